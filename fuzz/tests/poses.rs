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
