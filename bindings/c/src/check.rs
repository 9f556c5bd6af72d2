//! Checks of pointers that come from C.

use crate::status::Code;

/// Whether `pointer` can be followed, as far as it tells by itself.
#[inline(always)]
pub(crate) fn pointer<T>(pointer: *const T) -> Result<(), Code> {
    address::<T>(pointer.addr())
}

/// Whether a `T` can be at `address`, as far as that tells by itself.
#[inline(always)]
pub(crate) fn address<T>(address: usize) -> Result<(), Code> {
    if address == 0 {
        return Err(Code::Null);
    }
    if !address.is_multiple_of(align_of::<T>()) {
        return Err(Code::Misaligned);
    }
    Ok(())
}

/// Whether each of `addresses` is aligned for a `T`, by one test of their lowest bits.
#[inline(always)]
pub(crate) fn aligned<T, const N: usize>(addresses: [usize; N]) -> bool {
    addresses.into_iter().fold(0, |bits, address| bits | address).is_multiple_of(align_of::<T>())
}

/// Whether none of `addresses` is null.
#[inline(always)]
pub(crate) fn present<const N: usize>(addresses: [usize; N]) -> bool {
    addresses.into_iter().all(|address| address != 0)
}
