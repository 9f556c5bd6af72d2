//! How storage keeps a block: as the value itself, or as words of which the value is made on each call.

use core::marker::PhantomData;

use lyapunov::{ParameterError, Snapshot};

use crate::flat::{self, Flat};
use crate::number::Number;
use crate::port::Port;
use crate::retuned::Retuned;
use crate::status::{Code, Status};

/// Kind of block: which value it is, and which parameters make it.
pub trait Kind: Sized {
    /// The signal at its port.
    type Port: Port;

    /// The parameters, as C gives them.
    type Parameters: Copy + Flat<WordOf<Self>> + Retuned;

    /// The value.
    type Body: Copy + Snapshot<State: Flat<WordOf<Self>>>;

    /// How the storage keeps it.
    type Kept: Keep<Self>;

    /// The memory, as C stores it.
    type Memory: Copy + AsMut<[WordOf<Self>]> + AsRef<[WordOf<Self>]>;

    /// The tag of its storage.
    const TAG: u32;

    /// An empty memory.
    const EMPTY: Self::Memory;

    /// The value of `parameters`.
    ///
    /// # Errors
    /// What the value's constructor refuses.
    fn build(parameters: &Self::Parameters) -> Result<Self::Body, ParameterError>;
}

/// Number of a kind's port.
pub type NumberOf<K> = <<K as Kind>::Port as lyapunov::Signal>::Scalar;

/// Word of a kind's port.
pub type WordOf<K> = <NumberOf<K> as Number>::Word;

/// Storage of a block: a tag as wide as a number, and what keeps the block.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct Storage<K: Kind> {
    pub(crate) tag: WordOf<K>,
    pub(crate) kept: K::Kept,
}

/// Way to keep a block, whatever the bits.
pub trait Keep<K: Kind>: Copy {
    /// Keeps a new `body`, made of `parameters`.
    fn keep(body: K::Body, parameters: &K::Parameters) -> Self;

    /// What `f` does to the block.
    ///
    /// # Errors
    /// `Code::Memory` where the bytes are no such block any more.
    fn lend<R>(&mut self, f: impl FnOnce(&mut K::Body) -> R) -> Result<R, Code>;

    /// The same block with other parameters.
    ///
    /// # Errors
    /// What the constructor refuses, and what the memory does not fit into.
    fn retune(&mut self, parameters: &K::Parameters) -> Result<(), Status> {
        let refused = |error| Status::refused(Code::Parameter, error);
        let state = self.lend(|body| body.state()).map_err(Status::of)?;
        let parameters = &parameters.retuned();
        let body = K::build(parameters).and_then(|body| body.restored(state)).map_err(refused)?;
        *self = Self::keep(body, parameters);
        Ok(())
    }

    /// Takes the memory out.
    ///
    /// # Errors
    /// `Code::Memory` where the bytes are no such block any more.
    fn save(&mut self, memory: &mut K::Memory) -> Result<(), Code> {
        self.lend(|body| flat::put(&body.state(), memory.as_mut()))
    }

    /// Puts a memory in place of the own one.
    ///
    /// # Errors
    /// What cannot be in the memory.
    fn restore(&mut self, memory: &K::Memory) -> Result<(), Status> {
        let restored = |body: &mut K::Body| {
            *body = body.restored(flat::take(memory.as_ref()))?;
            Ok(())
        };
        let refused = |error| Status::refused(Code::Memory, error);
        self.lend(restored).map_err(Status::of)?.map_err(refused)
    }
}

/// Kind whose value is numbers of its port and nothing else.
///
/// # Safety
/// All fields of the value are numbers of one type: it has no padding, and every pattern of bits is a value.
pub unsafe trait Plain: Kind {}

/// The value itself: a step reads and writes it in place.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct Whole<B>(B);

impl<B> Whole<B> {
    /// The value, to be looked at.
    #[inline(always)]
    pub(crate) fn value(&self) -> &B {
        &self.0
    }
}

impl<K: Plain> Keep<K> for Whole<K::Body> {
    #[inline(always)]
    fn keep(body: K::Body, _parameters: &K::Parameters) -> Self {
        Self(body)
    }

    #[inline(always)]
    fn lend<R>(&mut self, f: impl FnOnce(&mut K::Body) -> R) -> Result<R, Code> {
        Ok(f(&mut self.0))
    }
}

/// Parameters and memory, as words: for a value that has a flag, a counter or an option among its numbers, whose bytes
/// would have padding, and of which not every pattern is a value. It is made anew on each call.
#[derive(Clone, Copy, Debug)]
#[repr(transparent)]
pub struct Words<K: Kind, const N: usize> {
    words: [WordOf<K>; N],
    kind: PhantomData<K>,
}

impl<K: Kind, const N: usize> Words<K, N> {
    /// The words that the parameters take.
    const PARAMETERS: usize = <K::Parameters as Flat<WordOf<K>>>::WORDS;

    /// The words that the memory takes.
    const MEMORY: usize = <<K::Body as Snapshot>::State as Flat<WordOf<K>>>::WORDS;

    /// Every word is used.
    const FITS: () = assert!(Self::PARAMETERS + Self::MEMORY == N);
}

impl<K: Kind, const N: usize> Keep<K> for Words<K, N>
where
    Self: Copy,
{
    fn keep(body: K::Body, parameters: &K::Parameters) -> Self {
        let () = Self::FITS;
        let mut words = [WordOf::<K>::default(); N];
        if let Some((front, back)) = words.split_at_mut_checked(Self::PARAMETERS) {
            // The memory has what `init` alone reads, and a block that was retuned is then the same bytes as one that was not.
            flat::put(&parameters.retuned(), front);
            flat::put(&body.state(), back);
        }
        Self { words, kind: PhantomData }
    }

    #[inline]
    fn lend<R>(&mut self, f: impl FnOnce(&mut K::Body) -> R) -> Result<R, Code> {
        let () = Self::FITS;
        let split = self.words.split_at_mut_checked(Self::PARAMETERS);
        let (parameters, memory) = split.ok_or(Code::Memory)?;
        let parameters: K::Parameters = flat::take(parameters);
        let made = K::build(&parameters).and_then(|body| body.restored(flat::take(memory)));
        let mut body = made.map_err(|_| Code::Memory)?;
        let done = f(&mut body);
        flat::put(&body.state(), memory);
        Ok(done)
    }
}
