//! Unfinished tables of maps.

use lyapunov_lab::map::{BasicName, Checkpoint, CheckpointError, Run, Shard, Survey};

use crate::map::grid;

/// An interrupt in the middle of reading leaves what is there as it was.
#[test]
fn a_reading_that_is_stopped_changes_nothing() {
    let (x, y) = ("environment.wall.stiffness=500..9000:4", "device.mass=0.1..0.4:4");
    let grid = grid("", x, y, &[BasicName::Popc]);
    let place = tempfile::tempdir().unwrap();
    let mut survey = Survey::of(&grid);
    let open = |survey: &mut Survey, resume, go_on: &dyn Fn() -> bool| {
        Checkpoint::open(place.path(), &grid, Shard::WHOLE, resume, survey, go_on)
    };
    let mut begun = open(&mut survey, false, &|| true).unwrap();
    let run = Run::of(&grid, Some(1)).unwrap();
    run.cells(0..8, &|| true, &mut |_, outcomes| begun.put(&grid, outcomes)).unwrap();
    let part = begun.part().to_owned();
    drop(begun);
    let before = std::fs::read(&part).unwrap();
    let stopped = open(&mut survey, true, &|| false).unwrap_err();
    assert!(matches!(stopped, CheckpointError::Stopped(_)), "{stopped}");
    assert!(stopped.to_string().contains("--resume"), "{stopped}");
    assert_eq!(std::fs::read(&part).unwrap(), before);
    assert_eq!(open(&mut Survey::of(&grid), true, &|| true).unwrap().next(), 8);
}
