//! JSON document of teleoperator comparisons: `compare.json`.

use serde::Serialize;

use super::comparison::Comparison;
use crate::files::scene::Seed;
use crate::measure::teleoperation::{BAND, BOUND, Score};
use crate::show::json;

#[derive(Serialize)]
struct Document<'a> {
    /// The largest energy of a run that does not grow, as a multiple of the energy at the start.
    bound: f64,
    /// The largest kinetic energy in the last tenth of a run that settles, likewise.
    band: f64,
    teleoperators: Vec<Circumstances<'a>>,
    rows: Vec<Line<'a>>,
    /// The files that did not fit, with the reasons.
    #[serde(skip_serializing_if = "<[String]>::is_empty")]
    left_out: &'a [String],
}

/// Values that all rows of a teleoperator share.
#[derive(Serialize)]
struct Circumstances<'a> {
    teleoperator: &'a str,
    energy_start_mj: f64,
    /// What an ideal link rests with.
    force_ideal_n: f64,
    delay_ticks: u16,
    spread_ticks: u16,
    loss: f64,
    /// None: nothing is random.
    seed: Option<u64>,
    /// None: no limit.
    damping_cap: Option<f64>,
    compensation_speed_mm_per_s: f64,
    two_layer_level_mj: f64,
    two_layer_gain_ns_per_m_j: f64,
    two_layer_share: f64,
    wave_impedance_ns_per_m: f64,
    wave_filter_time_ms: f64,
}

#[derive(Serialize)]
struct Line<'a> {
    teleoperator: &'a str,
    #[serde(flatten)]
    score: &'a Score,
}

/// The comparisons as JSON, and the files that were `left_out` with the reasons; docs/teleoperation.md lists the keys.
pub(super) fn of(comparisons: &[Comparison], left_out: &[String]) -> String {
    let teleoperators = comparisons.iter().map(|Comparison { name, file, .. }| {
        let (cap, layers) = (file.stabilizer.damping_cap.get(), file.layers());
        Circumstances {
            teleoperator: name,
            energy_start_mj: 1e3 * file.stored_at_start(),
            force_ideal_n: file.ideal_force(),
            delay_ticks: file.channel.delay.get(),
            spread_ticks: file.channel.spread.get(),
            loss: file.channel.loss.get(),
            seed: file.channel.seed.map(Seed::get),
            damping_cap: cap.is_finite().then_some(cap),
            compensation_speed_mm_per_s: 1e3 * file.stabilizer.drift_compensated.speed.get(),
            two_layer_level_mj: 1e3 * layers.level,
            two_layer_gain_ns_per_m_j: layers.gain,
            two_layer_share: layers.share,
            wave_impedance_ns_per_m: file.wave_impedance(),
            wave_filter_time_ms: 1e3 * file.wave_filter_time(),
        }
    });
    let rows = comparisons.iter().flat_map(|comparison| {
        comparison.scores().map(|score| Line { teleoperator: &comparison.name, score })
    });
    let document = Document {
        bound: BOUND,
        band: BAND,
        teleoperators: teleoperators.collect(),
        rows: rows.collect(),
        left_out,
    };
    json::text(&document)
}
