//! Integrator chosen at run time.

use lyapunov::{
    ParameterError, Scalar, Signal,
    integrators::{
        Adaptive, DormandPrince5, DormandPrince8, ImplicitMechanics, ImplicitMidpoint, Integrator,
        RungeKuttaNystrom4, SemiImplicitEuler, State,
    },
};

use crate::files::scene::{self, of};

/// Any integrator except the exact one: plants that move exactly have none.
///
/// An enum instead of a box: a plant that holds it stays `Copy`, and each kind of plant is compiled once.
#[derive(Clone, Copy, Debug)]
pub(super) enum AnyIntegrator<T> {
    SemiImplicitEuler,
    ImplicitMidpoint,
    RungeKuttaNystrom4,
    Adaptive5(Adaptive<DormandPrince5, T>),
    Adaptive8(Adaptive<DormandPrince8, T>),
}

impl<T: Scalar> AnyIntegrator<T> {
    /// The integrator that a scene names, with its steps per period; none where the scene asks for exact motion.
    ///
    /// # Errors
    /// A tolerance below what the scalar can keep.
    pub(super) fn of(named: scene::Integrator) -> Result<Option<(Self, u32)>, ParameterError> {
        let in_steps = |integrator| (integrator, named.steps_per_tick().unwrap_or(1));
        Ok(match named {
            scene::Integrator::Exact => None,
            scene::Integrator::SemiImplicitEuler { .. } => Some(Self::SemiImplicitEuler),
            scene::Integrator::ImplicitMidpoint { .. } => Some(Self::ImplicitMidpoint),
            scene::Integrator::Rk4 { .. } => Some(Self::RungeKuttaNystrom4),
            scene::Integrator::Dopri5 { tolerance } => {
                Some(Self::Adaptive5(Adaptive::new(DormandPrince5, of(tolerance))?))
            }
            scene::Integrator::Dop853 { tolerance } => {
                Some(Self::Adaptive8(Adaptive::new(DormandPrince8, of(tolerance))?))
            }
        }
        .map(in_steps))
    }
}

impl<V, D> Integrator<V, D> for AnyIntegrator<V::Scalar>
where
    V: Signal,
    D: ImplicitMechanics<V>,
{
    fn step(
        &mut self,
        dynamics: &D,
        from: State<D::Coordinates>,
        effort: V,
        interval: V::Scalar,
    ) -> State<D::Coordinates> {
        match self {
            Self::SemiImplicitEuler => SemiImplicitEuler.step(dynamics, from, effort, interval),
            Self::ImplicitMidpoint => ImplicitMidpoint.step(dynamics, from, effort, interval),
            Self::RungeKuttaNystrom4 => RungeKuttaNystrom4.step(dynamics, from, effort, interval),
            Self::Adaptive5(pair) => pair.step(dynamics, from, effort, interval),
            Self::Adaptive8(pair) => pair.step(dynamics, from, effort, interval),
        }
    }
}
