//! Fit of the model's coefficients to a log: output error over segments.

use nalgebra::{Matrix4, Vector4};

use super::base::Base;
use super::blocks::Score;
use super::least_squares::inverse;
use super::motion::{BIAS, Coefficients, DECAY, MOBILITY, Motion, SPRING, State};
use super::stretch::{Stretch, weights};

/// Most steps of one fit.
const STEPS: usize = 40;

/// Decrease of the cost, as a share, below which a fit has ended.
const DONE: f64 = 1e-10;

/// Horizon at which a fit begins, in rows, and the factor from one to the next.
const HORIZONS: [usize; 3] = [16, 64, 256];
const LONGER: usize = 4;

/// A setting of a fit: which rows are predicted from which.
#[derive(Clone, Copy, Debug)]
pub(super) struct Setting<'a> {
    pub(super) stretches: &'a [Stretch],
    /// The median period, s.
    pub(super) period: f64,
    /// Rows by which the force acts late.
    pub(super) lag: usize,
    /// Rows that are predicted from one state.
    pub(super) horizon: usize,
    /// Whether each segment has a constant force of its own.
    pub(super) pushed: bool,
    /// The coefficients that are fitted.
    pub(super) free: [bool; 4],
}

/// A pass over the log with some coefficients.
#[derive(Clone, Debug)]
pub(super) struct Pass {
    pub(super) cost: f64,
    /// Sum of the weights of the rows.
    pub(super) weight: f64,
    /// Numbers that belong to one segment only.
    pub(super) own: usize,
    pub(super) known: Matrix4<f64>,
    slope: Vector4<f64>,
    pub(super) scores: Vec<Score>,
    /// Fitted positions, in the order of the rows that are predicted.
    pub(super) fitted: Vec<f64>,
    /// Position and velocity of the first predicted row.
    pub(super) start: [f64; 2],
    /// Sum of the segments' own accelerations, each times its rows, m/s².
    pub(super) pushes: f64,
}

/// The result of a fit.
#[derive(Clone, Debug)]
pub(super) struct Fit {
    pub(super) at: Coefficients,
    pub(super) pass: Pass,
}

impl Fit {
    /// The error of a row, root mean square, m, free of the numbers fitted.
    pub(super) fn error(&self, free: usize) -> f64 {
        let freedom = self.pass.weight - (self.pass.own + free) as f64;
        (self.pass.cost / freedom.max(1.0)).sqrt()
    }
}

impl Setting<'_> {
    /// Number of coefficients that are fitted.
    pub(super) fn count(&self) -> usize {
        self.free.iter().filter(|it| **it).count()
    }

    /// The best fit from horizons that grow, begun at several.
    pub(super) fn fit(&self, from: Coefficients) -> Option<Fit> {
        let longest = self.stretches.iter().map(Stretch::len).max()?.min(self.horizon);
        let from_horizon = |first: &usize| {
            let mut at = from;
            let mut horizon = *first;
            while horizon < longest {
                let setting = Setting { horizon, ..*self };
                at = setting.refine(at).map_or(at, |fit| fit.at);
                horizon *= LONGER;
            }
            self.refine(at)
        };
        let starts = HORIZONS.iter().filter(|first| **first < longest).map(from_horizon);
        starts
            .chain([self.refine(from)])
            .flatten()
            .min_by(|one, other| one.pass.cost.total_cmp(&other.pass.cost))
    }

    /// Gauss and Newton's steps from these coefficients on.
    pub(super) fn refine(&self, from: Coefficients) -> Option<Fit> {
        let mut at = from;
        let mut pass = self.pass(&at)?;
        // The linear coefficients first: they are right where there is no force, and the others have no effect there.
        let linear = [false, false, self.free[BIAS], self.free[MOBILITY]];
        if let Some(step) = solve(&pass, linear)
            && let Some(next) = self.pass(&(at + step))
            && next.cost < pass.cost
        {
            (at, pass) = (at + step, next);
        }
        for _ in 0..STEPS {
            let Some(step) = self.step(&at, &pass) else { break };
            let shorter = (0..12).map(|halvings| step * 0.5_f64.powi(halvings));
            let found = shorter.map(|step| passive(at + step)).find_map(|at| {
                let next = self.pass(&at)?;
                (next.cost < pass.cost).then_some((at, next))
            });
            let Some((next, better)) = found else { break };
            let decrease = pass.cost - better.cost;
            (at, pass) = (next, better);
            if decrease <= DONE * pass.cost {
                break;
            }
        }
        Some(Fit { at, pass })
    }

    /// The step to the best coefficients; one that is 0 and would fall below stays.
    fn step(&self, at: &Coefficients, pass: &Pass) -> Option<Coefficients> {
        let mut free = self.free;
        loop {
            let step = solve(pass, free)?;
            let held = [DECAY, SPRING]
                .into_iter()
                .find(|it| free[*it] && at[*it] <= 0.0 && step[*it] < 0.0);
            match held {
                Some(it) => free[it] = false,
                None => return Some(step),
            }
        }
    }

    /// The step that the data alone ask for.
    pub(super) fn unbound_step(&self, fit: &Fit) -> Coefficients {
        solve(&fit.pass, self.free).unwrap_or_default()
    }

    /// One pass over the log.
    pub(super) fn pass(&self, at: &Coefficients) -> Option<Pass> {
        let mut motion = Motion::new(at, self.period);
        let mut pass = Pass {
            cost: 0.0,
            weight: 0.0,
            own: 0,
            known: Matrix4::zeros(),
            slope: Vector4::zeros(),
            scores: Vec::new(),
            fitted: Vec::new(),
            start: [f64::NAN; 2],
            pushes: 0.0,
        };
        for stretch in self.stretches {
            let rows = stretch.len().saturating_sub(self.lag);
            let segments = rows.div_ceil(self.horizon).max(1);
            for segment in 0..segments {
                let [from, to] = [segment, segment + 1].map(|it| self.lag + it * rows / segments);
                self.add(stretch, from..to, at, &mut motion, &mut pass);
            }
        }
        let finite = pass.cost.is_finite() && pass.known.iter().all(|it| it.is_finite());
        finite.then_some(pass)
    }

    /// Adds a segment, its own numbers fitted.
    fn add(
        &self,
        stretch: &Stretch,
        rows: std::ops::Range<usize>,
        at: &Coefficients,
        motion: &mut Motion,
        pass: &mut Pass,
    ) {
        let weights = weights(&stretch.positions[rows.clone()]);
        let mut state = Motion::start();
        let mut lines = Vec::with_capacity(rows.len());
        for row in rows.clone() {
            if row > rows.start {
                let period = stretch.times[row] - stretch.times[row - 1];
                motion.advance(&mut state, period, stretch.forces[row - 1 - self.lag]);
            }
            lines.push(state);
        }
        let own = if self.pushed { 3 } else { 2 };
        if lines.len() <= own {
            pass.fitted.extend_from_slice(&stretch.positions[rows]);
            return;
        }
        let shared = |line: &State, part: usize| {
            let bias = if self.pushed { 0.0 } else { at[BIAS] };
            bias * line[(part, 2)] + at[MOBILITY] * line[(part, 3)]
        };
        let measured = &stretch.positions[rows.clone()];
        let left: Vec<f64> =
            lines.iter().zip(measured).map(|(line, x)| x - shared(line, 0)).collect();
        let base = Base::of(&lines, own, &weights);
        let numbers = base.numbers(&left, &weights);
        let mut slopes: [Vec<f64>; 4] = Default::default();
        for line in &lines {
            let bent = |part: usize| {
                (0..own).map(|it| numbers[it] * line[(part, it)]).sum::<f64>() + shared(line, part)
            };
            slopes[DECAY].push(bent(2));
            slopes[SPRING].push(bent(4));
            slopes[BIAS].push(if self.pushed { 0.0 } else { line[(0, 2)] });
            slopes[MOBILITY].push(line[(0, 3)]);
        }
        let errors = base.rest(&left, &weights);
        let slopes = slopes.map(|slope| base.rest(&slope, &weights));
        for (row, error) in errors.iter().enumerate() {
            let slope = Vector4::from_fn(|it, _| slopes[it][row]);
            pass.known += slope * slope.transpose();
            pass.slope += slope * *error;
            pass.cost += error * error;
            pass.weight += weights[row] * weights[row];
            pass.scores.push(Score { slope, error: *error });
            let unweighted = error / weights[row];
            pass.fitted.push(measured[row] - unweighted);
        }
        if pass.start[0].is_nan() {
            pass.start = [numbers[0], numbers[1]];
        }
        pass.own += own;
        pass.pushes += numbers[2] * lines.len() as f64;
    }
}

/// The coefficients with neither decay nor spring below 0, as no hand and no device has.
fn passive(mut at: Coefficients) -> Coefficients {
    (at[DECAY], at[SPRING]) = (at[DECAY].max(0.0), at[SPRING].max(0.0));
    at
}

fn solve(pass: &Pass, free: [bool; 4]) -> Option<Vector4<f64>> {
    let step = inverse(&pass.known, free)? * pass.slope;
    step.iter().all(|it| it.is_finite()).then_some(step)
}
