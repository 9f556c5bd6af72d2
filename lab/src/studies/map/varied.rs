//! A number that an axis varies: of the scene, or of one stabilizer's table.

use toml::Value;

use super::axis::Axis;
use super::grid::GridError;
use super::vary::{Vary, VaryError};
use crate::files::Scene;
use crate::simulate::family::{StabilizerName, StabilizerNames};

/// A number that an axis varies.
#[derive(Clone, Debug)]
pub(super) enum Varied {
    /// A number of the scene, for every stabilizer; also of the table of a stabilizer that the scene names.
    OfScene(Vary),
    /// A number of the table of a stabilizer that the scene does not name, `stabilizer.NAME.KEY`; the other stabilizers
    /// stay as they are.
    OfStabilizer(StabilizerName, String),
}

impl Varied {
    /// The number that `axis` names in `scene`, whose TOML tree is `tree`, under `members`.
    pub(super) fn of(
        axis: &Axis,
        tree: &Value,
        scene: &Scene,
        members: &StabilizerNames,
    ) -> Result<Self, VaryError> {
        let named = axis.key.strip_prefix("stabilizer.").and_then(|rest| rest.split_once('.'));
        let is_own = |name: &str| scene.stabilizer.is_some_and(|own| own.name() == name);
        let Some((name, key)) = named.filter(|(name, _)| !is_own(name)) else {
            return Vary::of(axis, tree).map(Self::OfScene);
        };
        let problem = || format!("`{}` is of no stabilizer that takes part", axis.key);
        let member: StabilizerName =
            name.parse().map_err(|error| VaryError::new(problem(), format!("{error}")))?;
        if !members.contains(&member) {
            return Err(VaryError::new(problem(), format!("add `{name}` to --stabilizers")));
        }
        let varied = Self::OfStabilizer(member, key.to_owned());
        varied.written(scene, member, axis.value(0)).map(|_| varied)
    }

    /// `scene` with `value` written in the table of `member`, if this is a number of that.
    pub(super) fn written(
        &self,
        scene: &Scene,
        member: StabilizerName,
        value: f64,
    ) -> Result<Option<Scene>, VaryError> {
        let Self::OfStabilizer(name, key) = self else { return Ok(None) };
        if *name != member {
            return Ok(None);
        }
        let written = member.written_in(scene, &[(key, value)]);
        written.map(Some).map_err(|conflict| {
            let problem = format!("`stabilizer.{name}.{key}` = {value:?}: {conflict}");
            VaryError::new(problem, "choose a key of its table and a range that it allows")
        })
    }

    /// The stabilizer whose table it is of.
    pub(super) fn member(&self) -> Option<StabilizerName> {
        match self {
            Self::OfScene(_) => None,
            Self::OfStabilizer(member, _) => Some(*member),
        }
    }
}

/// A scene some of whose numbers are varied.
#[derive(Clone, Debug)]
pub(super) struct Variation {
    scene: Scene,
    tree: Value,
    numbers: Vec<Varied>,
}

impl Variation {
    /// The variation of `scene` along `axes` under `members`.
    ///
    /// # Errors
    /// A member that does not run on so many dimensions; a key that is no number of the scene or of a member.
    pub(super) fn of(
        scene: &Scene,
        axes: &[&Axis],
        members: &StabilizerNames,
    ) -> Result<Self, GridError> {
        members.iter().try_for_each(|it| it.check_axes(scene)).map_err(GridError::Axes)?;
        let tree = Value::try_from(scene);
        let tree = tree.map_err(|error| GridError::Unwritten(error.to_string()))?;
        let numbers = axes.iter().map(|axis| Varied::of(axis, &tree, scene, members));
        let numbers = numbers.collect::<Result<_, _>>()?;
        Ok(Self { scene: scene.clone(), tree, numbers })
    }

    /// The numbers.
    pub(super) fn numbers(&self) -> &[Varied] {
        &self.numbers
    }

    /// The scene with `values` for those of its numbers that are of the scene and have one.
    ///
    /// # Errors
    /// A value that is not whole where it has to be; values that make no scene.
    pub(super) fn scene(&self, values: &[Option<f64>]) -> Result<Result<Scene, String>, VaryError> {
        let mut tree = self.tree.clone();
        for (number, value) in self.numbers.iter().zip(values) {
            if let (Varied::OfScene(number), Some(value)) = (number, value) {
                number.write(&mut tree, *value)?;
            }
        }
        Ok(self.scene.remade(&tree))
    }

    /// `scene` with those `values` that are of the table of `member`.
    ///
    /// # Errors
    /// A value that the table does not allow.
    pub(super) fn under(
        &self,
        mut scene: Scene,
        member: StabilizerName,
        values: &[f64],
    ) -> Result<Scene, VaryError> {
        for (number, value) in self.numbers.iter().zip(values) {
            if let Some(written) = number.written(&scene, member, *value)? {
                scene = written;
            }
        }
        Ok(scene)
    }
}
