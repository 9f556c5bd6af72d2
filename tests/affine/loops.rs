//! Loops that fail without a stabilizer and hold with one, from many starts, in `f64` and `f32`.

use lyapunov::{
    Correction, DampingLimit, Lolc, OnePort, Plant, Scalar,
    effects::OnePortExt,
    integrators::RungeKutta4,
    models::{
        AffinePlant, ArmEnergy, ControlAffine, Decay, LegEnergy, LyapunovFunction, MotorEnergy,
        QuadraticForm, StateFeedback, UprightEnergy, VanDerPol, WithState, decrease_of,
    },
};
use nalgebra::SVector;

use crate::{Draw, arm, device, leg, motor, pendulum};

/// V over a run as a share of its start: the largest, and that at the end.
struct Run {
    largest: f64,
    last: f64,
}

/// A loop of a model under test.
struct Loop<P, F> {
    plant: P,
    function: F,
    /// Apparent mass of the port.
    mass: f64,
    /// Rate of the decay, 1/s.
    decay: f64,
    period: f64,
    ticks: u32,
}

impl<P, F> Loop<P, F> {
    fn run<T, Q, const N: usize, const M: usize>(
        &self,
        port: Q,
        start: SVector<T, N>,
        cap: f64,
    ) -> Run
    where
        T: Scalar,
        P: ControlAffine<T, N, M> + Copy,
        F: LyapunovFunction<SVector<T, N>> + Copy,
        Q: OnePort<WithState<T, N, M>>,
    {
        let of = T::of;
        let function = self.function;
        let mut plant = AffinePlant::new(self.plant, function, RungeKutta4, of(self.period), 2)
            .expect("a plant")
            .starting(start);
        let limit =
            DampingLimit::of_mass(of(cap), of(self.mass), of(self.period)).expect("a limit");
        let decay = Decay::new(function, of(self.decay)).expect("a rate");
        let mut port = port.stabilized(Lolc::new((decrease_of(function, start), decay), limit));
        let began = plant.value().lane(0);
        let (mut sample, mut run) = (plant.start(), Run { largest: 1.0, last: 1.0 });
        for _ in 0..self.ticks {
            sample = plant.advance(port.respond(&sample));
            run.last = plant.value().lane(0) / began;
            if !run.last.is_finite() || run.last > 1e12 {
                return Run { largest: f64::INFINITY, last: f64::INFINITY };
            }
            run.largest = run.largest.max(run.last);
            let Correction { alpha, .. } = port.correction();
            assert!(alpha.lane(0) <= limit.most().lane(0));
        }
        run
    }
}

/// A dozen starts, of all directions.
fn starts<T: Scalar, const N: usize>(size: f64) -> impl Iterator<Item = SVector<T, N>> {
    let mut draw = Draw(11);
    (0..12).map(move |_| draw.vector(size))
}

/// V may exceed its start by what one tick adds before the observer sees it.
const SLACK: f64 = 1.05;

fn van_der_pol<T: Scalar>() {
    let circle = QuadraticForm::sum_of_squares();
    let plant = VanDerPol::new(T::of(1.0)).expect("a parameter");
    let bounded =
        Loop { plant, function: circle, mass: 1.0, decay: 0.0, period: 0.01, ticks: 4000 };
    let nothing = || StateFeedback::new(|_: SVector<T, 2>| SVector::<T, 1>::from([T::of(0.0)]));
    for start in starts(0.5) {
        let without = bounded.run(nothing(), start, 0.0);
        assert!(without.largest > 8.0, "to the limit cycle: {}", without.largest);
        let with = bounded.run(nothing(), start, 0.5);
        assert!(with.largest < SLACK, "{}", with.largest);
        let decaying = Loop { decay: 0.5, ..bounded };
        let with = decaying.run(nothing(), start, 0.5);
        assert!(with.largest < SLACK && with.last < 0.3, "towards rest: {}", with.last);
    }
}

fn upright<T: Scalar>() {
    let of = T::of;
    let function = UprightEnergy::new(pendulum::<T>(), of(6.0)).expect("an energy");
    let mass = pendulum::<f64>().inertia();
    let held =
        Loop { plant: pendulum::<T>(), function, mass, decay: 4.0, period: 1e-3, ticks: 8000 };
    let law = |x: SVector<T, 2>| SVector::<T, 1>::from([x[0] * of(-6.0) - x[1] * of(0.4)]);
    let late = || StateFeedback::new(law).delayed::<120>(120).expect("a delay");
    for start in starts(0.2) {
        assert!(held.run(late(), start, 0.0).largest > 100.0, "falls");
        let with = held.run(late(), start, 0.5);
        assert!(with.largest < SLACK && with.last < 0.3, "{} {}", with.largest, with.last);
        let on_time = held.run(StateFeedback::new(law), start, 0.0);
        assert!(on_time.largest < 1.001, "the controller itself is right");
    }
}

fn admittance<T: Scalar>() {
    let of = T::of;
    let function = device::<T>().energy(of(0.2)).expect("an energy");
    let mass = device::<f64>().compliance();
    let rendered =
        Loop { plant: device::<T>(), function, mass, decay: 4.0, period: 1e-3, ticks: 2000 };
    let law = |x: SVector<T, 2>| SVector::<T, 1>::from([x[1] / of(0.2)]);
    let late = || StateFeedback::new(law).delayed::<2>(2).expect("a delay");
    for start in starts(5e-3) {
        assert!(rendered.run(late(), start, 0.0).largest > 100.0, "swings up");
        let with = rendered.run(late(), start, 0.5);
        assert!(with.largest < SLACK && with.last < 0.1, "{} {}", with.largest, with.last);
    }
}

fn position_loop<T: Scalar>() {
    let of = T::of;
    let function = MotorEnergy::new(motor::<T>(), of(0.05), of(0.004)).expect("a function");
    let turned =
        Loop { plant: motor::<T>(), function, mass: 0.02, decay: 10.0, period: 1e-3, ticks: 1500 };
    let gain = of(3.0 * motor::<f64>().critical_gain());
    let law = |x: SVector<T, 3>| SVector::<T, 1>::from([T::of(0.0) - gain * x[0]]);
    for start in starts(1.0) {
        let without = turned.run(StateFeedback::new(law), start, 0.0);
        assert!(without.largest > 100.0, "runs away");
        let with = turned.run(StateFeedback::new(law), start, 0.5);
        // At this gain the voltage lifts V by a sixth within the first ticks, before the current can follow.
        assert!(with.largest < 1.25 && with.last < 0.05, "{} {}", with.largest, with.last);
    }
}

fn arm_on_springs<T: Scalar>() {
    let of = T::of;
    let function = ArmEnergy::new(arm::<T>(), [of(40.0), of(10.0)]).expect("an energy");
    let mass = arm::<f64>().least_inertia();
    let held = Loop { plant: arm::<T>(), function, mass, decay: 1.0, period: 1e-3, ticks: 6000 };
    let law = |x: SVector<T, 4>| SVector::<T, 2>::from([x[0] * of(-40.0), x[1] * of(-10.0)]);
    let slow = || StateFeedback::new(law).held(20).expect("a hold");
    for start in starts(0.4) {
        assert!(held.run(slow(), start, 0.0).largest > 10.0, "gains energy");
        let with = held.run(slow(), start, 0.5);
        assert!(with.largest < SLACK && with.last < 0.1, "{} {}", with.largest, with.last);
    }
}

fn leg_on_its_stand<T: Scalar>() {
    let of = T::of;
    let function = LegEnergy::new(leg::<T>(), [of(300.0), of(150.0)]).expect("an energy");
    let mass = leg::<f64>().least_inertia();
    let put = Loop { plant: leg::<T>(), function, mass, decay: 2.0, period: 1e-3, ticks: 3000 };
    let holding = leg::<T>().holding();
    let law = |x: SVector<T, 4>| {
        let hip = x[0] * of(-300.0) - x[2] * of(4.0);
        holding + SVector::<T, 2>::from([hip, x[1] * of(-150.0) - x[3] * of(2.0)])
    };
    // Lifted, so the foot comes down.
    let lifted = |start: SVector<T, 4>| start + SVector::from([0.3, -0.4, 0.0, 0.0].map(of));
    let late = || StateFeedback::new(law).delayed::<20>(20).expect("a delay");
    for start in starts(0.1).map(lifted) {
        assert!(put.run(late(), start, 0.0).largest > 10.0, "kicks");
        let with = put.run(late(), start, 0.5);
        assert!(with.largest < SLACK && with.last < 0.1, "{} {}", with.largest, with.last);
    }
}

macro_rules! each {
    ($($name:ident),+) => {$(
        mod $name {
            #[test]
            fn f64() {
                super::$name::<f64>();
            }

            #[test]
            fn f32() {
                super::$name::<f32>();
            }
        }
    )+};
}

each!(van_der_pol, upright, admittance, position_loop, arm_on_springs, leg_on_its_stand);
