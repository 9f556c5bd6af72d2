//! The arithmetic of poses over random bytes.

use lyapunov_fuzz::{poses, random};

#[test]
fn poses_of_any_bits_break_no_promise() {
    let seeds = if cfg!(miri) { 20 } else { 60_000 };
    for seed in 0..seeds {
        let bytes = random(seed, (seed * 37 % 1200) as usize);
        assert!(std::panic::catch_unwind(|| poses(&bytes)).is_ok(), "seed {seed}");
    }
}

/// Half a turn in `f32` that libFuzzer found: its three numbers, each rounded, have a length of π and a last place.
#[test]
fn half_a_turn_is_half_a_turn_in_every_scalar() {
    poses(&[
        0xff, 0x13, 0, 0xfe, 0xff, 0xff, 0xff, 0xf9, 0, 0, 0xff, 0x16, 0, 0xff, 0xff, 0, 0, 3, 0,
        0, 0xff, 0xff, 0x16, 0, 0xff, 0xff, 0x9f, 0, 0, 0xff, 0xff, 0xff, 0x16,
    ]);
}
