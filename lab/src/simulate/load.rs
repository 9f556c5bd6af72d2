//! Loading of checked files: a file whose parts are each right is right if its loop can be built.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use super::building::{Assembly, in_space};
use super::{models, teleoperation};
use crate::files::models::{self as model_files, Model};
use crate::files::scene::{
    self, Basis, Conflict, Diagnostic, Draft, Keys, MODEL, Open, Scene, TELEOPERATOR,
};
use crate::files::teleoperation::{self as teleoperator_files, Teleoperator};
use crate::text::names::Named;

impl Draft {
    /// Checks the rules between values and returns the scene: the number of ticks, the ratio of the rates, what tables
    /// require of each other, the range of f32 where the run computes in it, and what the blocks of the loop accept.
    ///
    /// # Errors
    /// The first broken rule, and its key.
    pub fn check(self) -> Result<Scene, Conflict> {
        let scene = self.by_rules()?;
        if let Some(stabilizer) = &scene.stabilizer {
            stabilizer.kind().check(&Basis::of(&scene))?;
        }
        // Values that are each allowed may make a loop that is not.
        let built = in_space!(scene, Axes => Assembly::<Axes>::of(&scene).map(drop));
        match built {
            Ok(()) => Ok(scene),
            Err(error) => Err(scene.out_of_range(&error, scene.scalar.name())),
        }
    }
}

impl Scene {
    /// Reads a scene from TOML text; `name` stands for the text in messages, usually the path of its file. Files that
    /// the scene names are looked for in the current folder.
    ///
    /// # Errors
    /// The first broken rule, with its place and what would be right.
    pub fn parse(text: &str, name: &str) -> Result<Self, Diagnostic> {
        Self::parse_beside(text, name, &on_disk)
    }

    /// The same where there are no files: `open` gives the contents of those that the scene names.
    ///
    /// # Errors
    /// Those of [`Scene::parse`].
    pub fn parse_beside(
        text: &str,
        name: &str,
        open: &dyn Fn(&Path) -> io::Result<Box<dyn Read>>,
    ) -> Result<Self, Diagnostic> {
        parse(text, name, Path::new(""), open)
    }

    /// Reads a scene from a file of at most 1 MiB.
    ///
    /// # Errors
    /// Those of [`Scene::parse`], and a file that cannot be read or is no text.
    pub fn load(path: &Path) -> Result<Self, Diagnostic> {
        parse_at(&scene::text_of(&scene::BOOK, path)?, path)
    }
}

/// Reads a scene as [`Scene::parse`] does, with the files that it names in `folder`.
fn parse(text: &str, name: &str, folder: &Path, open: Open<'_>) -> Result<Scene, Diagnostic> {
    scene::read(&scene::BOOK, text, name, |keys| checked(keys, folder, open)).map_err(|fault| {
        let Some(kind) = [MODEL, TELEOPERATOR].into_iter().find(|kind| kind.is_in(text)) else {
            return fault;
        };
        Diagnostic::new(name, format!("this is {}, not a scene", kind.noun))
            .with_help("`lyapunov compare` takes it")
    })
}

/// A file of the disk.
fn on_disk(path: &Path) -> io::Result<Box<dyn Read>> {
    Ok(Box::new(File::open(path)?))
}

fn checked(keys: Keys, folder: &Path, open: Open<'_>) -> Result<Scene, Conflict> {
    let mut draft = Draft::try_from(keys)?;
    draft.read_motion(folder, open)?;
    draft.check()
}

/// Reads the scene in `text`, the contents of the file at `path`.
fn parse_at(text: &str, path: &Path) -> Result<Scene, Diagnostic> {
    let folder = path.parent().unwrap_or(Path::new(""));
    parse(text, &path.display().to_string(), folder, &on_disk)
}

impl Model {
    /// Reads a model from TOML text; `name` stands for the text in messages, usually the path of its file.
    ///
    /// # Errors
    /// The first broken rule, with its place and what would be right.
    pub fn parse(text: &str, name: &str) -> Result<Self, Diagnostic> {
        scene::read(&model_files::BOOK, text, name, |model: Self| model.check().map(|()| model))
    }

    /// Reads a model from a file of at most 1 MiB.
    ///
    /// # Errors
    /// Those of [`Model::parse`], and a file that cannot be read or is no text.
    pub fn load(path: &Path) -> Result<Self, Diagnostic> {
        Self::parse(&scene::text_of(&model_files::BOOK, path)?, &path.display().to_string())
    }

    /// Checks the rules between values: the number of ticks, a number for each state and each input, the range of f32
    /// where the run computes in it, what the blocks of the loop accept, and a start that is not at rest.
    ///
    /// # Errors
    /// The first broken rule, and its key.
    pub fn check(&self) -> Result<(), Conflict> {
        self.check_rules()?;
        let began = models::built(self).map_err(|refused| self.refusal(refused))?.began();
        if began > 0.0 && began.is_finite() {
            return Ok(());
        }
        Err(Conflict::new(
            "initial",
            format!("V is {began:?} at this start"),
            "V is compared with what it was at the start: give a state away from rest at which V is finite and above 0",
        ))
    }
}

impl Teleoperator {
    /// Reads a teleoperator from TOML text; `name` stands for the text in messages, usually the path of its file.
    ///
    /// # Errors
    /// The first broken rule, with its place and what would be right.
    pub fn parse(text: &str, name: &str) -> Result<Self, Diagnostic> {
        Self::parse_for(teleoperation::Entrant::ALL, text, name)
    }

    fn parse_for(
        entrants: &[teleoperation::Entrant],
        text: &str,
        name: &str,
    ) -> Result<Self, Diagnostic> {
        let checked = |it: Self| it.check_for(entrants).map(|()| it);
        scene::read(&teleoperator_files::BOOK, text, name, checked)
    }

    /// Reads a teleoperator from a file of at most 1 MiB.
    ///
    /// # Errors
    /// Those of [`Teleoperator::parse`], and a file that cannot be read or is no text.
    pub fn load(path: &Path) -> Result<Self, Diagnostic> {
        Self::parse(&scene::text_of(&teleoperator_files::BOOK, path)?, &path.display().to_string())
    }

    /// Checks the rules between values: the number of ticks, a start that stores energy, a wall that the slave does not
    /// start in and that is not too stiff for the rate, an impedance for the waves, a seed for random effects, the
    /// range of f32 where the run computes in it, and what the blocks of the loop accept.
    ///
    /// # Errors
    /// The first broken rule, and its key.
    pub fn check(&self) -> Result<(), Conflict> {
        self.check_for(teleoperation::Entrant::ALL)
    }

    /// The same where only these `entrants` take part: what the others need is not asked for.
    ///
    /// # Errors
    /// Those of [`Teleoperator::check`].
    fn check_for(&self, entrants: &[teleoperation::Entrant]) -> Result<(), Conflict> {
        self.check_rules()?;
        if entrants.iter().any(|entrant| entrant.sends_waves()) {
            self.check_impedance()?;
        }
        entrants.iter().copied().try_for_each(|entrant| {
            let built = teleoperation::rig::build(self, entrant);
            built.map_err(|refused| Conflict::beyond(self.scalar, refused))
        })
    }
}

/// Contents of a compared file, told apart by tables that only one kind of file has.
#[derive(Clone, Debug, PartialEq)]
pub enum Subject {
    /// A scene.
    Scene(Box<Scene>),
    /// A model.
    Model(Box<Model>),
    /// A teleoperator.
    Teleoperator(Box<Teleoperator>),
}

impl Subject {
    /// Reads the file once, since it may be a pipe; a teleoperator is checked for these `entrants`.
    ///
    /// # Errors
    /// Those of [`Scene::load`], [`Model::load`] and [`Teleoperator::load`].
    pub fn load(path: &Path, entrants: &[teleoperation::Entrant]) -> Result<Self, Diagnostic> {
        let text = scene::text_of(&scene::BOOK, path)?;
        let name = path.display().to_string();
        if Model::is_in(&text) {
            Model::parse(&text, &name).map(|model| Self::Model(Box::new(model)))
        } else if Teleoperator::is_in(&text) {
            let read = Teleoperator::parse_for(entrants, &text, &name);
            read.map(|it| Self::Teleoperator(Box::new(it)))
        } else {
            parse_at(&text, path).map(|scene| Self::Scene(Box::new(scene)))
        }
    }
}
