//! The passivity observer/controller.

use lyapunov_core::{Held, Plain, PortEnergy};

use crate::Lolc;

/// Passivity observer/controller of Hannaford and Ryu (IEEE Transactions on Robotics and Automation
/// 18(1), 2002): the Lyapunov observer/controller whose candidate is the port's own energy and nothing else.
///
/// ```
/// use lyapunov_core::PortEnergy;
/// use lyapunov_stabilizers::{DampingLimit, Popc};
/// let popc: Popc<f64> = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
/// # let _ = popc;
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
pub type Popc<T, W = Held, A = Plain<T>> = Lolc<T, PortEnergy, W, A>;
