//! What `lyapunov compare` takes.

use std::path::Path;

use super::model::Model;
use crate::scene::{self, Diagnostic, Scene};

/// What is compared: a scene, or a model of a plant, told apart by their tables.
#[derive(Clone, Debug, PartialEq)]
pub enum Subject {
    /// A scene.
    Scene(Box<Scene>),
    /// A model.
    Model(Box<Model>),
}

impl Subject {
    /// Reads a file, once, as it may be a pipe.
    ///
    /// # Errors
    /// As [`Scene::load`] and [`Model::load`].
    pub fn load(path: &Path) -> Result<Self, Diagnostic> {
        let text = scene::text_of(&scene::BOOK, path)?;
        if Model::is_in(&text) {
            let name = path.display().to_string();
            Model::parse(&text, &name).map(|model| Self::Model(Box::new(model)))
        } else {
            scene::parse_at(&text, path).map(|scene| Self::Scene(Box::new(scene)))
        }
    }
}
