//! Stabilizer chosen at run time.

use std::fmt;

use lyapunov::{
    Correction, DampingLimit, Dissipation, Held, Lolc, LyapunovCandidate, OnePort, ParameterError,
    PortEnergy, PortSample, Signal, Stabilizer,
    accumulators::{Accumulator, Compensated},
    environments::ForceLaw,
};

use super::assembly::measured;
use super::on::On;
use super::{Port, Scenes, Space};
use crate::files::scene::{self, Candidate, Damping, Lanes, Ledger, Render, Work};
use crate::simulate::instructions::Instructions;

/// Any stabilizer of efforts, boxed: one that a scene file names, or your own.
pub struct AnyStabilizer<V: Signal>(Box<dyn Replay<V>>);

impl<V: Signal> AnyStabilizer<V> {
    /// Bytes that the stabilizer keeps from tick to tick, parameters included.
    pub fn state_bytes(&self) -> usize {
        self.0.state_bytes()
    }

    /// `port` watched and corrected by this stabilizer, its motion measured as `scene` says: one part, compiled for its
    /// type, instead of a box in a box.
    pub(super) fn on(self, port: Port<V>, scenes: Scenes<'_>) -> Result<Port<V>, ParameterError> {
        self.0.on(port, scenes)
    }

    /// Runs the stabilizer over `samples` in order, without a call through a table for each.
    pub(crate) fn replay(
        &mut self,
        samples: &[(PortSample<V>, V)],
        corrections: &mut [Correction<V>],
    ) {
        self.0.replay(samples, corrections);
    }
}

impl<V: Space> AnyStabilizer<V> {
    /// Boxes `stabilizer`.
    pub fn new(stabilizer: impl Stabilizer<V> + 'static) -> Self {
        Self::fused(stabilizer, Instructions::Base)
    }

    /// Boxes `stabilizer` for a loop that calls it through a table: no loop is compiled for its type.
    pub(crate) fn called(stabilizer: impl Stabilizer<V> + 'static) -> Self {
        Self::called_on(stabilizer, Instructions::Base)
    }

    /// The same, with its steps on `instructions`.
    pub(super) fn called_on(
        stabilizer: impl Stabilizer<V> + 'static,
        instructions: Instructions,
    ) -> Self {
        Self(Box::new(Called(On::new(stabilizer, instructions))))
    }

    /// Boxes `stabilizer` with a loop compiled for its type, and its steps on `instructions`.
    pub(super) fn fused(
        stabilizer: impl Stabilizer<V> + 'static,
        instructions: Instructions,
    ) -> Self {
        let part = On::new(stabilizer, instructions);
        // Loops that are small rather than fast call every stabilizer.
        Self(if cfg!(feature = "every-scalar") { Box::new(part) } else { Box::new(Called(part)) })
    }

    /// POPC or LOLC of the tables, one for each scene and alike in all but numbers.
    ///
    /// # Errors
    /// A parameter that is right by itself but out of the range of the scalar, alone or with others; another table.
    pub(super) fn observing(
        scenes: Scenes<'_>,
        tables: &[scene::Stabilizer],
    ) -> Result<Self, ParameterError> {
        let (work, ledger, candidate) = match Lanes::new(tables).common() {
            scene::Stabilizer::Popc(popc) => (popc.work, popc.ledger, Candidate::Spring),
            scene::Stabilizer::Lolc(lolc) => (lolc.work, lolc.ledger, lolc.candidate),
            _ => return Err(scene::elsewhere()),
        };
        let limit = Damping::limit_of_lanes(&|lane| {
            let (scene, table) = (scenes.lane(lane), Lanes::new(tables).lane(lane));
            // The cap that is written, else the default of the scene.
            scene.damping(table.written("damping_cap").unwrap_or_else(|| scene.default_cap()))
        })?;
        let booking = Booking { work, ledger, limit, instructions: scenes.instructions() };
        // A loop is compiled for the two candidates that most scenes have; environments have as many as they are.
        let by_default = (work, ledger) == (Work::Held, Ledger::Plain);
        Ok(match candidate {
            Candidate::Spring if by_default => {
                Self::fused(Lolc::new(PortEnergy, limit), booking.instructions)
            }
            Candidate::Spring => Self::watching(PortEnergy, booking),
            Candidate::DeviceDamping => {
                let damper = Dissipation::of(scenes.each(|it| it.device.damping))?;
                if by_default {
                    let lolc = Lolc::new((PortEnergy, damper), limit);
                    Self::fused(lolc, booking.instructions)
                } else {
                    Self::watching((PortEnergy, damper), booking)
                }
            }
            Candidate::MassSpringDamper => V::render(scenes, booking)?,
        })
    }

    fn watching(
        candidate: impl LyapunovCandidate<V> + 'static,
        Booking { work, ledger, limit, instructions: on }: Booking<V::Scalar>,
    ) -> Self {
        // Only the default ledger of held work is compiled for each candidate; the others pay for a box with a call.
        let boxed = |candidate| Lolc::new(AnyCandidate::<V>(Box::new(candidate)), limit);
        match (work, ledger) {
            (Work::Held, Ledger::Plain) => Self::called_on(Lolc::new(candidate, limit), on),
            (Work::Sampled, Ledger::Plain) => Self::called_on(boxed(candidate).sampled(), on),
            (_, Ledger::Compensated) => {
                Self::booked(boxed(candidate).summed_in::<Compensated<V::Scalar>>(), work, on)
            }
            (_, Ledger::Wide) => Self::booked(boxed(candidate).summed_in::<V::Wide>(), work, on),
        }
    }

    fn booked<A: Accumulator<V::Scalar> + 'static>(
        lolc: Lolc<V::Scalar, AnyCandidate<V>, Held, A>,
        work: Work,
        on: Instructions,
    ) -> Self {
        match work {
            Work::Held => Self::called_on(lolc, on),
            Work::Sampled => Self::called_on(lolc.sampled(), on),
        }
    }
}

/// Work, ledger and damping limit of an observer/controller, and the instructions of its steps.
#[derive(Clone, Copy)]
struct Booking<T> {
    work: Work,
    ledger: Ledger,
    limit: DampingLimit<T>,
    instructions: Instructions,
}

/// Any candidate, boxed.
struct AnyCandidate<V: Signal>(Box<dyn LyapunovCandidate<V>>);

impl<V: Signal> LyapunovCandidate<V> for AnyCandidate<V> {
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        self.0.decrease(sample)
    }
}

impl<V: Signal> fmt::Debug for AnyStabilizer<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("AnyStabilizer").finish_non_exhaustive()
    }
}

impl<V: Signal> Stabilizer<V> for AnyStabilizer<V> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        self.0.stabilize(sample, effort)
    }
}

/// LOLC with the credit of the scene's own environment.
impl<V: Space> Render<V> for Booking<V::Scalar> {
    type Made = AnyStabilizer<V>;

    fn render(
        self,
        _environment: impl ForceLaw<V> + 'static,
        credit: impl LyapunovCandidate<V> + 'static,
    ) -> Result<Self::Made, ParameterError> {
        #[cfg(not(feature = "every-scalar"))]
        let credit = AnyCandidate::<V>(Box::new(credit));
        Ok(AnyStabilizer::watching((PortEnergy, credit), self))
    }
}

/// Stabilizer that can wrap a port or run over samples.
trait Replay<V: Signal>: Stabilizer<V> {
    fn state_bytes(&self) -> usize;

    fn on(self: Box<Self>, port: Port<V>, scenes: Scenes<'_>) -> Result<Port<V>, ParameterError>;

    fn replay(&mut self, samples: &[(PortSample<V>, V)], corrections: &mut [Correction<V>]);
}

/// Stabilizer that a loop calls through a table.
struct Called<S>(On<S>);

impl<V: Space, S: Stabilizer<V>> Stabilizer<V> for Called<S> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        self.0.stabilize(sample, effort)
    }
}

impl<V: Space, S: Stabilizer<V> + 'static> Replay<V> for Called<S> {
    fn state_bytes(&self) -> usize {
        size_of::<S>()
    }

    fn on(self: Box<Self>, port: Port<V>, scenes: Scenes<'_>) -> Result<Port<V>, ParameterError> {
        measured(scenes, port.stabilized(AnyStabilizer(self)))
    }

    fn replay(&mut self, samples: &[(PortSample<V>, V)], corrections: &mut [Correction<V>]) {
        take(self, samples, corrections);
    }
}

/// Stabilizer with a loop compiled for its type.
impl<V: Space, S: Stabilizer<V> + 'static> Replay<V> for On<S> {
    fn state_bytes(&self) -> usize {
        size_of::<S>()
    }

    fn on(self: Box<Self>, port: Port<V>, scenes: Scenes<'_>) -> Result<Port<V>, ParameterError> {
        measured(scenes, port.stabilized(self.into_part()))
    }

    fn replay(&mut self, samples: &[(PortSample<V>, V)], corrections: &mut [Correction<V>]) {
        take(self, samples, corrections);
    }
}

#[inline(never)]
fn take<V: Signal>(
    stabilizer: &mut impl Stabilizer<V>,
    samples: &[(PortSample<V>, V)],
    corrections: &mut [Correction<V>],
) {
    for ((sample, effort), correction) in samples.iter().zip(corrections) {
        *correction = stabilizer.stabilize(sample, *effort);
    }
}
