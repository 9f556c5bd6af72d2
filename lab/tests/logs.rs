//! Logs that cannot be read, or hardly: remedies and lines that name the cause.

use lyapunov_lab::observe::{LogError, Report, Settings, observe};

fn read(log: &[u8]) -> Result<Report, LogError> {
    observe(log, "made.csv", &Settings::default()).map(|it| it.report)
}

#[track_caller]
fn remedy(log: &[u8], words: &str) {
    let error = read(log).unwrap_err();
    assert!(error.help().is_some_and(|help| help.contains(words)), "{words}: {error}");
}

#[test]
fn what_is_no_table_is_not_asked_for_columns() {
    let table = "as text with one row per line";
    for log in [
        &b"{\"t\":0,\"x\":1,\"f\":2}\n"[..],
        b"[0,1,2]\n",
        b"<row>,<t>,<x>\n",
        b"t|x|f\n0|0|0\n",
        b"t,\xff\x01,b,c\n",
    ] {
        remedy(log, table);
    }
    remedy(b"time,place,push\n0,0,0\n", "name the column of x with --columns");
}

#[test]
fn a_log_of_another_encoding_or_too_few_columns_is_told_so() {
    let utf_16 = |text: &str| text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<_>>();
    let swapped: Vec<u8> = utf_16("t,x,f\n").chunks(2).flat_map(|it| [it[1], it[0]]).collect();
    let many = format!("t,x,f\r{}", "0,0,0\r".repeat(50_000)).into_bytes();
    for (log, words) in [
        (&b"t;x\n0;0\n"[..], "a log needs columns of time, position and force; there are t, x"),
        (b"a,\xff\xfe,b,c\n", "the file is not UTF-8 in `"),
        (b"t,x,Kr\xe4ft\n0,0,0\n", "not UTF-8 in `Kr\u{fffd}ft`: save it as UTF-8"),
        (b"t,x [\xb5m],f\n0,0,0\n", "in `x [\u{fffd}m]`: save it as UTF-8"),
        (b"t,x\xb0,f\n0,0,0\n", "or give --columns the numbers of the columns, from 1"),
        (&utf_16("\u{feff}t,x,f\n0,0,0\n"), "text in UTF-16 looks like this: save it as UTF-8"),
        (&utf_16("t,x,f\n0,0,0\n"), "text in UTF-16 looks like this: save it as UTF-8"),
        (&swapped, "text in UTF-16 looks like this: save it as UTF-8"),
        (b"t,x,f\r0,0,0\r1,1,1\r", "its lines end in CR alone"),
        (b"t,x,f,v\r0,0,0,0\r1,1,1,0\r", "save it with line ends LF or CRLF"),
        (b"# made\rt,x,f\r0,0,0\r1,1,1\r", "its lines end in CR alone"),
        (&many, "its lines end in CR alone"),
    ] {
        remedy(log, words);
    }
    assert_eq!(read(b"t,x,f\r\r\n0,0,0\r\r\n1,1,1\r\r\n").unwrap().rows, 2);
}

#[test]
fn a_name_between_others_as_near_is_not_guessed() {
    let error = read(b"t,x,y,fx,fy\n0,0,0,0,0\n").unwrap_err();
    assert!(!error.help().unwrap().contains("did you mean"), "{error}");
    remedy(b"t,x,y,f0,load\n0,0,0,0,0\n", "did you mean `f0`?");
}

#[test]
fn bad_rows_have_the_remedy_of_their_fault() {
    let rows = |row: &str| format!("t,x,f\n{}", format!("{row}\n").repeat(30)).into_bytes();
    remedy(&rows("0,0,0,"), "does each row end in a separator?");
    remedy(&rows("0;0;0"), "rows and names need the same separator");
    remedy(&rows("0,0"), "is it cut off?");
    remedy(&rows("12:30:00.5,0,0"), "t is a time of day: give t in seconds");
    remedy(&rows("1.5 s,0,0"), "write numbers as 0.5 or 5e-1");
    remedy(&rows("0,0,0"), "equal stamps: write t with more digits, or give each row once");
}

#[test]
fn many_bad_rows_are_told() {
    let log = |bad: usize| {
        let row = |n: usize| if n < bad { "x,0,0\n".to_owned() } else { format!("{n},{n}e-3,1\n") };
        format!("t,x,f\n{}", (0..100).map(row).collect::<String>())
    };
    let told = |bad| {
        let report = read(log(bad).as_bytes()).unwrap();
        report.look_at.iter().any(|it| it.text == format!("{bad} of 100 rows are bad and left out"))
    };
    assert!(told(11) && !told(10) && !told(0));
}

/// Twelve touches, of which the table has room for ten.
#[test]
fn the_contacts_that_are_shown_are_counted() {
    let row = |n: u32| format!("{}e-2,{n}e-3,{}\n", n, if n.is_multiple_of(10) { 5 } else { 0 });
    let log = format!("t,x,f\n{}", (0..120).map(row).collect::<String>());
    let text = read(log.as_bytes()).unwrap().to_string();
    let words: Vec<&str> = text.split_whitespace().collect();
    assert!(words.join(" ").contains("contacts 12, 0 generated energy"), "{text}");
    assert!(words.join(" ").contains("so far); the 10 worst of 12 below from to"), "{text}");
}

#[test]
fn a_force_on_the_last_row_alone_is_no_contact() {
    let report = read(b"t,x,f\n0,0,0\n0.001,0.0001,1\n").unwrap();
    assert_eq!((report.contacts.count, report.ends_in_contact), (0, false));
    let report = read(b"t,x,f\n0,0,0\n0.001,0.0001,1\n0.002,0.0002,1\n").unwrap();
    assert_eq!((report.contacts.count, report.ends_in_contact), (1, true));
    let text = report.to_string();
    let words: Vec<&str> = text.split_whitespace().collect();
    assert!(
        words.join(" ").contains("the largest force so far); below, the worst first from to"),
        "{text}"
    );
}

#[test]
fn axes_that_are_not_read_are_told() {
    let row = |n: u32| {
        let x = f64::from(n).sin();
        format!("{n}e-2,{x:?},{:?},1.0,{n}\n", 100.0 * (0.1 - x).max(0.0))
    };
    let rows = (0..100).map(row).collect::<String>();
    let note = "the log has columns of further axes (y, y_f_act): only the first axis is read, and energy that passes along the \
                others is missing";
    let plane = format!("t,x,f_act,y,y_f_act\n{rows}");
    let observed = observe(plane.as_bytes(), "plane.csv", &Settings::default()).unwrap();
    let json: serde_json::Value = serde_json::from_str(&observed.report.to_json()).unwrap();
    assert_eq!(json["notes"][0], note);
    let text = observed.report.to_string();
    assert!(
        text.split_whitespace().collect::<Vec<_>>().join(" ").contains(&format!("note {note}")),
        "{text}"
    );
    assert!(observed.to_html("lyapunov observe plane.csv").contains(note));
    let line = plane.replace("y,", "a,").replace("y_", "a_");
    let json: serde_json::Value =
        serde_json::from_str(&read(line.as_bytes()).unwrap().to_json()).unwrap();
    assert_eq!(json.get("notes"), None);
}

#[test]
fn each_kind_of_bad_row_has_its_remedy_in_a_line() {
    let log = "t,x [mm],f\n-1e-9,0,0\n0.001,1\n0.002,one,0\n0.003,nan,0\n0.004,2,0\n0.001,2,0\n0.005,1,0\n";
    let observed = observe(log.as_bytes(), "made.csv", &Settings::default()).unwrap();
    let (text, page) = (observed.report.to_string(), observed.to_html("lyapunov observe made.csv"));
    for told in ["= every row", "= write numbers", "= NaN and infinities", "= time must increase"] {
        assert!(text.contains(told) && page.contains(&format!("\n{told}")), "{told}: {text}");
    }
    assert!(text.contains("from 0.0000 s to 0.0050 s"), "{text}");
    assert!(page.contains(
        "4; the next good row spans the gap\nline 3: 2 fields, not 3\nline 4: x is <code>one</code>"
    ));
    assert!(page.contains("x is <code>x [mm]</code> in mm"), "{page}");
}
