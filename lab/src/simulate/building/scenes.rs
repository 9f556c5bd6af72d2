//! Scenes that a loop is built of.

use std::ops::Deref;

use lyapunov::{OnePort, Plant, bodies::OperatedBody};

use super::body::AnyBody;
use super::on::On;
use super::{AnyPlant, Port, Space};
use crate::files::scene::{Lanes, Scene};
use crate::simulate::instructions::Instructions;

/// The scenes of the lanes of a loop, alike in all but numbers, and the instructions that its boxes run on; a loop of
/// one scene is the case of one lane.
#[derive(Clone, Copy, Debug)]
pub struct Scenes<'a> {
    lanes: Lanes<'a, Scene>,
    instructions: Instructions,
}

impl<'a> Scenes<'a> {
    /// One scene, in each lane if there are several.
    pub(crate) fn of(scene: &'a Scene) -> Self {
        Self::on(std::slice::from_ref(scene), Instructions::Base)
    }

    /// The `scenes` of the lanes of a loop on `instructions`.
    pub(crate) fn on(scenes: &'a [Scene], instructions: Instructions) -> Self {
        Self { lanes: Lanes::new(scenes), instructions }
    }

    /// The instructions that boxes run on.
    pub(crate) fn instructions(self) -> Instructions {
        self.instructions
    }

    /// `port` in a box.
    pub(super) fn port<V: Space>(self, port: impl OnePort<V> + 'static) -> Port<V> {
        Port::new(On::new(port, self.instructions))
    }

    /// `port` as a part of a larger one: by itself, or in a box where loops are small rather than fast.
    pub(super) fn part<V: Space, P: OnePort<V> + 'static>(
        self,
        port: P,
    ) -> impl OnePort<V> + 'static + use<V, P> {
        #[cfg(not(feature = "every-scalar"))]
        let port = self.port(port);
        port
    }

    /// `plant` in a box.
    pub(super) fn plant<V: Space>(self, plant: impl Plant<V> + 'static) -> AnyPlant<V> {
        AnyPlant::new(On::new(plant, self.instructions))
    }

    /// `body` in a box.
    pub(super) fn body<V: Space, B>(self, body: B) -> AnyBody<V, B::Parts>
    where
        B: OperatedBody<V, Parts: Copy> + 'static,
    {
        AnyBody::new(On::new(body, self.instructions))
    }
}

impl<'a> Deref for Scenes<'a> {
    type Target = Lanes<'a, Scene>;

    fn deref(&self) -> &Lanes<'a, Scene> {
        &self.lanes
    }
}
