//! The loop that an own stabilizer is made for.

use lyapunov::{DampingLimit, ParameterError, Scalar};

use super::super::kind::Numbers;
use super::super::{Basis, Search};
use super::{OwnNumber, OwnTable};
use crate::files::scene::Scene;

/// The loop that an own stabilizer or candidate is made for, and the numbers that its table writes.
#[derive(Clone, Copy, Debug)]
pub struct Loop<'a> {
    basis: &'a Basis,
    table: &'a OwnTable,
}

impl<'a> Loop<'a> {
    pub(crate) fn new(basis: &'a Basis, table: &'a OwnTable) -> Self {
        Self { basis, table }
    }

    /// The mass guaranteed to move with the port, kg.
    pub fn mass(&self) -> f64 {
        self.basis.limit.port_mass
    }

    /// The servo period T, s.
    pub fn period(&self) -> f64 {
        self.basis.limit.period
    }

    /// The device's own damping, N·s/m.
    pub fn damping(&self) -> f64 {
        self.basis.damping
    }

    /// Whole servo ticks by which a force acts late.
    pub fn delay(&self) -> u32 {
        self.basis.delay
    }

    /// Servo ticks from one evaluation of the environment to the next, 1 or more.
    pub fn environment_ratio(&self) -> u32 {
        self.basis.ratio
    }

    /// One count of the encoder, m; none without an encoder.
    pub fn encoder_count(&self) -> Option<f64> {
        self.basis.count
    }

    /// The energy that the motion starts with, J: the scale of all energies.
    pub fn energy(&self) -> f64 {
        self.basis.energy
    }

    /// The speed at which the moving mass has that energy, m/s.
    pub fn speed(&self) -> f64 {
        self.basis.speed
    }

    /// The damping limit `cap m / T` of this loop, with the `damping_cap` that is written, else the default.
    ///
    /// # Errors
    /// A limit out of the range of the scalar.
    pub fn damping_limit<T: Scalar>(&self) -> Result<DampingLimit<T>, ParameterError> {
        let written = self.table.written(OwnNumber::DAMPING_CAP.key);
        self.basis.limit(written.unwrap_or_else(|| self.default_cap()))
    }

    /// The damping cap where none is written, m / T: half, and less for a force that acts late.
    pub fn default_cap(&self) -> f64 {
        self.basis.limit.cap
    }

    /// The value of `number` in the scalar of the loop: the one that the table writes, else its default.
    pub fn number<T: Scalar>(&self, number: OwnNumber) -> T {
        T::of(self.table.written(number.key).unwrap_or_else(|| (number.default)(self)))
    }

    /// The scene; none in the hard cases that play samples instead of a scene.
    pub fn scene(&self) -> Option<&'a Scene> {
        self.basis.scene.as_deref()
    }

    /// Caps worth a try.
    pub(super) fn caps(&self) -> Option<Search> {
        self.basis.caps()
    }
}
