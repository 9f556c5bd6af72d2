//! Positions in encoder counts.

use lyapunov_core::{
    Correction, OnePort, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot,
};

use super::retold::Retold;

/// A port whose positions are rounded to whole counts, ties away from zero.
///
/// `xm(n) = round(x(n) / resolution) · resolution`; the displacement is the difference of the counts, and the work that
/// of the applied effort over this displacement: true up to the resolution times the effort. The velocity stays as it
/// is; take it from the counts with [`OnePortExt::differenced`](crate::OnePortExt::differenced) inside.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::{OnePortExt, Spring};
/// let mut coarse = Spring::new(500.0)?.encoded(0.25)?; // m
/// let at = |x: f64| PortSample::starting(1e-3, x, 0.0);
/// assert_eq!((coarse.respond(&at(0.3)), coarse.respond(&at(0.4))), (125.0, 250.0));
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Encoder<P, V: Signal> {
    port: P,
    resolution: V::Scalar,
    retold: Retold<V>,
}

lends_port!([P, V: Signal] Encoder<P, V>);

impl<P, V: Signal> Encoder<P, V> {
    pub(crate) fn new(port: P, resolution: V::Scalar) -> Result<Self, ParameterError> {
        let resolution = Requirement::Positive.check("encoder resolution", resolution)?;
        // Below this the counts of everyday positions leave the range.
        let finest = V::Scalar::smallest_normal().lane(0) / V::Scalar::epsilon().lane(0);
        let resolution = Requirement::AtLeast(finest).check("encoder resolution", resolution)?;
        Ok(Self { port, resolution, retold: Retold::after(None) })
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for Encoder<P, V> {
    #[inline(always)]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let position = sample.position.counted(self.resolution);
        self.port.respond(&self.retold.sample(sample, position))
    }

    #[inline(always)]
    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

impl<P: Snapshot, V: Signal> Snapshot for Encoder<P, V> {
    /// The memory of the port inside, and the last position.
    type State = (P::State, Option<V>);

    fn state(&self) -> Self::State {
        (self.port.state(), self.retold.last())
    }

    fn restored(self, (port, last): Self::State) -> Result<Self, ParameterError> {
        Ok(Self { port: self.port.restored(port)?, retold: Retold::after(last), ..self })
    }
}
