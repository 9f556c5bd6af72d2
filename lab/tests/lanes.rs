//! Lanes of boxes against single runs of the same cells, bit for bit.

use lyapunov_lab::Scene;
use lyapunov_lab::family::StabilizerName;
use lyapunov_lab::map::{Grid, Instructions, Outcome, Run};
use lyapunov_lab::scene::{Finite, Positive};
use lyapunov_lab::scenes::SCENES;
use proptest::prelude::*;

/// A shipped scene of one dimension, cut to `duration` s; none of several dimensions.
fn on_a_line(name: &str, duration: f64) -> Option<Scene> {
    // From its file, for the motion that it reads lies beside it.
    let path = format!(concat!(env!("CARGO_MANIFEST_DIR"), "/../scenes/{}.toml"), name);
    let scene = Scene::load(path.as_ref()).unwrap_or_else(|fault| panic!("{fault}"));
    let mut draft = scene.to_draft();
    if draft.dimensions() > 1 {
        return None;
    }
    draft.duration = Positive::new(duration).unwrap();
    Some(draft.check().unwrap())
}

fn outcomes(run: &Run<'_>, cells: u64) -> Vec<Vec<Outcome>> {
    let mut all = Vec::new();
    let put = &mut |_: u64, outcomes: &[Vec<Outcome>]| {
        all.extend_from_slice(outcomes);
        Ok(())
    };
    run.cells(0..cells, &|| true, put).unwrap();
    all
}

/// Compares lanes of all kinds with single runs, and returns the outcomes.
fn same(what: &str, grid: &Grid) -> Vec<Vec<Outcome>> {
    let alone = outcomes(&Run::one_by_one(grid, Some(2)).unwrap(), grid.cells());
    for set in Instructions::all() {
        let lanes = outcomes(&Run::on_boxes(grid, set, Some(2)).unwrap(), grid.cells());
        for (cell, (lanes, alone)) in lanes.iter().zip(&alone).enumerate() {
            for ((one, other), member) in lanes.iter().zip(alone).zip(grid.stabilizers.iter()) {
                assert_eq!(one, other, "{what}, {member}, cell {cell}, {}", set.name());
            }
        }
    }
    alone
}

fn grid(scene: &Scene, x: &str, y: &str, members: &[StabilizerName]) -> Grid {
    let axes = [x, y].map(|axis| axis.parse().unwrap());
    let [x, y] = axes;
    Grid::new(scene.clone(), x, y, members.iter().copied()).unwrap_or_else(|e| panic!("{e}"))
}

fn named(names: &[&str]) -> Vec<StabilizerName> {
    names.iter().map(|name| name.parse().unwrap()).collect()
}

/// The axes of every scene: a mass, and where it starts; nine and three cells leave lanes empty.
const AXES: [&str; 2] = ["device.mass=0.1..0.5:9", "initial.velocity=-0.1..0.2:3"];

#[test]
fn every_scene_on_a_line_has_the_bits_of_single_runs() {
    let mut bounded = 0;
    for shipped in SCENES {
        let Some(scene) = on_a_line(shipped.name, 1.5) else { continue };
        let members = named(&["none", "popc", "lolc-device-damping"]);
        let all = same(shipped.name, &grid(&scene, AXES[0], AXES[1], &members));
        bounded += all.iter().flatten().filter(|it| it.measures.peak_force.is_some()).count();
    }
    assert!(bounded > 1000, "{bounded}");
}

#[test]
fn every_member_has_them() {
    let members: Vec<StabilizerName> = StabilizerName::ALL.into();
    for name in ["press-1khz", "cubic-spring"] {
        let scene = on_a_line(name, 1.5).unwrap();
        let key = format!("environment.{}.stiffness", scene.environment.name());
        same(name, &grid(&scene, &format!("{key}=100..9000:9:log"), AXES[1], &members));
    }
}

/// Numbers that are structure (ticks, rates, kinds of filters) make groups of their own, down to single cells.
#[test]
fn numbers_of_a_structure_part_the_lanes() {
    let scene = on_a_line("tour", 0.5).unwrap();
    for axes in [
        ["effects.delay.ticks=0..3:4", "environment.wall.damping=0..9:7"],
        ["servo_rate=500..2000:4", "effects.filter.cutoff=50..200:3"],
        ["operator.motion.amplitude=0.01..0.02:3", "effects.noise.seed=1..5:5"],
        ["effects.dropout.probability=0..0.5:5", "effects.jitter.deviation=0..2e-5:2"],
        ["effects.saturation.force=1..9:3", "effects.friction.coulomb=0..0.15:6"],
        ["link.stiffness=1e3..5e4:5:log", "effects.encoder.resolution=1e-6..1e-4:3:log"],
    ] {
        same(axes[0], &grid(&scene, axes[0], axes[1], &named(&["none", "lolc", "popc-rising"])));
    }
    let press = on_a_line("press-1khz", 0.8).unwrap();
    let members = named(&["popc-spread", "popc-windowed", "force-bounding", "iss"]);
    for axes in [
        ["stabilizer.popc-spread.ticks=1..3:3", "effects.delay.ticks=0..12:3"],
        ["stabilizer.popc-windowed.window=0.01..0.3:6", "device.damping=0.05..1:5"],
    ] {
        same(axes[0], &grid(&press, axes[0], axes[1], &members));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// Any shipped scene under any member over two of its numbers.
    #[test]
    fn random_cells_have_them(
        place in 0..SCENES.len(),
        member in 0..StabilizerName::ALL.len(),
        mass in 0.05..0.5_f64,
        start in -0.01..0.0_f64,
        stiffness in 0.0..900.0_f64,
    ) {
        let name = SCENES[place].name;
        let Some(scene) = on_a_line(name, 0.7) else { return Ok(()) };
        let mut draft = scene.to_draft();
        draft.initial.position = Finite::new(start).unwrap().into();
        let scene = draft.check().unwrap();
        let member = StabilizerName::ALL[member];
        if !member.fits(&scene) {
            return Ok(());
        }
        let x = format!("device.mass={mass:?}..{:?}:5", 2.0 * mass);
        let y = format!("operator.stiffness={stiffness:?}..{:?}:4", stiffness + 100.0);
        same(name, &grid(&scene, &x, &y, &[member]));
    }
}
