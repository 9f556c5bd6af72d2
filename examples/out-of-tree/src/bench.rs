//! Every command of `lyapunov`, with the own stabilizer and the own candidate among those that ship.

use std::process::ExitCode;

use lyapunov::{LyapunovCandidate, ParameterError, PortEnergy, Signal, Stabilizer};
use lyapunov_cli::Bench;
use lyapunov_lab::own::{Allowed, Loop, OwnCandidate, OwnNumber, OwnStabilizer, Promise, Search};
use out_of_tree::{DryFriction, WhileGiving};

fn main() -> ExitCode {
    Bench::new().stabilizer::<GivingEntrant>().candidate::<FrictionEntrant>().main()
}

/// `while-giving`: it waits, so it promises no more than damping within its limit.
struct GivingEntrant;

impl OwnStabilizer for GivingEntrant {
    const NAME: &'static str = "while-giving";
    const NUMBERS: &'static [OwnNumber] = &[OwnNumber::DAMPING_CAP];
    const PROMISE: Promise = Promise::Damps;

    fn make<V: Signal>(on: &Loop<'_>) -> Result<impl Stabilizer<V> + 'static, ParameterError> {
        Ok(WhileGiving::new(PortEnergy, on.damping_limit::<V::Scalar>()?))
    }
}

/// `lolc-dry-friction`: LOLC with the own candidate.
struct FrictionEntrant;

/// The friction that the device surely has: none, unless a scene says so.
const FORCE: OwnNumber = OwnNumber::new("force", "N", Allowed::NonNegative, |on| {
    let friction = on.scene().and_then(|scene| scene.effects.friction);
    friction.map_or(0.0, |friction| friction.coulomb.get())
})
.searched(|default, _| Search::up_to(2.0 * default));

impl OwnCandidate for FrictionEntrant {
    const NAME: &'static str = "dry-friction";
    const NUMBERS: &'static [OwnNumber] = &[FORCE];
    const PROMISE: Promise = Promise::Serves;

    fn make<V: Signal>(
        on: &Loop<'_>,
    ) -> Result<impl LyapunovCandidate<V> + 'static, ParameterError> {
        DryFriction::of(on.number::<V::Scalar>(FORCE))
    }
}
