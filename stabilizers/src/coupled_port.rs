//! Virtual coupling: a spring and a damper between the device and what it touches.

use lyapunov_core::{
    Correction, HeldTick, OnePort, ParameterError, PortSample, Requirement, Scalar, Signal,
    Snapshot,
};

/// Spring and dampers of a [`CoupledPort`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VirtualCoupling<T> {
    /// The spring between device and proxy, N/m.
    pub stiffness: T,
    /// The damper between device and proxy, N·s/m.
    pub damping: T,
    /// The damper on the proxy alone, N·s/m.
    pub drag: T,
}

#[cfg(feature = "approx")]
lyapunov_core::approximate!(impl[T: PartialEq] VirtualCoupling<T>, of T { stiffness, damping, drag });

impl<T: Scalar> VirtualCoupling<T> {
    /// The same coupling, checked.
    fn checked(self) -> Result<Self, ParameterError> {
        Requirement::Positive.check("coupling stiffness", self.stiffness)?;
        Requirement::NonNegative.check("coupling damping", self.damping)?;
        Requirement::NonNegative.check("proxy drag", self.drag)?;
        Ok(self)
    }

    /// The least viscous damping of a device that renders this coupling passively, N·s/m: `K T / 2 + B`.
    pub fn device_damping(self, period: T) -> T {
        T::of(0.5) * self.stiffness * period + self.damping
    }
}

/// A port behind a virtual coupling: the device pulls a massless proxy by a spring and a damper, and it is the proxy that touches the
/// environment.
///
/// With `e = x − x_p` the deflection, `u_p` the proxy's displacement on this tick, `K`, `B` the coupling's stiffness and
/// damping and `c` the proxy's drag, the proxy goes where the forces on it balance:
///
/// ```text
/// f(n) = K e(n) + B (e(n) − e(n−1)) / T = f_env(n−1) + c u_p(n) / T
/// e(n) = (f_env(n−1) + c Δx(n) / T + (B + c) e(n−1) / T) / (K + (B + c) / T)
/// ```
///
/// `f(n)` is what the device feels; then the environment is asked at `x_p(n) = x(n) − e(n)`, once a tick. At rest that is the
/// series of coupling and environment, `1 / (1 / K + 1 / k)` for a spring `k`.
///
/// **Passive** (derived here; time domain, all axes). Assume that proxy and environment absorb:
/// `Σ f(n) · u_p(n)` is bounded from below. Then device and coupling do, `Σ (b |Δx(n+1)|² / T + f(n) · Δx(n+1))`, if
/// `b ≥ K T / 2 + B`: the condition of Colgate and Schenkel for the coupling alone, whatever is behind it. For by parts
/// `Σ f(n) · (Δx(n+1) − Δx(n)) = −Σ Δx(n) · (f(n) − f(n−1))` up to the ends, which is at most
/// `(K / 2 + B / T) Σ (|Δx|² + |Δe|²)`, and `f(n) · Δe(n)` pays for the second. The assumption holds for every spring that is
/// no stiffer than `k`, walls included, if `c ≥ k T / 2`, and for a spring with a damper `B_e` if `c ≥ k T / 2 + B_e`.
///
/// So the coupling is chosen by the device and the drag by the environment, which may be far stiffer than the device
/// can render.
/// What it costs: a wall feels no stiffer than `K`, and free motion feels the drag. An environment that is not passive by
/// itself (late, driven, or too stiff for the drag) stays what it is.
///
/// Colgate, Stanley and Brown (IEEE/RSJ International Conference on Intelligent Robots and Systems, 1995) put a virtual coupling
/// between a device and a virtual tool; Adams and Hannaford (IEEE Transactions on Robotics and Automation 15(3), 1999) choose it by
/// two-port theory. A tool with mass is left out here.
///
/// A deflection or an answer that is not finite is told once and then forgotten.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{HeldTick, PortSample, OnePort};
/// use lyapunov_stabilizers::{CoupledPort, VirtualCoupling};
/// struct Spring(f64); // N/m
/// impl OnePort<f64> for Spring {
///     fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
///         self.0 * sample.position
///     }
/// }
/// let coupling = VirtualCoupling { stiffness: 1000.0_f64, damping: 0.1, drag: 5.0 };
/// assert_abs_diff_eq!(coupling.device_damping(1e-3), 0.6, epsilon = 1e-12); // N·s/m
/// let mut port = CoupledPort::new(Spring(9000.0), coupling)?;
/// let mut force = port.respond(&HeldTick {
///     period: 1e-3, position: 1e-3, velocity: 1.0, displacement: 1e-3, applied: 0.0
/// }.sample());
/// for _ in 0..100 {
///     force = port.respond(&HeldTick {
///         period: 1e-3, position: 1e-3, velocity: 0.0, displacement: 0.0, applied: force
///     }.sample());
/// }
/// assert_abs_diff_eq!(force, 0.9, epsilon = 1e-9); // 1 mm on 900 N/m
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct CoupledPort<P, V: Signal> {
    port: P,
    coupling: VirtualCoupling<V::Scalar>,
    deflection: V,
    answer: V,
}

impl<P, V: Signal> CoupledPort<P, V> {
    /// `port` behind `coupling`, relaxed.
    ///
    /// # Errors
    /// A stiffness not above 0 and finite; a damping or drag below 0, infinite or NaN.
    pub fn new(port: P, coupling: VirtualCoupling<V::Scalar>) -> Result<Self, ParameterError> {
        let coupling = coupling.checked()?;
        Ok(Self { port, coupling, deflection: V::zero(), answer: V::zero() })
    }

    /// The coupling.
    pub fn coupling(&self) -> VirtualCoupling<V::Scalar> {
        self.coupling
    }

    /// Changes the coupling between ticks. The deflection stays, so a stiffer spring holds more energy at once: as
    /// `Δk / 2` times its square, and the device may get that back.
    ///
    /// # Errors
    /// As [`new`](Self::new); the old one stays.
    pub fn set_coupling(
        &mut self,
        coupling: VirtualCoupling<V::Scalar>,
    ) -> Result<(), ParameterError> {
        self.coupling = coupling.checked()?;
        Ok(())
    }

    /// The port inside.
    pub fn port(&self) -> &P {
        &self.port
    }

    /// The port inside, to be changed between ticks.
    pub fn port_mut(&mut self) -> &mut P {
        &mut self.port
    }

    /// Distance of the device ahead of the proxy, m.
    #[inline]
    pub fn deflection(&self) -> V {
        self.deflection
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for CoupledPort<P, V> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let VirtualCoupling { stiffness, damping, drag } = self.coupling;
        // A period that is none makes the answer NaN, as a period that is NaN does.
        let unknown = V::Scalar::of(f64::NAN);
        let period = V::Scalar::choose(sample.timed(), sample.period, unknown);
        let (damper, drag) = (damping / period, drag / period);
        let share = V::Scalar::of(1.0) / (stiffness + damper + drag);
        let pulled = sample.displacement.scale(drag) + self.deflection.scale(damper + drag);
        let deflection = (self.answer + pulled).scale(share);
        let stretched = deflection - self.deflection;
        let moved = sample.displacement - stretched;
        let felt = deflection.scale(stiffness) + stretched.scale(damper);

        let rate = V::Scalar::of(1.0) / period;
        let position = sample.position - deflection;
        let proxy = HeldTick {
            period,
            position,
            velocity: moved.scale(rate),
            displacement: moved,
            applied: self.answer,
        }
        .sample();
        let answer = self.port.respond(&proxy);
        self.deflection = V::choose(deflection.finite(), deflection, self.deflection);
        self.answer = V::choose(answer.finite(), answer, self.answer);
        felt
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

impl<P: Snapshot, V: Signal> Snapshot for CoupledPort<P, V> {
    /// The memory of the port inside, the deflection, and the last answer.
    type State = (P::State, V, V);

    fn state(&self) -> Self::State {
        (self.port.state(), self.deflection, self.answer)
    }

    fn restored(self, (port, deflection, answer): Self::State) -> Result<Self, ParameterError> {
        let deflection = Requirement::Finite.check_axes("stored deflection", deflection)?;
        let answer = Requirement::Finite.check_axes("stored answer", answer)?;
        Ok(Self { port: self.port.restored(port)?, deflection, answer, ..self })
    }
}
