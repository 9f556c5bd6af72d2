//! Retuning with what only `init` reads at a value that `init` would refuse.

use std::ffi::CStr;
use std::mem::MaybeUninit;

use lyapunov::{Correction, PortSample};
use lyapunov_c::abi::ABI;
use lyapunov_c::blocks;
use lyapunov_c::kept::{Kind, Storage};
use lyapunov_c::port::{CorrectionForm, SampleForm};
use lyapunov_c::status::{Code, Status};
use lyapunov_c::status_text::lyapunov_status_text;

const NAN: f64 = f64::NAN;

fn text(status: &Status) -> String {
    let mut text = [0; 200];
    // SAFETY: as many bytes can be written there, and the status is the library's.
    unsafe {
        lyapunov_status_text(status, text.as_mut_ptr(), text.len());
        CStr::from_ptr(text.as_ptr()).to_str().unwrap().to_owned()
    }
}

/// A block made of `$sound` and retuned to `$later`: the status, the energies before and after, and the block.
macro_rules! retuned {
    ($block:ident, $sound:expr, $later:expr, $energy:path) => {{
        use blocks::$block::of_f64::{Block, life};
        let mut storage = MaybeUninit::<Storage<Block>>::uninit();
        let (sound, later) = ($sound, $later);
        // SAFETY: all pointers lead to variables of this block, and `init` writes the storage.
        unsafe {
            let made = life::init_abi(storage.as_mut_ptr(), &sound, ABI);
            assert_eq!(made.code, Code::Ok as u32, "{}", text(&made));
            let mut it = storage.assume_init();
            let before = $energy(&it);
            let status = life::retune(&mut it, &later);
            (status, before, $energy(&it), it)
        }
    }};
}

/// Checks that the memory stays; energies are those that the parameters at the start give.
macro_rules! keeps {
    ($block:ident, $sound:expr, $later:expr, $energy:expr) => {{
        use blocks::$block::of_f64::account::observed_energy;
        let (status, before, after, _) = retuned!($block, $sound, $later, observed_energy);
        assert_eq!(status.code, Code::Ok as u32, "{}: {}", stringify!($block), text(&status));
        assert_eq!((before, after), ($energy, $energy), "{}", stringify!($block));
    }};
}

#[test]
fn a_lower_ceiling_is_taken_below_the_start() {
    use blocks::tank::of_f64::{Parameters, account::observed_energy};
    let sound =
        Parameters { start: 2e-3, floor: 5e-4, ceiling: 5e-3, power: 1.0, device_damping: 0.0 };
    for start in [2e-3, NAN, -1.0] {
        keeps!(tank, sound, Parameters { start, ceiling: 2e-3, ..sound }, 1.5e-3);
    }
    let low = Parameters { ceiling: 1e-3, ..sound };
    let (status, _, _, mut tank) = retuned!(tank, sound, low, observed_energy);
    assert_eq!(status.code, Code::Ok as u32, "{}", text(&status));
    let still = PortSample::<f64> { period: 1e-3, ..PortSample::default() };
    let mut out = CorrectionForm::of(&Correction::none(0.0));
    // SAFETY: all pointers lead to variables of this function.
    let energy = unsafe {
        blocks::tank::of_f64::stabilizer::step(&mut tank, &SampleForm::of(&still), 0.0, &mut out);
        observed_energy(&tank)
    };
    // What is above the ceiling goes, and the floor does not count.
    assert!((energy - 5e-4).abs() < 1e-15, "{energy}");
}

#[test]
fn an_energy_tank_keeps_its_energy_up_to_its_ceiling() {
    use blocks::energy_tank::of_f64::{Parameters, drawn::energy};
    let sound = Parameters { start: 2e-3, floor: 0.0, ceiling: 5e-3, power: 1.0 };
    for (ceiling, left) in [(3e-3, 2e-3), (1e-3, 1e-3)] {
        let later = Parameters { start: 1e-4, ceiling, ..sound };
        let (status, before, after, _) = retuned!(energy_tank, sound, later, energy);
        assert_eq!((status.code, before, after), (0, 2e-3, left), "{}", text(&status));
    }
}

/// The value that stands in for a start has no name of its own in a refusal.
#[test]
fn a_floor_above_the_ceiling_is_refused_as_a_floor() {
    use blocks::tank::of_f64::{Parameters, account::observed_energy};
    let sound =
        Parameters { start: 2e-3, floor: 0.0, ceiling: 5e-3, power: 1.0, device_damping: 0.0 };
    let wrong = Parameters { floor: 2e-3, ceiling: 1e-3, ..sound };
    let (status, before, after, _) = retuned!(tank, sound, wrong, observed_energy);
    assert_eq!(text(&status), "floor is 0.002; it must be at most 0.001");
    assert_eq!((before, after), (2e-3, 2e-3));
}

#[test]
fn a_budget_is_not_looked_at() {
    use blocks::{lolc, lolc_custom, lolc_storage, popc, two_layer};
    let (damping_limit, device_damping) = (80.0, 0.5);
    let popc = |budget| popc::of_f64::Parameters { damping_limit, budget };
    keeps!(popc, popc(0.25), popc(NAN), 0.25);
    keeps!(popc, popc(0.25), popc(-1.0), 0.25);
    let lolc = |budget| lolc::of_f64::Parameters { damping_limit, device_damping, budget };
    keeps!(lolc, lolc(0.25), lolc(f64::INFINITY), 0.25);
    let custom = |budget| lolc_custom::of_f64::Parameters { damping_limit, budget };
    keeps!(lolc_custom, custom(0.25), custom(NAN), 0.25);
    let storage = |start| lolc_storage::of_f64::Parameters { damping_limit, start };
    keeps!(lolc_storage, storage(0.25), storage(NAN), 0.0);
    let layer = |start| two_layer::of_f64::Parameters { start, share: 0.0, level: 0.0, gain: 0.0 };
    keeps!(two_layer, layer(0.25), layer(NAN), 0.25);
}

/// Of blocks that are made anew on each call, what was not looked at is not looked at later either.
#[test]
fn a_budget_within_is_not_looked_at() {
    use blocks::windowed_credit::of_f64::{Parameters, account::observed_energy, stabilizer};
    let given = |budget| {
        let lolc =
            blocks::lolc::of_f64::Parameters { damping_limit: 80.0, device_damping: 0.5, budget };
        Parameters { lolc, ticks: 3 }
    };
    let (status, before, after, mut it) =
        retuned!(windowed_credit, given(0.25), given(NAN), observed_energy);
    assert_eq!((status.code, before, after), (0, 0.25, 0.25), "{}", text(&status));
    let still = PortSample::<f64> { period: 1e-3, ..PortSample::default() };
    let mut out = CorrectionForm::of(&Correction::none(0.0));
    // SAFETY: all pointers lead to variables of this function.
    let code = unsafe { stabilizer::step(&mut it, &SampleForm::of(&still), 1.0, &mut out) };
    assert_eq!((code, out.accepted, out.observed_energy), (0, 1, 0.25));
}

#[test]
fn budgets_of_axes_are_not_looked_at() {
    use blocks::lolc::of_f64x3::Parameters as Lolc;
    use blocks::per_axis::of_f64x3::{Block, Parameters, life};
    let of = |budget| Parameters {
        axes: [Lolc { damping_limit: 80.0, device_damping: 0.5, budget }; 3],
    };
    let mut storage = MaybeUninit::<Storage<Block>>::uninit();
    let mut memory = <Block as Kind>::EMPTY;
    // SAFETY: all pointers lead to variables of this function, and `init` writes the storage.
    let codes = unsafe {
        let made = life::init_abi(storage.as_mut_ptr(), &of(0.25), ABI);
        let retuned = life::retune(storage.as_mut_ptr(), &of(NAN));
        [made.code, retuned.code, life::save(storage.as_ptr(), &mut memory)]
    };
    assert_eq!((codes, memory.word.map(f64::from_bits)), ([0; 3], [0.25; 3]));
}
