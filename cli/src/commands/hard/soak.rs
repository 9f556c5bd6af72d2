//! The promises of `lyapunov hard` on a scene, and on random ones without end.

use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};

use indicatif::ProgressBar;
use lyapunov_lab::hard::faults::{SPACING, sweep};
use lyapunov_lab::hard::soak::{Soak, breach};
use lyapunov_lab::scene::Scene;
use lyapunov_lab::shell_word;

use super::Hard;
use crate::commands::folder::Folder;
use crate::commands::results::Results;
use crate::commands::{BAR, End, named, print, program, shown};
use crate::files::Inputs;

/// The file of the scene that is found.
const FOUND: &str = "soak.toml";

/// Time in minutes, above 0.
pub(super) fn minutes(given: &str) -> Result<Duration, String> {
    let span = given.parse().ok().filter(|minutes| *minutes > 0.0);
    let span = span.and_then(|minutes: f64| Duration::try_from_secs_f64(60.0 * minutes).ok());
    span.ok_or_else(|| {
        "not a time in minutes above 0 that a clock can count, such as 0.5".to_owned()
    })
}

impl Hard {
    /// Holds the promises on a scene.
    pub(super) fn hold(&self, path: &Path) -> Result<(), End> {
        let scene = Scene::load(path).map_err(End::input)?;
        let name = named(path);
        let scene = match self.stabilizer {
            None => scene,
            Some(member) if member.fits(&scene) => member
                .written_in(&scene, &[])
                .map_err(|error| End::input(format_args!("{name}: {error}")))?,
            Some(member) => {
                return Err(End::input(format_args!(
                    "{name}: does not suit `{member}`, or lacks what it is set by\n  = take another, or see docs/family.md"
                )));
            }
        };
        let broken = breach(&scene).map_err(|error| End::input(format_args!("{name}: {error}")))?;
        if let Some(broken) = broken {
            return Err(End::Failed(format!("{name}: {broken}")));
        }
        let faults =
            if scene.stabilizer.is_some() { self.faults(path, &scene)? } else { String::new() };
        match self.quiet {
            true => Ok(()),
            false => print(format_args!("{name}: every promise is kept\n{faults}")),
        }
    }

    /// Sweeps every fault through every tick of a scene.
    fn faults(&self, path: &Path, scene: &Scene) -> Result<String, End> {
        let name = named(path);
        let bar = shown(ProgressBar::new(SPACING), BAR, self.quiet);
        let (mut faults, mut recovery) = (0, 0);
        for first in 0..SPACING {
            End::if_interrupted()?;
            let swept = sweep(scene, &[first], u64::MAX);
            let swept = swept.map_err(|error| End::input(format_args!("{name}: {error}")))?;
            if let Some(found) = swept.found {
                return Err(End::Failed(format!("{name}: {found}")));
            }
            (faults, recovery) = (faults + swept.faults, recovery.max(swept.recovery));
            bar.inc(1);
        }
        bar.finish_and_clear();
        let ticks = if recovery == 1 { "tick" } else { "ticks" };
        Ok(format!(
            "after {faults} faults too; every sample is accepted again after {recovery} {ticks}\n"
        ))
    }

    /// Holds the promises on random scenes.
    pub(super) fn soak(&self, span: Duration) -> Result<(), End> {
        let soak = Soak { seed: self.seed, stabilizer: self.stabilizer };
        if let Some(name) = self.stabilizer.filter(|_| !soak.takes_part()) {
            return Err(End::input(format_args!(
                "`{name}` takes part in no random scene: they lack what it is set by\n  = write a scene for it, and give that"
            )));
        }
        let out = self.out.as_deref().unwrap_or(Path::new("."));
        let folder = Folder::claim(out, [FOUND], &Inputs::default())?;
        let (start, length) = (Instant::now(), span.as_millis() as u64);
        let bar = shown(ProgressBar::new(length), BAR, self.quiet);
        let soaked = soak.run(&mut |_| {
            let spent = start.elapsed();
            bar.set_position(length.min(spent.as_millis() as u64));
            if spent < span { End::go_on() } else { ControlFlow::Break(()) }
        });
        bar.finish_and_clear();
        let file = out.join(FOUND);
        let command = format!("{} hard {}", program(), shell_word(&file.to_string_lossy()));
        if let Some(found) = &soaked.found {
            let file = (FOUND.to_owned(), found.file(&command).into_bytes());
            // It may have been found after hours.
            folder.keep_all(Results::of(vec![file]))?;
        }
        if !self.quiet {
            print(if self.json { soaked.to_json() } else { soaked.to_string() })?;
        }
        match soaked.found {
            Some(_) => Err(End::Failed(format!("a promise is broken; it is again by: {command}"))),
            None => End::if_interrupted(),
        }
    }
}
