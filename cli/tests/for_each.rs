//! A check on random cases from a fixed seed.

use std::fmt::Debug;

use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestCaseError, TestRunner};

/// Panics at the first of so many `cases` that fails, made smaller by at most `shrinks` further checks.
pub(crate) fn for_each<C: Debug>(
    strategy: impl Strategy<Value = C>,
    cases: u32,
    shrinks: u32,
    seed: u64,
    check: impl Fn(&C) -> Result<(), String>,
) {
    let config = Config {
        cases,
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(seed),
        max_shrink_iters: shrinks,
        ..Config::default()
    };
    let checked = |case: C| check(&case).map_err(TestCaseError::fail);
    if let Err(error) = TestRunner::new(config).run(&strategy, checked) {
        panic!("{error}");
    }
}
