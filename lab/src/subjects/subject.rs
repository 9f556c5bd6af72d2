//! A file that `lyapunov compare` takes.

use std::path::Path;

use crate::models::Model;
use crate::scene::{self, Diagnostic, Scene};
use crate::teleoperation::Teleoperator;

/// What is compared, told apart by tables that only one kind of file has.
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
    /// Reads a file, once, as it may be a pipe.
    ///
    /// # Errors
    /// As [`Scene::load`], [`Model::load`] and [`Teleoperator::load`].
    pub fn load(path: &Path) -> Result<Self, Diagnostic> {
        let text = scene::text_of(&scene::BOOK, path)?;
        let name = path.display().to_string();
        if Model::is_in(&text) {
            Model::parse(&text, &name).map(|model| Self::Model(Box::new(model)))
        } else if Teleoperator::is_in(&text) {
            Teleoperator::parse(&text, &name).map(|it| Self::Teleoperator(Box::new(it)))
        } else {
            scene::parse_at(&text, path).map(|scene| Self::Scene(Box::new(scene)))
        }
    }
}
