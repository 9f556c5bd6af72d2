//! The shipped scenes, embedded in the program so that they are available wherever it runs.

use std::fmt;

use crate::text::{nearest, shorten};

/// A shipped scene file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shipped {
    /// Its name: that of its file in `scenes/`, without the ending.
    pub name: &'static str,
    /// The content of the file.
    pub text: &'static str,
}

macro_rules! shipped {
    ($($name:literal),+ $(,)?) => {
        &[$(Shipped {
            name: $name,
            text: include_str!(concat!("../../../scenes/", $name, ".toml")),
        }),+]
    };
}

/// All shipped scenes: the tour, one per effect from the port outwards to the hand, the environments, and the paper's.
pub const SCENES: &[Shipped] = shipped![
    "tour",
    "hold",
    "dropout",
    "delay",
    "saturation",
    "filter-cutoff",
    "filter-window",
    "encoder",
    "noise",
    "jitter",
    "friction",
    "load",
    "pulse",
    "link",
    "motion-step",
    "motion-ramp",
    "motion-sine",
    "motion-file",
    "grip",
    "spring",
    "mass-spring-damper",
    "layered-wall",
    "hunt-crossley",
    "moving-wall",
    "varying-spring",
    "cubic-spring",
    "plane",
    "sphere",
    "box",
    "press-1khz",
    "paper-8k-none",
    "paper-8k-popc",
    "paper-8k-lolc",
    "paper-50k-none",
    "paper-50k-popc",
    "paper-50k-lolc",
];

/// Files that shipped scenes read, by their names in `scenes/`.
const COMPANIONS: &[(&str, &str)] =
    &[("motion-file.csv", include_str!("../../../scenes/motion-file.csv"))];

impl Shipped {
    /// The two comment lines at its top: the subject of the scene, and what to look at.
    pub fn comment(&self) -> [&'static str; 2] {
        let mut lines = self.text.lines().filter_map(|line| line.strip_prefix("# "));
        [(); 2].map(|()| lines.next().unwrap_or_default())
    }
}

/// A name that no shipped file has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unknown(String);

impl fmt::Display for Unknown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<&str> = SCENES.iter().map(|scene| scene.name).collect();
        let name = shorten(&self.0);
        write!(f, "no scene that ships is called `{name}`")?;
        if let Some(nearest) = nearest(&self.0, &names) {
            write!(f, "\n  = did you mean `{nearest}`?")?;
        }
        f.write_str("\n  = `lyapunov scenes` lists them")
    }
}

impl std::error::Error for Unknown {}

/// The shipped file `name`: a scene, with or without its ending, or a file that a scene reads.
///
/// # Errors
/// Any other name.
pub fn text_of(name: &str) -> Result<&'static str, Unknown> {
    let scene = name.strip_suffix(".toml").unwrap_or(name);
    let scene = SCENES.iter().find(|shipped| shipped.name == scene).map(|shipped| shipped.text);
    let companion = || COMPANIONS.iter().find(|(file, _)| *file == name).map(|(_, text)| *text);
    scene.or_else(companion).ok_or_else(|| Unknown(name.to_owned()))
}
