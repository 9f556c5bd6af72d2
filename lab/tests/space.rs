//! Scenes in a space: on one axis they are the scene on a line, a rotation changes nothing, and energies and rests are
//! those of closed forms.

use approx::{assert_abs_diff_eq, assert_relative_eq};
use lyapunov_lab::compare::{Comparison, Entrants, Score};
use lyapunov_lab::explain::{Balance, Explanation};
use lyapunov_lab::family::StabilizerNames;
use lyapunov_lab::{Rollout, SVector, Scene, Space, Summary, Verdict};

use crate::bound::systems::scene;

type Plane = SVector<f64, 2>;
type Space3 = SVector<f64, 3>;

/// A hand that falls from 4 mm onto a surface and stays pressed; `place` has the coordinates and the environment.
fn pressed(place: &str) -> Scene {
    scene(&format!(
        "duration = 8\nservo_rate = 1000\ndevice = {{ mass = 0.2, damping = 0.1 }}\n\
         operator.mass = 0.1\noperator.damping = 1.5\noperator.stiffness = 200\n{place}"
    ))
}

/// What is measured of a run, in the order of the table; none is NaN here.
fn numbers(score: &Score) -> Vec<f64> {
    [
        score.settling_time,
        score.short_peak,
        score.long_peak,
        score.energy_injected,
        score.energy_taken,
        score.shortfall,
        score.stiffness_felt,
        score.stiffness_percent,
        score.force_error,
        score.chatter,
        score.active,
        score.energy_given,
        score.energy_given_beyond_damper,
        score.force_felt,
    ]
    .map(|it| it.unwrap_or(f64::NAN))
    .to_vec()
}

fn scores<V: Space>(scene: &Scene, names: &str) -> Vec<Score> {
    let names: StabilizerNames = names.parse().unwrap();
    let compared = Comparison::of("test", scene, &Entrants::<V>::of(names)).unwrap();
    compared.scores().cloned().collect()
}

#[track_caller]
fn assert_alike(one: &[Score], other: &[Score], within: f64) {
    assert_eq!(one.len(), other.len());
    for (one, other) in one.iter().zip(other) {
        assert_eq!(one.verdict, other.verdict, "{}", one.stabilizer);
        for (at, (a, b)) in numbers(one).into_iter().zip(numbers(other)).enumerate() {
            let same = a.is_nan() && b.is_nan() || (a - b).abs() <= within * (1.0 + a.abs());
            assert!(same, "{} of {}: {a} and {b}", at, one.stabilizer);
        }
    }
}

/// Those whose defaults do not follow from the energy of the start, which is another about the hand's rest than about x_eq.
const NAMES: &str = "none,popc,lolc,iss,virtual-coupling,force-bounding,popc-spread";

#[test]
fn on_one_axis_a_space_has_the_numbers_of_a_line() {
    let line = pressed(
        "initial = { position = -0.004, velocity = 0.1 }\noperator.rest = 0.006\n\
         environment.wall = { position = 0.001, stiffness = 4000, damping = 2 }\n\
         effects.delay.ticks = 2\neffects.saturation.force = 30\neffects.encoder.resolution = 1e-5\n\
         effects.load.force = 0.2",
    );
    let plane = pressed(
        "space.dimensions = 2\ninitial = { position = [-0.004, 0], velocity = [0.1, 0] }\n\
         operator.rest = [0.006, 0]\n\
         environment.plane = { point = [0.001, 0], normal = [-2, 0], stiffness = 4000, damping = 2 }\n\
         effects.delay.ticks = 2\neffects.saturation.force = 30\neffects.encoder.resolution = 1e-5\n\
         effects.load.force = 0.2",
    );
    assert_alike(&scores::<f64>(&line, NAMES), &scores::<Plane>(&plane, NAMES), 1e-12);
    let [one, other] =
        [Explanation::of::<f64>(&line).unwrap(), Explanation::of::<Plane>(&plane).unwrap()];
    let balances = [(one.whole_run, other.whole_run)]
        .into_iter()
        .chain(one.first_contact.zip(other.first_contact));
    for (one, other) in balances {
        for ((part, a), (_, b)) in one.parts().into_iter().zip(other.parts()) {
            assert_abs_diff_eq!(a, b, epsilon = 1e-15 + 1e-12 * a.abs());
            assert!(a.is_finite(), "{part}");
        }
    }
    assert_eq!((one.verdict, one.verdict_by), (other.verdict, other.verdict_by));
    assert_eq!(one.remedies.len(), other.remedies.len());
    for (one, other) in one.remedies.iter().zip(&other.remedies) {
        assert_relative_eq!(one.peak_force, other.peak_force, max_relative = 1e-9);
    }
}

/// A hand before a plane, turned by an angle about the origin.
fn turned_plane(angle: f64) -> Scene {
    let (sin, cos) = angle.sin_cos();
    let at = |x: f64, y: f64| format!("[{:?}, {:?}]", x * cos - y * sin, x * sin + y * cos);
    pressed(&format!(
        "space.dimensions = 2\ninitial = {{ position = {}, velocity = {} }}\noperator.rest = {}\n\
         environment.plane = {{ point = {}, normal = {}, stiffness = 5000, damping = 3 }}",
        at(-0.004, 0.01),
        at(0.1, 0.2),
        at(0.006, -0.01),
        at(0.001, 0.0),
        at(-1.0, 0.0)
    ))
}

#[test]
fn a_turned_plane_changes_no_measure() {
    let names = "none,popc,lolc,tank,least-norm,iss,virtual-coupling,directed-damping";
    let straight = scores::<Plane>(&turned_plane(0.0), names);
    assert!(straight.iter().all(|score| score.stiffness_felt.is_some()));
    for angle in [0.7, 2.0, -1.3] {
        assert_alike(&straight, &scores::<Plane>(&turned_plane(angle), names), 1e-6);
        let [one, other] = [0.0, angle]
            .map(|angle| Explanation::of::<Plane>(&turned_plane(angle)).unwrap().whole_run);
        for ((part, a), (_, b)) in one.parts().into_iter().zip(other.parts()) {
            assert!((a - b).abs() <= 1e-9 * (1e-3 + a.abs()), "{part}: {a} and {b}");
        }
    }
}

#[test]
fn a_turned_approach_to_a_ball_changes_no_measure() {
    // The axes in another order and with other signs: the ball is the same from there.
    let ball = |[x, y, z]: [usize; 3], sign: f64| {
        let at = |of: [f64; 3]| format!("[{:?}, {:?}, {:?}]", sign * of[x], of[y], sign * of[z]);
        pressed(&format!(
            "space.dimensions = 3\ninitial.position = {}\noperator.rest = {}\n\
             environment.sphere = {{ center = [0, 0, 0], radius = 0.02, stiffness = 3000, damping = 5 }}",
            at([0.004, -0.01, 0.03]),
            at([0.001, 0.002, 0.015])
        ))
    };
    let own = scores::<Space3>(&ball([0, 1, 2], 1.0), "none,popc,tank");
    assert!(own.iter().all(|score| score.verdict == Verdict::Settles));
    for (axes, sign) in [([1, 2, 0], 1.0), ([0, 1, 2], -1.0), ([2, 0, 1], -1.0)] {
        assert_alike(&own, &scores::<Space3>(&ball(axes, sign), "none,popc,tank"), 1e-9);
    }
}

/// Free flight with a damper: `½ m v² (1 − exp(−2 b t / m))` on each axis, and friction takes all of the rest.
#[test]
fn energies_of_free_flight_are_those_of_the_closed_form() {
    let free = |more: &str| {
        scene(&format!(
            "duration = 2\nservo_rate = 500\nspace.dimensions = 3\n\
             device = {{ mass = 0.2, damping = 0.05 }}\ninitial.velocity = [0.3, -0.2, 0.1]\n\
             environment.plane = {{ point = [0, 0, -9], normal = [0, 0, 1], stiffness = 100 }}\n{more}"
        ))
    };
    let energy: f64 = 0.5 * 0.2 * (0.09 + 0.04 + 0.01);
    let whole = |scene: &Scene| -> Balance { Explanation::of::<Space3>(scene).unwrap().whole_run };
    let damped = whole(&free(""));
    let burnt = energy * (1.0 - (-2.0 * 0.05 * 2.0 / 0.2_f64).exp());
    assert_relative_eq!(damped.device, burnt, max_relative = 1e-12);
    assert_relative_eq!(damped.gained, -burnt, max_relative = 1e-12);
    // Friction as large as a stop within 0.1 s takes: what the damper does not get is heat.
    let rubbed = whole(&free("effects.friction.coulomb = 1.0"));
    assert_relative_eq!(rubbed.gained, -energy, max_relative = 1e-12);
    assert!(rubbed.friction > 0.9 * energy);
}

#[test]
fn a_run_in_a_space_comes_to_rest_where_the_summary_says() {
    let plane =
        "environment.plane = { point = [0, 0], normal = [0.5, 1], stiffness = 3000, damping = 10 }";
    let disc =
        "environment.sphere = { center = [0, 0], radius = 0.02, stiffness = 3000, damping = 10 }";
    let rectangle = "environment.box = { center = [0, 0], half = [0.02, 0.03], stiffness = 3000, damping = 10 }";
    let start = |rest: &str, position: &str| {
        format!("space.dimensions = 2\noperator.rest = {rest}\ninitial.position = {position}\n")
    };
    for (from, environment, more) in [
        (start("[0.0, -0.01]", "[0.0, 0.03]"), plane, ""),
        (start("[0.0, 0.01]", "[0.0, 0.03]"), plane, ""),
        (start("[0.01, -0.02]", "[0.0, 0.03]"), plane, "effects.load.force = 0.7"),
        (start("[0.003, 0.01]", "[0.01, 0.04]"), disc, ""),
        // The same box from two sides: each face holds the hand.
        (start("[-0.01, 0.005]", "[-0.05, 0.0]"), rectangle, ""),
        (start("[-0.01, 0.005]", "[0.05, 0.0]"), rectangle, ""),
        (start("[-0.01, 0.005]", "[0.0, 0.05]"), rectangle, ""),
        // Half of the face's force gets through.
        (start("[-0.005, 0.0]", "[-0.05, 0.0]"), rectangle, "effects.saturation.force = 1.5"),
    ] {
        let scene = pressed(&format!("{from}{environment}\n{more}"));
        let rollout = Rollout::<Plane>::of(&scene).unwrap();
        let last = Rollout::<Plane>::of(&scene).unwrap().last().unwrap().truth.position;
        let summary = Summary::of(&scene, rollout);
        let told = summary.equilibrium.clone().unwrap_or_else(|| panic!("{from}{environment}"));
        assert_eq!(summary.verdict(), Verdict::Settles, "{from}{environment}{more}");
        assert_abs_diff_eq!(told[0], last.x, epsilon = 1e-6);
        assert_abs_diff_eq!(told[1], last.y, epsilon = 1e-6);
    }
    // A hand that lies a nanometre deep is pushed out of the ball, not through its middle.
    let grazing = pressed(&format!("{}{disc}", start("[0.019999999, 0.0]", "[0.03, 0.0]")));
    let told = Summary::new(&grazing).equilibrium.expect("a place on the surface");
    assert!((told[0] - 0.02).abs() < 1e-9 && told[1] == 0.0, "{told:?}");
    // However stiff a surface is, a hand behind it rests on it.
    for stiffness in ["1e8", "2e10", "1e13", "1e16"] {
        let stiff = |environment: &str| {
            let text = environment.replace("stiffness = 3000", &format!("stiffness = {stiffness}"));
            pressed(&format!("{}{text}", start("[-0.01, -0.005]", "[-0.05, 0.0]")))
        };
        let told = |environment: &str| Summary::new(&stiff(environment)).equilibrium;
        let on = told(rectangle).unwrap_or_else(|| panic!("{stiffness}"));
        let faces = [[-0.02, -0.005], [0.02, -0.005], [-0.01, 0.03], [-0.01, -0.03]];
        let near = |[x, y]: [f64; 2]| (on[0] - x).hypot(on[1] - y) < 1e-7;
        assert!(faces.into_iter().any(near), "{stiffness}: {on:?}");
        let on = told(disc).unwrap_or_else(|| panic!("{stiffness}"));
        assert!((on[0].hypot(on[1]) - 0.02).abs() < 1e-7, "{stiffness}: {on:?}");
        assert!(told(plane).is_some(), "{stiffness}");
    }
    // In the very middle of a ball no direction leads out.
    let middle = pressed(&format!("{}{disc}", start("[0.0, 0.0]", "[0.01, 0.04]")));
    assert_eq!(Summary::new(&middle).equilibrium, None);
}
