//! A port that bad samples do not reach.

use lyapunov_core::{Action, Drive, OnePort, Scalar, Signal};

use crate::Fallback;

/// A port that is called with finite drives only, and answers with finite efforts only.
///
/// A drive with a NaN or an infinity in any field is turned away before anything inside is touched; the
/// answer is the [`Fallback`], and the action says `accepted: false`, that effort and no damping. The next sound drive that is handed on
/// spans the gap: the periods add up, the displacement is the difference of the two sound positions.
///
/// **A ledger of held work never overstates what was absorbed meanwhile.** The work of ticks that were known is kept.
/// Over the unknown part of the displacement `S` the work is taken to be the least of `f S` over the efforts
/// `f` that acted there, axis by axis: exact if one effort acted throughout (as under [`Fallback::Hold`]), a
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

/// What is known of the time since the last sound drive.
#[derive(Clone, Copy, Debug)]
struct Gap<V: Signal> {
    period: V::Scalar,
    /// Work and displacement of the ticks for which both were sound.
    work: V,
    moved: V,
    /// The range of the efforts that acted over the rest, if there was any.
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
    /// Notes what a drive that is not sound still tells.
    fn note(&mut self, drive: &Drive<V>) {
        let mut gap = self.gap.unwrap_or(Gap {
            period: V::Scalar::of(0.0),
            work: V::zero(),
            moved: V::zero(),
            unknown: None,
        });
        gap.period += if drive.period.finite() { drive.period } else { self.period };
        if drive.work.finite() && drive.displacement.finite() {
            gap.work = gap.work + drive.work;
            gap.moved = gap.moved + drive.displacement;
        } else {
            let acted = if drive.acted.finite() { drive.acted } else { self.told };
            let (least, most) = gap.unknown.unwrap_or((acted, acted));
            gap.unknown =
                Some((least.zip(acted, Scalar::smaller), most.zip(acted, Scalar::larger)));
        }
        self.gap = Some(gap);
    }

    /// What the port inside answers to a sound drive, if that is sound.
    fn ask(&mut self, drive: &Drive<V>) -> Option<V>
    where
        P: OnePort<V>,
    {
        let whole = match self.gap.take() {
            Some(gap) => self.span(drive, &gap),
            None => *drive,
        };
        self.period = drive.period;
        self.position = Some(drive.position);
        Some(self.port.respond(&whole)).filter(|effort| effort.finite())
    }

    /// The sound drive `now` with what happened since the last one.
    fn span(&self, now: &Drive<V>, gap: &Gap<V>) -> Drive<V> {
        let period = gap.period + now.period;
        let known = gap.work + now.work;
        let Some(position) = self.position else {
            let displacement = gap.moved + now.displacement;
            return Drive { period, displacement, work: known, ..*now };
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
        Drive { period, velocity, displacement, work: known + unseen_work, ..*now }
    }
}

impl<V, P> OnePort<V> for Guard<P, V>
where
    V: Signal,
    V::Scalar: Scalar<Mask = bool>,
    P: OnePort<V>,
{
    #[inline]
    fn respond(&mut self, drive: &Drive<V>) -> V {
        let effort = if drive.finite() {
            self.ask(drive)
        } else {
            self.note(drive);
            None
        };
        self.rejected = effort.is_none();
        self.effort = effort.unwrap_or(self.effort);
        self.told = effort.unwrap_or(self.answer());
        self.told
    }

    #[inline]
    fn action(&self) -> Action<V> {
        let action = self.port.action();
        if !self.rejected {
            return action;
        }
        let zero = V::Scalar::of(0.0);
        let shortfall = (zero - action.sum).larger(zero);
        Action { effort: self.told, alpha: zero, shortfall, accepted: false, ..action }
    }
}
