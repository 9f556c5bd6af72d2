//! Rows as Parquet, read back by the crate that reads the format.
//!
//! A target of its own: with the feature the command is another one, and only this test needs it.

#![cfg(unix)]

// Other tests use the rest of it.
#[allow(dead_code)]
mod cli {
    pub(crate) mod place;
    pub(crate) mod said;
}

use cli::place::Place;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::RowAccessor;
use serde_json::Value;

#[test]
fn parquet_holds_the_rows_and_what_they_are() {
    let place = Place::with_scene();
    place.run(["run", "scene.toml", "--parquet", "rows.parquet"]).ended(0, &["peak force"]);
    place.run(["run", "scene.toml", "--csv", "rows.csv", "--quiet"]).ended(0, &[]);
    let file = std::fs::File::open(place.path("rows.parquet")).unwrap();
    let reader = SerializedFileReader::new(file).unwrap();
    let csv = place.text("rows.csv");
    let mut rows = 0;
    for (row, line) in reader.get_row_iter(None).unwrap().zip(csv.lines().skip(1)) {
        let row = row.unwrap();
        for (column, number) in line.split(',').enumerate() {
            assert_eq!(row.get_double(column).unwrap(), number.parse::<f64>().unwrap());
        }
        rows += 1;
    }
    assert_eq!(rows + 1, csv.lines().count());
    let metadata = reader.metadata().file_metadata().key_value_metadata().unwrap();
    let value =
        |key: &str| metadata.iter().find(|it| it.key == key).unwrap().value.clone().unwrap();
    let json: Value = serde_json::from_str(&place.text("rows.json")).unwrap();
    assert_eq!(value("scene"), json["scene"].as_str().unwrap());
    assert_eq!(value("lyapunov"), env!("CARGO_PKG_VERSION"));
    let units: Value = serde_json::from_str(&value("units")).unwrap();
    assert_eq!(units["f_act"], "N");
    place.refuses(["run", "scene.toml", "--parquet", "scene.toml"], &["the scene itself"]);
}
