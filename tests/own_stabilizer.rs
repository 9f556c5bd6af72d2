//! The page and the example of a stabilizer of one's own: the same code, as honest as it says, with the errors it names.

use std::path::{Path, PathBuf};
use std::process::Command;

use lyapunov::lanes::{AutoF32x8, AutoF64x4, WideF64x4};
use lyapunov::laws::{self, Law, Samples};
use lyapunov::{
    Correction, DampingLimit, HeldTick, LyapunovCandidate, PortEnergy, PortSample, Scalar, Signal,
    Stabilizer,
};
use nalgebra::Vector3;

#[path = "../examples/own_stabilizer.rs"]
#[allow(dead_code, unreachable_pub)]
mod example;

use example::{DryFriction, WhileGiving};

const PERIOD: f64 = 1e-3;
const LIMIT: f64 = 100.0;
const PAGE: &str = include_str!("../docs/own-stabilizer.md");

fn own<T: Scalar>() -> WhileGiving<T, PortEnergy> {
    WhileGiving::new(PortEnergy, DampingLimit::at(T::of(LIMIT)).expect("a limit"))
}

/// The same law on plain numbers, with `if` and a plain sum.
#[derive(Clone, Default)]
struct ByHand {
    sum: f64,
}

impl Stabilizer<f64> for ByHand {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        let v = sample.velocity;
        if (self.sum + sample.work).is_finite() {
            self.sum += sample.work;
        }
        let debt = if self.sum < 0.0 { -self.sum } else { 0.0 };
        let square = v * v * sample.period;
        if !(sample.sound() && effort.is_finite() && square.is_finite()) {
            let rejected = Correction::none(0.0);
            let (shortfall, accepted) = (debt, false);
            return Correction { observed_energy: self.sum, shortfall, accepted, ..rejected };
        }
        let alpha = if effort * v < 0.0 && square > f64::MIN_POSITIVE {
            (debt / square).min(LIMIT)
        } else {
            0.0
        };
        let left = debt - alpha * square;
        Correction {
            effort: effort + alpha * v,
            observed_energy: self.sum,
            alpha,
            shortfall: if left > 0.0 { left } else { 0.0 },
            accepted: true,
        }
    }
}

/// Samples that ship, every seventh with a flaw, and efforts of every sign.
fn flawed(seed: u64) -> impl Iterator<Item = (PortSample<f64>, f64)> {
    Samples::<f64>::new(PERIOD).seeded(seed).enumerate().map(|(tick, (sample, effort))| {
        let bad = [f64::NAN, f64::INFINITY, 1e200][tick / 7 % 3];
        match tick % 28 {
            0 => (PortSample { velocity: bad, ..sample }, effort),
            7 => (PortSample { work: f64::NAN, ..sample }, effort),
            14 => (sample, f64::NAN),
            21 => (PortSample { position: f64::INFINITY, ..sample }, -effort),
            _ => (sample, effort),
        }
    })
}

#[test]
fn selects_do_what_the_ifs_do() {
    for seed in 0..10 {
        let (mut own, mut by_hand) = (own::<f64>(), ByHand::default());
        let (mut active, mut rejected) = (0, 0);
        for (tick, (sample, effort)) in flawed(seed).enumerate() {
            let [one, other] = [own.stabilize(&sample, effort), by_hand.stabilize(&sample, effort)];
            assert_eq!(one, other, "seed {seed}, tick {tick}: {sample:?}, {effort}");
            active += u32::from(one.alpha > 0.0);
            rejected += u32::from(!one.accepted);
        }
        assert!(active > 100 && rejected > 100, "{active} active, {rejected} rejected");
    }
}

fn of_lane<L: Scalar>(sample: &PortSample<L>, lane: usize) -> PortSample<f64> {
    sample.map(sample.period.lane(lane), |value| value.lane(lane))
}

#[test]
fn each_lane_is_the_scalar() {
    let mut lanes = own::<WideF64x4>();
    let mut scalars = [own::<f64>(); 4];
    for (sample, effort) in Samples::<WideF64x4>::new(WideF64x4::of(PERIOD)) {
        let together = lanes.stabilize(&sample, effort);
        for (lane, scalar) in scalars.iter_mut().enumerate() {
            let alone = scalar.stabilize(&of_lane(&sample, lane), effort.lane(lane));
            assert_eq!(together.effort.lane(lane).to_bits(), alone.effort.to_bits());
            assert_eq!(together.shortfall.lane(lane).to_bits(), alone.shortfall.to_bits());
        }
    }
}

#[test]
fn a_motion_along_one_axis_is_the_scalar() {
    let along = |value: f64| Vector3::new(0.0, value, 0.0);
    let (mut space, mut line) = (own::<f64>(), own::<f64>());
    for (sample, effort) in Samples::<f64>::new(PERIOD) {
        let moved = sample.map(sample.period, along);
        let (one, other) =
            (space.stabilize(&moved, along(effort)), line.stabilize(&sample, effort));
        assert_eq!(one.effort, along(other.effort));
        assert_eq!((one.alpha, one.shortfall), (other.alpha, other.shortfall));
    }
}

fn keeps_the_laws<V: Signal>() {
    let of = V::Scalar::of;
    let friction = DryFriction::of(of(0.02)).expect("a friction");
    let limit = DampingLimit::at(of(LIMIT)).expect("a limit");
    for seed in 0..8 {
        let samples = Samples::<V>::new(of(PERIOD)).seeded(seed);
        laws::candidate(&friction, samples).expect("the candidate");
        let credited = WhileGiving::new(friction, limit);
        laws::stabilizer(&credited, samples).expect("the stabilizer");
        laws::ledger(&credited, &friction, limit.most(), samples).expect("the ledger");
    }
}

#[test]
fn both_keep_the_laws_everywhere() {
    keeps_the_laws::<f64>();
    keeps_the_laws::<f32>();
    keeps_the_laws::<Vector3<f32>>();
    keeps_the_laws::<AutoF32x8>();
    keeps_the_laws::<Vector3<AutoF64x4>>();
}

/// A credit by hand, with a sum for each axis.
#[test]
fn the_candidate_credits_the_path_on_each_axis() {
    let mut candidate = DryFriction::of(0.5).expect("a friction");
    let (moved, applied) = (Vector3::new(1e-3, -2e-3, 0.0), Vector3::new(2.0, 1.0, 9.0));
    let rest = Vector3::zeros();
    let tick =
        HeldTick { period: PERIOD, position: rest, velocity: rest, displacement: moved, applied };
    let sample = tick.sample();
    let decrease: f64 = candidate.decrease(&sample);
    approx::assert_abs_diff_eq!(decrease, 0.0 + 0.5 * 3e-3, epsilon = 1e-18);
    assert!(DryFriction::of(-0.1).is_err());
}

/// What the page builds is what the example runs.
#[test]
fn page_and_example_hold_the_same_code() {
    let example = include_str!("../examples/own_stabilizer.rs");
    let (candidate, rest) = example
        .split_once("/// The port's energy")
        .and_then(|(_, code)| code.split_once("/// Stabilizer that pays"))
        .expect("the candidate");
    let (stabilizer, _) = rest.split_once("fn main()").expect("the stabilizer");
    for part in [candidate, stabilizer] {
        assert!(PAGE.contains(part.trim()), "docs/own-stabilizer.md lacks\n{part}");
    }
}

/// Stabilizer of the page without its shortfall.
#[derive(Clone)]
struct Silent(WhileGiving<f64, PortEnergy>);

impl Stabilizer<f64> for Silent {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        Correction { shortfall: 0.0, ..self.0.stabilize(sample, effort) }
    }
}

#[test]
fn the_page_quotes_the_breach() {
    let broken = laws::stabilizer(&Silent(own()), Samples::new(PERIOD)).expect_err("broken");
    assert_eq!(broken.law, Law::Served);
    let page: Vec<&str> = PAGE.split_whitespace().collect();
    let told = broken.to_string();
    assert!(page.join(" ").contains(&told), "docs/own-stabilizer.md lacks\n{told}");
}

/// Blocks of the page that must not compile, with the code that each names.
fn refused() -> Vec<(&'static str, &'static str)> {
    let blocks = PAGE.split("```compile_fail,").skip(1);
    blocks
        .map(|block| {
            let (code, rest) = block.split_once('\n').expect("a code");
            (code, rest.split_once("```").expect("the end").0)
        })
        .collect()
}

/// What rustc says to `code` as a crate of its own that uses the library at `rlib`.
fn compiled(name: &str, code: &str, rlib: &Path) -> (bool, String) {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("own-stabilizer");
    std::fs::create_dir_all(&folder).expect("a folder");
    let source = folder.join(format!("{name}.rs"));
    std::fs::write(&source, format!("#![allow(dead_code)]\n{code}")).expect("a file");
    let deps = rlib.parent().expect("a folder");
    let rustc = std::env::var_os("RUSTC").unwrap_or("rustc".into());
    let output = Command::new(rustc)
        .args(["--edition=2024", "--crate-type=lib", "--emit=metadata", "--color=never"])
        .arg("--out-dir")
        .arg(&folder)
        .arg("-L")
        .arg(format!("dependency={}", deps.display()))
        .arg("--extern")
        .arg(format!("lyapunov={}", rlib.display()))
        .arg(source)
        .output()
        .expect("rustc runs");
    (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned())
}

/// A build of the library beside this test, the latest one that rustc can use.
fn library() -> PathBuf {
    let test = std::env::current_exe().expect("a path");
    let deps = test.parent().expect("a folder").read_dir().expect("the builds");
    let mut builds: Vec<_> = deps
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            name.starts_with("liblyapunov-") && name.ends_with(".rlib")
        })
        .collect();
    builds.sort_by_key(|path| path.metadata().and_then(|it| it.modified()).expect("a time"));
    let sound = "pub fn zero<T: lyapunov::Scalar>() -> T { T::of(0.0) }";
    builds
        .into_iter()
        .rev()
        .find(|path| compiled("sound", sound, path).0)
        .expect("a build of the library that rustc can use")
}

/// `compile_fail,E0369` alone passes on a stable compiler whatever the error is.
#[test]
fn rustc_gives_the_errors_that_the_page_names() {
    let (library, refused) = (library(), refused());
    assert_eq!(refused.len(), 5);
    for (index, (code, block)) in refused.into_iter().enumerate() {
        let (built, told) = compiled(&format!("block{index}"), block, &library);
        assert!(!built, "compiles:\n{block}");
        let errors: Vec<&str> = told.lines().filter(|line| line.starts_with("error[")).collect();
        assert!(!errors.is_empty(), "{told}");
        for error in errors {
            assert!(error.starts_with(&format!("error[{code}]")), "{error}\n{block}");
        }
    }
}
