//! State feedback as a port.

use lyapunov_core::{OnePort, PortSample, Scalar};
use nalgebra::SVector;

use crate::WithState;

/// A state feedback `u = k(x)` as a port: it answers with the effort `e = −k(x)`.
///
/// Any `Fn(SVector<T, N>) -> SVector<T, M>` will do. Everything that acts on a port acts on it: hold, delay,
/// saturation, stabilizer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StateFeedback<K> {
    law: K,
}

impl<K> StateFeedback<K> {
    /// The feedback `u = law(x)`.
    pub fn new<T: Scalar, const N: usize, const M: usize>(law: K) -> Self
    where
        K: Fn(SVector<T, N>) -> SVector<T, M>,
    {
        Self { law }
    }
}

impl<T, K, const N: usize, const M: usize> OnePort<WithState<T, N, M>> for StateFeedback<K>
where
    T: Scalar,
    K: Fn(SVector<T, N>) -> SVector<T, M>,
{
    #[inline]
    fn respond(&mut self, sample: &PortSample<WithState<T, N, M>>) -> WithState<T, N, M> {
        WithState::of_input(-(self.law)(sample.position.state))
    }
}
