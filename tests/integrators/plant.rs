//! Plant moved by an integrator.

use lyapunov::{
    Plant, Requirement, Signal,
    bodies::{
        DampedMass, ElasticJoint, FromParts, Impedance, IntegratedPlant, OperatedBody, TwoMassParts,
    },
    integrators::{
        Coordinates, CoupledOscillators, ImplicitMidpoint, Oscillator, RungeKuttaNystrom4,
        TwoMassCoordinates,
    },
};

use crate::{hand, moved, pair};

#[test]
fn invalid_parameters_are_refused_by_name() {
    let refused = |mass, damping, stiffness| {
        let error = Oscillator::new(Impedance { mass, damping, stiffness }).expect_err("no parts");
        (error.parameter, error.requirement)
    };
    assert_eq!(refused(0.0_f32, 0.0, 0.0), ("mass", Requirement::Positive));
    assert_eq!(refused(1.0, -1.0, 0.0), ("damping", Requirement::NonNegative));
    assert_eq!(refused(1.0, 0.0, f32::NAN), ("stiffness", Requirement::NonNegative));
    assert_eq!(refused(1e-38, 0.0, 50.0), ("mass", Requirement::InRange));
    let no_link = TwoMassParts { link: ElasticJoint { stiffness: 0.0, damping: 0.0 }, ..pair() };
    let error = CoupledOscillators::new(pair::<f64>())
        .expect("parts")
        .made_of(no_link)
        .expect_err("no link");
    assert_eq!((error.parameter, error.requirement), ("link stiffness", Requirement::Positive));

    let dynamics = Oscillator::new(hand::<f32>()).expect("parts");
    let stepped = |period, steps| {
        IntegratedPlant::<f32, _, _>::new(dynamics, RungeKuttaNystrom4, period, steps)
    };
    let refused = |period: f32, steps| {
        let error = stepped(period, steps).expect_err("no plant");
        (error.parameter, error.requirement)
    };
    assert_eq!(refused(1e-3, 0), ("steps", Requirement::AtLeast(1.0)));
    assert_eq!(refused(0.0, 1), ("period", Requirement::Positive));
    assert_eq!(refused(f32::INFINITY, 1), ("period", Requirement::Positive));
    // A single step of that length is out of range; steps of ten microseconds are not, however many.
    assert_eq!(refused(1e30, 1), ("period", Requirement::InRange));
    assert!(stepped(1e30, u32::MAX).is_err());
    assert!(stepped(1e3, 100_000_000).is_ok());
}

#[test]
fn a_plant_that_is_reshaped_stays_where_it_is_and_over_no_time_does_not_move() {
    let dynamics = CoupledOscillators::new(pair::<f64>()).expect("parts");
    let mut plant = moved(dynamics, ImplicitMidpoint, 1e-3, 2).starting(-0.004, 0.1);
    plant.advance(1.0);
    let before = plant.state();
    assert!(before.position.stretch != 0.0);
    plant.reshape(pair(), 0.0).expect("no time");
    let sample = plant.advance(1.0);
    assert_eq!((plant.state(), sample.displacement, sample.period), (before, 0.0, 0.0));
    plant.reshape(pair(), -1.0).expect_err("no such time");
    let none = TwoMassParts { device: DampedMass { mass: 0.0, damping: 0.0 }, ..pair() };
    plant.reshape(none, 1e-3).expect_err("no mass");
    assert_eq!(plant.advance(1.0).period, 0.0);
    plant.reshape(pair(), 1e-3).expect("as it was");
    assert!(plant.advance(1.0).displacement != 0.0);
}

#[test]
fn the_coordinates_of_two_masses_are_a_signal() {
    let at = |device: f64, stretch: f64| TwoMassCoordinates { device, stretch };
    let (a, b) = (at(1.0, 2.0), at(3.0, 5.0));
    assert_eq!((a + b, b - a), (at(4.0, 7.0), at(2.0, 3.0)));
    assert_eq!((a.times(b), a.inner(b), a.sum()), (at(3.0, 10.0), 13.0, 3.0));
    assert_eq!(TwoMassCoordinates::choose(true, a, b), a);
    assert_eq!((TwoMassCoordinates::all_at(2.0), b.at_port()), (at(2.0, 0.0), 3.0));
    assert!(!at(0.0, f64::NAN).finite() && !at(f64::INFINITY, 0.0).finite() && a.finite());
}

/// A body that coasts in `f32`, a decimetre from the origin: each of a thousand short steps is far below what a position of that
/// size can tell.
#[test]
fn many_short_steps_lose_no_motion() {
    let free = Impedance { mass: 0.3, damping: 0.0, stiffness: 0.0 };
    let dynamics = Oscillator::<f32>::new(free).expect("parts");
    for steps in [1, 100, 1000] {
        let plant = IntegratedPlant::<f32, _, _>::new(dynamics, RungeKuttaNystrom4, 1e-3, steps);
        let mut plant = plant.expect("a plant").starting(-0.1, 5e-3);
        for _ in 0..1000 {
            plant.advance(0.0);
        }
        let coasted = f64::from(plant.state().position) + f64::from(0.1_f32);
        assert!((coasted / 5e-3 - 1.0).abs() < 1e-3, "{steps} steps: {coasted} m");
    }
}
