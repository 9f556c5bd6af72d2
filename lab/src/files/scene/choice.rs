//! A choice of one from several: a word in quotes, or the only table given.

use serde::de::value::StrDeserializer;
use serde::de::{
    DeserializeSeed, Deserializer, EnumAccess, IntoDeserializer, VariantAccess, Visitor,
};

use super::fault::{Fault, Found, Place, Problem};
use super::node::{Entry, Item};
use super::reader::{Reader, found};

/// One word from several, or one table from several with its content.
pub(super) struct Choice<'tree, 'text> {
    word: &'tree str,
    place: Place,
    content: Option<Item<'tree, 'text>>,
}

impl<'tree, 'text> Choice<'tree, 'text> {
    /// A word written as the value itself.
    pub(super) fn word(word: &'tree str, place: &Place) -> Self {
        Self { word, place: place.clone(), content: None }
    }

    /// The only entry of a table that chooses among several things.
    pub(super) fn only_entry(
        entries: &[Entry<'tree, 'text>],
        place: &Place,
        known: &'static [&'static str],
    ) -> Result<Self, Fault> {
        let known_there = entries.iter().any(|entry| known.contains(&entry.name));
        match entries {
            [] => Err(Fault::new(Problem::NoneChosen { known }).at(place)),
            [_, second, ..] if known_there => {
                let chosen = entries.iter().map(|entry| entry.name.to_owned());
                let problem = Problem::SeveralChosen { chosen: chosen.collect(), known };
                Err(Fault::new(problem).at(&place.spanning(second.span.clone())))
            }
            // Of several unknown names the first is reported: most likely they are keys of an inner table.
            [Entry { name, span, value }, ..] => Ok(Self {
                word: name,
                place: place.child(name, span.clone()),
                content: Some(value.clone()),
            }),
        }
    }
}

impl<'tree> EnumAccess<'tree> for Choice<'tree, '_> {
    type Error = Fault;
    type Variant = Self;

    fn variant_seed<V: DeserializeSeed<'tree>>(self, seed: V) -> Result<(V::Value, Self), Fault> {
        let word: StrDeserializer<'_, Fault> = self.word.into_deserializer();
        match seed.deserialize(word) {
            Ok(variant) => Ok((variant, self)),
            Err(fault) => Err(match (fault.into_parts(), self.content) {
                ((Problem::UnknownWord { known }, _), Some(_)) => {
                    Fault::new(Problem::UnknownKey { known })
                }
                ((problem, _), _) => Fault::new(problem),
            }
            .at(&self.place)),
        }
    }
}

impl<'tree> VariantAccess<'tree> for Choice<'tree, '_> {
    type Error = Fault;

    fn unit_variant(self) -> Result<(), Fault> {
        match self.content {
            None => Ok(()),
            Some(content) => Err(Fault::new(Problem::WrongKind {
                expected: "a word in quotes",
                found: found(&content.node.content()),
            })
            .at(&self.place)),
        }
    }

    fn newtype_variant_seed<T: DeserializeSeed<'tree>>(self, seed: T) -> Result<T::Value, Fault> {
        let Some(content) = self.content else {
            return Err(Fault::new(Problem::WrongKind {
                expected: "a table",
                found: Found::Value("the text"),
            })
            .at(&self.place));
        };
        let place = self.place.spanning(content.span);
        seed.deserialize(Reader::new(content.node, place.clone())).map_err(|fault| fault.at(&place))
    }

    fn tuple_variant<V: Visitor<'tree>>(
        self,
        _length: usize,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.newtype_variant_seed(Visited(visitor))
    }

    fn struct_variant<V: Visitor<'tree>>(
        self,
        _fields: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.newtype_variant_seed(Visited(visitor))
    }
}

/// A seed that lets a visitor read a variant's content as a value of its own.
struct Visited<V>(V);

impl<'tree, V: Visitor<'tree>> DeserializeSeed<'tree> for Visited<V> {
    type Value = V::Value;

    fn deserialize<D: Deserializer<'tree>>(self, deserializer: D) -> Result<V::Value, D::Error> {
        deserializer.deserialize_any(self.0)
    }
}
