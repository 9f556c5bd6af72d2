//! Sides of a teleoperator: each end of a channel has one.

use lyapunov::stabilizers::{DriftCompensated, Sharing, TwoLayer, TwoPortSide};

use crate::export::blocks;
use crate::limits::limit;
use crate::named::named;

blocks! {
    /// Side of a two-port (TwoPortSide): send `absorbed` to the other side on every tick, and give `receive` what came. Where force comes
    /// in and motion goes out, as at a slave, `velocity` of the sample is the measured force (N), `displacement` its impulse (N.s),
    /// `position` the sum of the impulses, `applied` the velocity that was applied (m/s); efforts in and out are velocities, `alpha` and
    /// the limit mobilities, m/(N.s). README.md has it as a table.
    two_port_side on every = {
        "two_port_side";
        TwoPortSide<V>, whole 5 + 1;
        {
            /// Largest damping, N.s/m.
            damping_limit: T,
        };
        |given| Ok(TwoPortSide::new(limit(given.damping_limit)?));
        [life stabilizer account side]
    }
    /// Side of a two-port with an admittance, which makes up for the drift of its commanded motion (DriftCompensated). `velocity` of the
    /// sample is the measured force (N), `displacement` its impulse (N.s), `position` the sum of the impulses, `applied` the velocity
    /// that was applied (m/s); efforts in and out are velocities, `alpha` is a mobility, m/(N.s). README.md has it as a table.
    drift_compensated on every = {
        "drift_compensated";
        DriftCompensated<TwoPortSide<V>, V>, whole 7 + 2;
        {
            /// Largest mobility, m/(N.s), as `damping_limit_..._of_stiffness` gives it; infinity: no limit.
            mobility_limit: T,
            /// The largest speed of compensation on each axis, m/s; infinity: no limit.
            speed: T,
            /// The impedance that compensation meets, N.s/m; 0 if it is not known.
            impedance: T,
        };
        |given| {
            let side = TwoPortSide::new(named("mobility_limit", limit(given.mobility_limit))?);
            DriftCompensated::new(side, given.speed)?.meeting(given.impedance)
        };
        [life stabilizer account side]
    }
    /// Side of a two-layer architecture (TwoLayer): send `sent` to the other side, and give `receive` what came. A slave has a
    /// level and a gain of 0.
    two_layer on every = {
        "two_layer";
        TwoLayer<T>, whole 7 + 0;
        {
            /// Energy at the start, J. Only init reads it: `retune` does not, and later there is `grant`.
            start: T => 0.0,
            /// The share of the tank that is sent on every tick, 0 to 1.
            share: T,
            /// The level that the master fills its tank to, J.
            level: T,
            /// The gain of the damper that fills it, N.s/(m.J).
            gain: T,
        };
        |given| {
            let sharing = Sharing { start: given.start, share: given.share };
            TwoLayer::master(sharing, given.level, given.gain)
        };
        [life stabilizer account layer]
    }
}
