//! Numbers that the run of a scene is judged by.

use std::f64::consts::TAU;

use super::building::Space;
use super::equilibrium::{driven, equilibria, last_pull, swing};
use super::place::Place;
use crate::files::scene::Draft;

/// Largest distance from the equilibrium that counts as settled, as a share of the starting swing.
pub(crate) const BAND: f64 = 0.05;

/// A starting swing below this share of the deflection is rounding: the run starts in balance.
const BALANCE: f64 = 1e-6;

/// The least number of swings in a run that is judged: in a quarter of them each swing has a peak.
const SWINGS: f64 = 2.0;

/// The least number of answers of the environment in a run that is judged: the last tenth then has two.
const ANSWERS: u64 = 20;

/// Rounding of a run's length.
const ROUNDING: f64 = 1e-9;

/// Place and scale that the motion of a scene is judged by.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Criterion {
    /// The places where the plant may come to rest; one at most on a line.
    pub(crate) equilibria: Vec<Place>,
    /// The places that distances in a space are measured from: the equilibria, else the hand's rest; none on a line.
    middles: Vec<Place>,
    /// The swing that a run is measured against, m; 0 without an equilibrium.
    pub(crate) start: f64,
    /// Half the width of the band about the equilibrium that counts as settled, m; below 0 without an equilibrium.
    pub(crate) band: f64,
    /// Whether the plant starts in its equilibrium, up to rounding.
    pub(crate) starts_in_balance: bool,
    /// The ticks in which what drives the run recurs: the longest period of a hand and an environment that swing; 0 without.
    pub(crate) cycle: u64,
    /// The reason why the run is too short to judge.
    pub(crate) shortage: Option<Shortage>,
}

/// Reason why a run is too short to judge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Shortage {
    /// It is shorter than [`SWINGS`] periods of its slowest swing, each this long, s.
    Swings(f64),
    /// It has fewer ticks than [`ANSWERS`] answers of the environment take, this many.
    Answers(u64),
}

impl Criterion {
    pub(crate) fn of(scene: &Draft) -> Self {
        let equilibria = equilibria(scene);
        let start = Place::of(&scene.initial.position, scene.dimensions());
        let equilibrium = nearest(&equilibria, |axis| start.axes()[axis]).copied();
        let swing = equilibrium.map_or(0.0, |rest| swing(scene, &rest));
        // The starting swing, or the spring's deflection at the equilibrium if that is larger, so that a start in
        // balance is not measured against zero.
        let deflection = |rest: Place| rest.distance(|axis| scene.operator.rest.axis(axis));
        let start = equilibrium.map_or(0.0, |rest| swing.max(deflection(rest)));
        let starts_in_balance = equilibrium.is_some() && swing <= BALANCE * start;
        let width = BAND * if starts_in_balance { start } else { swing };
        let band = if equilibrium.is_some() { width } else { -1.0 };
        let hand = Place::of(&scene.operator.rest, scene.dimensions());
        let middles = match (scene.dimensions(), equilibria.is_empty()) {
            (1, _) => Vec::new(),
            (_, false) => equilibria.clone(),
            (_, true) => vec![hand],
        };
        // Rounded up, and of any size: a conversion ends at the largest number.
        let cycle =
            (slowest_drive(scene) * scene.servo_rate.get() * (1.0 - ROUNDING)).ceil() as u64;
        Self {
            equilibria,
            middles,
            start,
            band,
            starts_in_balance,
            cycle,
            shortage: Shortage::of(scene),
        }
    }

    /// The coordinate that a motion is judged along, m: on a line the position, in a space the distance from the nearest
    /// equilibrium, or from the hand's rest where there is none.
    #[inline]
    pub(crate) fn coordinate<V: Space>(&self, position: V) -> f64 {
        let distances = self.middles.iter().map(|it| it.distance(|axis| position.axis(axis)));
        distances.reduce(f64::min).unwrap_or_else(|| position.axis(0))
    }

    /// The equilibrium nearest to a position.
    pub(crate) fn nearest<V: Space>(&self, position: V) -> Option<&Place> {
        nearest(&self.equilibria, |axis| position.axis(axis))
    }

    /// The coordinate that the plant's distance is measured from, m; none where its speed is judged instead: without an
    /// equilibrium, or without a scale for the distance.
    pub(crate) fn place(&self) -> Option<f64> {
        self.equilibria.first().filter(|_| self.start > 0.0).map(|rest| self.along(rest))
    }

    /// The coordinate where the plant comes to rest and half the width of the band about it that counts as settled, m; a
    /// band below 0 where there is no such place.
    #[inline]
    pub(crate) fn rest(&self) -> (f64, f64) {
        (self.equilibria.first().map_or(0.0, |rest| self.along(rest)), self.band)
    }

    /// The coordinate of the equilibrium.
    #[inline]
    fn along(&self, rest: &Place) -> f64 {
        if self.middles.is_empty() { rest.axes()[0] } else { 0.0 }
    }
}

/// The place nearest to the point with the coordinate `of` each axis.
fn nearest(places: &[Place], of: impl Fn(usize) -> f64) -> Option<&Place> {
    let distance = |place: &&Place| place.distance(&of);
    places.iter().min_by(|one, other| distance(one).total_cmp(&distance(other)))
}

impl Shortage {
    fn of(scene: &Draft) -> Option<Self> {
        let delay = scene.delay_ticks().into();
        let least = ANSWERS.saturating_mul(scene.environment_ratio().saturating_add(delay));
        if scene.ticks() < least {
            return Some(Self::Answers(least));
        }
        let period = slowest_swing(scene);
        (scene.end() < SWINGS * period * (1.0 - ROUNDING)).then_some(Self::Swings(period))
    }
}

/// The longest period among the swings of a scene, s: that of the plant on its springs, that of a hand that swings, and
/// that of an environment that does; 0 without any.
fn slowest_swing(scene: &Draft) -> f64 {
    let kind = scene.environment.kind();
    // Before a one-sided wall the plant swings on the hand's spring alone.
    let own = kind.impedance().filter(|_| scene.surface().is_none() && scene.dimensions() == 1);
    let stiffness = last_pull(scene) + own.map_or(0.0, |it| it.stiffness);
    let mass = scene.operator.mass.get() + scene.device.mass.get();
    let free = if stiffness > 0.0 { TAU * (mass / stiffness).sqrt() } else { 0.0 };
    free.max(slowest_drive(scene))
}

/// The longest period of a hand and an environment that swing, s, as the ticks see it; 0 without any.
fn slowest_drive(scene: &Draft) -> f64 {
    let hand = driven(scene).map(|it| sampled(it, scene.servo_rate.get()));
    let environment = scene.environment.kind().frequency();
    let environment = environment.map(|it| sampled(it, scene.environment_rate()));
    let seen = hand.into_iter().chain(environment).filter(|frequency| *frequency > 0.0);
    seen.fold(0.0, |slowest, frequency| slowest.max(frequency.recip()))
}

/// The frequency that samples at `rate` show of a swing: its distance from the nearest multiple of the rate, Hz.
pub(crate) fn sampled(frequency: f64, rate: f64) -> f64 {
    let turns = frequency / rate;
    if turns <= 0.5 { frequency } else { (turns - turns.round()).abs() * rate }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::files::Scene;

    /// A plant of 0.5 kg on 50 N/m, which swings in 0.2 π s, at 1 kHz before a wall; `more` adds keys or replaces these.
    fn criterion(more: &str) -> Criterion {
        let usual = [
            ("duration", "4.0"),
            ("servo_rate", "1000.0"),
            ("device.mass", "0.5"),
            ("operator.stiffness", "50.0"),
            ("initial.position", "-0.004"),
            ("environment", "{ wall = { position = 0.001, stiffness = 1000.0 } }"),
        ];
        let given = |key: &str| {
            let mut keys = more.lines().map(|line| line.split_once(" =").map_or(line, |it| it.0));
            keys.any(|it| it == key || key.starts_with(&format!("{it}.")))
        };
        let usual = usual.iter().filter(|(key, _)| !given(key));
        let text: String = usual.map(|(key, value)| format!("{key} = {value}\n")).collect();
        let scene = Scene::parse(&format!("{text}{more}"), "test");
        Criterion::of(&scene.unwrap_or_else(|fault| panic!("{fault}")))
    }

    /// A rest that is held from tick to tick moves alike at f and at f plus the rate.
    #[test]
    fn a_swing_faster_than_the_ticks_counts_as_the_one_that_they_see() {
        for (frequency, seen) in
            [(0.6, 0.6), (1000.6, 0.6), (499.0, 499.0), (501.0, 499.0), (2999.4, 0.6)]
        {
            assert_abs_diff_eq!(sampled(frequency, 1000.0), seen, epsilon = 1e-9);
        }
        let sine = |frequency: f64| {
            let motion = "operator.motion = { kind = \"sine\", amplitude = 0.01, frequency = ";
            criterion(&format!("{motion}{frequency:?} }}\n"))
        };
        let (slow, fast) = (sine(0.9), sine(1000.9));
        assert_eq!((slow.cycle, slow.shortage), (fast.cycle, fast.shortage));
    }

    /// The equilibrium on a line.
    fn at(criterion: &Criterion) -> Option<f64> {
        criterion.equilibria.first().map(|place| place.axes()[0])
    }

    #[test]
    fn the_scale_is_the_swing_or_the_deflection_if_that_is_larger() {
        let free = criterion("");
        assert_eq!((at(&free), free.place()), (Some(0.0), Some(0.0)));
        assert_abs_diff_eq!(free.start, 0.004, epsilon = 1e-15);
        assert_abs_diff_eq!(free.band, 0.0002, epsilon = 1e-15);
        // 50 N/m pulling from 22 mm against 1 kN/m at 1 mm: balance at 2 mm, deflection 20 mm.
        let pressed = criterion("operator.rest = 0.022\n");
        assert_abs_diff_eq!(pressed.start, 0.020, epsilon = 1e-12);
        assert_abs_diff_eq!(pressed.band, 0.05 * 0.006, epsilon = 1e-12);
    }

    #[test]
    fn a_start_in_balance_takes_the_deflection_and_one_without_any_has_no_place() {
        let balanced = criterion("operator.rest = 0.022\ninitial.position = 0.002\n");
        assert!(balanced.starts_in_balance && !criterion("").starts_in_balance);
        assert_abs_diff_eq!(balanced.start, 0.020, epsilon = 1e-12);
        assert_abs_diff_eq!(balanced.band, 0.001, epsilon = 1e-12);
        let idle = criterion("initial.position = 0.0\n");
        assert_eq!((at(&idle), idle.start, idle.place()), (Some(0.0), 0.0, None));
        let loose = criterion("operator.stiffness = 0.0\n");
        assert_eq!((at(&loose), loose.place(), loose.rest()), (None, None, (0.0, -1.0)));
    }

    /// Whether a run of so many seconds is judged.
    fn is_judged(more: &str, duration: f64) -> bool {
        criterion(&format!("duration = {duration}\n{more}")).shortage.is_none()
    }

    #[test]
    fn a_judged_run_has_two_swings_of_the_slowest_kind() {
        let swing = |stiffness: f64| TAU * (0.5 / stiffness).sqrt();
        let sine = "motion = { kind = \"sine\", amplitude = 0.01, frequency = 0.5 }";
        for (more, period) in [
            (String::new(), swing(50.0)),
            ("operator.stiffness = 5.0\n".into(), swing(5.0)),
            ("environment = { spring = { stiffness = 400.0 } }\n".into(), swing(450.0)),
            ("environment = { spring = { stiffness = -45.0 } }\n".into(), swing(5.0)),
            (format!("operator = {{ stiffness = 50.0, {sine} }}\n"), 2.0),
            (
                "operator.stiffness = 0.0\nenvironment = { moving-wall = { stiffness = 1000.0, \
                 amplitude = 0.001, frequency = 0.8 } }\n"
                    .into(),
                1.25,
            ),
        ] {
            let two = 2.0 * period;
            assert!(is_judged(&more, two + 0.001) && !is_judged(&more, two - 0.001), "{more}");
        }
        // Nothing swings: any length will do.
        assert!(is_judged("operator.stiffness = 0.0\n", 0.02));
    }

    #[test]
    fn a_judged_run_has_twenty_answers_of_the_environment() {
        for (more, least) in [
            ("operator.stiffness = 0.0\n", 0.020),
            ("operator.stiffness = 0.0\nenvironment_rate = 100.0\n", 0.200),
            (
                "operator.stiffness = 0.0\nenvironment_rate = 100.0\neffects.delay.ticks = 8\n",
                0.360,
            ),
        ] {
            assert!(is_judged(more, least) && !is_judged(more, least - 0.001), "{more}");
        }
    }
}
