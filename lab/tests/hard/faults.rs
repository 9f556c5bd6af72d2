//! Every fault at every tick of every shipped scene, under every member that takes part.

use lyapunov_lab::Scene;
use lyapunov_lab::family::{BasicName, StabilizerName};
use lyapunov_lab::hard::faults::{Fault, RECOVERY, SPACING, Swept, sweep};
use lyapunov_lab::scenes::SCENES;

use crate::shipped::rows::scene;

/// The shipped scenes under each member: the scene, and the name.
fn loops() -> Vec<(Scene, &'static str, &'static str)> {
    let nobody = StabilizerName::Basic(BasicName::NoStabilizer);
    let shipped = SCENES.iter().map(|it| (it.name, scene(it.name)));
    let under = |(name, scene): (&'static str, Scene)| {
        let members = StabilizerName::ALL.into_iter();
        let members = members.filter(|it| *it != nobody && it.fits(&scene)).collect::<Vec<_>>();
        let written =
            move |it: StabilizerName| (it.written_in(&scene, &[]).unwrap(), name, it.name());
        members.into_iter().map(written)
    };
    shipped.flat_map(under).collect()
}

/// Sweeps one loop in `step`, with the first ticks that `firsts` gives for the number of a loop, up to tick `last`.
fn swept(step: usize, firsts: impl Fn(u64) -> Vec<u64>, last: u64) -> Swept {
    let mut all = Swept::default();
    for (number, (scene, name, member)) in (0..).zip(&loops()).step_by(step) {
        let told = sweep(scene, &firsts(number), last).unwrap();
        assert!(told.found.is_none(), "{name} under {member}: {}", told.found.unwrap());
        all.faults += told.faults;
        all.recovery = all.recovery.max(told.recovery);
    }
    assert_eq!(all.recovery, RECOVERY);
    all
}

/// Every scene and every member, but not each with each: of each loop one tick in [`SPACING`] of the first ticks, another one
/// from loop to loop.
#[test]
fn no_fault_of_a_tick_leaves_its_bounds_in_a_shipped_scene() {
    let told = swept(11, |number| vec![number % SPACING], 60);
    assert!(told.faults > 10_000, "{}", told.faults);
}

/// Otherwise a kind of fault might never be made.
#[test]
fn every_fault_meets_every_tick() {
    let (ticks, kinds) = (60, Fault::all().len() as u64);
    let told = sweep(&loops()[0].0, &(0..SPACING).collect::<Vec<_>>(), ticks).unwrap();
    // In f64 and in f32.
    assert_eq!(told.faults, 2 * kinds * (ticks + 1));
}

/// Every tick of every scene: `cargo test -p lyapunov-lab --release --test library every_tick -- --ignored --nocapture`.
#[test]
#[ignore = "takes half an hour"]
fn no_fault_of_every_tick_leaves_its_bounds_in_a_shipped_scene() {
    let told = swept(1, |_| (0..SPACING).collect(), u64::MAX);
    println!("{} faults of {} kinds", told.faults, Fault::all().len());
}
