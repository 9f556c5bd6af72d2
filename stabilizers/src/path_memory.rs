//! Path memory: letting go gives no more energy, place by place, than pressing in took.

use lyapunov_core::lanes::apart;
use lyapunov_core::{
    Accumulator, Correction, ParameterError, Plain, PortSample, Requirement, Scalar, Snapshot,
    Stabilizer,
};

use crate::StabilizerExt;
use crate::account::owed;
use crate::limiting::limiting;
use crate::range::in_range;
use nalgebra::SVector;

/// A memory of energies: what pressing in took is kept place by place, and letting go gives no more there. One axis,
/// one side: the environment lies beyond a surface and pushes against `+x`, like a wall.
///
/// The depth beyond the surface is divided into `N` cells, each with a force `Mᵢ ≥ 0`. A motion inwards under the mean
/// force `F = work / Δx` writes `max(0, F)` into the cells that it enters, and where it starts within a cell the
/// smaller of that and what is there. So on each stretch of the way no more than was taken there is in memory, and
/// `A(a, b) = Σ Mᵢ |cell i ∩ [a, b]|` is what a motion from `b` out to `a` may give. What it gave more is a debt, paid
/// off by what later motions outwards give less:
///
/// ```text
/// D(n) = max(0, D(n−1) − work(n) − A(x(n), x(n−1)))    outwards
/// D(n) = D(n−1) + max(0, −work(n))                     otherwise
/// F(n) ≤ max(0, (A(x − l, x) − D(n)) / l)              where v < 0;  l = max(|v| T, a cell)
/// ```
///
/// The port's energy is never below `−D`, whatever the motion and whatever applied: each stretch gives what it took or
/// less, and the rest is in `D`. `D` is not 0 where a motion turns round within a period, or is faster than the last
/// velocity; it is reported as shortfall, and the observed energy is `−D`. Unlike the passivity observer it does not
/// let what was absorbed elsewhere pay; so it acts in the first contact, with small cuts, and never pushes. Efforts are
/// only made smaller, and only on the way out.
///
/// It is derived here from the memory of forces of Ryu and Yoon ([`MemoryBased`](crate::MemoryBased)), which keeps no
/// debt: what that one gives too much where a motion turns round, this one gives less later. It looks one period ahead
/// whatever the delay; for a force that acts later the debt makes up. Beyond the last cell, which reaches on without an
/// end, the smallest force of its loading bounds; before the surface nothing is bounded.
///
/// Each tick visits all cells once, several at a time where the processor has vectors, so that it takes the same time
/// wherever the motion is (`benches/stabilizers` measures it). Take cells of about the displacement of a period: larger ones
/// give less back, smaller ones cost time.
///
/// ```
/// use approx::assert_abs_diff_eq;
/// use lyapunov_core::{HeldTick, Stabilizer};
/// use lyapunov_stabilizers::PathMemory;
/// let mut memory = PathMemory::<f64, 32>::beyond(0.0, 3.2e-3)?; // cells of 0.1 mm
/// // 2 N over the first millimetre
/// let pressed = HeldTick { period: 1e-3, position: 1e-3, velocity: 1.0, displacement: 1e-3, applied: 2.0 }.sample();
/// assert_eq!(memory.stabilize(&pressed, 8.0).effort, 8.0);
/// let back = HeldTick {
///     period: 1e-3, position: 0.9e-3, velocity: -0.1, displacement: -0.1e-3, applied: 2.0
/// }.sample();
/// let effort: f64 = memory.stabilize(&back, 7.2).effort;
/// assert_abs_diff_eq!(effort, 2.0, epsilon = 1e-9);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PathMemory<T, const N: usize, A = Plain<T>> {
    surface: T,
    cell: T,
    forces: [T; N],
    /// The debt with a minus sign, J: 0 or less.
    energy: A,
}

impl<T: Scalar, const N: usize> PathMemory<T, N> {
    /// A memory of the way beyond `surface` m, `depth` m deep.
    ///
    /// # Errors
    /// `surface` infinite or NaN; `depth` not above 0 and finite, or out of range for `N` cells.
    pub fn beyond(surface: T, depth: T) -> Result<Self, ParameterError> {
        let surface = Requirement::Finite.check("surface", surface)?;
        let depth = Requirement::Positive.check("memory depth", depth)?;
        let cell = in_range("memory depth", depth, depth / T::of(N as f64))?;
        Ok(Self { surface, cell, forces: [T::of(0.0); N], energy: Plain::zero() })
    }
}

impl<T: Scalar, const N: usize, A: Accumulator<T>> PathMemory<T, N, A> {
    /// The same memory with its debt summed in a `B`.
    #[must_use]
    pub fn summed_in<B: Accumulator<T>>(self) -> PathMemory<T, N, B> {
        let Self { surface, cell, forces, energy } = self;
        PathMemory { surface, cell, forces, energy: B::holding(energy.value()) }
    }

    /// Writes the way `back..on` that was gone `inwards` under `force`, and adds up what the memory allows over two
    /// stretches: over the same way before it is written, and over `ahead..on` after, J.
    ///
    /// One pass over the cells, each by itself, so that a processor's vectors take several at once; the sums are apart.
    #[inline(always)]
    fn walk(
        &mut self,
        [back, on]: [T; 2],
        force: T,
        inwards: T::Mask,
        [ahead, now]: [T; 2],
    ) -> [T; 2] {
        let (cell, mut gave, mut gives) = (self.cell, [T::of(0.0); N], [T::of(0.0); N]);
        let (low, high) = (back.smaller(on), back.larger(on));
        let way = Way { low, high, force, inwards, ahead, now };
        for index in 0..N - 1 {
            apart::<T>();
            let ends = [cell * T::of(index as f64), cell * T::of(index as f64 + 1.0)];
            [gave[index], gives[index]] = way.through(ends, &mut self.forces[index]);
        }
        // The last one has no end.
        let ends = [cell * T::of((N - 1) as f64), T::largest()];
        [gave[N - 1], gives[N - 1]] = way.through(ends, &mut self.forces[N - 1]);
        [side_by_side(&gave), side_by_side(&gives)]
    }
}

/// A way that is gone and a stretch ahead.
struct Way<T: Scalar> {
    low: T,
    high: T,
    force: T,
    inwards: T::Mask,
    ahead: T,
    now: T,
}

impl<T: Scalar> Way<T> {
    /// Writes the way into the cell of the force `kept` from `start` to `end`, and returns what the memory allows there over it and
    /// over the stretch ahead, J.
    #[inline(always)]
    fn through(&self, [start, end]: [T; 2], kept: &mut T) -> [T; 2] {
        let zero = T::of(0.0);
        let gave = *kept * (self.high.smaller(end) - self.low.larger(start)).larger(zero);
        let written = T::choose(start.below(self.low), self.force.smaller(*kept), self.force);
        let crossed = self.inwards & start.below(self.high) & self.low.below(end);
        *kept = T::choose(crossed, written, *kept);
        [gave, *kept * (self.now.smaller(end) - self.ahead.larger(start)).larger(zero)]
    }
}

/// The sum of all, in eight sums side by side.
#[inline(always)]
fn side_by_side<T: Scalar, const N: usize>(terms: &[T; N]) -> T {
    let zero = T::of(0.0);
    let (eights, rest) = terms.as_chunks::<8>();
    let mut sums = [zero; 8];
    for eight in eights {
        for index in 0..8 {
            apart::<T>();
            sums[index] += eight[index];
        }
    }
    let [a, b, c, d, e, f, g, h] = sums;
    let mut all = ((a + e) + (c + g)) + ((b + f) + (d + h));
    for term in rest {
        all += *term;
    }
    all
}

impl<T, const N: usize, A> StabilizerExt for PathMemory<T, N, A> {}

impl<T: Scalar, const N: usize, A: Accumulator<T>> Stabilizer<T> for PathMemory<T, N, A> {
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<T>, effort: T) -> Correction<T> {
        let zero = T::of(0.0);
        let sound = sample.sound();
        let moved = T::choose(sound, sample.displacement, zero);
        let work = T::choose(sound, sample.work, zero);
        let now = T::choose(sound, sample.position - self.surface, zero);
        let before = now - moved;

        let (inwards, outwards) = (moved.above(zero), moved.below(zero));
        let mean = (work / moved).larger(zero);
        let force = T::choose(mean.finite(), mean, zero);
        let ahead = (-sample.velocity * sample.period).larger(self.cell);
        let [gave, gives] = self.walk([before, now], force, inwards, [now - ahead, now]);

        let given = T::choose(outwards, -work - gave, (-work).larger(zero));
        self.energy.book(-given);
        self.energy.lower(zero);
        let debt = self.debt();
        let leaving = sample.velocity.below(zero) & now.above(zero) & sound;
        let most = ((gives - debt) / ahead).larger(zero);
        let bounded = T::choose(leaving, effort.smaller(most), effort);
        let accepted = sound & effort.finite() & most.finite();
        // No debt is 0, and not −0.
        limiting(bounded, zero - debt, accepted)
    }
}

/// It remembers debts alone, and no credit: there is nothing to grant.
impl<T: Scalar, const N: usize, A: Accumulator<T>> PathMemory<T, N, A> {
    /// What it owes, J.
    pub fn debt(&self) -> T {
        T::of(0.0) - self.energy.value()
    }

    /// Adds a `debt` of as many joules, carried over from another controller or an earlier run: the way out gives as
    /// much less.
    ///
    /// ```
    /// use lyapunov_stabilizers::PathMemory;
    /// let mut path = PathMemory::<f64, 16>::beyond(0.0, 0.02)?;
    /// path.owe(1e-3)?;
    /// assert_eq!(path.debt(), 1e-3);
    /// path.reset();
    /// assert_eq!(path.debt(), 0.0);
    /// # Ok::<(), lyapunov_core::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// `debt` below 0, infinite or NaN, or more than there is room for; nothing is changed.
    pub fn owe(&mut self, debt: T) -> Result<(), ParameterError> {
        self.energy = owed(self.energy, debt, Accumulator::book)?;
        Ok(())
    }

    /// Forgives the debt; what was given is given for good. The forces of the path stay.
    pub fn reset(&mut self) {
        self.energy.clear();
    }
}

impl<T: Scalar, const N: usize, A: Accumulator<T> + Snapshot> Snapshot for PathMemory<T, N, A> {
    /// The forces in the cells, N, and the debt with a minus sign, J.
    type State = (SVector<T, N>, A::State);

    fn state(&self) -> Self::State {
        (SVector::from(self.forces), self.energy.state())
    }

    fn restored(self, (forces, energy): Self::State) -> Result<Self, ParameterError> {
        let forces = Requirement::NonNegative.check_axes("stored force", forces)?.into();
        let memory = Self { forces, energy: self.energy.restored(energy)?, ..self };
        Requirement::NonNegative.check("stored debt", memory.debt())?;
        Ok(memory)
    }
}
