//! Signals of C, and lists of them.

use lyapunov::poses::Screw;
use lyapunov::{ParameterError, Scalar, Signal};
use nalgebra::{Vector3, Vector6};

pub(crate) type Done = Result<(), ParameterError>;

/// A signal of C.
pub(crate) trait Named: Signal<Scalar: Scalar<Mask = bool>> {
    const NAME: &'static str;
}

macro_rules! named {
    ($($type:ty = $name:literal),+ $(,)?) => {
        $(impl Named for $type { const NAME: &'static str = $name; })+
    };
}

named! {
    f32 = "f32", f64 = "f64", Vector3<f32> = "f32x3", Vector3<f64> = "f64x3",
    Vector6<f32> = "f32x6", Vector6<f64> = "f64x6", Screw<f32> = "f32screw", Screw<f64> = "f64screw",
}

pub(crate) type Of<V> = <V as Signal>::Scalar;

/// A number as C wrote it: in `float`.
pub(crate) fn n<T: Scalar>(number: f32) -> T {
    T::of(f64::from(number))
}

/// `$body` with `$v` each of the signals.
macro_rules! each {
    ($v:ident in [$($signal:ty),+] $body:block) => {
        $({ type $v = $signal; $body })+
    };
}
macro_rules! line {
    ($v:ident $body:block) => { each!($v in [f32, f64] $body) };
}
macro_rules! bodies {
    ($v:ident $body:block) => { each!($v in [Screw<f32>, Screw<f64>] $body) };
}
macro_rules! axes {
    ($v:ident $body:block) => {
        each!($v in [f32, f64, Vector3<f32>, Vector3<f64>, Vector6<f32>, Vector6<f64>] $body)
    };
}
macro_rules! every {
    ($v:ident $body:block) => {{ axes!($v $body); bodies!($v $body); }};
}

pub(crate) use {axes, bodies, each, every, line};
