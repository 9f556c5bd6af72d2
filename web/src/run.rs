//! Runs of a scene from its start.

use lyapunov_lab::scene::Scene;
use lyapunov_lab::{Csv, Rollout, Row, Space, Summary, Verdict, in_space};

use crate::exchange::{answer, bytes};
use crate::map::place;
use crate::scene::{parsed, stabilized};

/// The most ticks of a run whose rows the page holds, 48 bytes each for three loops at once.
const MOST: u64 = 1_000_000;

/// Runs a scene; the output is its rows, as the command `run` writes them.
#[unsafe(no_mangle)]
pub extern "C" fn rows() -> u32 {
    answer(|text| {
        let scene = parsed(text)?;
        in_space!(scene, V => csv::<V>(&scene))
    })
}

fn csv<V: Space>(scene: &Scene) -> Result<Vec<u8>, String> {
    let rollout = Rollout::<V>::of(scene).map_err(|error| error.to_string())?;
    let written = || -> std::io::Result<Vec<u8>> {
        let mut csv = Csv::of(Vec::new(), scene)?;
        for tick in rollout {
            csv.write(&tick)?;
        }
        csv.into_inner()
    };
    written().map_err(|error| error.to_string())
}

/// Runs a scene under the stabilizer in the first line of the input.
///
/// The output is numbers: the verdict's place among all, the time since which the run has settled (NaN if it has not), the largest
/// force on the plant, the energy that the controller set out to dissipate, the least observed energy, the share of active
/// ticks, the number of rows that follow; then each row: time, position, force of the environment, force of the controller,
/// force on the plant, observed energy, in a space along its first axis.
#[unsafe(no_mangle)]
pub extern "C" fn trace() -> u32 {
    answer(|text| {
        let scene = stabilized(text)?;
        if scene.ticks() > MOST {
            return Err("more than a million ticks: shorten the duration".to_owned());
        }
        in_space!(scene, V => traced::<V>(&scene))
    })
}

fn traced<V: Space>(scene: &Scene) -> Result<Vec<u8>, String> {
    let mut summary = Summary::new(scene);
    let mut rows = Vec::new();
    for tick in Rollout::<V>::of(scene).map_err(|error| error.to_string())? {
        summary.add(&tick);
        let Row { t, x, f_env, f_ctl, f_act, observed_energy, .. } = Row::of(&tick);
        rows.extend([t, x, f_env, f_ctl, f_act, observed_energy]);
    }
    let active = summary.active as f64 / summary.rows.max(1) as f64;
    let head = [
        place(summary.verdict()).into(),
        summary.settled.unwrap_or(f64::NAN),
        summary.acting_peak,
        summary.asked,
        summary.observed_energy_least,
        active,
        summary.rows as f64,
    ];
    Ok(bytes(head.into_iter().chain(rows)))
}

/// The words of the verdicts, in their order, one on a line.
#[unsafe(no_mangle)]
pub extern "C" fn verdicts() -> u32 {
    answer(|_| Ok(Verdict::ALL.map(Verdict::word).join("\n").into_bytes()))
}
