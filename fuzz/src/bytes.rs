//! Bytes read as numbers, of which every bit pattern can come and ordinary ones come often.

use lyapunov_core::{Angle, Requirement, Scalar};

/// Scalar that bytes can spell.
pub trait Real: Scalar<Mask = bool> + Angle + PartialOrd + Send + Sync + 'static {
    /// Number of bytes.
    const WIDTH: usize;

    /// The number with these bits.
    fn of_bits(bits: u64) -> Self;

    /// Its bits; every NaN has the same.
    fn bits(self) -> u64;
}

macro_rules! real {
    ($($real:ident $bits:ident),+) => {$(
        impl Real for $real {
            const WIDTH: usize = size_of::<$real>();

            fn of_bits(bits: u64) -> Self {
                Self::from_bits(bits as $bits)
            }

            fn bits(self) -> u64 {
                if self.is_nan() { u64::MAX } else { u64::from(self.to_bits()) }
            }
        }
    )+};
}

real!(f32 u32, f64 u64);

/// Bytes that are left to read; past the end there are zeros.
#[derive(Clone, Debug)]
pub struct Bytes<'a> {
    left: &'a [u8],
    believable: bool,
}

impl<'a> Bytes<'a> {
    /// All of `bytes`.
    pub fn of(bytes: &'a [u8]) -> Self {
        Self { left: bytes, believable: true }
    }

    /// Whether nothing is left.
    pub fn at_end(&self) -> bool {
        self.left.is_empty()
    }

    /// Whether every parameter that was read is 0, or of the size of a machine's.
    pub(crate) fn believable(&self) -> bool {
        self.believable
    }

    /// The next byte.
    pub fn byte(&mut self) -> u8 {
        self.word(1) as u8
    }

    /// Number of ticks below `most`.
    pub fn ticks(&mut self, most: u32) -> u32 {
        u32::from(self.byte()) % most
    }

    fn word(&mut self, width: usize) -> u64 {
        let (read, left) = self.left.split_at(width.min(self.left.len()));
        self.left = left;
        read.iter().rev().fold(0, |word, byte| word << 8 | u64::from(*byte))
    }

    /// The next number of ordinary size: up to 128, in steps of 1/256.
    pub fn ordinary<T: Real>(&mut self) -> T {
        T::of(f64::from(self.word(2) as i16) / 256.0)
    }

    /// The next number: of any bits, of ordinary size, of any order of magnitude, or one of the ends of the range.
    pub fn number<T: Real>(&mut self) -> T {
        match self.byte() % 8 {
            0 | 1 => T::of_bits(self.word(T::WIDTH)),
            2 | 3 => self.ordinary(),
            4 => {
                let mantissa = f64::from(self.byte() as i8) / 64.0;
                let exponent = i32::from(self.byte() as i8) * if T::WIDTH == 8 { 5 } else { 1 };
                T::of(mantissa * 10_f64.powi(exponent / 2))
            }
            5 => T::of(f64::from(self.byte()) * 1e-4),
            _ => self.end(),
        }
    }

    /// An end of the range of numbers.
    fn end<T: Real>(&mut self) -> T {
        let kind = self.byte();
        let number = match kind >> 1 {
            0 => T::of(0.0),
            1 => T::of(1.0),
            2 => T::smallest_positive(),
            3 => T::smallest_normal(),
            4 => T::smallest_normal() - T::smallest_positive(),
            5 => T::smallest_normal() + T::smallest_positive(),
            6 => T::epsilon(),
            7 => T::largest(),
            8 => T::largest() * T::of(0.5),
            9 => T::largest().sqrt(),
            10 => T::smallest_normal().sqrt(),
            11 => T::of(f64::INFINITY),
            12 => T::of(f64::NAN),
            other => T::of(f64::from(other) / 8.0),
        };
        if kind % 2 == 0 { number } else { -number }
    }

    /// A number that a constructor may accept: mostly one above 0.
    pub fn parameter<T: Real>(&mut self) -> T {
        let number = self.number::<T>();
        let number = if self.byte() % 16 == 0 { number } else { number.magnitude() };
        self.told(number)
    }

    fn told<T: Real>(&mut self, parameter: T) -> T {
        let size = parameter.magnitude();
        let sized = size >= T::of(1e-9) && size <= T::of(1e9);
        self.believable &= sized || size == T::of(0.0) || !size.finite();
        parameter
    }

    /// A number above 0 and finite, or what was spelled if that is not to be had.
    pub fn positive<T: Real>(&mut self) -> T {
        let number = self.number::<T>().magnitude();
        let refused = Requirement::Positive.check("", number).is_err();
        // Most of what is drawn shall be driven.
        let number = if refused && self.byte() % 4 != 0 { T::of(0.25) } else { number };
        self.believable &= number.finite();
        self.told(number)
    }
}
