//! The damping limit of a scene.

use lyapunov::{DampingLimit, ParameterError, Scalar};

use super::lanes::numbers;
use super::{Cap, Draft};

/// The factors of a loop's damping limit `cap · port_mass / T`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Damping {
    /// The cap: the limit as a share of `port_mass / T`.
    pub(crate) cap: f64,
    /// The mass guaranteed to move with the port, kg.
    pub(crate) port_mass: f64,
    /// The servo period T, s.
    pub(crate) period: f64,
}

impl Damping {
    /// The cap where none is written, for a force that acts `ticks` late: half of `m / T`, times the factor of
    /// [`DampingLimit::delayed`].
    pub(crate) fn default_cap(ticks: u32) -> f64 {
        // A limit of 0.5 N·s/m stands for the share of m / T.
        let half: Result<DampingLimit<f64>, _> = DampingLimit::at(Cap::default().get());
        half.map_or(0.0, |half| half.delayed(ticks).most())
    }

    /// The limit in the scalar of the loop.
    pub(crate) fn limit<T: Scalar>(self) -> Result<DampingLimit<T>, ParameterError> {
        Self::limit_of_lanes(&|_| self)
    }

    /// The limit of each lane.
    pub(crate) fn limit_of_lanes<T: Scalar>(
        lane: &dyn Fn(usize) -> Self,
    ) -> Result<DampingLimit<T>, ParameterError> {
        let lanes: Vec<Self> = (0..T::LANES).map(lane).collect();
        let each = |number: fn(Self) -> f64| numbers(&mut |index| number(lanes[index]));
        DampingLimit::of_mass(each(|it| it.cap), each(|it| it.port_mass), each(|it| it.period))
    }
}

impl Draft {
    /// The mass in kg guaranteed to move with the port: the device's, plus the operator's if no link is between them.
    pub fn port_mass(&self) -> f64 {
        let operator = if self.link.is_some() { 0.0 } else { self.operator.mass.get() };
        operator + self.device.mass.get()
    }

    /// The ticks by which a force acts late.
    pub fn delay_ticks(&self) -> u32 {
        self.effects.delay.map_or(0, |delay| delay.ticks.get().into())
    }

    /// The damping cap, m / T, that the scene's stabilizer writes, whichever it is.
    pub fn written_cap(&self) -> Option<f64> {
        self.stabilizer.and_then(|it| it.written("damping_cap"))
    }

    /// The damping cap of the scene, m / T: the one that it writes, else the default for its delay.
    pub fn damping_cap(&self) -> f64 {
        self.written_cap().unwrap_or_else(|| self.default_cap())
    }

    /// The damping cap where none is written, m / T, for the delay of the scene.
    pub fn default_cap(&self) -> f64 {
        Damping::default_cap(self.delay_ticks())
    }

    /// The limit of the cap for the delay of the scene, m / T, where the cap that is written lies above it.
    pub fn exceeded_cap(&self) -> Option<f64> {
        let limit = self.default_cap();
        let is_above = self.written_cap().is_some_and(|cap| cap > limit);
        (self.delay_ticks() > 0 && is_above).then_some(limit)
    }

    /// The factors of this loop's damping limit, for a stabilizer with the damping cap `cap`.
    pub(crate) fn damping(&self, cap: f64) -> Damping {
        Damping { cap, port_mass: self.port_mass(), period: self.period() }
    }
}
