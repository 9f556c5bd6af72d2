//! Telemetry: a ring that keeps the last ticks and writes them digit for digit, and a meter whose sums hold for a year.

use std::collections::VecDeque;

use lyapunov::lanes::{AutoF32x4, AutoF64x4};
use lyapunov::laws::Samples;
use lyapunov::telemetry::{EnergyMeter, EnergySummary, RecordedTick, TickRing};
use lyapunov::{
    Correction, DampingLimit, HeldTick, Popc, PortEnergy, PortSample, Scalar, Signal, Stabilizer,
    accumulators::DoubleDouble,
};
use nalgebra::{Vector2, Vector4};

const PERIOD: f64 = 1e-3;

/// A period over which `applied` was held.
fn tick<T: Signal<Scalar = T>>(
    period: T,
    [position, velocity, displacement, applied]: [T; 4],
) -> PortSample<T> {
    HeldTick { period, position, velocity, displacement, applied }.sample()
}

fn popc<T: Scalar>() -> Popc<T> {
    Popc::new(PortEnergy, DampingLimit::at(T::of(100.0)).expect("a limit"))
}

/// Ticks of POPC over the samples that ship.
fn ticks<V: Signal>(seed: u64) -> impl Iterator<Item = RecordedTick<V>> {
    let mut popc = popc::<V::Scalar>();
    Samples::<V>::new(V::Scalar::of(PERIOD)).seeded(seed).map(move |(sample, effort)| {
        RecordedTick { sample, correction: popc.stabilize(&sample, effort) }
    })
}

fn keeps_the_last<const N: usize>() {
    let (mut ring, mut kept) = (TickRing::<f64, N>::new(), VecDeque::new());
    for (index, tick) in ticks::<f64>(1).enumerate() {
        assert_eq!(ring.len(), index.min(N));
        ring.push(&tick.sample, &tick.correction);
        kept.push_back(tick);
        if kept.len() > N {
            kept.pop_front();
        }
        assert!(ring.iter().eq(&kept), "{N} after {index}");
        assert_eq!((ring.seen(), ring.is_empty()), (index as u64 + 1, N == 0));
    }
    assert_ne!(ring, TickRing::new());
    ring.clear();
    assert_eq!((ring, ring.iter().count(), ring.seen()), (TickRing::default(), 0, 0));
}

#[test]
fn the_ring_keeps_the_last_ticks_in_their_order() {
    keeps_the_last::<0>();
    keeps_the_last::<1>();
    keeps_the_last::<2>();
    keeps_the_last::<255>();
    keeps_the_last::<3000>();
}

/// A ring that starts before any code runs, as firmware has it.
static RING: std::sync::Mutex<TickRing<f32, 4>> = std::sync::Mutex::new(TickRing::new());

#[test]
fn a_ring_may_be_a_static() {
    let mut ring = RING.lock().expect("a ring");
    ring.push(&PortSample::default(), &Correction::default());
    assert_eq!(ring.len(), 1);
}

/// Header and rows of a log, read by a reader of the test's own.
fn read(csv: &str) -> (Vec<&str>, Vec<Vec<f64>>) {
    let mut lines = csv.lines();
    let header = lines.next().expect("a header").split(',').collect();
    let number = |field: &str| field.parse::<f64>().expect("a number");
    (header, lines.map(|line| line.split(',').map(number).collect()).collect())
}

#[test]
fn every_digit_is_written() {
    let mut ring = TickRing::<f64, 1000>::new();
    let all: Vec<_> = ticks::<f64>(7).collect();
    all.iter().for_each(|tick| ring.push(&tick.sample, &tick.correction));
    let csv = ring.csv().to_string();
    let (header, rows) = read(&csv);
    assert_eq!(header.join(","), "t,x,v,f,f_out,observer,alpha,shortfall,accepted");
    assert_eq!(rows.len(), 1000);
    for (index, (row, tick)) in rows.iter().zip(&all[1000..]).enumerate() {
        let RecordedTick { sample, correction } = tick;
        // The force that acts from this tick on is known to the next; the last row has what was commanded.
        let acting = all.get(1000 + index + 1).map_or(correction.effort, |it| it.sample.applied);
        let expected = [
            index as f64 * PERIOD,
            sample.position,
            sample.velocity,
            acting,
            correction.effort,
            correction.observed_energy,
            correction.alpha,
            correction.shortfall,
            1.0,
        ];
        let bits = |numbers: &[f64]| numbers.iter().map(|it| it.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(row), bits(&expected), "row {index}");
    }
}

#[test]
fn axes_and_lanes_have_columns_of_their_own() {
    let axis = |index: f64| AutoF64x4::from_lanes(|lane| 10.0 * index + lane as f64);
    let position = Vector4::new(axis(1.0), axis(2.0), axis(3.0), axis(4.0));
    let mut ring = TickRing::<Vector4<AutoF64x4>, 2>::new();
    let sample = PortSample::starting(AutoF64x4::of(PERIOD), position, position);
    ring.push(&sample, &Correction::none(position));
    for lane in 0..4 {
        let csv = ring.csv().of_lane(lane).to_string();
        let (header, rows) = read(&csv);
        assert_eq!(
            header.join(","),
            "t,x,v,f,f_out,y,y_v,y_f,y_f_out,z,z_v,z_f,z_f_out,x4,x4_v,x4_f,x4_f_out,\
             observer,alpha,shortfall,accepted"
        );
        for (index, name) in ["x", "y", "z", "x4"].into_iter().enumerate() {
            let column = header.iter().position(|it| *it == name).expect("a column");
            assert_eq!(rows[0][column], 10.0 * (index + 1) as f64 + lane as f64);
        }
    }
    assert!(ring.csv().of_lane(4).to_string().lines().nth(1).expect("a row").contains("NaN"));
}

#[test]
fn a_period_that_is_none_counts_as_the_one_before() {
    let mut ring = TickRing::<f32, 8>::new();
    for period in [9.0, 0.25, 0.5, f32::NAN, -1.0, 0.0, f32::INFINITY, 0.125] {
        ring.push(&PortSample::starting(period, 0.0, 0.0), &Correction::default());
    }
    let csv = ring.csv().to_string();
    let (_, rows) = read(&csv);
    let times: Vec<f64> = rows.iter().map(|row| row[0]).collect();
    // The period before the oldest tick is over.
    assert_eq!(times, [0.0, 0.25, 0.75, 1.25, 1.75, 2.25, 2.75, 2.875]);
}

#[test]
fn a_rejected_tick_is_told() {
    let mut ring = TickRing::<f64, 2>::new();
    let bad = tick(PERIOD, [f64::NAN, 0.0, 0.0, 1.0]);
    ring.push(&bad, &popc().stabilize(&bad, 2.0));
    ring.push(&bad, &Correction { accepted: false, ..popc().stabilize(&bad, f64::NAN) });
    let csv = ring.csv().to_string();
    assert!(csv.ends_with(",0\n") && csv.contains(",NaN,"));
}

/// Sums of thirty digits beside the meter.
fn by_hand(ticks: &[RecordedTick<f64>]) -> [f64; 8] {
    let (mut absorbed, mut asked) = (DoubleDouble::default(), DoubleDouble::default());
    let (mut least, mut most, mut active, mut worst) = (f64::INFINITY, f64::NEG_INFINITY, 0, 0.0);
    for RecordedTick { sample, correction } in ticks {
        absorbed += DoubleDouble::product_of(sample.applied, sample.displacement);
        let square = sample.velocity * sample.velocity * sample.period;
        asked += DoubleDouble::product_of(correction.alpha, square);
        least = f64::min(least, correction.observed_energy);
        most = f64::max(most, correction.observed_energy);
        worst = f64::max(worst, correction.shortfall);
        active += u32::from(correction.alpha > 0.0);
    }
    let last = ticks.last().expect("ticks").correction;
    let [absorbed, asked] = [absorbed, asked].map(DoubleDouble::high);
    let now = [last.observed_energy, last.shortfall];
    [absorbed, asked, least, most, worst, active.into(), now[0], now[1]]
}

#[test]
fn the_meter_sums_what_sums_of_thirty_digits_do() {
    for seed in 0..10 {
        let ticks: Vec<_> = ticks::<f64>(seed).collect();
        let mut meter = EnergyMeter::new();
        ticks.iter().for_each(|tick| meter.add(&tick.sample, &tick.correction));
        let it = meter.summary();
        assert_eq!((it.ticks, it.rejected), (2000, 0.0));
        assert!(it.active > 100.0 && it.largest_shortfall > 0.0);
        let told = [
            it.absorbed,
            it.asked,
            it.least,
            it.most,
            it.largest_shortfall,
            it.active,
            it.now,
            it.shortfall,
        ];
        // Each term of the meter is rounded, by half a unit in its last place.
        let size: f64 = ticks.iter().map(|tick| tick.sample.work.abs()).sum();
        for (told, exact) in told.into_iter().zip(by_hand(&ticks)) {
            assert!((told - exact).abs() <= size * f64::EPSILON, "{told} is not {exact}");
        }
    }
}

/// 2²⁵ ticks: twice as many as an `f32` can count one by one, and energies of which a plain sum would lose half.
#[test]
fn in_f32_the_sums_do_not_stop() {
    let mut meter = EnergyMeter::<f32>::new();
    let sample = tick::<f32>(1e-3, [0.0, 1.0, 1e-3, 1.0]);
    let correction = Correction { alpha: 2.0, accepted: false, ..Correction::none(0.0) };
    let ticks = 1_u64 << 25;
    for _ in 0..ticks {
        meter.add(&sample, &correction);
    }
    let EnergySummary { active, rejected, absorbed, asked, .. } = meter.summary();
    assert_eq!([active, rejected].map(f64::from), [ticks as f64; 2]);
    let each = f64::from(1e-3_f32) * ticks as f64;
    approx::assert_relative_eq!(f64::from(absorbed), each, max_relative = 1e-7);
    approx::assert_relative_eq!(f64::from(asked), 2.0 * each, max_relative = 1e-7);
}

#[test]
fn each_lane_is_metered_as_alone() {
    let mut lanes = EnergyMeter::<AutoF32x4>::new();
    let mut alone = [EnergyMeter::<f32>::new(); 4];
    for RecordedTick { sample, correction } in ticks::<AutoF32x4>(3) {
        lanes.add(&sample, &correction);
        for (lane, meter) in alone.iter_mut().enumerate() {
            let of = |value: AutoF32x4| value.lane(lane) as f32;
            let own = sample.map(of(sample.period), of);
            let told = Correction {
                observed_energy: of(correction.observed_energy),
                alpha: of(correction.alpha),
                shortfall: of(correction.shortfall),
                ..Correction::none(of(correction.effort))
            };
            meter.add(&own, &told);
        }
    }
    let together = lanes.summary();
    for (lane, meter) in alone.iter().enumerate() {
        let own = meter.summary();
        for (all, one) in [
            (together.absorbed, own.absorbed),
            (together.asked, own.asked),
            (together.least, own.least),
            (together.most, own.most),
            (together.active, own.active),
            (together.largest_shortfall, own.largest_shortfall),
        ] {
            assert_eq!(all.lane(lane), f64::from(one));
        }
    }
}

#[test]
fn what_is_not_finite_is_left_out() {
    let mut meter = EnergyMeter::new();
    let sound = tick(PERIOD, [0.0, 0.1, 1e-4, 2.0]);
    meter.add(&sound, &Correction { observed_energy: -1e-3, ..Correction::none(0.0) });
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let spoilt = tick(bad, [bad; 4]);
        meter.add(&spoilt, &Correction { accepted: false, ..Correction::none(0.0) });
    }
    let summary = meter.summary();
    assert_eq!((summary.ticks, summary.rejected, summary.active), (4, 3.0, 0.0));
    assert_eq!((summary.absorbed, summary.asked, summary.least), (2e-4, 0.0, -1e-3));
    assert_eq!(EnergyMeter::<f64>::default().summary(), EnergySummary::default());
}

/// Of observed energies NaN alone is left out, also at the start.
#[test]
fn the_least_and_the_most_are_of_all_that_are_numbers() {
    let sound = tick(PERIOD, [0.0, 0.1, 1e-4, 2.0]);
    let extremes = |energies: &[f64]| {
        let mut meter = EnergyMeter::new();
        for &observed_energy in energies {
            meter.add(&sound, &Correction { observed_energy, ..Correction::none(0.0) });
        }
        let summary = meter.summary();
        (summary.least, summary.most)
    };
    let least = f64::NEG_INFINITY;
    assert_eq!(extremes(&[f64::NAN, 5.0, f64::NAN, 1.0]), (1.0, 5.0));
    assert_eq!(extremes(&[5.0, least, 1.0]), (least, 5.0));
    assert_eq!(extremes(&[least, 1.0, f64::NAN]), (least, 1.0));
}

/// The samples of no time are neutral.
#[test]
fn defaults_change_nothing() {
    for (sample, _) in Samples::<Vector2<f64>>::new(PERIOD) {
        assert_eq!(sample.spanning(&PortSample::default()), sample);
    }
    assert_eq!(Correction::<f64>::default(), Correction::none(0.0));
}

#[test]
fn an_energy_that_is_not_a_number_has_no_extremes() {
    let mut meter = EnergyMeter::new();
    for energy in [f64::NAN, 2e-3, f64::NAN, -1e-3] {
        meter.add(
            &tick(PERIOD, [0.0; 4]),
            &Correction { observed_energy: energy, ..Correction::none(0.0) },
        );
    }
    assert_eq!((meter.summary().least, meter.summary().most), (-1e-3, 2e-3));
}
