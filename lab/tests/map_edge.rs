//! Edge of stability from few runs against the full map.

use lyapunov_lab::map::{BasicName, Refined, Run, Side};

use crate::map::{STIFFNESS, grid, outcomes};

#[test]
fn judged_cells_of_an_edge_are_those_of_the_map() {
    for more in ["", "effects.encoder.resolution = 1e-6\n"] {
        let x = format!("{STIFFNESS}=20..1500:48");
        let grid = grid(more, &x, "device.mass=0.05..0.4:40", &[BasicName::NoStabilizer]);
        let run = Run::of(&grid, Some(2)).unwrap();
        let refined = Refined::of(&run, &|_| true).unwrap();
        let all = outcomes(&grid, false, 2);
        let sides: Vec<Side> = all.iter().map(|it| it[0].verdict.into()).collect();
        let (_, edge) = refined.edges().next().unwrap();
        let judged = edge.judged();
        assert!(judged.len() < all.len() * 2 / 3, "{} of {}", judged.len(), all.len());
        for (cell, side) in judged {
            assert_eq!(side, sides[cell as usize], "{cell}");
        }
        for side in [Side::Bounded, Side::Grows] {
            assert!(sides.iter().filter(|it| **it == side).count() > 100);
        }
        let missed = (0..grid.cells()).filter(|at| edge.side(*at) != sides[*at as usize]).count();
        assert!(missed * 100 < all.len(), "{missed}");
    }
}
