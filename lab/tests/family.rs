//! The family by name: each stabilizer is what docs/family.md says, with the numbers of that page worked out by hand.

use approx::abs_diff_eq;
use lyapunov::laws::Samples;
use lyapunov::{
    DampingLimit, Popc, PortEnergy, PortSample, Scalar, Stabilizer, StorageFunction,
    accumulators::Plain,
    candidates::InContact,
    stabilizers::{
        EnergyBounding, ForceBound, ForceBounding, LeastNorm, MemoryBased, ReferenceDamper,
        ReferenceFollowing, StabilizerExt, Tank, TankLimits, WindowedCredit,
    },
};
use lyapunov_lab::family::{StabilizerName, StabilizerNames};
use lyapunov_lab::{AnyStabilizer, F64x8, Rollout, Row, Scene};

/// A hand of 0.2 + 0.3 kg on 50 N/m, let go 40 mm before a wall that is computed every fourth tick.
const SCENE: &str = "
duration = 3.0
servo_rate = 1000.0
environment_rate = 250.0
operator = { mass = 0.2, damping = 0.1, stiffness = 50.0 }
device = { mass = 0.3, damping = 0.25 }
initial.position = -0.04
environment.wall = { position = 0.001, stiffness = 20000.0, damping = 1.0 }
effects.encoder.resolution = 1e-5
stabilizer.popc.damping_cap = 0.4
";

/// ½ k swing²: 50 N/m over the 40 mm from the start to where the hand comes to rest, which is before the wall.
const ENERGY: f64 = 0.5 * 50.0 * 0.04 * 0.04;

const PERIOD: f64 = 1e-3;

fn popc() -> Popc<f64> {
    Popc::new(PortEnergy, DampingLimit::of_mass(0.4, 0.5, PERIOD).unwrap())
}

/// The stabilizer of this name, built by hand.
fn by_hand(name: &str) -> Option<AnyStabilizer<f64>> {
    let popc = popc();
    // √(k / m) = 10 rad/s over 40 mm.
    let speed = 0.4;
    Some(match name {
        "popc" | "lolc-spring" | "popc-budgeted" => AnyStabilizer::new(popc),
        "popc-bounded" => AnyStabilizer::new(popc.bounded(ENERGY).unwrap()),
        "popc-windowed" => {
            // A swing of 2π / 10 rad/s is 628.3 ticks, an eighth of it 78.5.
            let sum = WindowedCredit::<f64, Plain<f64>, 8>::of_ticks(79).unwrap();
            AnyStabilizer::new(popc.summed_by(sum))
        }
        "popc-contact-reset" => AnyStabilizer::new(popc.reset_at(InContact { position: 0.001 })),
        "popc-threshold" => AnyStabilizer::new(popc.above_velocity(1.5e-5 / PERIOD).unwrap()),
        "popc-spread" => AnyStabilizer::new(popc.spread_over(4).unwrap()),
        "popc-rising" => AnyStabilizer::new(popc.rising_over(4).unwrap()),
        "popc-rate-limited" => {
            let rate = 0.4 * 0.5 / PERIOD * speed / (4.0 * PERIOD);
            AnyStabilizer::new(popc.rate_limited::<f64>(rate).unwrap())
        }
        "popc-reference" => {
            let stored = |x: f64, _v: f64| 10000.0 * (x - 0.001).max(0.0).powi(2);
            let candidate = (PortEnergy, StorageFunction::starting(stored, -0.04, 0.0));
            let limit = DampingLimit::of_mass(0.4, 0.5, PERIOD).unwrap();
            AnyStabilizer::new(ReferenceFollowing::new(candidate, limit))
        }
        "force-bound" => {
            AnyStabilizer::new(ForceBound::new(0.25).unwrap().budgeted(ENERGY).unwrap())
        }
        "tank" => {
            let store = TankLimits {
                start: ENERGY,
                floor: 0.0,
                ceiling: 2.0 * ENERGY,
                power: f64::INFINITY,
            };
            AnyStabilizer::new(Tank::new(PortEnergy, store).unwrap())
        }
        _ => return rival_by_hand(name),
    })
}

/// A published law of this name, built here for a prompt force.
fn rival_by_hand(name: &str) -> Option<AnyStabilizer<f64>> {
    let limit = DampingLimit::of_mass(0.4, 0.5, PERIOD).unwrap();
    Some(match name {
        "energy-bounding" => AnyStabilizer::new(EnergyBounding::of_damping(0.25, PERIOD).unwrap()),
        "force-bounding" => AnyStabilizer::new(ForceBounding::of_damping(0.25).unwrap()),
        "memory-based" => {
            // Twice as deep as a spring of the wall's largest slope takes up the energy: more than 256 counts.
            let slope = 20000.0 + 2.0 * 1.0 / (1.0 / 250.0);
            let depth: f64 = 2.0 * (2.0 * ENERGY / slope).sqrt();
            assert!(depth > 256.0 * 1e-5);
            let memory = MemoryBased::<f64, 256>::beyond(0.001, depth);
            AnyStabilizer::new(memory.unwrap())
        }
        "reference-following" => {
            let depth = |x: f64| (x - 0.001).max(0.0);
            let stored = move |x: f64, _v: f64| 0.5 * 20000.0 * depth(x) * depth(x);
            let damper = ReferenceDamper::starting(1.0, depth, -0.04).unwrap();
            let stored = StorageFunction::starting(stored, -0.04, 0.0);
            AnyStabilizer::new(ReferenceFollowing::new((PortEnergy, (stored, damper)), limit))
        }
        "least-norm" => AnyStabilizer::new(LeastNorm::new(PortEnergy, limit, 1.0).unwrap()),
        _ => return None,
    })
}

const RIVALS: [&str; 5] =
    ["energy-bounding", "force-bounding", "memory-based", "reference-following", "least-norm"];

/// Asserts equal rows, up to the rounding of numbers that are computed in another order.
fn alike(name: &str, ours: &[Row], theirs: &[Row]) {
    assert_eq!(ours.len(), theirs.len(), "{name}");
    // Rounding errors grow, so only the beginning is compared; the first contact is at 0.157 s.
    for (one, other) in ours.iter().zip(theirs).take(400) {
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-6 * (1e-3 + a.abs());
        assert!(near(one.x, other.x) && near(one.f_out, other.f_out), "{name}: {one:?} {other:?}");
    }
}

#[test]
fn each_stabilizer_is_set_as_the_page_says() {
    let scene = Scene::parse(SCENE, "test").unwrap();
    let rows = |stabilizer| rows(&scene, stabilizer);
    let mut built = 0;
    let none = rows_under(&scene, StabilizerName::ALL[0]);
    for member in StabilizerName::ALL {
        let Some(by_hand) = by_hand(member.name()) else { continue };
        let ours = rows_under(&scene, member);
        alike(member.name(), &ours, &rows(by_hand));
        // Each stabilizer acts in this run, so that its numbers matter.
        assert!(ours.iter().zip(&none).any(|(one, other)| one.f_out != other.f_out), "{member}");
        built += 1;
    }
    assert_eq!(built, 18);
}

/// Differences of two counts over the period round to either side of one count a tick.
#[test]
fn ticks_of_one_count_are_below_the_threshold() {
    let count = 2e-5;
    // A hand that presses on a softer wall, and so owes energy at small speeds.
    let pressed = SCENE.replace("1e-5", "2e-5").replace("20000.0", "4000.0");
    let pressed = pressed.replace("50.0 }", "50.0, rest = 0.006 }").replace("-0.04", "-0.004");
    let scene = Scene::parse(&pressed, "test").unwrap();
    let rows = rows_under(&scene, "popc-threshold".parse().unwrap());
    let ticks = |row: &Row| (row.v * PERIOD / count).abs().round();
    assert!(rows.iter().all(|row| row.alpha == 0.0 || ticks(row) >= 2.0));
    assert!(rows.iter().any(|row| row.alpha > 0.0 && ticks(row) == 2.0));
    let owed = |row: &&Row| ticks(row) == 1.0 && row.shortfall > 0.0;
    let above = rows.iter().filter(owed).filter(|row| row.v.abs() > count / PERIOD).count();
    let below = rows.iter().filter(owed).filter(|row| row.v.abs() < count / PERIOD).count();
    assert!(above > 0 && below > 0, "{above} above, {below} below");
}

fn rows_under(scene: &Scene, member: StabilizerName) -> Vec<Row> {
    Rollout::<f64>::under(scene, member).unwrap().rows().collect()
}

fn rows(scene: &Scene, stabilizer: AnyStabilizer<f64>) -> Vec<Row> {
    Rollout::stabilized_by(scene, stabilizer).unwrap().rows().collect()
}

/// To the bit: nothing is rounded twice on the way from the scene.
#[test]
fn the_published_laws_are_the_librarys_own() {
    let scene = Scene::parse(SCENE, "test").unwrap();
    for name in RIVALS {
        let named: StabilizerName = name.parse().unwrap();
        let ours = Rollout::<f64>::under(&scene, named).unwrap().rows().collect::<Vec<_>>();
        assert_eq!(ours, rows(&scene, rival_by_hand(name).unwrap()), "{name}");
    }
}

/// Two ticks late, without an encoder: the laws that know of a delay are told of it, and a cell is what a tick moves at 0.4 m/s.
#[test]
fn the_published_laws_know_the_delay_of_the_scene() {
    for ticks in [2, 20] {
        let late = SCENE.replace(
            "effects.encoder.resolution = 1e-5",
            &format!("effects.delay.ticks = {ticks}"),
        );
        let scene = Scene::parse(&late, "test").unwrap();
        let by_hand = |name: &str| match name {
            "energy-bounding" => AnyStabilizer::new(
                EnergyBounding::of_damping(0.25, PERIOD).unwrap().delayed(ticks).unwrap(),
            ),
            "force-bounding" => {
                let bounding = ForceBounding::of_damping(0.25).unwrap();
                AnyStabilizer::new(bounding.delayed::<20>(ticks).unwrap())
            }
            _ => {
                let memory = MemoryBased::<f64, 256>::beyond(0.001, 256.0 * 0.4 * PERIOD);
                AnyStabilizer::new(memory.unwrap().delayed(ticks))
            }
        };
        for name in ["energy-bounding", "force-bounding", "memory-based"] {
            let named: StabilizerName = name.parse().unwrap();
            let ours = rows_under(&scene, named);
            alike(name, &ours, &rows(&scene, by_hand(name)));
            let prompt = rows(&scene, rival_by_hand(name).unwrap());
            assert!(
                ours.iter().zip(&prompt).any(|(one, other)| one.f_out != other.f_out),
                "{name}"
            );
        }
    }
}

/// The wall's damper is in the reference of the one and not of the other; without it they are the same, to the bit.
#[test]
fn a_reference_has_the_walls_damper() {
    let both = |text: &str| {
        let scene = Scene::parse(text, "test").unwrap();
        ["reference-following", "popc-reference"]
            .map(|name| rows_under(&scene, name.parse().unwrap()))
    };
    let [following, stored] = both(SCENE);
    assert_ne!(following, stored);
    let [following, stored] = both(&SCENE.replace(", damping = 1.0 }", " }"));
    assert_eq!(following, stored);
}

/// Without a damping of the device the laws that rely on it are refused by name, and `all` is everybody else.
#[test]
fn energy_bounding_needs_a_damping() {
    let bare = SCENE.replace(", damping = 0.25", "");
    let scene = Scene::parse(&bare, "test").unwrap();
    let bounding: StabilizerName = "energy-bounding".parse().unwrap();
    let refused = bounding.on::<f64>(&scene).unwrap_err().to_string();
    assert_eq!(refused, "device.damping is 0.0; it must be above 0 and finite");
    let names = |given: &str| given.parse::<StabilizerNames>().unwrap().on(&scene);
    let all = names("all");
    let lacking = StabilizerName::ALL.into_iter().filter(|name| !all.contains(name));
    let lacking: Vec<&str> = lacking.map(StabilizerName::name).collect();
    assert_eq!(lacking, ["energy-bounding", "slope-bound", "virtual-coupling"]);
    assert!(!all.contains(&bounding) && names("popc,energy-bounding").contains(&bounding));
    let damped = Scene::parse(SCENE, "test").unwrap();
    assert_eq!(*"all".parse::<StabilizerNames>().unwrap().on(&damped), StabilizerName::ALL);
}

/// Every stabilizer that differs from POPC by a parameter differs from it in at least one of these loops; otherwise a
/// wrong parameter would go unnoticed.
#[test]
fn every_parameter_makes_a_difference() {
    let coarse = SCENE.replace("resolution = 1e-5", "resolution = 1e-4");
    // The hand presses for a second at a time into a soft wall: the wall then gives back later than one swing after it took.
    let soft = SCENE.replace("position = -0.04", "position = -0.002").replace("20000.0", "500.0");
    let motion = "motion = { kind = \"sine\", amplitude = 0.06, frequency = 0.5 }";
    let pressed = soft.replace("stiffness = 50.0", &format!("stiffness = 50.0, {motion}"));
    // A pulse presses a hand that stays much further than it starts: the wall gives back more than the start's energy.
    let pushed = format!("{soft}effects.pulse = {{ start = 0.5, duration = 1.0, force = 5.0 }}\n");
    let forces = |text: &str, member: StabilizerName| -> Vec<f64> {
        let scene = Scene::parse(text, "test").unwrap();
        let rollout = Rollout::<f64>::under(&scene, member).unwrap();
        rollout.map(|tick| tick.command).collect()
    };
    let popc: StabilizerName = "popc".parse().unwrap();
    let same: Vec<&str> = StabilizerName::ALL
        .into_iter()
        .filter(|member| {
            let texts = [SCENE, &coarse, &pressed, &pushed];
            texts.iter().all(|text| forces(text, *member) == forces(text, popc))
        })
        .map(StabilizerName::name)
        .collect();
    // The budget is zero here, since nothing is stored at the start.
    assert_eq!(same, ["popc", "lolc-spring", "popc-budgeted"]);
}

/// A start inside the wall: 20 kN/m, pressed by 2 mm, store 40 mJ.
#[test]
fn a_budget_is_the_energy_stored_at_the_start() {
    let scene = SCENE.replace("position = -0.04", "position = 0.003");
    let scene = Scene::parse(&scene, "test").unwrap();
    let member: StabilizerName = "popc-budgeted".parse().unwrap();
    let mut budgeted = member.on::<f64>(&scene).unwrap().behind().unwrap();
    let still = PortSample::starting(PERIOD, 0.003, 0.0);
    let sum = budgeted.stabilize(&still, 40.0).observed_energy;
    assert!(abs_diff_eq!(sum, 0.5 * 20000.0 * 0.002 * 0.002, epsilon = 1e-15), "{sum}");
}

#[test]
fn names_are_read_and_written() {
    let mut names = Vec::new();
    for member in StabilizerName::ALL {
        let name = member.name();
        assert_eq!(name.parse(), Ok(member));
        assert!(name.chars().all(|c| c.is_ascii_lowercase() || c == '-'), "{name}");
        assert!(!names.contains(&name), "{name} is there twice");
        names.push(name);
    }
    let all: StabilizerNames = "all".parse().unwrap();
    assert_eq!(*all, StabilizerName::ALL);
    assert_eq!(all.to_string(), names.join(","));
    assert_eq!(all.to_string().parse(), Ok(all));
    for (given, words) in [
        ("popc-refrence", &["`popc-refrence`", "did you mean `popc-reference`?", "tank"][..]),
        ("zzz", &["`zzz`", "the names are", "popc-bounded", "lolc-mass-spring-damper"]),
        ("", &["``", "the names are"]),
        ("popc,,tank", &["``"]),
        ("tank,popc,tank", &["`tank` is named twice"]),
    ] {
        let said = given.parse::<StabilizerNames>().unwrap_err().to_string();
        words.iter().for_each(|word| assert!(said.contains(word), "{word}: {said}"));
        assert!(said.lines().all(|line| line.chars().count() <= 100), "{said}");
    }
}

fn first<L: Scalar>(sample: &PortSample<L>) -> PortSample<f64> {
    sample.map(sample.period.lane(0), |value| value.lane(0))
}

#[test]
fn lanes_and_scalars_are_set_alike() {
    let scene = Scene::parse(SCENE, "test").unwrap();
    for member in StabilizerName::ALL {
        member.on::<f32>(&scene).unwrap();
        // The others are ports around an environment.
        let Some(mut lanes) = member.on::<F64x8>(&scene).unwrap().behind() else { continue };
        let mut alone = member.on::<f64>(&scene).unwrap().behind().unwrap();
        for (sample, effort) in Samples::<F64x8>::new(F64x8::of(PERIOD)).seeded(7) {
            let together = lanes.stabilize(&sample, effort);
            let correction = alone.stabilize(&first(&sample), effort.lane(0));
            let (ours, theirs) = (together.effort.lane(0), correction.effort);
            assert_eq!(
                (ours, together.observed_energy.lane(0)),
                (theirs, correction.observed_energy),
                "{member}"
            );
        }
    }
}

/// No number of a scene gives a stabilizer an invalid parameter.
#[test]
fn every_stabilizer_can_be_made_for_odd_scenes() {
    let wall = "environment.wall.stiffness = 0.0\n";
    for odd in [
        // No hand, no damping, nothing moves.
        "duration = 0.1\nservo_rate = 1000.0\ndevice.mass = 0.2\n".to_owned() + wall,
        "duration = 0.1\nservo_rate = 1e6\nenvironment_rate = 10.0\ndevice.mass = 1e-6\n"
            .to_owned()
            + wall,
        "duration = 1e4\nservo_rate = 1e-3\ndevice.mass = 1e6\ninitial.velocity = 1e6\n".to_owned()
            + wall,
        SCENE.replace("damping_cap = 0.4", "damping_cap = inf"),
        SCENE.replace("damping_cap = 0.4", "damping_cap = 0"),
        SCENE
            .replace("environment.wall", "environment.spring")
            .replace(", damping = 1.0 }", "}")
            .replace("20000", "-20"),
        SCENE.replace("environment.wall", "environment.mass-spring-damper"),
        SCENE
            .replace("environment.wall", "environment.hunt-crossley")
            .replace("}\neffects", ", exponent = 1.5 }\neffects"),
        SCENE
            .replace("environment.wall", "environment.layered-wall")
            .replace("20000.0", "[2000.0, 20000.0], depth = 0.001"),
    ] {
        let scene = Scene::parse(&odd, "odd").unwrap_or_else(|fault| panic!("{odd}: {fault}"));
        for member in StabilizerName::ALL.into_iter().filter(|member| member.fits(&scene)) {
            let made = member.on::<f64>(&scene).unwrap_or_else(|error| panic!("{member}: {error}"));
            let rows = Rollout::assemble(&scene, made).unwrap().count();
            assert!(rows > 0, "{member} {odd}");
            member.on::<f32>(&scene).unwrap_or_else(|error| panic!("{member} in f32: {error}"));
        }
    }
}
