//! Storing, and a controller to try.

use ciborium::Value;
use serde::{Serialize, de::DeserializeOwned};

use lyapunov::{DampingLimit, Popc, PortEnergy, Scalar};

pub(crate) const PERIOD: f64 = 1e-3;

pub(crate) fn limit<T: Scalar>() -> DampingLimit<T> {
    DampingLimit::of_mass(T::of(0.5), T::of(0.2), T::of(PERIOD)).expect("a limit")
}

pub(crate) fn popc<T: Scalar>() -> Popc<T> {
    Popc::new(PortEnergy, limit())
}

/// The bytes of a state in CBOR, which keeps every bit of a number.
pub(crate) fn stored(state: &impl Serialize) -> Vec<u8> {
    let mut bytes = Vec::new();
    ciborium::into_writer(state, &mut bytes).expect("a state that can be stored");
    bytes
}

pub(crate) fn loaded<S: DeserializeOwned>(bytes: &[u8]) -> S {
    ciborium::from_reader(bytes).expect("a state that was stored")
}

/// Whether every number that was stored is finite, as those of JSON are.
pub(crate) fn has_a_text(bytes: &[u8]) -> bool {
    fn finite(value: &Value) -> bool {
        match value {
            Value::Float(number) => number.is_finite(),
            Value::Array(values) => values.iter().all(finite),
            Value::Map(values) => values.iter().all(|(_, value)| finite(value)),
            _ => true,
        }
    }
    finite(&loaded(bytes))
}

/// The text of a state in JSON: `serde_json` reads back every finite number to the bit, as its feature
/// `float_roundtrip` says.
pub(crate) fn written(state: &impl Serialize) -> String {
    serde_json::to_string(state).expect("a state that can be written")
}

pub(crate) fn read<S: DeserializeOwned>(text: &str) -> S {
    serde_json::from_str(text).expect("a state that was written")
}
