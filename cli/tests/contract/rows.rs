//! Check that each row of a trace follows from the rows before it, however long and however chaotic the trace is.
//!
//! An equation may be off by a small part of its largest term, plus a few units in the last place of the operands of
//! its differences: a position is known no better than it is stored, and where dx, an increment or a penetration is
//! small beside the positions, its own magnitude says nothing about its error. Below the normal numbers the last place
//! is an absolute error.

use crate::contract::motion::Motion;
use crate::contract::row::Row;
use crate::contract::scene::{Kind, Scalar, Scene, Stabilizer, Velocity, Work};

/// Units of the state, for the step of the plant: its sums of several products, each rounded, and the map's rounding.
const STEP_UNITS: f64 = 32.0;
/// Units of an operand, for one difference.
const DIFFERENCE_UNITS: f64 = 4.0;

type Checked = Result<(), String>;

pub(crate) fn follow(scene: &Scene, rows: &[Row]) -> Checked {
    let scene = scene.in_scalar();
    let damping = scene.operator.damping + scene.device.damping;
    let period = 1.0 / scene.servo_rate;
    let check = Check {
        motion: Motion::new(scene.mass(), damping, scene.operator.stiffness, period),
        period,
        relative: match scene.scalar {
            Scalar::F64 => 1e-12,
            Scalar::F32 => 1e-5,
        },
        rows,
        scene,
    };
    for n in 0..rows.len() {
        check.time(n)?;
        check.position(n)?;
        check.measured(n)?;
        check.velocity(n)?;
        check.wall(n)?;
        check.stabilizer(n)?;
        check.output(n)?;
    }
    check.end()
}

struct Check<'a> {
    scene: Scene,
    rows: &'a [Row],
    motion: Motion,
    period: f64,
    relative: f64,
}

impl Check<'_> {
    fn units(&self, units: f64, operands: &[f64]) -> f64 {
        units * self.scene.scalar.epsilon() * largest(operands)
    }

    fn last_place(&self) -> f64 {
        self.scene.scalar.tiny() * self.scene.scalar.epsilon()
    }

    /// Compares within the allowed error. A term that the scalar cannot hold is passed: [`Check::end`] judges it.
    fn near(
        &self,
        n: usize,
        what: &str,
        got: f64,
        want: f64,
        terms: &[f64],
        slack: f64,
    ) -> Checked {
        let scale = largest(terms);
        if !want.is_finite() || scale > self.scene.scalar.largest() {
            return Ok(());
        }
        let allowed = self.relative * scale + slack + self.scene.scalar.tiny();
        if (got - want).abs() <= allowed {
            return Ok(());
        }
        Err(format!("row {n}: {what} is {got:e}, not {want:e} +- {allowed:e}"))
    }

    fn exactly(&self, n: usize, what: &str, got: f64, want: f64) -> Checked {
        if got == want {
            return Ok(());
        }
        Err(format!("row {n}: {what} is {got:e}, not exactly {want:e}"))
    }

    fn time(&self, n: usize) -> Checked {
        let want = n as f64 / self.scene.servo_rate;
        let slack = self.units(DIFFERENCE_UNITS, &[want]);
        self.near(n, "t", self.rows[n].t, want, &[], slack)
    }

    fn position(&self, n: usize) -> Checked {
        let (map, rest) = (&self.motion, self.scene.operator.rest);
        let x = self.rows[n].x;
        if n == 0 {
            return self.exactly(n, "x", x, self.scene.initial.position);
        }
        let last = &self.rows[n - 1];
        let slack = self.units(STEP_UNITS, &[x, last.x, rest]);
        let step = |terms: &[f64]| {
            let want = terms.iter().sum();
            self.near(n, "dx", x - last.x, want, terms, slack)
        };
        let speed = match (n, self.scene.velocity) {
            (1, _) => Some(self.scene.initial.velocity),
            (_, Velocity::Exact) => Some(last.v),
            _ => None,
        };
        if let Some(speed) = speed {
            step(&[
                map.position_y * (last.x - rest),
                map.position_v * speed,
                -map.position_f * last.f_act,
            ])?;
        }
        if n == 1 {
            return Ok(());
        }
        let before = &self.rows[n - 2];
        step(&[
            map.decay * (last.x - before.x),
            -map.pull * (last.x - rest),
            -map.now * last.f_act,
            -map.before * before.f_act,
        ])
    }

    fn measured(&self, n: usize) -> Checked {
        let Row { x, x_measured, .. } = self.rows[n];
        let Some(resolution) = self.scene.encoder else {
            return self.exactly(n, "x_measured", x_measured, x);
        };
        let whole = (x_measured / resolution).round() * resolution;
        // Division by a power of two does not round, so even a tie is determined.
        if resolution.log2().fract() == 0.0 {
            let want = (x / resolution).round() * resolution;
            return self.exactly(n, "x_measured", x_measured, want);
        }
        let slack = self.units(DIFFERENCE_UNITS, &[x, x_measured]);
        self.near(n, "x_measured", x_measured, whole, &[], slack)?;
        let off = (x_measured - x).abs() - resolution / 2.0;
        self.near(n, "|x_measured - x|", off.max(0.0), 0.0, &[], slack)
    }

    fn velocity(&self, n: usize) -> Checked {
        let row = &self.rows[n];
        let exact = self.scene.velocity == Velocity::Exact;
        if n == 0 {
            let want = if exact { self.scene.initial.velocity } else { 0.0 };
            return self.exactly(n, "v", row.v, want);
        }
        let last = &self.rows[n - 1];
        if exact {
            let (map, rest) = (&self.motion, self.scene.operator.rest);
            let terms = [
                map.velocity_y * (last.x - rest),
                map.velocity_v * last.v,
                -map.velocity_f * last.f_act,
            ];
            let state = [row.v, last.v, map.velocity_y * last.x, map.velocity_y * rest];
            let slack = self.units(STEP_UNITS, &state);
            return self.near(n, "dv", row.v - last.v, terms.iter().sum(), &terms, slack);
        }
        let want = (row.x_measured - last.x_measured) / self.period;
        let slack = self.units(DIFFERENCE_UNITS, &[row.x_measured, last.x_measured]) / self.period;
        self.near(n, "v", row.v, want, &[want], slack)
    }

    fn wall(&self, n: usize) -> Checked {
        let row = &self.rows[n];
        if !n.is_multiple_of(self.scene.hold) {
            return self.exactly(n, "f_env", row.f_env, self.rows[n - 1].f_env);
        }
        let wall = &self.scene.wall;
        let penetration = row.x_measured - wall.position;
        if penetration <= 0.0 {
            return self.exactly(n, "f_env", row.f_env, 0.0);
        }
        let terms = [wall.stiffness * penetration, wall.damping * row.v];
        let want = f64::max(0.0, terms[0] + terms[1]);
        let slack = wall.stiffness * self.units(DIFFERENCE_UNITS, &[row.x_measured, wall.position]);
        self.near(n, "f_env", row.f_env, want, &terms, slack)
    }

    fn stabilizer(&self, n: usize) -> Checked {
        let row = &self.rows[n];
        self.exactly(n, "accepted", row.accepted, 1.0)?;
        let Some(stabilizer) = self.scene.stabilizer else {
            self.exactly(n, "observer", row.observer, 0.0)?;
            self.exactly(n, "alpha", row.alpha, 0.0)?;
            self.exactly(n, "f_ctl", row.f_ctl, 0.0)?;
            return self.exactly(n, "shortfall", row.shortfall, 0.0);
        };
        self.sum(n, &stabilizer)?;
        let f_ctl = row.alpha * row.v;
        self.near(n, "f_ctl", row.f_ctl, f_ctl, &[f_ctl], self.last_place() * row.v.abs())?;
        self.controller(n, &stabilizer)
    }

    fn sum(&self, n: usize, stabilizer: &Stabilizer) -> Checked {
        let row = &self.rows[n];
        let last = n.checked_sub(1).map(|last| &self.rows[last]);
        let credit = match stabilizer.kind {
            Kind::MassSpringDamper if row.x_measured > self.scene.wall.position => {
                self.scene.wall.damping
            }
            Kind::DeviceDamping => self.scene.device.damping,
            _ => 0.0,
        };
        let mut terms = vec![credit * row.v * row.v * self.period];
        let mut slack = 0.0;
        if stabilizer.work == Work::Sampled {
            terms.push(row.f_env * row.v * self.period);
        }
        if let Some(last) = last {
            terms.push(last.observer);
            match stabilizer.work {
                Work::Sampled => {
                    let weight = last.v * last.v * self.period;
                    terms.push(last.alpha * weight);
                    slack = self.last_place() * weight;
                }
                Work::Held => {
                    let dx = row.x_measured - last.x_measured;
                    terms.push(last.f_act * dx);
                    let operands = [row.x_measured, last.x_measured];
                    slack = last.f_act.abs() * self.units(DIFFERENCE_UNITS, &operands)
                        + self.last_place() * dx.abs();
                }
            }
        }
        self.near(n, "observer", row.observer, terms.iter().sum(), &terms, slack)
    }

    fn controller(&self, n: usize, stabilizer: &Stabilizer) -> Checked {
        let row = &self.rows[n];
        let weight = row.v * row.v * self.period;
        let (tiny, largest) = (self.scene.scalar.tiny(), self.scene.scalar.largest());
        if (weight / tiny - 1.0).abs() < 1e-4 || row.v * row.v > largest {
            return Ok(());
        }
        let debt = (-row.observer).max(0.0);
        if row.observer > 0.0 || weight < tiny {
            self.exactly(n, "alpha", row.alpha, 0.0)?;
            return self.near(n, "shortfall", row.shortfall, debt, &[debt], 0.0);
        }
        let cap = (stabilizer.cap * self.scene.mass() / self.period).min(largest);
        let want = (debt / weight).min(cap);
        self.near(n, "alpha", row.alpha, want, &[want], self.last_place() / weight)?;
        if row.alpha < cap * (1.0 - self.relative) {
            return self.exactly(n, "shortfall", row.shortfall, 0.0);
        }
        let served = row.alpha * weight;
        let left = (debt - served).max(0.0);
        self.near(n, "shortfall", row.shortfall, left, &[debt, served], 0.0)
    }

    fn output(&self, n: usize) -> Checked {
        let row = &self.rows[n];
        let limit = self.scene.saturation.unwrap_or(f64::INFINITY);
        let want = (row.f_env + row.f_ctl).clamp(-limit, limit);
        self.near(n, "f_out", row.f_out, want, &[row.f_env, row.f_ctl], 0.0)?;
        if row.f_out.abs() > limit {
            return Err(format!("row {n}: f_out {} is beyond {limit}", row.f_out));
        }
        let sent = n.checked_sub(self.scene.delay);
        let want = sent.map_or(0.0, |sent| self.rows[sent].f_out);
        self.exactly(n, "f_act", row.f_act, want)
    }

    /// Checks that the trace is whole, or ends because the next row does not fit into the scalar.
    fn end(&self) -> Checked {
        let ticks = self.scene.ticks();
        match self.rows {
            rows if rows.len() == ticks + 1 => Ok(()),
            [.., before, last] if self.rows.len() <= ticks && self.leaves(before, last) => Ok(()),
            rows => Err(format!(
                "{} rows for {ticks} ticks, and the next would have been finite",
                rows.len()
            )),
        }
    }

    /// Whether the next row, or a product on the way to it, is beyond the range of the scalar.
    fn leaves(&self, before: &Row, last: &Row) -> bool {
        let (map, scene) = (&self.motion, &self.scene);
        let y = last.x - scene.operator.rest;
        let dx = map.decay * (last.x - before.x)
            - map.pull * y
            - map.now * last.f_act
            - map.before * before.f_act;
        let dv = map.velocity_y * y + map.velocity_v * last.v - map.velocity_f * last.f_act;
        let x = last.x + dx;
        let v = match scene.velocity {
            Velocity::Exact => last.v + dv,
            Velocity::BackwardDifference => dx / self.period,
        };
        let penetration = f64::max(0.0, x - scene.wall.position);
        let counts = scene.encoder.map_or(0.0, |resolution| x / resolution);
        let force = scene.wall.stiffness * penetration + scene.wall.damping * v.abs();
        let mut values = vec![x, v, counts, force];
        if scene.stabilizer.is_some() {
            let damping = scene.wall.damping.max(scene.device.damping).max(1.0);
            values.extend([damping * v * v, last.alpha * last.v * last.v]);
            values.extend([last.f_act * dx, last.f_env * v, force * v]);
        }
        let fits = |value: &f64| value.abs() < scene.scalar.largest() * (1.0 - 1e-4);
        !values.iter().all(fits)
    }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |largest, value| largest.max(value.abs()))
}
