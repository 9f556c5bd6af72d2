//! Proof that this processor has the instructions of a vector.

#[cfg(target_arch = "x86_64")]
use std::cell::Cell;
use std::fmt::Debug;

#[cfg(target_feature = "simd128")]
use pulp::bytemuck::cast;
use pulp::{NullaryFnOnce, Simd};

/// Instructions that a thread has [proven](Self::prove) to be there.
///
/// Operators and constants of a [`Scalar`](lyapunov::Scalar) have no argument that could carry the proof, so they look
/// for it where the thread keeps it. Nothing in a loop writes there, so that the compiler looks once for all ticks.
pub(super) trait Proven: Simd + Debug + 'static {
    /// Whether they multiply and add with one rounding.
    const FUSES: bool;

    /// Keeps this proof for the thread.
    #[cfg(target_arch = "x86_64")]
    fn prove(self);

    /// The proof that the thread keeps.
    fn here() -> Self;

    /// Runs `job` compiled for these instructions.
    fn run<J: NullaryFnOnce>(self, job: J) -> J::Output;

    /// The larger, zeros and a NaN chosen as by [`Scalar::larger`](lyapunov::Scalar::larger).
    fn larger_f64s(self, one: Self::f64s, other: Self::f64s) -> Self::f64s;

    /// The smaller, zeros and a NaN chosen as by [`Scalar::smaller`](lyapunov::Scalar::smaller).
    fn smaller_f64s(self, one: Self::f64s, other: Self::f64s) -> Self::f64s;

    /// The same as [`larger_f64s`](Self::larger_f64s) for `f32`.
    #[cfg(target_arch = "x86_64")]
    fn larger_f32s(self, one: Self::f32s, other: Self::f32s) -> Self::f32s;

    /// The same as [`smaller_f64s`](Self::smaller_f64s) for `f32`.
    #[cfg(target_arch = "x86_64")]
    fn smaller_f32s(self, one: Self::f32s, other: Self::f32s) -> Self::f32s;
}

/// A path of its own that never returns, so that what follows the look need not look again.
#[cold]
#[inline(never)]
fn unproven() -> ! {
    unreachable!("vectors are made after their instructions were proven")
}

#[cfg(target_arch = "x86_64")]
macro_rules! chosen {
    ($($choose:ident by $of_processor:ident on $vector:ident),+) => {$(
        #[inline(always)]
        fn $choose(self, one: Self::$vector, other: Self::$vector) -> Self::$vector {
            self.$of_processor(one, other)
        }
    )+};
}

#[cfg(target_arch = "x86_64")]
macro_rules! proven {
    ($($token:ty, kept in $cell:ident);+ $(;)?) => {$(
        thread_local! {
            static $cell: Cell<Option<$token>> = const { Cell::new(None) };
        }

        impl Proven for $token {
            const FUSES: bool = true;

            fn prove(self) {
                $cell.set(Some(self));
            }

            #[inline(always)]
            fn here() -> Self {
                // Unlike `get`, this is inlined in every part that a crate is compiled in.
                match $cell.try_with(Cell::get) {
                    Ok(Some(proof)) => proof,
                    _ => unproven(),
                }
            }

            #[inline(always)]
            fn run<J: NullaryFnOnce>(self, job: J) -> J::Output {
                self.vectorize(job)
            }

            chosen!(larger_f64s by max_f64s on f64s, smaller_f64s by min_f64s on f64s,
                larger_f32s by max_f32s on f32s, smaller_f32s by min_f32s on f32s);
        }
    )+};
}

#[cfg(target_arch = "x86_64")]
proven! {
    pulp::x86::V3, kept in AVX2;
    pulp::x86::V4, kept in AVX512;
}

// The whole program is compiled for them, so there is nothing to keep.
#[cfg(target_feature = "simd128")]
impl Proven for pulp::wasm::Simd128 {
    const FUSES: bool = false;

    #[inline(always)]
    fn here() -> Self {
        Self::try_new().unwrap_or_else(|| unproven())
    }

    #[inline(always)]
    fn run<J: NullaryFnOnce>(self, job: J) -> J::Output {
        job.call()
    }

    // The pseudo-maximum takes its first number unless the second is larger.
    #[inline(always)]
    fn larger_f64s(self, one: Self::f64s, other: Self::f64s) -> Self::f64s {
        cast(self.simd128.f64x2_pmax(cast(other), cast(one)))
    }

    #[inline(always)]
    fn smaller_f64s(self, one: Self::f64s, other: Self::f64s) -> Self::f64s {
        cast(self.simd128.f64x2_pmin(cast(other), cast(one)))
    }
}
