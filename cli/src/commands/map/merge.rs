//! The command `lyapunov map merge`.

use std::path::PathBuf;

use clap::Args;
use lyapunov_lab::map::{
    Bounds, MergeError, Shard, areas, document, figure_names, merge, table_name,
};

use super::{MERGED, RESULTS, results};
use crate::commands::folder::Folder;
use crate::commands::results::{command_line, names};
use crate::commands::{End, named, tell};
use crate::files::{Inputs, Output};

/// Put the shards of a map together.
///
/// Exit status: 0 done, 1 internal error, 2 bad input, 130 interrupted.
#[derive(Args, Debug)]
pub(crate) struct Merge {
    /// The tables of all shards (map-i-of-n.csv), or folders that hold them.
    #[arg(required = true, value_name = "PATH")]
    paths: Vec<PathBuf>,
    /// Write the map into this folder; made if not there.
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    /// Print map.json instead of the table.
    #[arg(long, conflicts_with = "quiet")]
    json: bool,
    /// Print nothing but errors.
    #[arg(long)]
    quiet: bool,
}

impl Merge {
    pub(super) fn run(&self) -> Result<(), End> {
        let tables = self.tables()?;
        let inputs = Inputs::of("a shard", &tables);
        let files = names(RESULTS, figure_names(), [table_name(Shard::WHOLE)]);
        let folder = Folder::claim(&self.out, files, &inputs)?;
        let table = folder.path().join(table_name(Shard::WHOLE));
        let mut output = Output::create(&table).map_err(End::input)?;
        let go_on = || End::if_interrupted().is_ok();
        let survey = merge(&tables, &mut output, &table, &go_on).map_err(|error| match error {
            MergeError::Stopped => End::Interrupted,
            error => End::input(error),
        })?;
        let bounds = Bounds::of(survey.grid());
        let text = document(&survey, bounds.as_ref(), None);
        let results = results(&survey, bounds.as_ref(), &text, [&command_line(), MERGED])?;
        folder.fill(results.with_rows(output))?;
        tell(self.json, self.quiet, text, areas(&survey))
    }

    /// Paths of the tables, with those in the folders that were named.
    fn tables(&self) -> Result<Vec<PathBuf>, End> {
        let mut tables = Vec::new();
        for path in &self.paths {
            if path.is_file() || !path.exists() {
                tables.push(path.clone());
                continue;
            }
            if !path.is_dir() {
                let remedy = "give a file: it is read more than once";
                return Err(End::input(format!("{} is no file\n  = {remedy}", named(path))));
            }
            let refuse = |error| End::input(format!("{} cannot be read: {error}", named(path)));
            let mut found = Vec::new();
            for entry in path.read_dir().map_err(refuse)? {
                let entry = entry.map_err(refuse)?.path();
                let name = entry.file_name().unwrap_or_default().to_string_lossy().into_owned();
                if name.starts_with("map-")
                    && name.ends_with(".csv")
                    && !name.ends_with(".part.csv")
                {
                    found.push(entry);
                }
            }
            found.sort();
            tables.extend(found);
        }
        if tables.is_empty() {
            return Err(End::input(
                "there is no table of a shard\n  = name the files map-i-of-n.csv, or folders that hold them",
            ));
        }
        Ok(tables)
    }
}
