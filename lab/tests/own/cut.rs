//! Own stabilizer that makes efforts smaller and adds no damping.

use lyapunov::{Correction, ParameterError, PortSample, Scalar, Signal, Stabilizer};
use lyapunov_lab::family::Judgement;
use lyapunov_lab::own::{Allowed, Loop, OwnNumber, OwnStabilizer, Promise};

use super::{name, shipped};

/// Half of every effort: no damper.
struct Half;

impl<V: Signal> Stabilizer<V> for Half {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let accepted = sample.sound() & effort.finite();
        let half = V::choose(accepted, effort.scale(V::Scalar::of(0.5)), V::zero());
        Correction { accepted, ..Correction::none(half) }
    }
}

const PACE: OwnNumber = OwnNumber::new("pace", "m/s", Allowed::Positive, |on| on.speed());
const ENERGY: OwnNumber = OwnNumber::new("energy", "J", Allowed::Positive, |on| on.energy());

own!(Cutter, "cutter", [PACE, ENERGY], Cuts, |_| Ok(Half));

/// The judgement without a damper, and the scales that a loop offers for numbers.
#[test]
fn what_only_cuts_is_judged_by_energy_and_force() {
    assert_eq!(name("cutter").judgement(), Judgement::EnergyAndForce);
    assert_eq!(name("my-popc").judgement(), Judgement::Settling);
    let numbers = name("cutter").parameters(&shipped("hold"));
    let [pace, energy] = [0, 1].map(|place| numbers[place].default.unwrap());
    // The device of 0.2 kg and the hand of 0.1 kg.
    assert!((0.5 * 0.3 * pace * pace / energy - 1.0).abs() < 1e-12, "{pace} m/s, {energy} J");
}
