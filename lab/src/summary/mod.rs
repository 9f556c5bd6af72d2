//! What a run came to, in a few lines.

mod document;

use std::fmt;

use crate::described;
use crate::equilibrium::{equilibrium, never_rests, swing};
use crate::meters::Settling;
use crate::scene::{Candidate, Cap, Ledger, Lolc, Popc, Scalar, Scene, Stabilizer, Velocity, Work};
use crate::words::listed;
use crate::{Row, Space, Tick};

/// Settled means within this share of the starting swing about the equilibrium.
pub(crate) const BAND: f64 = 0.05;
/// Settled in the last tenth of a run is not yet settled.
const LATE: f64 = 0.9;

/// Lengths and energies are told in thousandths of their units.
const MILLI: f64 = 1e3;

/// What a run came to, summed up tick by tick.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    scene: Scene,
    /// Ticks summed up.
    pub rows: u64,
    /// The last tick.
    pub last: Option<Row>,
    /// Where the operator's spring and the environment balance, m; none where no spring pulls, or only out of range.
    pub equilibrium: Option<f64>,
    /// Half the width of the band about the equilibrium that counts as settled, m.
    pub band: f64,
    /// Since when the plant has been in the band without a break, s; none if it is outside.
    pub settled: Option<f64>,
    settling: Settling<f64>,
    /// Largest magnitude of the environment's force, N.
    pub environment_peak: f64,
    /// Largest magnitude of the force that applied on the plant, N.
    pub acting_peak: f64,
    /// Energy that crossed the port into the environment, `Σ f_act Δx` over the true positions, J; infinite from where
    /// it leaves the range of f64.
    pub absorbed: f64,
    /// Least value of the observer sum, J.
    pub observer_least: f64,
    /// Largest value of the observer sum, J.
    pub observer_most: f64,
    /// Energy that the controller set out to burn, `Σ α v² T`, J; infinite from where it leaves the range of f64.
    pub injected: f64,
    /// Largest debt that a tick could not serve, J.
    pub shortfall: f64,
    /// Ticks on which the controller was active.
    pub active: u64,
    axes: [Axis; 3],
}

impl Summary {
    /// The summary of no tick yet.
    pub fn new(scene: &Scene) -> Self {
        let rest = equilibrium(scene).map(|rest| (rest, BAND * swing(scene, rest)));
        let shown = |metres: f64| (MILLI * metres).is_finite();
        let (equilibrium, band) = rest.filter(|(rest, band)| shown(*rest) && shown(*band)).unzip();
        Self {
            scene: scene.clone(),
            rows: 0,
            last: None,
            equilibrium,
            band: band.unwrap_or_default(),
            settled: None,
            settling: rest_of(equilibrium.zip(band)),
            environment_peak: 0.0,
            acting_peak: 0.0,
            absorbed: 0.0,
            observer_least: 0.0,
            observer_most: 0.0,
            injected: 0.0,
            shortfall: 0.0,
            active: 0,
            axes: Default::default(),
        }
    }

    /// The summary of all `ticks` of a `scene`.
    pub fn of<V: Space>(scene: &Scene, ticks: impl IntoIterator<Item = Tick<V>>) -> Self {
        let mut summary = Self::new(scene);
        ticks.into_iter().for_each(|tick| summary.add(&tick));
        summary
    }

    /// Sums up one more tick.
    pub fn add<V: Space>(&mut self, tick: &Tick<V>) {
        let (row, axes) = (Row::of(tick), Axis::of(tick));
        if self.last.is_some() {
            for (last, axis) in self.axes.iter().zip(&axes) {
                self.absorbed = sum(self.absorbed, last.f_act, axis.x - last.x);
            }
        }
        self.settling.add(row.x);
        self.settled = self.settling.since(0).and(self.settled.or(Some(row.t)));
        let size = |forces: [f64; 3]| forces.into_iter().fold(0.0, f64::hypot);
        self.environment_peak = self.environment_peak.max(size(axes.map(|axis| axis.f_env)));
        self.acting_peak = self.acting_peak.max(size(axes.map(|axis| axis.f_act)));
        self.observer_least = self.observer_least.min(row.observer);
        self.observer_most = self.observer_most.max(row.observer);
        for axis in &axes {
            self.injected = sum(self.injected, axis.f_ctl, axis.v * self.scene.period());
        }
        self.shortfall = self.shortfall.max(row.shortfall);
        self.active += u64::from(row.alpha > 0.0);
        self.rows += 1;
        self.last = Some(row);
        self.axes = axes;
    }

    /// The last time at which everything was finite, s, if the motion left the range of the scalar.
    pub fn left_range(&self) -> Option<f64> {
        let complete = self.rows == self.scene.ticks() + 1;
        (!complete).then(|| self.last.map_or(0.0, |row| row.t))
    }
}

/// Never at rest where there is no place to rest at.
fn rest_of(rest: Option<(f64, f64)>) -> Settling<f64> {
    let (rest, band) = rest.unwrap_or((0.0, -1.0));
    Settling::new(rest, band)
}

/// A tick along one axis.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Axis {
    x: f64,
    v: f64,
    f_env: f64,
    f_ctl: f64,
    f_act: f64,
}

impl Axis {
    /// `tick` along each axis; all 0 along those that the scene does not have.
    fn of<V: Space>(tick: &Tick<V>) -> [Self; 3] {
        let control = tick.control();
        let mut axes = [Self::default(); 3];
        for (index, axis) in axes.iter_mut().enumerate().take(V::DIMENSIONS) {
            *axis = Self {
                x: tick.truth.position.axis(index),
                v: tick.measured.velocity.axis(index),
                f_env: tick.environment.axis(index),
                f_ctl: control.axis(index),
                f_act: tick.applied.axis(index),
            };
        }
        axes
    }
}

/// A sum of work with one more piece; once infinite it stays so, and it is never NaN.
fn sum(total: f64, force: f64, way: f64) -> f64 {
    // Two positions can lie so far apart that the way between them is infinite.
    if total.is_finite() && force != 0.0 { total + force * way } else { total }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_scene(f)?;
        if let Some(time) = self.left_range() {
            let scalar = if self.scene.scalar == Scalar::F32 { "f32" } else { "f64" };
            match self.rows {
                0 => write!(f, "\n  cut short    at t = 0 s, before the first row")?,
                _ => write!(f, "\n  cut short    after t = {} s", given(time))?,
            }
            write!(f, ": the motion left the range of {scalar}")?;
        }
        self.write_settling(f)?;
        write!(
            f,
            "\n  peak force   {} N from the environment, {} N on the plant",
            found(self.environment_peak),
            found(self.acting_peak)
        )?;
        write!(f, "\n  energy       {} mJ into the port", found(MILLI * self.absorbed))?;
        if self.absorbed < 0.0 {
            f.write_str(": more came out than went in")?;
        }
        if self.scene.stabilizer.is_some() { self.write_stabilizer(f) } else { Ok(()) }
    }
}

impl Summary {
    /// The scene, as far as it is not the same for every scene.
    fn write_scene(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scene = &self.scene;
        write!(
            f,
            "  run          {} s at {} Hz",
            given(scene.duration.get()),
            given(scene.servo_rate.get())
        )?;
        if scene.environment_ratio() > 1 {
            write!(f, ", environment at {} Hz", given(scene.environment_rate()))?;
        }
        if scene.velocity == Velocity::Exact {
            f.write_str(", exact velocity")?;
        }
        if let Some(integrator) = described::integrator(scene.integrator) {
            write!(f, ", {integrator}")?;
        }
        if scene.scalar == Scalar::F32 {
            f.write_str(", in f32")?;
        }
        if scene.dimensions() > 1 {
            write!(f, ", in {} dimensions", scene.dimensions())?;
        }
        let environment = described::environment(scene);
        if scene.environment.wall().is_some() {
            write!(f, "\n  wall         {environment}")?;
        } else {
            write!(f, "\n  environment  {}: {environment}", scene.environment.name())?;
        }
        write_list("operator", &described::operator(scene), f)?;
        match scene.stabilizer {
            None => f.write_str("\n  stabilizer   none")?,
            Some(Stabilizer::Popc(Popc { work, ledger, damping_cap })) => {
                write!(f, "\n  stabilizer   POPC: {}", Booking(work, ledger, damping_cap))?;
            }
            Some(Stabilizer::Lolc(Lolc { work, candidate, ledger, damping_cap })) => {
                let candidate = match candidate {
                    Candidate::MassSpringDamper => "mass-spring-damper",
                    Candidate::DeviceDamping => "device-damping",
                    Candidate::Spring => "spring",
                };
                let booking = Booking(work, ledger, damping_cap);
                write!(f, "\n  stabilizer   LOLC: {candidate}, {booking}")?;
            }
        }
        write_list("effects", &described::effects(scene), f)
    }

    fn write_settling(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("\n  settled      ")?;
        let millimetres = |metres: f64| found(MILLI * metres);
        let (rest, last) = match (self.equilibrium, self.last, self.left_range()) {
            (_, None, _) | (_, _, Some(_)) => return f.write_str("no"),
            (None, ..) if self.scene.operator.stiffness.get() == 0.0 => {
                return f
                    .write_str("no: without an operator's spring there is no place to settle at");
            }
            (None, ..) if self.scene.dimensions() > 1 => {
                return f.write_str("not judged in more than one dimension");
            }
            (None, ..) if never_rests(&self.scene) => {
                return f.write_str("no: what moves the plant never rests");
            }
            (None, ..) => return f.write_str("no: the place to settle at is out of range"),
            (Some(rest), Some(last), None) => (rest, last),
        };
        let (band, place) = (millimetres(self.band), millimetres(rest));
        match self.settled {
            // One last swing through the band is no rest.
            Some(time) if time > LATE * last.t => {
                let since = given(time);
                write!(f, "not yet: within {band} mm of x = {place} mm only since t = {since} s")
            }
            None if self.band == 0.0 => {
                write!(f, "not judged: it starts where it comes to rest, x = {place} mm")
            }
            Some(time) => {
                write!(f, "yes: from t = {} s on within {band} mm of x = {place} mm", given(time))
            }
            None => {
                let away = millimetres((last.x - rest).abs());
                write!(f, "no: at the end {away} mm from x = {place} mm, not within {band} mm")
            }
        }
    }

    fn write_stabilizer(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let share = 100.0 * self.active as f64 / self.rows.max(1) as f64;
        let last = self.last.map_or(0.0, |row| row.observer);
        write!(
            f,
            "\n  observer     from {} to {} mJ, at the end {} mJ",
            found(MILLI * self.observer_least),
            found(MILLI * self.observer_most),
            found(MILLI * last)
        )?;
        write!(
            f,
            "\n  controller   active on {share:.1} % of ticks, {} mJ asked for, shortfall up to {} mJ",
            found(MILLI * self.injected),
            found(MILLI * self.shortfall)
        )
    }
}

/// A line of things with their name in front, folded where it grows long; nothing where there is none.
fn write_list(name: &str, things: &[String], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if things.is_empty() {
        return Ok(());
    }
    write!(f, "\n{}", listed(&format!("  {name:<13}"), things))
}

/// How a stabilizer books work, and how much it may inject.
struct Booking(Work, Ledger, Cap);

impl fmt::Display for Booking {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let work = if self.0 == Work::Held { "held" } else { "sampled" };
        let ledger = match self.1 {
            Ledger::Plain => "",
            Ledger::Compensated => ", compensated ledger",
            Ledger::Wide => ", wide ledger",
        };
        let cap = self.2.get();
        if cap.is_infinite() {
            write!(f, "{work} work{ledger}, no damping cap")
        } else {
            write!(f, "{work} work{ledger}, damping cap {} m / T", given(cap))
        }
    }
}

/// A number that was computed: four digits tell all that matters.
pub(crate) fn found(value: f64) -> Number {
    Number { value, digits: 4 }
}

/// A number from the scene, or a time: close to what was written there, and still short.
pub(crate) fn given(value: f64) -> Number {
    Number { value, digits: 9 }
}

/// A number rounded to some significant digits, whole parts to no fewer than they have, without final zeros.
pub(crate) struct Number {
    value: f64,
    digits: usize,
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (value, size) = (self.value, self.value.abs());
        if size.is_infinite() {
            f.write_str(if value > 0.0 { "over 1.797e308" } else { "under -1.797e308" })
        } else if size == 0.0 {
            f.write_str("0")
        } else if (1e-3..1e6).contains(&size) {
            let decimals = (self.digits as i32 - 1 - size.log10().floor() as i32).max(0) as usize;
            f.write_str(trimmed(&format!("{value:.decimals$}")))
        } else {
            let decimals = self.digits - 1;
            let text = format!("{value:.decimals$e}");
            let (digits, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            write!(f, "{}e{exponent}", trimmed(digits))
        }
    }
}

/// Without the zeros at the end of a fraction.
fn trimmed(number: &str) -> &str {
    if number.contains('.') { number.trim_end_matches('0').trim_end_matches('.') } else { number }
}
