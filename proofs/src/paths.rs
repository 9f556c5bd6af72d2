//! Paths: every way through a step, one run each.

use std::cell::RefCell;

use crate::symbolic::Truth;
use crate::tape::{self, Node};

/// One way: what was decided, and what construction and state are known to be.
#[derive(Debug, Default)]
struct Way {
    /// What to decide, in this order; past its end everything is true first.
    choices: Vec<(usize, usize)>,
    taken: usize,
    decided: Vec<(Truth, bool)>,
    known: Vec<Truth>,
    is_stepping: bool,
}

thread_local! {
    static WAY: RefCell<Way> = RefCell::default();
}

/// What held on a way, and what came of it.
#[derive(Debug)]
pub(crate) struct Path<R> {
    pub(crate) known: Vec<Truth>,
    pub(crate) decided: Vec<(Truth, bool)>,
    pub(crate) result: R,
}

/// `run` on every way through it.
pub(crate) fn every<R>(run: impl Fn() -> R) -> Vec<Path<R>> {
    let mut found = Vec::new();
    WAY.with_borrow_mut(|way| *way = Way::default());
    loop {
        let result = run();
        let more = WAY.with_borrow_mut(|way| {
            let (known, decided) = (way.known.split_off(0), way.decided.split_off(0));
            found.push(Path { known, decided, result });
            way.taken = 0;
            while let Some((choice, of)) = way.choices.pop() {
                if choice + 1 < of {
                    way.choices.push((choice + 1, of));
                    return true;
                }
            }
            false
        });
        if !more {
            return found;
        }
    }
}

/// Takes it for known that `truth` holds.
pub(crate) fn assume(truth: Truth) {
    WAY.with_borrow_mut(|way| way.known.push(truth));
}

/// The answer of a `step`, on every way through it. Elsewhere, where parameters and memory are checked, the witnesses decide.
pub(crate) fn step<R>(step: impl FnOnce() -> R) -> R {
    let stepping = |is: bool| WAY.with_borrow_mut(|way| way.is_stepping = is);
    stepping(true);
    let told = step();
    stepping(false);
    told
}

/// One of `of` choices, each on a way of its own.
pub(crate) fn choose(of: usize) -> usize {
    WAY.with_borrow_mut(|way| {
        if way.taken == way.choices.len() {
            way.choices.push((0, of));
        }
        way.taken += 1;
        way.choices[way.taken - 1].0
    })
}

/// Whether `truth` holds on this way.
pub(crate) fn decide(truth: Truth) -> bool {
    if let Node::Truth(truth) = tape::with(|tape| tape.node(truth.0)) {
        return truth;
    }
    if !WAY.with_borrow(|way| way.is_stepping) {
        return tape::with(|tape| tape.witnesses[truth.0 as usize] != 0.0);
    }
    let before = WAY.with_borrow(|way| {
        way.decided.iter().find(|(other, _)| other.0 == truth.0).map(|(_, decided)| *decided)
    });
    before.unwrap_or_else(|| {
        let decided = choose(2) == 0;
        WAY.with_borrow_mut(|way| way.decided.push((truth, decided)));
        decided
    })
}
