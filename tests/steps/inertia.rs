//! The limit of an inertia on two axes, against the kinetic energy of the mechanism itself.

use approx::assert_relative_eq;
use lyapunov::{
    Correction, DampingLimit, Popc, PortEnergy, PortSample, Stabilizer, laws,
    stabilizers::{InertiaLimit, JointInertia},
};
use nalgebra::{Matrix2, Vector2};

use crate::support::{Dice, PERIOD};

const CAP: f64 = 0.5;

fn unlimited() -> Popc<f64> {
    Popc::new(PortEnergy, DampingLimit::at(f64::INFINITY).expect("none"))
}

/// A mechanism of two joints, kg·m²: a sum of squares.
fn mechanism(dice: &mut Dice) -> Matrix2<f64> {
    let some = Matrix2::from_fn(|_, _| dice.within(0.4));
    some * some.transpose() + Matrix2::identity() * 0.01
}

fn told(inertia: Matrix2<f64>) -> JointInertia<f64, 2> {
    JointInertia::new(inertia).expect("an inertia")
}

/// Of what a correction is to take, whatever the debt, at least the share `1 − cap / 2` leaves the mechanism; where it is
/// limited it is the correction after which the most is lost, times the cap, and a force that is late by two ticks has
/// the smaller cap of the delay.
#[test]
fn a_correction_is_a_share_of_what_takes_most() {
    let mut dice = Dice::of(31);
    let start = InertiaLimit::new(unlimited(), told(mechanism(&mut dice)), CAP, PERIOD);
    let start = start.expect("a limit");
    let (mut cut, mut whole) = (0, 0);
    for (late, cap) in [(0, CAP), (2, CAP * (2.0 - 3f64.sqrt()))] {
        let mut member = start.delayed(late);
        for _ in 0..500 {
            let (inertia, velocity) = (mechanism(&mut dice), dice.signal::<Vector2<f64>>(1.0));
            member.tell(told(inertia));
            let debt = 10f64.powf(dice.within(3.0) - 2.0);
            let owes = PortSample {
                work: Vector2::new(-debt, 0.0),
                ..PortSample::starting(PERIOD, Vector2::zeros(), velocity)
            };
            let correction: Correction<Vector2<f64>> =
                member.clone().stabilize(&owes, Vector2::zeros());
            let given = correction.effort;
            let gained = -inertia.cholesky().expect("above 0").solve(&given) * PERIOD;
            let kinetic = |rates: Vector2<f64>| 0.5 * rates.dot(&(inertia * rates));
            let lost = kinetic(velocity) - kinetic(velocity + gained);
            let meant = given.dot(&velocity) * PERIOD;
            assert!(lost >= (1.0 - cap / 2.0) * meant * (1.0 - 1e-9), "{lost:e} of {meant:e}");
            assert_relative_eq!(meant + correction.shortfall, debt, max_relative = 1e-9);
            if correction.shortfall > 1e-9 * debt {
                // As large as takes most: c·v T = c·Λ⁻¹c T².
                let most = given.dot(&velocity) / -gained.dot(&given);
                assert_relative_eq!(most * cap, 1.0, max_relative = 1e-9);
                cut += 1;
            } else {
                whole += 1;
            }
        }
    }
    assert!(cut > 200 && whole > 200, "{cut} {whole}");
}

/// Adds a force along the motion.
#[derive(Clone, Debug)]
struct Pushes;

impl Stabilizer<Vector2<f64>> for Pushes {
    fn stabilize(
        &mut self,
        sample: &PortSample<Vector2<f64>>,
        effort: Vector2<f64>,
    ) -> Correction<Vector2<f64>> {
        Correction::none(effort - sample.velocity * 1e6)
    }
}

/// A correction that does not brake is no damping, and stays as it is.
#[test]
fn a_push_is_not_limited() {
    let inertia = told(Matrix2::new(0.5, 0.1, 0.1, 0.1));
    let mut member = InertiaLimit::new(Pushes, inertia, CAP, PERIOD).expect("a limit");
    let moving = PortSample::starting(PERIOD, Vector2::zeros(), Vector2::new(0.25, -0.5));
    let correction = member.stabilize(&moving, Vector2::new(1.0, 2.0));
    assert_eq!(correction.effort, Vector2::new(1.0 - 2.5e5, 2.0 + 5e5));
}

#[test]
fn its_memory_is_that_of_what_it_limits() {
    let inertia = told(Matrix2::new(0.5, 0.1, 0.1, 0.1));
    let member = InertiaLimit::new(unlimited(), inertia, CAP, PERIOD).expect("a limit");
    let samples = || laws::Samples::<Vector2<f64>>::new(PERIOD).seeded(3).take(300);
    laws::snapshot(&member, samples()).expect("the law");
    laws::stabilizer(&member, samples()).expect("the laws");
}
