//! Servo tick of a rollout.

use lyapunov::{Correction, Mask, PortSample, Scalar, Signal};

/// One servo tick of a [`Rollout`](crate::Rollout), along all axes and in all lanes of its signal.
///
/// All reports of a run are derived from these ticks: [`Row`](crate::Row)s, a [`Summary`](crate::Summary), comparisons
/// and energies by cause.
#[derive(Clone, Copy, Debug)]
pub struct Tick<V: Signal> {
    /// Time, s.
    pub time: f64,
    /// The plant's own sample, before any measurement.
    pub truth: PortSample<V>,
    /// The sample that the stabilizer gets.
    pub measured: PortSample<V>,
    /// The environment's effort, N.
    pub environment: V,
    /// The stabilizer's correction.
    pub correction: Correction<V>,
    /// The commanded effort, after saturation, N.
    pub command: V,
    /// The effort applied to the plant until the next tick, after delay, N.
    pub applied: V,
    /// The operator's motion, where a link sets it apart from the device's.
    pub operator: Option<OperatorMotion<V>>,
}

/// Motion of an operator that a link sets apart from the device.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OperatorMotion<V> {
    /// Position, m.
    pub position: V,
    /// Velocity, m/s.
    pub velocity: V,
}

impl<V: Signal> Tick<V> {
    /// The controller's effort as a damper, `α v`, N.
    #[inline(always)]
    pub fn control(&self) -> V {
        self.measured.velocity.scale(self.correction.alpha)
    }

    /// The effort that the stabilizer adds to the environment's, N: `α v` to the bit where that is all it adds.
    #[inline]
    pub(crate) fn added(&self) -> V {
        let (damper, effort) = (self.control(), self.correction.effort);
        if self.environment + damper == effort { damper } else { effort - self.environment }
    }

    /// Whether the sample was accepted and every value of the tick is finite, in the first lane.
    #[inline]
    pub(crate) fn in_range(&self) -> bool {
        Mask::all(self.correction.accepted) && self.finite().lane(0)
    }

    /// The lanes whose sample was accepted and in which every value of the tick is finite.
    #[inline(always)]
    pub(crate) fn sound(&self) -> <V::Scalar as Scalar>::Mask {
        self.correction.accepted & self.finite()
    }

    /// The lanes in which every value of the tick is finite.
    #[inline(always)]
    fn finite(&self) -> <V::Scalar as Scalar>::Mask {
        let Correction { observed_energy: sum, alpha, shortfall, .. } = self.correction;
        let signals = [
            self.truth.position,
            self.measured.position,
            self.measured.velocity,
            self.environment,
            self.control(),
            self.command,
            self.applied,
        ];
        // Zero times a finite number is zero, and zero times anything else is NaN, which stays.
        let zero = V::Scalar::of(0.0);
        let mut nothing = sum * zero + alpha * zero + shortfall * zero;
        for signal in signals {
            nothing += signal.scale(zero).sum();
        }
        if let Some(OperatorMotion { position, velocity }) = self.operator {
            nothing += position.scale(zero).sum() + velocity.scale(zero).sum();
        }
        nothing.finite() & Mask::of(self.time.is_finite())
    }
}
