//! Every member of the family, with the parameters that bytes spell.

mod bounding;
mod channel;
mod chosen;
mod damping;
mod several_axes;

use lyapunov_core::{ParameterError, PortEnergy};
use lyapunov_stabilizers::{DampingLimit, Popc, TankLimits};

use crate::{Bytes, Real};

/// The number of ticks that were driven, or the parameter that was refused.
pub type Driven = Result<usize, ParameterError>;

/// Member of the family.
#[derive(Clone, Copy, Debug)]
pub struct Member {
    /// Its name in `tests/embedded`; there `popc-member` is POPC, and here any member.
    pub name: &'static str,
    /// Makes and drives it by bytes, and panics where a promise is broken.
    pub run: fn(&mut Bytes<'_>) -> Driven,
}

/// All of them.
pub fn members<T: Real>() -> Vec<Member> {
    let mut members = Vec::new();
    damping::list::<T>(&mut members);
    bounding::list::<T>(&mut members);
    channel::list::<T>(&mut members);
    several_axes::list::<T>(&mut members);
    chosen::list::<T>(&mut members);
    members
}

/// Any limit that one of the constructors gives.
fn limit<T: Real>(bytes: &mut Bytes<'_>) -> Result<DampingLimit<T>, ParameterError> {
    let kind = bytes.byte();
    let limit = match kind % 4 {
        0 => DampingLimit::of_mass(bytes.parameter(), bytes.positive(), bytes.positive()),
        1 => DampingLimit::of_stiffness(bytes.parameter(), bytes.positive(), bytes.positive()),
        _ => DampingLimit::at(bytes.parameter()),
    }?;
    Ok(limit.delayed(u32::from(kind >> 6)))
}

fn popc<T: Real>(bytes: &mut Bytes<'_>) -> Result<Popc<T>, ParameterError> {
    Ok(Popc::new(PortEnergy, limit(bytes)?))
}

fn store<T: Real>(bytes: &mut Bytes<'_>) -> TankLimits<T> {
    let [floor, above, room, power] = [(); 4].map(|()| bytes.parameter());
    TankLimits { start: floor + above, floor, ceiling: floor + above + room, power }
}
