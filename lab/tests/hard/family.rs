//! The whole family in the hard cases.

use std::ops::ControlFlow;

use lyapunov_lab::family::{BasicName, StabilizerName};
use lyapunov_lab::hard::Catalogue;

/// Whatever its promise: every output is finite, what is bad is rejected and what follows is not, every correction is within
/// its limit, and the account closes where one is kept. Its bound is kept by those that promise it.
#[test]
fn every_member_keeps_what_it_is_held_to() {
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
    // Two are about how a sum is kept, one about watching two axes at once.
    assert_eq!(cases, vec![all - 3; family().count()]);
    // Not every bound is kept by everybody, or the cases would not be hard.
    assert!(over > 20, "{over}");
}
