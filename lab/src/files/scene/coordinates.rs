//! Coordinates of a position or a direction in the space of a scene.

use std::borrow::Cow;
use std::fmt;

use lyapunov::Scalar;
use nalgebra::SVector;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::SeqAccessDeserializer;
use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use serde::ser::{Serialize, Serializer};

use super::quantity::Finite;

/// Coordinates: a number in one dimension, a list of numbers in two or three; the origin if none is given.
#[derive(Clone, Debug, Default)]
pub struct Coordinates(Vec<Finite>);

impl Coordinates {
    /// The coordinate along axis `index`; 0 past the last one given.
    pub fn axis(&self, index: usize) -> f64 {
        self.0.get(index).map_or(0.0, |value| value.get())
    }

    /// The coordinate in one dimension.
    pub fn get(&self) -> f64 {
        self.axis(0)
    }

    /// The vector in the scalar of a loop.
    pub(crate) fn vector<T: Scalar, const N: usize>(&self) -> SVector<T, N> {
        SVector::from_fn(|index, _| T::of(self.axis(index)))
    }

    /// The same with a number for each axis of a space of so many `dimensions`, where none is given.
    pub(super) fn written_in(self, dimensions: usize) -> Self {
        if self.0.is_empty() && dimensions > 1 {
            return Self(vec![Finite::default(); dimensions]);
        }
        self
    }

    /// The number of coordinates given.
    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }
}

impl From<Finite> for Coordinates {
    fn from(value: Finite) -> Self {
        Self(vec![value])
    }
}

impl From<Vec<Finite>> for Coordinates {
    fn from(values: Vec<Finite>) -> Self {
        Self(values)
    }
}

impl PartialEq for Coordinates {
    fn eq(&self, other: &Self) -> bool {
        (0..self.0.len().max(other.0.len())).all(|index| self.axis(index) == other.axis(index))
    }
}

impl Serialize for Coordinates {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self.0.as_slice() {
            [] => serializer.serialize_f64(0.0),
            [only] => only.serialize(serializer),
            several => several.serialize(serializer),
        }
    }
}

impl<'de> Deserialize<'de> for Coordinates {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(Given)
    }
}

impl JsonSchema for Coordinates {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "Coordinates".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "type": ["number", "array"],
            "items": { "type": "number" },
            "minItems": 1,
            "maxItems": 3
        })
    }
}

struct Given;

impl<'de> Visitor<'de> for Given {
    type Value = Coordinates;

    fn expecting(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("a number, or a list of numbers")
    }

    fn visit_f64<E: Error>(self, value: f64) -> Result<Coordinates, E> {
        Finite::new(value).map(Coordinates::from).map_err(E::custom)
    }

    fn visit_i64<E: Error>(self, value: i64) -> Result<Coordinates, E> {
        self.visit_f64(value as f64)
    }

    fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Coordinates, A::Error> {
        let values = Vec::deserialize(SeqAccessDeserializer::new(list))?;
        if values.is_empty() {
            return Err(A::Error::custom("must have a number for each axis, not an empty list"));
        }
        Ok(Coordinates(values))
    }
}
