//! Debt of a stabilizer that errors of the measured position made.

use lyapunov::Scalar;

use super::{Oddity, Sign};
use crate::files::Scene;
use crate::simulate::{Space, Tick};
use crate::text::found;

/// Fewest ticks of braking for a debt that are not put down to chance.
const BRAKES: u64 = 20;

/// Share of the run, back from its end, over which a debt has to stand: one that a loop pays off is none.
const LAST: f64 = 0.1;

/// Share of the debt that errors of the position have to make up.
const MADE: f64 = 0.5;

/// Share of the debt, at the most, that the true port made itself by what it gave.
const OWN: f64 = 0.1;

/// Share of the most energy that the true port took, below which a debt does no harm that is felt.
const LARGE: f64 = 0.01;

/// Watches what a stabilizer leaves owed, and the work of the applied force on the true and on the measured motion.
///
/// A sound debt is the true port's: energy that came out and that the damping limit kept from being taken. A step of an
/// encoder is work as well in the eyes of a stabilizer, and what it adds up over a run is never paid off.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Miscount {
    ticks: u64,
    /// Ticks of the debt that stands now, and those of them with damping.
    standing: u64,
    braking: u64,
    owed: f64,
    /// Work on the true and on the measured motion, J, and the most of the first so far.
    work: [f64; 2],
    most: f64,
    last: Option<Last>,
}

/// Force and positions of a tick.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Last {
    force: [f64; 3],
    places: [[f64; 3]; 2],
}

impl Miscount {
    pub(super) fn add<V: Space>(&mut self, tick: &Tick<V>) {
        let places = [tick.truth.position.axes(), tick.measured.position.axes()];
        self.move_on(Last { force: tick.applied.axes(), places });
        self.ticks += 1;
        self.owed = tick.correction.shortfall.lane(0);
        if self.owed > 0.0 {
            self.standing += 1;
            self.braking += u64::from(tick.correction.alpha.lane(0) > 0.0);
        } else {
            (self.standing, self.braking) = (0, 0);
        }
    }

    /// Books the work of the last force on the way from there to here.
    #[inline]
    fn move_on(&mut self, now: Last) {
        if let Some(Last { force, places }) = self.last.replace(now) {
            for (motion, work) in self.work.iter_mut().enumerate() {
                let [from, to] = [places[motion], now.places[motion]];
                *work += (0..3).map(|axis| force[axis] * (to[axis] - from[axis])).sum::<f64>();
            }
        }
        self.most = self.most.max(self.work[0]);
    }

    /// The sign of a stabilizer that still brakes at the end for a debt of which the true port knows nothing.
    pub(super) fn finish(&self, scene: &Scene) -> Option<Oddity> {
        let [true_work, measured] = self.work;
        let stands = self.standing as f64 >= LAST * self.ticks as f64 && self.braking >= BRAKES;
        let is_made = true_work - measured >= MADE * self.owed && -true_work <= OWN * self.owed;
        let is_large = self.owed >= LARGE * self.most;
        (stands && is_made && is_large).then(|| {
            let [owed, work] = [self.owed, true_work.abs()].map(|energy| found(1e3 * energy));
            let way = if true_work < 0.0 { "came out of" } else { "went into" };
            let text = format!(
                "the stabilizer brakes to the end: its sum has a debt of {owed} mJ due to errors of the measured \
                 position, not to the motion, by which {work} mJ {way} the port; a smaller damping_cap brakes less{}",
                of_a_count(scene).unwrap_or_default()
            );
            Oddity::new(Sign::Miscounted, text)
        })
    }
}

/// The force with which the damping limit answers a tick of one count, in words; none where the velocity of a count is not
/// plain or no limit is set.
fn of_a_count(scene: &Scene) -> Option<String> {
    let velocity = scene.plain_count()? / scene.period();
    let cap = scene.stabilizer.and(Some(scene.damping_cap())).filter(|cap| cap.is_finite())?;
    let limit = scene.damping(cap).limit::<f64>().ok()?.most();
    let [speed, most, force] = [1e3 * velocity, limit, limit * velocity].map(found);
    Some(format!(": one count ({speed} mm/s) at the limit of {most} N.s/m is {force} N"))
}
