//! Reference of the tick contract with every effect, tick by tick, in f64.

use crate::effects::environment::dot;
use crate::effects::plant::{Plant, State};
use crate::effects::random::{self, Source};
use crate::effects::scene::{Axes, Kind, Motion, Scene};
use crate::effects::velocity::velocity;

/// Row of the CSV, in the order of `Scene::columns`.
pub(crate) type Row = Vec<f64>;

/// First column of the further axes; each axis has `PER_AXIS` columns.
const FURTHER: usize = 12;
const PER_AXIS: usize = 7;

/// Largest number of ticks that a filter looks back.
const LONGEST_WINDOW: usize = 256;

/// Column of x, x_measured, v and so on, on each axis.
pub(crate) fn column(axis: usize, index: usize) -> usize {
    if axis == 0 { 1 + index } else { FURTHER + (axis - 1) * PER_AXIS + index }
}

pub(crate) struct Loop<'a> {
    scene: &'a Scene,
    pub(crate) state: [State; 3],
    measured: Vec<Axes>,
    velocities: Vec<Axes>,
    outputs: Vec<Axes>,
    efforts: Vec<Axes>,
    f_env: Axes,
    seen_by_environment: Option<Axes>,
    answers: u64,
    observer: f64,
    burnt: f64,
}

impl<'a> Loop<'a> {
    pub(crate) fn new(scene: &'a Scene) -> Self {
        let start = |axis: usize| {
            let (x, v) = (scene.position[axis], scene.velocity[axis]);
            [x, v, x, v]
        };
        Self {
            scene,
            state: [0, 1, 2].map(start),
            measured: vec![],
            velocities: vec![],
            outputs: vec![],
            efforts: vec![],
            f_env: [0.0; 3],
            seen_by_environment: None,
            answers: 0,
            observer: 0.0,
            burnt: 0.0,
        }
    }

    /// Row `n`, from the plant's present state and the rows before.
    pub(crate) fn tick(&mut self, n: usize) -> Row {
        let scene = self.scene;
        let x = self.state.map(|state| state[0]);
        let measured = self.measure(n, x);
        self.measured.push(measured);
        let v = self.velocity();
        if n.is_multiple_of(scene.hold) {
            self.ask(n, measured, v);
        }
        let (observer, alpha, shortfall) = self.stabilize(n, measured, v);
        let f_ctl = v.map(|v| alpha * v);
        let limit = scene.saturation.unwrap_or(f64::INFINITY);
        let f_out = [0, 1, 2].map(|axis| (self.f_env[axis] + f_ctl[axis]).clamp(-limit, limit));
        self.outputs.push(f_out);
        let f_act = n.checked_sub(scene.delay).map_or([0.0; 3], |sent| self.outputs[sent]);
        self.velocities.push(v);
        self.efforts.push(f_act);

        let t = n as f64 / scene.servo_rate;
        let signals = [x, measured, v, self.f_env, f_ctl, f_out, f_act];
        let mut row = vec![t];
        row.extend(signals.map(|signal| signal[0]));
        row.extend([observer, alpha, shortfall, 1.0]);
        for axis in 1..scene.dimensions {
            row.extend(signals.map(|signal| signal[axis]));
        }
        if scene.link.is_some() {
            let operators = self.state[..scene.dimensions].iter();
            row.extend(operators.flat_map(|state| [state[2], state[3]]));
        }
        row
    }

    /// Replaces the observed energy, as if it had been rounded otherwise.
    pub(crate) fn disturb(&mut self, observer: f64) {
        self.observer = observer;
    }

    /// Takes from `row`, row `n` of the command, all that later rows follow from.
    pub(crate) fn believe(&mut self, n: usize, row: &[f64]) {
        let scene = self.scene;
        for axis in 0..scene.dimensions {
            let at = |index: usize| row[column(axis, index)];
            self.state[axis][0] = at(0);
            self.measured[n][axis] = at(1);
            self.velocities[n][axis] = at(2);
            self.f_env[axis] = at(3);
            self.outputs[n][axis] = at(5);
            self.efforts[n][axis] = at(6);
            if scene.exact {
                self.state[axis][1] = at(2);
            }
            if scene.link.is_some() {
                let first = FURTHER + (scene.dimensions - 1) * PER_AXIS + 2 * axis;
                self.state[axis][2..].copy_from_slice(&row[first..first + 2]);
            }
        }
        if n.is_multiple_of(scene.hold) {
            self.seen_by_environment = Some(self.velocities[n]);
        }
        self.observer = row[8];
        self.burnt = row[9] * dot(self.velocities[n], self.velocities[n]) * scene.period();
    }

    /// Moves the plant from tick `n` to the next.
    pub(crate) fn advance(&mut self, n: usize) {
        let scene = self.scene;
        let mut interval = scene.period();
        if let Some((deviation, seed)) = scene.jitter {
            interval += deviation * random::normal(seed, n as u64, Source::Jitter, 0);
        }
        let grip = scene.grip.iter().flatten().rfind(|row| scene.tick_of(row[0]) <= n);
        let own = [scene.operator.stiffness, scene.operator.damping];
        let grip = grip.map_or(own, |row| [row[1], row[2]]);
        for axis in 0..scene.dimensions {
            let first = axis == 0;
            let rest = if first { scene.rest_at(n) } else { scene.operator.rest[axis] };
            let push = if first { scene.push_at(n) } else { 0.0 };
            let plant = Plant::new(scene, grip, rest, push - self.efforts[n][axis]);
            self.state[axis] = plant.advance(self.state[axis], interval.max(0.0));
        }
    }

    fn measure(&self, n: usize, x: Axes) -> Axes {
        let scene = self.scene;
        std::array::from_fn(|axis| {
            let noise = scene.noise.map_or(0.0, |(deviation, seed)| {
                deviation * random::normal(seed, n as u64, Source::Noise, axis as u32)
            });
            let noisy = if axis < scene.dimensions { x[axis] + noise } else { 0.0 };
            match scene.encoder {
                None => noisy,
                Some(resolution) => (noisy / resolution).round() * resolution,
            }
        })
    }

    fn velocity(&self) -> Axes {
        if self.scene.exact {
            return self.state.map(|state| state[1]);
        }
        std::array::from_fn(|axis| {
            let first = self.measured.len().saturating_sub(LONGEST_WINDOW + 1);
            let x: Vec<f64> = self.measured[first..].iter().map(|x| x[axis]).collect();
            let before = self.velocities.last().map_or(0.0, |v| v[axis]);
            velocity(self.scene, &x, before)
        })
    }

    fn ask(&mut self, n: usize, x: Axes, v: Axes) {
        let scene = self.scene;
        let interval = scene.hold as f64 * scene.period();
        let last = self.seen_by_environment.replace(v).unwrap_or(v);
        let acceleration = (v[0] - last[0]) / interval;
        let t = n as f64 / scene.servo_rate;
        let answer = scene.environment.effort(t, x, v, acceleration);
        let call = self.answers;
        self.answers += 1;
        match scene.dropout {
            Some(it) if random::lost(it.seed, call, it.probability) => {
                if it.zero {
                    self.f_env = [0.0; 3];
                }
            }
            _ => self.f_env = answer,
        }
    }

    /// Observed energy, injected damping and shortfall.
    fn stabilize(&mut self, n: usize, x: Axes, v: Axes) -> (f64, f64, f64) {
        let scene = self.scene;
        let Some(stabilizer) = scene.stabilizer else {
            return (0.0, 0.0, 0.0);
        };
        let (period, t) = (scene.period(), n as f64 / scene.servo_rate);
        let work = if stabilizer.sampled {
            dot(self.f_env, v) * period + self.burnt
        } else if n == 0 {
            0.0
        } else {
            let moved = std::array::from_fn(|axis| x[axis] - self.measured[n - 1][axis]);
            dot(self.efforts[n - 1], moved)
        };
        let credit = match stabilizer.kind {
            Kind::MassSpringDamper => scene.environment.credit(t, x, v, period),
            Kind::DeviceDamping => scene.device[1] * dot(v, v) * period,
            Kind::Popc | Kind::Spring => 0.0,
        };
        let sum = self.observer + work + credit;
        let weight = dot(v, v) * period;
        let mass = scene.device[0] + if scene.link.is_some() { 0.0 } else { scene.operator.mass };
        let tiny = if scene.single { f64::from(f32::MIN_POSITIVE) } else { f64::MIN_POSITIVE };
        let cap = stabilizer.cap * mass / period;
        let alpha = if sum < 0.0 && weight > tiny { (-sum / weight).min(cap) } else { 0.0 };
        let shortfall = if alpha > 0.0 && alpha < cap { 0.0 } else { -sum - alpha * weight };
        (self.observer, self.burnt) = (sum, alpha * weight);
        (sum, alpha, shortfall.max(0.0))
    }
}

impl Scene {
    /// Rest of the operator's spring on the first axis from tick `n` to the next.
    fn rest_at(&self, n: usize) -> f64 {
        let (rest, t) = (self.operator.rest[0], n as f64 / self.servo_rate);
        match &self.motion {
            None => rest,
            Some(Motion::Step { at, to }) => {
                if n < self.tick_of(*at) {
                    rest
                } else {
                    *to
                }
            }
            Some(Motion::Ramp { at, to, rate }) => {
                let gone = if n < self.tick_of(*at) { 0.0 } else { rate * (t - at).max(0.0) };
                if gone >= (to - rest).abs() { *to } else { rest + gone * (to - rest).signum() }
            }
            Some(Motion::Sine { amplitude, frequency }) => {
                rest + amplitude * (std::f64::consts::TAU * (frequency * t).fract()).sin()
            }
            Some(Motion::File { rows }) => {
                let after = rows.iter().position(|row| row.0 > t);
                match after {
                    None => rows[rows.len() - 1].1,
                    Some(0) => rows[0].1,
                    Some(next) => {
                        let ((t0, rest0), (t1, rest1)) = (rows[next - 1], rows[next]);
                        (rest0 * (t1 - t) + rest1 * (t - t0)) / (t1 - t0)
                    }
                }
            }
        }
    }

    /// Push on the device on the first axis from tick `n` to the next.
    fn push_at(&self, n: usize) -> f64 {
        let pulse = self.pulse.map_or(0.0, |it| {
            let ticks = self.tick_of(it.start)..self.tick_of(it.start + it.duration);
            if ticks.contains(&n) { it.force } else { 0.0 }
        });
        self.load.unwrap_or(0.0) + pulse
    }
}
