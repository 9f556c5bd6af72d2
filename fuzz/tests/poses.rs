//! The arithmetic of poses over random bytes.

use lyapunov_fuzz::{poses, random};

#[test]
fn poses_of_any_bits_break_no_promise() {
    for seed in 0..60_000 {
        let bytes = random(seed, (seed * 37 % 1200) as usize);
        assert!(std::panic::catch_unwind(|| poses(&bytes)).is_ok(), "seed {seed}");
    }
}
