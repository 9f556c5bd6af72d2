//! Scale of the feedback: what a change of it does is work, and it is booked.

use lyapunov::{
    DampingLimit, HeldTick, OnePort, Popc, PortEnergy, PortSample, Stabilizer,
    effects::OnePortExt,
    environments::{ForceLaw, Kinematics, OrientationSpring, Spring, Wall},
    laws,
    poses::{Pose, Screw, WithPose},
};
use nalgebra::{Isometry3, Vector3};

/// Pressed into a spring at one scale and let out at another, in steps so small that the hold does not show: the port's
/// energy is the difference of what was stored, in closed form.
#[test]
fn a_change_of_scale_is_work() {
    const STEPS: u32 = 100_000;
    let (deep, stiffness) = (0.01, 2000.0);
    for (pressed, released) in [(1.0, 2.0), (1.0, 0.25), (0.5, 0.5), (0.0, 1.0)] {
        let mut port = Spring::<f64>::new(stiffness).expect("a spring").scaled(pressed).expect("1");
        let mut popc = Popc::new(PortEnergy, DampingLimit::at(0.0).expect("an observer"));
        let step = deep / f64::from(STEPS);
        let (mut position, mut applied, mut sum) = (0.0, 0.0, 0.0);
        for tick in 0..2 * STEPS {
            if tick == STEPS {
                let motion = Kinematics::at(position, 0.0);
                let before = port.stored(&motion);
                port.set_scale(released).expect("a scale");
                let work = port.stored(&motion) - before;
                let stored = 0.5 * stiffness * deep * deep;
                assert!((work - (released - pressed) * stored).abs() < 1e-9);
                // The spring answers at its new scale before it moves.
                applied = port.respond(&PortSample::starting(1e-3, position, 0.0));
            }
            let moved = if tick < STEPS { step } else { -step };
            position += moved;
            let sample = HeldTick {
                period: 1e-3,
                position,
                velocity: moved / 1e-3,
                displacement: moved,
                applied,
            }
            .sample();
            let correction = popc.stabilize(&sample, port.respond(&sample));
            (sum, applied) = (correction.observed_energy, correction.effort);
        }
        let expected = (pressed - released) * 0.5 * stiffness * deep * deep;
        let held = stiffness * (pressed + released) * deep * step;
        assert!((sum - expected).abs() <= held, "{sum} for {expected}");
    }
}

/// A stabilizer outside of the scale takes back what the change gave.
#[test]
fn what_a_change_gives_is_taken_back() {
    let mass = 0.2;
    let run = |cap: f64| {
        let limit = DampingLimit::of_mass(cap, mass, 1e-3).expect("a limit");
        let mut popc = Popc::new(PortEnergy, limit);
        let mut port = Wall::new(500.0, 0.0).expect("a wall").scaled(1.0).expect("a scale");
        let (mut position, mut velocity, mut applied, mut late) = (-0.01, 0.3, 0.0, 0.0f64);
        let mut deepest = 0.0f64;
        let start = 0.5 * mass * velocity * velocity;
        for tick in 0..400 {
            let before = position;
            for _ in 0..50 {
                velocity -= applied / mass * 2e-5;
                position += velocity * 2e-5;
            }
            let moved = position - before;
            let sample = HeldTick {
                period: 1e-3,
                position,
                velocity: moved / 1e-3,
                displacement: moved,
                applied,
            }
            .sample();
            // A knob is turned up on the way out.
            if position > 0.0 && position < deepest {
                port.set_scale(3.0).expect("a scale");
            }
            deepest = deepest.max(position);
            applied = popc.stabilize(&sample, port.respond(&sample)).effort;
            if tick > 300 {
                late = late.max(0.5 * mass * velocity * velocity / start);
            }
        }
        late
    };
    let (without, with) = (run(0.0), run(0.5));
    assert!(without > 2.0 && with < 1.05, "{without} {with}");
}

/// 1 changes no bit; it scales a wrench as it scales a force.
#[test]
fn one_changes_nothing() {
    let wall = Wall::new(1e3, 2.0).expect("a wall");
    let mut scaled = wall.scaled(1.0).expect("a scale");
    for (sample, _) in laws::Samples::<f64>::new(1e-3) {
        assert_eq!(scaled.respond(&sample).to_bits(), { wall }.respond(&sample).to_bits());
    }
    let spring = OrientationSpring::new(2.0, 0.0).expect("a spring");
    let turned = Pose::from(Isometry3::rotation(Vector3::z() * 0.5));
    let sample = PortSample::starting(1e-3, WithPose::<f64>::at(turned), WithPose::default());
    let mut scaled = OnePortExt::<WithPose<f64>>::scaled(spring, 0.5).expect("a scale");
    let wrench: Screw<f64> = scaled.respond(&sample).screw;
    assert!((wrench.rotation.z - 0.5).abs() < 1e-15);
    laws::one_port(&wall.scaled(0.3).expect("a scale"), laws::Samples::new(1e-3)).expect("laws");
}

#[test]
fn what_is_no_scale_is_refused_and_changes_nothing() {
    let mut port = Spring::<f64>::new(100.0).expect("a spring").scaled(2.0).expect("a scale");
    for bad in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(Spring::<f64>::new(1.0).expect("a spring").scaled(bad).is_err());
        let refused = port.set_scale(bad).expect_err("refused").to_string();
        assert!(refused.starts_with("feedback scale is"), "{refused}");
    }
    assert_eq!(port.respond(&PortSample::starting(1e-3, 0.01, 0.0)), 2.0);
}
