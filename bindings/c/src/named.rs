//! Names that refused parameters have in C.

use lyapunov::ParameterError;

/// Result of a constructor; a refusal has the name of the block's field.
///
/// For fields of which [`NAMES`] cannot tell: a damping is the device's in one block and the wall's in another.
pub(crate) fn named<R>(
    field: &'static str,
    made: Result<R, ParameterError>,
) -> Result<R, ParameterError> {
    made.map_err(|error| ParameterError { parameter: field, ..error })
}

/// Parameters of the library that fields and arguments have other names for.
///
/// Only a text is made by them, so that a program which asks for none does without.
const NAMES: [(&str, &str); 37] = [
    ("barrier decay", "decay"),
    ("compensation speed", "speed"),
    ("correction rate", "rate"),
    ("damping cap", "cap"),
    ("damping limit", "damping_limit"),
    ("damping", "device_damping"),
    ("debt carried over", "debt"),
    ("device damping", "damping"),
    ("fastest motion", "fastest"),
    ("fastest rotation", "fastest_rotation"),
    ("fastest translation", "fastest_translation"),
    ("filter cutoff", "cutoff"),
    ("follower damping", "damping"),
    ("follower stiffness", "stiffness"),
    ("granted credit", "energy"),
    ("memory depth", "depth"),
    ("mobility cap", "cap"),
    ("most stored credit", "most"),
    ("plausible effort", "effort"),
    ("plausible speed", "speed"),
    ("rise ticks", "ticks"),
    ("shared part", "share"),
    ("spread ticks", "ticks"),
    ("tank ceiling", "ceiling"),
    ("tank floor", "floor"),
    ("tank gain", "gain"),
    ("tank level", "level"),
    ("tank power", "power"),
    ("tank start", "start"),
    ("velocity threshold", "velocity"),
    ("watchdog hold", "hold"),
    ("watchdog rise", "rise"),
    ("wave filter share", "share"),
    ("wave impedance", "impedance"),
    ("weight", "weights"),
    ("window band", "band"),
    ("window ticks", "ticks"),
];

/// The name in C, where it is another.
pub(crate) fn in_c(parameter: &[u8]) -> Option<&'static str> {
    NAMES.iter().find(|(name, _)| name.as_bytes() == parameter).map(|(_, field)| *field)
}
