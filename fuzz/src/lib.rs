//! Fuzz targets of the lower crates, as plain functions of bytes: each panics where a promise is broken.

mod bytes;
mod check;
mod drive;
mod members;
mod poses;
mod random;
mod tick;

pub use bytes::{Bytes, Real};
pub use members::{Driven, Member, members};
pub use poses::poses;
pub use random::random;

/// A member of the family with any parameters that pass its checks, and any ticks.
///
/// The first byte chooses the member, the second the scalar.
pub fn steps(bytes: &[u8]) {
    let [index, scalar, rest @ ..] = bytes else { return };
    let mut rest = Bytes::of(rest);
    // What a constructor refuses is not driven.
    let _refused =
        if scalar % 2 == 0 { run::<f64>(*index, &mut rest) } else { run::<f32>(*index, &mut rest) };
}

fn run<T: Real>(index: u8, bytes: &mut Bytes<'_>) -> Driven {
    let members = members::<T>();
    (members[usize::from(index) % members.len()].run)(bytes)
}
