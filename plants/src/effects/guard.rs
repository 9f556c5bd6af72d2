//! Rejection of bad samples in front of a port.

use lyapunov_core::{
    Correction, EffortRange, OnePort, ParameterError, PortSample, Requirement, Scalar, Signal,
    Snapshot, careful,
};

use crate::Fallback;

/// A port that receives only finite samples over a time above 0 and answers only with finite efforts.
///
/// A sample with a NaN or an infinity in any field, or a period that is not above 0, is rejected before anything inside
/// changes; the answer is the [`Fallback`], and the correction has `accepted: false`, that effort and no damping. The next
/// sound sample that reaches the port spans the gap: the periods add up, and the displacement is the difference of the two
/// sound positions.
///
/// **A ledger of held work never overstates what was absorbed meanwhile.** The work of known ticks is kept. Over the
/// unknown part `S` of the displacement, the work is taken to be the least of `f S` over the efforts `f` that applied
/// there, axis by axis: exact if one effort applied throughout (as under [`Fallback::Hold`]), a lower bound if the
/// motion did not reverse within the gap. The velocity passed on is, axis by axis, the smaller in magnitude of the
/// measured one and the mean over the gap, and 0 where their directions disagree, so that no damper is credited with
/// more than the mean motion dissipated and no correction pushes along the motion. An estimator of velocities inside would put its
/// own in that place: it stands outside, `port.guarded(fallback).low_passed(cutoff)?`. Before the first sound sample there
/// is no position to count from: the unknown part until then is not booked, and the mean is that of the known part.
///
/// A gap is a length of time, and different gaps would put lanes out of step, so a guard stands on ports of one value
/// at a time (`f32`, `f64` and vectors of them).
///
/// ```
/// use lyapunov_core::{OnePort, PortSample};
/// use lyapunov_plants::{Fallback, OnePortExt, Spring};
/// let mut spring = Spring::new(500.0)?.guarded(Fallback::Hold);
/// let at = |position: f64| PortSample::starting(1e-3, position, 0.0);
/// assert_eq!(spring.respond(&at(0.01)), 5.0);
/// assert_eq!(spring.respond(&at(f64::NAN)), 5.0); // rejected: the last effort is held
/// assert!(!OnePort::<f64>::correction(&spring).accepted);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
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

lends_port!([P, V: Signal] Guard<P, V>);

/// The known work and motion since the last sound sample.
#[derive(Clone, Copy, Debug)]
struct Gap<V: Signal> {
    period: V::Scalar,
    /// Work and displacement of the ticks for which both were sound.
    work: V,
    moved: V,
    /// The range of the efforts that applied over the rest of the displacement, if any.
    unknown: Option<EffortRange<V>>,
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
}

impl<P, V: Signal> Guard<P, V>
where
    V::Scalar: Scalar<Mask = bool>,
{
    /// Books what a rejected sample still reports.
    fn note(&mut self, sample: &PortSample<V>) {
        let mut gap = self.gap.unwrap_or(Gap {
            period: V::Scalar::of(0.0),
            work: V::zero(),
            moved: V::zero(),
            unknown: None,
        });
        gap.period += if sample.timed() { sample.period } else { self.period };
        if sample.work.finite() && sample.displacement.finite() {
            gap.work = gap.work + sample.work;
            gap.moved = gap.moved + sample.displacement;
        } else {
            let applied = if sample.applied.finite() { sample.applied } else { self.told };
            let alone = EffortRange::of(applied);
            gap.unknown = Some(gap.unknown.map_or(alone, |range| range.with(applied)));
        }
        self.gap = Some(gap);
    }

    /// The port's answer to a sound sample, if that answer is sound.
    ///
    /// Where a gap is out of the scalar's range, as from 3e38 m to −3e38 m in `f32`, the sample is rejected, the gap is
    /// not booked, and the next one counts from here.
    fn ask(&mut self, sample: &PortSample<V>) -> Option<V>
    where
        P: OnePort<V>,
    {
        let gap = self.gap.take();
        let whole = gap.map(|gap| self.span(sample, &gap));
        self.period = sample.period;
        self.position = Some(sample.position);
        if whole.is_some_and(|whole| !whole.finite()) {
            return None;
        }
        Some(self.port.respond(&whole.unwrap_or(*sample))).filter(|effort| effort.finite())
    }

    /// The sound sample `now`, extended over the gap since the last one.
    fn span(&self, now: &PortSample<V>, gap: &Gap<V>) -> PortSample<V> {
        let period = gap.period + now.period;
        let known = gap.work + now.work;
        let (displacement, unseen) = match self.position {
            Some(position) => {
                let whole = now.position - position;
                (whole, whole - gap.moved - now.displacement)
            }
            None => (gap.moved + now.displacement, V::zero()),
        };
        let unseen_work = gap.unknown.map_or(V::zero(), |range| range.least_work(unseen));
        let velocity =
            now.velocity.zip(displacement, |measured, moved| careful(measured, moved / period));
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
        let effort = if sample.sound() {
            self.ask(sample)
        } else {
            self.note(sample);
            None
        };
        self.rejected = effort.is_none();
        self.effort = effort.unwrap_or(self.effort);
        self.told = effort.unwrap_or(self.fallback.after(self.effort));
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

/// What is remembered of a gap: period, work, displacement, and the range of the efforts over the rest.
type GapState<V> = (<V as Signal>::Scalar, V, V, Option<(V, V)>);

impl<P: Snapshot, V: Signal> Snapshot for Guard<P, V> {
    /// The memory of the port inside; the last sound effort and the last one told; period and position of the last
    /// sound sample; the gap since then; and whether the last tick was rejected.
    type State = (P::State, (V, V), (V::Scalar, Option<V>), Option<GapState<V>>, bool);

    fn state(&self) -> Self::State {
        let Self { effort, told, period, position, gap, rejected, .. } = *self;
        let gap = gap.map(|Gap { period, work, moved, unknown }| {
            (period, work, moved, unknown.map(|range| (range.least, range.most)))
        });
        (self.port.state(), (effort, told), (period, position), gap, rejected)
    }

    fn restored(
        self,
        (port, (effort, told), (period, position), gap, rejected): Self::State,
    ) -> Result<Self, ParameterError> {
        Requirement::Finite.check_axes("stored effort", effort)?;
        Requirement::Finite.check_axes("stored effort", told)?;
        Requirement::Finite.check("stored period", period)?;
        Requirement::Finite.check_axes("stored position", position.unwrap_or(told))?;
        let gap = gap.map(|(period, work, moved, unknown)| {
            let unknown = unknown.map(|(least, most)| EffortRange { least, most });
            Gap { period, work, moved, unknown }
        });
        let port = self.port.restored(port)?;
        Ok(Self { port, effort, told, period, position, gap, rejected, ..self })
    }
}
