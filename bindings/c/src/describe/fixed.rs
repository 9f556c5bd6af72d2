//! Types that no block brings: signals, samples, corrections, the status.

use core::mem::offset_of;
use std::fmt::Write;
use std::format;
use std::string::String;

use lyapunov::poses::Screw;
use nalgebra::SVector;

use super::c_type::{Named, Suffix};
use super::{CType, Field, Header};
use crate::answered::WaveForm;
use crate::port::{AxesForm, CorrectionForm, Port, SampleForm, ScrewForm};
use crate::poses::PoseForm;
use crate::readings::CheckedForm;
use crate::status::{CODES, Status};
use crate::told::Candidate;
use crate::watched::SummaryForm;

macro_rules! field {
    ($struct:ty, $field:ident, $type:ty, $about:literal) => {
        Field {
            name: stringify!($field),
            c_type: <$type as CType>::name(),
            offset: offset_of!($struct, $field),
            about: &[$about],
        }
    };
}

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
    axes::<T, 3>(header);
    axes::<T, 6>(header);
    summary::<T>(header);
    let fields = [
        field!(ScrewForm<T>, translation, [T; 3], "The part of translation: m/s, m, N, or J."),
        field!(ScrewForm<T>, rotation, [T; 3], "The part of rotation: rad/s, rad, N.m, or J."),
    ];
    header.fields(&ScrewForm::<T>::name(), size_of::<ScrewForm<T>>(), &fields);
    let fields = [
        field!(PoseForm<T>, position, [T; 3], "Position of the reference point, m."),
        field!(
            PoseForm<T>,
            quaternion,
            [T; 4],
            "Orientation as a quaternion: x, y, z, w. Of length near 1: the length is divided out, unless it is 0, but a change of it by orders of magnitude costs digits."
        ),
    ];
    header.fields(&PoseForm::<T>::name(), size_of::<PoseForm<T>>(), &fields);
}

fn summary<T: Named>(header: &mut Header) {
    let fields = [
        field!(SummaryForm<T>, ticks, u64, "Number of ticks."),
        field!(SummaryForm<T>, active, T, "Number of ticks with an injected damping above 0."),
        field!(SummaryForm<T>, rejected, T, "Number of ticks whose sample was not accepted."),
        field!(SummaryForm<T>, now, T, "The observed energy now, J."),
        field!(
            SummaryForm<T>,
            least,
            T,
            "The least observed energy so far, J; below 0 it is the largest debt."
        ),
        field!(SummaryForm<T>, most, T, "The most observed energy so far, J."),
        field!(
            SummaryForm<T>,
            asked,
            T,
            "Energy that the injected damping was meant to dissipate, J."
        ),
        field!(
            SummaryForm<T>,
            absorbed,
            T,
            "Energy that flowed through the port into the environment, J; below 0 the port gave energy away."
        ),
        field!(SummaryForm<T>, shortfall, T, "The shortfall now, J."),
        field!(SummaryForm<T>, largest_shortfall, T, "The largest shortfall so far, J."),
    ];
    header.fields(&SummaryForm::<T>::name(), size_of::<SummaryForm<T>>(), &fields);
}

fn axes<T: Named, const N: usize>(header: &mut Header) {
    let fields = [field!(AxesForm<T, N>, axis, [T; N], "The axes.")];
    header.fields(&AxesForm::<T, N>::name(), size_of::<AxesForm<T, N>>(), &fields);
}

fn port<V: Port<Form: CType, Scalar: CType> + Suffix>(header: &mut Header) {
    sample::<V>(header);
    correction::<V>(header);
    checked::<V>(header);
    wave::<V>(header);
    candidate::<V>(header);
}

fn sample<V: Port<Form: CType, Scalar: CType> + Suffix>(header: &mut Header) {
    type Sample<V> = SampleForm<V>;
    let fields = [
        field!(Sample<V>, period, V::Scalar, "Time since the last call, s: above 0 and finite."),
        field!(Sample<V>, position, V::Form, "Position now, m."),
        field!(Sample<V>, velocity, V::Form, "Velocity now, m/s."),
        field!(Sample<V>, displacement, V::Form, "Displacement since the last call, m."),
        field!(
            Sample<V>,
            applied,
            V::Form,
            "The effort applied last, N: after saturation and delay."
        ),
        field!(
            Sample<V>,
            work,
            V::Form,
            "Work of the applied efforts since the last call, on each axis, J: applied times displacement under one held effort."
        ),
    ];
    header.fields(&Sample::<V>::name(), size_of::<Sample<V>>(), &fields);
}

fn correction<V: Port<Form: CType, Scalar: CType> + Suffix>(header: &mut Header) {
    type Out<V> = CorrectionForm<V>;
    let fields = [
        field!(Out<V>, effort, V::Form, "The effort to command, correction included, N."),
        field!(
            Out<V>,
            observed_energy,
            V::Scalar,
            "The observed energy before this tick's correction, J."
        ),
        field!(
            Out<V>,
            alpha,
            V::Scalar,
            "The damping injected on this tick, N.s/m; 0 from a block that corrects in another way."
        ),
        field!(
            Out<V>,
            shortfall,
            V::Scalar,
            "The part of the debt that this tick's correction cannot serve, J; it stays."
        ),
        field!(
            Out<V>,
            accepted,
            u32,
            "1 if the sample was accepted; else 0, with a zero effort or with what a watchdog holds."
        ),
        field!(Out<V>, code, u32, "What the call returned."),
    ];
    header.fields(&Out::<V>::name(), size_of::<Out<V>>(), &fields);
}

fn checked<V: Port<Form: CType, Scalar: CType> + Suffix>(header: &mut Header) {
    type Checked<V> = CheckedForm<V>;
    let fields = [
        field!(
            Checked<V>,
            sample,
            SampleForm<V>,
            "The sample, for your controller and a stabilizer. Of a reading that was not accepted it stands still, and its work is NaN, so that a stabilizer that reads the work rejects it; a sampled account does not read it: look at `accepted`."
        ),
        field!(Checked<V>, accepted, u32, "1 if the reading was accepted, else 0."),
        field!(
            Checked<V>,
            jumped,
            u32,
            "1 if the position was farther away than the fastest motion leads."
        ),
        field!(Checked<V>, late, u32, "1 if a tick was missed since the last accepted reading."),
        field!(Checked<V>, timed, u32, "1 if the time could be used; always 1 at a fixed period."),
    ];
    header.fields(&Checked::<V>::name(), size_of::<Checked<V>>(), &fields);
}

fn wave<V: Port<Form: CType, Scalar: CType> + Suffix>(header: &mut Header) {
    type Wave<V> = WaveForm<V>;
    let fields = [
        field!(Wave<V>, flow, V::Form, "The flow, m/s."),
        field!(Wave<V>, effort, V::Form, "The effort, N."),
        field!(Wave<V>, there, V::Form, "The wave that travels with the flow, root of W."),
        field!(Wave<V>, back, V::Form, "The wave that comes back, root of W."),
    ];
    header.fields(&Wave::<V>::name(), size_of::<Wave<V>>(), &fields);
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
