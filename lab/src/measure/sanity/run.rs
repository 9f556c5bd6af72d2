//! Signs of a mistake in the run of a scene.

use lyapunov::{Mask, PortSample, Scalar};

use super::miscount::Miscount;
use super::{Oddity, Sign, scene};
use crate::files::Scene;
use crate::simulate::{Space, Tick};
use crate::text::{counted, found, given};

/// Ticks without effect, of a force on its way or of a correction, that are no chance yet.
const WAIT: u64 = 20;

/// Share of the saturation's force from which on a force counts as clipped, whatever the scalar.
const CLIPPED: f64 = 1.0 - 1e-6;

/// Watches what a run touches and what acts in it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RunSigns {
    ticks: u64,
    /// The tick on which the environment's force first is not 0, if there is one.
    first: Option<u64>,
    environment: f64,
    applied: f64,
    low: f64,
    high: f64,
    /// Ticks with damping, and those on which the saturation leaves nothing of it.
    damped: u64,
    clipped: u64,
    limit: f64,
    /// What the controller set out to dissipate, J.
    asked: f64,
    miscount: Miscount,
}

impl RunSigns {
    /// A run of `scene` without ticks.
    pub(crate) fn new(scene: &Scene) -> Self {
        let limit = scene.effects.saturation.map_or(f64::INFINITY, |it| it.force.get());
        Self {
            ticks: 0,
            first: None,
            environment: 0.0,
            applied: 0.0,
            low: f64::INFINITY,
            high: f64::NEG_INFINITY,
            damped: 0,
            clipped: 0,
            limit: CLIPPED * limit,
            asked: 0.0,
            miscount: Miscount::default(),
        }
    }

    pub(crate) fn add<V: Space>(&mut self, tick: &Tick<V>) {
        let (environment, position) =
            (largest(tick.environment.axes()), tick.truth.position.axis(0));
        if environment != 0.0 {
            self.first.get_or_insert(self.ticks);
        }
        self.environment = self.environment.max(environment);
        self.applied = self.applied.max(largest(tick.applied.axes()));
        (self.low, self.high) = (self.low.min(position), self.high.max(position));
        if Mask::all(tick.correction.accepted) {
            let forces = [tick.environment.axes(), tick.command.axes()];
            let PortSample { velocity, period, .. } = tick.measured;
            let alpha = tick.correction.alpha.lane(0);
            self.damp(alpha, velocity.axes(), period.lane(0), forces);
        }
        self.miscount.add(tick);
        self.ticks += 1;
    }

    /// Counts a damping of a motion, with the forces of the environment and after the saturation.
    #[inline]
    fn damp(&mut self, alpha: f64, velocity: [f64; 3], period: f64, forces: [[f64; 3]; 2]) {
        if alpha == 0.0 || largest(velocity) == 0.0 {
            return;
        }
        self.damped += 1;
        let is_clipped = (0..3).all(|axis| {
            let [own, left] = [forces[0][axis], forces[1][axis]];
            let is_at_limit = own.abs() >= self.limit && left.abs() >= self.limit;
            velocity[axis] == 0.0 || is_at_limit && own.signum() == left.signum()
        });
        self.clipped += u64::from(is_clipped);
        self.asked += velocity.iter().map(|it| alpha * it * it * period).sum::<f64>();
    }

    /// Whether any force acted on the plant.
    pub(crate) fn acts(&self) -> bool {
        self.applied != 0.0
    }

    /// The signs of a run of `scene`, those of the scene's own numbers first.
    pub(crate) fn finish(&self, scene: &Scene) -> Vec<Oddity> {
        let mut signs = scene::signs(scene);
        // A position in a wrong unit is the cause, and told already.
        let has_unit = signs.iter().any(|it| it.sign == Sign::Unit);
        let miscount = self.miscount.finish(scene).filter(|_| !has_unit);
        let further = [self.idle(scene), self.clipped(), self.driven(), miscount];
        signs.extend(further.into_iter().flatten());
        signs
    }

    /// A run that touches nothing, or in which no force acts.
    fn idle(&self, scene: &Scene) -> Option<Oddity> {
        let ticks = self.ticks;
        if self.environment != 0.0 {
            let waits = self.ticks - self.first.unwrap_or(0) >= WAIT.min(self.ticks);
            let is_idle = self.applied == 0.0 && (waits || u64::from(scene.delay_ticks()) >= ticks);
            let most = found(self.environment);
            return is_idle.then(|| {
                let text = format!("f_env reaches {most} N, and f_act is 0 {}", on_all(ticks));
                Oddity::new(Sign::Idle, format!("{text}: {}", self.withheld(scene)))
            });
        }
        if ticks == 0 {
            return None;
        }
        if scene.effects.dropout.is_some_and(|it| it.probability.get() == 1.0) {
            let text = "no answer of the environment arrives: effects.dropout.probability is 1";
            return Some(Oddity::new(Sign::Idle, text));
        }
        let text = format!("f_env is 0 {}: {}", on_all(ticks), self.out_of_touch(scene));
        Some(Oddity::new(Sign::Untouched, text))
    }

    /// The reason why no force of the environment reaches the plant.
    fn withheld(&self, scene: &Scene) -> String {
        let delay = scene.delay_ticks();
        if self.first.unwrap_or(0) + u64::from(delay) >= self.ticks {
            return format!("the delay is {}", counted(delay as usize, "tick"));
        }
        let why = if scene.device.damping.get() == 0.0 {
            "; device.damping is 0, and force-bound and force-bounding spend that damping"
        } else {
            ""
        };
        format!("the stabilizer lets none of it through{why}")
    }

    /// Where the plant is and where the environment begins.
    fn out_of_touch(&self, scene: &Scene) -> String {
        let stands = scene.environment.kind().frequency().is_none();
        let Some(surface) = scene.surface().filter(|_| stands) else {
            return "nothing is touched".to_owned();
        };
        let (high, place) = (found(1e3 * self.high), given(1e3 * surface));
        if self.high > surface {
            format!("x reaches {high} mm, beyond the surface at {place} mm, but nothing pushes")
        } else {
            format!("x does not go beyond {high} mm, and the surface is at {place} mm")
        }
    }

    /// Corrections of which the saturation leaves nothing.
    fn clipped(&self) -> Option<Oddity> {
        let is_lost = self.damped >= WAIT && self.clipped == self.damped;
        is_lost.then(|| {
            let (ticks, limit) = (self.damped, given(self.limit / CLIPPED));
            let text = format!(
                "alpha is not 0 on {ticks} ticks, and the saturation of {limit} N hides all of it"
            );
            Oddity::new(Sign::Idle, text)
        })
    }

    /// A stabilizer that pushes along the motion.
    fn driven(&self) -> Option<Oddity> {
        (self.asked < 0.0).then(|| {
            let asked = found(1e3 * self.asked);
            let text =
                format!("the stabilizer pushes along the motion: alpha v^2 T sums to {asked} mJ");
            Oddity::new(Sign::Reversed, text)
        })
    }
}

#[inline]
fn largest(axes: [f64; 3]) -> f64 {
    axes.iter().fold(0.0, |size, axis| size.max(axis.abs()))
}

/// All ticks of a run, in words.
fn on_all(ticks: u64) -> String {
    if ticks == 1 { "on its only tick".to_owned() } else { format!("on all {ticks} ticks") }
}
