//! A stabilizer of the family by its name, and its promises.

use lyapunov::{Dissipation, Lolc, Popc, PortEnergy, Scalar, stabilizers::NoStabilizer};

use super::trial::HardError;
use crate::files::scene::{Basis, Pledge, Scene, Stabilizer};
use crate::simulate::family::{BasicName, StabilizerName};
use crate::simulate::{AnyStabilizer, Fitted, Instructions, Space};

/// The stabilizer called `member`, set by `basis`, without a scene: LOLC credits the device's damping, whatever its
/// candidate.
///
/// # Errors
/// [`HardError::NoPart`] of one that this loop cannot have; a parameter out of the range of the scalar.
pub(super) fn set_by<T: Scalar + Space>(
    member: StabilizerName,
    basis: &Basis,
) -> Result<AnyStabilizer<T>, HardError> {
    let limit = basis.limit.limit()?;
    match member {
        StabilizerName::Basic(BasicName::NoStabilizer) => Ok(AnyStabilizer::called(NoStabilizer)),
        StabilizerName::Basic(BasicName::Popc | BasicName::LolcSpring) => {
            Ok(AnyStabilizer::called(Popc::new(PortEnergy, limit)))
        }
        StabilizerName::Basic(_) => {
            let damper = Dissipation::of(T::of(basis.damping))?;
            Ok(AnyStabilizer::called(Lolc::new((PortEnergy, damper), limit)))
        }
        StabilizerName::Member(_) | StabilizerName::Own(_) => {
            let table = member.bare_table().filter(|table| table.kind().lacks(basis).is_none());
            let table = table.ok_or(HardError::NoPart)?;
            match Fitted::on_bases(std::slice::from_ref(basis), &[table], Instructions::Base)? {
                Fitted::Behind(stabilizer) => Ok(stabilizer),
                // The samples of these cases come without an environment that could be asked.
                Fitted::Around(_) => Err(HardError::NoPart),
            }
        }
    }
}

/// Pledge of `member` with the parameters of `basis`, in a scalar like `T`, without a scene: LOLC credits the device's
/// damping, whatever its candidate.
pub(super) fn pledge_of<T: Scalar>(member: StabilizerName, basis: &Basis) -> Pledge {
    match member {
        StabilizerName::Basic(
            BasicName::NoStabilizer | BasicName::Popc | BasicName::LolcSpring,
        ) => Pledge::POPC,
        StabilizerName::Basic(_) => in_scalar::<T>(Pledge::damper(basis.damping)),
        StabilizerName::Member(_) | StabilizerName::Own(_) => {
            let pledge = member.bare_table().map(|table| table.kind().pledge(basis));
            pledge.map_or(Pledge::POPC, in_scalar::<T>)
        }
    }
}

/// Pledge of the stabilizer with this table on the loop of `scene`.
pub(super) fn pledge_on<T: Scalar>(table: Option<Stabilizer>, scene: &Scene) -> Pledge {
    let pledge = table.map(|table| table.kind().pledge(&Basis::of(scene)));
    pledge.map_or(Pledge::POPC, in_scalar::<T>)
}

/// The stabilizer credits each number as its scalar rounds it.
fn in_scalar<T: Scalar>(pledge: Pledge) -> Pledge {
    pledge.rounded(|number| T::of(number).lane(0))
}

/// Whether `member` makes the promises of POPC in the catalogue: it serves every debt at once, and credits nothing
/// that may not have been dissipated.
pub(super) fn promises(member: StabilizerName) -> bool {
    match member {
        StabilizerName::Basic(basic_name) => {
            matches!(
                basic_name,
                BasicName::Popc | BasicName::LolcSpring | BasicName::LolcDeviceDamping
            )
        }
        StabilizerName::Member(_) | StabilizerName::Own(_) => {
            member.bare_table().is_some_and(|table| table.kind().promises())
        }
    }
}
