//! Energy that an environment stores.

use lyapunov::{
    LyapunovCandidate, ParameterError, Signal,
    environments::{ForceLaw, Kinematics},
};

use crate::files::scene::environments::{Environment, Rates, Render};
use crate::files::scene::{Draft, Lanes};

/// The ideal environment of a scene, as a store of energy that is a function of position and velocity.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Reference {
    environment: Environment,
    rates: Rates,
}

impl Reference {
    /// The store of `scene`; none where the environment swings by itself, and in more than one dimension.
    pub(crate) fn of(scene: &Draft) -> Option<Self> {
        let environment = &scene.environment;
        let stores = scene.dimensions() == 1 && environment.kind().frequency().is_none();
        stores.then(|| Self { environment: environment.clone(), rates: Rates::of(scene) })
    }

    /// `S(x, v)` as the scalar `T` has it, J.
    pub(crate) fn stored<T: lyapunov::Scalar>(&self, x: f64, v: f64) -> f64 {
        let stored = Stored { x: T::of(x), v: T::of(v) };
        Self::render(&[self], stored).map_or(0.0, |energy: T| energy.lane(0))
    }

    /// Makes something of the ideal environments of all lanes.
    pub(super) fn render<T: lyapunov::Scalar, R: Render<T>>(
        each: &[&Self],
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let environments: Vec<&Environment> = each.iter().map(|it| &it.environment).collect();
        Environment::on_a_line(&environments, Lanes::new(each).common().rates, to)
    }
}

/// Reading of the energy at one position and velocity.
struct Stored<V> {
    x: V,
    v: V,
}

impl<V: Signal> Render<V> for Stored<V> {
    type Made = V::Scalar;

    fn render(
        self,
        environment: impl ForceLaw<V> + 'static,
        _credit: impl LyapunovCandidate<V> + 'static,
    ) -> Result<V::Scalar, ParameterError> {
        Ok(environment.stored(&Kinematics::at(self.x, self.v)))
    }
}
