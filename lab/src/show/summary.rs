//! Summary in a few lines, and as JSON.

use std::fmt;

use serde::Serialize;

use super::described;
use super::json;
use super::row_file::RowFile;
use crate::files::scene::{Scalar, Velocity};
use crate::text::{folded, found, given, listed};

use crate::measure::summary::MILLI;
use crate::measure::{Oddity, Summary, Verdict, Yardstick};
use crate::simulate::Stabilizing;

#[derive(Serialize)]
struct Document<'a, A: Serialize> {
    scene: &'a str,
    rows: u64,
    complete: bool,
    verdict: Verdict,
    verdict_by: Yardstick,
    settling_time_s: Option<f64>,
    equilibrium_mm: Option<Place>,
    band_mm: Option<f64>,
    peak_force_environment_n: f64,
    peak_force_acting_n: f64,
    energy_into_port_mj: f64,
    stabilizer: Option<Observed<'a>>,
    look_at: Vec<Oddity>,
    /// What the file of the rows says about itself.
    file: RowFile,
    /// What a study adds under a name of its own.
    #[serde(skip_serializing_if = "Option::is_none")]
    against: Option<A>,
}

/// A place in mm: a number on a line, a list in a space.
#[derive(Serialize)]
#[serde(untagged)]
enum Place {
    OnALine(f64),
    InSpace(Vec<f64>),
}

impl Place {
    fn of(metres: &[f64]) -> Self {
        match metres {
            [x] => Self::OnALine(MILLI * x),
            axes => Self::InSpace(axes.iter().map(|axis| MILLI * axis).collect()),
        }
    }
}

/// Observed energies and corrections of a stabilizer.
#[derive(Serialize)]
struct Observed<'a> {
    /// The name of a stabilizer of the caller's, whose table no scene has.
    #[serde(skip_serializing_if = "Option::is_none")]
    own: Option<&'a str>,
    /// None where a stabilizer of the caller's tells neither observed energy nor shortfall, and so the shortfall.
    observed_energy_least_mj: Option<f64>,
    observed_energy_most_mj: Option<f64>,
    observed_energy_end_mj: Option<f64>,
    /// None under a law without a damping that is told as `alpha`, and so the energy asked for.
    active_percent: Option<f64>,
    /// The limit of the damping cap for the delay, m / T, where the cap lies above it.
    #[serde(skip_serializing_if = "Option::is_none")]
    damping_cap_limit: Option<f64>,
    energy_asked_for_mj: Option<f64>,
    shortfall_mj: Option<f64>,
}

impl Summary {
    /// The summary of the scene called `scene`, as JSON; docs/command.md lists its keys.
    pub fn to_json(&self, scene: &str) -> String {
        self.to_json_against(scene, None::<()>)
    }

    /// The same with the log that the run was laid over under `against`.
    pub(crate) fn to_json_against(&self, scene: &str, against: Option<impl Serialize>) -> String {
        let complete = self.left_range().is_none();
        let stabilizer = self.stabilizing.is_there().then(|| self.stabilizer());
        let document = Document {
            scene,
            rows: self.rows,
            complete,
            verdict: self.verdict(),
            verdict_by: self.verdict_by(),
            settling_time_s: self.settling_time(),
            equilibrium_mm: self.equilibrium.as_deref().map(Place::of),
            band_mm: self.equilibrium.as_ref().map(|_| MILLI * self.band),
            peak_force_environment_n: self.environment_peak,
            peak_force_acting_n: self.acting_peak,
            energy_into_port_mj: MILLI * self.absorbed,
            stabilizer,
            look_at: self.look_at(),
            file: RowFile::of(&self.scene),
            against,
        };
        json::text(&document)
    }

    fn stabilizer(&self) -> Observed<'_> {
        let own = match &self.stabilizing {
            Stabilizing::Foreign(name) => Some(&**name),
            Stabilizing::Table(_) => None,
        };
        let told = |energy: f64| self.reports_debt().then_some(MILLI * energy);
        Observed {
            own,
            observed_energy_least_mj: told(self.observed_energy_least),
            observed_energy_most_mj: told(self.observed_energy_most),
            observed_energy_end_mj: told(self.last.map_or(0.0, |row| row.observed_energy)),
            damping_cap_limit: self.scene.exceeded_cap(),
            active_percent: self.active_percent(),
            energy_asked_for_mj: self.millijoules_asked(),
            shortfall_mj: told(self.shortfall),
        }
    }
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write_scene(f)?;
        if let Some(time) = self.left_range() {
            match self.rows {
                0 => write!(f, "\n  cut short    at t = 0 s, before the first row")?,
                _ => write!(f, "\n  cut short    after t = {} s", given(time))?,
            }
            match self.is_rejected() {
                true => write!(f, ": the stabilizer rejected a sample")?,
                false => write!(f, ": the motion left the range of {}", self.scene.scalar.name())?,
            }
        }
        write!(f, "\n{}", folded("  verdict      ", &self.verdict_in_words()))?;
        write!(
            f,
            "\n  peak force   {} N from the environment, {} N on the plant",
            found(self.environment_peak),
            found(self.acting_peak)
        )?;
        let way = if self.absorbed < 0.0 { "came out of" } else { "went into" };
        write!(f, "\n  energy       {} mJ {way} the port", found(MILLI * self.absorbed.abs()))?;
        if self.stabilizing.is_there() {
            self.write_stabilizer(f)?;
        }
        let mut signs = self.look_at().into_iter();
        signs.try_for_each(|it| write!(f, "\n{}", folded("  look at      ", &it.text)))
    }
}

impl Summary {
    /// Writes the scene, as far as it differs from scene to scene.
    fn write_scene(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scene = &self.scene;
        let (duration, rate) = (given(scene.duration.get()), given(scene.servo_rate.get()));
        let mut run = vec![format!("{duration} s at {rate} Hz")];
        if scene.environment_ratio() > 1 {
            run.push(format!("environment at {} Hz", given(scene.environment_rate())));
        }
        if scene.velocity == Velocity::Exact {
            run.push("exact velocity".to_owned());
        }
        run.extend(described::integrator(scene.integrator));
        if scene.scalar == Scalar::F32 {
            run.push("in f32".to_owned());
        }
        if scene.dimensions() > 1 {
            run.push(format!("in {} dimensions", scene.dimensions()));
        }
        f.write_str(&listed("  run          ", &run))?;
        let environment = described::environment(scene);
        if scene.environment.wall().is_some() {
            write!(f, "\n  wall         {environment}")?;
        } else {
            write!(f, "\n  environment  {}: {environment}", scene.environment.name())?;
        }
        write_list("operator", &described::operator(scene), f)?;
        write!(f, "\n{}", described::stabilizer(scene, &self.stabilizing))?;
        if let Some(sentence) = described::exceeded_cap(scene) {
            write!(f, "\n  cap          {sentence}")?;
        }
        write_list("effects", &described::effects(scene), f)
    }

    fn write_stabilizer(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let last = self.last.map_or(0.0, |row| row.observed_energy);
        let energies =
            [self.observed_energy_least, self.observed_energy_most, last, self.shortfall];
        let [least, most, last, shortfall] = energies.map(|it| found(MILLI * it));
        let (observed, short) = match self.reports_debt() {
            true => (
                format!("energy from {least} to {most} mJ, at the end {last} mJ"),
                format!(", shortfall up to {shortfall} mJ"),
            ),
            false => ("energy and shortfall: it tells none".to_owned(), String::new()),
        };
        write!(f, "\n  observed     {observed}")?;
        let did = match (self.active_percent(), self.millijoules_asked(), &self.stabilizing) {
            (Some(share), Some(asked), _) => {
                format!("active on {share:.1} % of ticks, {} mJ asked for", found(asked))
            }
            (.., Stabilizing::Table(Some(table))) if table.kind().adds_damping() => {
                "damps as a port around the environment and not by an alpha".to_owned()
            }
            (.., Stabilizing::Foreign(_)) => "changes the force and tells no alpha".to_owned(),
            _ => "cuts the force and adds no damping".to_owned(),
        };
        write!(f, "\n  controller   {did}{short}")
    }
}

/// Writes a line of `things` with `name` in front, folded if it grows long; nothing if there are none.
fn write_list(name: &str, things: &[String], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if things.is_empty() {
        return Ok(());
    }
    write!(f, "\n{}", listed(&format!("  {name:<13}"), things))
}
