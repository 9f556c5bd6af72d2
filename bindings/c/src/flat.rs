//! Flat form of values: words of one width, in which memory is kept and stored.

use lyapunov::poses::{Axes, Screw, WithPose};
use lyapunov::{Scalar, Signal};
use nalgebra::{SVector, Vector3};

use crate::number::Word;
use crate::port::{AxesForm, ScrewForm};

/// Value that is a fixed number of words.
pub trait Flat<W: Word>: Sized {
    /// How many.
    const WORDS: usize;

    /// Hands the words out, first to last.
    fn put(&self, out: &mut impl FnMut(W));

    /// The value of the next words.
    fn take(from: &mut impl FnMut() -> W) -> Self;
}

/// Writes `value` into `words`; words without a value are 0.
#[inline]
pub fn put<W: Word, F: Flat<W>>(value: &F, words: &mut [W]) {
    let mut places = words.iter_mut();
    value.put(&mut |word| {
        if let Some(place) = places.next() {
            *place = word;
        }
    });
    places.for_each(|place| *place = W::default());
}

/// Reads a value from `words`; missing ones are 0.
#[inline]
pub fn take<W: Word, F: Flat<W>>(words: &[W]) -> F {
    let mut words = words.iter().copied();
    F::take(&mut || words.next().unwrap_or_default())
}

impl<W: Word> Flat<W> for () {
    const WORDS: usize = 0;

    fn put(&self, _out: &mut impl FnMut(W)) {}

    fn take(_from: &mut impl FnMut() -> W) -> Self {}
}

impl<W: Word> Flat<W> for u32 {
    const WORDS: usize = 1;

    #[inline]
    fn put(&self, out: &mut impl FnMut(W)) {
        out(W::of(u64::from(*self)));
    }

    #[inline]
    fn take(from: &mut impl FnMut() -> W) -> Self {
        // Of a longer word the lowest bits: `put` gave no others.
        from().value() as Self
    }
}

/// Places in an array, which fit into 32 bits.
impl<W: Word> Flat<W> for usize {
    const WORDS: usize = 1;

    #[inline]
    fn put(&self, out: &mut impl FnMut(W)) {
        out(W::of(*self as u64));
    }

    #[inline]
    fn take(from: &mut impl FnMut() -> W) -> Self {
        // A place that does not fit is none, which whoever restores it refuses.
        Self::try_from(from().value()).unwrap_or(Self::MAX)
    }
}

/// Two words, the lower half first, also where one would do: memory then has as many words for both numbers.
impl<W: Word> Flat<W> for u64 {
    const WORDS: usize = 2;

    #[inline]
    fn put(&self, out: &mut impl FnMut(W)) {
        out(W::of(*self & 0xffff_ffff));
        out(W::of(*self >> 32));
    }

    #[inline]
    fn take(from: &mut impl FnMut() -> W) -> Self {
        let low = from().value() & 0xffff_ffff;
        low | from().value() << 32
    }
}

/// A time, beside numbers of half its width.
impl Flat<u32> for f64 {
    const WORDS: usize = 2;

    #[inline]
    fn put(&self, out: &mut impl FnMut(u32)) {
        self.to_bits().put(out);
    }

    #[inline]
    fn take(from: &mut impl FnMut() -> u32) -> Self {
        Self::from_bits(u64::take(from))
    }
}

/// The value of none is 0.
impl<W: Word, F: Flat<W>> Flat<W> for Option<F> {
    const WORDS: usize = 1 + F::WORDS;

    #[inline]
    fn put(&self, out: &mut impl FnMut(W)) {
        out(W::of(u64::from(self.is_some())));
        match self {
            Some(value) => value.put(out),
            None => (0..F::WORDS).for_each(|_| out(W::default())),
        }
    }

    #[inline]
    fn take(from: &mut impl FnMut() -> W) -> Self {
        let some = from() != W::default();
        let value = F::take(from);
        some.then_some(value)
    }
}

impl<W: Word, F: Flat<W>, const N: usize> Flat<W> for [F; N] {
    const WORDS: usize = N * F::WORDS;

    #[inline]
    fn put(&self, out: &mut impl FnMut(W)) {
        self.iter().for_each(|one| one.put(out));
    }

    #[inline]
    fn take(from: &mut impl FnMut() -> W) -> Self {
        core::array::from_fn(|_| F::take(from))
    }
}

impl<W: Word, F: Flat<W> + nalgebra::Scalar, const N: usize> Flat<W> for SVector<F, N> {
    const WORDS: usize = N * F::WORDS;

    #[inline]
    fn put(&self, out: &mut impl FnMut(W)) {
        self.iter().for_each(|one| one.put(out));
    }

    #[inline]
    fn take(from: &mut impl FnMut() -> W) -> Self {
        Self::from(<[F; N]>::take(from))
    }
}

impl<W: Word, T: Flat<W> + Scalar, F: Axes> Flat<W> for Screw<T, F> {
    const WORDS: usize = 6 * T::WORDS;

    #[inline]
    fn put(&self, out: &mut impl FnMut(W)) {
        self.translation.put(out);
        self.rotation.put(out);
    }

    #[inline]
    fn take(from: &mut impl FnMut() -> W) -> Self {
        let translation = Vector3::take(from);
        Self::new(translation, Vector3::take(from))
    }
}

impl<W: Word, T: Flat<W> + Scalar, F: Axes> Flat<W> for WithPose<T, F> {
    const WORDS: usize = 13 * T::WORDS;

    #[inline]
    fn put(&self, out: &mut impl FnMut(W)) {
        self.map(|number| {
            number.put(out);
            number
        });
    }

    #[inline]
    fn take(from: &mut impl FnMut() -> W) -> Self {
        Self::default().map(|_| T::take(from))
    }
}

impl<W: Word, T: Flat<W>, const N: usize> Flat<W> for AxesForm<T, N> {
    const WORDS: usize = N * T::WORDS;

    #[inline]
    fn put(&self, out: &mut impl FnMut(W)) {
        self.axis.put(out);
    }

    #[inline]
    fn take(from: &mut impl FnMut() -> W) -> Self {
        Self { axis: Flat::take(from) }
    }
}

impl<W: Word, T: Flat<W>> Flat<W> for ScrewForm<T> {
    const WORDS: usize = 6 * T::WORDS;

    #[inline]
    fn put(&self, out: &mut impl FnMut(W)) {
        self.translation.put(out);
        self.rotation.put(out);
    }

    #[inline]
    fn take(from: &mut impl FnMut() -> W) -> Self {
        let translation = Flat::take(from);
        Self { translation, rotation: Flat::take(from) }
    }
}

macro_rules! tuple {
    ($($part:ident $at:tt),+) => {
        impl<W: Word, $($part: Flat<W>),+> Flat<W> for ($($part,)+) {
            const WORDS: usize = 0 $(+ $part::WORDS)+;

            #[inline]
            fn put(&self, out: &mut impl FnMut(W)) {
                $(self.$at.put(out);)+
            }

            #[inline]
            fn take(from: &mut impl FnMut() -> W) -> Self {
                ($($part::take(from),)+)
            }
        }
    };
}

tuple!(A 0, B 1);
tuple!(A 0, B 1, C 2);
tuple!(A 0, B 1, C 2, D 3);
tuple!(A 0, B 1, C 2, D 3, E 4);
