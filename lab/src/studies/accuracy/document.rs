//! Accuracy study as JSON.

use serde::Serialize;

use super::Study;
use super::reference::Second;
use super::study::Row;
use crate::show::csv;
use crate::show::json;

#[derive(Serialize)]
struct Document<'a> {
    /// The keys that come from a clock.
    not_deterministic: [&'static str; 6],
    scene: &'a str,
    reference: Reference,
    lyapunov_exponent_per_s: Option<f64>,
    chaotic: bool,
    /// The errors count up to this time.
    errors_until_s: f64,
    /// A trace is believed while its error is no larger.
    believed_within_m: f64,
    rows: Vec<Line>,
    ledger: Vec<LedgerLine>,
    #[serde(skip_serializing_if = "Option::is_none")]
    target: Option<Target>,
}

#[derive(Serialize)]
struct Reference {
    first: &'static str,
    second: &'static str,
    distance_m: f64,
    agree_until_s: f64,
}

#[derive(Serialize)]
struct Line {
    propagator: &'static str,
    steps_per_tick: Option<u32>,
    tolerance: Option<f64>,
    scalar: &'static str,
    max_error: Option<f64>,
    error_is_known: bool,
    ns_per_simulated_second: f64,
    spread_ns: f64,
    horizon_s: Option<f64>,
    pareto: bool,
}

#[derive(Serialize)]
struct LedgerLine {
    scalar: &'static str,
    ledger: &'static str,
    ticks: u32,
    error_j: f64,
    ns_per_tick: f64,
    spread_ns: f64,
}

#[derive(Serialize)]
struct Target {
    metres: f64,
    /// The fastest setting that meets the target.
    cheapest: Option<Line>,
    /// The most accurate setting, if none meets the target.
    nearest: Option<Line>,
}

impl Line {
    fn of(row: &Row) -> Self {
        let integrator = row.setting.integrator;
        Self {
            propagator: integrator.name(),
            steps_per_tick: integrator.steps_per_tick(),
            tolerance: integrator.tolerance(),
            scalar: row.setting.number.name(),
            max_error: row.max_error,
            error_is_known: row.is_known,
            ns_per_simulated_second: row.time.median,
            spread_ns: row.time.spread,
            horizon_s: row.horizon,
            pareto: row.is_on_front,
        }
    }
}

impl Study {
    /// The study as JSON, and with a `target` in m the setting that meets it; docs/accuracy.md lists the keys.
    pub fn to_json(&self, target: Option<f64>) -> String {
        let (basis, period) = (&self.basis, self.scene.period());
        let seconds = |ticks: usize| ticks.saturating_sub(1) as f64 * period;
        let ledger = self.ledger.iter().map(|row| LedgerLine {
            scalar: row.scalar,
            ledger: row.ledger,
            ticks: super::ledger::TICKS,
            error_j: row.error,
            ns_per_tick: row.time.median,
            spread_ns: row.time.spread,
        });
        let target = target.map(|metres| {
            let cheapest = self.cheapest(metres);
            let nearest = if cheapest.is_some() { None } else { self.nearest() };
            Target { metres, cheapest: cheapest.map(Line::of), nearest: nearest.map(Line::of) }
        });
        let document = Document {
            not_deterministic: [
                "ns_per_simulated_second",
                "ns_per_tick",
                "spread_ns",
                "pareto",
                "target",
                "the order of rows",
            ],
            scene: &self.name,
            reference: Reference {
                first: "exact map in double-double",
                second: basis.second.name(),
                distance_m: basis.distance,
                agree_until_s: seconds(basis.agreeing),
            },
            lyapunov_exponent_per_s: basis.growth.exponent,
            chaotic: basis.growth.chaotic,
            errors_until_s: seconds(basis.ticks),
            believed_within_m: basis.believed,
            rows: self.rows.iter().map(Line::of).collect(),
            ledger: ledger.collect(),
            target,
        };
        json::text(&document)
    }

    /// The settings as comma-separated values, the fastest first.
    pub fn csv(&self) -> String {
        csv::records(self.rows.iter().map(Line::of))
    }
}

impl Second {
    /// The name in JSON.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Extrapolation => "extrapolation in double-double",
            Self::Adaptive => "dop853 with located switches",
            Self::Double => "exact map in f64",
        }
    }
}
