//! Fit of a wall to the force of a log.

use nalgebra::{Matrix4, Vector4};

use super::blocks::{Score, Spread, spread};
use super::least_squares::inverse;
use super::stretch::Stretch;

/// Forces, as shares of the largest, from which on a row is first taken as contact; a loop that grows ends in far larger ones
/// than it began with.
const TOUCH: [f64; 3] = [0.05, 1e-3, 1e-6];

/// Share of the largest force up to which a depth is rounding: a wall may stand on a step of the encoder.
pub(super) const EDGE: f64 = 1e-9;

/// Most rounds in which rows join or leave the contact.
const ROUNDS: usize = 50;

/// Most rows by which the force may be late.
pub(super) const LAGS: usize = 8;

/// Fewest rows in contact that a wall is fitted to.
const FEWEST: usize = 6;

/// Share of the rows with the largest force in which a wall fitted to the others asks for more, where that force is a limit, and
/// the share by which it asks for more on average: of a force in steps, or at rest, it asks for as much.
const CLIPPED: f64 = 0.9;
const BEYOND: f64 = 0.05;

/// Share of the largest force from which on a force out of contact is no error of a sensor.
pub(super) const STRAY: f64 = 0.1;

/// Share of the force that a wall has to explain, as root mean squares.
const EXPLAINED: f64 = 0.5;

/// The positions and velocities that a wall may have seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Seen {
    /// The log's positions and their backward differences.
    Measured,
    /// The log's positions and velocities.
    WithVelocity,
    /// The fitted positions and their backward differences.
    Fitted,
}

/// What a wall saw, and its force.
#[derive(Clone, Copy, Debug)]
struct Touch {
    position: f64,
    velocity: f64,
    force: f64,
}

/// A wall `f = max(0, K (x − x0) + B v)` for `x > x0`, fitted to a log.
#[derive(Clone, Debug)]
pub(super) struct Wall {
    /// Stiffness in N/m, damping in N·s/m, and the force at the origin, N.
    pub(super) at: Vector4<f64>,
    pub(super) spread: Option<Spread>,
    pub(super) seen: Seen,
    /// Rows by which its force is late.
    pub(super) lag: usize,
    /// Rows in contact.
    pub(super) rows: usize,
    /// Error over the rows in contact, root mean square, N.
    pub(super) error: f64,
    /// Force over the same rows, root mean square, N.
    pub(super) force: f64,
    /// Standard deviation of the position in contact, m.
    pub(super) travel: f64,
    /// Standard deviation of the velocity in contact, m/s.
    pub(super) speed: f64,
    /// Error of the positions that it was fitted to, where those are fitted themselves, m.
    pub(super) unsure: f64,
    /// The largest force of the log, N, the rows with it, and whether those are clipped and left out.
    pub(super) largest: f64,
    pub(super) at_most: usize,
    pub(super) is_clipped: bool,
    /// The largest magnitude of the force out of contact, N, and the rows there with more than a share [`STRAY`] of the largest.
    pub(super) stray: f64,
    pub(super) strays: usize,
    cost: f64,
}

impl Wall {
    /// Its surface, from the recording's origin on, m.
    pub(super) fn position(&self) -> f64 {
        -self.at[2] / self.at[0]
    }

    /// Its force at a position from the recording's origin on, N.
    pub(super) fn force_at(&self, position: f64, velocity: f64) -> f64 {
        wall(&self.at, EDGE * self.largest, position, velocity)
    }

    /// The wall that explains the force of a log best; `fitted` are the positions from the row `late` of each
    /// stretch on, `unsure` their error.
    pub(super) fn of(
        stretches: &[Stretch],
        fitted: &[f64],
        late: usize,
        unsure: f64,
    ) -> Option<Self> {
        let largest =
            stretches.iter().flat_map(|it| &it.forces).fold(0.0_f64, |most, it| most.max(*it));
        if largest <= 0.0 {
            return None;
        }
        let has_velocity = stretches.iter().all(|it| !it.velocities.is_empty());
        let sources =
            [Some(Seen::Measured), has_velocity.then_some(Seen::WithVelocity), Some(Seen::Fitted)];
        let sources: Vec<Seen> = sources.into_iter().flatten().collect();
        let touches = |seen, lag| touches(stretches, fitted, late, seen, lag);
        let best = |takes: &dyn Fn(&Touch) -> bool| {
            let all = sources.iter().flat_map(|seen| (0..=LAGS).map(|lag| (*seen, lag)));
            let walls = all.flat_map(|(seen, lag)| {
                let touches: Vec<Touch> = touches(seen, lag).into_iter().filter(takes).collect();
                TOUCH.map(|share| Self::fit(&touches, share, largest, (seen, lag)))
            });
            // The first of several that explain it as well.
            let better = |best: Self, next: Self| {
                if next.cost < 0.98 * best.cost { next } else { best }
            };
            let best = walls.flatten().reduce(better)?;
            (best.error <= EXPLAINED * best.force).then_some(best)
        };
        let forces = stretches.iter().flat_map(|it| &it.forces);
        let at_most = forces.filter(|it| **it == largest).count();
        let clipped = || {
            let wall = best(&|it| it.force < largest)?;
            let left = touches(wall.seen, wall.lag).into_iter().filter(|it| it.force == largest);
            let is_clipped = wall.asks_beyond(&left.collect::<Vec<_>>());
            is_clipped.then_some(Self { is_clipped, ..wall })
        };
        let wall = (at_most >= FEWEST).then(clipped).flatten().or_else(|| best(&|_| true))?;
        let unsure = if wall.seen == Seen::Fitted { unsure } else { 0.0 };
        Some(Self { unsure, at_most, ..wall })
    }

    /// The force that the error of fitted positions may add, N.
    pub(super) fn unsure_force(&self) -> f64 {
        self.unsure * (self.at[0] + self.at[1] * self.speed / self.travel)
    }

    /// Whether the wall, fitted to the other rows, asks for more than the force of these.
    fn asks_beyond(&self, touches: &[Touch]) -> bool {
        let excess = touches.iter().map(|it| self.force_at(it.position, it.velocity) - it.force);
        let beyond = excess.clone().filter(|it| *it > EDGE * self.largest).count() as f64;
        let rows = touches.len() as f64;
        beyond >= CLIPPED * rows && excess.sum::<f64>() >= BEYOND * self.largest * rows
    }

    fn fit(
        touches: &[Touch],
        share: f64,
        largest: f64,
        (seen, lag): (Seen, usize),
    ) -> Option<Self> {
        let edge = EDGE * largest;
        let wall = |at: &Vector4<f64>, it: &Touch| wall(at, edge, it.position, it.velocity);
        let mut contact: Vec<bool> = touches.iter().map(|it| it.force > share * largest).collect();
        let mut at = Vector4::zeros();
        for _ in 0..ROUNDS {
            at = line(touches, &contact)?;
            if at[0] <= 0.0 || at[0].is_nan() {
                return None;
            }
            let next: Vec<bool> = touches.iter().map(|it| wall(&at, it) > 0.0).collect();
            if next == contact {
                break;
            }
            contact = next;
        }
        let scores = scores(touches, &contact, &at);
        let rows = scores.len();
        let known: Matrix4<f64> = scores.iter().map(|it| it.slope * it.slope.transpose()).sum();
        let spread = inverse(&known, LINE).and_then(|it| spread(&scores, rows as f64, &it, 3));
        let mean = |of: &dyn Fn(&Touch) -> f64| {
            let of_contact = touches.iter().zip(&contact).filter(|it| *it.1);
            of_contact.map(|it| of(it.0)).sum::<f64>() / rows as f64
        };
        let mean_square = |of: &dyn Fn(&Touch) -> f64| mean(&|it| of(it).powi(2));
        let off = |it: &Touch| it.force - wall(&at, it);
        let outside = || touches.iter().filter(|it| wall(&at, it) == 0.0).map(|it| it.force.abs());
        let [middle, drift] = [mean(&|it| it.position), mean(&|it| it.velocity)];
        Some(Self {
            at,
            spread,
            seen,
            lag,
            rows,
            error: mean_square(&off).sqrt(),
            force: mean_square(&|it| it.force).sqrt(),
            travel: mean_square(&|it| it.position - middle).sqrt(),
            speed: mean_square(&|it| it.velocity - drift).sqrt(),
            unsure: 0.0,
            largest,
            at_most: 0,
            is_clipped: false,
            stray: outside().fold(0.0, f64::max),
            strays: outside().filter(|it| *it > STRAY * largest).count(),
            cost: touches.iter().map(|it| off(it).powi(2)).sum::<f64>() / touches.len() as f64,
        })
    }
}

fn wall(at: &Vector4<f64>, edge: f64, position: f64, velocity: f64) -> f64 {
    let depth = at[0] * position + at[2];
    if depth > edge { (depth + at[1] * velocity).max(0.0) } else { 0.0 }
}

const LINE: [bool; 4] = [true, true, true, false];

fn slope(touch: &Touch) -> Vector4<f64> {
    Vector4::new(touch.position, touch.velocity, 1.0, 0.0)
}

fn scores(touches: &[Touch], contact: &[bool], at: &Vector4<f64>) -> Vec<Score> {
    let of_contact = touches.iter().zip(contact).filter(|it| *it.1);
    let score = |(touch, _): (&Touch, &bool)| {
        let slope = slope(touch);
        Score { slope, error: touch.force - slope.dot(at) }
    };
    of_contact.map(score).collect()
}

/// The plane through the rows in contact: stiffness, damping (0 or more) and force at the origin.
fn line(touches: &[Touch], contact: &[bool]) -> Option<Vector4<f64>> {
    let scores = scores(touches, contact, &Vector4::zeros());
    if scores.len() < FEWEST {
        return None;
    }
    let known: Matrix4<f64> = scores.iter().map(|it| it.slope * it.slope.transpose()).sum();
    let solved = |free| {
        let inverse = inverse(&known, free)?;
        let mut at = Vector4::zeros();
        // A second round takes back what the first lost by rounding.
        for _ in 0..2 {
            let rest: Vector4<f64> =
                scores.iter().map(|it| it.slope * (it.error - it.slope.dot(&at))).sum();
            at += inverse * rest;
        }
        Some(at)
    };
    match solved(LINE) {
        Some(at) if at[1] >= 0.0 => Some(at),
        _ => solved([true, false, true, false]),
    }
}

fn touches(
    stretches: &[Stretch],
    fitted: &[f64],
    late: usize,
    seen: Seen,
    lag: usize,
) -> Vec<Touch> {
    let mut touches = Vec::new();
    let mut offset = 0;
    for stretch in stretches {
        let first = if seen == Seen::Fitted { late } else { 0 };
        let positions = match seen {
            Seen::Fitted => &fitted[offset..offset + stretch.len().saturating_sub(late)],
            _ => &stretch.positions[..],
        };
        offset += stretch.len().saturating_sub(late);
        for row in first + lag + 1..stretch.len() {
            let (at, period) = (row - lag, stretch.times[row - lag] - stretch.times[row - lag - 1]);
            let position = positions[at - first];
            let velocity = match seen {
                Seen::WithVelocity => stretch.velocities[at],
                _ => (position - positions[at - first - 1]) / period,
            };
            touches.push(Touch { position, velocity, force: stretch.forces[row] });
        }
    }
    touches
}
