//! `lyapunov map --refine`: the edge of bounded runs from few runs.

use std::path::Path;

use indicatif::ProgressBar;
use lyapunov_lab::map::{Bounds, Grid, Refined, Run};

use super::Map;
use crate::commands::folder::Folder;
use crate::commands::results::{Results, command_line, names};
use crate::commands::{End, shown, tell};
use crate::files::Inputs;

/// The file that `--json` prints.
const RESULTS: &str = "refined.json";

const BAR: &str = "{spinner} {human_pos} cells judged, {elapsed}";

impl Map {
    /// Finds the edge of bounded runs on `grid`.
    pub(super) fn refine(&self, grid: &Grid, run: &Run<'_>) -> Result<(), End> {
        let inputs = Inputs::scene(self.scene.as_deref().unwrap_or(Path::new("")), &grid.scene);
        let files = names(RESULTS, ["edge"], ["judged.csv"]);
        let folder = Folder::asked(self.out.as_deref(), files, &inputs)?;
        let bar = shown(ProgressBar::no_length(), BAR, self.quiet);
        let watch = |judged| {
            bar.inc(judged);
            End::if_interrupted().is_ok()
        };
        let refined = Refined::of(run, &watch).map_err(|error| self.ended(error))?;
        bar.finish_and_clear();
        let text = refined.to_json();
        if let Some(folder) = folder {
            let bounds = run.install(|| Bounds::of(grid));
            let page = refined.to_html(bounds.as_ref(), &command_line());
            let results = Results::new(page, RESULTS, &text).with_file("judged.csv", refined.csv());
            folder.fill(results.with_figure("edge", &refined.figure(bounds.as_ref()))?)?;
        }
        tell(self.json, self.quiet, text, refined)
    }
}
