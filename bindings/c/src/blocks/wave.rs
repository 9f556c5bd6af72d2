//! Waves: a channel that delays them stays passive.

use lyapunov::stabilizers::{WaveFilter, WaveFollower, WaveTransform};

use crate::answered::{Fixed, WaveForm};
use crate::export::blocks;

blocks! {
    /// Wave transformation (WaveTransform): waves of a flow v and an effort F, and the other way round. With the impedance b
    /// the wave there is (b v + F) / sqrt(2 b), the one back (b v - F) / sqrt(2 b), and the power F v is (there^2 - back^2) / 2. It
    /// has no memory, and what is not finite comes out so.
    wave_transform on every = {
        "wave_transform";
        Fixed<WaveTransform<T>>, whole 2 + 0;
        {
            /// The wave impedance, N.s/m.
            impedance: T,
        };
        |given| WaveTransform::new(given.impedance).map(Fixed);
        [life wave]
    }
    /// Low pass in the path of a wave (WaveFilter).
    wave_filter on every = {
        "wave_filter";
        WaveFilter<V>, whole 1 + 1;
        {
            /// The share of a change that is taken over on each tick, above 0 and at most 1.
            share: T,
        };
        |given| WaveFilter::new(given.share);
        [life wave_filter]
    }
    /// Slave behind a wave (WaveFollower): a spring and a damper that solve for the flow they are commanded. A damping as large as the
    /// impedance is matched, and reflects nothing. It has no memory.
    wave_follower on every = {
        "wave_follower";
        Fixed<WaveFollower<T>>, whole 4 + 0;
        {
            /// The wave impedance, N.s/m.
            impedance: T,
            /// The spring, N/m.
            stiffness: T,
            /// The damper, N.s/m.
            damping: T,
        };
        |given| {
            let wave = WaveTransform::new(given.impedance)?;
            WaveFollower::new(wave, given.stiffness, given.damping).map(Fixed)
        };
        [life wave_follower]
    }
}
