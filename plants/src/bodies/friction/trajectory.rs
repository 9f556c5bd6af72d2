//! Motion through one period, from event to event.

use lyapunov_core::lanes::apart;
use lyapunov_core::{Mask, Scalar};

use super::Transition::{Cut, Reverse, Slip, Stick};
use super::root::{Polynomial, first_fall};
use super::series::{Series, System};
use super::transition::Transitions;

/// Most pieces of a period.
pub(super) const PIECES: usize = 1024;

/// The share of a step in which nothing happens.
const NEVER: f64 = 2.0;

/// The motion through one period, in lanes that share no event: each goes from event to event by itself, and what they
/// compute between events they compute together. The lanes are of `f64`.
pub(super) struct Trajectory<'a, T: Scalar, const S: usize> {
    system: &'a System<T, S>,
    state: [T; S],
    /// The direction in which the device slides, ±1; 0 while it sticks.
    sense: T,
    elapsed: T,
    remaining: T,
    /// The total gain, without the rounding of adding it to a deflection.
    pub(super) gain: [T; S],
    /// The energy that friction dissipated, J.
    pub(super) heat: T,
    pub(super) log: Transitions<T>,
}

/// ±1 by the sign of a number that is not 0.
#[inline(always)]
fn sign<T: Scalar>(of: T) -> T {
    T::choose(of.below(T::zero()), -T::one(), T::one())
}

#[inline(always)]
fn is_zero<T: Scalar>(number: T) -> T::Mask {
    !(number.above(T::zero()) | number.below(T::zero()))
}

impl<'a, T: Scalar, const S: usize> Trajectory<'a, T, S> {
    /// The motion of the lanes `of` from `state` through `interval` s; the others stay where they are.
    #[inline(always)]
    pub(super) fn run(system: &'a System<T, S>, state: [T; S], interval: T, of: T::Mask) -> Self {
        let zero = T::zero();
        let (gain, log, velocity) = ([zero; S], Transitions::none(), state[S - 1]);
        let remaining = T::choose(of, interval, zero);
        let sense = sign(velocity);
        let mut trajectory =
            Self { system, state, sense, elapsed: zero, remaining, gain, heat: zero, log };
        let still = is_zero(velocity);
        if still.any() {
            trajectory.sense = T::choose(still, trajectory.at_rest(), sense);
            let moves = still & !is_zero(trajectory.sense) & remaining.above(zero);
            trajectory.log.note(moves, zero, Slip);
        }
        let mut cut = T::Mask::of(false);
        let mut series = Series::none();
        for _ in 0..PIECES {
            let running = trajectory.remaining.above(zero) & !cut;
            if !running.any() {
                break;
            }
            cut = cut | trajectory.piece(&mut series, running);
        }
        let cut = trajectory.remaining.above(zero);
        if cut.any() {
            trajectory.log.clear(cut);
            trajectory.log.note(cut, zero, Cut);
        }
        trajectory
    }

    /// The lanes that reached the end of the period.
    #[inline(always)]
    pub(super) fn complete(&self) -> T::Mask {
        !self.remaining.above(T::zero())
    }

    /// Entry `index` of the state, a velocity. It is not a sum of gains: a device at rest has exactly 0.
    #[inline(always)]
    pub(super) fn velocity(&self, index: usize) -> T {
        self.state[index]
    }

    /// The direction in which a device that has come to rest starts to slide, or 0 if it sticks.
    #[inline(always)]
    fn at_rest(&self) -> T {
        let force = self.system.force(&self.state);
        let slips = force.magnitude().above(self.system.law.breakaway) | !force.finite();
        T::choose(slips, sign(force), T::zero())
    }

    /// Moves the lanes `running` on to their next event or the end of their step; returns those in which there is no step.
    #[inline(always)]
    fn piece(&mut self, series: &mut Series<T, S>, running: T::Mask) -> T::Mask {
        let (state, sense, remaining) = (&self.state, self.sense, self.remaining);
        let found = self.system.expand(series, state, sense, remaining, running);
        let sticking = found & is_zero(self.sense);
        let sliding = found & !is_zero(self.sense);
        let never = T::of(NEVER);
        let (mut first, mut start, mut floor) = (never, self.sense, T::zero());
        if sticking.any() {
            (first, start) = self.first_slip(series, sticking);
        }
        if sliding.any() {
            let fall;
            (fall, floor) = self.first_stop(series, sliding);
            first = T::choose(sliding, fall, first);
        }
        let happens = first.below(never);
        let share = T::choose(happens, first, T::one());
        let before = self.state[S - 1];
        if sliding.any() {
            self.heat = T::choose(sliding, self.heat + series.heat(share), self.heat);
        }
        self.pass(series, share, found);
        let slips = sticking & happens;
        if slips.any() {
            self.log.note(slips, self.elapsed, Slip);
            self.sense = T::choose(slips, start, self.sense);
        }
        let stopped = happens & is_zero(floor);
        let moves_on = (self.sense * self.state[S - 1]).above(T::zero()) & !stopped;
        let stops = sliding & !moves_on;
        if stops.any() {
            self.stop(stops, is_zero(before) & is_zero(first));
        }
        running & !found
    }

    /// The share of the step at which a device at rest slips, if it does, and the direction.
    #[inline(always)]
    fn first_slip(&self, series: &Series<T, S>, sticking: T::Mask) -> (T, T) {
        let force = self.system.force_series(series);
        let one = T::one();
        let senses = [one, -one];
        let mut first = [T::of(NEVER); 2];
        for way in 0..2 {
            // A force within a rounding above static friction counts as equal to it: this device was just found to
            // stick.
            let start = -senses[way] * force[0] + self.system.law.breakaway;
            first[way] = falls(&force, -senses[way], start.larger(T::zero()), sticking);
        }
        let [forwards, back] = first;
        let is_back = back.below(forwards);
        (T::choose(is_back, back, forwards), T::choose(is_back, -one, one))
    }

    /// The share of the step at which a sliding device is down to a speed, if it is, and that speed.
    #[inline(always)]
    fn first_stop(&self, series: &Series<T, S>, sliding: T::Mask) -> (T, T) {
        let (_, floor) = self.system.law.constant_above(self.state[S - 1].magnitude());
        let velocity = &series.state[S - 1];
        let start = self.sense * velocity[0] - floor;
        (falls(velocity, self.sense, start, sliding), floor)
    }

    /// Ends the sliding of some lanes at rest; in those where the device `never_left` rest it sticks.
    #[inline(always)]
    fn stop(&mut self, stops: T::Mask, never_left: T::Mask) {
        let zero = T::zero();
        self.state[S - 1] = T::choose(stops, zero, self.state[S - 1]);
        // Where it never left rest, the force equals static friction within rounding, and falls.
        let next = T::choose(never_left, zero, self.at_rest());
        let sticks = is_zero(next);
        self.log.note(stops & sticks, self.elapsed, Stick);
        // At the end of the period the next effort decides.
        let turns = (next * self.sense).below(zero) & self.remaining.above(zero);
        self.log.note(stops & turns, self.elapsed, Reverse);
        self.sense = T::choose(stops, next, self.sense);
    }

    /// Moves the lanes `of` on by `share` of the step.
    #[inline(always)]
    fn pass(&mut self, series: &Series<T, S>, share: T, of: T::Mask) {
        let only = |new: T, kept: T| T::choose(of, new, kept);
        for index in 0..S {
            let gain = series.gain(index, share);
            self.state[index] = only(self.state[index] + gain, self.state[index]);
            self.gain[index] = only(self.gain[index] + gain, self.gain[index]);
        }
        let passed = share * series.step;
        self.elapsed = only(self.elapsed + passed, self.elapsed);
        self.remaining = only(self.remaining - passed, self.remaining);
    }
}

/// [`first_fall`] of `sign` times `polynomial`, from `start` on instead of its first coefficient, in the lanes `of`; [`NEVER`]
/// where there is none.
#[inline(always)]
fn falls<T: Scalar>(polynomial: &Polynomial<T>, sign: T, start: T, of: T::Mask) -> T {
    let never = T::of(NEVER);
    // Most lanes stay above 0 so surely that this sum is too.
    let mut sum = T::zero();
    for coefficient in &polynomial[1..] {
        apart::<T>();
        sum += (sign * *coefficient).smaller(T::zero());
    }
    let stays = start.above(T::zero()) & (sum + start).above(T::zero());
    if (stays | !of).all() {
        return never;
    }
    T::from_lanes(|lane| {
        if !of.lane(lane) || stays.lane(lane) {
            return NEVER;
        }
        let mut alone: Polynomial<f64> =
            core::array::from_fn(|at| sign.lane(lane) * polynomial[at].lane(lane));
        alone[0] = start.lane(lane);
        first_fall(&alone).unwrap_or(NEVER)
    })
}
