//! The scenes of the paper's section IV and the figures drawn from them.
//!
//! The paper leaves open how operator and device join, where the operator's spring rests and the observer's rate. The
//! scenes follow docs/paper.md: one mass, at rest at the wall, everything at 100 Hz, held work, a damping cap of half
//! of m / T.

pub mod claims;
mod figures;
mod report;
mod study;

pub use figures::{FIGURES, PaperFigure, figures};
pub use study::{Draws, Study};

use lyapunov::ParameterError;

use crate::files::scene::{Conflict, Diagnostic, Scene};
use crate::simulate::{Rollout, Row};

/// A scene of the paper's section IV.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    /// 8 kN/m and 2 N·s/m without control: figure 6.
    Plain8k,
    /// The same with POPC.
    Popc8k,
    /// The same with LOLC: figure 7.
    Lolc8k,
    /// 50 kN/m and 20 N·s/m without control.
    Plain50k,
    /// The same with POPC: figures 8 and 9.
    Popc50k,
    /// The same with LOLC: figures 8 and 9.
    Lolc50k,
}

impl Case {
    /// All scenes.
    pub const ALL: [Self; 6] =
        [Self::Plain8k, Self::Popc8k, Self::Lolc8k, Self::Plain50k, Self::Popc50k, Self::Lolc50k];

    /// The name of the scene file, without its ending.
    pub fn name(self) -> &'static str {
        self.file().0
    }

    /// The scene.
    ///
    /// # Errors
    /// None as long as the shipped scene files are valid.
    pub fn scene(self) -> Result<Scene, Diagnostic> {
        let (name, text) = self.file();
        Scene::parse(text, name)
    }

    /// The scene file.
    pub fn text(self) -> &'static str {
        self.file().1
    }

    fn file(self) -> (&'static str, &'static str) {
        macro_rules! shipped {
            ($name:literal) => {
                ($name, include_str!(concat!("../../../../scenes/", $name, ".toml")))
            };
        }
        match self {
            Self::Plain8k => shipped!("paper-8k-none"),
            Self::Popc8k => shipped!("paper-8k-popc"),
            Self::Lolc8k => shipped!("paper-8k-lolc"),
            Self::Plain50k => shipped!("paper-50k-none"),
            Self::Popc50k => shipped!("paper-50k-popc"),
            Self::Lolc50k => shipped!("paper-50k-lolc"),
        }
    }

    /// The rows of the scene.
    ///
    /// # Errors
    /// None as long as the shipped scene files are valid.
    pub fn rows(self) -> Result<Vec<Row>, PaperError> {
        Ok(Rollout::<f64>::of(&self.scene()?)?.rows().collect())
    }
}

/// Reason why the paper's figures could not be made.
#[derive(Debug)]
pub enum PaperError {
    /// A shipped scene is not valid.
    Scene(Diagnostic),
    /// A shipped scene has a parameter that a block rejects.
    Parameter(ParameterError),
    /// A member of the ensemble is no scene.
    Draw(Conflict),
}

macro_rules! causes {
    ($($variant:ident($cause:ty)),+) => {$(
        impl From<$cause> for PaperError {
            fn from(cause: $cause) -> Self {
                Self::$variant(cause)
            }
        }
    )+

        impl std::fmt::Display for PaperError {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                match self {
                    $(Self::$variant(cause) => cause.fmt(f),)+
                }
            }
        }
    };
}

causes!(Scene(Diagnostic), Parameter(ParameterError), Draw(Conflict));

impl std::error::Error for PaperError {}
