//! Verdict on the run of a scene, lane by lane.

use std::ops::Range;

use lyapunov::Scalar;

use super::stretches::{ALL, EARLY, LAST_QUARTER, LAST_TENTH, SECOND, Span, Stretches};
use super::verdict::{Findings, Verdict, Yardstick};
use crate::files::scene::Draft;
use crate::simulate::criterion::BAND;
use crate::simulate::{Criterion, Space, Tick};

/// Largest ratio of the last quarter's swing to the second's in a run that does not grow: as much as sampling the peaks
/// of an undamped swing may amount to, and no more.
const GROWTH: f64 = 1.05;

/// The distance that is never bounded, as a multiple of the starting swing.
const REACH: f64 = 10.0;

/// Watches the distance `e(n) = |x(n) − x_eq|` from where the operator's spring and the environment balance; where they
/// do not balance anywhere, the speed `|v(n)|` of the plant.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Fate<T> {
    criteria: Vec<Criterion>,
    /// Of positions: `e` is largest at one of the extremes, whatever `x_eq` is.
    positions: Stretches<T>,
    /// Of speeds; none if every lane is judged by its distance.
    speeds: Option<Stretches<T>>,
}

/// The sizes by which a run is judged: distances in m, or speeds in m/s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sizes {
    /// The largest in the second quarter.
    pub(crate) second: f64,
    /// The largest in the last quarter.
    pub(crate) end: f64,
    /// The largest in the last tenth.
    pub(crate) tail: f64,
    /// The largest of all.
    pub(crate) widest: f64,
}

impl<T: Scalar> Fate<T> {
    /// The meter of a run of `scene`.
    pub(crate) fn of(scene: &Draft) -> Self {
        Self::of_lanes([scene])
    }

    /// The meter of a run of each of `scenes`, all with as many ticks, and in a cycle.
    pub(crate) fn of_lanes<'a>(scenes: impl IntoIterator<Item = &'a Draft>) -> Self {
        let mut scenes = scenes.into_iter().peekable();
        let last = scenes.peek().map_or(0, |scene| scene.ticks());
        let criteria: Vec<Criterion> = scenes.map(Criterion::of).collect();
        let has_place = criteria.iter().all(|criterion| criterion.place().is_some());
        let cycle = criteria.iter().map(|criterion| criterion.cycle).max().unwrap_or(0);
        let speeds = (!has_place).then(|| Stretches::recurring(last, cycle));
        Self { criteria, positions: Stretches::new(last), speeds }
    }

    /// Adds the position and the velocity of one more tick, as they really are; in a space the
    /// [coordinate](Criterion::coordinate) and the speed.
    #[inline(always)]
    pub(crate) fn add(&mut self, position: T, velocity: T) {
        self.positions.add(position);
        if let Some(speeds) = &mut self.speeds {
            add_speed(speeds, velocity);
        }
    }

    /// The ticks that may be [watched](Self::watched) from here on, at least one.
    pub(crate) fn room(&mut self) -> u64 {
        self.positions.room()
    }

    /// The fate over some ticks, no more than there is [room](Self::room) for.
    #[inline(always)]
    pub(crate) fn watched(&mut self) -> Watched<'_, T> {
        Watched { span: self.positions.span(), fate: self }
    }

    /// Whether it judges by positions alone.
    pub(crate) fn needs_positions_only(&self) -> bool {
        self.speeds.is_none()
    }

    /// The criterion of a lane.
    pub(crate) fn criterion(&self, lane: usize) -> &Criterion {
        &self.criteria[lane]
    }

    /// The quantity that a lane is judged by.
    pub(crate) fn verdict_by(&self, lane: usize) -> Yardstick {
        Yardstick::of(&self.criteria[lane])
    }

    /// Whether the run of a lane grows already, whatever follows.
    pub(crate) fn is_lost(&self, lane: usize) -> bool {
        let is_judged = self.criteria[lane].shortage.is_none() && self.positions.is_late();
        self.is_out(lane) || is_judged && self.grows(lane)
    }

    /// Whether every tick was added.
    pub(crate) fn is_complete(&self) -> bool {
        self.positions.is_complete()
    }

    /// The verdict on the run of a lane; a run that is not complete has left the range of the numbers.
    pub(crate) fn verdict(&self, lane: usize) -> Verdict {
        Verdict::of(Findings {
            is_lost: !self.is_complete() || self.is_out(lane),
            is_short: self.criteria[lane].shortage.is_some(),
            grows: self.grows(lane),
            settles: self.settles(lane),
        })
    }

    /// The distance that a lane does not leave while it is bounded, m; none if it is judged by its speed.
    pub(crate) fn reach(&self, lane: usize) -> Option<f64> {
        let criterion = &self.criteria[lane];
        criterion.place().map(|_| REACH * criterion.start)
    }

    /// Whether a lane left the bound of its distance.
    pub(crate) fn is_out(&self, lane: usize) -> bool {
        self.reach(lane).is_some_and(|reach| self.size(ALL, lane) > reach)
    }

    fn grows(&self, lane: usize) -> bool {
        let [second, end] = [self.size(SECOND, lane), self.size(LAST_QUARTER, lane)];
        end > (GROWTH * second).max(self.noise(lane))
    }

    /// Size below which growth is noise: the band about the starting swing, or about the speed of the first half, of which the
    /// second quarter is what growth is compared with.
    fn noise(&self, lane: usize) -> f64 {
        match self.criteria[lane].place() {
            Some(_) => BAND * self.criteria[lane].start,
            None => BAND * self.size(EARLY, lane),
        }
    }

    fn settles(&self, lane: usize) -> bool {
        let tail = self.size(LAST_TENTH, lane);
        match self.criteria[lane].place() {
            Some(_) => tail <= self.criteria[lane].band,
            None => tail <= BAND * self.size(ALL, lane),
        }
    }

    /// The sizes of a lane, so far.
    pub(crate) fn sizes(&self, lane: usize) -> Sizes {
        Sizes {
            second: self.size(SECOND, lane),
            end: self.size(LAST_QUARTER, lane),
            tail: self.size(LAST_TENTH, lane),
            widest: self.size(ALL, lane),
        }
    }

    /// The largest distance or speed of a lane over some stretches, so far; 0 without a row.
    fn size(&self, stretches: Range<usize>, lane: usize) -> f64 {
        match (&self.speeds, self.criteria[lane].place()) {
            (_, Some(rest)) => {
                let [low, high] = self.positions.extremes(stretches, lane);
                // Rounding of a difference is monotonic, so this is the largest of all.
                (high - rest).max(rest - low).max(0.0)
            }
            (Some(speeds), None) => speeds.extremes(stretches, lane)[1].max(0.0),
            (None, None) => 0.0,
        }
    }
}

/// A fate over some ticks, with what changes at each of them apart, so that it may stay in registers.
#[derive(Debug)]
pub(crate) struct Watched<'a, T> {
    span: Span<T>,
    fate: &'a mut Fate<T>,
}

impl<T: Scalar> Watched<'_, T> {
    /// Adds one more tick, as [`Fate::add`].
    #[inline(always)]
    pub(crate) fn add(&mut self, position: T, velocity: T) {
        self.span.add(position);
        if let Some(speeds) = &mut self.fate.speeds {
            add_speed(speeds, velocity);
        }
    }

    /// Adds the position of one more tick to a fate that [needs no more](Fate::needs_positions_only).
    #[inline(always)]
    pub(crate) fn place(&mut self, position: T) {
        self.span.add(position);
    }

    /// The largest |position| of the present stretch.
    #[inline(always)]
    pub(crate) fn reach(&self) -> T {
        self.span.reach()
    }

    /// Ends after as many `ticks`.
    #[inline(always)]
    pub(crate) fn end(self, ticks: u64) {
        self.fate.positions.take(self.span, ticks);
    }
}

/// Adds a speed out of the way of the lanes of a map, which hardly ever have one to add.
#[cold]
#[inline(never)]
fn add_speed<T: Scalar>(speeds: &mut Stretches<T>, velocity: T) {
    speeds.add(velocity.magnitude());
}

impl Fate<f64> {
    /// Adds one more tick: the coordinate that its motion is judged along, and its speed.
    pub(crate) fn add_tick<V: Space>(&mut self, tick: &Tick<V>) {
        let coordinate = self.criteria[0].coordinate(tick.truth.position);
        self.add(coordinate, tick.truth.velocity.length());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::files::Scene;
    use crate::measure::samples::scene;

    /// The verdict on a run of `rows` rows with `x(t)` and `v(t)`.
    fn judged(
        scene: &Scene,
        rows: u64,
        x: impl Fn(f64) -> f64,
        v: impl Fn(f64) -> f64,
    ) -> (Verdict, Yardstick) {
        let mut fate = Fate::of(scene);
        for row in 0..rows {
            // A run that is known to grow does, however it goes on.
            let was_lost = fate.is_lost(0);
            fate.add(x(row as f64 * scene.period()), v(row as f64 * scene.period()));
            assert!(!was_lost || fate.is_lost(0));
        }
        let verdict = fate.verdict(0);
        assert!(!fate.is_lost(0) || verdict == Verdict::Grows);
        (verdict, fate.verdict_by(0))
    }

    /// The verdict on a whole run at `x(t)` of a scene of a second at 100 Hz, with its equilibrium at 0 and a starting
    /// swing of 4 mm that takes 0.487 s.
    fn verdict(x: impl Fn(f64) -> f64) -> Verdict {
        let (verdict, by) = judged(&scene(""), 101, x, |_| 0.0);
        assert_eq!(by, Yardstick::Distance);
        verdict
    }

    #[test]
    fn swings_of_closed_form_are_told_by_their_rate() {
        let swing = |rate: f64| verdict(move |t| 0.004 * (rate * t).exp() * (60.0 * t).cos());
        // From 0.9 s on within 5 % from a rate of ln(0.05) / 0.9 s on, as far as the peaks are sampled.
        assert_eq!([-6.0, -3.4].map(swing), [Verdict::Settles; 2]);
        assert_eq!([-3.0, -0.5, 0.0].map(swing), [Verdict::Swinging; 3]);
        assert_eq!([0.5, 2.0].map(swing), [Verdict::Grows; 2]);
        // Growth from a swing that had died away first.
        let again = |t: f64| 0.004 * (1.0 - 2.0 * t).abs() * (60.0 * t).cos();
        assert_eq!(verdict(again), Verdict::Grows);
    }

    #[test]
    fn the_definitions_hold_to_the_row() {
        // The band is 0.2 mm, and it counts from the row at 0.9 s on.
        assert_eq!(verdict(|_| 0.000_199), Verdict::Settles);
        assert_eq!(verdict(|_| 0.000_201), Verdict::Swinging);
        let enters = |at: f64| verdict(move |t| if t < at { 0.004 } else { 0.0 });
        assert_eq!((enters(0.9), enters(0.905)), (Verdict::Settles, Verdict::Swinging));
        // Growth within the band is noise, and beyond it 5 % are the peaks between two samples.
        let last_quarter = |before: f64, end: f64| {
            verdict(move |t| if t > 0.8 && t < 0.85 { end } else { before })
        };
        assert_eq!(last_quarter(0.0001, 0.000_199), Verdict::Settles);
        assert_eq!(last_quarter(0.0001, 0.000_201), Verdict::Grows);
        assert_eq!(last_quarter(0.002, 0.00209), Verdict::Swinging);
        assert_eq!(last_quarter(0.002, 0.00211), Verdict::Grows);
        // Beyond ten times the start a cycle is lost, even if it stands still.
        assert_eq!(verdict(|_| 0.0399), Verdict::Swinging);
        assert_eq!(verdict(|_| 0.0401), Verdict::Grows);
        // What grows does not settle, even if it ends in the band.
        assert_eq!(last_quarter(0.0, 0.001), Verdict::Grows);
    }

    #[test]
    fn a_short_run_is_not_judged_unless_it_is_lost() {
        // Two swings take 0.973 s.
        for (duration, word) in [("0.98", Verdict::Settles), ("0.97", Verdict::TooShort)] {
            let scene = scene(&format!("duration = {duration}\n"));
            let told = |rows: u64, x: f64| judged(&scene, rows, |_| x, |_| 0.0).0;
            let rows = scene.ticks() + 1;
            assert_eq!(told(rows, 0.0), word, "{duration}");
            assert_eq!(told(rows, 0.041), Verdict::Grows, "{duration}");
            // Rows that end early have left the range of the numbers.
            assert_eq!(told(rows - 1, 0.0), Verdict::Grows, "{duration}");
        }
        let short = scene("duration = 0.97\n");
        let growing = |t: f64| 0.001 * (2.0 * t).exp() * (60.0 * t).cos();
        assert_eq!(judged(&short, short.ticks() + 1, growing, |_| 0.0).0, Verdict::TooShort);
    }

    #[test]
    fn without_an_equilibrium_the_speed_decides() {
        let loose = scene("operator.stiffness = 0.0\n");
        let told = |v: &dyn Fn(f64) -> f64| {
            let (verdict, by) = judged(&loose, 101, |t| 10.0 * t, v);
            assert_eq!(by, Yardstick::Speed);
            verdict
        };
        let swing = |rate: f64| told(&move |t: f64| 0.2 * (rate * t).exp() * (60.0 * t).sin());
        assert_eq!([-6.0, -3.5].map(swing), [Verdict::Settles; 2]);
        assert_eq!([-3.0, 0.0].map(swing), [Verdict::Swinging; 2]);
        assert_eq!([0.5, 2.0].map(swing), [Verdict::Grows; 2]);
        assert_eq!(told(&|_| 0.3), Verdict::Swinging);
        assert_eq!(told(&|_| 0.0), Verdict::Settles);
        // Direction does not matter, and a twentieth of the first quarter's speed is noise.
        assert_eq!(told(&|t| if t > 0.8 { -0.106 } else { 0.1 }), Verdict::Grows);
        let rests = |end: f64| {
            move |t: f64| {
                if t < 0.1 {
                    1.0
                } else if t > 0.8 {
                    end
                } else {
                    0.0
                }
            }
        };
        assert_eq!(told(&rests(0.049)), Verdict::Settles);
        assert_eq!(told(&rests(0.051)), Verdict::Grows);
        assert_eq!(judged(&loose, 100, |_| 0.0, |_| 0.0).0, Verdict::Grows);
    }

    #[test]
    fn a_start_at_rest_is_judged_by_speed_and_a_start_in_balance_by_the_deflection() {
        let idle = scene("initial.position = 0.0\n");
        let told = judged(&idle, 101, |_| 0.0, |_| 0.0);
        assert_eq!(told, (Verdict::Settles, Yardstick::Speed));
        // Balance at 2 mm, deflection 20 mm.
        let balanced = scene("operator.rest = 0.022\ninitial.position = 0.002\n");
        let at = |x: f64| judged(&balanced, 101, move |_| x, |_| 0.0).0;
        assert_eq!((at(0.0029), at(0.0031)), (Verdict::Settles, Verdict::Swinging));
    }

    /// A motion that recurs with the hand, with a stroke in each period, over runs of all lengths and phases.
    #[test]
    fn what_recurs_with_its_drive_neither_grows_nor_settles() {
        let (period, mut grown) = (0.7, 0);
        for tenths in 14..70 {
            let duration = f64::from(tenths) / 10.0;
            let driven = scene(&format!(
                "duration = {duration}\noperator.motion = {{ kind = \"sine\", amplitude = 0.01, frequency = {:?} }}\n",
                1.0 / period
            ));
            for phase in [0.0, 0.1, 0.3, 0.6] {
                let told = |rate: f64| {
                    let stroke = |t: f64| if (t + phase) % period < 0.05 { 1.0 } else { 0.001 };
                    let speed = move |t: f64| (rate * t).exp() * stroke(t);
                    judged(&driven, driven.ticks() + 1, |_| 0.0, speed)
                };
                assert_eq!(told(0.0), (Verdict::Swinging, Yardstick::Speed), "{duration}, {phase}");
                grown += u32::from(told(0.5).0 == Verdict::Grows);
                assert_ne!(told(0.5).0, Verdict::Settles, "{duration}, {phase}");
            }
        }
        assert_eq!(grown, 4 * 56);
    }

    /// Lanes of different scenes, against each by itself.
    #[test]
    fn lanes_are_judged_one_by_one() {
        use lyapunov::lanes::AutoF64x8;

        let scenes = ["", "operator.stiffness = 0.0\n", "initial.position = -0.02\n"].map(scene);
        let drafts = [0, 1, 2].map(|index: usize| scenes[index].to_draft());
        let x = |lane: usize, t: f64| 0.004 * (lane as f64 - 1.0) * (t * lane as f64).exp();
        let mut lanes = Fate::<AutoF64x8>::of_lanes(&drafts);
        for row in 0..101 {
            let t = f64::from(row) / 100.0;
            let at = |lane: usize| x(lane, t);
            lanes.add(AutoF64x8::from_lanes(at), AutoF64x8::from_lanes(|lane| -at(lane)));
        }
        for (lane, scene) in scenes.iter().enumerate() {
            let alone = judged(scene, 101, |t| x(lane, t), |t| x(lane, t));
            assert_eq!((lanes.verdict(lane), lanes.verdict_by(lane)), alone, "{lane}");
        }
    }
}
