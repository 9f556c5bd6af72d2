//! Refused parameters under the names of the header.

use std::ffi::CStr;
use std::mem::MaybeUninit;

use lyapunov_c::abi::ABI;
use lyapunov_c::blocks;
use lyapunov_c::limits::of_f64;
use lyapunov_c::status::{Code, Status};
use lyapunov_c::status_text::lyapunov_status_text;

const LOLC: blocks::lolc::of_f64::Parameters =
    blocks::lolc::of_f64::Parameters { damping_limit: 80.0, device_damping: 0.5, budget: 0.0 };

fn text(status: &Status) -> String {
    let mut text = [0; 200];
    // SAFETY: as many bytes can be written there, and the status is the library's.
    unsafe {
        lyapunov_status_text(status, text.as_mut_ptr(), text.len());
        CStr::from_ptr(text.as_ptr()).to_str().unwrap().to_owned()
    }
}

/// Checks that `init` refuses each field, at this value and with the others as given, by its own name.
macro_rules! refused {
    ($block:ident, $module:ident, { $($field:ident: $sound:expr => $wrong:expr),* $(,)? } $($rest:tt)*) => {{
        use blocks::$block::$module::{Block, Parameters, life};
        use lyapunov_c::kept::Storage;
        let sound = Parameters { $($field: $sound,)* $($rest)* };
        $({
            let mut given = sound;
            given.$field = $wrong;
            let mut storage = MaybeUninit::<Storage<Block>>::uninit();
            // SAFETY: both pointers lead to variables of this block.
            let status = unsafe { life::init_abi(storage.as_mut_ptr(), &given, ABI) };
            assert_eq!(status.code, Code::Parameter as u32, "{}", stringify!($block.$field));
            let (told, field) = (text(&status), concat!(stringify!($field), " is "));
            assert!(told.starts_with(field), "{}: {told}", stringify!($block));
        })*
    }};
}

const NAN: f64 = f64::NAN;

#[test]
fn fields_of_controllers_and_refinements_are_named() {
    refused!(popc, of_f64, { damping_limit: 1.0 => -1.0, budget: 0.0 => NAN });
    refused!(lolc, of_f64, { damping_limit: 1.0 => -1.0, device_damping: 0.0 => -1.0, budget: 0.0 => NAN });
    refused!(lolc_custom, of_f64, { damping_limit: 1.0 => -1.0, budget: 0.0 => NAN });
    refused!(lolc_storage, of_f64, { damping_limit: 1.0 => -1.0, start: 0.0 => NAN });
    refused!(lolc_in_contact, of_f64,
        { damping_limit: 1.0 => -1.0, wall_damping: 0.0 => -1.0, surface: 0.0 => NAN, budget: 0.0 => NAN });
    refused!(contact_reset, of_f64, { surface: 0.0 => NAN } lolc: LOLC);
    refused!(bounded_credit, of_f64, { most: 1.0 => -1.0 } lolc: LOLC);
    refused!(windowed_credit, of_f64, { ticks: 2 => 0 } lolc: LOLC);
    refused!(velocity_threshold, of_f64, { velocity: 1.0 => -1.0 } lolc: LOLC);
    refused!(spread, of_f64, { ticks: 2 => 0 } lolc: LOLC);
    refused!(soft_start, of_f64, { ticks: 2 => 0 } lolc: LOLC);
    refused!(rate_limit, of_f64, { rate: 1.0 => -1.0 } lolc: LOLC);
    refused!(axis_weights, of_f64, { weights: 1.0 => -1.0 } lolc: LOLC);
    refused!(plausible, of_f64, { speed: 1.0 => -1.0, effort: 1.0 => -1.0 } lolc: LOLC);
    refused!(watchdog, of_f64, { hold: 1.0 => -1.0, rise: 1.0 => -1.0 } lolc: LOLC);
    refused!(safeguarded, of_f64, {
        most: 1.0 => -1.0, rate: 1.0 => -1.0, speed: 1.0 => -1.0, effort: 1.0 => -1.0, hold: 1.0 => -1.0,
        rise: 1.0 => -1.0,
    } lolc: LOLC);
    refused!(part_limits, of_f64screw, {
        translation_limit: 1.0 => -1.0, rotation_limit: 1.0 => -1.0, translation_damping: 0.0 => -1.0,
        rotation_damping: 0.0 => -1.0, budget: 0.0 => NAN,
    });
    refused!(observer, of_f64, { device_damping: 0.0 => -1.0 });
}

#[test]
fn fields_of_other_members_are_named() {
    refused!(force_bound, of_f64, { damping: 1.0 => -1.0 });
    refused!(force_bounding, of_f64, { damping: 1.0 => -1.0 });
    refused!(tank, of_f64,
        { floor: 0.0 => -1.0, ceiling: 2.0 => NAN, power: 1.0 => -1.0, device_damping: 0.0 => -1.0 } start: 1.0);
    refused!(energy_tank, of_f64, { floor: 0.0 => -1.0, ceiling: 2.0 => NAN, power: 1.0 => -1.0 } start: 1.0);
    refused!(energy_bounding, of_f64, { damping: 1.0 => 0.0, period: 1e-3 => 0.0 } late: 0);
    refused!(least_norm, of_f64, {
        damping_limit: 1.0 => -1.0, decay: 0.5 => -1.0, device_damping: 0.0 => -1.0, budget: 0.0 => NAN,
    });
    refused!(slope_bound, of_f64, { slope: 1.0 => 0.0, creep: 0.0 => -1.0 });
    refused!(memory_based, of_f64, { surface: 0.0 => NAN, depth: 1.0 => 0.0 } late: 0);
    refused!(path_memory, of_f64, { surface: 0.0 => NAN, depth: 1.0 => 0.0 });
    refused!(two_port_side, of_f64, { damping_limit: 1.0 => -1.0 });
    refused!(drift_compensated, of_f64,
        { mobility_limit: 1.0 => -1.0, speed: 1.0 => -1.0, impedance: 1.0 => -1.0 });
    refused!(two_layer, of_f64,
        { start: 1.0 => -1.0, share: 0.5 => 2.0, level: 1.0 => -1.0, gain: 1.0 => -1.0 });
    refused!(wave_transform, of_f64, { impedance: 1.0 => 0.0 });
    refused!(wave_filter, of_f64, { share: 0.5 => 2.0 });
    refused!(wave_follower, of_f64, { impedance: 1.0 => 0.0, stiffness: 1.0 => -1.0, damping: 1.0 => -1.0 });
}

#[test]
fn fields_of_readings_are_named() {
    refused!(readings, of_f64, { period: 1e-3 => 0.0, fastest: 1.0 => 0.0 });
    refused!(readings_low_passed, of_f64, { cutoff: 30.0 => 0.0 } period: 1e-3, fastest: 1.0);
    refused!(readings_windowed, of_f64, { ticks: 4 => 0, band: 1e-6 => -1.0 } period: 1e-3, fastest: 1.0);
    refused!(readings_of_poses, of_f64screw,
        { period: 1e-3 => 0.0, fastest_translation: 1.0 => 0.0, fastest_rotation: 1.0 => 0.0 });
}

#[test]
fn arguments_of_limits_are_named() {
    let mut limit = 0.0;
    let (mass, stiffness) = (of_f64::of_mass, of_f64::of_stiffness);
    // SAFETY: the pointer leads to a variable of this function.
    let told = unsafe {
        [
            (mass(-1.0, 0.2, 1e-3, 0, &mut limit), "cap is -1;"),
            (mass(0.5, -1.0, 1e-3, 0, &mut limit), "mass is -1;"),
            (mass(0.5, 0.2, -1.0, 0, &mut limit), "period is -1;"),
            (stiffness(-1.0, 100.0, 1e-3, 0, &mut limit), "cap is -1;"),
            (stiffness(0.5, -1.0, 1e-3, 0, &mut limit), "stiffness is -1;"),
        ]
    };
    for (status, begins) in told {
        assert!(text(&status).starts_with(begins), "{}", text(&status));
    }
}
