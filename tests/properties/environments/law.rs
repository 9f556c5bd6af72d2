//! Force and credit, against the laws in straight `f64`.

use approx::assert_abs_diff_eq;
use nalgebra::Vector2;
use proptest::array::{uniform2, uniform16};
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::{
    Dissipation, HeldTick, LyapunovCandidate, OnePort, PortSample,
    bodies::Impedance,
    effects::OnePortExt,
    environments::{Contact, HuntCrossley, MassSpringDamper, MovingWall, Sphere, Spring, Wall},
};

use super::models::{Environment, Example2, Hunt, Layered, Moving, Parts, Plain, Sample, Varying};
use crate::support::{Bits, CASES, Real, Spy, hold, same};

fn follows<E: Environment, T: Real>() {
    let samples = vec(uniform2(any::<Bits>()), 1..24);
    hold(CASES, (uniform16(any::<Bits>()), samples), |(bits, samples)| {
        let parts = Parts::<T>::of(&bits, 0);
        let (mut port, mut term) = E::build(parts);
        let mut before = None;
        for (call, reading) in samples.into_iter().enumerate() {
            let sample = parts.sample(reading, 0);
            let v = sample.velocity.f64();
            let law = E::law(
                &parts.widened(),
                Sample {
                    call: call as u32,
                    x: sample.position.f64(),
                    v,
                    before: before.unwrap_or(v),
                    period: sample.period.f64(),
                },
            );
            before = Some(v);
            let (force, credit) = (port.respond(&sample).f64(), term.decrease(&sample).f64());
            let [depth, made_of] = law.depth;
            if depth.abs() <= 8.0 * T::unit() * made_of {
                continue;
            }
            let near = |found: f64, [exact, size]: [f64; 2]| {
                (found - exact).abs() <= 16.0 * T::unit() * size
            };
            prop_assert!(near(force, law.force), "{force:e} for {law:?} at {call}");
            prop_assert!(near(credit, law.credit), "credit {credit:e} for {law:?} at {call}");
        }
        Ok(())
    });
}

mod check {
    use super::*;

    pub(super) fn wall<T: Real>() {
        follows::<Plain, T>();
    }

    pub(super) fn layered_wall<T: Real>() {
        follows::<Layered, T>();
    }

    pub(super) fn hunt_crossley<T: Real>() {
        follows::<Hunt, T>();
    }

    pub(super) fn moving_wall<T: Real>() {
        follows::<Moving, T>();
    }

    pub(super) fn varying_spring<T: Real>() {
        follows::<Varying, T>();
    }

    pub(super) fn mass_spring_damper<T: Real>() {
        follows::<Example2<false>, T>();
    }

    pub(super) fn active_mass_spring_damper<T: Real>() {
        follows::<Example2<true>, T>();
    }
}

crate::support::every_real!(
    wall,
    layered_wall,
    hunt_crossley,
    moving_wall,
    varying_spring,
    mass_spring_damper,
    active_mass_spring_damper,
);

/// Behind a hold of three ticks the acceleration is over three periods: velocities 0, 1, …, 6 m/s at 0.5 s give 2 m/s².
#[test]
fn acceleration_behind_a_hold_is_over_the_whole_hold() {
    let impedance = Impedance { mass: 7.0, damping: 0.0, stiffness: 0.0 };
    let mut spy = Spy::on(MassSpringDamper::<f64>::new(impedance).expect("a mass"));
    let mut held = (&mut spy).held(3).expect("a hold");
    let drives = (0..7).map(|n| {
        HeldTick {
            period: 0.5,
            position: 0.0,
            velocity: f64::from(n),
            displacement: 0.5 * f64::from(n),
            applied: 0.0,
        }
        .sample()
    });
    let forces: Vec<f64> = drives.map(|sample| held.respond(&sample)).collect();
    assert_eq!(forces, [0.0, 0.0, 0.0, 14.0, 14.0, 14.0, 14.0]);
}

/// The mass-spring-damper on several axes is one on each, and its credit is the sum of theirs.
#[test]
fn mass_spring_damper_on_several_axes() {
    use nalgebra::Vector3;
    let impedance = Impedance { mass: 0.5, damping: 3.0, stiffness: 20.0 };
    let mut whole = MassSpringDamper::<Vector3<f64>>::new(impedance).expect("three axes");
    let mut axes = [MassSpringDamper::<f64>::new(impedance).expect("one"); 3];
    let mut credit = whole.dissipation();
    for n in 0..20 {
        let at = Vector3::new(0.1, 0.2, -0.3) * f64::from(n);
        let velocity = at.map(|x| (3.0 * x).sin());
        let sample = HeldTick {
            period: 1e-3,
            position: at,
            velocity,
            displacement: Vector3::zeros(),
            applied: Vector3::zeros(),
        }
        .sample();
        let effort = whole.respond(&sample);
        for (axis, port) in axes.iter_mut().enumerate() {
            let alone = HeldTick {
                period: 1e-3,
                position: at[axis],
                velocity: velocity[axis],
                displacement: 0.0,
                applied: 0.0,
            }
            .sample();
            assert!(same(effort[axis], port.respond(&alone)));
        }
        let burnt: f64 = velocity.iter().map(|v| 3.0 * v * v * 1e-3).sum();
        assert_abs_diff_eq!(credit.decrease(&sample), burnt, epsilon = 1e-15 * burnt);
    }
}

/// `p = 0` is no contact, the least depth above it is.
#[test]
fn contact_begins_strictly_beyond_the_surface() {
    let contact = HuntCrossley::new(1e12, 0.5, 1.0).expect("a contact").at(0.25);
    let beyond = f64::from_bits(0.25f64.to_bits() + 1);
    for (x, touching) in [(0.25, false), (beyond, true), (0.2, false)] {
        let sample = PortSample::starting(1e-3, x, 1.0);
        assert_eq!({ contact }.respond(&sample) > 0.0, touching);
        assert_eq!(contact.dissipation().decrease(&sample) > 0.0, touching);
    }
}

/// A spring that pushes away, and one of several axes.
#[test]
fn a_spring_may_push_away() {
    let mut spring = Spring::new(-50.0).expect("a spring").at(0.5);
    assert_eq!(spring.respond(&PortSample::starting(1e-3, 0.75, 3.0)), -12.5);
    assert!(Spring::<f64>::new(f64::NAN).is_err());
}

/// A negative damping gives energy and dissipates none.
#[test]
fn a_negative_damping_credits_nothing() {
    let impedance = Impedance { mass: 0.0, damping: -2.0, stiffness: 0.0 };
    let port = MassSpringDamper::<f64>::new(impedance).expect("an active one");
    assert_eq!(port.dissipation(), Dissipation::of(0.0).expect("none"));
    assert_eq!({ port }.respond(&PortSample::starting(1e-3, 0.0, 3.0)), -6.0);
}

/// A NaN credit would erase a debt.
#[test]
fn a_velocity_that_is_not_finite_credits_nothing() {
    let wall = Wall::new(100.0, 2.0).expect("a wall");
    let moving = MovingWall::new(wall, 0.01, 1.0, 1e3).expect("a moving wall");
    let hunt = HuntCrossley::new(100.0, 1.5, 2.0).expect("a contact");
    let ball = Contact::with(Sphere::new(Vector2::zeros(), 0.5).expect("a ball"), 100.0, 2.0)
        .expect("a contact");
    let credits = |velocity| {
        let sample = PortSample::starting(1e-3, 0.25, velocity);
        let plane =
            PortSample::starting(1e-3, Vector2::new(0.25, 0.0), Vector2::new(velocity, 0.0));
        [
            wall.dissipation().decrease(&sample),
            moving.dissipation(1e3).expect("a rate").decrease(&sample),
            hunt.dissipation().decrease(&sample),
            ball.dissipation().decrease(&plane),
        ]
    };
    for velocity in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e200] {
        assert_eq!(credits(velocity), [0.0; 4], "{velocity}");
    }
    assert!(credits(1.0).iter().all(|&credit| credit > 0.0));
}
