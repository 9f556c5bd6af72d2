//! Stabilizer of a loop, at its place.

use std::any::TypeId;

use lyapunov::{
    Correction, OnePort, ParameterError, PortSample, Requirement, Scalar, Signal, Stabilizer,
    stabilizers::NoStabilizer,
};

use super::{AnyStabilizer, AnyWrapper, Port, Scenes, Space};
use crate::files::scene::own::{Loop, OwnTable};
use crate::files::scene::{self, Basis, Install, Lanes, Pace, Scene, elsewhere};
use crate::simulate::instructions::Instructions;

/// Stabilizer of a loop: one behind the hold, which sees the environment's efforts only, or a port around the
/// environment, which asks it.
#[derive(Debug)]
pub enum Fitted<V: Signal> {
    /// A stabilizer of efforts.
    Behind(AnyStabilizer<V>),
    /// A port around the environment.
    Around(AnyWrapper<V>),
}

impl<V: Space> Fitted<V> {
    /// What `scene` names; [`NoStabilizer`] if it names none.
    ///
    /// # Errors
    /// A parameter that is right by itself but out of the range of the scalar, alone or with others.
    pub fn of(scene: &Scene) -> Result<Self, ParameterError> {
        Self::named(scene, scene.stabilizer)
    }

    /// What a table asks for on the loop of `scene`, whatever `scene` names; [`NoStabilizer`] without a table.
    ///
    /// # Errors
    /// As [`Fitted::of`]; a table that lacks a number which the loop does not give.
    pub fn named(scene: &Scene, table: Option<scene::Stabilizer>) -> Result<Self, ParameterError> {
        Self::on(Scenes::of(scene), &[table])
    }

    /// What the tables, one for each scene and alike in all but numbers, ask for.
    ///
    /// # Errors
    /// As [`Fitted::named`].
    pub(crate) fn on(
        scenes: Scenes<'_>,
        tables: &[Option<scene::Stabilizer>],
    ) -> Result<Self, ParameterError> {
        let tables: Option<Vec<scene::Stabilizer>> = tables.iter().copied().collect();
        V::fitted(tables.as_deref(), scenes)
    }

    /// The same, with the members of the family from `member`.
    pub(super) fn asked(
        tables: Option<&[scene::Stabilizer]>,
        scenes: Scenes<'_>,
        member: impl FnOnce(Scenes<'_>, &[scene::Stabilizer]) -> Result<Self, ParameterError>,
    ) -> Result<Self, ParameterError> {
        let Some(tables) = tables else {
            let nothing = AnyStabilizer::fused(NoStabilizer, scenes.instructions());
            return Ok(Self::Behind(nothing));
        };
        match Lanes::new(tables).common() {
            scene::Stabilizer::Popc(_) | scene::Stabilizer::Lolc(_) => {
                AnyStabilizer::observing(scenes, tables).map(Self::Behind)
            }
            _ => member(scenes, tables),
        }
    }

    /// The member that a table asks for in several dimensions, on the loop of one scene.
    pub(super) fn in_space(
        scenes: Scenes<'_>,
        tables: &[scene::Stabilizer],
    ) -> Result<Self, ParameterError> {
        let (basis, table) = (&Basis::of(scenes.common()), Lanes::new(tables).common());
        lacking(basis, table)?;
        match table {
            scene::Stabilizer::Own(own) => Self::own(basis, own),
            table => table.in_space(basis, Boxing(Instructions::Base)),
        }
    }

    /// What the table of an own stabilizer asks for, on a loop with this basis.
    fn own(basis: &Basis, table: &OwnTable) -> Result<Self, ParameterError> {
        let made = (table.own().make())(TypeId::of::<V>(), &Loop::new(basis, table));
        let made = made.and_then(|made| made.downcast().ok());
        let made: Result<AnyStabilizer<V>, _> = made.map_or_else(|| Err(elsewhere()), |made| *made);
        made.map(Self::Behind)
    }

    /// The stabilizer of efforts, if it is one.
    pub fn behind(self) -> Option<AnyStabilizer<V>> {
        match self {
            Self::Behind(stabilizer) => Some(stabilizer),
            Self::Around(_) => None,
        }
    }

    /// Bytes that it keeps from tick to tick, parameters included.
    pub fn state_bytes(&self) -> usize {
        match self {
            Self::Behind(stabilizer) => stabilizer.state_bytes(),
            Self::Around(wrapper) => wrapper.state_bytes(),
        }
    }

    /// Runs it over `samples` in order; an environment answers with the recorded efforts.
    ///
    /// # Errors
    /// A parameter out of the range of the scalar.
    pub(crate) fn replay(
        &mut self,
        samples: &[(PortSample<V>, V)],
        corrections: &mut [Correction<V>],
    ) -> Result<(), ParameterError> {
        match self {
            Self::Behind(stabilizer) => stabilizer.replay(samples, corrections),
            Self::Around(wrapper) => wrapper.replay(samples, corrections)?,
        }
        Ok(())
    }

    /// The wrapper of this pace, if it is one.
    pub(super) fn around(&self, pace: Pace) -> Option<&AnyWrapper<V>> {
        match self {
            Self::Around(wrapper) if wrapper.pace() == pace => Some(wrapper),
            _ => None,
        }
    }
}

impl<T: Scalar + Space> Fitted<T> {
    /// The member that the tables, one for each scene, ask for in one dimension.
    pub(super) fn on_a_line(
        scenes: Scenes<'_>,
        tables: &[scene::Stabilizer],
    ) -> Result<Self, ParameterError> {
        let bases: Vec<Basis> = scenes.values().iter().map(Basis::of).collect();
        Self::on_bases(&bases, tables, scenes.instructions())
    }

    /// The same on loops with these bases.
    pub(crate) fn on_bases(
        bases: &[Basis],
        tables: &[scene::Stabilizer],
        instructions: Instructions,
    ) -> Result<Self, ParameterError> {
        bases.iter().zip(tables).try_for_each(|(basis, table)| lacking(basis, table))?;
        match Lanes::new(tables).common() {
            scene::Stabilizer::Own(own) => Self::own(Lanes::new(bases).common(), own),
            _ => scene::Stabilizer::on_a_line(tables, bases, Boxing(instructions)),
        }
    }
}

/// The error of a loop without what the stabilizer is set by.
fn lacking(basis: &Basis, table: &scene::Stabilizer) -> Result<(), ParameterError> {
    let lacks = table.kind().lacks(basis);
    lacks.map_or(Ok(()), |key| Requirement::Positive.check(key, 0.0).map(drop))
}

/// Boxing of a member of the family, with its steps on some instructions.
struct Boxing(Instructions);

impl<V: Space> Install<V> for Boxing {
    type Made = Fitted<V>;
    type Port = Port<V>;

    fn behind(self, stabilizer: impl Stabilizer<V> + 'static) -> Fitted<V> {
        Fitted::Behind(AnyStabilizer::called_on(stabilizer, self.0))
    }

    fn around<P: OnePort<V> + 'static>(
        self,
        pace: Pace,
        wrap: impl Fn(Port<V>) -> Result<P, ParameterError> + 'static,
    ) -> Fitted<V> {
        Fitted::Around(AnyWrapper::new(pace, wrap, self.0))
    }
}
