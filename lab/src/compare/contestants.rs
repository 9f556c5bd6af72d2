//! Who takes part.

use std::fmt;

use lyapunov::{ParameterError, Scalar, Stabilizer};

use crate::family::{Member, Members};
use crate::scene::{self, Cap, Draft, Ledger, Scene, Work};
use crate::{AnyStabilizer, Space};

/// Who takes part in a comparison: names, and how to make a stabilizer for a scene.
///
/// ```
/// use lyapunov::{Correction, PortSample, Stabilizer};
/// use lyapunov_lab::compare::{Comparison, Contestants};
/// use lyapunov_lab::paper;
///
/// /// A damper that is always there, N·s/m.
/// struct Damper(f64);
/// impl Stabilizer<f64> for Damper {
///     fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
///         Correction { alpha: self.0, ..Correction::none(effort + self.0 * sample.velocity) }
///     }
/// }
///
/// let contestants = Contestants::<f64>::standard().with("damper", |_| Ok(Damper(5.0)));
/// let comparison = Comparison::of("8 kN/m", &paper::Case::Plain8k.scene()?, &contestants)?;
/// println!("{comparison}");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Contestants<V: Space = f64> {
    entries: Vec<Contestant<V>>,
}

/// How the stabilizer of a contestant is made.
type Make<V> = dyn Fn(&Scene) -> Result<AnyStabilizer<V>, ParameterError> + Send + Sync;

/// A name, and a way to make a stabilizer for a scene.
pub(super) struct Contestant<V: Space> {
    pub(super) name: String,
    make: Box<Make<V>>,
}

impl<V: Space> Contestants<V> {
    /// Nobody yet.
    pub fn nobody() -> Self {
        Self { entries: Vec::new() }
    }

    /// The same with one more, whose stabilizer is made by `make` for each scene.
    #[must_use]
    pub fn with<S: Stabilizer<V> + 'static>(
        self,
        name: impl Into<String>,
        make: impl Fn(&Scene) -> Result<S, ParameterError> + Send + Sync + 'static,
    ) -> Self {
        self.entered(name.into(), move |scene| make(scene).map(AnyStabilizer::new))
    }

    /// The names, in the order of registration.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.entries.iter().map(|contestant| contestant.name.as_str())
    }

    pub(super) fn entries(&self) -> &[Contestant<V>] {
        &self.entries
    }

    fn entered(
        mut self,
        name: String,
        make: impl Fn(&Scene) -> Result<AnyStabilizer<V>, ParameterError> + Send + Sync + 'static,
    ) -> Self {
        self.entries.push(Contestant { name, make: Box::new(make) });
        self
    }
}

impl<T: Scalar + Space> Contestants<T> {
    /// Those of [`Members::standard`].
    pub fn standard() -> Self {
        Self::of(Members::standard())
    }

    /// These members of the family, set as the scene says.
    pub fn of(members: impl IntoIterator<Item = Member>) -> Self {
        members.into_iter().fold(Self::nobody(), |others, member| {
            others.entered(member.name().to_owned(), move |scene| member.on(scene))
        })
    }
}

impl<V: Space> Contestant<V> {
    pub(super) fn stabilizer(&self, scene: &Scene) -> Result<AnyStabilizer<V>, ParameterError> {
        (self.make)(scene)
    }
}

impl<V: Space> fmt::Debug for Contestant<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Contestant").field("name", &self.name).finish_non_exhaustive()
    }
}

/// What POPC and LOLC are set to on a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The work they book.
    pub work: Work,
    /// What they sum energies in.
    pub ledger: Ledger,
    /// The limit of their damping, of m / T.
    pub damping_cap: Cap,
    /// Whether the scene says so; else these are the defaults.
    pub from_scene: bool,
}

impl Settings {
    /// Those of the stabilizer that `scene` names, whichever it is, or the defaults.
    pub fn of(scene: &Draft) -> Self {
        let (work, ledger, damping_cap) = match scene.stabilizer {
            None => (Work::default(), Ledger::default(), Cap::default()),
            Some(scene::Stabilizer::Popc(popc)) => (popc.work, popc.ledger, popc.damping_cap),
            Some(scene::Stabilizer::Lolc(lolc)) => (lolc.work, lolc.ledger, lolc.damping_cap),
        };
        Self { work, ledger, damping_cap, from_scene: scene.stabilizer.is_some() }
    }

    /// The kind of work in one word.
    pub(super) fn work_name(&self) -> &'static str {
        match self.work {
            Work::Held => "held",
            Work::Sampled => "sampled",
        }
    }
}

impl fmt::Display for Settings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (work, cap) = (self.work_name(), self.damping_cap.get());
        let source = if self.from_scene { "as the scene says" } else { "the defaults" };
        write!(f, "{work} work, cap {cap} ({source})")
    }
}
