//! Damping limits against closed forms.

use lyapunov::DampingLimit;

fn most(limit: Result<DampingLimit<f64>, lyapunov::ParameterError>) -> f64 {
    limit.expect("a limit").most()
}

#[test]
fn a_limit_is_a_share_of_mass_over_period() {
    let inf = f64::INFINITY;
    assert_eq!(most(DampingLimit::of_mass(0.5, 6.0, 0.25)), 12.0);
    assert_eq!(most(DampingLimit::of_mass(0.0, 6.0, 0.25)), 0.0);
    assert_eq!(most(DampingLimit::of_mass(inf, 6.0, 0.25)), f64::MAX);
    assert_eq!((most(DampingLimit::at(7.0)), most(DampingLimit::at(inf))), (7.0, f64::MAX));
    for bad in [-1.0, f64::NAN] {
        assert!(DampingLimit::at(bad).is_err() && DampingLimit::of_mass(bad, 6.0, 0.25).is_err());
        assert!(DampingLimit::of_stiffness(bad, 6.0, 0.25).is_err());
    }
    for bad in [-1.0, 0.0, f64::NAN, inf] {
        assert!(DampingLimit::of_mass(0.5, bad, 0.25).is_err());
        assert!(DampingLimit::of_mass(0.5, 6.0, bad).is_err());
        assert!(DampingLimit::of_stiffness(0.5, bad, 0.25).is_err());
        assert!(DampingLimit::of_stiffness(0.5, 6.0, bad).is_err());
    }
}

/// Also where the product of stiffness and period is too small or too large for the scalar.
#[test]
fn a_limit_of_a_mobility_is_over_stiffness_times_period() {
    assert_eq!(most(DampingLimit::of_stiffness(6.0, 8.0, 0.25)), 3.0);
    assert_eq!(most(DampingLimit::of_stiffness(0.0, 1e-200, 1e-200)), 0.0);
    for (cap, part) in [(2f64.powi(-900), -600), (2f64.powi(900), 600)] {
        let limit = most(DampingLimit::of_stiffness(cap, 2f64.powi(part), 2f64.powi(part)));
        assert_eq!(limit, cap * 2f64.powi(-part) * 2f64.powi(-part));
    }
    assert_eq!(most(DampingLimit::of_stiffness(3.0, 2f64.powi(-600), 2f64.powi(-600))), f64::MAX);
}

/// `tan(π / (4 (d + 1)))` for 0 to 3 ticks and 5: 1, √2 − 1, 2 − √3, and by halving the angle.
#[test]
fn a_late_force_has_a_smaller_limit() {
    let limit = DampingLimit::at(8.0).expect("a limit");
    let half = |tangent: f64| ((1.0 + tangent * tangent).sqrt() - 1.0) / tangent;
    let (root_2, root_3) = (2f64.sqrt(), 3f64.sqrt());
    for (ticks, share) in [
        (0, 1.0),
        (1, root_2 - 1.0),
        (2, 2.0 - root_3),
        (3, half(root_2 - 1.0)),
        (5, half(2.0 - root_3)),
    ] {
        assert!((limit.delayed(ticks).most() - 8.0 * share).abs() < 1e-14, "{ticks} ticks");
    }
}
