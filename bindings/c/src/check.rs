//! Checks of pointers that come from C.

use crate::status::Code;

/// Whether `pointer` can be followed, as far as it tells by itself.
#[inline(always)]
pub(crate) fn pointer<T>(pointer: *const T) -> Result<(), Code> {
    if pointer.is_null() {
        return Err(Code::Null);
    }
    if !pointer.is_aligned() {
        return Err(Code::Misaligned);
    }
    Ok(())
}
