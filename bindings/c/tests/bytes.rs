//! Every byte of a block is initialised, and what it should be; under Miri, that none is read before.

use std::mem::MaybeUninit;

use lyapunov::{Correction, PortSample};
use lyapunov_c::abi::ABI;
use lyapunov_c::blocks;
use lyapunov_c::kept::{Kind, Storage};
use lyapunov_c::port::{CorrectionForm, SampleForm};
use lyapunov_c::readings::CheckedForm;
use lyapunov_c::status::Code;

/// The bytes of a value, each read once.
fn bytes<T>(value: &T) -> Vec<u8> {
    let start = (&raw const *value).cast::<u8>();
    // SAFETY: as many bytes as the value has; that each is initialised is what Miri looks at here.
    (0..size_of::<T>()).map(|at| unsafe { start.add(at).read() }).collect()
}

/// Storage that was never written, made a block by `init`.
fn fresh<K: Kind>(init: impl FnOnce(*mut Storage<K>) -> u32) -> Storage<K> {
    let mut storage = MaybeUninit::<Storage<K>>::uninit();
    assert_eq!(init(storage.as_mut_ptr()), Code::Ok as u32);
    // SAFETY: `init` wrote it.
    unsafe { storage.assume_init() }
}

fn sample(period: f64, work: f64) -> SampleForm<f64> {
    let (velocity, displacement) = (0.1, 1e-4);
    SampleForm::of(&PortSample {
        period,
        position: 0.0,
        velocity,
        displacement,
        applied: -2.0,
        work,
    })
}

/// Ticks that make a debt, bring nothing, are no ticks, or are rejected.
const TICKS: [(f64, f64); 5] =
    [(1e-3, -2e-4), (1e-3, 0.0), (0.0, 1.0), (1e-3, f64::NAN), (1e-3, 1e-3)];

macro_rules! stabilizer {
    ($name:ident, $block:ident, $given:expr) => {
        #[test]
        fn $name() {
            #[allow(unused_imports)]
            use blocks::lolc::of_f64::Parameters as L;
            use blocks::$block::of_f64::{Block, Parameters as P, life, stabilizer};
            let given: P = ($given)(L { damping_limit: 80.0, device_damping: 0.5, budget: 0.0 });
            // SAFETY: here and below all pointers lead to variables of this function.
            let make = || fresh::<Block>(|it| unsafe { life::init_abi(it, &given, ABI) }.code);
            let (mut one, other) = (make(), make());
            assert_eq!(bytes(&one), bytes(&other));
            let mut out = CorrectionForm::of(&Correction::none(0.0));
            for (period, work) in TICKS {
                let sample = sample(period, work);
                // SAFETY: as above.
                let code = unsafe { stabilizer::step(&mut one, &sample, 1.0, &mut out) };
                assert_eq!(code, Code::Ok as u32);
                assert!(bytes(&one).len() == size_of::<Storage<Block>>() && out.effort.is_finite());
                let mut memory = <Block as Kind>::EMPTY;
                let mut again = make();
                // SAFETY: as above.
                let restored = unsafe {
                    assert_eq!(life::save(&one, &mut memory), Code::Ok as u32);
                    life::restore(&mut again, &memory)
                };
                assert_eq!(restored.code, Code::Ok as u32);
                assert_eq!(bytes(&one), bytes(&again));
            }
            // SAFETY: as above.
            let retuned = unsafe { life::retune(&mut one, &given) };
            assert_eq!((retuned.code, bytes(&one).len()), (0, size_of::<Storage<Block>>()));
        }
    };
}

stabilizer!(popc, popc, |_| P { damping_limit: 80.0, budget: 0.0 });
stabilizer!(lolc, lolc, |lolc| lolc);
stabilizer!(compensated, lolc_compensated, |lolc| P { lolc });
stabilizer!(windowed, windowed_credit, |lolc| P { lolc, ticks: 3 });
stabilizer!(contact, contact_reset, |lolc| P { lolc, surface: 0.0 });
stabilizer!(spread, spread, |lolc| P { lolc, ticks: 3 });
stabilizer!(watchdog, watchdog, |lolc| P { lolc, hold: 0.01, rise: 0.1 });
stabilizer!(slope, slope_bound, |_| P { slope: 1000.0, creep: 0.5 });
stabilizer!(tank, tank, |_| P {
    start: 0.01,
    floor: 0.0,
    ceiling: 1.0,
    power: 1.0,
    device_damping: 0.5
});
stabilizer!(side, two_port_side, |_| P { damping_limit: 80.0 });

/// No byte of the restored value decides anything before it is written.
#[test]
fn a_restored_screw() {
    use blocks::lolc::of_f32screw::Parameters as L;
    use blocks::safeguarded::of_f32screw::{Block, Parameters, life};
    let lolc = L { damping_limit: 80.0, device_damping: 0.5, budget: 0.0 };
    let (most, rate, speed, effort, hold, rise) = (1e-3, 2000.0, 1.0, 10.0, 0.01, 0.1);
    let given = Parameters { lolc, most, rate, speed, effort, hold, rise };
    // SAFETY: here and below all pointers lead to variables of this function.
    let mut one = fresh::<Block>(|it| unsafe { life::init_abi(it, &given, ABI) }.code);
    let mut memory = <Block as Kind>::EMPTY;
    // Refused if the last effort, which is among them, has an axis that is not finite.
    for (axis, word) in memory.word.iter_mut().enumerate() {
        *word = (axis as f32 * 1e-6).to_bits();
    }
    // SAFETY: as above.
    let restored = unsafe { life::restore(&mut one, &memory) };
    let mut saved = <Block as Kind>::EMPTY;
    // SAFETY: as above.
    let code = unsafe { life::save(&one, &mut saved) };
    assert_eq!((restored.code, code, saved.word), (0, 0, memory.word));
}

#[test]
fn inertias() {
    use blocks::inertia_limit::of_f64x3::{Block, Parameters, life, stabilizer};
    use blocks::lolc::of_f64x3::Parameters as L;
    use lyapunov_c::port::AxesForm;
    use nalgebra::Vector3;
    let lolc = L { damping_limit: f64::INFINITY, device_damping: 0.0, budget: 0.0 };
    let inertia = [[0.5, 9.0, 9.0], [0.1, 0.1, 9.0], [0.0, 0.0, 0.2]].map(|axis| AxesForm { axis });
    let given = Parameters { lolc, inertia, cap: 0.5, period: 1e-3, late: 0 };
    // SAFETY: here and below all pointers lead to variables of this function.
    let mut it = fresh::<Block>(|it| unsafe { life::init_abi(it, &given, ABI) }.code);
    let along = Vector3::x();
    let sample = SampleForm::of(&PortSample {
        period: 1e-3,
        position: along,
        velocity: along,
        displacement: along * 1e-3,
        applied: along * -900.0,
        work: along * -0.9,
    });
    let none = AxesForm { axis: [0.0; 3] };
    let mut out = CorrectionForm::of(&Correction::none(Vector3::zeros()));
    // SAFETY: as above.
    let code = unsafe { stabilizer::step(&mut it, &sample, &none, &mut out) };
    // The first joint alone would be 0.5 kg.m^2; the second one may yield: 0.5 - 0.1^2 / 0.1.
    assert!(code == Code::Ok as u32 && (out.alpha - 0.5 * 0.4 / 1e-3).abs() < 1e-9);
    assert_eq!(bytes(&it).len(), size_of_val(&it));
}

#[test]
fn readings() {
    use blocks::readings::of_f64::{Block, Parameters, life, reading};
    use blocks::readings_clocked::of_f64 as clocked;
    let given = Parameters { period: 1e-3, fastest: 2.0 };
    // SAFETY: here and below all pointers lead to variables of this function.
    let mut plain = fresh::<Block>(|it| unsafe { life::init_abi(it, &given, ABI) }.code);
    let given = clocked::Parameters { period: 1e-3, fastest: 2.0 };
    // SAFETY: as above.
    let mut timed =
        fresh::<clocked::Block>(|it| unsafe { clocked::life::init_abi(it, &given, ABI) }.code);
    let mut out = MaybeUninit::<CheckedForm<f64>>::uninit();
    for (tick, position) in [0.3, 0.301, f64::NAN, 0.302, 9.0].into_iter().enumerate() {
        // SAFETY: as above; both write `out` before it is read.
        let (told, accepted) = unsafe {
            let told = reading::read(&mut plain, position, 1.0, out.as_mut_ptr());
            let accepted = out.assume_init().accepted;
            clocked::reading_at::read_at(
                &mut timed,
                tick as f64 * 1e-3,
                position,
                1.0,
                out.as_mut_ptr(),
            );
            (told, accepted)
        };
        assert_eq!((told, accepted), (0, u32::from(position < 1.0)));
        assert_eq!(
            bytes(&plain).len() + bytes(&timed).len(),
            size_of_val(&plain) + size_of_val(&timed)
        );
    }
}

#[test]
fn poses() {
    use blocks::readings_of_poses::of_f64screw::{Block, Parameters, life, pose_reading};
    use lyapunov_c::port::ScrewForm;
    use lyapunov_c::poses::PoseForm;
    let (fastest_translation, fastest_rotation) = (2.0, f64::INFINITY);
    let given = Parameters { period: 1e-3, fastest_translation, fastest_rotation };
    // SAFETY: here and below all pointers lead to variables of this function.
    let mut it = fresh::<Block>(|it| unsafe { life::init_abi(it, &given, ABI) }.code);
    let applied = ScrewForm { translation: [0.0; 3], rotation: [0.0, 0.0, 2.0] };
    // As it stands; a quarter of a turn, whose quaternion is no unit; no orientation at all.
    for (quaternion, turned) in
        [([0.0, 0.0, 0.0, 1.0], 0.0), ([0.0, 0.0, 2.0, 2.0], 1.0), ([0.0; 4], 0.0)]
    {
        let pose = PoseForm { position: [0.3, 0.0, 0.0], quaternion };
        let mut out = MaybeUninit::uninit();
        // SAFETY: as above; the call writes `out`.
        let (code, read) = unsafe {
            (pose_reading::read(&mut it, &pose, &applied, out.as_mut_ptr()), out.assume_init())
        };
        let quarter = turned * core::f64::consts::FRAC_PI_2;
        assert_eq!((code, read.accepted), (0, u32::from(quaternion != [0.0; 4])));
        assert!((read.sample.displacement.rotation[2] - quarter).abs() < 1e-12);
        assert!(bytes(&it).len() == size_of_val(&it));
    }
    let mut memory = <Block as Kind>::EMPTY;
    // SAFETY: as above.
    let saved = unsafe { life::save(&it, &mut memory) };
    // SAFETY: as above.
    let mut again = fresh::<Block>(|it| unsafe { life::init_abi(it, &given, ABI) }.code);
    // SAFETY: as above.
    let restored = unsafe { life::restore(&mut again, &memory) };
    assert_eq!((saved, restored.code, bytes(&it)), (0, 0, bytes(&again)));
}

#[test]
fn poses_in_a_window() {
    use blocks::readings_of_poses_windowed::of_f64screw::{Block, Parameters, life, pose_reading};
    use lyapunov_c::port::ScrewForm;
    use lyapunov_c::poses::PoseForm;
    let (fastest_translation, fastest_rotation) = (2.0, f64::INFINITY);
    let given =
        Parameters { period: 1e-3, fastest_translation, fastest_rotation, ticks: 4, band: 1e-9 };
    // SAFETY: here and below all pointers lead to variables of this function.
    let mut it = fresh::<Block>(|it| unsafe { life::init_abi(it, &given, ABI) }.code);
    let applied = ScrewForm::default();
    for tick in 0..3 {
        let position = [0.3 + 1e-4 * f64::from(tick), 0.0, 0.0];
        let pose = PoseForm { position, quaternion: [0.0, 0.0, 0.0, 1.0] };
        let mut out = MaybeUninit::uninit();
        // SAFETY: as above; the call writes `out`.
        let (code, read) = unsafe {
            (pose_reading::read(&mut it, &pose, &applied, out.as_mut_ptr()), out.assume_init())
        };
        let speed = if tick == 0 { 0.0 } else { 0.1 };
        assert_eq!((code, read.accepted), (0, 1));
        assert!((read.sample.velocity.translation[0] - speed).abs() < 1e-9);
        assert!(bytes(&it).len() == size_of_val(&it));
    }
}

#[test]
fn summaries() {
    use blocks::energy_meter::of_f32::{Block, Parameters, life, meter};
    // SAFETY: here and below all pointers lead to variables of this function.
    let it =
        fresh::<Block>(|it| unsafe { life::init_abi(it, &Parameters { reserved: 0 }, ABI) }.code);
    let mut out = MaybeUninit::uninit();
    // SAFETY: as above; the call writes `out`.
    let (code, summary) = unsafe { (meter::summary(&it, out.as_mut_ptr()), out.assume_init()) };
    assert_eq!((code, bytes(&summary).len()), (0, size_of_val(&summary)));
}

/// What stands behind a tag may be anything.
#[test]
fn bytes_gone_bad() {
    use blocks::slope_bound::of_f64::{Block, Parameters, life, stabilizer};
    let given = Parameters { slope: 1000.0, creep: 0.5 };
    // No slope at all; tiny and huge numbers, which are a slope bound; NaN.
    for (fill, refused) in [(0x00, true), (0x01, false), (0x7f, false), (0xff, true)] {
        // SAFETY: here and below all pointers lead to variables of this function.
        let mut it = fresh::<Block>(|it| unsafe { life::init_abi(it, &given, ABI) }.code);
        let (start, tag) = ((&raw mut it).cast::<u8>(), size_of::<f64>());
        // SAFETY: within the storage, which is words of any bits.
        (tag..size_of::<Storage<Block>>()).for_each(|at| unsafe { start.add(at).write(fill) });
        let mut out = CorrectionForm::of(&Correction::none(0.0));
        // SAFETY: as above.
        let code = unsafe { stabilizer::step(&mut it, &sample(1e-3, 0.0), 1.0, &mut out) };
        assert_eq!(code == Code::Memory as u32, refused, "{fill}");
        assert!(out.effort.is_finite() && !(refused && out.accepted != 0));
    }
}
