//! The whole family in the hard cases.

use std::ops::ControlFlow;

use lyapunov_lab::family::{BasicName, StabilizerName};
use lyapunov_lab::hard::Catalogue;

/// Laws that hold for every stabilizer: every output is finite, bad samples are rejected and the ones after them are
/// not, every correction is within its limit, and the ledger closes where one is kept. Only a stabilizer that promises
/// the bound has to keep it.
#[test]
fn every_stabilizer_keeps_the_laws_and_its_promises() {
    let (mut cases, mut over) = (Vec::new(), 0);
    let nobody = StabilizerName::Basic(BasicName::NoStabilizer);
    let family = || StabilizerName::ALL.into_iter().filter(|member| *member != nobody);
    for member in family() {
        let catalogue = Catalogue::of(Some(member), &|| ControlFlow::Continue(())).unwrap();
        assert_eq!(catalogue.stabilizer, Some(member.name()));
        for row in &catalogue.rows {
            let ours = format!("{member}: {row:#?}");
            assert!(row.passed && row.broken.is_none(), "{ours}");
            assert!(row.largest_force_n.is_finite() && row.ledger_off <= 1.0, "{ours}");
            assert!(row.measured <= row.bound || !row.promised, "{ours}");
            over += usize::from(row.measured > row.bound);
        }
        cases.push(catalogue.rows.len());
    }
    let all = Catalogue::cases().len();
    // Three cases do not apply: two are about the arithmetic of the ledger, one about two axes watched at once.
    for (member, cases) in family().zip(cases) {
        // Some take part only where the device has a damping, or where there is an environment that they can ask.
        let choosy = ["energy-bounding", "slope-bound", "virtual-coupling", "iss"];
        let chooses = choosy.contains(&member.name());
        let applies = if chooses { 10..all - 3 } else { all - 3..all - 2 };
        assert!(applies.contains(&cases), "{member} in {cases} of {all}");
    }
    // Some stabilizers exceed some bounds; otherwise the cases would not be hard.
    assert!(over > 20, "{over}");
}
