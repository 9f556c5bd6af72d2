//! Both ends together give no more than they took, over seeds of channels.

use lyapunov_lab::compare::Named;
use lyapunov_lab::teleoperation::Entrant;

use crate::teleoperation::shipped::{compared, parsed, scores, text};

#[test]
fn energy_that_both_ports_generated_is_reported_as_shortfall() {
    let mut generated = 0;
    for seed in 0..60 {
        let (delay, spread, loss) = (seed % 7 * 9, seed % 5 * 13, f64::from(seed % 4) * 0.3);
        let text = text("lossy")
            .replace("duration = 5.0", "duration = 2.0")
            .replace("delay = 20", &format!("delay = {delay}\nspread = {spread}"))
            .replace("loss = 0.3", &format!("loss = {loss}"))
            .replace("seed = 1", &format!("seed = {seed}"));
        let rows = scores(&compared(&parsed(&text)));
        for (entrant, row) in Entrant::ALL.iter().zip(rows) {
            let (given, shortfall) = (row.given.unwrap(), row.shortfall.unwrap());
            // 5 mJ are in the hand at the start, and only the link can add to them.
            let energy = row.energy.unwrap();
            assert!(energy <= 5.0 + given + 1e-9 * (1.0 + given), "{row:?} in\n{text}");
            // The tolerance is for ledgers of some 10 mJ.
            match entrant {
                Entrant::None => generated += i32::from(given > 1.0),
                Entrant::Popc | Entrant::TwoPort | Entrant::Compensated => {
                    let kept = row.kept.unwrap();
                    assert!(kept >= -shortfall - 1e-9, "{row:?} in\n{text}");
                }
                // The tanks are empty at the start.
                Entrant::TwoLayer => assert!(given <= shortfall + 1e-9, "{row:?} in\n{text}"),
                Entrant::Waves | Entrant::MatchedWaves | Entrant::FilteredWaves => {}
            }
        }
    }
    assert!(generated > 20, "only {generated} loops had anything to repair");
}
