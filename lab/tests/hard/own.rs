//! A stabilizer of one's own fails a hard case in the words of the shipped laws.

use lyapunov::laws::{self, Law, Samples};
use lyapunov::{Action, DampingLimit, Drive, Lolc, PortEnergy, Stabilizer};
use lyapunov_lab::AnyStabilizer;
use lyapunov_lab::hard::{Catalogue, Tally};

/// A stabilizer with something wrong in what it makes of the right action.
#[derive(Clone)]
struct Wrong {
    popc: Lolc<f64, PortEnergy>,
    spoil: fn(&Drive<f64>, f64, Action<f64>) -> Action<f64>,
}

impl Stabilizer<f64> for Wrong {
    fn stabilize(&mut self, drive: &Drive<f64>, effort: f64) -> Action<f64> {
        let action = self.popc.stabilize(drive, effort);
        (self.spoil)(drive, effort, action)
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

/// The case and the shipped laws name the same law.
#[track_caller]
fn fails(case: &str, law: Law, spoil: fn(&Drive<f64>, f64, Action<f64>) -> Action<f64>) {
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
fn a_right_one_breaks_nothing() {
    let right = Lolc::new(PortEnergy, limit());
    for case in ["a debt at rest", "NaN once", "a stale sample"] {
        assert_eq!(tried(case, &right).broken, None, "{case}");
    }
    let samples = Samples::<f64>::new(1e-3);
    laws::ledger(&right, &PortEnergy, limit().most(), samples).expect("the account");
}

#[test]
fn a_division_by_rest_is_not_finite() {
    fails("a debt at rest", Law::Finite, |drive, effort, action| {
        let square = drive.velocity.powi(2) * drive.period;
        let most = if square > 0.0 { limit().most() } else { f64::INFINITY };
        let alpha = if action.sum < 0.0 { (-action.sum / square).min(most) } else { 0.0 };
        let accepted = effort.is_finite() && drive.finite();
        let effort = if accepted { effort + alpha * drive.velocity } else { 0.0 };
        Action { effort, alpha, accepted, ..action }
    });
}

#[test]
fn a_pull_along_the_motion_does_not_oppose() {
    fails("a debt at rest", Law::Opposes, |drive, effort, action| {
        let pulled = effort - action.alpha * drive.velocity;
        Action { effort: if action.accepted { pulled } else { 0.0 }, ..action }
    });
}

#[test]
fn a_negative_damping_is_told() {
    fails("a debt at rest", Law::NoNegativeDamping, |_, _, action| Action {
        alpha: -action.alpha,
        ..action
    });
}

#[test]
fn a_debt_that_is_not_told_is_not_served() {
    fails("a debt at rest", Law::Served, |_, _, action| Action { shortfall: 0.0, ..action });
}

#[test]
fn a_sum_that_forgets_does_not_balance() {
    fails("a debt at rest", Law::Balances, |_, _, action| Action {
        sum: action.sum * (1.0 - 1e-9),
        ..action
    });
}

#[test]
fn a_correction_beyond_the_limit_is_told() {
    fails("a debt at rest", Law::WithinLimit, |drive, effort, action| {
        let alpha = if action.alpha > 0.0 { action.alpha + 200.0 } else { 0.0 };
        let effort = if action.accepted { effort + alpha * drive.velocity } else { 0.0 };
        Action { effort, alpha, ..action }
    });
}

#[test]
fn a_sample_that_is_not_finite_has_to_be_rejected() {
    fails("NaN once", Law::Rejects, |_, effort, action| Action {
        effort: if action.accepted { action.effort } else { effort },
        ..action
    });
}
