//! Types that no block brings: signals, samples, corrections, the status.

use core::mem::offset_of;
use std::fmt::Write;
use std::format;
use std::string::String;

use lyapunov::poses::Screw;
use nalgebra::SVector;

use super::c_type::{Named, Suffix};
use super::{CType, Header};
use crate::answered::WaveForm;
use crate::port::{AxesForm, CorrectionForm, Port, SampleForm, ScrewForm};
use crate::poses::PoseForm;
use crate::readings::CheckedForm;
use crate::status::{CODES, Status};
use crate::told::Candidate;
use crate::watched::SummaryForm;

pub(super) fn describe(header: &mut Header) {
    codes(header);
    status(header);
    header.block("Signals", &["several axes, and twists or wrenches along the world's axes"]);
    signals::<f32>(header);
    signals::<f64>(header);
    header.block(
        "Samples and corrections",
        &["what the other side of a port did since the last call, and what a stabilizer did to an effort"],
    );
    port::<f32>(header);
    port::<f64>(header);
    port::<SVector<f32, 3>>(header);
    port::<SVector<f64, 3>>(header);
    port::<SVector<f32, 6>>(header);
    port::<SVector<f64, 6>>(header);
    port::<Screw<f32>>(header);
    port::<Screw<f64>>(header);
}

fn codes(header: &mut Header) {
    let _ = writeln!(
        header.text,
        "/* What became of a call. */\ntypedef uint32_t lyapunov_code;\nenum {{"
    );
    for (at, (name, code, about)) in CODES.iter().enumerate() {
        let comma = if at + 1 < CODES.len() { "," } else { "" };
        let value = *code as u32;
        let _ = writeln!(header.text, "    LYAPUNOV_{name} = {value}{comma} /* {about} */");
    }
    let _ = writeln!(header.text, "}};\n");
}

fn status(header: &mut Header) {
    let _ = writeln!(
        header.text,
        "/* What became of a call that may be refused: the code, and the refused parameter. */"
    );
    let _ = writeln!(header.text, "typedef struct lyapunov_status {{");
    let fields: [(&str, String, &str); 6] = [
        ("value", f64::name(), "The refused value."),
        ("bound", f64::name(), "The number of the requirement, where it has one."),
        (
            "parameter",
            <*const u8>::name(),
            "The parameter's name, not closed by a zero; null without one.",
        ),
        ("length", u16::name(), "The length of the name."),
        ("requirement", u16::name(), "The requirement, for lyapunov_status_text."),
        ("code", "lyapunov_code".into(), "The code: LYAPUNOV_OK or what was wrong."),
    ];
    for (name, c, about) in fields {
        let gap = if c.ends_with('*') { "" } else { " " };
        let _ = writeln!(header.text, "    /* {about} */\n    {c}{gap}{name};");
    }
    let _ = writeln!(header.text, "}} lyapunov_status;");
    // A pointer's width differs from target to target, and with it this struct.
    for (name, offset) in [
        ("value", offset_of!(Status, value)),
        ("bound", offset_of!(Status, bound)),
        ("parameter", offset_of!(Status, parameter)),
    ] {
        let _ = writeln!(
            header.text,
            "LYAPUNOV_ASSERT(offsetof(lyapunov_status, {name}) == {offset}, lyapunov_status_{name});"
        );
    }
    let text = [
        ("status", <*const Status>::name()),
        ("text", <*mut core::ffi::c_char>::name()),
        ("capacity", usize::name()),
    ];
    header.function(
        "lyapunov_status_text",
        &["Writes what is wrong and what would be right, as far as `capacity` bytes reach, with a closing zero; returns the length of the whole text."],
        usize::name(),
        &text,
    );
    header.function(
        "lyapunov_abi",
        &["The version of the library's binary interface, to be compared with LYAPUNOV_ABI."],
        u32::name(),
        &[],
    );
}

fn signals<T: Named>(header: &mut Header) {
    header.form::<AxesForm<T, 3>>();
    header.form::<AxesForm<T, 6>>();
    header.form::<SummaryForm<T>>();
    header.form::<ScrewForm<T>>();
    header.form::<PoseForm<T>>();
}

fn port<V: Port<Form: CType, Scalar: CType> + Suffix>(header: &mut Header) {
    header.form::<SampleForm<V>>();
    header.form::<CorrectionForm<V>>();
    header.form::<CheckedForm<V>>();
    header.form::<WaveForm<V>>();
    candidate::<V>(header);
}

fn candidate<V: Port<Form: CType, Scalar: CType> + Suffix>(header: &mut Header) {
    let (number, candidate) = (V::Scalar::name(), Candidate::<V>::name());
    let sample = <*const SampleForm<V>>::name();
    let declared = format!("typedef {number} (*{candidate})(void *context, {sample}sample);");
    let _ = writeln!(
        header.text,
        "/* Function of yours that a step calls, see lolc_custom and lolc_storage. */\n{declared}"
    );
}
