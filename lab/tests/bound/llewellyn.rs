//! Llewellyn's condition against two-ports between passive ends.

use lyapunov_lab::bound::llewellyn::{TwoPort, first_violation, hold};
use nalgebra::Complex;

use crate::bound::systems::Chance;

fn c(re: f64, im: f64) -> Complex<f64> {
    Complex::new(re, im)
}

/// Impedance at port 1 of a two-port given by impedances, with port 2 terminated by `end`.
fn shown(it: &TwoPort, end: Complex<f64>) -> Complex<f64> {
    it.p11 - it.p12 * it.p21 / (it.p22 + end)
}

#[test]
fn an_absolutely_stable_two_port_is_passive_at_port_1_for_any_passive_termination() {
    let mut chance = Chance::new(31);
    let (mut stable, mut unstable) = (0, 0);
    for _ in 0..3000 {
        let mut any = |positive: bool| {
            let re = if positive { chance.within(0.0, 2.0) } else { chance.within(-1.0, 1.0) };
            c(re, chance.within(-2.0, 2.0))
        };
        let it = TwoPort { p11: any(true), p12: any(false), p21: any(false), p22: any(true) };
        let ends = (0..4000).map(|n| (std::f64::consts::PI * (f64::from(n) + 0.5) / 4000.0).tan());
        // Pure reactances are the worst: the least real part over the half plane is on its edge.
        let least =
            ends.map(|x| shown(&it, c(0.0, x - it.p22.im)).re).fold(f64::INFINITY, f64::min);
        if it.is_absolutely_stable() {
            assert!(least >= -1e-9, "{it:?} {least}");
            for _ in 0..20 {
                let end = c(chance.decades(1e-3, 1e3), chance.within(-9.0, 9.0));
                assert!(shown(&it, end).re >= -1e-12, "{it:?}");
            }
            stable += 1;
        } else if it.margin() < -0.01 {
            assert!(least < 0.0, "{it:?} {least}");
            unstable += 1;
        }
    }
    assert!(stable > 300 && unstable > 300, "{stable} {unstable}");
}

/// Adams and Hannaford's haptic display of the impedance kind with a virtual coupling: device `b + m s`, coupling
/// `b_c + k_c / s`.
fn display(frequency: f64, damping: f64, coupling: Complex<f64>) -> TwoPort {
    let device = c(damping, 0.2 * frequency);
    TwoPort { p11: device, p12: c(1.0, 0.0), p21: c(-1.0, 0.0), p22: coupling.inv() }
}

#[test]
fn a_passive_coupling_is_always_stable_without_a_hold() {
    let coupled = |w: f64| display(w, 0.01, c(3.0, -900.0 / w));
    assert_eq!(first_violation((1..3000).map(f64::from), coupled), None);
    let pushing = |w: f64| display(w, 0.01, c(if w > 100.0 { -3.0 } else { 3.0 }, -900.0 / w));
    assert_eq!(first_violation((1..3000).map(f64::from), pushing), Some(101.0));
}

/// Held, the condition is `Re(1/Z_c) ≥ (1 − cos ∠ZOH) |ZOH| / (2 Re Z_d)`: their equation for the impedance display.
#[test]
fn with_a_hold_the_coupling_must_be_compliant() {
    let period = 1e-3;
    let mut chance = Chance::new(32);
    for _ in 0..2000 {
        let w = chance.within(1.0, std::f64::consts::PI / period);
        let damping = chance.decades(0.01, 100.0);
        let half = 0.5 * w * period;
        let size = half.sin() / half;
        let least = (1.0 - half.cos()) * size / (2.0 * damping);
        for (share, stable) in [(1.0 + 1e-9, true), (1.0 - 1e-9, false)] {
            // A coupling whose compliance has this real part.
            let coupling = c(least * share, chance.within(-1.0, 1.0)).inv();
            let it = display(w, damping, coupling).held(w, period);
            assert_eq!(it.is_absolutely_stable(), stable, "{it:?}");
        }
    }
}

#[test]
fn a_hold_is_the_mean_of_the_delays_up_to_one_period() {
    assert_eq!(hold(0.0, 1e-3), c(1.0, 0.0));
    // The transfer function is an integral; the sum approximates it.
    for w in [10.0, 1000.0, 3000.0] {
        let count = 20_000;
        let mean: Complex<f64> = (0..count)
            .map(|n| Complex::from_polar(1.0, -w * 1e-3 * (f64::from(n) + 0.5) / f64::from(count)))
            .sum::<Complex<f64>>()
            / f64::from(count);
        assert!((hold(w, 1e-3) - mean).norm() < 1e-9);
    }
}
