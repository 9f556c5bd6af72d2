//! A deserializer that hands a TOML tree to serde and keeps the place and kind of every fault.

use std::vec;

use serde::de::value::StrDeserializer;
use serde::de::{DeserializeSeed, Deserializer, IntoDeserializer, MapAccess, SeqAccess, Visitor};
use serde::forward_to_deserialize_any;
use toml::Spanned;
use toml::de::{DeArray, DeString, DeTable, DeValue};

use super::choice::Choice;
use super::fault::{Fault, Found, Place, Problem};
use super::number;

/// One value of the tree.
#[derive(Clone, Debug)]
pub(super) struct Reader<'tree, 'text> {
    value: &'tree DeValue<'text>,
    place: Place,
}

impl<'tree, 'text> Reader<'tree, 'text> {
    pub(super) fn new(value: &'tree DeValue<'text>, place: Place) -> Self {
        Self { value, place }
    }

    fn wrong_kind(&self, expected: &'static str) -> Fault {
        let found = found(self.value);
        Fault::new(Problem::WrongKind { expected, found }).at(&self.place)
    }

    fn too_large(&self) -> Fault {
        Fault::new(Problem::Refused {
            sentence: "must be a number that 64 bits can hold".to_owned(),
        })
        .at(&self.place)
    }

    fn visit_table<V: Visitor<'tree>>(
        self,
        table: &'tree DeTable<'text>,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_map(Entries::new(table, &self.place)).map_err(|fault| fault.at(&self.place))
    }
}

impl<'tree> Deserializer<'tree> for Reader<'tree, '_> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            DeValue::String(text) => visitor.visit_str(text),
            DeValue::Integer(whole) => match number::whole(whole) {
                Some(whole) => visitor.visit_i64(whole),
                None => Err(self.too_large()),
            },
            DeValue::Float(float) => match number::real_of_float(float) {
                Some(real) => visitor.visit_f64(real),
                None => Err(self.too_large()),
            },
            DeValue::Boolean(truth) => visitor.visit_bool(*truth),
            DeValue::Datetime(_) => Err(self.wrong_kind("something other than a date")),
            DeValue::Array(list) => visitor.visit_seq(Items::new(list, &self.place)),
            DeValue::Table(table) => self.visit_table(table, visitor),
        }
    }

    fn deserialize_f64<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        let real = match self.value {
            DeValue::Integer(whole) => number::real_of_integer(whole),
            DeValue::Float(float) => number::real_of_float(float),
            _ => return Err(self.wrong_kind("a number")),
        };
        match real {
            Some(real) => visitor.visit_f64(real),
            None => Err(self.too_large()),
        }
    }

    fn deserialize_f32<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.deserialize_f64(visitor)
    }

    fn deserialize_i64<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            DeValue::Integer(whole) => match number::whole(whole) {
                Some(whole) => visitor.visit_i64(whole),
                None => Err(self.too_large()),
            },
            _ => Err(self.wrong_kind("a whole number")),
        }
    }

    fn deserialize_u64<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            DeValue::Integer(whole) => match number::natural(whole) {
                Some(whole) => visitor.visit_u64(whole),
                None => self.deserialize_i64(visitor),
            },
            _ => Err(self.wrong_kind("a whole number")),
        }
    }

    fn deserialize_bool<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            DeValue::Boolean(truth) => visitor.visit_bool(*truth),
            _ => Err(self.wrong_kind("true or false")),
        }
    }

    fn deserialize_str<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            DeValue::String(text) => visitor.visit_str(text),
            _ => Err(self.wrong_kind("a text in quotes")),
        }
    }

    fn deserialize_string<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.deserialize_str(visitor)
    }

    fn deserialize_seq<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            DeValue::Array(list) => visitor.visit_seq(Items::new(list, &self.place)),
            _ => Err(self.wrong_kind("a list")),
        }
    }

    fn deserialize_map<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value {
            DeValue::Table(table) => self.visit_table(table, visitor),
            _ => Err(self.wrong_kind("a table")),
        }
    }

    fn deserialize_struct<V: Visitor<'tree>>(
        self,
        _name: &'static str,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.deserialize_map(visitor)
    }

    fn deserialize_option<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'tree>>(
        self,
        _name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_enum<V: Visitor<'tree>>(
        self,
        _name: &'static str,
        known: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let choice = match self.value {
            DeValue::String(word) => Choice::word(word, &self.place),
            DeValue::Table(table) => Choice::only_entry(table, &self.place, known)?,
            other => {
                let found = found(other);
                return Err(Fault::new(Problem::NotWord { known, found }).at(&self.place));
            }
        };
        visitor.visit_enum(choice)
    }

    forward_to_deserialize_any! {
        <V: Visitor<'tree>>
        i8 i16 i32 i128 u8 u16 u32 u128 char bytes byte_buf unit unit_struct tuple tuple_struct identifier ignored_any
    }
}

/// The kind of a value.
pub(super) fn found(value: &DeValue<'_>) -> Found {
    match value {
        DeValue::String(_) => Found::Value("the text"),
        DeValue::Integer(_) | DeValue::Float(_) => Found::Value("the number"),
        DeValue::Boolean(_) => Found::Value("the truth value"),
        DeValue::Datetime(_) => Found::Value("the date or time"),
        DeValue::Array(_) => Found::Structure("a list"),
        DeValue::Table(_) => Found::Structure("a table"),
    }
}

/// A key and its value.
pub(super) type Entry<'tree, 'text> =
    (&'tree Spanned<DeString<'text>>, &'tree Spanned<DeValue<'text>>);

/// The entries in the order of the text, so that the first fault in the file is reported.
pub(super) fn in_order<'tree, 'text>(table: &'tree DeTable<'text>) -> Vec<Entry<'tree, 'text>> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
}

/// The entries of a table, one after the other.
struct Entries<'tree, 'text> {
    entries: vec::IntoIter<Entry<'tree, 'text>>,
    value: Option<Reader<'tree, 'text>>,
    table: Place,
}

impl<'tree, 'text> Entries<'tree, 'text> {
    fn new(table: &'tree DeTable<'text>, place: &Place) -> Self {
        Self { entries: in_order(table).into_iter(), value: None, table: place.clone() }
    }
}

impl<'tree> MapAccess<'tree> for Entries<'tree, '_> {
    type Error = Fault;

    fn next_key_seed<K: DeserializeSeed<'tree>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, Fault> {
        let Some((key, value)) = self.entries.next() else {
            return Ok(None);
        };
        let name: &str = key.get_ref();
        self.value = Some(Reader::new(value.get_ref(), self.table.child(name, value.span())));
        let name: StrDeserializer<'_, Fault> = name.into_deserializer();
        seed.deserialize(name)
            .map(Some)
            .map_err(|fault| fault.at(&self.table.child(key.get_ref(), key.span())))
    }

    fn next_value_seed<V: DeserializeSeed<'tree>>(&mut self, seed: V) -> Result<V::Value, Fault> {
        let Some(reader) = self.value.take() else {
            return Err(serde::de::Error::custom("has no value"));
        };
        let place = reader.place.clone();
        seed.deserialize(reader).map_err(|fault| fault.at(&place))
    }
}

/// The items of a list, one after the other.
struct Items<'tree, 'text> {
    items: std::iter::Enumerate<std::slice::Iter<'tree, Spanned<DeValue<'text>>>>,
    list: Place,
}

impl<'tree, 'text> Items<'tree, 'text> {
    fn new(list: &'tree DeArray<'text>, place: &Place) -> Self {
        Self { items: list.iter().enumerate(), list: place.clone() }
    }
}

impl<'tree> SeqAccess<'tree> for Items<'tree, '_> {
    type Error = Fault;

    fn next_element_seed<T: DeserializeSeed<'tree>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Fault> {
        let Some((index, item)) = self.items.next() else {
            return Ok(None);
        };
        let place = Place {
            name: format!("{}[{index}]", self.list.name),
            ..self.list.spanning(item.span())
        };
        seed.deserialize(Reader::new(item.get_ref(), place.clone()))
            .map(Some)
            .map_err(|fault| fault.at(&place))
    }
}
