//! The cases of the catalogue, by theme.

mod axes;
mod contact;
mod delay;
mod environment;
mod faults;
mod found;
mod limit;
mod reading;
mod scale;
mod signals;
mod stiffness;
mod time;

use crate::studies::hard::case::Case;

/// Every case, in the order of the report.
pub(super) fn all() -> Vec<Case> {
    [
        signals::cases(),
        faults::cases(),
        reading::cases(),
        time::cases(),
        stiffness::cases(),
        contact::cases(),
        delay::cases(),
        limit::cases(),
        environment::cases(),
        axes::cases(),
        scale::cases(),
        found::cases(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::*;
    use crate::studies::hard::table::with_unit;

    #[test]
    fn every_case_fits_its_two_lines_under_a_name_of_its_own() {
        let cases = all();
        for case in &cases {
            let (name, hard) = (case.name, case.hard);
            let bound = with_unit(case.bound, case.quantity.unit);
            let promise = format!("{} <= {bound}", case.quantity.words);
            assert!(name.len() <= 31 && hard.len() <= 94, "{name}: {}", hard.len());
            assert!(promise.len() <= 36, "{name}: {promise}");
        }
        let names: BTreeSet<_> = cases.iter().map(|case| case.name).collect();
        assert_eq!(names.len(), cases.len());
    }
}
