//! Snapshots of readings: the memory of a port goes on in another program.

use proptest::collection::vec;
use proptest::prelude::any;
use proptest::proptest;

use lyapunov::{Reading, Readings, Snapshot, readings::CheckedSample};

use crate::support::{loaded, stored};

fn told(checked: &CheckedSample<f64>) -> String {
    format!("{checked:?}")
}

proptest! {
    #[test]
    fn they_go_on(
        ticks in vec((any::<f64>(), -1e-2..1e-2f64, any::<f64>(), 0u8..8), 2..40),
        cut in 0usize..40,
    ) {
        let fresh = Readings::<f64>::every(1e-3).expect("a period");
        let fresh = fresh.no_faster_than(3.0).expect("a speed");
        let low_passed = fresh.low_passed(30.0).expect("a cutoff");
        let windowed = fresh.windowed::<7>(6, 1e-4).expect("a window").clocked();
        let mut running = (low_passed, windowed);
        let mut resumed = running;
        let mut now = 0.0;
        for (at, (wild, slow, effort, flaw)) in ticks.iter().enumerate() {
            let position = if *flaw == 0 { *wild } else { *slow };
            let applied = if *flaw == 1 { *effort } else { *slow };
            now = if *flaw == 2 { *wild } else { now + 1e-3 };
            let reading = Reading { position, applied };
            if at == cut % ticks.len() {
                let bytes = stored(&running.state());
                resumed = (low_passed, windowed).restored(loaded(&bytes)).expect("a state");
            }
            let first = (running.0.read(reading), running.1.read_at(now, reading));
            if at >= cut % ticks.len() {
                let again = (resumed.0.read(reading), resumed.1.read_at(now, reading));
                assert_eq!(told(&again.0), told(&first.0));
                assert_eq!(told(&again.1), told(&first.1));
            }
        }
        assert_eq!(stored(&resumed.state()), stored(&running.state()));
    }
}

/// After a pause in which the arm was moved, what was restored is restarted: the move books nothing.
#[test]
fn a_restored_memory_can_be_restarted() {
    let fresh = Readings::<f64>::every(1e-3).expect("a period");
    let mut before = fresh;
    before.read(Reading { position: 0.3, applied: 0.0 });
    let mut after = fresh.restored(before.state()).expect("a state");
    after.restart();
    let sample = after.read(Reading { position: 0.9, applied: 5.0 }).sample;
    assert_eq!([sample.displacement, sample.work, sample.velocity], [0.0; 3]);
}
