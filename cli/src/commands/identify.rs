//! The command `lyapunov identify`.

use std::path::PathBuf;

use clap::Args;
use lyapunov_lab::identify::{Alone, Identified, Recording, Settings};
use lyapunov_lab::observe::{Columns, Scale};

use super::apart::apart;
use super::folder::Folder;
use super::results::{Results, command_line, names};
use super::source::Source;
use super::{End, tell};
use crate::files::Inputs;

/// The file that `--json` prints.
const RESULTS: &str = "identify.json";

/// Fit a scene to a recorded log: mass, damping, spring and wall, each with its 95 % interval.
///
/// The log is as for `observe`: time, position and the force that acts from each row until the next, positive where it
/// resists motion towards larger x. Mass, damping and spring are those under which the recorded force moves the device
/// as recorded; the wall is the force over the depth. The scene that is printed is ready to run. Notes say what the
/// log cannot tell, and what it contradicts. docs/identify.md has the equations.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Identify {
    /// The log; `-` is standard input.
    log: PathBuf,
    /// The columns of time, position, force and, if there is one, velocity: by name, or by number from 1. The wall may
    /// have seen that velocity, or the backward difference.
    #[arg(long, value_name = "T,X,F[,V]", default_value = "t,x,f")]
    columns: Columns,
    /// A factor from the log's unit of t, x, f or v to SI, as in x=1e-3,t=1e-6; f=-1 turns the sign.
    #[arg(long, value_name = "COLUMN=FACTOR", value_delimiter = ',', allow_hyphen_values = true)]
    scale: Vec<Scale>,
    /// The mass of the device without the hand, kg: a log tells only the sum of both. The rest of the sum is the hand's.
    #[arg(long, value_name = "KG", allow_negative_numbers = true)]
    device_mass: Option<f64>,
    /// The damping of the device without the hand, N·s/m, as surely is there; the rest of the sum is the hand's.
    #[arg(long, value_name = "B", allow_negative_numbers = true)]
    device_damping: Option<f64>,
    /// Write report.html, identify.json, the scene (identify.toml), the numbers (CSV) and the plot (SVG and PNG) into
    /// this folder; made if not there.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Print the numbers and the scene as JSON, in SI units.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Identify {
    pub(crate) fn run(&self) -> Result<(), End> {
        let alone = Alone { mass: self.device_mass, damping: self.device_damping };
        let (columns, scales) = (self.columns.clone(), self.scale.clone());
        let settings = Settings { columns, scales, alone };
        let inputs = Inputs::of("the log", [&self.log]);
        let files = names(RESULTS, ["identify"], ["identify.toml", "identify.csv"]);
        let folder = Folder::asked(self.out.as_deref(), files, &inputs)?;
        let (recording, name) = Source::read_by(&self.log, self.quiet, |log, name| {
            Recording::read(log, name, &settings).map(|it| (it, name.to_owned()))
        })?;
        let identified =
            apart(move || Identified::of(recording, &name, alone))?.map_err(End::input)?;
        let json = identified.to_json();
        if let Some(folder) = folder {
            let results = Results::new(identified.to_html(&command_line()), RESULTS, &json);
            let results = results.with_figure("identify", &identified.figure())?;
            let results = results.with_file("identify.toml", identified.scene.as_str());
            folder.fill(results.with_file("identify.csv", identified.csv()))?;
        }
        tell(self.json, self.quiet, json, identified)
    }
}
