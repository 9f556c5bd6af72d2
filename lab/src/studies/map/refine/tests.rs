use std::convert::Infallible;

use proptest::prelude::*;

use super::{Edge, Side};

/// The edge of the region in which `is_bounded` holds.
fn edge_of(size: [u64; 2], is_bounded: impl Fn(u64, u64) -> bool) -> Edge {
    let side = |cell: &u64| match is_bounded(cell % size[0], cell / size[0]) {
        true => Side::Bounded,
        false => Side::Grows,
    };
    let found = Edge::find(size, |cells| Ok::<_, Infallible>(cells.iter().map(side).collect()));
    found.unwrap_or_else(|never| match never {})
}

/// The cells on a wrong side.
fn wrong(edge: &Edge, size: [u64; 2], is_bounded: impl Fn(u64, u64) -> bool) -> usize {
    // Of a large grid a part is enough: its length has no factor in common with the blocks.
    let cells = (0..size[0] * size[1]).step_by(if size[0] > 1000 { 97 } else { 1 });
    let right = |cell: &u64| {
        (edge.side(*cell) == Side::Bounded) == is_bounded(cell % size[0], cell / size[0])
    };
    cells.filter(|cell| !right(cell)).count()
}

#[test]
fn a_smooth_edge_takes_few_runs_of_a_large_grid() {
    let size = [4096, 4096];
    let disc = |x: u64, y: u64| {
        let (x, y) = (x as f64 - 1500.0, y as f64 - 2000.0);
        x.hypot(y) < 1200.0
    };
    let edge = edge_of(size, disc);
    let judged = edge.judged();
    assert!(
        judged
            .iter()
            .all(|(cell, side)| (*side == Side::Bounded) == disc(cell % 4096, cell / 4096))
    );
    assert!(judged.len() < 4096 * 4096 / 100, "{}", judged.len());
    assert_eq!(wrong(&edge, size, disc), 0);
    let shares = edge.shares();
    let exact = std::f64::consts::PI * 1200.0 * 1200.0 / (4095.0 * 4095.0);
    assert!((shares.sides[0] - exact).abs() < 0.5 * shares.passed, "{shares:?}, {exact}");
    assert_eq!(edge.unresolved(), None);
}

#[test]
fn a_finger_is_followed_through_blocks_whose_corners_agree() {
    let size = [1024, 512];
    let finger = |x: u64, y: u64| x < 300 || (x < 700 && (101..104).contains(&y));
    let edge = edge_of(size, finger);
    assert_eq!(wrong(&edge, size, finger), 0);
    // Two straight edges and an end of three cells pass no more cells than their own length.
    assert!(edge.passed_blocks() > 40);
}

#[test]
fn an_edge_without_any_order_is_ragged_and_the_runs_are_limited() {
    let size = [4096, 4096];
    let noise = |x: u64, y: u64| {
        (x.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ y.wrapping_mul(0xc2b2_ae3d_27d4_eb4f)) >> 32 & 1
            == 0
    };
    // The left half is one side, and the right half noise.
    let edge = edge_of(size, |x, y| x < 2048 || noise(x, y));
    assert!(edge.judged().len() <= 4096 * 4096 / 20);
    assert!(edge.unresolved().is_some());
    assert!(edge.ragged_blocks() > edge.passed_blocks() / 2);
    // Noise is as often on one side as on the other.
    assert!((edge.shares().sides[0] - 0.75).abs() < 0.02, "{:?}", edge.shares());
}

#[test]
fn a_straight_edge_is_not_ragged() {
    let edge = edge_of([2048, 2048], |x, y| 3 * x + 2 * y < 4000);
    assert_eq!((edge.ragged_blocks(), edge.unresolved()), (0, None));
}

#[test]
fn the_smallest_grids_are_judged() {
    for size in [[1, 1], [1, 7], [7, 1], [2, 2], [3, 2], [1, 1000], [17, 16]] {
        let is_bounded = |x: u64, y: u64| x + y < 5;
        let edge = edge_of(size, is_bounded);
        assert_eq!(wrong(&edge, size, is_bounded), 0, "{size:?}");
        let sum: f64 = edge.shares().sides.iter().sum();
        assert!((sum - 1.0).abs() < 1e-12, "{size:?}: {sum}");
    }
}

proptest! {
    /// The corners of a block tell its inside where the edge only rises.
    #[test]
    fn an_edge_that_only_rises_is_found_to_the_cell(
        columns in 1_u64..300,
        rows in 1_u64..300,
        steps in prop::collection::vec(0_u64..4, 300),
        first in 0_u64..40,
    ) {
        let mut height = first;
        let heights: Vec<u64> = steps.iter().map(|step| { height += step; height }).collect();
        let below = |x: u64, y: u64| y < heights[x as usize];
        let edge = edge_of([columns, rows], below);
        prop_assert_eq!(wrong(&edge, [columns, rows], below), 0);
        prop_assert_eq!(edge.ragged_blocks(), 0);
    }
}
