//! Second form of the contract, with misreadings to choose from: it tests whether the comparisons find them.
//!
//! The plant is integrated by the fourth-order Runge-Kutta method in steps far below the period; the port's energy is
//! an integral beside it, the delay a queue and the hold a countdown.

use std::collections::VecDeque;

use crate::contract::fault::Fault;
use crate::contract::row::Row;
use crate::contract::scene::{Kind, Scene, Velocity, Work};

/// Runge-Kutta steps per unit of z, the plant's fastest rate times the period. The answer to a force is off by z^3 / 60
/// over the fourth power of the steps, the state by z^4 / 120: both stay near rounding.
const FINENESS: f64 = 1500.0;

pub(crate) fn run(scene: &Scene, fault: Option<Fault>) -> Vec<Row> {
    let mut machine = Loop::new(scene, fault);
    let mut rows = Vec::new();
    for n in 0..=scene.ticks() {
        let row = machine.tick(n);
        if !row.columns().iter().all(|value| value.is_finite()) {
            break;
        }
        rows.push(row);
        machine.integrate(row.f_act);
    }
    rows
}

struct Loop<'a> {
    scene: &'a Scene,
    fault: Option<Fault>,
    period: f64,
    /// Position, velocity, and the work done on the environment since the last tick.
    state: [f64; 3],
    measured: Option<f64>,
    until_environment: usize,
    f_env: f64,
    f_act: f64,
    pipeline: VecDeque<f64>,
    velocity: f64,
    alpha: f64,
    observer: f64,
}

impl<'a> Loop<'a> {
    fn new(scene: &'a Scene, fault: Option<Fault>) -> Self {
        let delay = match fault {
            Some(Fault::DelayForgotten) => 0,
            Some(Fault::DelayTooLong) => scene.delay + 1,
            _ => scene.delay,
        };
        let late = fault == Some(Fault::HoldLate) && scene.hold > 1;
        Self {
            scene,
            fault,
            period: scene.servo_rate.recip(),
            state: [scene.initial.position, scene.initial.velocity, 0.0],
            measured: None,
            until_environment: usize::from(late),
            f_env: 0.0,
            f_act: 0.0,
            pipeline: VecDeque::from(vec![0.0; delay]),
            velocity: 0.0,
            alpha: 0.0,
            observer: 0.0,
        }
    }

    fn is(&self, fault: Fault) -> bool {
        self.fault == Some(fault)
    }

    fn tick(&mut self, n: usize) -> Row {
        let [x, speed, _] = self.state;
        let x_measured = self.encode(x);
        let dx = self.measured.map_or(0.0, |measured| x_measured - measured);
        let exact = self.scene.velocity == Velocity::Exact || self.is(Fault::VelocityOfThePlant);
        let fresh = if exact { speed } else { dx * self.scene.servo_rate };
        let v = if self.is(Fault::VelocityOneTickOld) { self.velocity } else { fresh };
        let environment_ticks = self.until_environment == 0 || self.is(Fault::HoldForgotten);
        if environment_ticks {
            self.f_env = self.wall(x_measured, v);
            self.until_environment = self.scene.hold;
        }
        self.until_environment -= 1;

        self.account(x_measured, dx, v, environment_ticks);
        let observer = self.observer;
        let (alpha, shortfall) = self.damper(observer, v);
        let f_ctl = alpha * v;
        let f_out = self.clip(f_ctl);
        self.pipeline.push_back(f_out);
        let f_act = self.pipeline.pop_front().unwrap_or(f_out);
        self.f_act = if self.is(Fault::WorkOfCommand) { self.f_env + f_ctl } else { f_act };
        (self.measured, self.velocity, self.alpha) = (Some(x_measured), fresh, alpha);

        let served = alpha * v * v * self.period;
        let corrected = if self.is(Fault::ObserverAfterCorrection) { served } else { 0.0 };
        if self.is(Fault::DebtForgotten) && alpha > 0.0 {
            self.observer = 0.0;
        }
        let late = usize::from(self.is(Fault::TimeOneTickLate));
        Row {
            t: (n + late) as f64 / self.scene.servo_rate,
            x,
            x_measured,
            v,
            f_env: self.f_env,
            f_ctl,
            f_out,
            f_act,
            observer: observer + corrected,
            alpha,
            shortfall,
            accepted: 1.0,
        }
    }

    fn encode(&self, x: f64) -> f64 {
        let Some(resolution) = self.scene.encoder else {
            return x;
        };
        let counts = x / resolution;
        let whole = if self.is(Fault::EncoderRoundsDown) {
            counts.floor()
        } else if self.is(Fault::EncoderHalvesToEven) {
            counts.round_ties_even()
        } else {
            (counts.abs() + 0.5).floor().copysign(counts)
        };
        whole * resolution
    }

    fn wall(&self, x_measured: f64, v: f64) -> f64 {
        let wall = &self.scene.wall;
        let forgotten = self.is(Fault::WallPositionForgotten);
        let surface = if forgotten { 0.0 } else { wall.position };
        let force = wall.stiffness * (x_measured - surface) + wall.damping * v;
        if x_measured <= surface || (force < 0.0 && !self.is(Fault::WallPulls)) {
            0.0
        } else {
            force
        }
    }

    fn account(&mut self, x_measured: f64, dx: f64, v: f64, environment_ticks: bool) {
        let (scene, period) = (self.scene, self.period);
        let Some(stabilizer) = scene.stabilizer else {
            return;
        };
        self.observer += match stabilizer.work {
            Work::Held if self.measured.is_none() => 0.0,
            Work::Held if self.is(Fault::WorkOfNewForce) => self.f_env * dx,
            Work::Held if self.is(Fault::WorkNegative) => -self.state[2],
            Work::Held if scene.encoder.is_some() || self.is(Fault::WorkOfCommand) => {
                self.f_act * dx
            }
            Work::Held => self.state[2],
            Work::Sampled => {
                let period = if self.is(Fault::SampledWithoutPeriod) { 1.0 } else { period };
                let then = if self.is(Fault::SampledWithNewDamper) { v } else { self.velocity };
                let damper = if self.is(Fault::SampledWithoutDamper) { 0.0 } else { self.alpha };
                period * self.f_env * v + period * damper * then * then
            }
        };

        let contact = x_measured > scene.wall.position || self.is(Fault::CreditInFreeMotion);
        let watched = environment_ticks || !self.is(Fault::CreditOnlyAtEnvironmentTicks);
        let pressed = self.f_env > 0.0 || !self.is(Fault::CreditOnlyUnderForce);
        let damping = match stabilizer.kind {
            Kind::MassSpringDamper if contact && watched && pressed => scene.wall.damping,
            Kind::DeviceDamping if self.is(Fault::CreditOfAllDamping) => {
                scene.device.damping + scene.operator.damping
            }
            Kind::DeviceDamping => scene.device.damping,
            _ => return,
        };
        let sign = if self.is(Fault::CreditNegative) { -1.0 } else { 1.0 };
        let period = if self.is(Fault::CreditWithoutPeriod) { 1.0 } else { period };
        self.observer += sign * damping * v.powi(2) * period;
    }

    fn damper(&self, observer: f64, v: f64) -> (f64, f64) {
        let Some(stabilizer) = self.scene.stabilizer else {
            return (0.0, 0.0);
        };
        if observer >= 0.0 {
            return (0.0, 0.0);
        }
        let debt = -observer;
        let period = if self.is(Fault::DamperWithoutPeriod) { 1.0 } else { self.period };
        let dissipated = v.powi(2) * period;
        let mass = match self.fault {
            Some(Fault::CapWithoutMass) => 1.0,
            Some(Fault::CapOfDeviceMass) => self.scene.device.mass,
            Some(Fault::CapForgotten) => f64::INFINITY,
            _ => self.scene.mass(),
        };
        let cap = stabilizer.cap * mass * self.scene.servo_rate;
        let cap = if cap.is_nan() { 0.0 } else { cap };
        let alpha = if dissipated > f64::MIN_POSITIVE {
            (debt / dissipated).min(cap).min(f64::MAX)
        } else {
            0.0
        };
        let whole = dissipated > f64::MIN_POSITIVE && debt / dissipated <= cap;
        let left = if whole { 0.0 } else { debt - alpha * dissipated };
        let left = if self.is(Fault::ShortfallForgotten) { 0.0 } else { left.max(0.0) };
        let alpha = if self.is(Fault::DamperNegative) { -alpha } else { alpha };
        (alpha, left)
    }

    fn clip(&self, f_ctl: f64) -> f64 {
        let Some(force) = self.scene.saturation else {
            return self.f_env + f_ctl;
        };
        if self.is(Fault::SaturationBeforeController) {
            return self.f_env.clamp(-force, force) + f_ctl;
        }
        let below = if self.is(Fault::SaturationOneSided) { f64::NEG_INFINITY } else { -force };
        (self.f_env + f_ctl).max(below).min(force)
    }

    fn integrate(&mut self, f_act: f64) {
        let (operator, device) = (&self.scene.operator, &self.scene.device);
        let damping = if self.is(Fault::OperatorDampingForgotten) { 0.0 } else { operator.damping };
        let mass = if self.is(Fault::DeviceMassForgotten) { 0.0 } else { device.mass };
        let rest = if self.is(Fault::RestForgotten) { 0.0 } else { operator.rest };
        let force = if self.is(Fault::ForcePushes) { -f_act } else { f_act };
        let mass = (operator.mass + mass).max(0.01);
        let damping = damping + device.damping;
        let rate = (damping / mass).max((operator.stiffness / mass).sqrt());
        let reach = rate * self.period;
        let steps = (reach.max(reach.powf(0.75)) * FINENESS).ceil().max(1.0);

        let h = self.period / steps;
        let slope = |[x, v, _]: [f64; 3]| {
            let pull = damping * v + operator.stiffness * (x - rest);
            [v, -(force + pull) / mass, f_act * v]
        };
        let moved = |s: [f64; 3], by: f64, k: [f64; 3]| {
            [s[0] + by * k[0], s[1] + by * k[1], s[2] + by * k[2]]
        };
        self.state[2] = 0.0;
        // The gain is summed apart from the start, so that a thousand steps round like one.
        let start = self.state;
        let mut gained = [0.0; 3];
        for _ in 0..steps as usize {
            let s = moved(start, 1.0, gained);
            let k1 = slope(s);
            let k2 = slope(moved(s, h / 2.0, k1));
            let k3 = slope(moved(s, h / 2.0, k2));
            let k4 = slope(moved(s, h, k3));
            for (i, gained) in gained.iter_mut().enumerate() {
                *gained += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
            }
        }
        self.state = moved(start, 1.0, gained);
    }
}
