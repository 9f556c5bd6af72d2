//! Entrants of a comparison.

use std::fmt;

use lyapunov::{ParameterError, Stabilizer};

use crate::files::Scene;
use crate::simulate::family::{StabilizerName, StabilizerNames};
use crate::simulate::{AnyStabilizer, Fitted, Space};

/// The entrants of a comparison: names, and the way to make each stabilizer for a scene.
///
/// ```
/// use lyapunov::{Correction, PortSample, Stabilizer};
/// use lyapunov_lab::compare::{Comparison, Entrants};
/// use lyapunov_lab::paper;
///
/// /// Constant damper, N·s/m.
/// struct Damper(f64);
/// impl Stabilizer<f64> for Damper {
///     fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
///         Correction { alpha: self.0, ..Correction::none(effort + self.0 * sample.velocity) }
///     }
/// }
///
/// let entrants = Entrants::<f64>::standard().with("damper", |_| Ok(Damper(5.0)));
/// let comparison = Comparison::of("8 kN/m", &paper::Case::Plain8k.scene()?, &entrants)?;
/// println!("{comparison}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Entrants<V: Space = f64> {
    entries: Vec<Entrant<V>>,
}

/// Constructor of an entrant's stabilizer.
type Make<V> = dyn Fn(&Scene) -> Result<Fitted<V>, ParameterError> + Send + Sync;

/// Name, and the constructor of its stabilizer for a scene.
pub(super) struct Entrant<V: Space> {
    pub(super) name: String,
    /// The stabilizer that it is judged and reported like; none of an entrant of your own.
    pub(super) like: Option<StabilizerName>,
    make: Box<Make<V>>,
}

impl<V: Space> Entrants<V> {
    /// No entrants.
    pub fn empty() -> Self {
        Self { entries: Vec::new() }
    }

    /// Adds an entrant whose stabilizer `make` builds for each scene.
    #[must_use]
    pub fn with<S: Stabilizer<V> + 'static>(
        self,
        name: impl Into<String>,
        make: impl Fn(&Scene) -> Result<S, ParameterError> + Send + Sync + 'static,
    ) -> Self {
        self.entered(name.into(), None, move |scene| {
            make(scene).map(|made| Fitted::Behind(AnyStabilizer::new(made)))
        })
    }

    /// Adds an entrant that `make` fits to each scene, behind the environment or around it; `like` says how to judge it.
    #[must_use]
    pub fn with_fitted(
        self,
        name: impl Into<String>,
        like: StabilizerName,
        make: impl Fn(&Scene) -> Result<Fitted<V>, ParameterError> + Send + Sync + 'static,
    ) -> Self {
        self.entered(name.into(), Some(like), make)
    }

    /// The names, in the order of registration.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.entries.iter().map(|entrant| entrant.name.as_str())
    }

    pub(super) fn entries(&self) -> &[Entrant<V>] {
        &self.entries
    }

    fn entered(
        mut self,
        name: String,
        like: Option<StabilizerName>,
        make: impl Fn(&Scene) -> Result<Fitted<V>, ParameterError> + Send + Sync + 'static,
    ) -> Self {
        self.entries.push(Entrant { name, like, make: Box::new(make) });
        self
    }

    /// The entrants of [`StabilizerNames::standard`].
    pub fn standard() -> Self {
        Self::of(StabilizerNames::standard())
    }

    /// These members of the family, set as the scene says.
    pub fn of(members: impl IntoIterator<Item = StabilizerName>) -> Self {
        members.into_iter().fold(Self::empty(), |others, member| {
            others.entered(member.name().to_owned(), Some(member), move |scene| member.on(scene))
        })
    }
}

impl<V: Space> Entrant<V> {
    pub(super) fn fitted(&self, scene: &Scene) -> Result<Fitted<V>, ParameterError> {
        (self.make)(scene)
    }
}

impl<V: Space> fmt::Debug for Entrant<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Entrant").field("name", &self.name).finish_non_exhaustive()
    }
}
