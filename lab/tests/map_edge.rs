//! Edge of bounded runs, from few of them, against the full map.

use lyapunov_lab::map::{BasicName, Outcome, Refined, Run, Side};

use crate::map::{STIFFNESS, grid, outcomes};

/// Cells are run in tiles of 16384 rows.
#[test]
fn a_cell_of_a_later_tile_is_its_own() {
    let x = format!("{STIFFNESS}=20..1500:2");
    let more = "duration = 0.5\noperator = { mass = 0.1, damping = 0.2, stiffness = 2000.0 }\n";
    let grid = grid(more, &x, "device.mass=0.05..0.4:16400", &[BasicName::NoStabilizer]);
    let of = |run: Run<'_>| {
        let mut all = Vec::new();
        let put = &mut |_: u64, outcomes: &[Vec<Outcome>]| {
            all.extend_from_slice(outcomes);
            Ok(())
        };
        run.cells(2 * 16_384 - 4..2 * 16_384 + 8, &|| true, put).unwrap();
        all
    };
    let (lanes, alone) =
        (of(Run::of(&grid, Some(1)).unwrap()), of(Run::one_by_one(&grid, Some(1)).unwrap()));
    assert_eq!(lanes.len(), 12);
    assert_eq!(lanes, alone);
}

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
