//! Damping along one direction.

use lyapunov::{
    ParameterError, Popc, PortEnergy, Signal,
    stabilizers::{AlongDirection, DirectedDamping as Law},
};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

use super::kind::{Anywhere, Install, OnLoops, StabilizerKind};
use super::table::table;
use super::{Basis, Manner, Pledge};
use crate::files::scene::check::Conflict;
use crate::files::scene::{Coordinates, Finite, Lanes};

table! {
    /// The passivity observer/controller, which dissipates along one direction only.
    DirectedDamping = "directed-damping" {
        words {
            /// Direction in which damping acts, of any length but 0; default: that in which a plane pushes, else the
            /// first axis.
            direction: Option<Direction>, "direction = 1.0";
        }
        numbers {
            damping_cap;
        }
    }
}

impl StabilizerKind for DirectedDamping {
    fn pledge(&self, _on: &Basis) -> Pledge {
        Pledge { manner: Manner::Directs, ..Pledge::POPC }
    }

    fn promises(&self) -> bool {
        true
    }

    fn check(&self, _on: &Basis) -> Result<(), Conflict> {
        if self.direction.is_none_or(|it| it.axes().any(|axis| axis != 0.0)) {
            return Ok(());
        }
        Err(Conflict::new(
            "stabilizer.directed-damping.direction",
            "`stabilizer.directed-damping.direction` is 0 on every axis, which is no direction",
            "give any other vector; its length does not matter",
        ))
    }

    fn vectors(&self) -> Vec<(&'static str, usize)> {
        self.direction.iter().map(|it| ("direction", it.count)).collect()
    }
}

impl Anywhere for DirectedDamping {
    fn make<V: Signal, R: Install<V>>(
        on: OnLoops<'_, Self>,
        to: R,
    ) -> Result<R::Made, ParameterError> {
        let limit = on.limit(Self::damping_cap)?;
        let directions: Vec<Direction> =
            on.pairs().map(|(own, on)| own.direction.unwrap_or(on.normal)).collect();
        let direction = AlongDirection::new(Direction::of_lanes::<V>(&directions))?;
        Ok(to.behind(Law::new(Popc::new(PortEnergy, limit), direction, limit)))
    }
}

/// A direction: a number in one dimension, a list of numbers in two or three.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(from = "Coordinates", into = "Coordinates")]
pub struct Direction {
    axes: [f64; 3],
    count: usize,
}

impl Direction {
    /// The direction of the first axis.
    pub(crate) const FIRST: Self = Self { axes: [1.0, 0.0, 0.0], count: 1 };

    fn axes(self) -> impl Iterator<Item = f64> {
        self.axes.into_iter().take(self.count)
    }

    /// The vectors of all lanes in the signal of a loop.
    fn of_lanes<V: Signal>(each: &[Self]) -> V {
        let mut axis = 0;
        V::zero().map(|_| {
            let along = Lanes::new(each).each(|it| it.axes.get(axis).copied().unwrap_or_default());
            axis += 1;
            along
        })
    }
}

impl From<Coordinates> for Direction {
    fn from(list: Coordinates) -> Self {
        Self { axes: [0, 1, 2].map(|axis| list.axis(axis)), count: list.len() }
    }
}

impl From<Direction> for Coordinates {
    fn from(direction: Direction) -> Self {
        let axes: Result<Vec<Finite>, _> = direction.axes().map(Finite::new).collect();
        axes.map_or_else(|_| Self::default(), Self::from)
    }
}

impl JsonSchema for Direction {
    fn inline_schema() -> bool {
        Coordinates::inline_schema()
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        Coordinates::schema_name()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        Coordinates::json_schema(generator)
    }
}
