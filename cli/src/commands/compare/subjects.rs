//! The command `lyapunov compare` of models and teleoperators.

use std::path::PathBuf;

use lyapunov_lab::Scene;
use lyapunov_lab::compare::{Compared, Names, RunError, Sheet, Subject, page};
use lyapunov_lab::models::Model;
use lyapunov_lab::teleoperation::{self, Teleoperator};

use super::{Compare, RESULTS, ROWS, names};
use crate::commands::folder::Folder;
use crate::commands::left_out::LeftOut;
use crate::commands::results::{self, Results, command_line};
use crate::commands::{End, advance, named, tell};
use crate::files::Inputs;

/// Files to compare, each under the path as it was given.
pub(super) enum Subjects {
    Scenes(Vec<(String, Scene)>),
    Models(Vec<(String, Model)>),
    Teleoperators(Vec<(String, Teleoperator)>),
}

impl Subjects {
    /// Reads files, which must all be of one kind, as far as they can be read; `entrants` are those of teleoperators.
    pub(super) fn load(
        paths: &[PathBuf],
        entrants: &Names<teleoperation::Entrant>,
        left_out: &mut LeftOut,
    ) -> Result<Self, End> {
        let (mut scenes, mut models, mut teleoperators) = (Vec::new(), Vec::new(), Vec::new());
        for path in paths {
            let name = named(path);
            match left_out.unless(Subject::load(path, entrants).map_err(End::input))? {
                Some(Subject::Scene(scene)) => scenes.push((name, *scene)),
                Some(Subject::Model(model)) => models.push((name, *model)),
                Some(Subject::Teleoperator(it)) => teleoperators.push((name, *it)),
                None => {}
            }
        }
        if scenes.is_empty() && models.is_empty() && teleoperators.is_empty() {
            return left_out.unless_all(Vec::new()).map(Self::Scenes);
        }
        let firsts = [
            scenes.first().map(|(name, _)| format!("{name} is a scene")),
            models.first().map(|(name, _)| format!("{name} is a model of a plant")),
            teleoperators.first().map(|(name, _)| format!("{name} is a teleoperator")),
        ];
        match &firsts.into_iter().flatten().collect::<Vec<_>>()[..] {
            [one, other, ..] => Err(End::input(format!(
                "{one} and {other}\n  = their columns differ: compare them in calls of their own"
            ))),
            _ if !models.is_empty() => Ok(Self::Models(models)),
            _ if !teleoperators.is_empty() => Ok(Self::Teleoperators(teleoperators)),
            _ => Ok(Self::Scenes(scenes)),
        }
    }
}

/// Compares `files` as `asked`.
pub(super) fn run<C: Compared>(
    asked: &Compare,
    files: &[(String, C::File)],
    left_out: LeftOut,
) -> Result<(), End> {
    let noun = C::NOUN;
    if asked.by.is_some() {
        return Err(End::input(format!(
            "--by names a column of scenes\n  = the rows of a {noun} keep their order: leave it out"
        )));
    }
    let entrants: Names<C::Entrant> = asked.entrants()?.unwrap_or_default();
    let inputs = Inputs::of("a compared file", &asked.scenes);
    let files_of = beside_rows(files.iter().map(|(name, _)| &name[..]));
    let rows = files_of.iter().map(|name| format!("{name}.csv"));
    let rows = rows.chain([ROWS.to_owned()]);
    let outputs = results::names(RESULTS, &files_of, rows);
    let folder = Folder::asked(asked.out.as_deref(), outputs, &inputs)?;
    let ticks: u64 = files.iter().map(|(_, file)| C::ticks(file)).sum();
    let bar = asked.progress(ticks * entrants.len() as u64);
    let watch = |ticks| advance(&bar, ticks);
    let compared = files.iter().map(|(name, file)| C::of(name, file, &entrants, &watch));
    let comparisons: Result<Vec<_>, _> = compared.collect();
    let comparisons = comparisons.map_err(|error| match error {
        RunError::Stopped => End::Interrupted,
        error => End::internal(error),
    })?;
    bar.finish_and_clear();
    let text = C::document(&comparisons, left_out.reasons());
    let sheets: Vec<Sheet> = comparisons.iter().map(C::sheet).collect();
    if let Some(folder) = folder {
        let page = page::<C>(&sheets, left_out.reasons(), &command_line());
        let results = Results::new(page, RESULTS, &text);
        fill(&folder, results.with_file(ROWS, C::rows(&comparisons)), &sheets)?;
    }
    let said: Vec<String> = sheets.iter().map(ToString::to_string).collect();
    tell(asked.json, asked.quiet, text, said.join("\n"))?;
    left_out.end()
}

fn fill(folder: &Folder<'_>, mut results: Results, sheets: &[Sheet]) -> Result<(), End> {
    let files_of = beside_rows(sheets.iter().map(|sheet| &sheet.name[..]));
    for (name, sheet) in files_of.iter().zip(sheets) {
        End::if_interrupted()?;
        results = results.with_figure(name, &sheet.figure)?;
        results = results.with_file(format!("{name}.csv"), &sheet.csv[..]);
    }
    folder.fill(results)
}

/// The beginning of the names of the output files for each of `files`; none is that of the rows.
fn beside_rows<'a>(files: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    names(std::iter::once(ROWS).chain(files)).split_off(1)
}
