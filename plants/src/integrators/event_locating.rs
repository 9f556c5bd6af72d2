//! Steps that end where the equation of motion switches.

use lyapunov_core::{Integrator, Mask, Scalar, Signal};

use crate::Switching;

/// Most pieces of one step.
const PIECES: usize = 64;

/// Most tries for an instant. At least every fourth one halves the bracket.
const ROUNDS: usize = 240;

/// An integrator of [switching](Switching) motion that steps to each switching instant and goes on from there, so that
/// no step contains a kink and the order is kept.
///
/// An instant is a zero of the switching function along the inner integrator's own step. It is bracketed to two units
/// in the last place by the secant method, with the Illinois remedy where one end stays (Dowell and Jarratt 1971) and a
/// bisection every fourth time. A function that falls below 0 and comes back within one step is not noticed.
///
/// After 64 pieces the rest of a step is taken as one, whatever switches there. Each lane has its own instants, and
/// moves as the scalar run does, bit for bit. A step does not take constant time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EventLocating<I> {
    integrator: I,
}

impl<I> EventLocating<I> {
    /// Steps of `integrator`, cut where the motion switches.
    pub const fn new(integrator: I) -> Self {
        Self { integrator }
    }

    /// The time, within `left` s, at which each lane of `over` switches; `left` in the others.
    fn instant<T, D>(&self, piece: &Piece<'_, T, D>, left: T, over: T::Mask, end: T) -> T
    where
        T: Scalar,
        D: Switching<T>,
        I: Integrator<T, D::Phase> + Copy,
    {
        let choose = <T as Signal>::choose;
        let (mut low, mut high) = (T::of(0.0), left);
        let (mut above, mut below) = (piece.reserve(piece.state), end);
        let (mut rose, mut fell) = (T::Mask::of(false), T::Mask::of(false));
        for round in 0..ROUNDS {
            let open = over & (high - low).above(high * T::epsilon() * T::of(2.0));
            if !open.any() {
                break;
            }
            let half = low + (high - low) * T::of(0.5);
            let secant = high - (high - low) * (below / (below - above));
            let inside = secant.above(low) & secant.below(high) & T::Mask::of(round % 4 != 3);
            let at = choose(open, choose(inside, secant, half), high);
            let mut probe = self.integrator;
            let reserve = piece.reserve(piece.state + piece.gain(&mut probe, at));
            let falls = open & reserve.below(T::of(0.0));
            let rises = open & !falls;
            above = choose(falls & fell, above * T::of(0.5), above);
            below = choose(rises & rose, below * T::of(0.5), below);
            (high, below) = (choose(falls, at, high), choose(falls, reserve, below));
            (low, above) = (choose(rises, at, low), choose(rises, reserve, above));
            (rose, fell) = (rises, falls);
        }
        choose(over, high, left)
    }
}

/// A piece of a motion.
struct Piece<'a, T: Scalar, D: Switching<T>> {
    dynamics: &'a D,
    phase: D::Phase,
    state: D::State,
    input: T,
}

impl<T: Scalar, D: Switching<T>> Piece<'_, T, D> {
    fn reserve(&self, state: D::State) -> T {
        self.dynamics.reserve(&self.phase, state)
    }

    fn gain(&self, integrator: &mut impl Integrator<T, D::Phase>, interval: T) -> D::State {
        integrator.step(&self.phase, self.state, self.input, interval)
    }
}

impl<T, D, I> Integrator<T, D> for EventLocating<I>
where
    T: Scalar,
    D: Switching<T>,
    I: Integrator<T, D::Phase> + Copy,
{
    fn step(&mut self, dynamics: &D, from: D::State, input: T, interval: T) -> D::State {
        let zero = T::of(0.0);
        let (mut gained, mut left) = (D::State::splat(zero), interval);
        let mut phase = dynamics.phase(from, input);
        for _ in 0..PIECES {
            let piece = Piece { dynamics, phase, state: from + gained, input };
            let mut probe = self.integrator;
            let whole = piece.gain(&mut probe, left);
            let end = piece.reserve(piece.state + whole);
            let over = end.below(zero);
            if !over.any() {
                self.integrator = probe;
                return gained + whole;
            }
            let passed = self.instant(&piece, left, over, end);
            let gain = piece.gain(&mut self.integrator, passed);
            gained = gained + gain;
            left -= passed;
            let (next, exactly) = dynamics.switched(&phase, from + gained, input);
            phase = D::chosen(over, next, phase);
            gained = Signal::choose(over, gained + exactly, gained);
        }
        let piece = Piece { dynamics, phase, state: from + gained, input };
        gained + piece.gain(&mut self.integrator, left)
    }
}
