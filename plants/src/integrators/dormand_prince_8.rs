//! Dormand-Prince method of order 8, with estimates of orders 5 and 3.

use lyapunov_core::{Dynamics, Integrator, Scalar, Signal};

use super::embedded_pair::{Row, stages, summed};
use crate::EmbeddedPair;

/// Dormand and Prince's method of order 8 with the two estimates of Hairer, Nørsett and Wanner, of orders 5 and 3, known
/// as DOP853 (Dormand and Prince 1981; Solving Ordinary Differential Equations I, 1993, II.5 and II.10, with the
/// coefficients of the authors' own program, which are irrational).
///
/// It takes 12 evaluations, at steps of the given length or chosen by [`Adaptive`](crate::Adaptive).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DormandPrince8;

const ROWS: [Row; 11] = [
    &[(0, 0.05260015195876773)],
    &[(0, 0.0197250569845379), (1, 0.0591751709536137)],
    &[(0, 0.02958758547680685), (2, 0.08876275643042054)],
    &[(0, 0.2413651341592667), (2, -0.8845494793282861), (3, 0.924834003261792)],
    &[(0, 0.037037037037037035), (3, 0.17082860872947386), (4, 0.12546768756682242)],
    &[(0, 0.037109375), (3, 0.17025221101954405), (4, 0.06021653898045596), (5, -0.017578125)],
    &[
        (0, 0.03709200011850479),
        (3, 0.17038392571223998),
        (4, 0.10726203044637328),
        (5, -0.015319437748624402),
        (6, 0.008273789163814023),
    ],
    &[
        (0, 0.6241109587160757),
        (3, -3.3608926294469414),
        (4, -0.868219346841726),
        (5, 27.59209969944671),
        (6, 20.154067550477894),
        (7, -43.48988418106996),
    ],
    &[
        (0, 0.47766253643826434),
        (3, -2.4881146199716677),
        (4, -0.590290826836843),
        (5, 21.230051448181193),
        (6, 15.279233632882423),
        (7, -33.28821096898486),
        (8, -0.020331201708508627),
    ],
    &[
        (0, -0.9371424300859873),
        (3, 5.186372428844064),
        (4, 1.0914373489967295),
        (5, -8.149787010746927),
        (6, -18.52006565999696),
        (7, 22.739487099350505),
        (8, 2.4936055526796523),
        (9, -3.0467644718982196),
    ],
    &[
        (0, 2.273310147516538),
        (3, -10.53449546673725),
        (4, -2.0008720582248625),
        (5, -17.9589318631188),
        (6, 27.94888452941996),
        (7, -2.8589982771350235),
        (8, -8.87285693353063),
        (9, 12.360567175794303),
        (10, 0.6433927460157636),
    ],
];

const GAIN: Row = &[
    (0, 0.054293734116568765),
    (5, 4.450312892752409),
    (6, 1.8915178993145003),
    (7, -5.801203960010585),
    (8, 0.3111643669578199),
    (9, -0.1521609496625161),
    (10, 0.20136540080403034),
    (11, 0.04471061572777259),
];

/// The gain of order 8 less that of order 5.
const FIFTH: Row = &[
    (0, 0.01312004499419488),
    (5, -1.2251564463762044),
    (6, -0.4957589496572502),
    (7, 1.6643771824549864),
    (8, -0.35032884874997366),
    (9, 0.3341791187130175),
    (10, 0.08192320648511571),
    (11, -0.022355307863886294),
];

/// The gain of order 8 less that of order 3.
const THIRD: Row = &[
    (0, -0.18980075407240762),
    (5, 4.450312892752409),
    (6, 1.8915178993145003),
    (7, -5.801203960010585),
    (8, -0.4226823213237919),
    (9, -0.1521609496625161),
    (10, 0.20136540080403034),
    (11, 0.02265179219836082),
];

impl<U: Signal, D: Dynamics<U>> Integrator<U, D> for DormandPrince8 {
    fn step(&mut self, dynamics: &D, from: D::State, input: U, interval: U::Scalar) -> D::State {
        let stages: [_; 12] = stages(dynamics, from, input, interval, &ROWS);
        summed(&stages, GAIN, interval)
    }
}

impl<U: Signal, D: Dynamics<U>> EmbeddedPair<U, D> for DormandPrince8 {
    const ESTIMATE: u32 = 8;

    /// The estimate is `e₅² / √(e₅² + e₃² / 100)`, of order 8, with `e₅` and `e₃` the sizes of the two errors.
    fn attempt(
        &self,
        dynamics: &D,
        from: D::State,
        input: U,
        interval: U::Scalar,
        size: impl Fn(D::State, D::State) -> U::Scalar,
    ) -> (D::State, U::Scalar) {
        let stages: [_; 12] = stages(dynamics, from, input, interval, &ROWS);
        let gain = summed(&stages, GAIN, interval);
        let fifth = size(gain, summed(&stages, FIFTH, interval));
        let third = size(gain, summed(&stages, THIRD, interval));
        // Two errors of 0 would give 0 / 0 instead of 0.
        let least = U::Scalar::smallest_normal();
        let norm = (fifth * fifth + third * third * U::Scalar::of(0.01)).sqrt() + least;
        (gain, fifth * (fifth / norm))
    }
}
