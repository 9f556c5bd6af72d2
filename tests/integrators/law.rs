//! Laws of an integrator: kept, and broken.

use lyapunov::lanes::{AutoF64x4, WideF64x4};
use lyapunov::laws::{self, Law, Samples};
use lyapunov::{
    Scalar, Signal,
    accumulators::DoubleDouble,
    bodies::Impedance,
    integrators::{
        CoupledOscillators, Exact, ImplicitMidpoint, Integrator, Mechanics, Oscillator,
        RungeKutta4, RungeKuttaNystrom4, SemiImplicitEuler, State,
    },
};
use nalgebra::SVector;

use crate::{hand, moved, pair};

fn keeps_the_laws<V, D, I>(integrator: I, dynamics: D, order: u32)
where
    V: Signal,
    D: Mechanics<V>,
    I: Integrator<V, D> + Clone,
{
    let samples = Samples::<D::Coordinates>::new(V::Scalar::of(1e-3)).step_by(40);
    let efforts = Samples::<V>::new(V::Scalar::of(1e-3)).seeded(2);
    let starts = samples.zip(efforts).map(|((sample, _), (_, effort))| {
        (State { position: sample.position, velocity: sample.velocity }, effort)
    });
    // The hand turns about one radian in 0.1 s, the link twice that.
    laws::integrator(&integrator, &dynamics, starts, V::Scalar::of(0.06), order).expect("the laws");
}

fn all_keep_the_laws<V: Signal>() {
    let one = || Oscillator::new(hand()).expect("parts");
    let two = || CoupledOscillators::new(pair()).expect("parts");
    keeps_the_laws::<V, _, _>(SemiImplicitEuler, one(), 1);
    keeps_the_laws::<V, _, _>(SemiImplicitEuler, two(), 1);
    keeps_the_laws::<V, _, _>(ImplicitMidpoint, one(), 2);
    keeps_the_laws::<V, _, _>(ImplicitMidpoint, two(), 2);
    keeps_the_laws::<V, _, _>(RungeKuttaNystrom4, one(), 4);
    keeps_the_laws::<V, _, _>(RungeKuttaNystrom4, two(), 4);
    keeps_the_laws::<V, _, _>(RungeKutta4, one(), 4);
    keeps_the_laws::<V, _, _>(RungeKutta4, two(), 4);
    keeps_the_laws::<V, _, _>(Exact::new(), one(), 100);
    keeps_the_laws::<V, _, _>(Exact::new(), two(), 100);
    let period = V::Scalar::of(1e-3);
    let samples = Samples::<V>::new(period);
    laws::plant(&moved::<V, _, _>(one(), ImplicitMidpoint, period, 4), samples).expect("one mass");
    laws::plant(&moved::<V, _, _>(two(), RungeKuttaNystrom4, period, 4), samples)
        .expect("two masses");
}

#[test]
fn the_integrators_that_ship_keep_the_laws() {
    all_keep_the_laws::<f64>();
    all_keep_the_laws::<f32>();
    all_keep_the_laws::<SVector<f64, 3>>();
    all_keep_the_laws::<WideF64x4>();
    all_keep_the_laws::<SVector<AutoF64x4, 2>>();
}

/// Integrators that break one law each.
#[derive(Clone, Copy, Debug)]
enum Broken {
    /// Explicit Euler, whose order is 1.
    OfOrderOne,
    /// RK4 of the motion without its damping.
    Undamped,
    /// RK4 that drifts by itself.
    Drifting,
    /// RK4 whose lanes follow the first.
    Following,
    /// RK4 that fails at speed.
    Overflowing,
}

impl<T: Scalar> Integrator<T, Oscillator<T>> for Broken {
    fn step(
        &mut self,
        dynamics: &Oscillator<T>,
        from: State<T>,
        effort: T,
        interval: T,
    ) -> State<T> {
        let gain = RungeKuttaNystrom4.step(dynamics, from, effort, interval);
        let drift = T::of(1e-12);
        match self {
            Self::OfOrderOne => State {
                position: from.velocity * interval,
                velocity: dynamics.acceleration(from.position, from.velocity, effort) * interval,
            },
            Self::Undamped => {
                let parts = Impedance { damping: T::of(0.0), ..hand() };
                let dynamics = Oscillator::new(parts).expect("parts");
                RungeKuttaNystrom4.step(&dynamics, from, effort, interval)
            }
            Self::Drifting => State { position: gain.position + drift, ..gain },
            Self::Following => State { velocity: T::of(gain.velocity.lane(0)), ..gain },
            Self::Overflowing => State { velocity: gain.velocity / T::of(0.0), ..gain },
        }
    }
}

#[test]
fn a_broken_law_of_an_integrator_is_named() {
    let broken = |integrator: Broken, order: u32| {
        let dynamics = Oscillator::<AutoF64x4>::new(hand()).expect("parts");
        let place = AutoF64x4::from_lanes(|lane| 0.01 * lane as f64 - 0.004);
        let start = (State { position: place, velocity: place * AutoF64x4::of(5.0) }, place);
        let violation =
            laws::integrator(&integrator, &dynamics, [start], AutoF64x4::of(0.06), order);
        violation.err().map(|violation| violation.law)
    };
    assert_eq!(broken(Broken::OfOrderOne, 1), None);
    assert_eq!(broken(Broken::OfOrderOne, 2), Some(Law::Converges));
    assert_eq!(broken(Broken::Undamped, 1), Some(Law::Converges));
    assert_eq!(broken(Broken::Drifting, 4), Some(Law::NothingForNothing));
    assert_eq!(broken(Broken::Following, 4), Some(Law::LaneByLane));
    assert_eq!(broken(Broken::Overflowing, 4), Some(Law::Finite));
}

/// Lanes are told apart with all their digits.
#[test]
fn thirty_digits_keep_the_laws() {
    let of = DoubleDouble::of;
    let parts = Impedance { mass: of(0.3), damping: of(0.4), stiffness: of(60.0) };
    let dynamics = Oscillator::new(parts).expect("parts");
    let third = |k: i32| DoubleDouble::of(f64::from(k)) / DoubleDouble::of(3.0);
    let starts = (1..20).map(|k| (State { position: third(k), velocity: third(-k) }, third(k)));
    laws::integrator(&RungeKutta4, &dynamics, starts, DoubleDouble::of(0.06), 4).expect("the laws");
}
