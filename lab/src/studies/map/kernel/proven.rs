//! Proof that this processor has the instructions of a vector.

#[cfg(target_arch = "x86_64")]
use std::cell::Cell;
use std::fmt::Debug;

use pulp::{NullaryFnOnce, Simd};

/// Instructions that a thread has [proven](Self::prove) to be there.
///
/// Operators and constants of a [`Scalar`](lyapunov::Scalar) have no argument that could carry the proof, so they look
/// for it where the thread keeps it. Nothing in a loop writes there, so that the compiler looks once for all ticks.
pub(super) trait Proven: Simd + Debug + 'static {
    /// Whether they multiply and add with one rounding.
    const FUSES: bool;

    /// Whether their minimum and maximum choose as [`Scalar`](lyapunov::Scalar)'s do, zeros and NaN included.
    const CHOOSES: bool;

    /// Keeps this proof for the thread.
    #[cfg(target_arch = "x86_64")]
    fn prove(self);

    /// The proof that the thread keeps.
    fn here() -> Self;

    /// Runs `job` compiled for these instructions.
    fn run<J: NullaryFnOnce>(self, job: J) -> J::Output;
}

/// A path of its own that never returns, so that what follows the look need not look again.
#[cold]
#[inline(never)]
fn unproven() -> ! {
    unreachable!("vectors are made after their instructions were proven")
}

#[cfg(target_arch = "x86_64")]
macro_rules! proven {
    ($($token:ty, kept in $cell:ident);+ $(;)?) => {$(
        thread_local! {
            static $cell: Cell<Option<$token>> = const { Cell::new(None) };
        }

        impl Proven for $token {
            const FUSES: bool = true;
            const CHOOSES: bool = true;

            fn prove(self) {
                $cell.set(Some(self));
            }

            #[inline(always)]
            fn here() -> Self {
                match $cell.get() {
                    Some(proof) => proof,
                    None => unproven(),
                }
            }

            #[inline(always)]
            fn run<J: NullaryFnOnce>(self, job: J) -> J::Output {
                self.vectorize(job)
            }
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
    const CHOOSES: bool = false;

    #[inline(always)]
    fn here() -> Self {
        Self::try_new().unwrap_or_else(|| unproven())
    }

    #[inline(always)]
    fn run<J: NullaryFnOnce>(self, job: J) -> J::Output {
        job.call()
    }
}
