//! Makers of own stabilizers for each signal that a scene can have.

use std::any::{Any, TypeId};
use std::marker::PhantomData;

use lyapunov::accumulators::DoubleDouble;
use lyapunov::{Lolc, ParameterError};
use nalgebra::SVector;

use super::{OwnCandidate, OwnStabilizer};
use crate::files::scene::own::Loop;
use crate::simulate::aligned::F64x8;
use crate::simulate::building::{AnyStabilizer, Space};

/// A way to box a stabilizer for any signal.
pub(super) trait Maker {
    fn boxed<V: Space>(on: &Loop<'_>) -> Result<AnyStabilizer<V>, ParameterError>;
}

/// The own stabilizer `S`.
pub(super) struct Alone<S>(PhantomData<S>);

impl<S: OwnStabilizer> Maker for Alone<S> {
    fn boxed<V: Space>(on: &Loop<'_>) -> Result<AnyStabilizer<V>, ParameterError> {
        S::make::<V>(on).map(AnyStabilizer::called)
    }
}

/// LOLC with the own candidate `C`.
pub(super) struct Watching<C>(PhantomData<C>);

impl<C: OwnCandidate> Maker for Watching<C> {
    fn boxed<V: Space>(on: &Loop<'_>) -> Result<AnyStabilizer<V>, ParameterError> {
        let limit = on.damping_limit::<V::Scalar>()?;
        Ok(AnyStabilizer::called(Lolc::new(C::make::<V>(on)?, limit)))
    }
}

/// The stabilizer of `M` for the signal with the id `space`, as a `Result<AnyStabilizer<V>, ParameterError>`.
///
/// A table of scenes knows no signal and no stabilizer of simulations, so its maker speaks of neither.
pub(super) fn make<M: Maker>(space: TypeId, on: &Loop<'_>) -> Option<Box<dyn Any>> {
    macro_rules! of {
        ($($signal:ty),* $(,)?) => {
            $(if space == TypeId::of::<$signal>() {
                return Some(Box::new(M::boxed::<$signal>(on)));
            })*
        };
    }
    of!(
        f64,
        f32,
        SVector<f64, 2>,
        SVector<f64, 3>,
        SVector<f32, 2>,
        SVector<f32, 3>,
        F64x8,
        DoubleDouble,
    );
    None
}
