//! Lanes of models, port, observer and stabilizer: each equals its scalar run, bit for bit.

use lyapunov::lanes::{AutoF32x8, AutoF64x4, WideF64x4};
use lyapunov::{
    DampingLimit, Lolc, OnePort, Plant, Scalar,
    effects::OnePortExt,
    integrators::RungeKutta4,
    models::{
        AffinePlant, ArmEnergy, ControlAffine, Decay, LegEnergy, LyapunovFunction, MotorEnergy,
        QuadraticForm, StateFeedback, UprightEnergy, VanDerPol, decrease_of,
    },
};
use nalgebra::SVector;

use crate::{arm, device, leg, motor, pendulum};

/// Every state, flattened, of a stabilized loop under a late controller, with a start for each lane.
fn path<T, P, F, const N: usize, const M: usize>(
    plant: P,
    function: F,
    gain: f64,
    lane: &dyn Fn(usize) -> usize,
) -> Vec<T>
where
    T: Scalar,
    P: ControlAffine<T, N, M>,
    F: LyapunovFunction<SVector<T, N>> + Copy,
{
    let of = T::of;
    let place = |axis: usize, lane: usize| 0.1 + 0.03 * axis as f64 - 0.05 * lane as f64;
    let start: SVector<T, N> =
        SVector::from_fn(|axis, _| T::from_lanes(|index| place(axis, lane(index))));
    let mut plant = AffinePlant::new(plant, function, RungeKutta4, of(1e-3), 2)
        .expect("a plant")
        .starting(start);
    let decay = Decay::new(function, of(1.0)).expect("a rate");
    let limit = DampingLimit::of_mass(of(0.5), of(1e-2), of(1e-3)).expect("a limit");
    let law = move |x: SVector<T, N>| SVector::from_fn(|input, _| x[input] * of(-gain));
    let mut port = StateFeedback::new(law)
        .delayed::<4>(4)
        .expect("a delay")
        .stabilized(Lolc::new((decrease_of(function, start), decay), limit));
    let (mut sample, mut path) = (plant.start(), Vec::new());
    for _ in 0..400 {
        sample = plant.advance(port.respond(&sample));
        path.extend(plant.state().iter().copied());
        path.push(port.correction().alpha);
    }
    path
}

fn paths<T: Scalar>(lane: impl Fn(usize) -> usize) -> [Vec<T>; 6] {
    let of = T::of;
    let circle = QuadraticForm::sum_of_squares();
    let upright = UprightEnergy::new(pendulum::<T>(), of(6.0)).expect("an energy");
    let current = MotorEnergy::new(motor::<T>(), of(0.05), of(0.004)).expect("a function");
    let springs = ArmEnergy::new(arm::<T>(), [of(40.0), of(10.0)]).expect("an energy");
    let standing = LegEnergy::new(leg::<T>(), [of(150.0), of(80.0)]).expect("an energy");
    let rendered = device::<T>().energy(of(0.2)).expect("an energy");
    [
        path(VanDerPol::new(of(1.0)).expect("a parameter"), circle, 1.0, &lane),
        path(pendulum::<T>(), upright, 6.0, &lane),
        path(motor::<T>(), current, 10.0, &lane),
        path(arm::<T>(), springs, 40.0, &lane),
        path(leg::<T>(), standing, 150.0, &lane),
        path(device::<T>(), rendered, 2.0, &lane),
    ]
}

fn each_lane_is_its_scalar<T: Scalar, L: Scalar>() {
    let many = paths::<L>(|lane| lane);
    for lane in 0..L::LANES {
        for (model, (alone, many)) in paths::<T>(|_| lane).iter().zip(&many).enumerate() {
            assert_eq!(alone.len(), many.len());
            assert!(many.iter().any(|number| number.lane(lane) != 0.0));
            for (index, (one, number)) in alone.iter().zip(many).enumerate() {
                let (one, number) = (one.lane(0), number.lane(lane));
                assert_eq!(
                    one.to_bits(),
                    number.to_bits(),
                    "model {model}, lane {lane}, number {index}"
                );
            }
        }
    }
}

#[test]
fn each_lane_is_its_scalar_run_bit_for_bit() {
    each_lane_is_its_scalar::<f64, AutoF64x4>();
    each_lane_is_its_scalar::<f64, WideF64x4>();
    each_lane_is_its_scalar::<f32, AutoF32x8>();
}
