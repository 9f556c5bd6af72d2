//! What is remembered from reading to reading.

use super::{CheckedSample, Reading, Track, one_and_a_half};
use crate::velocity::careful;
use crate::{EffortRange, Mask, ParameterError, PortSample, Requirement, Scalar, Signal, Snapshot};

/// The last accepted position, and the time and the efforts since then.
#[derive(Clone, Copy, Debug)]
pub(super) struct Memory<V: Signal> {
    /// A 1 where a position is known, a 2 if the next reading is then the first at another period, and elsewhere a 0: numbers
    /// alone have no padding, and every pattern of bits is one.
    known: V::Scalar,
    position: V,
    /// Time since the last accepted reading, s; 0 unless some were rejected.
    gap: V::Scalar,
    /// The range of the efforts since then.
    efforts: EffortRange<V>,
}

/// Reading that was looked at and is not yet remembered.
#[derive(Clone, Copy, Debug)]
pub(super) struct Heard<V: Signal> {
    elapsed: V::Scalar,
    span: V::Scalar,
    position: V,
    displacement: V,
    applied: V,
    efforts: EffortRange<V>,
    work: V,
    jumped: <V::Scalar as Scalar>::Mask,
    late: <V::Scalar as Scalar>::Mask,
    pub(super) accepted: <V::Scalar as Scalar>::Mask,
    /// Where it is the first one accepted.
    pub(super) first: <V::Scalar as Scalar>::Mask,
}

impl<V: Signal> Heard<V> {
    /// The motion as an estimator of velocities is told it: not finite where the reading was not accepted.
    #[inline(always)]
    pub(super) fn motion(&self) -> PortSample<V> {
        let unknown = V::splat(V::Scalar::of(f64::NAN));
        PortSample {
            period: self.span,
            position: V::choose(self.accepted, self.position, unknown),
            velocity: V::zero(),
            displacement: V::choose(self.accepted, self.displacement, unknown),
            applied: self.applied,
            work: self.work,
        }
    }

    /// `velocity` where it is finite; over a gap no larger than the mean, and in its direction.
    #[inline(always)]
    fn careful(&self, velocity: V) -> V {
        let zero = V::Scalar::of(0.0);
        // Of the very numbers that a backward difference divides, so that it is not divided twice.
        velocity.zip(self.motion().displacement, |told, moved| {
            let velocity = V::Scalar::choose(self.late, careful(told, moved / self.span), told);
            V::Scalar::choose(velocity.finite(), velocity, zero)
        })
    }
}

impl<V: Signal> Memory<V> {
    pub(super) fn empty() -> Self {
        let (none, zero) = (V::Scalar::of(0.0), V::zero());
        Self { known: none, position: zero, gap: none, efforts: EffortRange::of(zero) }
    }

    pub(super) fn position(&self) -> V {
        self.position
    }

    /// Where a position is known.
    #[inline(always)]
    fn known(&self) -> <V::Scalar as Scalar>::Mask {
        self.known.above(V::Scalar::of(0.5))
    }

    /// Notes that from the next reading on the period is another one in these `lanes`.
    pub(super) fn space_anew(&mut self, lanes: <V::Scalar as Scalar>::Mask) {
        self.known = V::Scalar::choose(lanes & self.known(), V::Scalar::of(2.0), self.known);
    }

    /// The lanes in which the next reading is the first at another period.
    #[inline(always)]
    pub(super) fn spaced_anew(&self) -> <V::Scalar as Scalar>::Mask {
        self.known.above(V::Scalar::of(1.5))
    }

    pub(super) fn restart(&mut self) {
        self.known = V::Scalar::of(0.0);
        self.gap = V::Scalar::of(0.0);
    }

    /// `Ok(())` if a track of this kind can go on from where it is.
    pub(super) fn goes_on<P: Track<V>>(&self) -> Result<(), ParameterError> {
        if self.known().all() { P::counted_from(self.position) } else { Ok(()) }
    }

    /// The position of `place` on a `track`, and the track with it.
    #[inline(always)]
    pub(super) fn lead<P: Track<V>>(&self, track: P, place: P::Place) -> (V, P) {
        track.lead(place, self.position, self.known())
    }

    /// Looks at a reading `elapsed` seconds after the last, of a device that moves no faster than `fastest`.
    #[inline(always)]
    pub(super) fn hear<P: Track<V>>(
        &self,
        elapsed: V::Scalar,
        period: V::Scalar,
        fastest: P::Speed,
        reading: Reading<V>,
    ) -> Heard<V> {
        let told = reading.applied.finite();
        let applied = V::choose(told, reading.applied, self.efforts.least);
        let gap = self.gap.above(V::Scalar::of(0.0));
        let efforts =
            EffortRange::choose(gap, self.efforts.with(applied), EffortRange::of(applied));

        // Times near the end of the range may not add up.
        let span = (self.gap + elapsed).smaller(V::Scalar::largest());
        let late = span.above(one_and_a_half(period));
        let moved = reading.position - self.position;
        let known = self.known();
        let displacement = V::choose(known, moved, V::zero());
        // Over less than a period a count of the encoder would be a speed.
        let far = P::too_far(fastest, displacement, span.larger(period));
        let here = reading.position.finite();
        let jumped = here & (far | !displacement.finite());
        let work = efforts.least_work(displacement);
        let accepted = here & told & !jumped & work.finite();
        let first = accepted & !known;
        Heard {
            elapsed,
            span,
            position: reading.position,
            displacement,
            applied,
            efforts,
            work,
            jumped,
            late,
            accepted,
            first,
        }
    }

    /// Remembers what was `heard`, with the device's `velocity`.
    #[inline(always)]
    pub(super) fn close(&mut self, heard: Heard<V>, velocity: V, timed: bool) -> CheckedSample<V> {
        let Heard { accepted, applied, .. } = heard;
        let zero = V::Scalar::of(0.0);
        let known = self.known() | accepted;
        self.known = V::Scalar::choose(known, V::Scalar::of(1.0), zero);
        self.position = V::choose(accepted, heard.position, self.position);
        self.gap = V::Scalar::choose(accepted | !known, zero, heard.span);
        self.efforts = EffortRange::choose(accepted, EffortRange::of(applied), heard.efforts);
        let sample = PortSample {
            period: V::Scalar::choose(accepted, heard.span, heard.elapsed),
            position: self.position,
            velocity: V::choose(accepted, heard.careful(velocity), V::zero()),
            displacement: V::choose(accepted, heard.displacement, V::zero()),
            applied,
            work: V::choose(accepted, heard.work, V::splat(V::Scalar::of(f64::NAN))),
        };
        CheckedSample { sample, accepted, jumped: heard.jumped, late: heard.late, timed }
    }
}

impl<V: Signal> Snapshot for Memory<V> {
    type State = (V::Scalar, V, V::Scalar, V, V);

    fn state(&self) -> Self::State {
        (self.known, self.position, self.gap, self.efforts.least, self.efforts.most)
    }

    fn restored(
        self,
        (known, position, gap, least, most): Self::State,
    ) -> Result<Self, ParameterError> {
        Requirement::Finite.check_axes("stored position", position)?;
        Requirement::NonNegative.check("stored gap", gap)?;
        Requirement::Finite.check_axes("stored effort", least)?;
        Requirement::Finite.check_axes("stored effort", most)?;
        let [zero, one, two] = [0.0, 1.0, 2.0].map(V::Scalar::of);
        let anew = known.above(V::Scalar::of(1.5));
        let known = V::Scalar::choose(known.above(V::Scalar::of(0.5)), one, zero);
        let known = V::Scalar::choose(anew, two, known);
        Ok(Self { known, position, gap, efforts: EffortRange { least, most } })
    }
}
