//! Numbers of a port in C: `float` and `double`.

use lyapunov::Scalar;

use crate::flat::Flat;

/// Number of a port in C, and the unsigned integer of the same width.
pub trait Number: Scalar<Mask = bool, Real = f64> + Flat<Self::Word> + Default {
    /// The integer with as many bits.
    type Word: Word;

    /// The part that fills an odd count of them up to 64 bits.
    type Fill: Copy + Default + core::fmt::Debug;
}

/// Unsigned integer as wide as a number of the port.
pub trait Word: Copy + Default + Eq + core::fmt::Debug + 'static {
    /// The lowest bits of `value`; what does not fit is lost.
    fn of(value: u64) -> Self;

    /// The value.
    fn value(self) -> u64;
}

macro_rules! number {
    ($number:ident, $word:ident, $fill:ty) => {
        impl Number for $number {
            type Word = $word;
            type Fill = $fill;
        }

        impl Word for $word {
            #[inline(always)]
            fn of(value: u64) -> Self {
                value as $word
            }

            #[inline(always)]
            fn value(self) -> u64 {
                self.into()
            }
        }

        impl Flat<$word> for $number {
            const WORDS: usize = 1;

            #[inline]
            fn put(&self, out: &mut impl FnMut($word)) {
                out(self.to_bits());
            }

            #[inline]
            fn take(from: &mut impl FnMut() -> $word) -> Self {
                Self::from_bits(from())
            }
        }
    };
}

number!(f32, u32, u32);
number!(f64, u64, [u32; 0]);
