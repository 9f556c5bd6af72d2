//! Run with the quantities that it is judged by.

use std::ops::ControlFlow;

use lyapunov::ParameterError;

use super::account::{Account, Balance};
use super::body::{Body, Masses};
use crate::files::Scene;
use crate::measure::fate::Fate;
use crate::measure::force_error::SolidError;
use crate::measure::linear::LinearPart;
use crate::measure::sanity::{Oddity, RunSigns};
use crate::measure::share::Share;
use crate::measure::verdict::{Verdict, Yardstick};
use crate::measure::watch::Watch;
use crate::simulate::{Rollout, Space};

/// Past this, m and m/s, squares soon leave the range of the numbers.
const FAR: f64 = 1e100;

/// Ticks between two reports of progress.
const BREATH: u64 = 1 << 14;

/// The outcome of a run.
#[derive(Clone, Debug)]
pub(crate) struct Trial {
    pub(crate) verdict: Verdict,
    pub(crate) verdict_by: Yardstick,
    /// Whether it left the range of the numbers.
    pub(crate) left_range: bool,
    /// Whether it starts in balance and never leaves its band.
    pub(crate) is_undisturbed: bool,
    pub(crate) whole: Balance,
    pub(crate) first: Option<Balance>,
    /// The magnitudes of all energies moved and, tick by tick, stored, J: what rounding is to be measured by.
    pub(crate) moved: f64,
    pub(crate) feel: Feel,
    /// The signs of a mistake.
    pub(crate) look_at: Vec<Oddity>,
}

/// The forces felt in a run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Feel {
    /// Largest force on the plant, N.
    pub(crate) peak: f64,
    /// The [force error](SolidError), N; none without a contact with a wall or a solid.
    pub(crate) error: Option<f64>,
}

impl Trial {
    /// Runs `scene` as it is.
    pub(crate) fn of<V: Space>(scene: &Scene) -> Result<Self, ParameterError> {
        Self::along(scene, Rollout::<V>::of(scene)?, &|_| ControlFlow::Continue(()))
    }

    /// Runs a loop of `scene`, reporting to `watch` from time to time how many more ticks are done; it stops where
    /// `watch` breaks.
    pub(crate) fn along<V: Space>(
        scene: &Scene,
        rollout: Rollout<V>,
        watch: &Watch<'_>,
    ) -> Result<Self, ParameterError> {
        let (mut fate, mut signs) = (Fate::of(scene), RunSigns::new(scene));
        let mut account = Account::<V::Double>::new::<V>(scene, Body::of(scene)?);
        let (mut peak, mut error) = (0.0_f64, SolidError::<V::Double>::of(scene));
        let mut share = Share::<V::Double>::new::<V>(scene);
        let criterion = fate.criterion(0).clone();
        let ((rest, band), mut calm) = (criterion.rest(), criterion.starts_in_balance);
        let mut open = true;
        for (tick, number) in rollout.zip(1..) {
            fate.add_tick(&tick);
            signs.add(&tick);
            calm = calm && (criterion.coordinate(tick.truth.position) - rest).abs() <= band;
            let [position, velocity] = Masses::at(&tick).device;
            let applied = tick.applied.double();
            peak = peak.max(applied.length());
            let environment = share.split(&tick).environment;
            if let Some(error) = &mut error {
                error.add([position, velocity], applied, environment);
            }
            let near = position.length() < FAR && velocity.length() < FAR;
            open = open && near && account.add(&tick);
            if number % BREATH == 0 && watch(BREATH).is_break() {
                break;
            }
        }
        let moved = account.size();
        let (whole, first) = account.finish();
        let error = error.and_then(|error| error.root_mean_square());
        let (verdict, verdict_by) = (fate.verdict(0), fate.verdict_by(0));
        let (left_range, look_at) = (!fate.is_complete(), signs.finish(scene));
        let is_undisturbed = calm && verdict == Verdict::Settles;
        let feel = Feel { peak, error };
        Ok(Self {
            verdict,
            verdict_by,
            left_range,
            is_undisturbed,
            whole,
            first,
            moved,
            feel,
            look_at,
        })
    }

    /// Runs `scene`, reporting to `watch`; none without a verdict that is `wanted`, or if the loop is linear, has no stabilizer and
    /// does not decay in contact.
    pub(crate) fn that_holds<V: Space>(
        scene: &Scene,
        wanted: &dyn Fn(Verdict) -> bool,
        watch: &Watch<'_>,
    ) -> Option<Self> {
        let decays = scene.stabilizer.is_some()
            || LinearPart::of(scene).map_or(true, |part| part.spectral_radius() < 1.0);
        if !decays {
            return None;
        }
        // The verdict alone takes a tenth of the time, and most of what is tried fails by it.
        let mut fate = Fate::of(scene);
        for (tick, number) in Rollout::<V>::of(scene).ok()?.zip(1..) {
            fate.add_tick(&tick);
            if number % BREATH == 0 && watch(0).is_break() {
                return None;
            }
        }
        wanted(fate.verdict(0)).then_some(())?;
        Self::along(scene, Rollout::<V>::of(scene).ok()?, watch).ok()
    }
}

impl Balance {
    /// The balance of a whole run of `scene`, under whichever stabilizer, or of as much of it as stays in the range of
    /// the numbers. It reports to `watch` from time to time how many more ticks are done; the run ends where `watch`
    /// breaks.
    ///
    /// # Errors
    /// A scene whose body cannot be made.
    pub fn along<V: Space>(
        scene: &Scene,
        rollout: Rollout<V>,
        watch: &Watch<'_>,
    ) -> Result<Self, ParameterError> {
        Trial::along(scene, rollout, watch).map(|trial| trial.whole)
    }
}
