//! The JSON beside rows.

use serde_json::Value;

use crate::cli::place::Place;

fn said(place: &Place, name: &str) -> Value {
    serde_json::from_str(&place.text(name)).unwrap()
}

#[test]
fn beside_the_rows_stands_what_they_are() {
    let place = Place::new();
    let noise = "[effects]\nnoise = { deviation = 1e-6, seed = 7 }\n";
    place.put_scene("scene.toml", "[stabilizer", &format!("{noise}[stabilizer"));
    place.run(["run", "scene.toml", "--csv", "rows.csv"]).ended(0, &["peak force"]);
    let json = said(&place, "rows.json");
    let columns = json["columns"].as_array().unwrap();
    let names: Vec<&str> = columns.iter().map(|it| it["name"].as_str().unwrap()).collect();
    assert_eq!(place.text("rows.csv").lines().next().unwrap(), names.join(","));
    let unit = |name: &str| columns.iter().find(|it| it["name"] == name).unwrap()["unit"].clone();
    assert_eq!([unit("t"), unit("x"), unit("v"), unit("f_act")], ["s", "m", "m/s", "N"]);
    assert_eq!(json["seeds"]["noise"], 7);
    assert_eq!(json["lyapunov"], env!("CARGO_PKG_VERSION"));
    // The scene that stands there makes the same rows.
    place.put("again.toml", json["scene"].as_str().unwrap());
    place.run(["run", "again.toml", "--csv", "again.csv", "--quiet"]).ended(0, &[]);
    assert_eq!(place.text("again.csv"), place.text("rows.csv"));
    // In a folder it is a part of the results.
    place.run(["run", "scene.toml", "--out", "out", "--quiet"]).ended(0, &[]);
    assert_eq!(said(&place, "out/run.json")["file"], json);
}

#[test]
fn a_file_of_somebody_else_is_not_replaced() {
    let place = Place::with_scene();
    for text in ["{}", "not JSON", ""] {
        place.put("rows.json", text);
        place.refuses(["run", "scene.toml", "--csv", "rows.csv"], &["rows.json", "another name"]);
    }
    std::fs::remove_file(place.path("rows.json")).unwrap();
    for _ in 0..2 {
        place.run(["run", "scene.toml", "--csv", "rows.csv", "--quiet"]).ended(0, &[]);
    }
}
