//! The command `lyapunov observe`.

use std::path::PathBuf;

use clap::Args;
use lyapunov_lab::family::StabilizerNames;
use lyapunov_lab::observe::{self, Asked, Candidate, Columns, Scale, Settings};
use lyapunov_lab::scene::Scene;

use super::folder::Folder;
use super::results::{Results, command_line, names};
use super::source::Source;
use super::{End, named, tell};
use crate::files::Inputs;

/// The file that `--json` prints.
const RESULTS: &str = "observe.json";

/// Observe a recorded log of any device: when energy was generated, how much and by which contact.
///
/// The log is CSV (commas, semicolons or tabs) with the names of the columns in its first line, in SI units unless a
/// name tells another, as in x [mm], f_kN or time (ms): t in s, increasing but not necessarily evenly; x in m; f in N,
/// the environment's force on the device that acts from this row until the next. What run --csv writes is read as it
/// is. Power f v > 0 flows into the environment: f is positive where it resists motion towards larger x, as a wall
/// does. For a log with the other sign of force add --scale f=-1.
///
/// Bad rows are counted and named, and the next good row spans the gap. docs/observe.md defines every number.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Observe {
    /// The log; `-` is standard input.
    log: PathBuf,
    /// The columns of time, position, force and, if there is one, velocity: by name, or by number from 1.
    /// Without a velocity the backward difference over the true time step is taken. The letters stand for time, position or
    /// pos, force or f_act, and velocity as well.
    #[arg(long, value_name = "T,X,F[,V]", default_value = "t,x,f")]
    columns: Columns,
    /// A factor from the log's unit of t, x, f or v to SI, as in x=1e-3,t=1e-6, in place of a unit that the name of the
    /// column tells; f=-1 turns the sign.
    #[arg(long, value_name = "COLUMN=FACTOR", value_delimiter = ',', allow_hyphen_values = true)]
    scale: Vec<Scale>,
    /// The candidate whose decrease is summed, in the words of scene files; spring is the port's energy, as in
    /// POPC.
    #[arg(long, default_value = Candidate::NAMES[0], value_parser = Candidate::NAMES)]
    candidate: String,
    /// The damping that device-damping and mass-spring-damper credit, N·s/m.
    #[arg(long, value_name = "B", allow_negative_numbers = true)]
    damping: Option<f64>,
    /// Where mass-spring-damper begins to credit, m: beyond it is x > X.
    #[arg(long, value_name = "X", allow_negative_numbers = true)]
    surface: Option<f64>,
    /// The force above which there is contact, N [default: 1 % of the largest so far].
    #[arg(long, value_name = "NEWTON", allow_negative_numbers = true)]
    contact: Option<f64>,
    /// The rows by which the force acts later than its own, as where the log holds commands and the motor is late; identify
    /// tells them. The first rows, on which forces from before the log act, are left out.
    #[arg(long, value_name = "ROWS", default_value_t = 0, allow_negative_numbers = true,
        value_parser = clap::value_parser!(u32).range(..=1000))]
    late: u32,
    /// Ask these stabilizers what they would have done on the recorded motion, by name, or all; docs/family.md has the
    /// names. Had one acted, the motion would have been another.
    #[arg(long, value_name = "NAMES")]
    stabilizers: Option<StabilizerNames>,
    /// The scene that sets the numbers of these stabilizers, as in compare: mass, servo period, delay, environment.
    #[arg(long, value_name = "SCENE", requires = "stabilizers")]
    scene: Option<PathBuf>,
    /// Write report.html, observe.json, the contacts and the stabilizers (CSV) and plots (SVG and PNG) into this folder;
    /// made if not there.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print the report as JSON, in SI units.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Observe {
    pub(crate) fn run(&self) -> Result<(), End> {
        let settings = Settings {
            columns: self.columns.clone(),
            scales: self.scale.clone(),
            candidate: Candidate::named(&self.candidate, self.damping, self.surface)
                .map_err(End::input)?,
            contact: self.contact,
            late: self.late,
        };
        let asked = self.asked()?;
        let mut inputs = Inputs::of("the log", [&self.log]);
        let mut files = names(RESULTS, ["observe"], ["observe.csv"]);
        if let Some(asked) = &asked {
            inputs = inputs.and("the scene", self.scene.as_deref()).and_named_by(&asked.scene);
            files.extend(
                ["stabilizers.csv", "stabilizers.svg", "stabilizers.png"].map(str::to_owned),
            );
        }
        let folder = Folder::asked(self.out.as_deref(), files, &inputs)?;
        let observed = Source::read_by(&self.log, self.quiet, |log, name| match &asked {
            Some(asked) => observe::replay(log, name, &settings, asked),
            None => observe::observe(log, name, &settings),
        })?;
        let text = observed.report.to_json();
        if let Some(folder) = folder {
            let results = Results::new(observed.to_html(&command_line()), RESULTS, &text);
            let mut results = results.with_figure("observe", &observed.figure())?;
            if let Some(replay) = &observed.report.replay {
                results = results.with_file("stabilizers.csv", replay.csv());
            }
            if let Some(figure) = observed.would_have() {
                results = results.with_figure("stabilizers", &figure)?;
            }
            folder.fill(results.with_file("observe.csv", observed.csv()))?;
        }
        let written =
            self.out.as_deref().map(|folder| format!("  written     {}\n", named(folder)));
        let said = format!("{}\n{}", observed.report, written.unwrap_or_default());
        tell(self.json, self.quiet, text, said)
    }

    /// The stabilizers that are asked what they would have done.
    fn asked(&self) -> Result<Option<Asked>, End> {
        let Some(stabilizers) = self.stabilizers.clone() else { return Ok(None) };
        let Some(path) = &self.scene else {
            return Err(End::input(
                "--stabilizers needs --scene: mass, servo period, delay and environment set their numbers\n  \
                 = add --scene SCENE, a file for your device; scenes/paper-8k-none.toml is a short one",
            ));
        };
        let scene = Scene::load(path).map_err(End::input)?;
        Ok(Some(Asked { stabilizers, scene, name: named(path) }))
    }
}
