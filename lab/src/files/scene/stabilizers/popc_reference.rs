//! The passivity observer/controller that follows what the environment stores.

use lyapunov::{
    DampingLimit, LyapunovCandidate, ParameterError, PortEnergy, Scalar, StorageFunction,
    environments::{ForceLaw, Kinematics},
    stabilizers::{ReferenceDamper, ReferenceFollowing as Law},
};

use super::begun::Begun;
use super::kind::{Install, OnALine, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Pledge, Reference};
use crate::files::scene::environments::Render;

table! {
    /// The passivity observer/controller, whose energy follows what the environment stores.
    PopcReference = "popc-reference" {
        words {}
        numbers {
            damping_cap;
        }
    }
}

impl StabilizerKind for PopcReference {
    fn pledge(&self, on: &Basis) -> Pledge {
        Pledge::on_reference(on)
    }

    fn promises(&self) -> bool {
        true
    }

    fn shape(&self, on: &Basis) -> u32 {
        on.reference.is_some().into()
    }
}

impl OnALine for PopcReference {
    fn make<T: Scalar, R: Install<T>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let limit = on.limit(Self::damping_cap)?;
        follow(on, limit, None, to)
    }
}

/// Reference energy following on a loop: of what the environment stores, and of what the ideal wall's damper (N·s/m,
/// and where it begins, m) dissipates if one is given.
pub(super) fn follow<T: Scalar, R: Install<T>>(
    on: OnLoops<'_, impl StabilizerKind>,
    limit: DampingLimit<T>,
    damper: Option<[T; 2]>,
    to: R,
) -> Result<R::Made, ParameterError> {
    let following = Following { limit, damper, to };
    let references: Option<Vec<&Reference>> =
        on.pairs().map(|(_, on)| on.reference.as_ref()).collect();
    match references {
        None => following.of(|_, _| T::zero()),
        Some(references) => Reference::render(&references, following),
    }
}

/// Reference of a store and a damper, from the first sample on.
struct Following<T: Scalar, R> {
    limit: DampingLimit<T>,
    damper: Option<[T; 2]>,
    to: R,
}

impl<T: Scalar, R: Install<T>> Following<T, R> {
    fn of(self, stored: impl Fn(T, T) -> T + 'static) -> Result<R::Made, ParameterError> {
        let anywhere = T::zero();
        let stored = StorageFunction::starting(stored, anywhere, anywhere);
        let Some(damper) = self.damper else {
            return Ok(self.to.behind(Law::new((PortEnergy, Begun::new(stored)), self.limit)));
        };
        let [damping, surface] = damper;
        let depth = move |x: T| (x - surface).larger(T::zero());
        let damper = ReferenceDamper::starting(damping, depth, anywhere)?;
        let ideal = Begun::new((stored, damper));
        Ok(self.to.behind(Law::new((PortEnergy, ideal), self.limit)))
    }
}

impl<T: Scalar, R: Install<T>> Render<T> for Following<T, R> {
    type Made = R::Made;

    fn render(
        self,
        environment: impl ForceLaw<T> + 'static,
        _credit: impl LyapunovCandidate<T> + 'static,
    ) -> Result<R::Made, ParameterError> {
        let stored = move |x, v| environment.stored(&Kinematics::at(x, v));
        #[cfg(not(feature = "every-scalar"))]
        let stored: Box<dyn Fn(T, T) -> T> = Box::new(stored);
        self.of(stored)
    }
}
