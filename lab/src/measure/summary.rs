//! Summary of a run.

use super::fate::Fate;
use super::sanity::{Oddity, RunSigns};
use super::settling::Settling;
use super::verdict::{Verdict, Yardstick};
use crate::files::Scene;
use crate::files::scene::Draft;
use crate::simulate::{Rollout, Row, Space, Stabilizing, Tick};

/// Lengths and energies are reported in thousandths of their units.
pub(crate) const MILLI: f64 = 1e3;

/// Distance from 0 below which no square of a motion leaves the range of a scalar, m.
const NEAR: f64 = 1e6;

/// Summary of a run, built tick by tick.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    pub(crate) scene: Scene,
    pub(crate) stabilizing: Stabilizing,
    /// Ticks summed up.
    pub rows: u64,
    /// The last tick.
    pub last: Option<Row>,
    /// The place where the operator's spring and the environment balance, m on each axis, of several the nearest to the last
    /// position; none where no spring pulls, where no place is known, or if it is out of range.
    pub equilibrium: Option<Vec<f64>>,
    /// Half the width of the band about the equilibrium that counts as settled, m.
    pub band: f64,
    /// The time since when the plant has stayed in the band, s; none if it is outside.
    pub settled: Option<f64>,
    settling: Settling<f64>,
    /// The time since when the plant has not moved, s; none if it moves.
    pub(crate) still: Option<f64>,
    /// The distance from the equilibrium on the last tick, m.
    pub(crate) away: f64,
    pub(crate) fate: Fate<f64>,
    /// The first time at which the distance was beyond its bound, s.
    pub(crate) out_since: Option<f64>,
    /// Largest magnitude of the environment's force, N.
    pub environment_peak: f64,
    /// Largest magnitude of the force applied to the plant, N.
    pub acting_peak: f64,
    /// Energy that crossed the port into the environment, `Σ f_act Δx` over the true positions, J; infinite once it
    /// leaves the range of f64.
    pub absorbed: f64,
    /// Least value of the observed energy, J.
    pub observed_energy_least: f64,
    /// Largest value of the observed energy, J.
    pub observed_energy_most: f64,
    /// Energy that the controller set out to dissipate, `Σ α v² T`, J; infinite once it leaves the range of f64.
    pub asked: f64,
    /// Largest debt that a tick could not serve, J.
    pub shortfall: f64,
    /// Ticks on which the controller was active.
    pub active: u64,
    /// Whether an effort was changed on any tick.
    pub(crate) corrected: bool,
    signs: RunSigns,
    /// The true position, m, and the force applied to the plant, N, of the last tick.
    place: [f64; 3],
    acting: [f64; 3],
}

impl Summary {
    /// A summary without ticks, of a run under the stabilizer that `scene` names.
    pub fn new(scene: &Scene) -> Self {
        let fate = Fate::of(scene);
        let criterion = fate.criterion(0);
        let (rest, band) = criterion.rest();
        let shown = |metres: &f64| (MILLI * metres).is_finite();
        let first = criterion.equilibria.first();
        let equilibrium = first.map(|place| place.axes().to_vec());
        let equilibrium =
            equilibrium.filter(|place| band >= 0.0 && shown(&band) && place.iter().all(shown));
        let place = equilibrium.as_ref().map(|_| (rest, band));
        Self {
            scene: scene.clone(),
            stabilizing: Stabilizing::Table(scene.stabilizer),
            rows: 0,
            last: None,
            equilibrium,
            band: place.map_or(0.0, |(_, band)| band),
            settled: None,
            settling: rest_of(place),
            still: None,
            away: 0.0,
            fate,
            out_since: None,
            environment_peak: 0.0,
            acting_peak: 0.0,
            absorbed: 0.0,
            observed_energy_least: 0.0,
            observed_energy_most: 0.0,
            asked: 0.0,
            shortfall: 0.0,
            active: 0,
            corrected: false,
            signs: RunSigns::new(scene),
            place: [0.0; 3],
            acting: [0.0; 3],
        }
    }

    /// A summary without ticks, of a `rollout` of a `scene`, under whatever stabilizes that.
    pub fn under<V: Space>(scene: &Scene, rollout: &Rollout<V>) -> Self {
        let stabilizing = rollout.stabilizing.clone();
        let stabilizer = match &stabilizing {
            Stabilizing::Table(table) => *table,
            Stabilizing::Foreign(_) => None,
        };
        // What ran is told, and not what the scene names.
        let told = Draft { stabilizer, ..scene.to_draft() }.check();
        let told = told.unwrap_or_else(|_| scene.clone());
        Self { stabilizing, scene: told, ..Self::new(scene) }
    }

    /// The summary of all ticks of a `rollout` of a `scene`, under whatever stabilizes that.
    pub fn of<V: Space>(scene: &Scene, rollout: Rollout<V>) -> Self {
        let mut summary = Self::under(scene, &rollout);
        rollout.for_each(|tick| summary.add(&tick));
        summary
    }

    /// Adds one more tick.
    pub fn add<V: Space>(&mut self, tick: &Tick<V>) {
        let row = Row::of(tick);
        let [place, acting] = [tick.truth.position.axes(), tick.applied.axes()];
        if self.last.is_some() {
            for (axis, to) in place.iter().enumerate() {
                self.absorbed = sum(self.absorbed, self.acting[axis], to - self.place[axis]);
            }
        }
        self.fate.add_tick(tick);
        self.signs.add(tick);
        let criterion = self.fate.criterion(0);
        let coordinate = criterion.coordinate(tick.truth.position);
        self.away = (coordinate - criterion.rest().0).abs();
        if self.out_since.is_none() && self.fate.reach(0).is_some_and(|reach| self.away > reach) {
            self.out_since = Some(row.t);
        }
        let criterion = self.fate.criterion(0);
        if criterion.equilibria.len() > 1 && self.equilibrium.is_some() {
            let nearest = criterion.nearest(tick.truth.position);
            self.equilibrium = nearest.map(|place| place.axes().to_vec());
        }
        self.settling.add(coordinate);
        self.settled = self.settling.since(0).and(self.settled.or(Some(row.t)));
        let is_still = tick.truth.velocity.axes() == [0.0; 3];
        self.still = is_still.then(|| self.still.unwrap_or(row.t));
        self.environment_peak = self.environment_peak.max(tick.environment.length());
        self.acting_peak = self.acting_peak.max(tick.applied.length());
        self.observed_energy_least = self.observed_energy_least.min(row.observed_energy);
        self.observed_energy_most = self.observed_energy_most.max(row.observed_energy);
        let [force, velocity] = [tick.control().axes(), tick.measured.velocity.axes()];
        for axis in 0..3 {
            self.asked = sum(self.asked, force[axis], velocity[axis] * self.scene.period());
        }
        self.shortfall = self.shortfall.max(row.shortfall);
        self.active += u64::from(row.alpha > 0.0);
        self.corrected |= tick.added().axes() != [0.0; 3];
        self.rows += 1;
        self.last = Some(row);
        self.place = place;
        self.acting = acting;
    }

    /// The verdict on the run.
    pub fn verdict(&self) -> Verdict {
        self.fate.verdict(0)
    }

    /// The quantity that the run is judged by.
    pub fn verdict_by(&self) -> Yardstick {
        self.fate.verdict_by(0)
    }

    /// The time from which the plant stays in the band, s; none unless the run settles: another is in it by the phase of its last
    /// swing.
    pub fn settling_time(&self) -> Option<f64> {
        self.settled.filter(|_| self.verdict() == Verdict::Settles)
    }

    /// The signs of a mistake in the scene or its run; docs/sanity.md has the thresholds.
    pub fn look_at(&self) -> Vec<Oddity> {
        let mut signs = self.seen();
        signs.extend(self.scene.stabilizer.and_then(|own| Oddity::outside(&self.scene, own)));
        signs
    }

    /// The same without the stabilizer's assumptions, for a run under another than the scene names.
    pub(crate) fn seen(&self) -> Vec<Oddity> {
        self.signs.finish(&self.scene)
    }

    /// Share of ticks with damping, %; none under a stabilizer that adds no damping, and where its damping is no `α`, or is not told.
    pub fn active_percent(&self) -> Option<f64> {
        self.reports_damping().then(|| 100.0 * self.active as f64 / self.rows.max(1) as f64)
    }

    /// The energy in mJ that the controller set out to dissipate; none where there is no share of active ticks.
    pub fn millijoules_asked(&self) -> Option<f64> {
        self.reports_damping().then_some(MILLI * self.asked)
    }

    /// Whether the damping of the stabilizer, if it adds any, is told as `α`.
    fn reports_damping(&self) -> bool {
        match self.stabilizing {
            Stabilizing::Table(Some(table)) => table.kind().reports_damping(),
            Stabilizing::Table(None) => true,
            Stabilizing::Foreign(_) => self.tells_damping(),
        }
    }

    /// Whether observed energy and shortfall are findings: those of a value of the caller's may be left at 0.
    pub(crate) fn reports_debt(&self) -> bool {
        matches!(self.stabilizing, Stabilizing::Table(_)) || self.tells_debt()
    }

    /// Whether the corrections tell how they damp: a share of 0 % is one where no effort was changed, too.
    pub(crate) fn tells_damping(&self) -> bool {
        self.active > 0 || !self.corrected
    }

    /// Whether any correction told an observed energy or a shortfall. Without a force there is none to tell.
    pub(crate) fn tells_debt(&self) -> bool {
        let told = [self.observed_energy_least, self.observed_energy_most, self.shortfall];
        told != [0.0; 3] || !self.acts()
    }

    /// Whether any force acted on the plant.
    pub(crate) fn acts(&self) -> bool {
        self.signs.acts()
    }

    /// The last time at which everything was finite, s, if the motion left the range of the scalar.
    pub fn left_range(&self) -> Option<f64> {
        let complete = self.rows == self.scene.ticks() + 1;
        (!complete).then(|| self.last.map_or(0.0, |row| row.t))
    }

    /// Whether it was not the motion that left the range, which was nowhere near its end, but a stabilizer of the caller's that
    /// rejected a sample.
    pub(crate) fn is_rejected(&self) -> bool {
        let is_near = self.place.iter().all(|it| it.abs() < NEAR);
        self.left_range().is_some() && self.stabilizing.is_own() && is_near
    }
}

/// The settling about `rest`; never settled without a place to rest at.
fn rest_of(rest: Option<(f64, f64)>) -> Settling<f64> {
    let (rest, band) = rest.unwrap_or((0.0, -1.0));
    Settling::new(rest, band)
}

/// A sum of work with one more piece; once infinite it stays so, and it is never NaN.
fn sum(total: f64, force: f64, way: f64) -> f64 {
    // Two positions can lie so far apart that the distance is infinite.
    if total.is_finite() && force != 0.0 { total + force * way } else { total }
}
