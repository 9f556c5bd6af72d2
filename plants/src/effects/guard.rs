//! A port that bad samples do not reach.

use lyapunov_core::{Correction, OnePort, PortSample, Scalar, Signal};

use crate::Fallback;

/// A port that is called with finite drives only, and answers with finite efforts only.
///
/// A sample with a NaN or an infinity in any field is turned away before anything inside is touched; the
/// answer is the [`Fallback`], and the correction says `accepted: false`, that effort and no damping. The next sound sample that is handed on
/// spans the gap: the periods add up, the displacement is the difference of the two sound positions.
///
/// **A ledger of held work never overstates what was absorbed meanwhile.** The work of ticks that were known is kept.
/// Over the unknown part of the displacement `S` the work is taken to be the least of `f S` over the efforts
/// `f` that applied there, axis by axis: exact if one effort applied throughout (as under [`Fallback::Hold`]), a
/// lower bound if the motion did not turn round inside the gap. The velocity handed on is, axis by axis, the
/// smaller in magnitude of the measured and the mean over the gap, and 0 where they disagree about the direction,
/// so that no damper is credited for more than the mean motion burnt and no correction pushes along. Before the
/// first sound sample there is no position to count from: what is unknown until then is not booked.
///
/// A gap is one of time, and lanes would have to be out of step with each other over it, so a guard stands on
/// ports of one value at a time (`f32`, `f64` and vectors of them).
#[derive(Clone, Copy, Debug)]
pub struct Guard<P, V: Signal> {
    port: P,
    fallback: Fallback,
    effort: V,
    told: V,
    period: V::Scalar,
    position: Option<V>,
    gap: Option<Gap<V>>,
    rejected: bool,
}

/// What is known of the time since the last sound sample.
#[derive(Clone, Copy, Debug)]
struct Gap<V: Signal> {
    period: V::Scalar,
    /// Work and displacement of the ticks for which both were sound.
    work: V,
    moved: V,
    /// The range of the efforts that applied over the rest, if there was any.
    unknown: Option<(V, V)>,
}

impl<P, V: Signal> Guard<P, V> {
    pub(crate) fn new(port: P, fallback: Fallback) -> Self {
        Self {
            port,
            fallback,
            effort: V::zero(),
            told: V::zero(),
            period: V::Scalar::of(0.0),
            position: None,
            gap: None,
            rejected: false,
        }
    }

    fn answer(&self) -> V {
        match self.fallback {
            Fallback::Hold => self.effort,
            Fallback::Zero => V::zero(),
        }
    }
}

impl<P, V: Signal> Guard<P, V>
where
    V::Scalar: Scalar<Mask = bool>,
{
    /// Notes what a sample that is not sound still tells.
    fn note(&mut self, sample: &PortSample<V>) {
        let mut gap = self.gap.unwrap_or(Gap {
            period: V::Scalar::of(0.0),
            work: V::zero(),
            moved: V::zero(),
            unknown: None,
        });
        gap.period += if sample.period.finite() { sample.period } else { self.period };
        if sample.work.finite() && sample.displacement.finite() {
            gap.work = gap.work + sample.work;
            gap.moved = gap.moved + sample.displacement;
        } else {
            let applied = if sample.applied.finite() { sample.applied } else { self.told };
            let (least, most) = gap.unknown.unwrap_or((applied, applied));
            gap.unknown =
                Some((least.zip(applied, Scalar::smaller), most.zip(applied, Scalar::larger)));
        }
        self.gap = Some(gap);
    }

    /// What the port inside answers to a sound sample, if that is sound.
    fn ask(&mut self, sample: &PortSample<V>) -> Option<V>
    where
        P: OnePort<V>,
    {
        let whole = match self.gap.take() {
            Some(gap) => self.span(sample, &gap),
            None => *sample,
        };
        self.period = sample.period;
        self.position = Some(sample.position);
        Some(self.port.respond(&whole)).filter(|effort| effort.finite())
    }

    /// The sound sample `now` with what happened since the last one.
    fn span(&self, now: &PortSample<V>, gap: &Gap<V>) -> PortSample<V> {
        let period = gap.period + now.period;
        let known = gap.work + now.work;
        let Some(position) = self.position else {
            let displacement = gap.moved + now.displacement;
            return PortSample { period, displacement, work: known, ..*now };
        };
        let displacement = now.position - position;
        let unseen = displacement - gap.moved - now.displacement;
        let (least, most) = gap.unknown.unwrap_or((V::zero(), V::zero()));
        let unseen_work = least.times(unseen).zip(most.times(unseen), Scalar::smaller);
        let velocity = now.velocity.zip(displacement, |measured, moved| {
            let mean = moved / period;
            let slower = mean.magnitude().below(measured.magnitude());
            let turned = (mean * measured).below(V::Scalar::of(0.0));
            let careful = V::Scalar::choose(slower, mean, measured);
            V::Scalar::choose(turned, V::Scalar::of(0.0), careful)
        });
        PortSample { period, velocity, displacement, work: known + unseen_work, ..*now }
    }
}

impl<V, P> OnePort<V> for Guard<P, V>
where
    V: Signal,
    V::Scalar: Scalar<Mask = bool>,
    P: OnePort<V>,
{
    #[inline]
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let effort = if sample.finite() {
            self.ask(sample)
        } else {
            self.note(sample);
            None
        };
        self.rejected = effort.is_none();
        self.effort = effort.unwrap_or(self.effort);
        self.told = effort.unwrap_or(self.answer());
        self.told
    }

    #[inline]
    fn correction(&self) -> Correction<V> {
        let correction = self.port.correction();
        if !self.rejected {
            return correction;
        }
        let zero = V::Scalar::of(0.0);
        let shortfall = (zero - correction.observed_energy).larger(zero);
        Correction { effort: self.told, alpha: zero, shortfall, accepted: false, ..correction }
    }
}
