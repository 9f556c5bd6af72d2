//! The input-to-state stable port.

use lyapunov::{ParameterError, Scalar, Signal, stabilizers::InputToState};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Pace, Pledge, Search};

/// The slope as a multiple of the environment's, as in the public implementation.
const SHARE: f64 = 1.7;

/// The feed-forward of the rate, s, as in the public implementation.
const FEED: f64 = 5e-3;

/// The default for the slope of an environment; one that does not answer to its position is asked at the device.
fn beyond(slope: f64) -> f64 {
    if slope > 0.0 { SHARE * slope } else { f64::INFINITY }
}

table! {
    /// Input-to-state stable approach (Jafari and Ryu 2015): a port around the environment, which it asks a little
    /// before the device is there.
    Iss = "iss" {
        words {}
        numbers {
            /// Largest slope mu of the environment in N/m, greater than 0, inf asks the environment at the device;
            /// default: 1.7 times that of the environment, followed as it is seen where that has no bound.
            slope: PositiveLimit, "N/m", "slope = 3400.0  # N/m",
            |_, on| on.steepest.map_or(f64::NAN, beyond),
            |_, on| on.steepest.and_then(|slope| Search::ratios(1.05 * slope, 20.0 * slope));
            /// Feed-forward tau of the force's rate in s, 0 or more; default 0.005.
            feed: NonNegative, "s", "feed = 0.005  # s",
            |_, _| FEED, |at, _| Search::ratios(0.02 * at, 10.0 * at);
        }
    }
}

impl StabilizerKind for Iss {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge::ANSWERING
    }

    fn reports_damping(&self) -> bool {
        false
    }

    fn assumes(&self) -> Option<&'static str> {
        Some("an environment whose force its position alone determines, without energy of its own")
    }

    fn shape(&self, on: &Basis) -> u32 {
        self.slope(on).is_nan().into()
    }
}

impl Anywhere for Iss {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let (slope, feed) = (on.each(Self::slope), on.each(Self::feed));
        Ok(if on.own().slope(on.common()).is_nan() {
            let share = V::Scalar::of(SHARE);
            to.around(Pace::Environment, move |port| InputToState::adaptive(port, share, feed))
        } else {
            to.around(Pace::Environment, move |port| InputToState::new(port, slope, feed))
        })
    }
}
