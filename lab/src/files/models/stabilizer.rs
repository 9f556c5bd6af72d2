//! What the stabilizers of a model are set to.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::files::scene::{Cap, NonNegative};

/// What the stabilizers of a model are set to.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Stabilizer {
    /// Limit of the injected damping in units of m / T, with m the least apparent mass of the plant's port, 0 or more,
    /// inf for no limit; default 0.5.
    pub damping_cap: Cap,
    /// Rate c in 1/s at which V is asked to decay by the entrant that asks for it, 0 or more; default 0.
    pub decay: NonNegative,
}
