//! A force that is told to be late is that of the same log with its forces moved to where they act.

use std::fs;

use lyapunov_lab::observe::{Contact, Report, Settings, observe};

fn shipped() -> Vec<[String; 3]> {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/logs/mujoco-encoder.csv");
    let text = fs::read_to_string(path).unwrap();
    let row = |line: &str| {
        let fields: Vec<&str> = line.split(',').collect();
        [0, 1, 2].map(|at| fields[at].to_owned())
    };
    text.lines().skip(1).map(row).collect()
}

fn observed(rows: &[[String; 3]], late: u32) -> Report {
    let log: String = rows.iter().map(|row| row.join(",") + "\n").collect();
    let settings = Settings { late, ..Settings::default() };
    observe(format!("t,x,f\n{log}").as_bytes(), "log.csv", &settings).unwrap().report
}

#[test]
fn forces_act_where_they_are_told_to() {
    let mut rows = shipped();
    // A row that tells no place still tells the force that acts later.
    rows[500][1] = "-".to_owned();
    for late in [1, 2, 7_usize] {
        let moved: Vec<[String; 3]> = (late..rows.len())
            .map(|at| [rows[at][0].clone(), rows[at][1].clone(), rows[at - late][2].clone()])
            .collect();
        let (told, expected) = (observed(&rows, late as u32), observed(&moved, 0));
        assert_eq!(told.energy, expected.energy, "{late}");
        assert_eq!(told.observed_energy, expected.observed_energy, "{late}");
        assert_eq!(told.printed, expected.printed, "{late}");
        let contacts = |report: &Report| {
            let told = |it: &Contact| (it.start, it.end, it.generated, it.peak_force);
            report.contacts.worst.iter().map(told).collect::<Vec<_>>()
        };
        assert_eq!(contacts(&told), contacts(&expected), "{late}");
        assert_eq!((told.rows, told.late), (expected.rows, late as u32));
    }
}

#[test]
fn a_force_on_time_is_as_without_the_setting() {
    let rows = shipped();
    let (told, late) = (observed(&rows, 0), observed(&rows, 2));
    assert!(!told.to_json().contains("\"late\"") && late.to_json().contains("\"late\": 2"));
    assert!(late.to_string().contains("late") && !told.to_string().contains("late "));
    // The script that made this log gave the force two ticks late, and most of what the rows seem to absorb is that.
    let [absorbed, seemed] = [&late, &told].map(|it| -it.energy.generated);
    assert!(0.0 < absorbed && absorbed < 0.05 * seemed, "{absorbed} {seemed}");
}
