//! The laws by name.

use core::fmt;

/// Property that every implementation of a trait must have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Law {
    /// Finite numbers in give finite numbers out.
    Finite,
    /// Two copies that see the same do the same: all state is in the value.
    Repeatable,
    /// The reported damping and shortfall are not below 0.
    NoNegativeDamping,
    /// The correction feeds no power into the motion it sees: `(f_out − f_in) · v >= 0` up to rounding.
    Opposes,
    /// The corrected effort is between 0 and the uncorrected one, axis by axis and up to rounding.
    NoLarger,
    /// `L + α v² T + shortfall >= 0` up to rounding.
    Served,
    /// The correction is no more than the limit times the velocity.
    WithinLimit,
    /// The power that the correction takes out of the motion is at least that of the damping it tells,
    /// `(F − f) · v ≥ α v²`.
    Injects,
    /// The supplied energy is the stored, less the dissipated and the shortfall.
    Balances,
    /// A sample that is not finite, or whose period is not above 0, gives a finite effort; a bad effort is reported as
    /// not accepted.
    Rejects,
    /// After a sample that was not finite, the effort is finite again.
    Recovers,
    /// Where nothing moves and no effort is applied, nothing is credited.
    NothingForNothing,
    /// The sample reports the motion: displacements lead from position to position, the work is that of the effort
    /// over them, and the effort reported is the one applied.
    TellsTheTruth,
    /// An adaptor reports the correction of the port it owns.
    HandsOn,
    /// No lane depends on the values of the others.
    LaneByLane,
    /// The error falls with the step as the order says, towards the solution of the differential equation.
    Converges,
    /// `V(0) = 0`.
    ZeroAtRest,
    /// `V(x) > 0` away from rest.
    Positive,
    /// The gradient is the slope of `V`.
    Slope,
    /// The candidate's decreases sum to the difference of `V`.
    AddsUp,
    /// A value to which a state was restored goes on as the one it was taken from.
    Resumes,
}

impl fmt::Display for Law {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Finite => "finite numbers in must give finite numbers out",
            Self::Repeatable => "two copies that see the same must do the same",
            Self::NoNegativeDamping => "damping and shortfall must not be below 0",
            Self::Opposes => "the correction must not feed power into the motion",
            Self::NoLarger => "an effort that is limited must not grow or turn round",
            Self::Served => "sum, correction and shortfall together must not be below 0",
            Self::WithinLimit => "the correction must stay within its limit",
            Self::Injects => "the damping that is told must be in the effort",
            Self::Balances => "supplied must be stored, dissipated and shortfall together",
            Self::Rejects => "a sample that is not finite must be rejected with a finite effort",
            Self::Recovers => "after a sample that is not finite, the next must be finite again",
            Self::NothingForNothing => "where nothing happens, nothing must be credited",
            Self::TellsTheTruth => "the sample must tell what moved and which effort was applied",
            Self::HandsOn => "an adaptor must hand on the correction of the port it owns",
            Self::LaneByLane => "a lane must not depend on the others",
            Self::Converges => "the error must fall with the step as the order says",
            Self::ZeroAtRest => "V must be 0 at rest",
            Self::Positive => "V must be above 0 away from rest",
            Self::Slope => "the gradient must be the slope of V",
            Self::AddsUp => "the decreases must sum to the difference of V",
            Self::Resumes => "a restored state must go on as the one it was taken from",
        })
    }
}

impl Law {
    /// What most often breaks it.
    pub fn likely_cause(self) -> &'static str {
        match self {
            Self::Finite => {
                "a division by a velocity, a displacement or a period that may be 0 (give the divisor a least value: \
                 `.larger(T::smallest_normal())`), or a sound sample that is not accepted"
            }
            Self::Repeatable => {
                "state that is not in the value: a static, a shared cell, a clock, a generator without a seed"
            }
            Self::NoNegativeDamping => {
                "a sign: in debt `L` is below 0, and damping and shortfall count up from 0"
            }
            Self::Opposes => {
                "a sign (an effort resists the motion, so a damper adds `α v`), or an effort that is clipped inside"
            }
            Self::NoLarger => "a correction that adds damping: check it with `laws::stabilizer`",
            Self::Served => {
                "a debt that is not told: shortfall is `max(0, −L − α v² T)`, also where nothing moves"
            }
            Self::WithinLimit => {
                "a damping that is not held below its limit, or a correction that is not `α v`"
            }
            Self::Injects => {
                "an `alpha` that is told and not injected: `effort + α v` that was clipped, shared out or scaled \
                 afterwards; tell the smaller `α`, and what it leaves as shortfall"
            }
            Self::Balances => {
                "a ledger that books something else than the candidate's decrease: sampled work in place of held, a \
                 tick left out, a sum that loses digits, a reset"
            }
            Self::Rejects => {
                "a field or the effort that is not looked at: end with `Correction::checked()`, and take `α` and \
                 velocity as 0 where they are not finite"
            }
            Self::Recovers => {
                "a state that took in what is not finite: book only what is (`Observer::observe` does), and keep the \
                 last sound value by a select"
            }
            Self::NothingForNothing => {
                "a credit that does not vanish at rest: one of the period, of the position or of the time alone"
            }
            Self::TellsTheTruth => {
                "a sample that is not told from one state: a displacement that is not the difference of two positions, \
                 an effort of another tick, a work that is not `applied · displacement`"
            }
            Self::HandsOn => {
                "`OnePort::correction` left at its default: hand on that of the port inside, unchanged"
            }
            Self::LaneByLane => {
                "a decision for all lanes at once, by `all`, `any` or one lane: choose lane by lane instead"
            }
            Self::Converges => {
                "a stage at the wrong place, a weight that is off, or an interval over which the motion turns much"
            }
            Self::ZeroAtRest => "a constant in `V`, or coordinates that are not counted from rest",
            Self::Positive => {
                "a direction in which `V` is flat or falls, or digits lost in a difference (`2 sin²(θ/2)` for \
                 `1 − cos θ`)"
            }
            Self::Slope => "a term of the gradient with a wrong factor or sign",
            Self::AddsUp => {
                "a rate times the period in place of a difference, or a term of `V` that the candidate leaves out"
            }
            Self::Resumes => {
                "a number that changes from tick to tick and is not in `Snapshot::State`"
            }
        }
    }
}
