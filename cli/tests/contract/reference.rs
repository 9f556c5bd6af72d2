//! Reference of the contract: one servo tick after the other, in the contract's order.

use crate::contract::motion::Motion;
use crate::contract::row::Row;
use crate::contract::scene::{Kind, Scene, Velocity, Work};

/// Disturbance of a second run of the same scene, which shows how much of a trace rounding may decide.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Disturbance {
    /// Added to the start, in metres.
    pub(crate) start: f64,
    /// Largest relative error, of either sign, of the state and of the observed energy at each tick.
    pub(crate) rounding: f64,
    pub(crate) seed: u64,
}

impl Disturbance {
    const NONE: Self = Self { start: 0.0, rounding: 0.0, seed: 0 };

    fn factor(&mut self) -> f64 {
        self.seed = self
            .seed
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        let unit = (self.seed >> 11) as f64 / (1_u64 << 53) as f64;
        1.0 + self.rounding * (2.0 * unit - 1.0)
    }
}

pub(crate) fn run(scene: &Scene) -> Vec<Row> {
    run_disturbed(scene, Disturbance::NONE)
}

pub(crate) fn run_disturbed(scene: &Scene, mut disturbance: Disturbance) -> Vec<Row> {
    let period = 1.0 / scene.servo_rate;
    let damping = scene.operator.damping + scene.device.damping;
    let map = Motion::new(scene.mass(), damping, scene.operator.stiffness, period);
    let mut x = scene.initial.position + disturbance.start;
    let mut speed = scene.initial.velocity;
    let mut rows: Vec<Row> = Vec::with_capacity(scene.ticks() + 1);

    for n in 0..=scene.ticks() {
        let last = rows.last().copied();
        let x_measured = scene.encoder.map_or(x, |step| (x / step).round() * step);
        let dx = last.map_or(0.0, |last| x_measured - last.x_measured);
        let v = match scene.velocity {
            Velocity::Exact => speed,
            Velocity::BackwardDifference => dx / period,
        };
        let f_env = match last {
            Some(last) if !n.is_multiple_of(scene.hold) => last.f_env,
            _ => wall(scene, x_measured, v),
        };
        let (observer, alpha, shortfall) =
            stabilize(scene, last, x_measured, dx, v, f_env, &mut disturbance);
        let f_ctl = alpha * v;
        let f_cmd = f_env + f_ctl;
        let f_out = scene.saturation.map_or(f_cmd, |force| f_cmd.clamp(-force, force));
        let f_act = match scene.delay {
            0 => f_out,
            delay if n < delay => 0.0,
            delay => rows[n - delay].f_out,
        };
        let row = Row {
            t: n as f64 / scene.servo_rate,
            x,
            x_measured,
            v,
            f_env,
            f_ctl,
            f_out,
            f_act,
            observer,
            alpha,
            shortfall,
            accepted: 1.0,
        };
        let largest = scene.scalar.largest();
        if !row.columns().iter().all(|value| value.abs() <= largest) {
            break;
        }
        rows.push(row);

        let y = x - scene.operator.rest;
        x += map.position_y * y + map.position_v * speed - map.position_f * f_act;
        speed += map.velocity_y * y + map.velocity_v * speed - map.velocity_f * f_act;
        if disturbance.rounding > 0.0 {
            x = scene.scalar.round(x * disturbance.factor());
            speed = scene.scalar.round(speed * disturbance.factor());
        }
    }
    rows
}

fn wall(scene: &Scene, x_measured: f64, v: f64) -> f64 {
    let penetration = x_measured - scene.wall.position;
    if penetration > 0.0 {
        (scene.wall.stiffness * penetration + scene.wall.damping * v).max(0.0)
    } else {
        0.0
    }
}

/// Observed energy, injected damping and shortfall.
fn stabilize(
    scene: &Scene,
    last: Option<Row>,
    x_measured: f64,
    dx: f64,
    v: f64,
    f_env: f64,
    disturbance: &mut Disturbance,
) -> (f64, f64, f64) {
    let Some(stabilizer) = scene.stabilizer else {
        return (0.0, 0.0, 0.0);
    };
    let period = 1.0 / scene.servo_rate;
    let work = match stabilizer.work {
        Work::Held => last.map_or(0.0, |last| last.f_act * dx),
        Work::Sampled => {
            (f_env * v + last.map_or(0.0, |last| last.alpha * last.v * last.v)) * period
        }
    };
    let credit = match stabilizer.kind {
        Kind::MassSpringDamper if x_measured > scene.wall.position => {
            scene.wall.damping * v * v * period
        }
        Kind::DeviceDamping => scene.device.damping * v * v * period,
        _ => 0.0,
    };
    let before = last.map_or(0.0, |last| last.observer) * disturbance.factor();
    let sum = before + work * disturbance.factor() + credit;

    let weight = v * v * period;
    let cap = stabilizer.cap * scene.mass() / period;
    if sum >= 0.0 {
        (sum, 0.0, 0.0)
    } else if weight > scene.scalar.tiny() {
        let needed = -sum / weight;
        let alpha = needed.min(cap).min(scene.scalar.largest());
        let shortfall = if needed <= cap.min(scene.scalar.largest()) {
            0.0
        } else {
            (-sum - alpha * weight).max(0.0)
        };
        (sum, alpha, shortfall)
    } else {
        (sum, 0.0, -sum)
    }
}
