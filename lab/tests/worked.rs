//! Published laws from scene files: numbers worked by hand, and what each paper promises of a run.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use lyapunov::{HeldTick, OnePort, Scalar};
use lyapunov_lab::{Assembly, F64x8, Rollout, Scene, Space, Summary};

const PERIOD: f64 = 1e-3;

/// A press and a release on a spring of 5 kN/m, in tenths of a millimetre.
const WAY: [f64; 10] = [0.0, 1.0, 3.0, 6.0, 8.0, 8.0, 6.0, 3.0, 1.0, 0.0];

/// A wall of 5 kN/m at 0, a device of 0.2 kg with 0.5 N·s/m, 1 kHz.
fn scene(more: &str) -> Scene {
    let text = format!(
        "duration = 1.0\nservo_rate = 1000.0\ndevice = {{ mass = 0.2, damping = 0.5 }}\n\
         environment.wall.stiffness = 5000.0\n{more}\n"
    );
    Scene::parse(&text, "test").unwrap_or_else(|fault| panic!("{fault}"))
}

/// The forces that the port of a scene gives on the way, in N; each acts until the next.
fn forces<T: Scalar + Space>(scene: &Scene, way: &[f64]) -> Vec<T> {
    let mut port = Assembly::<T>::of(scene).unwrap().port;
    let (mut last, mut force) = (T::of(0.0), T::of(0.0));
    let step = |(number, x): (usize, &f64)| {
        let x = T::of(1e-4 * x);
        let moved = if number == 0 { T::of(0.0) } else { x - last };
        let velocity = moved / T::of(PERIOD);
        force = port.respond(
            &HeldTick {
                period: T::of(PERIOD),
                position: x,
                velocity,
                displacement: moved,
                applied: force,
            }
            .sample(),
        );
        last = x;
        force
    };
    way.iter().enumerate().map(step).collect()
}

/// Tables of stabilizers, and the forces on the way: worked by hand from each paper's equations.
#[rustfmt::skip]
const WORKED: &[(&str, [f64; 10])] = &[
    ("energy-bounding = {}", [0.0, 0.05, 0.15, 0.3, 0.4, 0.4, 0.312311, 0.196465, 0.120451, 0.0704505]),
    ("energy-bounding = { c1 = 500.0, c2 = 250.0 }", [0.0, 0.05, 0.120711, 0.217113, 0.272796, 0.272796, 0.22734, 0.164392, 0.121828, 0.0718277]),
    ("force-bounding = {}", [0.0, 0.1, 0.3, 0.6, 0.8, 0.8, 0.6, 0.3, 0.1, 0.0]),
    ("force-bound.budget = 1e-4", [0.0, 0.458258, 0.658258, 0.958258, 1.15826, 1.15826, 0.958258, 0.658258, 0.458258, 0.0]),
    ("memory-based.cell = 1e-4", [0.0, 0.5, 1.5, 3.0, 4.0, 4.0, 1.5, 0.0, 0.0, 0.0]),
    ("reference-following = {}", [0.0, 0.75, 1.875, 3.625, 4.8125, 4.0, 1.6875, 1.1875, -0.15625, -0.90625]),
    ("popc-reference = {}", [0.0, 0.75, 1.875, 3.625, 4.8125, 4.0, 1.6875, 1.1875, -0.15625, -0.90625]),
    ("popc = {}", [0.0, 0.5, 1.5, 3.0, 4.0, 4.0, 3.0, -0.333333, -1.91667, -2.91667]),
    ("least-norm = {}", [0.0, 0.5, 1.5, 3.0, 4.0, 4.0, 1.75, -0.583333, -0.291667, -0.291667]),
    ("least-norm.decay = 0.5", [0.0, 0.5, 1.5, 3.0, 4.0, 4.0, 0.875, 0.145833, 0.145833, 0.0]),
    ("iss.feed = 0", [0.0, 0.5, 1.20588, 2.29066, 2.65255, 2.43967, 1.5649, 0.579472, 0.159134, 0.0]),
    ("iss = {}", [0.0, 3.0, 4.73529, 7.71453, 4.46204, 1.37527, -2.80898, -4.34766, -1.94255, -0.795671]),
    ("iss = { slope = 1e4, feed = 2e-3 }", [0.0, 1.5, 2.75, 4.625, 3.6875, 2.15625, -0.078125, -1.46094, -0.769531, -0.351563]),
    ("iss = { slope = inf, feed = 0 }", [0.0, 0.5, 1.5, 3.0, 4.0, 4.0, 3.0, 1.5, 0.5, 0.0]),
];

#[test]
fn tables_give_the_worked_forces() {
    for (table, expected) in WORKED {
        let got = forces::<f64>(&scene(&format!("stabilizer.{table}")), &WAY);
        for (tick, (got, expected)) in got.iter().zip(expected).enumerate() {
            assert!((got - expected).abs() <= 1e-5, "{table} tick {tick}: {got}, not {expected}");
        }
    }
}

/// On an environment whose slope has no bound the slope is watched: a hardening spring that is straight so far.
#[test]
fn an_environment_without_a_bound_is_followed() {
    let watched = scene("stabilizer.iss = {}").to_draft();
    let text = toml::to_string(&watched).unwrap().replace(
        "[environment.wall]\nposition = 0.0\nstiffness = 5000.0\ndamping = 0.0\n",
        "[environment.cubic-spring]\nstiffness = 5000.0\ncubic = 1e-9\n",
    );
    let cubic = Scene::parse(&text, "test").unwrap_or_else(|fault| panic!("{fault}\n{text}"));
    // From the second tick on the slope is 1.7 times what was seen, as with 8500 N/m from the start.
    let expected = WORKED.iter().find(|(table, _)| *table == "iss = {}").unwrap().1;
    for (got, expected) in forces::<f64>(&cubic, &WAY).into_iter().zip(expected).take(9) {
        assert_abs_diff_eq!(got, expected, epsilon = 1e-4);
    }
}

/// Every lane equals its scalar, also of the ports around the environment.
#[test]
fn lanes_of_a_table_equal_the_scalar() {
    let coupled = "virtual-coupling = {}";
    for (table, _) in WORKED.iter().chain(&[(coupled, [0.0; 10])]) {
        let scene = scene(&format!("stabilizer.{table}"));
        let lanes = forces::<F64x8>(&scene, &WAY);
        for (lanes, alone) in lanes.iter().zip(forces::<f64>(&scene, &WAY)) {
            assert_eq!([lanes.lane(0), lanes.lane(7)], [alone; 2], "{table}");
        }
    }
}

/// Held long enough, a spring `K` is felt as `K` and `μ` in series, and `τ` is not felt.
#[test]
fn the_input_to_state_port_rests_on_both_springs_in_series() {
    let mut way = vec![0.0; 2];
    way.resize(400, 10.0);
    for (table, slope) in [("iss = {}", 8500.0), ("iss.slope = 2e4", 2e4)] {
        let force = forces::<f64>(&scene(&format!("stabilizer.{table}")), &way).pop().unwrap();
        let both = 1.0 / (1.0 / 5000.0 + 1.0 / slope);
        assert_relative_eq!(force, both * 1e-3, max_relative = 1e-9);
    }
}

/// The virtual coupling rests on its spring and the wall's in series.
#[test]
fn the_virtual_coupling_rests_on_both_springs_in_series() {
    let mut way = vec![0.0; 2];
    way.resize(4000, 10.0);
    let force = forces::<f64>(&scene("stabilizer.virtual-coupling = {}"), &way).pop().unwrap();
    // Half of the damping pays for the spring: 0.25 N·s/m · 2 / 1 ms.
    let both = 1.0 / (1.0 / 5000.0 + 1.0 / 500.0);
    assert_relative_eq!(force, both * 1e-3, max_relative = 1e-6);
}

/// The port asks at the environment's rate: with a hold, its forces are those of a servo at that rate, held.
#[test]
fn the_input_to_state_port_runs_at_the_environments_rate() {
    let slow = scene("stabilizer.iss = {}");
    let slow = toml::to_string(&slow).unwrap().replace("servo_rate = 1000.0", "servo_rate = 250.0");
    let slow = Scene::parse(&slow, "slow").unwrap();
    let held = scene("environment_rate = 250.0\nstabilizer.iss = {}");
    // The way of the slow one, at every fourth tick of the fast one.
    let fast: Vec<f64> = (0..40)
        .map(|tick| {
            let (whole, part) = (tick / 4, (tick % 4) as f64 / 4.0);
            let next = WAY.get(whole + 1).copied().unwrap_or(0.0);
            WAY[whole] + part * (next - WAY[whole])
        })
        .collect();
    let mut port = Assembly::<f64>::of(&slow).unwrap().port;
    let (mut last, mut force) = (0.0, 0.0);
    let slow: Vec<f64> = WAY
        .iter()
        .map(|x| {
            let moved = 1e-4 * x - last;
            last = 1e-4 * x;
            force = port.respond(
                &HeldTick {
                    period: 4e-3,
                    position: last,
                    velocity: moved / 4e-3,
                    displacement: moved,
                    applied: force,
                }
                .sample(),
            );
            force
        })
        .collect();
    for (tick, force) in forces::<f64>(&held, &fast).into_iter().enumerate() {
        assert_relative_eq!(force, slow[tick / 4], max_relative = 1e-9, epsilon = 1e-12);
    }
}

/// A hand on a wall that gains energy from its hold, as the scene has it.
const LOOP: &str = "
duration = 4.0
servo_rate = 1000.0
operator = { mass = 0.1, damping = 0.1, stiffness = 50.0, rest = 0.002 }
device = { mass = 0.2, damping = 0.5 }
initial.position = -0.02
environment.wall = { stiffness = 9000.0 }
";

/// `Σ F Δx + b Δx² / T` over a run, at its least, J.
fn least(scene: &Scene) -> f64 {
    let damping = scene.device.damping.get();
    let (mut energy, mut least, mut last) = (0.0_f64, 0.0_f64, None);
    for row in Rollout::<f64>::of(scene).unwrap().rows() {
        if let Some((x, force)) = last.replace((row.x, row.f_act)) {
            let moved = row.x - x;
            energy += force * moved + damping * moved * moved / PERIOD;
            least = least.min(energy);
        }
    }
    least
}

/// The promise of the bounding laws: port and damper give nothing away, prompt or late. Without them this loop does.
#[test]
fn port_and_damper_are_passive_under_the_bounding_laws() {
    for late in ["", "effects.delay.ticks = 3\n"] {
        let of = |table: &str| Scene::parse(&format!("{LOOP}{late}{table}"), "test").unwrap();
        assert!(least(&of("")) < -1e-4, "{}", least(&of("")));
        for table in ["energy-bounding = {}", "force-bounding = {}"] {
            let least = least(&of(&format!("stabilizer.{table}")));
            assert!(least >= -1e-12, "{table}: {least}");
        }
    }
}

/// The promise of the tank: what is given beyond what was taken is at most what was in it, up to the last tick's guess.
#[test]
fn a_tank_gives_no_more_than_is_in_it() {
    for start in [0.0, 1e-3] {
        let text = format!("{LOOP}stabilizer.tank = {{ start = {start:?}, ceiling = 1.0 }}");
        let scene = Scene::parse(&text, "test").unwrap();
        let summary = Summary::of(&scene, Rollout::<f64>::of(&scene).unwrap());
        let bare = Scene::parse(LOOP, "test").unwrap();
        let bare = Summary::of(&bare, Rollout::<f64>::of(&bare).unwrap());
        assert!(bare.absorbed < -5e-3, "{}", bare.absorbed);
        assert!(summary.absorbed >= -start - summary.shortfall - 1e-12, "{}", summary.absorbed);
        assert!(summary.shortfall < 1e-3, "{}", summary.shortfall);
    }
}

/// The input-to-state port adds damping: it settles what grows by itself.
#[test]
fn the_input_to_state_port_settles_a_growing_loop() {
    let settled = |table: &str| {
        let scene = Scene::parse(&format!("{LOOP}{table}"), "test").unwrap();
        Summary::of(&scene, Rollout::<f64>::of(&scene).unwrap()).settled
    };
    assert_eq!(settled(""), None);
    assert!(settled("stabilizer.iss = {}").is_some_and(|time| time < 3.0));
}
