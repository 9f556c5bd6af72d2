//! Cells of maps against the comparison of stabilizers, on a line and in a space.

use lyapunov_lab::compare::{Comparison, Entrants};
use lyapunov_lab::family::{StabilizerName, StabilizerNames};
use lyapunov_lab::map::Grid;
use lyapunov_lab::{SVector, Scene, Space};

use crate::map::{STIFFNESS, grid, outcomes};

/// The comparison of stabilizers measures the same runs row by row; sums along several axes may differ by a share.
fn check_cells<V: Space>(grid: &Grid, share: f64) {
    let near = |one: Option<f64>, other: Option<f64>| {
        let is_near = one.zip(other).is_some_and(|(a, b)| (a - b).abs() <= share * b.abs());
        assert!(one == other || is_near, "{one:?} {other:?}");
    };
    for (cell, outcomes) in (0..).zip(outcomes(grid, false, 2)) {
        let scene = grid.scene_of(cell).unwrap();
        let entrants = Entrants::<V>::of(grid.stabilizers.clone());
        let comparison = Comparison::of("cell", &scene, &entrants).unwrap();
        assert_eq!(comparison.scores().count(), outcomes.len());
        for (score, outcome) in comparison.scores().zip(outcomes) {
            assert_eq!(outcome.verdict, score.verdict);
            if score.verdict.is_bounded() {
                let it = outcome.measures;
                assert_eq!((it.settling_time, it.active), (score.settling_time, score.active));
                near(it.energy_injected, score.energy_injected);
                near(it.energy_taken, score.energy_taken);
                near(it.chatter, score.chatter);
                near(it.energy_given, score.energy_given);
                near(it.energy_given_beyond_damper, score.energy_given_beyond_damper);
                near(it.force_felt, score.force_felt);
                near(it.stiffness_felt, score.stiffness_percent);
            }
        }
    }
}

#[test]
fn cells_are_what_the_comparison_says() {
    for more in [
        "duration = 2.0\n",
        "duration = 1.2\neffects.delay.ticks = 2\neffects.saturation.force = 3.0\n",
    ] {
        let x = format!("{STIFFNESS}=500..9000:3");
        check_cells::<f64>(
            &grid(more, &x, "environment.wall.damping=1..30:2", &StabilizerName::ALL),
            0.0,
        );
    }
}

#[test]
fn cells_of_a_space_are_too() {
    for (axes, environment) in [
        (2, "plane = { point = [0, 0], normal = [0.5, 1], stiffness = 3000, damping = 10 }"),
        (3, "sphere = { center = [0, 0, 0], radius = 0.02, stiffness = 3000, damping = 10 }"),
    ] {
        let place = |y: &str| ["0.001", y, "0.002"][..axes].join(", ");
        let text = format!(
            "duration = 2\nservo_rate = 1000\nspace.dimensions = {axes}\n\
             device = {{ mass = 0.2, damping = 0.1 }}\n\
             operator = {{ mass = 0.1, damping = 1.5, stiffness = 200, rest = [{}] }}\n\
             initial.position = [{}]\nenvironment.{environment}\n",
            place("0.01"),
            place("0.04"),
        );
        let scene = Scene::parse(&text, "test").unwrap_or_else(|fault| panic!("{fault}"));
        let members: StabilizerNames = "all".parse().unwrap();
        let kind = environment.split(' ').next().unwrap();
        let axis = |text: &str| text.parse().unwrap();
        let x = axis(&format!("environment.{kind}.stiffness=500..90000:2"));
        let members = members.on(&scene).to_vec();
        let grid = Grid::new(scene, x, axis("device.damping=0.1..2:2"), members).unwrap();
        match axes {
            2 => check_cells::<SVector<f64, 2>>(&grid, 1e-12),
            _ => check_cells::<SVector<f64, 3>>(&grid, 1e-12),
        }
    }
}
