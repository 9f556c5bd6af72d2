//! Bytes that pass between the page and this module.

use std::cell::RefCell;

thread_local! {
    static INPUT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
    static OUTPUT: RefCell<Vec<u8>> = const { RefCell::new(Vec::new()) };
}

/// Answer of a call: it was done, or the output says why not.
const DONE: u32 = 0;
const REFUSED: u32 = 1;

/// Room for an input of `length` bytes, to be written before the call that reads it.
#[unsafe(no_mangle)]
pub extern "C" fn input(length: usize) -> *mut u8 {
    INPUT.with_borrow_mut(|bytes| {
        bytes.clear();
        bytes.resize(length, 0);
        bytes.as_mut_ptr()
    })
}

/// Place of the last output.
#[unsafe(no_mangle)]
pub extern "C" fn output() -> *const u8 {
    OUTPUT.with_borrow(|bytes| bytes.as_ptr())
}

/// Length of the last output, bytes.
#[unsafe(no_mangle)]
pub extern "C" fn output_length() -> usize {
    OUTPUT.with_borrow(Vec::len)
}

/// Answers the input with the output of `job`, or with the reason why there is none.
pub(crate) fn answer(job: impl FnOnce(&str) -> Result<Vec<u8>, String>) -> u32 {
    let input = INPUT.with_borrow_mut(std::mem::take);
    let told = String::from_utf8(input).map_err(|error| error.to_string());
    let (bytes, answer) = match told.and_then(|text| job(&text)) {
        Ok(bytes) => (bytes, DONE),
        Err(reason) => (reason.into_bytes(), REFUSED),
    };
    OUTPUT.set(bytes);
    answer
}

/// Numbers as bytes, eight for each, the least significant first.
pub(crate) fn bytes(numbers: impl IntoIterator<Item = f64>) -> Vec<u8> {
    numbers.into_iter().flat_map(f64::to_le_bytes).collect()
}
