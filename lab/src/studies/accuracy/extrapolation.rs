//! Extrapolated midpoint rule: a second method that follows a smooth motion to all digits of its scalar.

use lyapunov::{
    Mask, Scalar, Signal,
    integrators::{Dynamics, Integrator},
};

/// The most columns: the error of the last is of order `2 COLUMNS` in the step.
const COLUMNS: usize = 14;

/// The most halvings of a step.
const HALVINGS: u32 = 10;

/// Allowed rounding errors, in units of epsilon: extrapolation adds large terms of both signs.
const ROUNDINGS: f64 = 64.0;

/// The midpoint rule in 2, 4, 6, … steps, extrapolated to a step of zero (Gragg 1965; Bulirsch and Stoer 1966; Hairer,
/// Nørsett and Wanner, Solving Ordinary Differential Equations I, 1993, II.9).
///
/// It evaluates only the rates of the dynamics, and every coefficient is a ratio of whole numbers, so it shares nothing
/// with the matrix exponential.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extrapolation;

impl<U: Signal, D: Dynamics<U>> Integrator<U, D> for Extrapolation {
    fn step(&mut self, dynamics: &D, from: D::State, input: U, interval: U::Scalar) -> D::State {
        gain(&|at| dynamics.rate(at, input), from, interval, HALVINGS)
    }
}

/// The gain of `from` over `interval`, in halves where one step does not settle.
fn gain<Q: Signal>(rates: &impl Fn(Q) -> Q, from: Q, interval: Q::Scalar, halvings: u32) -> Q {
    let (gained, settled) = extrapolated(rates, from, interval);
    if settled || halvings == 0 {
        return gained;
    }
    let half = interval * Q::Scalar::of(0.5);
    let first = gain(rates, from, half, halvings - 1);
    first + gain(rates, from + first, half, halvings - 1)
}

/// The gain of `from` by the first column that no longer differs from the one before, and whether one did so.
fn extrapolated<Q: Signal>(rates: &impl Fn(Q) -> Q, from: Q, interval: Q::Scalar) -> (Q, bool) {
    let mut row: Vec<Q> = Vec::with_capacity(COLUMNS);
    for index in 0..COLUMNS {
        let mut above = midpoint(rates, from, interval, 2 * (index as u32 + 1));
        let mut last = Q::zero();
        for (column, before) in row.iter_mut().enumerate() {
            // 1 / ((n_j / n_(j-k))² - 1), from whole numbers.
            let (whole, part) = (index + 1, index - column);
            let share = Q::Scalar::of((part * part) as f64)
                / Q::Scalar::of((whole * whole - part * part) as f64);
            let next = combined(above, combined(above, *before, -one::<Q>()), share);
            *before = above;
            last = above;
            above = next;
        }
        let change = combined(above, last, -one::<Q>());
        let settled = index > 0 && is_small(change, from, above);
        if settled {
            return (above, true);
        }
        row.push(above);
    }
    (row.pop().unwrap_or_else(Q::zero), false)
}

/// The gain of `from` by the midpoint rule in `steps` steps, an even number, begun and ended by Euler's.
fn midpoint<Q: Signal>(rates: &impl Fn(Q) -> Q, from: Q, interval: Q::Scalar, steps: u32) -> Q {
    let step = interval / Q::Scalar::of(f64::from(steps));
    let mut before = Q::zero();
    let mut gained = combined(before, rates(from), step);
    for _ in 1..steps {
        let next = combined(before, rates(from + gained), step + step);
        (before, gained) = (gained, next);
    }
    let beyond = combined(before, rates(from + gained), step);
    combined(Q::zero(), gained + beyond, Q::Scalar::of(0.5))
}

fn one<Q: Signal>() -> Q::Scalar {
    Q::Scalar::of(1.0)
}

fn combined<Q: Signal>(base: Q, change: Q, share: Q::Scalar) -> Q {
    base + change.scale(share)
}

/// Whether `change` is no more than rounding on every axis; a NaN counts as rounding, since no column changes it any
/// more.
fn is_small<Q: Signal>(change: Q, from: Q, gained: Q) -> bool {
    let allowed = Q::Scalar::epsilon() * Q::Scalar::of(ROUNDINGS);
    let magnitude = |axis: Q::Scalar| axis.magnitude();
    let size = from.map(magnitude) + gained.map(magnitude);
    let mut small = true;
    change.zip(size, |change, size| {
        small &= !change.magnitude().above(allowed * size).any();
        change
    });
    small
}

#[cfg(test)]
mod tests {
    use lyapunov::{
        Scalar,
        accumulators::DoubleDouble,
        bodies::Impedance,
        integrators::{Oscillator, State},
    };

    use super::*;

    /// The cosine and the sine of 1, from tables: 0.54030230586813971740093660744297660373…
    #[test]
    fn a_swing_of_one_radian_has_twenty_seven_digits() {
        let of = DoubleDouble::of;
        let swing = Impedance { mass: of(1.0), damping: of(0.0), stiffness: of(1.0) };
        let swing = Oscillator::new(swing).unwrap();
        let from = State { position: of(1.0), velocity: of(0.0) };
        let gain = Extrapolation.step(&swing, from, of(0.0), of(1.0));
        let cosine = DoubleDouble::sum_of(0.540_302_305_868_139_8, -4.760_954_612_604_417e-17);
        let sine = DoubleDouble::sum_of(0.841_470_984_807_896_5, 1.776_845_092_935_536e-18);
        let off = |got: DoubleDouble, want: DoubleDouble| (got - want).magnitude().high();
        assert!(off(from.position + gain.position, cosine) < 1e-27);
        assert!(off(-gain.velocity, sine) < 1e-27);
    }
}
