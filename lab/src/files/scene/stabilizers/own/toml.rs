//! Reading and writing of the table of an own stabilizer.

use std::fmt;

use serde::de::{DeserializeSeed, Deserializer, Error, MapAccess, Visitor};
use serde::ser::{Serialize, SerializeMap, Serializer};

use super::super::kind::Numbers;
use super::{Declared, OwnNumber, OwnTable};

impl Serialize for OwnTable {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (key, is_whole, number) in self.entries() {
            match is_whole {
                true => map.serialize_entry(key, &(number as i64))?,
                false => map.serialize_entry(key, &number)?,
            }
        }
        map.end()
    }
}

/// Reader of the table of this stabilizer.
pub(in super::super) struct OwnSeed(pub(in super::super) &'static Declared);

impl<'de> DeserializeSeed<'de> for OwnSeed {
    type Value = OwnTable;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<OwnTable, D::Error> {
        deserializer.deserialize_struct(self.0.name, &self.0.names, self)
    }
}

impl<'de> Visitor<'de> for OwnSeed {
    type Value = OwnTable;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a table")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<OwnTable, A::Error> {
        let mut table = OwnTable::of(self.0);
        while let Some(number) = map.next_key_seed(KeySeed(self.0))? {
            let value = map.next_value_seed(NumberSeed(number))?;
            table.write(number.key, value).map_err(A::Error::custom)?;
        }
        Ok(table)
    }
}

/// Reader of a key of this stabilizer.
struct KeySeed(&'static Declared);

impl<'de> DeserializeSeed<'de> for KeySeed {
    type Value = &'static OwnNumber;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<Self::Value, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for KeySeed {
    type Value = &'static OwnNumber;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a key")
    }

    fn visit_str<E: Error>(self, given: &str) -> Result<Self::Value, E> {
        let found = self.0.numbers.iter().find(|number| number.key == given);
        found.ok_or_else(|| E::unknown_field(given, &self.0.names))
    }
}

/// Reader of the value of this number: checked here, where the place of the value is known.
struct NumberSeed(&'static OwnNumber);

impl<'de> DeserializeSeed<'de> for NumberSeed {
    type Value = f64;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<f64, D::Error> {
        match self.0.allowed.is_whole() {
            true => deserializer.deserialize_i64(self),
            false => deserializer.deserialize_f64(self),
        }
    }
}

impl Visitor<'_> for NumberSeed {
    type Value = f64;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a number")
    }

    fn visit_f64<E: Error>(self, number: f64) -> Result<f64, E> {
        self.0.allowed.check(number).map_err(E::custom)
    }

    fn visit_i64<E: Error>(self, number: i64) -> Result<f64, E> {
        self.visit_f64(number as f64)
    }

    fn visit_u64<E: Error>(self, number: u64) -> Result<f64, E> {
        self.visit_f64(number as f64)
    }
}
