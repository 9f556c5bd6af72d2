//! A program with own stabilizers, from outside: this test runs itself as that program.

use std::env;
use std::fs;
use std::path::Path;
use std::process::{Command, ExitCode};

use lyapunov::{
    Dissipation, LyapunovCandidate, ParameterError, Popc, PortEnergy, Scalar, Signal, Stabilizer,
};
use lyapunov_cli::Bench;
use lyapunov_lab::own::{Loop, OwnCandidate, OwnNumber, OwnStabilizer, Promise};
use serde_json::Value;

struct MyPopc;

impl OwnStabilizer for MyPopc {
    const NAME: &'static str = "my-popc";
    const NUMBERS: &'static [OwnNumber] = &[OwnNumber::DAMPING_CAP];
    const PROMISE: Promise = Promise::Serves;

    fn make<V: Signal>(on: &Loop<'_>) -> Result<impl Stabilizer<V> + 'static, ParameterError> {
        Ok(Popc::new(PortEnergy, on.damping_limit::<V::Scalar>()?))
    }
}

struct MyDamping;

impl OwnCandidate for MyDamping {
    const NAME: &'static str = "my-damping";

    fn make<V: Signal>(
        on: &Loop<'_>,
    ) -> Result<impl LyapunovCandidate<V> + 'static, ParameterError> {
        Ok((PortEnergy, Dissipation::of(V::Scalar::of(on.damping()))?))
    }
}

/// Word in the environment that makes this a program with own stabilizers.
const ROLE: &str = "LYAPUNOV_TEST_ROLE";

fn main() -> ExitCode {
    let bench = || Bench::new().stabilizer::<MyPopc>();
    match env::var(ROLE).as_deref() {
        Ok("own") => bench().candidate::<MyDamping>().main(),
        Ok("twice") => bench().stabilizer::<MyPopc>().main(),
        _ => {
            help_and_errors_name_own_stabilizers();
            every_command_takes_own_names();
            a_map_is_merged_by_its_own_names();
            ExitCode::SUCCESS
        }
    }
}

/// Exit status and both outputs of the program in a role.
fn ran(role: &str, line: &str, place: &Path) -> (i32, String, String) {
    let hold = Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/hold.toml");
    fs::copy(hold, place.join("hold.toml")).unwrap();
    let program = env::current_exe().unwrap();
    let mut command = Command::new(program);
    let said = command.current_dir(place).env(ROLE, role).args(line.split(' ')).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (said.status.code().unwrap(), text(said.stdout), text(said.stderr))
}

fn help_and_errors_name_own_stabilizers() {
    let place = tempfile::tempdir().unwrap();
    let told = "Own stabilizers of this program: my-popc, lolc-my-damping";
    for line in ["--help", "compare --help", "map -h", "tune --help", "hard --help"] {
        let (status, out, _) = ran("own", line, place.path());
        assert!(status == 0 && out.contains(told), "{line}: {out}");
    }
    assert!(!ran("own", "run --help", place.path()).1.contains("Own stabilizers"));
    let (status, _, err) = ran("own", "hard --stabilizer my-pop", place.path());
    assert!(status == 2 && err.contains("did you mean `my-popc`?"), "{err}");
    let (status, out, err) = ran("twice", "scenes", place.path());
    assert_eq!((status, out.as_str()), (2, ""));
    assert!(err.starts_with("error: two own stabilizers are called `my-popc`\n  = "), "{err}");
}

/// Own POPC is POPC, whatever it is asked for.
fn every_command_takes_own_names() {
    let place = tempfile::tempdir().unwrap();
    let path = place.path();
    let run = |line: &str| {
        let (status, out, err) = ran("own", line, path);
        assert_eq!((status, err.as_str()), (0, ""), "{line}");
        out
    };
    run("compare hold.toml --stabilizers popc,my-popc --out compared --quiet");
    let told: Value = read(&path.join("compared/compare.json"));
    let rows = told["rows"].as_array().unwrap();
    assert_eq!(rows[1]["stabilizer"], "my-popc");
    for key in ["verdict", "settling_time_s", "force_error_rms_n", "energy_given_mj"] {
        assert_eq!(rows[0][key], rows[1][key], "{key}");
    }
    let told = fs::read_to_string(path.join("compared/hold.trade-off.csv")).unwrap();
    let [popc, mine] = ["popc,", "my-popc,"].map(|name| {
        let row = told.lines().find(|line| line.starts_with(name));
        row.unwrap_or_else(|| panic!("{told}")).strip_prefix(name).unwrap()
    });
    assert_eq!(popc, mine);

    run("tune hold.toml --stabilizers popc,my-popc --trials 4 --runs 2 --out tuned --quiet");
    let [popc, mine] = ["popc", "my-popc"].map(|it| run(&format!("run tuned/{it}.toml")));
    let but = |text: &str| -> Vec<String> {
        let lines = text.lines().filter(|line| !line.contains("stabilizer   "));
        lines.skip(1).map(str::to_owned).collect()
    };
    assert_eq!(but(&popc), but(&mine));
    assert!(mine.contains("  stabilizer   my-popc: damping_cap "), "{mine}");

    run("hard --stabilizer my-popc --out judged --quiet");
    let told: Value = read(&path.join("judged/hard.json"));
    assert_eq!(told["stabilizer"], "my-popc");
    let page = fs::read_to_string(path.join("judged/report.html")).unwrap();
    assert!(page.contains(" hard --stabilizer my-popc --out judged"), "{page}");
    assert!(!page.contains("lyapunov hard"), "{page}");
    assert!(run("schema").contains("\"my-popc\""));
}

fn read(path: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

/// The table of a map has the scene in its head, and the names of whoever ran.
fn a_map_is_merged_by_its_own_names() {
    let place = tempfile::tempdir().unwrap();
    let scene =
        fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../scenes/hold.toml"));
    let scene = scene.unwrap().replace("[stabilizer.popc]", "[stabilizer.my-popc]");
    fs::write(place.path().join("mine.toml"), scene).unwrap();
    let map = "map mine.toml --x environment.wall.stiffness=500..8000:4 \
        --y device.damping=0.1..1:2 --stabilizers popc,my-popc,lolc-my-damping";
    for shard in 0..2 {
        let line = format!("{map} --shard {shard}/2 --out shard-{shard} --quiet");
        let (status, _, err) = ran("own", &line, place.path());
        assert_eq!((status, err.as_str()), (0, ""));
    }
    let (status, out, err) = ran("own", "map merge shard-0 shard-1 --out whole", place.path());
    assert_eq!((status, err.as_str()), (0, ""), "{out}");
    let table = fs::read_to_string(place.path().join("whole/map.csv")).unwrap();
    let rows = |name: &str| -> Vec<String> {
        let cells = table.lines().filter(|line| line.starts_with(|it: char| it.is_ascii_digit()));
        let rows = cells.filter(|line| line.contains(&format!(",{name},")));
        rows.map(|row| row.replace(name, "")).collect()
    };
    let (popc, mine) = (rows("popc"), rows("my-popc"));
    assert!(mine.len() == 8 && popc == mine, "{table}");
    assert_eq!(rows("lolc-my-damping").len(), 8);
}
