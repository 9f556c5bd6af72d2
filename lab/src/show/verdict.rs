//! Verdicts in words.

use crate::files::Scene;
use crate::measure::stretches::{exceeds_quarter, exceeds_tenth};
use crate::measure::summary::MILLI;
use crate::measure::{Summary, Verdict, Yardstick};
use crate::simulate::Criterion;
use crate::simulate::criterion::Shortage;
use crate::simulate::equilibrium::{last_pull, never_rests};
use crate::text::{found, given};

use super::html::verdict;
use super::table::Cell;

impl From<Verdict> for Cell {
    fn from(told: Verdict) -> Self {
        let class = match told {
            Verdict::Settles => "yes",
            Verdict::Swinging => "open",
            Verdict::Grows => "no",
            Verdict::TooShort => "",
        };
        Self::new(told.word(), verdict(class, told.word()))
    }
}

/// The quantity that a scene is judged by, if it is not its distance from the equilibrium, and the reason.
pub(crate) fn by_speed(scene: &Scene) -> Option<String> {
    let criterion = Criterion::of(scene);
    let why = match criterion.equilibria.first() {
        _ if criterion.place().is_some() => return None,
        Some(_) => "it starts where it rests",
        None if last_pull(scene) == 0.0 => "no spring of the operator pulls the plant anywhere",
        None if never_rests(scene) => "what moves the plant never rests",
        None if scene.dimensions() > 1 => "no place to rest at is known",
        None => "there is no place to rest at",
    };
    Some(format!("by speed, as {why}"))
}

/// A place in words, from m: `x = 1 mm`, `(x, y) = (1, 2) mm`.
fn place(rest: &[f64]) -> String {
    let told: Vec<String> = rest.iter().map(|axis| found(MILLI * axis).to_string()).collect();
    match &told[..] {
        [x] => format!("x = {x} mm"),
        [x, y] => format!("(x, y) = ({x}, {y}) mm"),
        axes => format!("(x, y, z) = ({}) mm", axes.join(", ")),
    }
}

impl Summary {
    /// The verdict, and the numbers that it follows from.
    pub(super) fn verdict_in_words(&self) -> String {
        let verdict = self.verdict();
        let why = if self.is_rejected() {
            "its stabilizer cut it short".to_owned()
        } else if self.left_range().is_some() {
            "it left the range of the numbers".to_owned()
        } else if verdict == Verdict::TooShort {
            self.shortage()
        } else if self.verdict_by() == Yardstick::Speed {
            let speed = self.speeds(verdict);
            by_speed(&self.scene).map_or(speed.clone(), |by| format!("{speed}; {by}"))
        } else {
            self.distances(verdict)
        };
        format!("{verdict}: {why}")
    }

    fn shortage(&self) -> String {
        let (ticks, scene) = (self.scene.ticks(), &self.scene);
        match self.fate.criterion(0).shortage {
            Some(Shortage::Swings(period)) => {
                let length = given(scene.end());
                format!("{length} s is less than two swings of {} s", found(period))
            }
            Some(Shortage::Answers(least)) => {
                format!("{ticks} ticks, and twenty answers of the environment take {least}")
            }
            None => String::new(),
        }
    }

    fn speeds(&self, verdict: Verdict) -> String {
        let sizes = self.fate.sizes(0);
        let told = |speed: f64| format!("{} mm/s", found(MILLI * speed));
        let (end, second) = (told(sizes.end), told(sizes.second));
        let (last, cycle) = (self.scene.ticks(), self.fate.criterion(0).cycle);
        let period = format!("{} s", found(self.scene.period() * cycle as f64));
        match verdict {
            Verdict::Grows => {
                let (part, before) = match exceeds_quarter(last, cycle) {
                    true => (&period[..], "as long before"),
                    false => ("quarter", "the second"),
                };
                format!("up to {end} in the last {part}, {second} in {before}")
            }
            _ => {
                let (tail, widest) = (told(sizes.tail), told(sizes.widest));
                let part = if exceeds_tenth(last, cycle) { period } else { "tenth".to_owned() };
                format!("up to {tail} in the last {part}, {widest} in all")
            }
        }
    }

    /// Time since which friction holds the plant where it stands, in words. A plant that only turns round stands for less than
    /// two ticks.
    fn held(&self) -> Option<String> {
        let friction = self.scene.effects.friction?;
        let (still, last) = (self.still?, self.last?);
        let most = friction.breakaway();
        (last.t - still >= self.scene.period()).then(|| {
            format!(
                "friction of up to {} N holds it there since t = {} s",
                given(most),
                given(still)
            )
        })
    }

    fn distances(&self, verdict: Verdict) -> String {
        let millimetres = |metres: f64| format!("{} mm", found(MILLI * metres));
        let Some(rest) = self.equilibrium.as_deref().filter(|_| self.last.is_some()) else {
            return "the place to rest at is out of range".to_owned();
        };
        let (band, place) = (millimetres(self.band), place(rest));
        match (verdict, self.settled) {
            (Verdict::Grows, _) => {
                // Sizes of a run that went away tell its length only.
                if let Some(time) = self.out_since {
                    let start = millimetres(self.fate.criterion(0).start);
                    return format!(
                        "past ten times the {start} of its start from {place} at t = {} s",
                        given(time)
                    );
                }
                let sizes = self.fate.sizes(0);
                let [second, end] = [sizes.second, sizes.end].map(millimetres);
                format!("up to {end} from {place} in the last quarter, {second} in the second")
            }
            (Verdict::Settles, Some(time)) => {
                format!("from t = {} s on within {band} of {place}", given(time))
            }
            // One last swing through the band is not rest.
            (_, Some(time)) => {
                format!("within {band} of {place} only since t = {} s", given(time))
            }
            (_, None) => {
                let away = millimetres(self.away);
                let held = self.held().map_or_else(String::new, |held| format!("; {held}"));
                format!("at the end {away} from {place}, not within {band}{held}")
            }
        }
    }
}
