//! Breach of a law, with all that it takes to find its cause.

use core::fmt;

use super::{Law, Quantity};
use crate::signal_axes::{axes, axis_of};
use crate::{PortSample, Scalar, Signal};

/// Breach of a law: which law, at which sample and under which force, with which number, and how far it was allowed.
///
/// ```
/// use lyapunov_core::{LyapunovCandidate, PortSample, laws};
/// /// Credits a power that is always there.
/// #[derive(Clone)]
/// struct Generous;
/// impl LyapunovCandidate<f64> for Generous {
///     fn decrease(&mut self, sample: &PortSample<f64>) -> f64 {
///         sample.work + 0.5 * sample.period
///     }
/// }
/// let broken = laws::candidate(&Generous, laws::Samples::new(1e-3)).unwrap_err();
/// assert_eq!((broken.law, broken.value, broken.quantity.unit), (laws::Law::NothingForNothing, 5e-4, "J"));
/// let told = broken.to_string();
/// assert!(told.starts_with("sample 0: where nothing happens, nothing must be credited; the decrease at rest is off by"));
/// assert!(told.contains("5.000e-4 J, allowed is 0 J") && told.contains("likely cause: a credit that"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Violation {
    /// The law.
    pub law: Law,
    /// The sample, counted from 0.
    pub tick: usize,
    /// The lane.
    pub lane: u32,
    /// The quantity that breaks it, and its unit.
    pub quantity: &'static Quantity,
    /// Its value.
    pub value: f64,
    /// How far it might have gone.
    pub allowed: Allowed,
    /// What drove the part on that sample; none where a law is not checked along a motion.
    pub drive: Option<Drive>,
}

/// Values that a law allows.
///
/// ```
/// use lyapunov_core::{OnePort, PortSample, laws};
/// /// Divides by the velocity, which may be 0.
/// #[derive(Clone)]
/// struct Hyperbola;
/// impl OnePort<f64> for Hyperbola {
///     fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
///         1.0 / sample.velocity
///     }
/// }
/// let broken = laws::one_port(&Hyperbola, laws::Samples::new(1e-3)).unwrap_err();
/// assert!(broken.allowed == laws::Allowed::Finite && broken.value.is_infinite());
/// let drive = broken.drive.unwrap();
/// assert_eq!((drive.velocity, drive.period), (0.0, 1e-3)); // a sample at rest
/// assert!(broken.law.likely_cause().starts_with("a division by a velocity"));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Allowed {
    /// Every finite number.
    Finite,
    /// True, and not false.
    True,
    /// Differences up to this magnitude.
    Within(f64),
    /// Numbers from this one up.
    From(f64),
}

/// Drive of a part on one sample: the force, and the motion that it met. On several axes all are magnitudes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    /// The effort that the part was given, N.
    pub effort: f64,
    /// The effort applied over the period before, N.
    pub applied: f64,
    /// The velocity, m/s.
    pub velocity: f64,
    /// The displacement, m.
    pub displacement: f64,
    /// The period, s.
    pub period: f64,
    /// The field of the sample that the check replaced, and by what.
    pub spoilt: Option<(&'static str, f64)>,
}

impl Drive {
    fn of<V: Signal>(sample: &PortSample<V>, effort: V, lane: usize) -> Self {
        let size = |signal: V| {
            let alone = axes::<V>() == 1;
            let size = if alone { axis_of(signal, 0) } else { signal.inner(signal).sqrt() };
            size.lane(lane)
        };
        Self {
            effort: size(effort),
            applied: size(sample.applied),
            velocity: size(sample.velocity),
            displacement: size(sample.displacement),
            period: sample.period.lane(lane),
            spoilt: None,
        }
    }
}

impl Violation {
    /// This breach, under `sample` and `effort`.
    pub(super) fn under<V: Signal>(self, sample: &PortSample<V>, effort: V) -> Self {
        let drive = Drive::of(sample, effort, self.lane as usize);
        let spoilt = self.drive.and_then(|told| told.spoilt);
        Self { drive: Some(Drive { spoilt, ..drive }), ..self }
    }

    /// This breach, after `field` of the sample or the effort was replaced by `bad`.
    pub(super) fn after(self, field: &'static str, bad: f64) -> Self {
        let drive = self.drive.unwrap_or(Drive::of(&PortSample::default(), 0.0, 0));
        Self { drive: Some(Drive { spoilt: Some((field, bad)), ..drive }), ..self }
    }
}

impl fmt::Display for Drive {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { effort, applied, velocity, displacement, period, spoilt } = self;
        write!(f, "driven by {effort:.3e} N at {velocity:.3e} m/s over {period:.3e} s, ")?;
        write!(f, "{applied:.3e} N applied before over {displacement:.3e} m")?;
        match spoilt {
            Some((field, bad)) => write!(f, ", with its {field} replaced by {bad}"),
            None => Ok(()),
        }
    }
}

impl fmt::Display for Violation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { law, tick, lane, quantity, value, allowed, drive } = self;
        let Quantity { name, unit } = quantity;
        let space = if unit.is_empty() { "" } else { " " };
        write!(f, "sample {tick}: {law}; the {name}")?;
        match allowed {
            Allowed::Finite => write!(f, " is {value}{space}{unit}")?,
            Allowed::True => f.write_str(" is false")?,
            Allowed::Within(most) => {
                write!(f, " is off by {value:.3e}{space}{unit}, allowed is ")?;
                match most {
                    0.0 => write!(f, "0{space}{unit}")?,
                    most => write!(f, "{most:.3e}{space}{unit}")?,
                }
            }
            Allowed::From(least) => {
                write!(
                    f,
                    " is {value:.3e}{space}{unit}, allowed from {least:.3e}{space}{unit} on"
                )?;
            }
        }
        if *lane > 0 {
            write!(f, " (lane {lane})")?;
        }
        if let Some(drive) = drive {
            write!(f, "; {drive}")?;
        }
        write!(f, "; likely cause: {}", law.likely_cause())
    }
}

impl core::error::Error for Violation {}
