//! Guard: bad samples do not reach the port inside, and its ledger does not overstate what happened meanwhile.

use proptest::array::uniform16;
use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::TestCaseResult;

use lyapunov::{
    DampingLimit, Dissipation, HeldTick, Lolc, OnePort, Plant, PortEnergy, PortSample, Scalar,
    bodies::{Body, Impedance},
    effects::{Fallback, OnePortExt},
    environments::Spring,
};

use crate::support::{Bits, CASES, Faulty, Port, Real, Spy, bad, hold, log_between, ordinary};

const TICKS: usize = 40;

/// A loop of a body and a spring, and its bad samples.
struct Scene<V: Port> {
    body: Body<V>,
    spring: Spring<V>,
    limit: DampingLimit<V::Scalar>,
    period: V::Scalar,
    fallback: Fallback,
    bits: [Bits; 16],
}

/// One tick: the plant's sample, whether it was sound, the sample that the guard received, its answer, and the ledger
/// inside.
struct Row<V: Port> {
    sample: PortSample<V>,
    sound: bool,
    told: PortSample<V>,
    answer: V,
    sum: V::Scalar,
    accepted: bool,
}

impl<V: Port> Scene<V> {
    fn from(bits: [Bits; 16]) -> Self {
        let of = |value: f64| V::Scalar::of(value);
        let period = of(log_between(bits[0], 5e-4, 5e-3));
        let impedance = Impedance { mass: of(0.3), damping: of(0.2), stiffness: of(50.0) };
        let start = V::from_axes(|axis| ordinary(bits[1 + axis], 5e-3));
        let flow = V::from_axes(|axis| ordinary(bits[4 + axis], 0.3));
        Self {
            body: Body::new(impedance, period).expect("a body").starting(start, flow),
            spring: Spring::new(of(log_between(bits[7], 100.0, 3000.0))).expect("a spring"),
            limit: DampingLimit::of_mass(of(0.5), of(0.3), period).expect("a limit"),
            period,
            fallback: if bits[8] & 1 == 0 { Fallback::Hold } else { Fallback::Zero },
            bits,
        }
    }

    /// The sample with NaN or infinities in some of its fields, different ones from tick to tick.
    fn spoilt(&self, sample: PortSample<V>, tick: usize) -> PortSample<V> {
        let bits = self.bits[9].rotate_left(7 * tick as u32) ^ self.bits[10];
        let fields = 1 + bits % 63;
        let wrong = bad::<V::Scalar>(bits >> 8);
        let spoil = |field: u32, signal: V| {
            let axis = (bits >> (16 + 2 * field)) as usize % V::AXES;
            let hit = fields >> field & 1 == 1;
            V::from_axes(|at| if hit && at == axis { wrong } else { signal.axis(at) })
        };
        PortSample {
            period: if fields & 1 == 1 { wrong } else { sample.period },
            position: spoil(1, sample.position),
            velocity: spoil(2, sample.velocity),
            displacement: spoil(3, sample.displacement),
            applied: spoil(4, sample.applied),
            work: spoil(5, sample.work),
        }
    }

    /// Runs with bad samples at `bad`; also returns the samples that the spring received.
    fn run(&self, bad: impl Fn(usize) -> bool) -> (Vec<Row<V>>, Vec<PortSample<V>>) {
        let mut spy = Spy::on(self.spring);
        let lolc = Lolc::new(PortEnergy, self.limit);
        let mut port = (&mut spy).stabilized(lolc).guarded(self.fallback);
        let (mut plant, mut sample) = (self.body, self.body.start());
        let mut rows = Vec::new();
        for tick in 0..TICKS {
            let sound = !bad(tick);
            let told = if sound { sample } else { self.spoilt(sample, tick) };
            let answer = port.respond(&told);
            let correction = port.correction();
            let (sum, accepted) = (correction.observed_energy, correction.accepted);
            rows.push(Row { sample, sound, told, answer, sum, accepted });
            sample = plant.advance(answer);
        }
        (rows, spy.asked)
    }
}

/// Every answer is finite, and the fallback is the one chosen.
fn answers<V: Port>(rows: &[Row<V>], fallback: Fallback) -> TestCaseResult {
    let mut last = V::zero();
    for row in rows {
        prop_assert!(row.answer.all_finite(), "answered {:?}", row.answer);
        prop_assert!(row.accepted == row.sound, "accepted {} of {:?}", row.accepted, row.told);
        match (row.sound, fallback) {
            (true, _) => last = row.answer,
            (false, Fallback::Hold) => prop_assert!(row.answer == last, "not held"),
            (false, Fallback::Zero) => prop_assert!(row.answer == V::zero(), "not zero"),
        }
    }
    Ok(())
}

/// The spring received one sample for every sound one, with the time and the displacement since the one before.
fn spans<V: Port>(rows: &[Row<V>], asked: &[PortSample<V>], period: V::Scalar) -> TestCaseResult {
    let sound: Vec<usize> = (0..rows.len()).filter(|&tick| rows[tick].sound).collect();
    prop_assert!(asked.len() == sound.len(), "{} calls", asked.len());
    for (whole, &tick) in asked.iter().zip(&sound) {
        prop_assert!(whole.finite() && whole.position == rows[tick].sample.position);
    }
    for ((whole, pair), ticks) in asked.iter().skip(1).zip(asked.windows(2)).zip(sound.windows(2)) {
        let steps = (ticks[1] - ticks[0]) as f64;
        let off = whole.period.f64() - steps * period.f64();
        prop_assert!(off.abs() <= steps * steps * V::Scalar::unit() * period.f64(), "{off:e} s");
        let way = pair[1].position - pair[0].position;
        let measured = rows[ticks[1]].sample;
        if steps == 1.0 {
            prop_assert!(*whole == measured, "a sound sample was changed");
            continue;
        }
        prop_assert!(whole.displacement == way, "not the way of the positions");
        for axis in 0..V::AXES {
            let mean = way.axis(axis).f64() / whole.period.f64();
            let (told, now) = (whole.velocity.axis(axis).f64(), measured.velocity.axis(axis).f64());
            let slower = if mean.abs() < now.abs() { mean } else { now };
            let least = if mean * now < 0.0 { 0.0 } else { slower };
            let off = (told - least).abs();
            prop_assert!(
                off <= 2.0 * V::Scalar::unit() * mean.abs(),
                "{told} for {mean} and {now}"
            );
        }
    }
    Ok(())
}

/// The first sample that the spring received has the periods and the motion that are known until then, and is no faster than
/// either its own velocity or that motion.
fn begins<V: Port>(rows: &[Row<V>], asked: &[PortSample<V>]) -> TestCaseResult {
    let (Some(first), Some(tick)) = (asked.first(), rows.iter().position(|row| row.sound)) else {
        return Ok(());
    };
    let measured = rows[tick].sample;
    if tick == 0 {
        prop_assert!(*first == measured, "a first sound sample was changed");
        return Ok(());
    }
    let before = || rows[..tick].iter().map(|row| row.told);
    let timed =
        before().map(|told| told.period.f64()).filter(|time| time.is_finite() && *time > 0.0);
    let (time, rounding) = (timed.sum::<f64>() + measured.period.f64(), V::Scalar::unit());
    let off = first.period.f64() - time;
    prop_assert!(off.abs() <= 2.0 * rounding * TICKS as f64 * time, "{off:e} s");
    let known = || before().filter(|told| told.work.all_finite() && told.displacement.all_finite());
    for axis in 0..V::AXES {
        let moved: f64 = known().map(|told| told.displacement.axis(axis).f64()).sum();
        let size: f64 = known().map(|told| told.displacement.axis(axis).f64().abs()).sum();
        let way = measured.displacement.axis(axis).f64();
        let bound = 2.0 * rounding * TICKS as f64 * (size + way.abs());
        let off = first.displacement.axis(axis).f64() - (moved + way);
        prop_assert!(off.abs() <= bound, "{off:e} m");
        let (told, now) = (first.velocity.axis(axis).f64(), measured.velocity.axis(axis).f64());
        let mean = (moved + way) / time;
        let most = mean.abs() + 2.0 * bound / time;
        prop_assert!(told.abs() <= now.abs().min(most), "{told} for {mean} and {now}");
        prop_assert!(told * now >= 0.0, "{told} turned from {now}");
    }
    Ok(())
}

/// Whether no axis reversed between the sound samples around each gap.
fn monotone<V: Port>(rows: &[Row<V>]) -> bool {
    let one_way = |part: &[Row<V>]| {
        (0..V::AXES).all(|axis| {
            let moved = || part.iter().map(|row| row.sample.displacement.axis(axis).f64());
            moved().all(|way| way >= 0.0) || moved().all(|way| way <= 0.0)
        })
    };
    // The first sound sample after a gap shows its end.
    let gap_at = |tick: usize| {
        let in_gap = |at: &usize| !rows[*at].sound || (*at > 0 && !rows[*at - 1].sound);
        (tick..rows.len()).take_while(in_gap).count()
    };
    (0..rows.len()).all(|tick| one_way(&rows[tick..tick + gap_at(tick)]))
}

/// On sound ticks the sum is at most the work that the plant knows of, and equal to it under a hold.
fn ledger<V: Port>(rows: &[Row<V>], fallback: Fallback) -> TestCaseResult {
    let (mut truth, mut size) = (0.0, 0.0);
    let one_way = monotone(rows);
    for (tick, row) in rows.iter().enumerate() {
        let PortSample { applied, displacement, position, .. } = row.sample;
        for axis in 0..V::AXES {
            let (f, dx) = (applied.axis(axis).f64(), displacement.axis(axis).f64());
            truth += f * dx;
            // The displacement over a gap is a difference of rounded positions.
            size += f.abs() * (dx.abs() + position.axis(axis).f64().abs());
        }
        if !row.sound {
            continue;
        }
        let (sum, bound) = (row.sum.f64(), 16.0 * V::Scalar::unit() * size);
        let over = sum - truth;
        prop_assert!(!one_way || over <= bound, "tick {tick}: {sum:e} J for {truth:e} J");
        let exact = fallback == Fallback::Hold;
        prop_assert!(!exact || over.abs() <= bound, "tick {tick}: {sum:e} J, not {truth:e} J");
    }
    Ok(())
}

fn laws<V: Port>(scene: &Scene<V>, bad: impl Fn(usize) -> bool) -> TestCaseResult {
    let (rows, asked) = scene.run(bad);
    answers(&rows, scene.fallback)?;
    spans(&rows, &asked, scene.period)?;
    begins(&rows, &asked)?;
    ledger(&rows, scene.fallback)
}

/// A second without positions ahead of 1 mm in 1 ms credits a damper of 0.6 N·s/m with the 0.6 mJ of that millisecond at most.
#[test]
fn a_gap_before_the_first_sound_sample_earns_nothing() {
    let body = (PortEnergy, Dissipation::of(0.6).expect("a damping"));
    let limit = DampingLimit::at(1.0).expect("a limit");
    let spring = Spring::new(0.0_f64).expect("a spring");
    let mut port = spring.stabilized(Lolc::new(body, limit)).guarded(Fallback::Zero);
    for _ in 0..1000 {
        port.respond(&PortSample::starting(1e-3, f64::NAN, 1.0));
    }
    let tick =
        HeldTick { period: 1e-3, position: 0.0, velocity: 1.0, displacement: 1e-3, applied: 0.0 };
    port.respond(&tick.sample());
    let credit = port.correction().observed_energy;
    assert!((0.0..=0.6e-3).contains(&credit), "{credit} J");
}

mod check {
    use super::*;

    pub(super) fn one_bad_sample<V: Port>() {
        hold(CASES, (0..TICKS, uniform16(any::<Bits>())), |(at, bits)| {
            laws(&Scene::<V>::from(bits), |tick| tick == at)
        });
    }

    pub(super) fn bad_from_then_on<V: Port>() {
        hold(CASES, (0..TICKS, uniform16(any::<Bits>())), |(at, bits)| {
            laws(&Scene::<V>::from(bits), |tick| tick >= at)
        });
    }

    pub(super) fn gaps<V: Port>() {
        hold(CASES, (0..TICKS, 1..12usize, uniform16(any::<Bits>())), |(at, long, bits)| {
            laws(&Scene::<V>::from(bits), |tick| (at..at + long).contains(&tick))
        });
    }

    pub(super) fn now_and_then<V: Port>() {
        hold(CASES, (any::<Bits>(), uniform16(any::<Bits>())), |(which, bits)| {
            laws(&Scene::<V>::from(bits), |tick| which >> tick & 1 == 1)
        });
    }

    /// An effort that is not finite is replaced as after a bad sample, and the correction reports it.
    pub(super) fn replaces_bad_efforts<V: Port>() {
        hold(CASES, (0..8u8, 1..8u8, uniform16(any::<Bits>())), |(from, long, bits)| {
            let scene = Scene::<V>::from(bits);
            let of = |value: u8| V::Scalar::of(f64::from(value));
            let faulty = Faulty::between(scene.spring, of(from), of(from + long));
            let mut port = faulty.guarded(scene.fallback);
            let (mut plant, mut sample, mut last) = (scene.body, scene.body.start(), V::zero());
            for tick in 0..16u8 {
                let answer = port.respond(&sample);
                let bad = (from..from + long).contains(&tick);
                let fallback = match scene.fallback {
                    Fallback::Hold => last,
                    Fallback::Zero => V::zero(),
                };
                let stiff = { scene.spring }.respond(&sample);
                prop_assert!(answer == if bad { fallback } else { stiff }, "{answer:?}");
                prop_assert!(port.correction().accepted != bad, "tick {tick} says nothing");
                last = answer;
                sample = plant.advance(answer);
            }
            Ok(())
        });
    }
}

crate::support::every_port!(
    one_bad_sample,
    bad_from_then_on,
    gaps,
    now_and_then,
    replaces_bad_efforts,
);
