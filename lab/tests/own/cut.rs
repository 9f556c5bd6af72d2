//! Own stabilizer that makes efforts smaller and adds no damping.

use lyapunov::{Correction, ParameterError, PortSample, Requirement, Scalar, Signal, Stabilizer};
use lyapunov_lab::family::Judgement;
use lyapunov_lab::own::{Allowed, Loop, OwnNumber, OwnStabilizer, Promise};
use lyapunov_lab::scenes::text_of;

use super::{fault, name, parsed, shipped};

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

const SHARE: OwnNumber = OwnNumber::new("share", "", Allowed::Positive, |_| 0.05);

own!(Choosing, "choosing", [SHARE], Cuts, |on| {
    let share = on.number::<f64>(SHARE);
    Requirement::AtMost(0.1).check("share", share)?;
    Requirement::AtLeast(1.0).check("half of a share", 500.0 * share).map(|_| Half)
});

/// The maker's own requirement is told, and not that a loop left the range.
#[test]
fn what_a_maker_refuses_is_told_in_its_words() {
    let text = text_of("hold").expect("a scene");
    parsed(&text.replace("[stabilizer.popc]", "[stabilizer.choosing]\nshare = 0.1"));
    let told = fault("[stabilizer.choosing]\nshare = 0.5");
    assert!(told.contains("hold.toml:24:9: share is 0.5; it must be at most 0.1"), "{told}");
    assert!(told.contains("`stabilizer.choosing.share` = 0.5 is that number"), "{told}");
    let told = fault("[stabilizer.choosing]\nshare = 0.001");
    assert!(told.contains("half of a share is 0.5; it must be at least 1.0 and finite"), "{told}");
    assert!(told.contains("hold.toml:23") && told.contains("that it follows from"), "{told}");
    for told in [fault("[stabilizer.choosing]\nshare = 0.5"), told] {
        assert!(!told.contains("range") && !told.contains("nearer to 1"), "{told}");
    }
}
