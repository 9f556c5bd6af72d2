//! Trace of one run, until it is decided.

/// Share of the start within which a run has settled.
const BAND: f64 = 0.05;
/// Time that a run stays within the band before it counts as settled, s: six swings of the hand.
const HOLD: f64 = 3.0;
/// Multiple of its start that a bounded run never passes, unless it settles all the same.
const REACH: f64 = 10.0;
/// Multiple of its start from which no run comes back.
const GONE: f64 = 1000.0;

/// One tick of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Point {
    /// Position, m.
    pub x: f64,
    /// The velocity that the observer sees, m/s.
    pub v: f64,
    /// The wall's force, N.
    pub force: f64,
    /// The damping injected, N·s/m.
    pub alpha: f64,
    /// The observed energy, J.
    pub observed_energy: f64,
    /// The energy that the tick adds to the observed energy, J, also where the observed energy is too large to show it.
    pub booked: f64,
}

/// The ticks of one run, from the first on.
///
/// A run is decided where `|x|` has stayed within 5 % of the start for 3 s, and where it passes a thousand times the start.
/// Ticks after that are not kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Trace {
    /// The period, s.
    pub period: f64,
    /// Distance from the wall at which the plant was released, m.
    pub start: f64,
    points: Vec<Point>,
    /// The latest ticks in a row within the band.
    inside: usize,
    settled: Option<usize>,
    left: Option<usize>,
    gone: Option<usize>,
}

impl Trace {
    /// A trace without ticks.
    pub fn new(period: f64, start: f64) -> Self {
        let points = Vec::new();
        Self { period, start, points, inside: 0, settled: None, left: None, gone: None }
    }

    /// Adds one more tick, unless the run is decided.
    #[inline]
    pub fn push(&mut self, point: Point) {
        if self.is_decided() {
            return;
        }
        let (tick, away) = (self.points.len(), point.x.abs());
        self.points.push(point);
        self.inside = if away <= BAND * self.start { self.inside + 1 } else { 0 };
        // A position that is not a number is beyond everything.
        let beyond = |reach: f64| (away.is_nan() || away > reach * self.start).then_some(tick);
        self.left = self.left.or_else(|| beyond(REACH));
        self.gone = beyond(GONE);
        self.settled = (self.inside > self.ticks(HOLD)).then(|| tick - self.ticks(HOLD));
    }

    /// Whether further ticks change nothing.
    pub fn is_decided(&self) -> bool {
        self.settled.is_some() || self.gone.is_some()
    }

    /// The ticks.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// The first tick from which `|x|` stays within 5 % of the start for 3 s.
    pub fn settled(&self) -> Option<usize> {
        self.settled
    }

    /// The first tick at which `|x|` is beyond ten times the start.
    pub fn left(&self) -> Option<usize> {
        self.left
    }

    /// The first tick at which `|x|` is beyond a thousand times the start.
    pub fn gone(&self) -> Option<usize> {
        self.gone
    }

    /// The number of ticks in a time, s.
    pub(super) fn ticks(&self, time: f64) -> usize {
        (time / self.period).round() as usize
    }

    /// Half the width of the band, m.
    pub(super) fn band(&self) -> f64 {
        BAND * self.start
    }
}
