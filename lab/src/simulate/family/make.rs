//! Construction of each stabilizer of the family.

use lyapunov::{
    DampingLimit, Dissipation, Lolc, LyapunovCandidate, ParameterError, Popc, PortEnergy, Scalar,
    StorageFunction,
    accumulators::Plain,
    candidates::InContact,
    environments::{ForceLaw, Kinematics},
    stabilizers::{
        ForceBound, NoStabilizer, ReferenceFollowing, StabilizerExt, Tank, TankLimits,
        WindowedCredit,
    },
};

use super::basis::SLOTS;
use super::{BasicName, Basis, StabilizerName};
use crate::files::scene::{Render, Scene};
use crate::simulate::building::{AnyStabilizer, Space};

/// Most that a tank holds, as a multiple of the energy that the motion starts with.
const CEILING: f64 = 2.0;

impl StabilizerName {
    /// The stabilizer on the loop of `scene`, whatever `scene` names.
    ///
    /// # Errors
    /// A parameter that is right by itself but out of the range of the scalar, alone or with others; a scene without
    /// what the stabilizer [needs](Self::fits).
    pub fn on<T: Scalar + Space>(self, scene: &Scene) -> Result<AnyStabilizer<T>, ParameterError> {
        match self {
            Self::Basic(basic_name) => basic_name.made(scene),
            _ => self.set_by(&Basis::of(scene)),
        }
    }

    /// The stabilizer set by `basis`, without a scene: LOLC credits the device's damping, whatever its candidate.
    pub(crate) fn set_by<T: Scalar + Space>(
        self,
        basis: &Basis,
    ) -> Result<AnyStabilizer<T>, ParameterError> {
        let of = T::of;
        let limit = basis.limit.limit()?;
        let popc = Popc::new(PortEnergy, limit);
        let (energy, ticks) = (of(basis.energy), basis.ticks());
        Ok(match self {
            Self::Basic(BasicName::NoStabilizer) => AnyStabilizer::called(NoStabilizer),
            Self::Basic(BasicName::Popc | BasicName::LolcSpring) => AnyStabilizer::called(popc),
            Self::Basic(_) => {
                let damper = Dissipation::of(of(basis.damping))?;
                AnyStabilizer::called(Lolc::new((PortEnergy, damper), limit))
            }
            Self::Budgeted => AnyStabilizer::called(popc.budgeted(of(basis.stored()))?),
            Self::Bounded => AnyStabilizer::called(popc.bounded(energy)?),
            Self::Windowed => {
                let sum = WindowedCredit::<T, Plain<T>, SLOTS>::of_ticks(basis.slot())?;
                AnyStabilizer::called(popc.summed_by(sum))
            }
            Self::ContactReset => {
                // An environment without a surface is in contact throughout.
                let position = of(basis.surface.unwrap_or(f64::NEG_INFINITY));
                AnyStabilizer::called(popc.reset_at(InContact { position }))
            }
            Self::Threshold => AnyStabilizer::called(popc.above_velocity(of(basis.threshold()))?),
            Self::Spread => AnyStabilizer::called(popc.spread_over::<T>(ticks)?),
            Self::RateLimited => AnyStabilizer::called(popc.rate_limited::<T>(of(basis.rate()))?),
            Self::Rising => AnyStabilizer::called(popc.rising_over::<T>(ticks)?),
            Self::Reference => {
                let following = Following { limit, start: basis.start.map(of) };
                match &basis.reference {
                    None => following.of(|_, _| T::zero()),
                    Some(reference) => reference.render(following)?,
                }
            }
            Self::ForceBound => {
                AnyStabilizer::called(ForceBound::new(of(basis.damping))?.budgeted(energy)?)
            }
            Self::Tank => {
                let (floor, power) = (T::zero(), of(f64::INFINITY));
                let store =
                    TankLimits { start: energy, floor, ceiling: of(CEILING) * energy, power };
                AnyStabilizer::called(Tank::new(PortEnergy, store)?)
            }
            Self::EnergyBounding => basis.energy_bounding()?,
            Self::ForceBounding => basis.force_bounding()?,
            Self::MemoryBased => basis.memory_based()?,
            Self::ReferenceFollowing => basis.reference_following()?,
            Self::LeastNorm => basis.least_norm()?,
        })
    }
}

/// Builder of the stabilizer whose energy follows a store, starting from a position and a velocity.
struct Following<T: Scalar> {
    limit: DampingLimit<T>,
    start: [T; 2],
}

impl<T: Scalar + Space> Following<T> {
    fn of(self, stored: impl Fn(T, T) -> T + 'static) -> AnyStabilizer<T> {
        let [x, v] = self.start;
        let stored = StorageFunction::starting(stored, x, v);
        AnyStabilizer::called(ReferenceFollowing::new((PortEnergy, stored), self.limit))
    }
}

impl<T: Scalar + Space> Render<T> for Following<T> {
    type Made = AnyStabilizer<T>;

    fn render(
        self,
        environment: impl ForceLaw<T> + 'static,
        _credit: impl LyapunovCandidate<T> + 'static,
    ) -> Result<AnyStabilizer<T>, ParameterError> {
        Ok(self.of(move |x, v| environment.stored(&Kinematics::at(x, v))))
    }
}
