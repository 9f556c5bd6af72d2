//! `lyapunov compare` of models of plants.

use std::io::{self, Write};
use std::ops::ControlFlow;
use std::path::PathBuf;

use lyapunov_lab::family::Members;
use lyapunov_lab::models::{
    CompareError, Comparison, Contestant, Model, Subject, document, report,
};
use lyapunov_lab::{Outputs, Scene};

use super::compare::{Compare, RESULTS, names};
use super::folder::Folder;
use super::{End, standard_output};

/// What is compared, each under the path as it was given.
pub(super) enum Subjects {
    Scenes(Vec<(String, Scene)>),
    Models(Vec<(String, Model)>),
}

impl Subjects {
    /// Reads files that are all scenes or all models.
    pub(super) fn load(paths: &[PathBuf]) -> Result<Self, End> {
        let (mut scenes, mut models) = (Vec::new(), Vec::new());
        for path in paths {
            let name = path.display().to_string();
            match Subject::load(path).map_err(End::input)? {
                Subject::Scene(scene) => scenes.push((name, *scene)),
                Subject::Model(model) => models.push((name, *model)),
            }
        }
        match (scenes.first(), models.first()) {
            (Some((scene, _)), Some((model, _))) => Err(End::input(format!(
                "{scene} is a scene and {model} a model of a plant\n  = their columns differ: compare them in two calls"
            ))),
            (_, None) => Ok(Self::Scenes(scenes)),
            (None, Some(_)) => Ok(Self::Models(models)),
        }
    }
}

/// Compares `models` as `asked`.
pub(super) fn run(asked: &Compare, models: &[(String, Model)]) -> Result<(), End> {
    if asked.by.is_some() {
        let message =
            "--by names a column of scenes\n  = the rows of a model keep their order: leave it out";
        return Err(End::input(message));
    }
    if asked.stabilizers != Members::standard() {
        let message = "--stabilizers names stabilizers of scenes\n  = of a model popc, lolc-decrease and lolc-decay are compared with none: leave it out";
        return Err(End::input(message));
    }
    let folder = asked.out.as_deref().map(|path| Folder::claim(path, RESULTS)).transpose()?;
    let ticks: u64 = models.iter().map(|(_, model)| model.ticks() + 1).sum();
    let bar = asked.progress(ticks * Contestant::ALL.len() as u64);
    let watch = |ticks| {
        bar.inc(ticks);
        match End::if_interrupted() {
            Ok(()) => ControlFlow::Continue(()),
            Err(_) => ControlFlow::Break(()),
        }
    };
    let compared = models.iter().map(|(name, model)| Comparison::of(name, model, &watch));
    let comparisons: Result<Vec<_>, _> = compared.collect();
    let comparisons = comparisons.map_err(|error| match error {
        CompareError::Stopped => End::Interrupted,
        error => End::internal(error),
    })?;
    bar.finish_and_clear();
    let text = document(&comparisons).map_err(End::internal)?;
    if let Some(folder) = folder {
        fill(&folder, &asked.scenes, &comparisons, &text)?;
    }
    let mut out = io::stdout().lock();
    if asked.json {
        return out.write_all(text.as_bytes()).map_err(standard_output);
    }
    let shown = if asked.quiet { &[][..] } else { &comparisons[..] };
    for (index, comparison) in shown.iter().enumerate() {
        let gap = if index == 0 { "" } else { "\n" };
        write!(out, "{gap}{comparison}").map_err(standard_output)?;
    }
    Ok(())
}

/// Writes everything, and only then lets it appear.
fn fill(
    folder: &Folder<'_>,
    models: &[PathBuf],
    comparisons: &[Comparison],
    text: &str,
) -> Result<(), End> {
    let mut outputs = Outputs::of(folder.path());
    for (name, comparison) in names(models).iter().zip(comparisons) {
        End::if_interrupted()?;
        let figure = comparison.figure();
        let picture = figure.to_png(2.0).map_err(End::internal)?;
        outputs.put(&format!("{name}.svg"), figure.to_svg()).map_err(End::input)?;
        outputs.put(&format!("{name}.png"), picture).map_err(End::input)?;
        outputs.put(&format!("{name}.csv"), comparison.csv()).map_err(End::input)?;
    }
    let given: Vec<String> = models.iter().map(|path| path.display().to_string()).collect();
    let command = format!("lyapunov compare {} --out {}", given.join(" "), folder.path().display());
    outputs.put("report.html", report(comparisons, &command)).map_err(End::input)?;
    outputs.put(RESULTS, text).map_err(End::input)?;
    End::if_interrupted()?;
    folder.keep();
    outputs.keep().map_err(End::input)
}
