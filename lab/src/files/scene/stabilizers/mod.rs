//! The stabilizers that watch a port.
//!
//! Each has its own file: the keys of its table with their defaults and ranges, the library's stabilizer made from
//! them, and the promises that it makes. The law itself is in the library only. The table below lists them.

mod basis;
mod begun;
mod booking;
mod directed_damping;
mod energy_bounding;
mod force_bound;
mod force_bounding;
mod iss;
mod kind;
mod least_norm;
mod lolc;
mod memory_based;
pub(crate) mod own;
mod path_memory;
mod pledge;
mod popc;
mod popc_bounded;
mod popc_budgeted;
mod popc_contact_reset;
mod popc_rate_limited;
mod popc_reference;
mod popc_rising;
mod popc_spread;
mod popc_threshold;
mod popc_windowed;
mod reference;
mod reference_following;
mod slope_bound;
mod table;
mod tank;
mod virtual_coupling;

use std::fmt;

use lyapunov::{ParameterError, Requirement, Scalar, Signal};
use schemars::JsonSchema;
use serde::de::{self, DeserializeSeed, Deserializer, EnumAccess, VariantAccess, Visitor};
use serde::{Deserialize, Serialize, Serializer};

use crate::files::scene::book::{Key, count, joined};
use crate::files::scene::{Lanes, OutOfRange};
use kind::{Anywhere, OnALine, OnLoops};

pub(crate) use basis::Basis;
pub use booking::{Candidate, Ledger, Work};
pub use directed_damping::Direction;
pub(crate) use kind::{Install, Pace, StabilizerKind};
pub use kind::{Parameter, Search, Spacing};
use own::{OwnSeed, OwnTable};
pub(crate) use pledge::{Credit, LedgerKind, Manner, Pledge};
pub(crate) use reference::Reference;

macro_rules! stabilizers {
    (
        observers { $($(#[$first:meta])* $Observer:ident in $observer:ident;)* }
        family { $($(#[$about:meta])* $Table:ident in $file:ident, $place:ident;)* }
    ) => {
        $(pub use $observer::$Observer;)*
        $(pub use $file::$Table;)*

        /// Stabilizer, which watches the port and keeps the loop bounded.
        #[derive(Clone, Copy, Debug, PartialEq, JsonSchema)]
        #[schemars(rename_all = "kebab-case")]
        pub enum Stabilizer {
            $($(#[$first])* $Observer($Observer),)*
            $($(#[$about])* $Table($Table),)*
            /// One of the program's own, under its own name.
            #[schemars(skip)]
            Own(OwnTable),
        }

        /// The names of the tables that ship.
        const SHIPPED: &[&str] = &[$($observer::NAME,)* $($file::NAME,)*];

        impl Serialize for Stabilizer {
            fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                // The formats of scenes write the name and not its number.
                let name = self.name();
                match self {
                    $(Self::$Observer(it) => serializer.serialize_newtype_variant("Stabilizer", 0, name, it),)*
                    $(Self::$Table(it) => serializer.serialize_newtype_variant("Stabilizer", 0, name, it),)*
                    Self::Own(it) => serializer.serialize_newtype_variant("Stabilizer", 0, name, it),
                }
            }
        }

        impl<'de> Visitor<'de> for Choosing {
            type Value = Stabilizer;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the table of a stabilizer")
            }

            fn visit_enum<A: EnumAccess<'de>>(self, data: A) -> Result<Stabilizer, A::Error> {
                let (name, content) = data.variant_seed(Naming)?;
                match name {
                    $($observer::NAME => content.newtype_variant().map(Stabilizer::$Observer),)*
                    $($file::NAME => content.newtype_variant().map(Stabilizer::$Table),)*
                    own => match own::named(own) {
                        Some(own) => content.newtype_variant_seed(OwnSeed(own)).map(Stabilizer::Own),
                        None => Err(de::Error::unknown_variant(own, own::tables())),
                    },
                }
            }
        }

        /// A stabilizer with one law and one name, which the observers/controllers with a choice of candidates are not.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Member {
            $($(#[$about])* $Table,)*
        }

        const TABLES: &[&[Key]] = &[$($observer::KEYS,)* $($file::KEYS,)*];

        impl Member {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$Table),*];

            /// Its table without a written key.
            pub(crate) fn table(self) -> Stabilizer {
                match self {
                    $(Self::$Table => Stabilizer::$Table($Table::default()),)*
                }
            }

            /// Its name.
            pub fn name(self) -> &'static str {
                match self {
                    $(Self::$Table => $file::NAME,)*
                }
            }
        }

        impl Stabilizer {
            /// The interface of its kind.
            pub(crate) fn kind(&self) -> &dyn StabilizerKind {
                match self {
                    $(Self::$Observer(it) => it,)*
                    $(Self::$Table(it) => it,)*
                    Self::Own(it) => it,
                }
            }

            fn kind_mut(&mut self) -> &mut dyn StabilizerKind {
                match self {
                    $(Self::$Observer(it) => it,)*
                    $(Self::$Table(it) => it,)*
                    Self::Own(it) => it,
                }
            }

            /// Whether it works in one dimension only.
            pub(crate) fn is_on_a_line(&self) -> bool {
                match self {
                    $(Self::$Observer(_) => false,)*
                    $(Self::$Table(_) => stabilizers!(@is_line $place),)*
                    Self::Own(_) => false,
                }
            }

            /// The result of `to` for the library's stabilizer of one dimension, with the numbers of each lane's table on
            /// its own loop; the observers/controllers need more than their loop's [`Basis`], and what is the program's
            /// own a maker from above: they are made elsewhere.
            pub(crate) fn on_a_line<T: Scalar, R: Install<T>>(
                each: &[Self],
                on: &[Basis],
                to: R,
            ) -> Result<R::Made, ParameterError> {
                match Lanes::new(each).common() {
                    $(Self::$Observer(_) => Err(elsewhere()),)*
                    $(Self::$Table(_) => {
                        let tables = stabilizers!(@tables each, $Table)?;
                        let tables: Vec<&$Table> = tables.iter().collect();
                        <$Table as $place>::make(OnLoops::new(&tables, on), to)
                    })*
                    Self::Own(_) => Err(elsewhere()),
                }
            }

            /// The same of several dimensions, for one run.
            pub(crate) fn in_space<V: Signal, R: Install<V>>(
                &self,
                on: &Basis,
                to: R,
            ) -> Result<R::Made, ParameterError> {
                match self {
                    $(Self::$Observer(_) => Err(elsewhere()),)*
                    $(Self::$Table(_it) => stabilizers!(@space $place $Table, _it, on, to),)*
                    Self::Own(_) => Err(elsewhere()),
                }
            }
        }
    };
    (@is_line OnALine) => { true };
    (@is_line Anywhere) => { false };
    (@space OnALine $Table:ident, $it:ident, $on:ident, $to:ident) => {{
        let _ = &$to;
        Err(elsewhere())
    }};
    (@space Anywhere $Table:ident, $it:ident, $on:ident, $to:ident) => {
        <$Table as Anywhere>::make(OnLoops::new(&[$it], std::slice::from_ref($on)), $to)
    };
    (@tables $each:ident, $Table:ident) => {{
        let table = |it: &'_ Stabilizer| match it {
            Stabilizer::$Table(it) => Ok(*it),
            _ => Err(elsewhere()),
        };
        $each.iter().map(table).collect::<Result<Vec<$Table>, _>>()
    }};
}

stabilizers! {
    observers {
        /// The Lyapunov observer/controller.
        Lolc in lolc;
        /// The passivity observer/controller.
        Popc in popc;
    }
    family {
        /// The passivity observer/controller with a budget.
        PopcBudgeted in popc_budgeted, Anywhere;
        /// The passivity observer/controller with a bounded credit.
        PopcBounded in popc_bounded, Anywhere;
        /// The passivity observer/controller with a credit that expires.
        PopcWindowed in popc_windowed, Anywhere;
        /// The passivity observer/controller that enters each contact without credit.
        PopcContactReset in popc_contact_reset, OnALine;
        /// The passivity observer/controller above a velocity.
        PopcThreshold in popc_threshold, Anywhere;
        /// The passivity observer/controller that pays in instalments.
        PopcSpread in popc_spread, Anywhere;
        /// The passivity observer/controller with a slow correction.
        PopcRateLimited in popc_rate_limited, Anywhere;
        /// The passivity observer/controller with a soft start.
        PopcRising in popc_rising, Anywhere;
        /// The passivity observer/controller that follows what the environment stores.
        PopcReference in popc_reference, OnALine;
        /// Force bounding with a budget in place of the reset.
        ForceBound in force_bound, Anywhere;
        /// Energy tank.
        Tank in tank, Anywhere;
        /// Energy bounding.
        EnergyBounding in energy_bounding, Anywhere;
        /// Force bounding.
        ForceBounding in force_bounding, Anywhere;
        /// Memory-based passivation.
        MemoryBased in memory_based, OnALine;
        /// Reference energy following.
        ReferenceFollowing in reference_following, OnALine;
        /// The least-norm filter.
        LeastNorm in least_norm, Anywhere;
        /// The input-to-state stable port.
        Iss in iss, Anywhere;
        /// Memory of energies along a path.
        PathMemory in path_memory, OnALine;
        /// A bound of the slope.
        SlopeBound in slope_bound, Anywhere;
        /// The virtual coupling.
        VirtualCoupling in virtual_coupling, Anywhere;
        /// Damping along one direction.
        DirectedDamping in directed_damping, Anywhere;
    }
}

impl<'de> Deserialize<'de> for Stabilizer {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_enum("Stabilizer", own::tables(), Choosing)
    }
}

/// Reader of the one table that chooses a stabilizer.
struct Choosing;

/// Reader of its name.
struct Naming;

impl<'de> DeserializeSeed<'de> for Naming {
    type Value = &'static str;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<&'static str, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Naming {
    type Value = &'static str;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the name of a stabilizer")
    }

    fn visit_str<E: de::Error>(self, given: &str) -> Result<&'static str, E> {
        let found = own::tables().iter().find(|name| **name == given);
        found.copied().ok_or_else(|| E::unknown_variant(given, own::tables()))
    }
}

/// The keys of all stabilizers that ship, for messages.
pub(super) const KEYS: &[Key] = &joined::<{ count(TABLES) }>(TABLES);

impl Stabilizer {
    /// Its name in a scene file.
    pub fn name(&self) -> &'static str {
        self.kind().name()
    }

    /// The number that its table writes under `key`, which is without its table path; none if it has no such key.
    pub fn written(&self, key: &str) -> Option<f64> {
        self.kind().written(key)
    }

    /// Writes a number under `key`, which is without its table path; false if its table has no such key.
    ///
    /// # Errors
    /// A number that the key does not allow.
    pub fn write(&mut self, key: &str, number: f64) -> Result<bool, OutOfRange> {
        self.kind_mut().write(key, number)
    }
}

/// The error of a stabilizer that is not made here, or not in this number of dimensions.
pub(crate) fn elsewhere() -> ParameterError {
    ParameterError { parameter: "dimensions", value: f64::NAN, requirement: Requirement::InRange }
}
