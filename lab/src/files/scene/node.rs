//! Value in a TOML tree: of a text that was read, or of a tree that was made.

use std::ops::Range;

use toml::Value;
use toml::de::{DeTable, DeValue};

use super::number;

/// A value in a tree.
#[derive(Clone, Copy, Debug)]
pub(super) enum Node<'tree, 'text> {
    /// In the tree of a text; its numbers are still text.
    Read(&'tree DeValue<'text>),
    /// In a tree that was made, without places.
    Made(&'tree Value),
}

/// The value itself.
pub(super) enum Content<'tree, 'text> {
    Text(&'tree str),
    Whole(Whole),
    /// A number with a point or an exponent; none if it is beyond the range of f64.
    Real(Option<f64>),
    Truth(bool),
    Date,
    List(Vec<Item<'tree, 'text>>),
    /// The entries in the order of the text, so that the first fault in the file is reported.
    Table(Vec<Entry<'tree, 'text>>),
}

/// A whole number in each type that can hold it.
pub(super) struct Whole {
    pub(super) signed: Option<i64>,
    pub(super) natural: Option<u64>,
    pub(super) real: Option<f64>,
}

/// A value with its bytes in the text.
#[derive(Clone, Debug)]
pub(super) struct Item<'tree, 'text> {
    pub(super) node: Node<'tree, 'text>,
    pub(super) span: Range<usize>,
}

/// A key and its value.
#[derive(Clone, Debug)]
pub(super) struct Entry<'tree, 'text> {
    pub(super) name: &'tree str,
    pub(super) span: Range<usize>,
    pub(super) value: Item<'tree, 'text>,
}

impl<'tree, 'text> Node<'tree, 'text> {
    pub(super) fn content(self) -> Content<'tree, 'text> {
        match self {
            Self::Read(value) => read(value),
            Self::Made(value) => made(value),
        }
    }
}

fn read<'tree, 'text>(value: &'tree DeValue<'text>) -> Content<'tree, 'text> {
    match value {
        DeValue::String(text) => Content::Text(text),
        DeValue::Integer(it) => Content::Whole(Whole {
            signed: number::whole(it),
            natural: number::natural(it),
            real: number::real_of_integer(it),
        }),
        DeValue::Float(it) => Content::Real(number::real_of_float(it)),
        DeValue::Boolean(truth) => Content::Truth(*truth),
        DeValue::Datetime(_) => Content::Date,
        DeValue::Array(list) => {
            let item = |it: &'tree toml::Spanned<DeValue<'text>>| Item {
                node: Node::Read(it.get_ref()),
                span: it.span(),
            };
            Content::List(list.iter().map(item).collect())
        }
        DeValue::Table(table) => Content::Table(in_order(table)),
    }
}

fn in_order<'tree, 'text>(table: &'tree DeTable<'text>) -> Vec<Entry<'tree, 'text>> {
    let entries = table.iter().map(|(key, value)| Entry {
        name: key.get_ref(),
        span: key.span(),
        value: Item { node: Node::Read(value.get_ref()), span: value.span() },
    });
    let mut entries: Vec<_> = entries.collect();
    entries.sort_unstable_by_key(|entry| entry.span.start);
    entries
}

fn made<'tree, 'text>(value: &'tree Value) -> Content<'tree, 'text> {
    let item = |value: &'tree Value| Item { node: Node::Made(value), span: 0..0 };
    match value {
        Value::String(text) => Content::Text(text),
        Value::Integer(whole) => Content::Whole(Whole {
            signed: Some(*whole),
            natural: u64::try_from(*whole).ok(),
            real: Some(*whole as f64),
        }),
        Value::Float(real) => Content::Real(Some(*real)),
        Value::Boolean(truth) => Content::Truth(*truth),
        Value::Datetime(_) => Content::Date,
        Value::Array(list) => Content::List(list.iter().map(item).collect()),
        Value::Table(table) => {
            let entry =
                |(name, value): (&'tree String, _)| Entry { name, span: 0..0, value: item(value) };
            Content::Table(table.iter().map(entry).collect())
        }
    }
}
