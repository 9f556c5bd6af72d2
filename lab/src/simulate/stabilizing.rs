//! Stabilizer of a run, as reports name it.

use std::any::type_name;
use std::borrow::Cow;

use crate::files::scene::Stabilizer;

/// Stabilizer of a run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Stabilizing {
    /// What a table says; none without one.
    Table(Option<Stabilizer>),
    /// A value of the caller's, by the name of its type, or another that the caller gave it.
    Foreign(Cow<'static, str>),
}

impl Stabilizing {
    /// A value of the type `S`, by its name without path and parameters.
    pub(crate) fn foreign<S>() -> Self {
        let path = type_name::<S>();
        let name = path.split('<').next().unwrap_or(path);
        Self::Foreign(name.rsplit("::").next().unwrap_or(name).into())
    }

    /// Whether it is the caller's own, which may reject any sample.
    pub(crate) fn is_own(&self) -> bool {
        matches!(self, Self::Foreign(_) | Self::Table(Some(Stabilizer::Own(_))))
    }

    /// Whether there is a stabilizer.
    pub(crate) fn is_there(&self) -> bool {
        *self != Self::Table(None)
    }
}
