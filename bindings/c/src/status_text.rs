//! Text of a status, and of a code.

use core::ffi::c_char;

use crate::check;
use crate::named::in_c;
use crate::status::{CODES, Code, REQUIREMENTS, Status};

/// Text that is written into the memory of a caller, as far as it fits.
struct Text {
    place: *mut c_char,
    room: usize,
    length: usize,
}

impl Text {
    /// Adds a byte; what does not fit is counted.
    fn byte(&mut self, byte: u8) {
        // The last place is for the zero.
        if self.length + 1 < self.room {
            // SAFETY: `text` was told that `room` bytes can be written here, and this one is within them.
            unsafe { self.place.add(self.length).write(byte as c_char) };
        }
        self.length += 1;
    }

    fn add(&mut self, text: &str) {
        text.bytes().for_each(|byte| self.byte(byte));
    }

    fn whole(&mut self, value: u32) {
        if value > 9 {
            self.whole(value / 10);
        }
        self.byte(b'0' + (value % 10) as u8);
    }

    /// `value` with up to six significant digits, as `%g` has it.
    fn number(&mut self, value: f64) {
        if value.is_nan() {
            return self.add("nan");
        }
        if value.is_sign_negative() {
            self.byte(b'-');
        }
        let size = value.abs();
        if size.is_infinite() {
            return self.add("inf");
        }
        if size == 0.0 {
            return self.byte(b'0');
        }
        let (digits, exponent) = digits(size);
        if (-4..6).contains(&exponent) {
            self.fixed(digits, exponent);
        } else {
            self.fixed(digits, 0);
            self.byte(b'e');
            self.byte(if exponent < 0 { b'-' } else { b'+' });
            if exponent.unsigned_abs() < 10 {
                self.byte(b'0');
            }
            self.whole(exponent.unsigned_abs());
        }
    }

    /// Six `digits`, of which the first counts `10^exponent`, without zeros behind the point.
    fn fixed(&mut self, digits: u32, exponent: i32) {
        let mut weight = 100_000;
        let mut rest = digits;
        if exponent < 0 {
            self.add("0.");
            (exponent + 1..0).for_each(|_| self.byte(b'0'));
        }
        for place in 0..6 {
            // The whole part has all its digits.
            if rest == 0 && place > exponent.max(0) {
                return;
            }
            if exponent >= 0 && place == exponent + 1 {
                self.byte(b'.');
            }
            self.byte(b'0' + (rest / weight) as u8);
            rest %= weight;
            weight = (weight / 10).max(1);
        }
    }

    /// Closes the text; its length without the zero, also where it did not fit.
    fn close(self) -> usize {
        if self.room > 0 {
            let end = self.length.min(self.room - 1);
            // SAFETY: within the room, as in `byte`.
            unsafe { self.place.add(end).write(0) };
        }
        self.length
    }
}

/// Six significant digits of `size`, and the exponent of the first.
fn digits(size: f64) -> (u32, i32) {
    let mut exponent = 0;
    let mut scaled = size;
    // Powers of ten up to 1e22 are exact, so few roundings add up.
    while scaled >= 1e16 {
        scaled /= 1e16;
        exponent += 16;
    }
    while scaled < 1e-15 {
        scaled *= 1e16;
        exponent -= 16;
    }
    let mut power = 1.0;
    if scaled >= 1.0 {
        while scaled >= 10.0 * power {
            power *= 10.0;
            exponent += 1;
        }
        scaled = scaled / power * 1e5;
    } else {
        while scaled * power < 1.0 {
            power *= 10.0;
            exponent -= 1;
        }
        scaled = scaled * power * 1e5;
    }
    let rounded = (scaled + 0.5) as u32;
    if rounded >= 1_000_000 { (rounded / 10, exponent + 1) } else { (rounded, exponent) }
}

/// The text of a status: what is wrong, and what would be right. Writes at most `capacity` bytes with the closing zero;
/// returns the length of the whole text.
///
/// # Safety
/// At `text`, unless it is null, `capacity` bytes can be written; `status` comes from the library.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn lyapunov_status_text(
    status: *const Status,
    text: *mut c_char,
    capacity: usize,
) -> usize {
    let room = if text.is_null() { 0 } else { capacity };
    let mut out = Text { place: text, room, length: 0 };
    let status = match check::pointer(status) {
        // SAFETY: neither null nor misaligned, and a variable by the caller's word.
        Ok(()) => unsafe { status.read() },
        Err(code) => Status::of(code),
    };
    if !status.parameter.is_null() {
        if status.code == Code::Memory as u32 {
            out.add("the stored memory is refused: ");
        }
        let length = usize::from(status.length);
        // SAFETY: name and length are those of a string of the library, by the caller's word.
        let parameter = unsafe { core::slice::from_raw_parts(status.parameter, length) };
        match in_c(parameter).filter(|_| status.code == Code::Parameter as u32) {
            Some(name) => out.add(name),
            None => parameter.iter().for_each(|byte| out.byte(*byte)),
        }
        out.add(" is ");
        out.number(status.value);
        out.add("; it must be ");
        let requirement = REQUIREMENTS.get(usize::from(status.requirement));
        let (front, back) = requirement.copied().unwrap_or(("as the library requires it", ""));
        out.add(front);
        if !back.is_empty() {
            out.number(status.bound);
            out.add(back.trim_end());
        }
        return out.close();
    }
    out.add(code_text(status.code));
    out.close()
}

fn code_text(code: u32) -> &'static str {
    let known = CODES.iter().find(|(_, known, _)| *known as u32 == code);
    known.map_or("a code of another version of the library", |(_, _, text)| text)
}

/// The version of the library's binary interface, to be compared with `LYAPUNOV_ABI`.
#[unsafe(no_mangle)]
pub extern "C" fn lyapunov_abi() -> u32 {
    crate::abi::ABI
}
