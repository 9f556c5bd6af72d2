//! The promises that every scene keeps.

use lyapunov::{ParameterError, Scalar};
use nalgebra::SVector;

use super::breach::Breach;
use super::ticks::{Ran, ticks};
use crate::files::Scene;
use crate::files::scene::Integrator;
use crate::measure::balance::Trial;
use crate::measure::runs::{AllMeasures, Judged, Measures, Runs, has_lanes};
use crate::simulate::{F64x8, Instructions, Space};
use crate::studies::hard::looped::from_start;

/// Share of the energies moved that may be left over: that of a rounding on every tick, and more.
const REST: f64 = 1e-9;

/// Distances between starts, as shares of the start.
const STEP: f64 = 0.03;

/// The first promise that the loop of `scene` breaks, whatever scalar it names; none if it keeps them all.
///
/// docs/hard.md lists them. The loop runs in `f64`, in `f32` if its numbers fit, and, where it has lanes, from eight
/// starts on lanes, of which the first and the last are compared with scalar runs.
///
/// # Errors
/// A parameter that is right by itself but out of the range of `f64`, alone or with others.
pub fn breach(scene: &Scene) -> Result<Option<Breach>, ParameterError> {
    match scene.dimensions() {
        1 => on_a_line(scene),
        2 => alone::<SVector<f64, 2>, SVector<f32, 2>>(scene),
        _ => alone::<SVector<f64, 3>, SVector<f32, 3>>(scene),
    }
}

fn on_a_line(scene: &Scene) -> Result<Option<Breach>, ParameterError> {
    let broken = alone::<f64, f32>(scene)?;
    if broken.is_some() || !has_lanes(scene, &scene.stabilizer) {
        return Ok(broken);
    }
    let start = |lane| from_start(scene, 1.0 - STEP * lane as f64);
    let starts: Vec<Scene> = (0..F64x8::LANES).map(start).collect();
    let lanes = ticks::<F64x8>(&starts)?;
    let broken = starts.iter().zip(&lanes).find_map(|(scene, ran)| law(scene, "lanes of f64", ran));
    if broken.is_some() {
        return Ok(broken);
    }
    for lane in [0, F64x8::LANES - 1] {
        let alone = ticks::<f64>(&starts[lane..=lane])?;
        if alone.iter().any(|ran| ran.bits != lanes[lane].bits) {
            return Ok(Some(Breach::Lane { lane }));
        }
    }
    measures(&starts)
}

/// The promises of scalar runs.
fn alone<D: Space, S: Space>(scene: &Scene) -> Result<Option<Breach>, ParameterError> {
    let scenes = std::slice::from_ref(scene);
    let double = ticks::<D>(scenes)?.pop();
    // A scene whose numbers do not fit f32 is not run in f32.
    let single = ticks::<S>(scenes).ok().and_then(|mut ran| ran.pop());
    let laws = [("f64", &double), ("f32", &single)];
    let broken = laws.iter().find_map(|(numbers, ran)| law(scene, numbers, ran.as_ref()?));
    if broken.is_some() {
        return Ok(broken);
    }
    if let [Some(double), Some(single)] =
        [&double, &single].map(|ran| runs_away(scene, ran.as_ref()?))
        && double != single
        && only_in_one::<D, S>(scene, [double, single])?
    {
        return Ok(Some(Breach::RunsAway { numbers: if double { "f64" } else { "f32" } }));
    }
    energies::<D>(scene)
}

/// The first law that a run broke.
fn law(scene: &Scene, numbers: &'static str, ran: &Ran) -> Option<Breach> {
    // The laws are those of a stabilizer; an uncapped run can leave the range of the scalar within one tick.
    if scene.stabilizer.is_none() || is_uncapped(scene) && ran.tally.out_of_range.is_some() {
        return None;
    }
    ran.tally.broken.map(|(law, tick)| Breach::Law { numbers, law, tick })
}

/// Whether nothing limits the damping, so that its effect depends on rounding.
fn is_uncapped(scene: &Scene) -> bool {
    scene.written_cap().is_some_and(f64::is_infinite)
}

/// Whether the swing of the last quarter is far beyond what the scene starts with (true) or near it (false); none in
/// between, and of a scene of which rounding decides. A loop that left the range of its scalar is judged by all of its
/// swing: no position may be known at its end.
fn runs_away(scene: &Scene, ran: &Ran) -> Option<bool> {
    if is_uncapped(scene) || scene.environment.wall().is_none() {
        return None;
    }
    let [position, velocity, rest] =
        [&scene.initial.position, &scene.initial.velocity, &scene.operator.rest]
            .map(|it| it.get().abs());
    let size = position + rest + velocity * scene.duration.get();
    let tally = &ran.tally;
    let swing = if tally.out_of_range.is_some() { tally.swing } else { tally.late_swing };
    match swing / size {
        share if share > 1e4 || !share.is_finite() => Some(true),
        share if share < 10.0 => Some(false),
        _ => None,
    }
}

/// Whether the loop runs away in one scalar only from seven starts next to its own as well: what one start shows may be a
/// wall that is met or missed by a rounding.
fn only_in_one<D: Space, S: Space>(scene: &Scene, away: [bool; 2]) -> Result<bool, ParameterError> {
    for number in 1..8 {
        let near = from_start(scene, 1.0 - STEP * f64::from(number));
        let scenes = std::slice::from_ref(&near);
        let found = [ticks::<D>(scenes)?, ticks::<S>(scenes)?];
        if found.map(|mut ran| runs_away(&near, &ran.pop()?)) != away.map(Some) {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Whether the energies by cause add up, as `explain` tells them.
fn energies<D: Space>(scene: &Scene) -> Result<Option<Breach>, ParameterError> {
    let Trial { whole, moved, .. } = Trial::of::<D>(scene)?;
    let is_exact = scene.integrator == Integrator::Exact;
    let closes = !is_exact || whole.closing.abs() <= REST * moved;
    Ok((!closes).then_some(Breach::Energies { rest: whole.closing, moved }))
}

/// Whether a map measures on lanes what it measures one by one, with the verdict of `explain`.
fn measures(starts: &[Scene]) -> Result<Option<Breach>, ParameterError> {
    let last = starts.len() - 1;
    let ends = [starts[0].clone(), starts[last].clone()];
    let lanes = measured(starts, Some(Instructions::Base))?;
    let scalars = measured(&ends, None)?;
    for (lane, scalar) in [(0, 0), (last, 1)] {
        let [on_lane, alone] = [&lanes[lane], &scalars[scalar]];
        if (on_lane.verdict, on_lane.reading) != (alone.verdict, alone.reading) {
            return Ok(Some(Breach::Measures { lane }));
        }
        let (map, explain) = (alone.verdict, Trial::of::<f64>(&ends[scalar])?.verdict);
        if map != explain {
            return Ok(Some(Breach::Verdicts { map, explain }));
        }
    }
    Ok(None)
}

fn measured(
    scenes: &[Scene],
    instructions: Option<Instructions>,
) -> Result<Vec<Judged<Measures>>, ParameterError> {
    let tables: Vec<_> = scenes.iter().map(|scene| scene.stabilizer).collect();
    let runs = Runs { scenes, told: scenes, tables: &tables, instructions };
    let done = runs.measured::<AllMeasures>(&|| true).map_err(|(_, error)| error)?;
    // They are never stopped, so there always is a result.
    Ok(done.unwrap_or_default())
}
