//! Stabilizer chosen at run time.

use std::fmt;

use lyapunov::{
    Correction, Dissipation, Held, Lolc, LyapunovCandidate, OnePort, ParameterError, PortEnergy,
    PortSample, Signal, Stabilizer,
    accumulators::{Accumulator, Compensated},
    environments::ForceLaw,
};

use super::Port;
use super::assembly::measured;
use crate::files::scene::{self, Candidate, Cap, Ledger, Popc, Render, Scene, Work, of};
use crate::simulate::building::Space;

/// Any stabilizer of efforts, boxed: one that a scene file names, or your own.
pub struct AnyStabilizer<V: Signal>(Box<dyn Replay<V>>);

impl<V: Signal> AnyStabilizer<V> {
    /// Bytes that the stabilizer keeps from tick to tick, parameters included.
    pub fn state_bytes(&self) -> usize {
        size_of_val(self.0.as_ref())
    }

    /// `port` watched and corrected by this stabilizer, its motion measured as `scene` says: one part, compiled for its
    /// type, instead of a box in a box.
    pub(super) fn on(self, port: Port<V>, scene: &Scene) -> Result<Port<V>, ParameterError> {
        self.0.on(port, scene)
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
        Self(Box::new(Fused(stabilizer)))
    }

    /// Boxes `stabilizer` for a loop that calls it through a table: no loop is compiled for its type.
    pub(crate) fn called(stabilizer: impl Stabilizer<V> + 'static) -> Self {
        Self(Box::new(Called(stabilizer)))
    }

    /// POPC on the loop of `scene`.
    ///
    /// # Errors
    /// A parameter that is right by itself but out of the range of the scalar, alone or with others.
    pub(super) fn popc(scene: &Scene, popc: Popc) -> Result<Self, ParameterError> {
        let Popc { work, ledger, damping_cap } = popc;
        Self::watching(scene, PortEnergy, Booking { work, ledger, cap: cap(scene, damping_cap) })
    }

    /// LOLC on the loop of `scene`.
    ///
    /// # Errors
    /// As [`AnyStabilizer::popc`].
    pub(super) fn lolc(scene: &Scene, lolc: scene::Lolc) -> Result<Self, ParameterError> {
        let scene::Lolc { work, ledger, damping_cap, .. } = lolc;
        let booking = Booking { work, ledger, cap: cap(scene, damping_cap) };
        match lolc.candidate {
            Candidate::Spring => Self::watching(scene, PortEnergy, booking),
            Candidate::DeviceDamping => {
                let damper = Dissipation::of(of(scene.device.damping))?;
                Self::watching(scene, (PortEnergy, damper), booking)
            }
            Candidate::MassSpringDamper => V::render(scene, Crediting { scene, booking }),
        }
    }

    fn watching(
        scene: &Scene,
        candidate: impl LyapunovCandidate<V> + 'static,
        Booking { work, ledger, cap }: Booking,
    ) -> Result<Self, ParameterError> {
        let limit = scene.damping(cap).limit()?;
        // Only the default ledger of held work is compiled for each candidate; the others pay for a box with a call.
        let boxed = |candidate| Lolc::new(AnyCandidate::<V>(Box::new(candidate)), limit);
        Ok(match (work, ledger) {
            (Work::Held, Ledger::Plain) => Self::new(Lolc::new(candidate, limit)),
            (Work::Sampled, Ledger::Plain) => Self::new(boxed(candidate).sampled()),
            (_, Ledger::Compensated) => {
                Self::booked(boxed(candidate).summed_in::<Compensated<V::Scalar>>(), work)
            }
            (_, Ledger::Wide) => Self::booked(boxed(candidate).summed_in::<V::Wide>(), work),
        })
    }

    fn booked<A: Accumulator<V::Scalar> + 'static>(
        lolc: Lolc<V::Scalar, AnyCandidate<V>, Held, A>,
        work: Work,
    ) -> Self {
        match work {
            Work::Held => Self::new(lolc),
            Work::Sampled => Self::new(lolc.sampled()),
        }
    }
}

/// Work, ledger and damping cap of a scene's stabilizer.
#[derive(Clone, Copy)]
struct Booking {
    work: Work,
    ledger: Ledger,
    cap: f64,
}

/// The cap that is written, else the default of `scene`.
fn cap(scene: &Scene, written: Option<Cap>) -> f64 {
    written.map_or_else(|| scene.default_cap(), Cap::get)
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
struct Crediting<'a> {
    scene: &'a Scene,
    booking: Booking,
}

impl<V: Space> Render<V> for Crediting<'_> {
    type Made = AnyStabilizer<V>;

    fn render(
        self,
        _environment: impl ForceLaw<V> + 'static,
        credit: impl LyapunovCandidate<V> + 'static,
    ) -> Result<Self::Made, ParameterError> {
        AnyStabilizer::watching(self.scene, (PortEnergy, credit), self.booking)
    }
}

/// Stabilizer that can wrap a port or run over samples.
trait Replay<V: Signal>: Stabilizer<V> {
    fn on(self: Box<Self>, port: Port<V>, scene: &Scene) -> Result<Port<V>, ParameterError>;

    fn replay(&mut self, samples: &[(PortSample<V>, V)], corrections: &mut [Correction<V>]);
}

/// Stabilizer that a loop calls through a table.
struct Called<S>(S);

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for Called<S> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        self.0.stabilize(sample, effort)
    }
}

impl<V: Space, S: Stabilizer<V> + 'static> Replay<V> for Called<S> {
    fn on(self: Box<Self>, port: Port<V>, scene: &Scene) -> Result<Port<V>, ParameterError> {
        measured(scene, port.stabilized(AnyStabilizer(self)))
    }

    fn replay(&mut self, samples: &[(PortSample<V>, V)], corrections: &mut [Correction<V>]) {
        take(&mut self.0, samples, corrections);
    }
}

/// Stabilizer with a loop compiled for its type.
struct Fused<S>(S);

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for Fused<S> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        self.0.stabilize(sample, effort)
    }
}

impl<V: Space, S: Stabilizer<V> + 'static> Replay<V> for Fused<S> {
    fn on(self: Box<Self>, port: Port<V>, scene: &Scene) -> Result<Port<V>, ParameterError> {
        measured(scene, port.stabilized(self.0))
    }

    fn replay(&mut self, samples: &[(PortSample<V>, V)], corrections: &mut [Correction<V>]) {
        take(&mut self.0, samples, corrections);
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
