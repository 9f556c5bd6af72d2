//! The command `lyapunov compare` of scenes.

mod subjects;

use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::str::FromStr;

use clap::Args;
use indicatif::ProgressBar;
use lyapunov_figures::Figure;
use lyapunov_lab::compare::{
    Broken, Column, CompareError, Comparison, Energies, Entrants, TradeOff, csv, document, report,
};
use lyapunov_lab::family::StabilizerNames;
use lyapunov_lab::scene::Scene;
use lyapunov_lab::tune::{Objective, Tuned, Tuning};
use lyapunov_lab::{Space, in_space, models, teleoperation};

use self::subjects::Subjects;
use super::folder::Folder;
use super::left_out::LeftOut;
use super::results::{self, Results, command_line};
use super::tune::tune;
use super::{BAR, End, advance, shown, tell};
use crate::files::Inputs;

/// Ticks in all from which on a progress bar is worth showing.
const LONG: u64 = 1 << 20;

/// The file that `--json` prints.
const RESULTS: &str = "compare.json";

/// The file of its rows.
const ROWS: &str = "compare.csv";

/// Compare stabilizers on the same scenes.
///
/// Prints a table for each scene. A name takes the scene's own table of that name if there is one; else its numbers follow
/// from the loop, as docs/family.md says, and damping_cap, work and ledger are those of the table that the scene has. A
/// `-` stands where a column does not apply; docs/compare.md defines the columns, docs/verdicts.md the verdicts.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Compare {
    /// The scene files, or files of models or of teleoperators, TOML.
    #[arg(required = true, value_name = "SCENE")]
    scenes: Vec<PathBuf>,
    /// Who takes part, by name, or all: of scenes docs/family.md has the names, and default are none, popc and lolc with
    /// each candidate; of models docs/any-plant.md and of teleoperators docs/teleoperation.md, and default are all.
    #[arg(long, value_name = "NAMES")]
    stabilizers: Option<String>,
    /// Tune each of them on each scene first, for this objective (lyapunov tune), and let the tuned ones take part too.
    #[arg(long, value_name = "TERMS", num_args = 0..=1, require_equals = true,
        default_missing_value = "settling")]
    tuned: Option<Objective>,
    /// Write report.html, compare.json, compare.csv and figures of each file (SVG, PNG and CSV) into this folder; made if not there.
    ///
    /// Of each scene: positions and sums over time, forces over time, energy by cause, and on how many walls the run stays
    /// bounded against how transparent they are, which takes 144 further runs of each stabilizer. Of others one figure.
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Sort by this column, the smallest first; by default the order of registration.
    ///
    /// A column is named by its key in compare.json, such as settling_time_s or ns_per_step.
    #[arg(long, value_name = "COLUMN")]
    by: Option<Column>,
    /// Print compare.json instead of tables.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Compare {
    pub(crate) fn run(&self) -> Result<(), End> {
        let mut left_out = LeftOut::of(self.scenes.len());
        // Names that are wrong here may be right for another kind of file: they are judged once the kind is known.
        let entrants = self.entrants().ok().flatten().unwrap_or_default();
        let scenes = match Subjects::load(&self.scenes, &entrants, &mut left_out)? {
            Subjects::Scenes(scenes) => scenes,
            _ if self.tuned.is_some() => {
                let remedy = "leave it away for files of models and of teleoperators";
                return Err(End::input(format!("--tuned is for scenes\n  = {remedy}")));
            }
            Subjects::Models(models) => {
                return subjects::run::<models::Comparison>(self, &models, left_out);
            }
            Subjects::Teleoperators(them) => {
                return subjects::run::<teleoperation::Comparison>(self, &them, left_out);
            }
        };
        let named = self.entrants()?.unwrap_or_else(StabilizerNames::standard);
        let folder = self.out.as_deref().map(|path| self.claim(path, &scenes)).transpose()?;
        let compared = self.compare(&scenes, &named, &mut left_out)?;
        let (comparisons, answers): (Vec<_>, Vec<_>) = compared.into_iter().unzip();
        let text = document(&comparisons, left_out.reasons());
        if let Some(folder) = folder {
            fill(&folder, &comparisons, &answers, &left_out, &text)?;
        }
        self.tell(&comparisons, &text)?;
        left_out.end()
    }

    /// The folder at `path`, for the files of all `scenes`.
    fn claim<'a>(&self, path: &'a Path, scenes: &[(String, Scene)]) -> Result<Folder<'a>, End> {
        let inputs = Inputs::of("the scene", &self.scenes);
        let inputs = scenes.iter().fold(inputs, |inputs, (_, scene)| inputs.and_named_by(scene));
        let files = names(scenes.iter().map(|(name, _)| &name[..]));
        let named = |questions: &[&str], ending: &str| -> Vec<String> {
            let pairs = files.iter().flat_map(|name| questions.iter().map(move |it| (name, it)));
            pairs.map(|(name, question)| figure_name(name, question) + ending).collect()
        };
        let figures = named(&["", "force", "energy", "trade-off"], "");
        let mut rows = named(&["energy", "trade-off"], ".csv");
        rows.push(ROWS.to_owned());
        Folder::claim(path, results::names(RESULTS, figures, rows), &inputs)
    }

    fn tell(&self, comparisons: &[Comparison], text: &str) -> Result<(), End> {
        let mut said: Vec<String> = comparisons.iter().map(ToString::to_string).collect();
        let broken = Broken::of(comparisons);
        if comparisons.len() > 1 && !broken.is_empty() {
            said.push(broken.to_string());
        }
        tell(self.json, self.quiet, text, said.join("\n"))
    }

    /// The entrants that are named, if any: the kind of file says who has a name.
    fn entrants<N>(&self) -> Result<Option<N>, End>
    where
        N: FromStr<Err: Display>,
    {
        let named = self.stabilizers.as_deref().map(str::parse).transpose();
        named.map_err(|error| End::input(format!("--stabilizers: {error}")))
    }

    /// The comparison on each of `scenes` that it fits.
    fn compare(
        &self,
        scenes: &[(String, Scene)],
        named: &StabilizerNames,
        left_out: &mut LeftOut,
    ) -> Result<Vec<(Comparison, Answers)>, End> {
        let ticks = |scene: &Scene| {
            let once = scene.ticks() + 1;
            let drawn = || TradeOff::runs(scene).map_or(once, |(runs, ticks)| once + runs * ticks);
            once + self.out.as_ref().map_or(0, |_| drawn())
        };
        let mut met = Vec::new();
        for (name, scene) in scenes {
            let tuned = self.tuned(name, scene, named);
            met.extend(left_out.unless(tuned)?.map(|tuned| (name, scene, tuned)));
        }
        let entrants = |tuned: &[Tuned]| (named.len() + tuned.len()) as u64;
        let ticks = met.iter().map(|(_, scene, tuned)| entrants(tuned) * ticks(scene));
        let bar = self.progress(ticks.sum());
        let mut compared = Vec::new();
        for (name, scene, tuned) in &met {
            bar.set_message(format!("{name}: "));
            let one = in_space!(scene, Axes => {
                self.meet(name, scene, &entered::<Axes>(named, scene, tuned), &bar)
            });
            compared.extend(left_out.unless(one)?);
        }
        bar.finish_and_clear();
        left_out.unless_all(compared)
    }

    /// The tuned stabilizers that take part: those with a number to tune.
    fn tuned(&self, name: &str, scene: &Scene, named: &StabilizerNames) -> Result<Vec<Tuned>, End> {
        let Some(objective) = self.tuned else { return Ok(Vec::new()) };
        let tuning = Tuning { objective, ..Tuning::default() };
        let mut tuned = tune(&tuning, name, scene, named, self.quiet)?;
        tuned.retain(|one| !one.settings[1].numbers().is_empty());
        Ok(tuned)
    }

    /// Progress bar, hidden for a short comparison.
    fn progress(&self, ticks: u64) -> ProgressBar {
        shown(ProgressBar::new(ticks), BAR, self.quiet || ticks < LONG)
    }

    fn meet<V: Space>(
        &self,
        name: &str,
        scene: &Scene,
        entrants: &Entrants<V>,
        bar: &ProgressBar,
    ) -> Result<(Comparison, Answers), End> {
        let watch = |ticks| advance(bar, ticks);
        let refused = |error| match error {
            CompareError::Stopped => End::Interrupted,
            error => End::input(error),
        };
        let mut comparison = Comparison::watched(name, scene, entrants, &watch).map_err(refused)?;
        if let Some(column) = self.by {
            comparison.sort_by(column);
        }
        let mut answers = Answers::default();
        if self.out.is_some() {
            let energies = Energies::of(&comparison, entrants, &watch).map_err(refused)?;
            let (figure, rows) = (energies.figure(), energies.csv());
            answers.0.push(Answer { question: "energy", figure, rows, note: None });
            let trade_off = TradeOff::of(&comparison, entrants, &watch).map_err(refused)?;
            if let Some(trade_off) = trade_off {
                let (figure, rows) = (trade_off.figure(), trade_off.csv());
                answers.0.push(Answer {
                    question: "trade-off",
                    figure,
                    rows,
                    note: trade_off.note(),
                });
            }
        }
        Ok((comparison, answers))
    }
}

/// The stabilizers that are `named`, then the `tuned` ones.
fn entered<V: Space>(named: &StabilizerNames, scene: &Scene, tuned: &[Tuned]) -> Entrants<V> {
    tuned.iter().fold(Entrants::of(named.on(scene)), |entrants, one| {
        let (name, setting) = (format!("{} tuned", one.name), one.settings[1].clone());
        entrants.with_fitted(name, one.name, move |scene| setting.fitted(scene))
    })
}

/// Figures that take runs of their own.
#[derive(Default)]
struct Answers(Vec<Answer>);

struct Answer {
    question: &'static str,
    figure: Figure,
    /// Its numbers, as comma-separated values.
    rows: String,
    /// A remark that the figure needs.
    note: Option<String>,
}

fn fill(
    folder: &Folder<'_>,
    comparisons: &[Comparison],
    answers: &[Answers],
    left_out: &LeftOut,
    text: &str,
) -> Result<(), End> {
    let of = |(one, answers): (&Comparison, &Answers)| {
        let own = [("", one.figure()), ("force", one.forces())];
        let own = own.map(|(question, figure)| (question, figure, caption(question).to_owned()));
        let others = answers.0.iter().map(|Answer { question, figure, note, .. }| {
            let note = note.as_ref().map_or_else(String::new, |note| format!(" {note}."));
            (*question, figure.clone(), format!("{}{note}", caption(question)))
        });
        own.into_iter().chain(others).collect()
    };
    let drawn: Vec<Vec<(&str, Figure, String)>> = comparisons.iter().zip(answers).map(of).collect();
    let told = comparisons.iter().zip(&drawn).map(|(one, figures)| {
        let figures = figures.iter().map(|(_, figure, caption)| (figure, &caption[..]));
        (one, figures.collect::<Vec<_>>())
    });
    let page = report(&told.collect::<Vec<_>>(), left_out.reasons(), &command_line());
    let mut results = Results::new(page, RESULTS, text).with_file(ROWS, csv(comparisons));
    let files = names(comparisons.iter().map(|one| &one.name[..]));
    for ((name, figures), answers) in files.iter().zip(&drawn).zip(answers) {
        for (question, figure, _) in figures {
            End::if_interrupted()?;
            results = results.with_figure(&figure_name(name, question), figure)?;
        }
        for Answer { question, rows, .. } in &answers.0 {
            results = results.with_file(figure_name(name, question) + ".csv", &rows[..]);
        }
    }
    folder.fill(results)
}

/// The name of the figure that answers a question about the scene whose files begin with `name`.
fn figure_name(name: &str, question: &str) -> String {
    let gap = if question.is_empty() { "" } else { "." };
    format!("{name}{gap}{question}")
}

/// The sentence under the figure that answers a question.
fn caption(question: &str) -> &'static str {
    match question {
        "force" => "What the hand feels: the forces on the plant.",
        "energy" => {
            "Where the energy came from, and where it went: two bars of one length for each run that does not grow."
        }
        "trade-off" => {
            "What boundedness costs in transparency: the share of walls on which the run stays bounded, and the force \
             error on the common walls: those that every stabilizer holds and that do not hold without one."
        }
        _ => {
            "Whether it settles. Equal curves are drawn once; that of a run that grows ends where it leaves the range of \
             the others."
        }
    }
}

/// Names that the files of each scene begin with: the scene file's own, with a number where two are equal.
///
/// They contain no dot, since the name of a figure follows one; so no two files get the same name.
fn names<'a>(scenes: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for scene in scenes {
        let stem =
            Path::new(scene).file_stem().unwrap_or_default().to_string_lossy().replace('.', "-");
        let numbered = (2..).map(|number| format!("{stem}-{number}"));
        let free = std::iter::once(stem.clone()).chain(numbered).find(|name| !names.contains(name));
        names.push(free.unwrap_or(stem));
    }
    names
}
