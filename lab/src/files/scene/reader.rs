//! A deserializer that hands a TOML tree to serde and keeps the place and kind of every fault.

use std::vec;

use serde::de::value::StrDeserializer;
use serde::de::{DeserializeSeed, Deserializer, IntoDeserializer, MapAccess, SeqAccess, Visitor};
use serde::forward_to_deserialize_any;

use super::choice::Choice;
use super::fault::{Fault, Found, Place, Problem};
use super::node::{Content, Entry, Item, Node, Whole};

/// One value of the tree.
#[derive(Clone, Debug)]
pub(super) struct Reader<'tree, 'text> {
    node: Node<'tree, 'text>,
    place: Place,
}

impl<'tree, 'text> Reader<'tree, 'text> {
    pub(super) fn new(node: Node<'tree, 'text>, place: Place) -> Self {
        Self { node, place }
    }

    fn wrong_kind(&self, expected: &'static str) -> Fault {
        let found = found(&self.node.content());
        Fault::new(Problem::WrongKind { expected, found }).at(&self.place)
    }

    fn too_long(&self, expected: &'static str) -> Fault {
        let sentence = format!("must be {expected}");
        Fault::new(Problem::Refused { sentence }).at(&self.place)
    }

    fn visit_table<V: Visitor<'tree>>(
        self,
        entries: Vec<Entry<'tree, 'text>>,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let place = self.place;
        visitor
            .visit_map(Entries { entries: entries.into_iter(), value: None, table: place.clone() })
            .map_err(|fault| fault.at(&place))
    }

    fn visit_list<V: Visitor<'tree>>(
        self,
        items: Vec<Item<'tree, 'text>>,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        visitor.visit_seq(Items { items: items.into_iter().enumerate(), list: self.place })
    }
}

impl<'tree> Deserializer<'tree> for Reader<'tree, '_> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.node.content() {
            Content::Text(text) => visitor.visit_str(text),
            Content::Whole(Whole { signed: Some(whole), .. }) => visitor.visit_i64(whole),
            Content::Real(Some(real)) => visitor.visit_f64(real),
            Content::Whole(_) => Err(self.too_long("a whole number of 64 bits, sign included")),
            Content::Real(None) => Err(self.too_long("a number of 64 bits")),
            Content::Truth(truth) => visitor.visit_bool(truth),
            Content::Date => Err(self.wrong_kind("something other than a date")),
            Content::List(items) => self.visit_list(items, visitor),
            Content::Table(entries) => self.visit_table(entries, visitor),
        }
    }

    fn deserialize_f64<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        let real = match self.node.content() {
            Content::Whole(Whole { real, .. }) | Content::Real(real) => real,
            _ => return Err(self.wrong_kind("a number")),
        };
        match real {
            Some(real) => visitor.visit_f64(real),
            None => Err(self.too_long("a number of 64 bits")),
        }
    }

    fn deserialize_f32<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.deserialize_f64(visitor)
    }

    fn deserialize_i64<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.node.content() {
            Content::Whole(Whole { signed: Some(whole), .. }) => visitor.visit_i64(whole),
            Content::Whole(_) => Err(self.too_long("a whole number of 64 bits, sign included")),
            _ => Err(self.wrong_kind("a whole number")),
        }
    }

    fn deserialize_u64<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.node.content() {
            Content::Whole(Whole { natural: Some(whole), .. }) => visitor.visit_u64(whole),
            Content::Whole(_) => self.deserialize_i64(visitor),
            _ => Err(self.wrong_kind("a whole number")),
        }
    }

    fn deserialize_bool<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.node.content() {
            Content::Truth(truth) => visitor.visit_bool(truth),
            _ => Err(self.wrong_kind("true or false")),
        }
    }

    fn deserialize_str<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.node.content() {
            Content::Text(text) => visitor.visit_str(text),
            _ => Err(self.wrong_kind("a text in quotes")),
        }
    }

    fn deserialize_string<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        self.deserialize_str(visitor)
    }

    fn deserialize_seq<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.node.content() {
            Content::List(items) => self.visit_list(items, visitor),
            _ => Err(self.wrong_kind("a list")),
        }
    }

    fn deserialize_map<V: Visitor<'tree>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.node.content() {
            Content::Table(entries) => self.visit_table(entries, visitor),
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
        let choice = match self.node.content() {
            Content::Text(word) => Choice::word(word, &self.place),
            Content::Table(entries) => Choice::only_entry(&entries, &self.place, known)?,
            other => {
                let found = found(&other);
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
pub(super) fn found(value: &Content<'_, '_>) -> Found {
    match value {
        Content::Text(_) => Found::Value("the text"),
        Content::Whole(_) | Content::Real(_) => Found::Value("the number"),
        Content::Truth(_) => Found::Value("the truth value"),
        Content::Date => Found::Value("the date or time"),
        Content::List(_) => Found::Structure("a list"),
        Content::Table(_) => Found::Structure("a table"),
    }
}

/// The entries of a table, one after the other.
struct Entries<'tree, 'text> {
    entries: vec::IntoIter<Entry<'tree, 'text>>,
    value: Option<Reader<'tree, 'text>>,
    table: Place,
}

impl<'tree> MapAccess<'tree> for Entries<'tree, '_> {
    type Error = Fault;

    fn next_key_seed<K: DeserializeSeed<'tree>>(
        &mut self,
        seed: K,
    ) -> Result<Option<K::Value>, Fault> {
        let Some(Entry { name, span, value }) = self.entries.next() else {
            return Ok(None);
        };
        self.value = Some(Reader::new(value.node, self.table.child(name, value.span)));
        let key: StrDeserializer<'_, Fault> = name.into_deserializer();
        seed.deserialize(key).map(Some).map_err(|fault| fault.at(&self.table.child(name, span)))
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
    items: std::iter::Enumerate<vec::IntoIter<Item<'tree, 'text>>>,
    list: Place,
}

impl<'tree> SeqAccess<'tree> for Items<'tree, '_> {
    type Error = Fault;

    fn next_element_seed<T: DeserializeSeed<'tree>>(
        &mut self,
        seed: T,
    ) -> Result<Option<T::Value>, Fault> {
        let Some((index, Item { node, span })) = self.items.next() else {
            return Ok(None);
        };
        let place =
            Place { name: format!("{}[{index}]", self.list.name), ..self.list.spanning(span) };
        seed.deserialize(Reader::new(node, place.clone()))
            .map(Some)
            .map_err(|fault| fault.at(&place))
    }
}
