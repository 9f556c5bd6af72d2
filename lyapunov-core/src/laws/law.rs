//! The laws by name.

use core::fmt;

macro_rules! laws {
    ($($(#[$doc:meta])+ $law:ident: $sentence:literal, $cause:literal;)+) => {
        /// Property that every implementation of a trait must have.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        #[non_exhaustive]
        pub enum Law {
            $($(#[$doc])+ $law,)+
        }

        impl fmt::Display for Law {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(match self {
                    $(Self::$law => $sentence,)+
                })
            }
        }

        impl Law {
            /// The most frequent cause of a breach.
            pub fn likely_cause(self) -> &'static str {
                match self {
                    $(Self::$law => $cause,)+
                }
            }
        }
    };
}

// Each with the sentence of a message, and what most often breaks it.
laws! {
    /// Finite numbers in give finite numbers out.
    Finite: "finite numbers in must give finite numbers out",
        "a division by a velocity, a displacement or a period that may be 0 (give the divisor a least value: \
         `.larger(T::smallest_normal())`), or a sound sample that is not accepted";
    /// Two copies that see the same do the same: all state is in the value.
    Repeatable: "two copies that see the same must do the same",
        "state that is not in the value: a static, a shared cell, a clock, a generator without a seed";
    /// The reported damping and shortfall are not below 0.
    NoNegativeDamping: "damping and shortfall must not be below 0",
        "a sign: in debt `L` is below 0, and damping and shortfall count up from 0";
    /// The correction feeds no power into the motion it sees: `(f_out − f_in) · v >= 0` up to rounding.
    Opposes: "the correction must not feed power into the motion",
        "a sign (an effort resists the motion, so a damper adds `α v`), or an effort that is clipped inside";
    /// The corrected effort is between 0 and the uncorrected one, axis by axis and up to rounding.
    NoLarger: "an effort that is limited must not grow or turn round",
        "a correction that adds damping: check it with `laws::stabilizer`";
    /// `L + α v² T + shortfall >= 0` up to rounding.
    Served: "sum, correction and shortfall together must not be below 0",
        "a debt that is not told: shortfall is `max(0, −L − α v² T)`, also where nothing moves";
    /// The correction is no more than the limit times the velocity.
    WithinLimit: "the correction must stay within its limit",
        "a damping that is not held below its limit, or a correction that is not `α v`";
    /// The power that the correction takes out of the motion is at least that of the damping it tells,
    /// `(F − f) · v ≥ α v²`.
    Injects: "the damping that is told must be in the effort",
        "an `alpha` that is told and not injected: `effort + α v` that was clipped, shared out or scaled afterwards; \
         tell the smaller `α`, and what it leaves as shortfall";
    /// The supplied energy is the stored, less the dissipated and the shortfall.
    Balances: "supplied must be stored, dissipated and shortfall together",
        "a ledger that books something else than the candidate's decrease: sampled work in place of held, a tick left \
         out, a sum that loses digits, a reset";
    /// A sample that is not finite, or whose period is not above 0, gives a finite effort; a bad effort is reported as
    /// not accepted.
    Rejects: "a sample that is not finite must be rejected with a finite effort",
        "a field or the effort that is not looked at: end with `Correction::checked()`, and take `α` and velocity as \
         0 where they are not finite";
    /// After a sample that was not finite, the effort is finite again.
    Recovers: "after a sample that is not finite, the next must be finite again",
        "a state that took in what is not finite: book only what is (`Observer::observe` does), and keep the last \
         sound value by a select";
    /// Where nothing moves and no effort is applied, nothing is credited.
    NothingForNothing: "where nothing happens, nothing must be credited",
        "a credit that does not vanish at rest: one of the period, of the position or of the time alone";
    /// The sample reports the motion: displacements lead from position to position, the work is that of the effort
    /// over them, and the effort reported is the one applied.
    TellsTheTruth: "the sample must tell what moved and which effort was applied",
        "a sample that is not told from one state: a displacement that is not the difference of two positions, an \
         effort of another tick, a work that is not `applied · displacement`";
    /// An adaptor reports the correction of the port it owns.
    HandsOn: "an adaptor must hand on the correction of the port it owns",
        "`OnePort::correction` left at its default: hand on that of the port inside, unchanged";
    /// No lane depends on the values of the others.
    LaneByLane: "a lane must not depend on the others",
        "a decision for all lanes at once, by `all`, `any` or one lane: choose lane by lane instead";
    /// The error falls with the step as the order says, towards the solution of the differential equation.
    Converges: "the error must fall with the step as the order says",
        "a stage at the wrong place, a weight that is off, or an interval over which the motion turns much";
    /// `V(0) = 0`.
    ZeroAtRest: "V must be 0 at rest",
        "a constant in `V`, or coordinates that are not counted from rest";
    /// `V(x) > 0` away from rest.
    Positive: "V must be above 0 away from rest",
        "a direction in which `V` is flat or falls, or digits lost in a difference (`2 sin²(θ/2)` for `1 − cos θ`)";
    /// The gradient is the slope of `V`.
    Slope: "the gradient must be the slope of V",
        "a term of the gradient with a wrong factor or sign";
    /// The candidate's decreases sum to the difference of `V`.
    AddsUp: "the decreases must sum to the difference of V",
        "a rate times the period in place of a difference, or a term of `V` that the candidate leaves out";
    /// A value to which a state was restored goes on as the one it was taken from.
    Resumes: "a restored state must go on as the one it was taken from",
        "a number that changes from tick to tick and is not in `Snapshot::State`";
}
