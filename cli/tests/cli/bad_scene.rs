//! Wrong scenes, and files that are no scenes.

use std::ffi::OsStr;
use std::fs::{self, File};
use std::os::unix::ffi::OsStrExt;
use std::os::unix::fs::symlink;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use crate::cli::place::{Place, SCENE};
use crate::cli::said::{Said, Start};

/// A part of the shipped scene, its replacement, and words of the error: the line, the key, the value and what would be
/// right.
type Case = (&'static str, &'static str, &'static [&'static str]);

#[rustfmt::skip]
const CASES: &[Case] = &[
    ("servo_rate", "sevro_rate", &["scene.toml:5:1", "sevro_rate = 100.0", "did you mean `servo_rate`?"]),
    ("mass = 0.2", "mas = 0.2", &["scene.toml:13:1", "mas = 0.2", "unknown key `mas` in [device]", "did you mean `mass`?"]),
    ("mass = 0.2", "mass = -0.2", &["scene.toml:13:8", "`device.mass`", "greater than 0", "not -0.2", "kg"]),
    ("mass = 0.2", "mass = 0", &["`device.mass`", "greater than 0"]),
    ("mass = 0.2", "mass = nan", &["scene.toml:13:8", "`device.mass`", "finite", "not NaN"]),
    ("mass = 0.2", "mass = \"0.2\"", &["must be a number, not the text \"0.2\""]),
    ("mass = 0.2", "mass = 0,2", &["`0,2` is not a number", "0.5"]),
    ("mass = 0.2", "mass =", &["scene.toml:13", "a value is missing"]),
    ("stiffness = 50.0", "stiffness = inf", &["scene.toml:10:13", "`operator.stiffness`", "finite", "not inf"]),
    ("duration = 10.0", "duration = 1e8", &["scene.toml:4:12", "1e10 ticks", "at most 1e9 ticks", "10000000.0 s"]),
    ("duration = 10.0", "duration = -1", &["`duration`", "greater than 0", "not -1.0"]),
    ("duration = 10.0\n", "", &["missing key `duration`", "duration = 10.0 # s"]),
    ("duration = 10.0", "duration = 10.0\nduration = 5.0", &["scene.toml:5:1", "given twice"]),
    ("duration = 10.0", "duration = 10.0\nenvironment_rate = 30",
        &["scene.toml:5:20", "`environment_rate` = 30.0 Hz does not divide `servo_rate` = 100.0 Hz", "25.0 Hz (ratio 4)"]),
    ("duration = 10.0", "duration = 10.0\nscalar = \"f16\"", &["scene.toml:5:10", "\"f16\"", "\"f64\", \"f32\""]),
    ("[stabilizer.lolc]", "[stabilizer.popc]\n[stabilizer.lolc]", &["scene.toml:24:13", "two stabilizers, `popc` and `lolc`", "keep one"]),
    ("[stabilizer.lolc]", "[stabilizer]", &["scene.toml:24:1", "unknown key `work` in [stabilizer]", "[stabilizer.lolc]"]),
    ("[environment.wall]", "[environment.cylinder]\n[environment.wall]", &["scene.toml:20:14", "two environments, `cylinder` and `wall`", "known: wall"]),
    ("[environment.wall]\nstiffness = 8000.0\ndamping = 2.0\n", "", &["missing key `environment.wall.stiffness`", "[environment.wall]"]),
    ("[environment.wall]", "[environment]", &["scene.toml:20:1", "`stiffness` is a key of [environment.wall], [environment.spring]"]),
    ("candidate = \"mass-spring-damper\"", "candidate = \"device\"", &["scene.toml:25:13", "\"device\"", "did you mean \"device-damping\"?"]),
    ("damping_cap = 0.5", "damping_cap = -0.5", &["scene.toml:26:15", "`stabilizer.lolc.damping_cap`", "0 or greater", "not -0.5"]),
    ("damping_cap = 0.5", "damping_cap = 0.5\n[effects.delay]\nticks = 1025", &["scene.toml:28:9", "0 to 1024", "not 1025"]),
    ("damping_cap = 0.5", "damping_cap = 0.5\n[effects.delay]\nticks = 0.5", &["`effects.delay.ticks`", "whole number", "0.5"]),
    ("stiffness = 50.0", "stiffness = 1e300",
        &["scene.toml:10:13", "motion within one period is beyond the range of f64", "`operator.stiffness` = 1e300 stands out"]),
    ("mass = 0.1\ndamping = 0.2\nstiffness = 50.0\n\n[device]\nmass = 0.2", "mass = 1e308\n[device]\nmass = 1e308",
        &["`operator.mass` and `device.mass` together", "1e308 stands out"]),
    ("damping = 0.2\nstiffness = 50.0\n\n[device]\nmass = 0.2\ndamping = 0.001", "damping = 1e308\n[device]\nmass = 1\ndamping = 1.5e308",
        &["scene.toml:12:11", "`operator.damping` and `device.damping` together", "`device.damping` = 1.5e308 stands out"]),
    ("servo_rate = 100.0", "scalar = \"f32\"\nservo_rate = 1e-40", &["scene.toml:6:14", "no period within f32"]),
    ("[device]", "[device", &["scene.toml:12", "lacks its closing `]`"]),
    // The place is where something is written, not the end of the file.
    ("damping_cap = 0.5", "damping_cap = 0.5\nx = \"\"\"abc\n\n\n", &["scene.toml:27:11", "expected `\"`"]),
];

/// Tables to add below the shipped scene, and words of the error.
#[rustfmt::skip]
const TABLES: &[(&str, &[&str])] = &[
    ("[effects.filter]\ncutoff = 0", &["`effects.filter.cutoff`", "greater than 0", "Hz"]),
    ("[effects.filter]\ncutoff = 1\nwindow = 2", &["two filters", "keep one of these keys"]),
    ("[effects.noise]\ndeviation = -1\nseed = 1", &["0 or greater", "not -1.0"]),
    ("[effects.noise]\ndeviation = 1\nseed = 0.5", &["whole number", "0.5"]),
    ("[effects.jitter]\ndeviation = nan\nseed = 1", &["`effects.jitter.deviation`", "NaN"]),
    ("[effects.dropout]\nprobability = 2\nseed = 1\npolicy = \"hold\"", &["from 0 to 1", "not 2.0"]),
    ("[effects.dropout]\nprobability = 0\nseed = 1\npolicy = \"last\"", &["\"hold\", \"zero\""]),
    ("[effects.friction]\ncoulomb = 2\nstatic = 1\nstribeck_velocity = 1", &["less than `coulomb`"]),
    ("[effects.load]\nforce = inf", &["`effects.load.force`", "finite"]),
    ("[effects.pulse]\nstart = 0\nforce = 1", &["missing key `effects.pulse.duration`"]),
    ("[link]\nstiffness = -1", &["`link.stiffness`", "greater than 0"]),
    ("[operator.grip]\ntimes = [2, 1]\nstiffness = [1, 1]\ndamping = [1, 1]", &["1.0 s after 2.0 s"]),
    ("[operator.motion]\nkind = \"sine\"\nto = 1", &["has `to`", "kind, amplitude, frequency"]),
    ("[operator.motion]\nkind = \"file\"\npath = \"none.csv\"", &["none.csv", "cannot be read"]),
    ("[environment.spring]\nstiffness = 1", &["two environments", "keep one of these tables"]),
    ("[space]\ndimensions = 3", &["`environment.wall` is not for 3 dimensions"]),
];

#[test]
fn a_wrong_table_of_an_effect_is_refused() {
    for (table, words) in TABLES {
        let place = Place::new();
        place.put("scene.toml", format!("{}\n{table}\n", SCENE.trim_end()));
        place.put("rows.csv", "rows of another run");
        for csv in ["rows.csv", "new.csv", "-"] {
            place.refuses(["run", "scene.toml", "--csv", csv], words);
        }
    }
}

#[test]
fn a_wrong_scene_is_refused_with_its_line_and_what_would_be_right() {
    for (from, to, words) in CASES {
        let place = Place::new();
        place.put_scene("scene.toml", from, to);
        place.put("rows.csv", "rows of another run");
        for csv in ["rows.csv", "new.csv", "-"] {
            place.refuses(["run", "scene.toml", "--csv", csv], words);
        }
    }
}

#[test]
fn files_that_are_no_toml_text_are_refused() {
    let place = Place::new();
    place.put("empty", "");
    place.put("blank", "\n \n# nothing\n");
    place.put("prose", "Once upon a time there was a wall.\n");
    place.put("binary", [0x7f, b'E', b'L', b'F', 0, 1, 2, 0xff]);
    place.put("latin", b"# gr\xf6\xdfe\nduration = 1.0\n");
    place.put("utf-16", SCENE.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<_>>());
    place.put("deep", "a = ".to_owned() + &"[".repeat(100_000));
    fs::create_dir(place.path("folder")).unwrap();
    symlink("nowhere", place.path("dangling")).unwrap();
    symlink("circle", place.path("circle")).unwrap();
    File::create(place.path("huge")).unwrap().set_len(1 << 30).unwrap();
    let this = env!("CARGO_BIN_EXE_lyapunov");
    let cases: &[(&str, &[&str])] = &[
        ("missing.toml", &["missing.toml: there is no such file", "check the path"]),
        ("empty", &["empty: the scene is empty", "[environment.wall]"]),
        ("blank", &["blank: the scene is empty"]),
        ("prose", &["prose:1", "key = value"]),
        ("binary", &["binary: this file is not text in UTF-8", "offset"]),
        ("latin", &["latin: this file is not text in UTF-8: byte 0xf6 at offset 4"]),
        ("utf-16", &["utf-16: this file is not text in UTF-8"]),
        ("deep", &["nested too deeply"]),
        ("folder", &["folder: this is a folder", "give the path of a scene file"]),
        ("dangling", &["dangling: there is no such file"]),
        ("circle", &["circle: this file cannot be read"]),
        ("prose/scene.toml", &["prose/scene.toml: this file cannot be read"]),
        ("huge", &["huge: this file is too large for a scene: 1073741824 bytes", "1048576"]),
        ("/dev/zero", &["/dev/zero: this file is too large for a scene", "1048576"]),
        ("/dev/null", &["/dev/null: the scene is empty"]),
        (this, &["too large"]),
    ];
    for (scene, words) in cases {
        place.refuses(["run", scene, "--csv", "rows.csv"], words);
    }
}

#[test]
fn a_scene_may_have_any_file_name() {
    let place = Place::new();
    for name in
        [&b"with spaces.toml"[..], b"not-\xff-text.toml", "größe.toml".as_bytes(), b"no ending"]
    {
        let name = OsStr::from_bytes(name);
        place.put(name, SCENE);
        let said = place.run([OsStr::new("run"), name]);
        said.ended(0, &["peak force"]);
        assert!(said.out.starts_with(&format!("{}\n", name.display())), "{}", said.out);
        place.put(name, SCENE.replacen("duration", "duratoin", 1));
        place.refuses([OsStr::new("run"), name], &[&format!("{}:4:1", name.display())]);
    }
}

/// A named pipe is read like any file, once somebody writes to it.
#[test]
fn a_scene_may_come_from_a_pipe() {
    let place = Place::new();
    let pipe = place.path("pipe");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let mut child = place.command(["run", "pipe"]).start(Stdio::piped());
    thread::sleep(Duration::from_millis(50));
    assert_eq!(child.try_wait().unwrap(), None);
    fs::write(&pipe, SCENE).unwrap();
    Said::by_child(child).ended(0, &["pipe run", "peak force"]);
}

#[test]
fn a_log_in_place_of_a_scene_is_called_one() {
    let place = Place::new();
    let row = "0.001,1200,-0.25\n";
    for (first, at) in [
        ("t,x,f\n", "log.csv:1:1"),
        ("Time (ms),Encoder (counts),Motor force (N)\n", "log.csv:1:1"),
        ("# rig 3\n\nt [s];x [mm];f [N]\n", "log.csv:3:1"),
        ("\"t\"\t\"x\"\t\"f\"\n", "log.csv:1:1"),
        ("", "log.csv:1:1"),
    ] {
        // A short one, and one that is larger than any scene may be.
        for rows in [3, 100_000] {
            place.put("log.csv", first.to_owned() + &row.repeat(rows));
            for command in ["run", "bound"] {
                let words = ["this looks like a log", "`lyapunov observe` reads a log", at];
                place.refuses([command, "log.csv"], &words);
            }
        }
    }
    for scene in ["duration, 5.0\n", "[device, 1, 2\n", "x = 1,2,3\n"] {
        place.put("scene.toml", scene);
        let said = place.refuses(["run", "scene.toml"], &["scene.toml:1"]);
        assert!(!said.err.contains("looks like a log"), "{}", said.err);
    }
}

#[test]
fn a_scene_in_place_of_a_log_is_called_one() {
    let place = Place::with_scene();
    let words =
        ["scene.toml:4: this looks like a scene: `duration = 10.0`", "`lyapunov run scene.toml`"];
    for arguments in [
        &["observe", "scene.toml"][..],
        &["identify", "scene.toml"],
        &["run", "scene.toml", "--against", "scene.toml"],
    ] {
        place.refuses(arguments, &words);
    }
    place.put("table.toml", "[device]\nmass = 1.0\n");
    place
        .refuses(["observe", "table.toml"], &["table.toml:1: this looks like a scene: `[device]`"]);
    place.put("pairs.csv", "t=0,x=0,f=1\nt=1,x=1,f=1\n");
    let said = place.refuses(["observe", "pairs.csv"], &["pairs.csv:1", "--columns"]);
    assert!(!said.err.contains("looks like a scene"), "{}", said.err);
}
