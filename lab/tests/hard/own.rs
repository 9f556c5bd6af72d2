//! Faulty stabilizers: each fails a hard case by the same law as in `lyapunov::laws`.

use lyapunov::laws::{self, Law, Samples};
use lyapunov::{Correction, DampingLimit, Lolc, PortEnergy, PortSample, Stabilizer};
use lyapunov_lab::AnyStabilizer;
use lyapunov_lab::hard::{Catalogue, Tally};

/// Stabilizer that spoils a right correction.
#[derive(Clone)]
struct Wrong {
    popc: Lolc<f64, PortEnergy>,
    spoil: fn(&PortSample<f64>, f64, Correction<f64>) -> Correction<f64>,
}

impl Stabilizer<f64> for Wrong {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        let correction = self.popc.stabilize(sample, effort);
        (self.spoil)(sample, effort, correction)
    }
}

fn limit() -> DampingLimit<f64> {
    DampingLimit::of_mass(0.5, 0.2, 1e-3).expect("a limit")
}

fn tried(case: &str, stabilizer: &(impl Stabilizer<f64> + Clone + 'static)) -> Tally {
    let cases = Catalogue::cases();
    let case = cases.iter().find(|it| it.name == case).expect("a case");
    let own = || AnyStabilizer::new(stabilizer.clone());
    case.with(&own).expect("a run").expect("a case for one value at a time")
}

/// Asserts that the case and the shipped laws name the same law.
#[track_caller]
fn fails(
    case: &str,
    law: Law,
    spoil: fn(&PortSample<f64>, f64, Correction<f64>) -> Correction<f64>,
) {
    let wrong = Wrong { popc: Lolc::new(PortEnergy, limit()), spoil };
    let (broken, _) = tried(case, &wrong).broken.expect("broken");
    let samples = Samples::<f64>::new(1e-3);
    let told = laws::stabilizer(&wrong, samples)
        .and_then(|()| laws::ledger(&wrong, &PortEnergy, limit().most(), samples))
        .expect_err("broken");
    assert_eq!((broken, told.law), (law, law));
    assert!(told.to_string().contains(&broken.to_string()));
}

#[test]
fn a_right_stabilizer_breaks_no_law() {
    let right = Lolc::new(PortEnergy, limit());
    for case in ["a debt at rest", "NaN once", "a stale sample", "time stamps after 1e9 s"] {
        let tally = tried(case, &right);
        assert!(tally.broken.is_none() && tally.peak_force > 0.0, "{case}: {tally:?}");
    }
    let samples = Samples::<f64>::new(1e-3);
    laws::ledger(&right, &PortEnergy, limit().most(), samples).expect("the account");
}

#[test]
fn a_division_by_rest_is_not_finite() {
    fails("a debt at rest", Law::Finite, |sample, effort, correction| {
        let square = sample.velocity.powi(2) * sample.period;
        let most = if square > 0.0 { limit().most() } else { f64::INFINITY };
        let alpha = if correction.observed_energy < 0.0 {
            (-correction.observed_energy / square).min(most)
        } else {
            0.0
        };
        let accepted = effort.is_finite() && sample.sound();
        let effort = if accepted { effort + alpha * sample.velocity } else { 0.0 };
        Correction { effort, alpha, accepted, ..correction }
    });
}

#[test]
fn a_pull_along_the_motion_does_not_oppose() {
    fails("a debt at rest", Law::Opposes, |sample, effort, correction| {
        let pulled = effort - correction.alpha * sample.velocity;
        Correction { effort: if correction.accepted { pulled } else { 0.0 }, ..correction }
    });
}

#[test]
fn a_negative_damping_is_reported() {
    fails("a debt at rest", Law::NoNegativeDamping, |_, _, correction| Correction {
        alpha: -correction.alpha,
        ..correction
    });
}

#[test]
fn an_unreported_debt_is_not_served() {
    fails("a debt at rest", Law::Served, |_, _, correction| Correction {
        shortfall: 0.0,
        ..correction
    });
}

#[test]
fn a_ledger_that_forgets_does_not_balance() {
    fails("a debt at rest", Law::Balances, |_, _, correction| Correction {
        observed_energy: correction.observed_energy * (1.0 - 1e-9),
        ..correction
    });
}

#[test]
fn a_correction_beyond_the_limit_is_reported() {
    fails("a debt at rest", Law::WithinLimit, |sample, effort, correction| {
        let alpha = if correction.alpha > 0.0 { correction.alpha + 200.0 } else { 0.0 };
        let effort = if correction.accepted { effort + alpha * sample.velocity } else { 0.0 };
        Correction { effort, alpha, ..correction }
    });
}

#[test]
fn a_sample_that_is_not_finite_has_to_be_rejected() {
    fails("NaN once", Law::Rejects, |_, effort, correction| Correction {
        effort: if correction.accepted { correction.effort } else { effort },
        ..correction
    });
}
