//! Lanes with gaps, jumps and starts of their own: each equals its scalar run bit for bit.

use nalgebra::SVector;
use proptest::prelude::any;
use proptest::proptest;

use lyapunov::lanes::{AutoF32x4, AutoF64x4, WideF32x8, WideF64x4};
use lyapunov::{
    DampingLimit, Dissipation, Lolc, Mask, MovingReading, PortEnergy, PortSample, Reading,
    Readings, Scalar, Signal, Stabilizer,
    readings::CheckedSample,
    stabilizers::{StabilizerExt, WatchdogTimes},
};

use crate::support::Dice;

type V<T> = SVector<T, 2>;

/// A sample, where it was accepted, jumped and was late, and the command behind it.
type Row<T> = (PortSample<V<T>>, [<T as Scalar>::Mask; 3], V<T>);

/// What lane `lane` reads on `tick`: mostly a slow motion, with NaN, jumps and efforts that are not finite.
fn tell(seed: u64, lane: usize, tick: usize) -> [f64; 5] {
    let mut dice = Dice::of(seed ^ (lane as u64) << 40 ^ (tick as u64) << 20);
    dice.draw();
    let mut number = |size: f64| match dice.draw() % 12 {
        0 => f64::NAN,
        1 => size * 1e6,
        2 => f64::INFINITY,
        _ => dice.within(size),
    };
    [number(1e-3), number(1e-3), number(1.0), number(5.0), number(5.0)]
}

/// Everything that the lanes from `first` on are told by readings of each kind, and commanded behind them.
fn run<T: Scalar>(seed: u64, first: usize) -> Vec<Row<T>> {
    let of = T::of;
    let steady: Readings<V<T>> = Readings::every(of(1e-3)).expect("a period");
    let steady = steady.no_faster_than(of(4.0)).expect("a speed");
    let mut low_passed = steady.low_passed(of(30.0)).expect("a cutoff");
    let mut windowed = steady.windowed::<6>(5, of(1e-4)).expect("a window").clocked();
    let mut measured = steady.measured().clocked();
    let mut differenced = steady;

    let limit = DampingLimit::of_mass(of(0.5), of(0.2), of(1e-3)).expect("a limit");
    let lolc = Lolc::new((PortEnergy, Dissipation::of(of(0.1)).expect("a damper")), limit);
    let times = WatchdogTimes { hold: of(2.5e-3), rise: of(10e-3) };
    let mut stabilizer = lolc.watched::<V<T>>(times).expect("a watchdog");

    let mut all = Vec::new();
    let mut clock = Dice::of(seed ^ 77);
    let mut now = 0.0;
    for tick in 0..50 {
        let at = |which: usize| T::from_lanes(|lane| tell(seed, first + lane, tick)[which]);
        let position = SVector::<T, 2>::new(at(0), at(1));
        let velocity = SVector::<T, 2>::new(at(2), at(0));
        let applied = SVector::<T, 2>::new(at(3), at(4));
        now += match clock.draw() % 8 {
            0 => 5e-3,
            1 => 0.0,
            2 => -0.1,
            3 => f64::NAN,
            _ => 1e-3,
        };
        now = if now.is_nan() && clock.draw().is_multiple_of(2) { 1.0 } else { now };
        let reading = Reading { position, applied };
        let mut keep = |checked: CheckedSample<V<T>>| {
            let CheckedSample { sample, accepted, jumped, late, .. } = checked;
            let effort = sample.position.scale(of(2e3));
            let command = stabilizer.stabilize(&sample, effort).effort;
            all.push((sample, [accepted, jumped, late], command));
        };
        keep(differenced.read(reading));
        keep(low_passed.read(reading));
        keep(windowed.read_at(now, reading));
        keep(measured.read_moving_at(now, MovingReading { position, velocity, applied }));
    }
    all
}

fn numbers<T: Scalar>(sample: &PortSample<V<T>>, command: V<T>, lane: usize) -> Vec<u64> {
    let PortSample { period, position, velocity, displacement, applied, work } = sample;
    let signals = [*position, *velocity, *displacement, *applied, *work, command];
    let axes = signals.iter().flat_map(|signal| [signal[0], signal[1]]);
    // All NaN are alike: which one an operation gives is not said.
    let bits = |value: f64| if value.is_nan() { f64::NAN } else { value }.to_bits();
    axes.chain([*period]).map(|axis| bits(axis.lane(lane))).collect()
}

fn alike<L: Scalar, T: Scalar>(seed: u64) {
    let lanes = run::<L>(seed, 0);
    for lane in 0..L::LANES {
        for (call, (together, alone)) in lanes.iter().zip(run::<T>(seed, lane)).enumerate() {
            let masks = together.1.map(|mask| mask.lane(lane));
            assert_eq!(masks, alone.1.map(|mask| mask.lane(0)), "lane {lane}, call {call}");
            let [one, other] =
                [numbers(&together.0, together.2, lane), numbers(&alone.0, alone.2, 0)];
            assert_eq!(one, other, "lane {lane}, call {call}: {:?}", alone.0);
        }
    }
}

proptest! {
    #[test]
    fn each_equals_its_scalar_run(seed in any::<u64>()) {
        alike::<AutoF64x4, f64>(seed);
        alike::<WideF64x4, f64>(seed);
        alike::<AutoF32x4, f32>(seed);
        alike::<WideF32x8, f32>(seed);
    }
}

/// The runs are worth comparing: lanes differ in what they accept, and most of it is accepted.
#[test]
fn runs_show_something() {
    let rows = run::<AutoF64x4>(5, 0);
    let accepted = |lane: usize| rows.iter().filter(|row| row.1[0].lane(lane)).count();
    assert!((0..4).all(|lane| accepted(lane) > rows.len() / 4 && accepted(lane) < rows.len()));
    assert!(rows.iter().any(|row| row.1[0].lane(0) != row.1[0].lane(1)));
    assert!(rows.iter().any(|row| row.1[1].any()) && rows.iter().any(|row| row.1[2].any()));
    assert!(rows.iter().any(|row| row.2[0].lane(0) != 0.0));
}
