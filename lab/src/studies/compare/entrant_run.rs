//! Run of one entrant on one scene.

use std::ops::ControlFlow;

use lyapunov::Scalar;

use super::compared::{BREATH, RunError, watched};
use super::contacts::{Contacts, Touch};
use super::cost::{KEPT, Samples};
use super::entrants::{Entrant, Entrants};
use super::score::Score;
use crate::files::scene::Scene;
use crate::measure::{Chatter, Energies, Oddity, Physical, Share, Summary, Trace, Verdict};
use crate::simulate::family::StabilizerName;
use crate::simulate::{Rollout, Space, Tick, in_space};

/// Callback that learns how many more ticks are done, and says whether to go on.
pub type Watch<'a> = dyn Fn(u64) -> ControlFlow<()> + Sync + 'a;

/// Result of one entrant on one scene, with its curves and the samples that its step is timed with.
#[derive(Debug)]
pub(super) struct EntrantRun<V: Space> {
    pub(super) score: Score,
    pub(super) curves: Curves,
    pub(super) samples: Samples<V>,
    pub(super) look_at: Vec<Oddity>,
}

/// The curves of a run over time: the [coordinate](crate::simulate::Criterion::coordinate) of the position in m, observed
/// energy in J, force on the plant in N, in a space its length.
#[derive(Clone, Debug)]
pub(super) struct Curves {
    pub(super) position: Vec<(f64, f64)>,
    pub(super) observed_energy: Vec<(f64, f64)>,
    pub(super) force: Vec<(f64, f64)>,
}

impl<V: Space> EntrantRun<V> {
    pub(super) fn of(
        scene: &Scene,
        entrant: &Entrant<V>,
        watch: &Watch<'_>,
    ) -> Result<Self, RunError> {
        let fitted = entrant.fitted(scene)?;
        let state_bytes = fitted.state_bytes();
        let mut meters = Meters::<V>::new(scene);
        let mut samples = Vec::new();
        let rollout = Rollout::assemble(scene, fitted)?;
        let run = |each: &mut dyn FnMut(Tick<V>) -> ControlFlow<()>| {
            // The caller who asked for an early end knows of it.
            let _ = { rollout }.try_for_each(each);
            Ok(())
        };
        watched((scene.ticks() + 1, BREATH), watch, run, |tick| {
            meters.add(&tick);
            if samples.len() < KEPT {
                samples.push((tick.measured, tick.environment));
            }
        })?;
        let mut look_at = meters.summary.seen();
        let table = entrant.like.and_then(|like| like.table(scene));
        look_at.extend(table.and_then(|table| Oddity::outside(scene, table)));
        // Of one that nobody knows, what stays at 0 was not told.
        let (damps, owes) = match entrant.like {
            Some(like) => (like.reports_damping(), true),
            None => (meters.summary.tells_damping(), meters.summary.tells_debt()),
        };
        let (score, curves) = meters.finish(entrant.name.clone(), state_bytes);
        let active = score.active.filter(|_| damps);
        let shortfall = score.shortfall.filter(|_| owes);
        let judged_by = entrant.like.map(StabilizerName::judgement);
        let score = Score { active, shortfall, judged_by, ..score };
        Ok(Self { score, curves, samples, look_at })
    }
}

/// The score of `scene` under `member`, in its own scalar; the time of a step is not measured.
///
/// # Errors
/// [`RunError::Stopped`] if `watch` stops the run; a stabilizer that cannot be made on the scene.
pub(crate) fn score_under(
    scene: &Scene,
    member: StabilizerName,
    watch: &Watch<'_>,
) -> Result<Score, RunError> {
    in_space!(scene, Axes => {
        let entrants = Entrants::<Axes>::of([member]);
        EntrantRun::of(scene, &entrants.entries()[0], watch).map(|run| run.score)
    })
}

/// All measures along a run.
#[derive(Debug)]
struct Meters<V: Space> {
    share: Share<V::Double>,
    summary: Summary,
    contacts: Contacts<V::Double>,
    energies: Energies<V::Double>,
    physical: Physical<V::Double>,
    chatter: Option<Chatter<V::Double>>,
    position: Trace,
    observed_energy: Trace,
    force: Trace,
}

impl<V: Space> Meters<V> {
    fn new(scene: &Scene) -> Self {
        Self {
            share: Share::new::<V>(scene),
            summary: Summary::new(scene),
            contacts: Contacts::new(scene),
            energies: Energies::new(),
            physical: Physical::new(scene),
            chatter: Chatter::new(scene.servo_rate.get()),
            position: Trace::new(scene.ticks()),
            observed_energy: Trace::new(scene.ticks()),
            force: Trace::new(scene.ticks()),
        }
    }

    fn add(&mut self, tick: &Tick<V>) {
        let split = self.share.split(tick);
        let touch = Touch {
            position: tick.truth.position.double(),
            velocity: tick.truth.velocity.double(),
            force: tick.applied.double(),
            environment: split.environment,
        };
        self.summary.add(tick);
        self.contacts.add(&touch);
        self.energies.add(touch.position, split.environment, split.controller);
        self.physical.add(tick, &split);
        if let Some(chatter) = &mut self.chatter {
            chatter.add(touch.force);
        }
        let criterion = self.summary.fate.criterion(0);
        self.position.add(tick.time, criterion.coordinate(touch.position));
        self.observed_energy.add(tick.time, tick.correction.observed_energy.lane(0));
        self.force.add(tick.time, signed(touch.force));
    }

    fn finish(mut self, stabilizer: String, state_bytes: usize) -> (Score, Curves) {
        self.contacts.end();
        let Self { summary, contacts, energies, physical, .. } = &self;
        let verdict = summary.verdict();
        let told = |value: Option<f64>| value.filter(|value| value.is_finite());
        let millijoules = |energy: f64| told(Some(1e3 * energy));
        let (stiffness, percent) = physical.stiffness_felt().unzip();
        let [given, beyond_damper] = physical.millijoules_given().map(|energy| told(Some(energy)));
        let of_bounded = |value: Option<f64>| told(value.filter(|_| verdict != Verdict::Grows));
        let active = 100.0 * summary.active as f64 / summary.rows as f64;
        let score = Score {
            stabilizer,
            verdict,
            settling_time: summary.settling_time(),
            short_peak: contacts.short_peak(),
            long_peak: contacts.long_peak(),
            energy_injected: millijoules(energies.injected()),
            energy_taken: millijoules(energies.taken()),
            shortfall: millijoules(summary.shortfall),
            stiffness_felt: told(stiffness),
            stiffness_percent: told(percent),
            force_error: of_bounded(contacts.force_error()),
            chatter: told(self.chatter.as_ref().and_then(Chatter::root_mean_square)),
            active: told(Some(active)),
            step_time: None,
            state_bytes,
            energy_given: given,
            energy_given_beyond_damper: beyond_damper,
            force_felt: of_bounded(physical.force_felt()),
            broke_it: None,
            judged_by: None,
        };
        let [position, observed_energy, force] =
            [self.position, self.observed_energy, self.force].map(Trace::finish);
        (score, Curves { position, observed_energy, force })
    }
}

/// The force as a curve shows it: on a line with its sign, in a space its length.
fn signed<V: Space>(force: V) -> f64 {
    if V::DIMENSIONS == 1 { force.axis(0) } else { force.length() }
}
