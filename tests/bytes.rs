//! Memory of effects: each stores its own values only, and an absent one nothing.

use lyapunov::{
    Popc, Readings,
    bodies::{Body, ExternalForce, Grip, HandMotion, Impedance, Jitter},
    effects::{
        AdaptiveWindow, BackwardDifference, Delay, Dropout, Encoder, LowPass, Noise, Saturation,
        Scaled, ZeroOrderHold,
    },
    environments::Wall,
    readings::{Clocked, Differenced, LowPassed, Measured, Windowed},
    stabilizers::Watchdog,
    trajectories::{Constant, Pulse},
};

/// Size of the type `Of` less that of `Inside`, in numbers of `T`.
fn added<Of, Inside, T>() -> f64 {
    (size_of::<Of>() - size_of::<Inside>()) as f64 / size_of::<T>() as f64
}

#[test]
fn an_adaptor_adds_its_own_numbers() {
    type Port = Wall<f64>;
    // An `Option` takes the room of a number for its tag; a stream of random numbers is a seed of four numbers, its
    // name and its place.
    let numbers = [
        ("nothing", added::<BackwardDifference<Port>, Port, f64>(), 0.0),
        ("force", added::<Saturation<Port, f64>, Port, f64>(), 1.0),
        ("scale", added::<Scaled<Port, f64>, Port, f64>(), 1.0),
        ("resolution, last", added::<Encoder<Port, f64>, Port, f64>(), 1.0 + 2.0),
        ("rate, last", added::<LowPass<Port, f64>, Port, f64>(), 1.0 + 2.0),
        (
            "ticks and left, sums, effort",
            added::<ZeroOrderHold<Port, f64>, Port, f64>(),
            1.0 + 3.0 + 1.0,
        ),
        ("ticks, next, efforts", added::<Delay<Port, f64, 4>, Port, f64>(), 2.0 + 4.0),
        ("ticks, band, past, known", added::<AdaptiveWindow<Port, f64, 8>, Port, f64>(), 3.0 + 8.0),
        ("deviation, stream, last", added::<Noise<Port, f64>, Port, f64>(), 1.0 + 6.0 + 2.0),
        ("chance, policy, stream, last", added::<Dropout<Port, f64>, Port, f64>(), 2.0 + 6.0 + 1.0),
    ];
    for (what, added, expected) in numbers {
        assert_eq!(added, expected, "{what}");
    }
    assert_eq!(added::<Saturation<Wall<f32>, f32>, Wall<f32>, f32>(), 1.0);
    assert_eq!(added::<ZeroOrderHold<Wall<f32>, f32>, Wall<f32>, f32>(), 2.0 + 3.0 + 1.0);
}

#[test]
fn readings_and_a_watchdog_keep_their_own_numbers() {
    // Period, speed, and where the position is known; position, gap, and two efforts.
    assert_eq!(size_of::<Readings<f64>>(), 7 * size_of::<f64>());
    assert_eq!(size_of::<Readings<f32>>(), 7 * size_of::<f32>());
    // Rate and velocity; two times, known; ticks, band, past, known.
    type Plain = Readings<f64>;
    assert_eq!(added::<Readings<f64, LowPassed<f64>>, Plain, f64>(), 1.0 + 2.0);
    assert_eq!(added::<Readings<f64, Differenced, Clocked>, Plain, f64>(), 3.0);
    assert_eq!(added::<Readings<f64, Windowed<f64, 8>>, Plain, f64>(), 3.0 + 8.0);
    assert_eq!(added::<Readings<f64, Measured>, Plain, f64>(), 0.0);
    // Two times, effort, silence, rise.
    assert_eq!(added::<Watchdog<Popc<f64>, f64>, Popc<f64>, f64>(), 5.0);
}

#[test]
fn an_adaptor_of_a_body_adds_its_own_numbers() {
    type Plant = Body<f64>;
    type Parts = Impedance<f64>;
    type Row = [(u64, Parts); 1];
    let numbers = [
        ("value, tick", added::<ExternalForce<Plant, Constant>, Plant, f64>(), 1.0 + 1.0),
        ("value, from, until, tick", added::<ExternalForce<Plant, Pulse>, Plant, f64>(), 3.0 + 1.0),
        ("trajectory, tick", added::<HandMotion<Plant, Constant>, Plant, f64>(), 1.0 + 1.0),
        ("a row, period, next, tick", added::<Grip<Plant, Row, f64>, Plant, f64>(), 4.0 + 3.0),
        (
            "parts, period, deviation, last interval",
            added::<Jitter<Plant, Parts, f64, fn() -> f64>, Plant, f64>() - 1.0,
            3.0 + 3.0,
        ),
    ];
    for (what, added, expected) in numbers {
        assert_eq!(added, expected, "{what}");
    }
}
