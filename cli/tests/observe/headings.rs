//! Logs as people have them: words and units in headings, decimal commas, our own columns, gaps and bad rows.

use std::process::Command;

use lyapunov_figures::Trace;
use lyapunov_lab::observe::{Observed, Settings, observe as read};
use serde_json::Value;

use crate::observe::command::{observe, run};

/// Times in µs, positions in µm, forces in mN: a spring of 2 kN/m that a hand swings on.
fn ticks() -> Vec<[i64; 3]> {
    let x = |n: i64| (4000.0 * (n as f64 * 0.1).sin()).round() as i64;
    (0..200).map(|n| [1000 * n, x(n), 2 * x(n)]).collect()
}

/// A whole number times a power of ten, with every digit.
fn decimal(number: i64, power: i32, mark: char) -> String {
    let digits = format!("{:0>20}", number.abs());
    let cut = (digits.len() as i32 + power) as usize;
    let digits = if power > 0 { digits + &"0".repeat(power as usize) } else { digits };
    let (whole, part) = digits.split_at(cut);
    let whole = match whole.trim_start_matches('0') {
        "" => "0",
        whole => whole,
    };
    let sign = if number < 0 { "-" } else { "" };
    if part.is_empty() { format!("{sign}{whole}") } else { format!("{sign}{whole}{mark}{part}") }
}

/// The log with these headings, in units that are these powers of ten of µs, µm and mN.
fn log(headings: [&str; 3], powers: [i32; 3], delimiter: char, mark: char) -> String {
    let joined = |fields: Vec<String>| fields.join(&delimiter.to_string()) + "\n";
    let rows = ticks().into_iter().map(|row| {
        let fields = row.into_iter().zip(powers);
        joined(fields.map(|(number, power)| decimal(number, power, mark)).collect())
    });
    joined(headings.map(str::to_owned).to_vec()) + &rows.collect::<String>()
}

/// The report without what tells how it was read.
fn report(log: &str, arguments: &[&str]) -> Value {
    let ended = observe(log.as_bytes(), &[arguments, &["--json"]].concat());
    assert_eq!((ended.status, ended.error.as_str()), (Some(0), ""));
    let mut report: Value = serde_json::from_str(&ended.out).unwrap();
    let keys = report.as_object_mut().unwrap();
    assert!(keys.remove("columns").is_some() && keys.remove("decimal_commas").is_some());
    report
}

/// A log without its first line.
fn rows(log: &str) -> &str {
    log.split_once('\n').unwrap().1
}

#[test]
fn units_words_and_commas_give_the_identical_report() {
    let si = report(&log(["t", "x", "f"], [-6, -6, -3], ',', '.'), &[]);
    assert_eq!(si["rows"], 200);
    for (headings, powers, delimiter, mark) in [
        (["time (ms)", "x [mm]", "f_kN"], [-3, -3, -6], ';', ','),
        (["t_us", "x [um]", "f (mN)"], [0, 0, 0], '\t', '.'),
        (["Time [s]", "Position [m]", "Force [N]"], [-6, -6, -3], '\t', ','),
        (["t (\u{b5}s)", "pos_cm", "f_act [N]"], [0, -4, -3], ',', '.'),
        (["t [\u{3bc}s]", "x_m", "f_N"], [0, -6, -3], ';', '.'),
        (["t [ns]", "x", "f"], [3, -6, -3], ',', '.'),
    ] {
        let text = log(headings, powers, delimiter, mark);
        assert_eq!(report(&text, &[]), si, "{headings:?}");
        // By number, and by whole headings, the units are read as well.
        assert_eq!(report(&text, &["--columns", "1,2,3"]), si, "{headings:?}");
        assert_eq!(report(&text, &["--columns", &headings.join(",")]), si, "{headings:?}");
    }
    // Parted by blanks, as by numpy.savetxt; and with the units in a line of their own. Lines are counted alike.
    let blanks = log(["t", "x", "f"], [-6, -6, -3], ' ', '.');
    assert_eq!(report(&blanks, &[]), si);
    assert_eq!(report(&format!("# {blanks}").replace('\n', " \n  "), &[]), si);
    let text = log(["t", "x", "f"], [-3, -3, -6], ',', '.');
    for units in ["ms,mm,kN", "(ms),[mm],(kN)"] {
        let text = text.replacen('\n', &format!("\n{units}\n"), 1);
        assert_eq!(report(&text, &[])["energy"], si["energy"], "{units}");
        let told = report(&text.replace("kN", "N"), &["--scale", "f=1e3"]);
        assert_eq!(told["energy"], si["energy"], "{units}");
    }
    let commented = format!("# {}", text.replacen('\n', "\n# ms,mm,kN\n# a comment\n", 1));
    assert_eq!(report(&commented, &[])["energy"], si["energy"]);
    // A sentence is not the names, whatever words it has; nor are names that other signs part than the rows.
    let sentence = "# Force and position of the device over time\n";
    assert_eq!(report(&format!("{sentence}{text}"), &[])["energy"], report(&text, &[])["energy"]);
    for told in [format!("{sentence}# {blanks}"), format!("{sentence}# t,x,f\n{}", rows(&text))] {
        assert_eq!(report(&told, &[])["rows"], 200, "{told}");
    }
    let ended = observe(format!("# t x f\n{}", rows(&text)).as_bytes(), &[]);
    assert!(ended.error.contains("give --columns the numbers of the columns"), "{}", ended.error);
    // A line of units that is not understood is no bad row: all would be read in SI.
    for (units, words) in [
        ("ms,mm,lbf", &["log.csv:2: `lbf` is no unit of force", "--scale f=1e-3"][..]),
        ("sec,mm,N", &["`sec` is no unit of time"]),
        ("ms,mm,N,mm/s", &["a line of units without the fields of the names"]),
    ] {
        let ended = observe(text.replacen('\n', &format!("\n{units}\n"), 1).as_bytes(), &[]);
        let said = |word: &&str| ended.error.contains(&word.replace("log.csv", "standard input"));
        assert!(ended.status == Some(2) && words.iter().all(said), "{}", ended.error);
    }
    // Without headings a comma still is a decimal mark.
    let bare = log(["t", "x", "f"], [-6, -6, -3], ';', ',');
    let bare = bare.split_once('\n').unwrap().1;
    let mut numbered = report(bare, &["--columns", "1,2,3"]);
    // Lines are counted from one earlier.
    assert_eq!(numbered["gaps"]["longest"].take(), Value::Null);
    assert_eq!(numbered["energy"], si["energy"]);
}

#[test]
fn what_was_read_is_told() {
    let ended =
        observe(log(["time (ms)", "x [mm]", "f_kN"], [-3, -3, -6], ';', ',').as_bytes(), &[]);
    let told = "columns     t is `time (ms)` in ms, x is `x [mm]` in mm, f is `f_kN` in kN, numbers have decimal";
    assert!(ended.out.contains(told), "{}", ended.out);
    let plain = observe(log(["t", "x", "f"], [-6, -6, -3], ',', '.').as_bytes(), &[]);
    assert!(!plain.out.contains("columns"), "{}", plain.out);
}

#[test]
fn a_factor_takes_the_place_of_a_unit_and_minus_one_turns_the_sign() {
    let si = log(["t", "x", "f"], [-6, -6, -3], ',', '.');
    let units = log(["t", "x [mm]", "f [kN]"], [-6, -3, -6], ',', '.');
    assert_eq!(report(&units, &["--scale", "f=-1"]), report(&si, &["--scale", "f=-1"]));
    let plain = log(["t", "x", "f [kN]"], [-6, -3, -6], ',', '.');
    assert_eq!(report(&units, &["--scale", "x=1"]), report(&plain, &[]));
    // A unit that is not known needs a factor.
    let inches = log(["t", "x [inch]", "f"], [-6, -6, -3], ',', '.');
    assert_eq!(report(&inches, &["--scale", "x=1"]), report(&si, &[]));
}

#[test]
fn headings_that_may_mean_two_things_are_refused_with_a_remedy() {
    for (headings, reasons) in [
        (
            "t,x [mm],x [m],f",
            &["input:1: two columns may be `x`: 2, `x [mm]`, and 3", "number"][..],
        ),
        ("t,x,force,f_act", &["two columns may be `force`: 3, `force`, and 4, `f_act`"]),
        (
            "t,x [ms],f",
            &["column `x [ms]`: `ms` is no unit of position", "m, cm, mm, um", "x=1e-3"],
        ),
        ("t (s),x,f [lbf]", &["column `f [lbf]`: `lbf` is no unit of force", "N, mN, kN", "f=1"]),
        ("t [min],x,f", &["`min` is no unit of time", "s, ms, us, ns"]),
        ("t,x_s,f", &["there is no column `x`", "there are t, x_s, f"]),
    ] {
        let ended = observe(format!("{headings}\n0,1,2,3\n").as_bytes(), &[]);
        assert_eq!(
            (ended.status, ended.out.as_str()),
            (Some(2), ""),
            "{headings}: {}",
            ended.error
        );
        for reason in reasons {
            assert!(ended.error.contains(reason), "no `{reason}` in: {}", ended.error);
        }
    }
}

#[test]
fn a_log_has_one_decimal_mark() {
    let text = "t;x;f\n0;0;1\n1;0,5;1\n2;1.000;1\n3;1,5;1\n4;1.000,5;1\n";
    let read = report(text, &[]);
    assert_eq!((&read["rows"], &read["bad_rows"]["count"]), (&3.into(), &2.into()));
    let reason = "x is `1.000`, and numbers before have a decimal comma";
    assert_eq!(read["bad_rows"]["first"][0]["reason"], reason);
    assert_eq!(read["energy"]["absorbed"], 1.5);
}

#[test]
fn our_own_rows_are_read_without_flags() {
    let folder = tempfile::tempdir().unwrap();
    let rows = folder.path().join("rows.csv");
    let rows = rows.to_str().unwrap();
    for scene in ["paper-50k-popc", "delay", "box"] {
        let scene = format!("{}/../scenes/{scene}.toml", env!("CARGO_MANIFEST_DIR"));
        let made = ["run", &scene, "--csv", rows, "--quiet"];
        let made = Command::new(env!("CARGO_BIN_EXE_lyapunov")).args(made).status().unwrap();
        assert!(made.success());
        let json = |arguments: &[&str]| {
            let ended = run(&[&[rows, "--json"], arguments].concat());
            assert_eq!((ended.status, ended.error.as_str()), (Some(0), ""));
            let mut json: Value = serde_json::from_str(&ended.out).unwrap();
            json["columns"].take();
            json
        };
        assert_eq!(json(&[]), json(&["--columns", "t,x,f_act"]), "{scene}");
    }
}

/// The bars of a row of the panel of marks: their ends.
fn bars(observed: &Observed, row: f64) -> Vec<(f64, f64)> {
    let figure = observed.figure();
    let series = figure.panels[3].series.iter().filter(|series| series.trace == Trace::Bars);
    let points = series.flat_map(|series| series.points.clone());
    let finite: Vec<_> = points.filter(|point| point.0.is_finite() && point.1 == row).collect();
    finite.chunks(2).map(|pair| (pair[0].0, pair[1].0)).collect()
}

#[test]
fn gaps_and_bad_rows_are_marked_where_they_are() {
    let mut text = "t,x,f\n".to_owned();
    for n in 0..1000 {
        let time = f64::from(n) * 1e-3;
        match n {
            300..400 => {}
            700 => text += "0.7,nothing,0\n",
            _ => text += &format!("{time:?},{:?},0\n", time.sin()),
        }
    }
    let observed = read(text.as_bytes(), "gaps.csv", &Settings::default()).unwrap();
    assert_eq!((observed.report.gaps.count, observed.report.bad_rows.count), (2, 1));
    assert_eq!(bars(&observed, 0.0)[0], (0.299, 0.4));
    let [(from, to)] = bars(&observed, -1.0)[..] else { panic!("one bad row") };
    assert!(from <= 0.699 && to >= 0.701 && to - from < 0.007, "{from} {to}");
    let sound = read(&b"t,x,f\n0,0,0\n1,1,1\n2,0,1\n"[..], "sound.csv", &Settings::default());
    assert_eq!(sound.unwrap().figure().panels.len(), 3);
}
