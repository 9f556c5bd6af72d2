//! What a run came to, in a few lines.

use std::fmt;

use crate::Row;
use crate::scene::{Candidate, Environment, Lolc, Popc, Scalar, Scene, Stabilizer, Work};

/// Settled means within this share of the starting swing about the equilibrium.
const BAND: f64 = 0.05;

/// What a run came to, summed up row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    scene: Scene,
    /// Rows summed up.
    pub rows: u64,
    /// The last row.
    pub last: Option<Row>,
    /// Where the operator's spring and the environment balance, m; none where no spring pulls.
    pub equilibrium: Option<f64>,
    /// Half the width of the band about the equilibrium that counts as settled, m.
    pub band: f64,
    /// Since when the plant has been in the band without a break, s; none if it is outside.
    pub settled: Option<f64>,
    /// Largest magnitude of the environment's force, N.
    pub environment_peak: f64,
    /// Largest magnitude of the force that acted on the plant, N.
    pub acting_peak: f64,
    /// Energy that crossed the port into the environment, `Σ f_act Δx` over the true positions, J.
    pub absorbed: f64,
    /// Least value of the observer sum, J.
    pub observer_least: f64,
    /// Largest value of the observer sum, J.
    pub observer_most: f64,
    /// Energy that the controller set out to burn, `Σ α v² T`, J.
    pub injected: f64,
    /// Largest debt that a tick could not serve, J.
    pub shortfall: f64,
    /// Ticks on which the controller was active.
    pub active: u64,
}

impl Summary {
    /// The summary of no row yet.
    pub fn new(scene: &Scene) -> Self {
        let equilibrium = equilibrium(scene);
        Self {
            scene: *scene,
            rows: 0,
            last: None,
            equilibrium,
            band: BAND * equilibrium.map_or(0.0, |rest| swing(scene, rest)),
            settled: None,
            environment_peak: 0.0,
            acting_peak: 0.0,
            absorbed: 0.0,
            observer_least: 0.0,
            observer_most: 0.0,
            injected: 0.0,
            shortfall: 0.0,
            active: 0,
        }
    }

    /// The summary of all `rows` of `scene`.
    pub fn of(scene: &Scene, rows: impl IntoIterator<Item = Row>) -> Self {
        let mut summary = Self::new(scene);
        rows.into_iter().for_each(|row| summary.add(&row));
        summary
    }

    /// Sums up one more row.
    pub fn add(&mut self, row: &Row) {
        if let Some(last) = self.last {
            self.absorbed += last.f_act * (row.x - last.x);
        }
        let inside = self.equilibrium.is_some_and(|rest| (row.x - rest).abs() <= self.band);
        self.settled = if inside { self.settled.or(Some(row.t)) } else { None };
        self.environment_peak = self.environment_peak.max(row.f_env.abs());
        self.acting_peak = self.acting_peak.max(row.f_act.abs());
        self.observer_least = self.observer_least.min(row.observer);
        self.observer_most = self.observer_most.max(row.observer);
        self.injected += row.f_ctl * row.v * self.scene.period();
        self.shortfall = self.shortfall.max(row.shortfall);
        self.active += u64::from(row.alpha > 0.0);
        self.rows += 1;
        self.last = Some(*row);
    }

    /// The last time at which everything was finite, s, if the motion left the range of the scalar.
    pub fn left_range(&self) -> Option<f64> {
        let complete = self.rows == self.scene.ticks() + 1;
        (!complete).then(|| self.last.map_or(0.0, |row| row.t))
    }
}

/// Where the operator's spring and a one-sided wall balance.
fn equilibrium(scene: &Scene) -> Option<f64> {
    let Environment::Wall(wall) = scene.environment;
    let (pull, rest) = (scene.operator.stiffness.get(), scene.operator.rest.get());
    let (push, surface) = (wall.stiffness.get(), wall.position.get());
    let pressed = surface + (rest - surface) * (pull / (pull + push));
    (pull > 0.0).then_some(if rest > surface { pressed } else { rest })
}

/// How far the plant would swing about `rest` if nothing else acted.
fn swing(scene: &Scene, rest: f64) -> f64 {
    let mass = scene.operator.mass.get() + scene.device.mass.get();
    let frequency = (scene.operator.stiffness.get() / mass).sqrt();
    let away = scene.initial.position.get() - rest;
    away.hypot(scene.initial.velocity.get() / frequency)
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", Described(&self.scene))?;
        let millimetres = |metres: f64| Number(1e3 * metres);
        match (self.left_range(), self.settled, self.equilibrium) {
            (Some(time), ..) => writeln!(
                f,
                "  settled      no: the motion left the range of the scalar after t = {} s",
                Number(time)
            )?,
            (None, Some(time), Some(rest)) => writeln!(
                f,
                "  settled      yes, from t = {} s on within {} mm of x = {} mm",
                Number(time),
                millimetres(self.band),
                millimetres(rest)
            )?,
            (None, _, Some(rest)) => writeln!(
                f,
                "  settled      no: at the end not within {} mm of x = {} mm",
                millimetres(self.band),
                millimetres(rest)
            )?,
            (None, _, None) => writeln!(f, "  settled      no: no spring pulls it anywhere")?,
        }
        writeln!(
            f,
            "  peak force   {} N from the environment, {} N on the plant",
            Number(self.environment_peak),
            Number(self.acting_peak)
        )?;
        write!(f, "  energy       {} mJ into the port", Number(1e3 * self.absorbed))?;
        if self.scene.stabilizer.is_none() {
            return Ok(());
        }
        let share = 100.0 * self.active as f64 / self.rows.max(1) as f64;
        let last = self.last.map_or(0.0, |row| row.observer);
        writeln!(
            f,
            "; observer from {} to {} mJ, at the end {} mJ",
            Number(1e3 * self.observer_least),
            Number(1e3 * self.observer_most),
            Number(1e3 * last)
        )?;
        write!(
            f,
            "  controller   active on {share:.1} % of ticks, {} mJ injected, shortfall up to {} mJ",
            Number(1e3 * self.injected),
            Number(1e3 * self.shortfall)
        )
    }
}

/// A number with four significant digits.
pub(crate) struct Number(pub(crate) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let size = self.0.abs();
        if size == 0.0 {
            f.write_str("0")
        } else if (1e-3..1e5).contains(&size) {
            let decimals = (3 - size.log10().floor() as i32).clamp(0, 6) as usize;
            write!(f, "{:.decimals$}", self.0)
        } else {
            write!(f, "{:.3e}", self.0)
        }
    }
}

/// A scene in one line.
struct Described<'a>(&'a Scene);

impl fmt::Display for Described<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scene = self.0;
        let Environment::Wall(wall) = scene.environment;
        let number = |value: f64| Number(value).to_string();
        write!(f, "{} s at {} Hz", scene.duration.get(), scene.servo_rate.get())?;
        if scene.environment_ratio() > 1 {
            write!(f, " over {} Hz", scene.environment_rate())?;
        }
        write!(f, ", wall {} N/m", wall.stiffness.get())?;
        write!(f, " {} N.s/m", number(wall.damping.get()))?;
        let work = |work| if work == Work::Held { "held" } else { "sampled" };
        match scene.stabilizer {
            None => write!(f, ", no stabilizer")?,
            Some(Stabilizer::Popc(Popc { work: kind, damping_cap })) => {
                write!(f, ", POPC ({} work, cap {})", work(kind), damping_cap.get())?;
            }
            Some(Stabilizer::Lolc(Lolc { work: kind, candidate, damping_cap })) => {
                let candidate = match candidate {
                    Candidate::MassSpringDamper => "mass-spring-damper",
                    Candidate::DeviceDamping => "device-damping",
                    Candidate::Spring => "spring",
                };
                write!(f, ", LOLC ({candidate}, {} work, cap {})", work(kind), damping_cap.get())?;
            }
        }
        if scene.scalar == Scalar::F32 { f.write_str(", f32") } else { Ok(()) }
    }
}
