//! Marks: the demands on exact propagation.

use serde::Serialize;

use crate::contest::Line;
use crate::row::{Origin, Setting};

/// Demand, and the measured value.
#[derive(Serialize)]
pub(crate) struct Mark {
    pub(crate) demand: String,
    /// The row that decided, by its name in reports.
    pub(crate) by: Option<String>,
    /// None if the row that decides was not run.
    pub(crate) found: Option<f64>,
    pub(crate) met: Option<bool>,
}

impl Mark {
    fn new(demand: &str, decisive: Option<(&Line, f64)>, met: impl Fn(f64) -> bool) -> Self {
        Self {
            demand: demand.into(),
            by: decisive.map(|(line, _)| line.id()),
            found: decisive.map(|(_, found)| found),
            met: decisive.map(|(_, found)| met(found)),
        }
    }

    /// All marks; the first of `lines` is the exact one, the second that on lanes.
    pub(crate) fn all(lines: &[Line]) -> Vec<Self> {
        let (exact, lanes) = (&lines[0], &lines[1]);
        let below = |error: f64, exact: &Line| {
            let over = |line: &'_ Line| line.over(exact);
            let crates = lines.iter().filter(|line| line.origin == Origin::Crate);
            let good = crates.filter(|line| line.error < error);
            let fastest = good.min_by(|one, other| over(one).total_cmp(&over(other)));
            fastest.map(|line| (line, over(line)))
        };
        let mujoco = lines.iter().filter(|line| line.method == "MuJoCo RK4");
        let apart = |line: &&Line| (line.error / 3e-9).ln().abs();
        let mujoco = mujoco.min_by(|one, other| apart(one).total_cmp(&apart(other)));
        vec![
            Self::new("exact: error, m, <= 1e-12", Some((exact, exact.error)), |it| it <= 1e-12),
            Self::new("fastest crate below 1e-9 m over exact >= 55", below(1e-9, exact), |it| {
                it >= 55.0
            }),
            Self::new("the same over a lane of 8 >= 100", below(1e-9, lanes), |it| it >= 100.0),
            Self::new("fastest crate below 1e-6 m over exact >= 30", below(1e-6, exact), |it| {
                it >= 30.0
            }),
            Self::new(
                "MuJoCo RK4 at about 3e-9 m over exact >= 20,000",
                mujoco.map(|line| (line, line.over(exact))),
                |it| it >= 20_000.0,
            ),
            Self::new("RK4 generic over by hand <= 1.1", generic_over_hand(lines), |it| it <= 1.1),
        ]
    }
}

/// The largest ratio over all step counts.
fn generic_over_hand(lines: &[Line]) -> Option<(&Line, f64)> {
    let of = |origin: Origin| {
        let counted = |line: &&Line| matches!(line.setting, Setting::Steps(_));
        lines.iter().filter(move |line| line.origin == origin).filter(counted)
    };
    let pairs = of(Origin::Ours).zip(of(Origin::Hand));
    let ratios = pairs.map(|(generic, hand)| (generic, generic.over(hand)));
    ratios.max_by(|one, other| one.1.total_cmp(&other.1))
}
