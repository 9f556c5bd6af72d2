//! Exact motion against a Taylor series in double-double and against closed forms.

use approx::abs_diff_eq;
use nalgebra::SMatrix;
use proptest::array::uniform16;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::{
    Plant,
    bodies::{Body, Impedance, held_input},
};

use crate::support::{
    Bits, CASES, Double, Gain, Motion, Port, Real, hold, log_between, ordinary, unit,
};

/// `exp(A) − I` by its series in double-double, halved and doubled where `A` is large.
fn series<const N: usize>(matrix: SMatrix<f64, N, N>) -> [[Double; N]; N] {
    let multiply = |a: &[[Double; N]; N], b: &[[Double; N]; N]| -> [[Double; N]; N] {
        std::array::from_fn(|row| {
            std::array::from_fn(|column| {
                (0..N).fold(Double::default(), |sum, at| sum + a[row][at] * b[at][column])
            })
        })
    };
    let size = matrix.iter().fold(0.0, |most: f64, entry| most.max(entry.abs())) * N as f64;
    let halvings = size.log2().ceil().max(0.0) as i32;
    let scaled: [[Double; N]; N] = std::array::from_fn(|row| {
        std::array::from_fn(|column| Double::of(matrix[(row, column)] * 2f64.powi(-halvings)))
    });
    let (mut term, mut increment) = (scaled, scaled);
    for degree in 2..=30 {
        let divisor = Double::of(f64::from(degree));
        term = multiply(&term, &scaled).map(|row| row.map(|entry| entry.over(divisor)));
        for row in 0..N {
            for column in 0..N {
                increment[row][column] = increment[row][column] + term[row][column];
            }
        }
    }
    for _ in 0..halvings {
        let square = multiply(&increment, &increment);
        increment = std::array::from_fn(|row| {
            std::array::from_fn(|column| {
                let entry = increment[row][column];
                entry + entry + square[row][column]
            })
        });
    }
    increment
}

/// The increments of a body over one period, read off one by one.
fn increments<T: Real + Port<Scalar = T>>(impedance: Impedance<T>, period: T) -> Gain {
    let (zero, one) = (T::of(0.0), T::of(1.0));
    let body = Body::new(impedance, period).expect("a body");
    let moved = |from: T, velocity: T, effort: T| {
        // For a body at the origin with its rest a metre behind, the new position is the increment.
        let sample = body.resting_at(-from).starting(zero, velocity).advance(effort);
        (sample.position.f64(), (sample.velocity - velocity).f64())
    };
    let parts = [moved(one, zero, zero), moved(zero, one, zero), moved(zero, zero, one)];
    Gain { position: parts.map(|part| part.0), velocity: parts.map(|part| part.1) }
}

mod check {
    use super::*;

    /// Many masses, dampings, stiffnesses and rates, also at critical damping and without damping or stiffness.
    pub(super) fn body_moves_exactly<T: Real + Port<Scalar = T>>() {
        hold(CASES, uniform16(any::<Bits>()), |bits| {
            let mass = T::of(log_between(bits[0], 0.01, 100.0));
            let period = T::of(log_between(bits[1], 1e-4, 0.05));
            let stiffness = T::of(match bits[2] % 4 {
                0 => 0.0,
                _ => log_between(bits[3], 0.1, 1e4),
            });
            let critical = 2.0 * (stiffness.f64() * mass.f64()).sqrt();
            let damping = T::of(match bits[4] % 5 {
                0 => 0.0,
                1 => critical,
                2 => critical * (1.0 + 1e-9 * unit(bits[5])),
                3 => log_between(bits[5], 1.0, 3.0) * critical,
                _ => log_between(bits[5], 1e-3, 2.0),
            });
            let [m, b, k] = [mass, damping, stiffness].map(Real::f64);
            let t = period.f64();
            if b / m * t + k / m * t * t > 20.0 {
                return Ok(());
            }
            let exact = Motion { mass: m, damping: b, stiffness: k, rest: 0.0 }.over(t);
            let found = increments(Impedance { mass, damping, stiffness }, period);
            // A few units of the summands of the increments.
            let bound = 1e-14f64.max(2.0 * T::unit());
            let sizes = [[k / m * t * t, t, t * t / m], [k / m * t, (b + k * t) / m * t, t / m]];
            let rows = [(found.position, exact.position), (found.velocity, exact.velocity)];
            for (row, ((found, exact), sizes)) in rows.into_iter().zip(sizes).enumerate() {
                for column in 0..3 {
                    let off = (found[column] - exact[column]).abs();
                    // The velocity's gain per velocity is read off a velocity of one, which is rounded.
                    let read = if (row, column) == (1, 1) { T::unit() } else { 0.0 };
                    // The first entry absorbs what the others lose: about three units, and half of one when that is
                    // rounded.
                    let bound = if (row, column) == (0, 0) { 2.0 * bound } else { bound };
                    let allowed = bound * sizes[column] + read;
                    prop_assert!(off <= allowed, "{} is not {}", found[column], exact[column]);
                }
            }
            Ok(())
        });
    }
}

crate::support::every_real!(body_moves_exactly);

/// Axes move independently, each like the scalar body.
#[test]
fn axes_move_alone() {
    hold(CASES, uniform16(any::<Bits>()), |bits| {
        let mass = log_between(bits[0], 0.1, 10.0);
        let impedance = Impedance { mass, damping: 2.0 * unit(bits[1]), stiffness: 100.0 };
        let body = Body::new(impedance, 0.01).expect("a body");
        let vector = Body::new(impedance, 0.01).expect("a body");
        let part = |at: usize| nalgebra::Vector3::from_axes(|axis| ordinary(bits[at + axis], 1.0));
        let (rest, start, velocity, effort) = (part(2), part(5), part(8), part(11));
        let moved = vector.resting_at(rest).starting(start, velocity).advance(effort);
        for axis in 0..3 {
            let alone = body.resting_at(rest[axis]).starting(start[axis], velocity[axis]);
            let alone = { alone }.advance(effort[axis]);
            prop_assert!(moved.position[axis].to_bits() == alone.position.to_bits());
            prop_assert!(moved.velocity[axis].to_bits() == alone.velocity.to_bits());
            prop_assert!(moved.displacement[axis] == moved.position[axis] - start[axis]);
        }
        Ok(())
    });
}

/// The amplitude `√(x² + v² / ω²)` of an undamped body of 0.3 kg over `steps` steps in `f32`, sampled now and then: its
/// largest error, as a share of the first.
fn drift(start: f32, stiffness: f32, rate: f32, steps: u32) -> f64 {
    let mass = 0.3;
    let impedance = Impedance { mass, damping: 0.0, stiffness };
    let mut body = Body::new(impedance, 1.0 / rate).expect("a body").starting(start, 0.0);
    let mut most = 0f64;
    for step in 0..steps {
        let sample = body.advance(0.0);
        if step % 16 == 0 {
            let (x, v) = (f64::from(sample.position), f64::from(sample.velocity));
            let amplitude = (x * x + v * v * f64::from(mass) / f64::from(stiffness)).sqrt();
            most = most.max((amplitude / f64::from(start) - 1.0).abs());
        }
    }
    most
}

/// The increment form gains no energy by rounding: within a ten-thousandth after a million steps.
#[test]
fn undamped_f32_keeps_its_amplitude() {
    for (stiffness, rate) in [(50.0, 1000.0), (2000.0, 4000.0), (7.0, 10_000.0)] {
        let drift = drift(0.004, stiffness, rate, 1_000_000);
        assert!(drift < 1e-4, "{drift:e} at {stiffness} N/m and {rate} Hz");
    }
}

/// Over ten million steps of 1 ms on 50 N/m the rounding of the steps is a random walk that depends on the start:
/// within a ten-thousandth at every one.
#[test]
fn undamped_f32_keeps_its_amplitude_for_hours() {
    for start in [1.0, 0.7, 0.1, 0.0123, 0.01, 0.004, 0.003] {
        let drift = drift(start, 50.0, 1000.0, 10_000_000);
        assert!(drift <= 1e-4, "{drift:e} from {start} m");
    }
}

/// With few steps per oscillation the rounding of the increments themselves matters, each by half a unit:
/// `E₁₁ + E₂₂ ≈ −(ω T)²` and `E₁₂ E₂₁ ≈ −(ω T)²` change the determinant by up to `3 u (ω T)²` on each step, and the
/// amplitude by half of that.
#[test]
fn coarse_undamped_f32_drifts_by_its_increments_only() {
    for (stiffness, rate) in [(50.0f32, 100.0f32), (500.0, 200.0), (50.0, 60.0)] {
        let turn = f64::from(stiffness) / 0.3 / f64::from(rate).powi(2);
        let bound = 1e-4 + 1e6 * 1.5 * f32::unit() * turn;
        let drift = drift(0.004, stiffness, rate, 1_000_000);
        assert!(drift < bound, "{drift:e} at {stiffness} N/m and {rate} Hz, {bound:e} allowed");
    }
}

/// Entries of any sign, with rows of up to 8 in sum, against the series.
#[test]
fn held_input_equals_the_series() {
    hold(CASES, uniform16(any::<Bits>()), |bits| {
        let scale = log_between(bits[9], 1e-6, 8.0 / 3.0);
        let entry =
            |at: usize| if bits[10] >> at & 1 == 0 { ordinary(bits[at], scale) } else { 0.0 };
        let matrix = SMatrix::<f64, 3, 3>::from_fn(|row, column| entry(3 * row + column));
        let (found, exact) = (held_input(matrix), series(matrix));
        // The sum of the terms without their signs.
        let terms = series(matrix.map(f64::abs));
        for row in 0..3 {
            for column in 0..3 {
                let off = (found[(row, column)] - exact[row][column].value()).abs();
                let size = terms[row][column].value();
                prop_assert!(
                    off <= 1e-14 * size,
                    "entry {row} {column} off by {off:e} of {size:e}"
                );
            }
        }
        Ok(())
    });
}

/// A rotation, a shear and a growth have closed forms.
#[test]
fn held_input_equals_closed_forms() {
    hold(CASES, proptest::array::uniform2(any::<Bits>()), |bits| {
        let angle = log_between(bits[0], 1e-9, 3.0);
        let turned = held_input(SMatrix::<f64, 2, 2>::new(0.0, -angle, angle, 0.0));
        let half = (angle / 2.0).sin();
        prop_assert!(abs_diff_eq!(
            turned[(0, 0)],
            -2.0 * half * half,
            epsilon = 4e-15 * angle.sinh().max(angle * angle)
        ));
        prop_assert!(abs_diff_eq!(turned[(1, 0)], angle.sin(), epsilon = 4e-15 * angle.sinh()));
        let growth: f64 = ordinary(bits[1], 3.0);
        let grown = held_input(SMatrix::<f64, 1, 1>::new(growth));
        prop_assert!(abs_diff_eq!(
            grown[(0, 0)],
            growth.exp_m1(),
            epsilon = 1e-14 * growth.abs().exp_m1()
        ));
        let sheared = held_input(SMatrix::<f64, 2, 2>::new(0.0, growth, 0.0, 0.0));
        prop_assert!(sheared == SMatrix::<f64, 2, 2>::new(0.0, growth, 0.0, 0.0));
        Ok(())
    });
    assert!(
        held_input(SMatrix::<f64, 2, 2>::from_element(f64::NAN)).iter().any(|e| !e.is_finite())
    );
    assert!(
        held_input(SMatrix::<f64, 2, 2>::from_element(f64::INFINITY))
            .iter()
            .any(|e| !e.is_finite())
    );
}
