//! `lyapunov compare`.

use std::io::{self, Write};
use std::ops::ControlFlow;
use std::path::PathBuf;

use clap::Args;
use indicatif::ProgressBar;
use lyapunov_lab::compare::{Column, CompareError, Comparison, Contestants, document};
use lyapunov_lab::family::Members;
use lyapunov_lab::scene::{Scalar, Scene};
use lyapunov_lab::{Output, OutputError, Space, models, teleoperation};

use super::folder::Folder;
use super::subjects::{self, Subjects};
use super::{BAR, End, heed_interrupts, shown, standard_output};

/// Ticks in all from which on there is something to wait for.
const LONG: u64 = 1 << 20;

/// The file that `--json` prints.
pub(super) const RESULTS: &str = "compare.json";

/// Compare stabilizers on the same scenes.
///
/// Prints a table for each scene. All stabilizers take damping_cap from the scene's own stabilizer if it has one, POPC and
/// LOLC its work and ledger as well; docs/family.md says what each of the others is set to. A `-` stands where a column
/// does not apply; docs/compare.md defines the columns.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Compare {
    /// The scene files, or files of models or of teleoperators, TOML.
    #[arg(required = true, value_name = "SCENE")]
    pub(super) scenes: Vec<PathBuf>,
    /// Who takes part, by the names of docs/family.md, or all; files that are no scenes have rows of their own.
    #[arg(long, default_value_t = Members::standard(), value_name = "NAMES")]
    pub(super) stabilizers: Members,
    /// Write compare.json and a figure for each scene (SVG and PNG) into this folder; made if not there. Of models
    /// and teleoperators also report.html and a CSV for each.
    #[arg(long, value_name = "DIR")]
    pub(super) out: Option<PathBuf>,
    /// Sort by this column, the smallest first; by default the order of registration.
    ///
    /// A column is named by its key in compare.json, such as settling_time_s or ns_per_step.
    #[arg(long, value_name = "COLUMN")]
    pub(super) by: Option<Column>,
    /// Print compare.json instead of tables.
    #[arg(long, conflicts_with = "quiet")]
    pub(super) json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    pub(super) quiet: bool,
}

impl Compare {
    pub(crate) fn run(&self) -> Result<(), End> {
        heed_interrupts(true);
        let scenes = match Subjects::load(&self.scenes)? {
            Subjects::Scenes(scenes) => scenes,
            Subjects::Models(models) => return subjects::run::<models::Comparison>(self, &models),
            Subjects::Teleoperators(them) => {
                return subjects::run::<teleoperation::Comparison>(self, &them);
            }
        };
        let folder = self.out.as_deref().map(|path| Folder::claim(path, RESULTS)).transpose()?;
        let comparisons = self.compare(&scenes)?;
        let text = document(&comparisons).map_err(End::internal)?;
        if let Some(folder) = folder {
            fill(&folder, &self.scenes, &comparisons, &text)?;
        }
        let mut out = io::stdout().lock();
        if self.json {
            return out.write_all(text.as_bytes()).map_err(standard_output);
        }
        let shown = if self.quiet { &[][..] } else { &comparisons[..] };
        for (index, comparison) in shown.iter().enumerate() {
            let gap = if index == 0 { "" } else { "\n" };
            write!(out, "{gap}{comparison}").map_err(standard_output)?;
        }
        Ok(())
    }

    fn compare(&self, scenes: &[(String, Scene)]) -> Result<Vec<Comparison>, End> {
        let contestants = self.stabilizers.len() as u64;
        let ticks = scenes.iter().map(|(_, scene)| contestants * (scene.ticks() + 1)).sum();
        let bar = self.progress(ticks);
        let mut comparisons = Vec::new();
        for (name, scene) in scenes {
            let mut comparison = match scene.scalar {
                Scalar::F64 => self.meet::<f64>(name, scene, &bar)?,
                Scalar::F32 => self.meet::<f32>(name, scene, &bar)?,
            };
            if let Some(column) = self.by {
                comparison.sort_by(column);
            }
            comparisons.push(comparison);
        }
        bar.finish_and_clear();
        Ok(comparisons)
    }

    /// A bar where there is something to wait for.
    pub(super) fn progress(&self, ticks: u64) -> ProgressBar {
        if self.quiet || ticks < LONG {
            return ProgressBar::hidden();
        }
        shown(ProgressBar::new(ticks), BAR)
    }

    fn meet<T: lyapunov::Scalar + Space>(
        &self,
        name: &str,
        scene: &Scene,
        bar: &ProgressBar,
    ) -> Result<Comparison, End> {
        let watch = |ticks| {
            bar.inc(ticks);
            match End::if_interrupted() {
                Ok(()) => ControlFlow::Continue(()),
                Err(_) => ControlFlow::Break(()),
            }
        };
        let contestants = Contestants::<T>::of(self.stabilizers.iter().copied());
        Comparison::watched(name, scene, &contestants, &watch).map_err(|error| match error {
            CompareError::Stopped => End::Interrupted,
            error => End::input(error),
        })
    }
}

/// Writes everything, and only then lets it appear.
fn fill(
    folder: &Folder<'_>,
    scenes: &[PathBuf],
    comparisons: &[Comparison],
    text: &str,
) -> Result<(), End> {
    let mut outputs = Vec::new();
    let mut put = |name: &str, bytes: &[u8]| -> Result<(), OutputError> {
        let mut output = Output::create(&folder.path().join(name))?;
        output.write_all(bytes).map_err(|error| output.blame(error))?;
        outputs.push(output);
        Ok(())
    };
    for (name, comparison) in names(scenes).iter().zip(comparisons) {
        End::if_interrupted()?;
        let figure = comparison.figure();
        let picture = figure.to_png(2.0).map_err(End::internal)?;
        put(&format!("{name}.svg"), figure.to_svg().as_bytes()).map_err(End::input)?;
        put(&format!("{name}.png"), &picture).map_err(End::input)?;
    }
    put(RESULTS, text.as_bytes()).map_err(End::input)?;
    End::if_interrupted()?;
    folder.keep();
    outputs.into_iter().try_for_each(Output::keep).map_err(End::input)
}

/// The name of each scene's figure: that of its file, with a number where two are alike.
pub(super) fn names(scenes: &[PathBuf]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for scene in scenes {
        let stem = scene.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into());
        let numbered = (2..).map(|number| format!("{stem}-{number}"));
        let free = std::iter::once(stem.clone()).chain(numbered).find(|name| !names.contains(name));
        names.push(free.unwrap_or(stem));
    }
    names
}
