//! Positions as an encoder counts them.

use lyapunov_core::{Action, Drive, OnePort, ParameterError, Requirement, Scalar, Signal};

/// A port that is told positions rounded to whole counts, ties away from zero.
///
/// `xm(n) = round(x(n) / resolution) · resolution`; the displacement is that of the counts, and the work the
/// acting effort's over that displacement: true up to the resolution times the effort. The velocity is left
/// as it is; take it from the counts with [`Adapt::differenced`](crate::Adapt::differenced) inside.
#[derive(Clone, Copy, Debug)]
pub struct Encoder<P, V: Signal> {
    port: P,
    resolution: V::Scalar,
    last: Option<V>,
}

impl<P, V: Signal> Encoder<P, V> {
    pub(crate) fn new(port: P, resolution: V::Scalar) -> Result<Self, ParameterError> {
        let resolution = Requirement::Positive.check("encoder resolution", resolution)?;
        Ok(Self { port, resolution, last: None })
    }
}

impl<V: Signal, P: OnePort<V>> OnePort<V> for Encoder<P, V> {
    #[inline]
    fn respond(&mut self, drive: &Drive<V>) -> V {
        let position = drive.position.map(|x| (x / self.resolution).rounded() * self.resolution);
        let displacement = position - self.last.unwrap_or(position);
        self.last = Some(position);
        // What several periods under other efforts did is kept; of a single one this is exactly zero.
        let others = drive.work - drive.acted.times(drive.displacement);
        let work = drive.acted.times(displacement) + others;
        self.port.respond(&Drive { position, displacement, work, ..*drive })
    }

    #[inline]
    fn action(&self) -> Action<V> {
        self.port.action()
    }
}
