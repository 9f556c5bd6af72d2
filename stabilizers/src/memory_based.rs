//! Memory-based passivation: forces on the way out no larger than those kept from the way in.

use lyapunov_core::{
    Accumulator, Correction, Mask, ParameterError, Plain, PortSample, Requirement, Scalar,
    Snapshot, Stabilizer,
};

use crate::StabilizerExt;
use crate::account::account_in_sum;
use crate::limiting::limiting;
use crate::range::in_range;
use nalgebra::SVector;

/// Memory-based passivation, after Ryu and Yoon (IEEE/ASME Transactions on Mechatronics 19(4), 2014): the force of the
/// pressing path is kept by position, and the releasing path may not be above it.
///
/// ```text
/// inwards  (Δx > 0): every cell of width h that [x − Δx, x] touches gets M = max(0, force that applied);   F = f
/// outwards (Δx < 0): F = min(f, M of every cell that [x + (1 + d) Δx, x] touches)
/// at rest            F = f
/// ```
///
/// One axis, one side: the environment lies beyond a surface and pushes against `+x`; before the surface `M = 0`. The
/// last of the `N` cells reaches on without an end. `d` is the delay of the force in ticks.
///
/// **Guarantee** (derived here, as is the look ahead; the paper's own text was not at hand): cell by cell no more
/// force comes out than acted last on the way in, but for the `1 + d` ticks in which a motion turns round, whose
/// force was given before it did. Place by place that is true to within a cell: of a force that rises within one, the
/// last is kept for all of it. After a way in from the surface, on which the force rose by `R` N in all from tick to
/// tick, no more than `h R` J too much comes out, which is much in large cells and little in such of a tick's motion.
/// **Assumed** is that the next displacements are no larger than the last; with too short a look ahead it leaks, and
/// a delay of one tick needs two. Take cells of about one tick's motion. [`PathMemory`](crate::PathMemory) keeps
/// energies instead, whatever the motion.
///
/// It needs no velocity and adds no damping. The observed energy is the work of the port; what it gave more than it
/// took is reported as shortfall. Each tick visits all cells, so that it takes the same time wherever the motion is.
///
/// ```
/// use lyapunov_core::{HeldTick, Stabilizer};
/// use lyapunov_stabilizers::MemoryBased;
/// let mut memory = MemoryBased::<f64, 32>::beyond(0.0, 3.2e-3)?; // cells of 0.1 mm
/// // 2 N over the first millimetre
/// let pressed = HeldTick { period: 1e-3, position: 1e-3, velocity: 1.0, displacement: 1e-3, applied: 2.0 }.sample();
/// assert_eq!(memory.stabilize(&pressed, 8.0).effort, 8.0);
/// let back = HeldTick {
///     period: 1e-3, position: 0.9e-3, velocity: -0.1, displacement: -0.1e-3, applied: 8.0
/// }.sample();
/// assert_eq!(memory.stabilize(&back, 7.2).effort, 2.0);
/// # Ok::<(), lyapunov_core::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct MemoryBased<T, const N: usize, A = Plain<T>> {
    surface: T,
    cell: T,
    look: T,
    last: Option<T>,
    forces: [T; N],
    energy: A,
}

impl<T: Scalar, const N: usize> MemoryBased<T, N> {
    /// A memory of the way beyond `surface` m, `depth` m deep.
    ///
    /// # Errors
    /// `surface` infinite or NaN; `depth` not above 0 and finite, or out of range for `N` cells.
    pub fn beyond(surface: T, depth: T) -> Result<Self, ParameterError> {
        let surface = Requirement::Finite.check("surface", surface)?;
        let depth = Requirement::Positive.check("memory depth", depth)?;
        let cell = in_range("memory depth", depth, depth / T::of(N as f64))?;
        let (look, forces) = (T::of(1.0), [T::of(0.0); N]);
        Ok(Self { surface, cell, look, last: None, forces, energy: Plain::zero() })
    }
}

impl<T: Scalar, const N: usize, A: Accumulator<T>> MemoryBased<T, N, A> {
    /// The same memory with its energies summed in a `B`.
    #[must_use]
    pub fn summed_in<B: Accumulator<T>>(self) -> MemoryBased<T, N, B> {
        let Self { surface, cell, look, last, forces, energy } = self;
        MemoryBased { surface, cell, look, last, forces, energy: B::holding(energy.value()) }
    }

    /// The same memory for a force that acts `ticks` periods late.
    #[must_use]
    pub fn delayed(self, ticks: u32) -> Self {
        Self { look: T::of(1.0 + f64::from(ticks)), ..self }
    }

    /// Lanes in which cell `index` and the stretch `[from, to]`, from the surface on, touch.
    #[inline(always)]
    fn touched(&self, index: usize, from: T, to: T) -> T::Mask {
        let start = self.cell * T::of(index as f64);
        let end = if index + 1 == N { T::largest() } else { self.cell * T::of(index as f64 + 1.0) };
        !start.above(to) & from.below(end)
    }
}

impl<T, const N: usize, A> StabilizerExt for MemoryBased<T, N, A> {}

impl<T: Scalar, const N: usize, A: Accumulator<T>> Stabilizer<T> for MemoryBased<T, N, A> {
    #[inline(always)]
    fn stabilize(&mut self, sample: &PortSample<T>, effort: T) -> Correction<T> {
        let zero = T::of(0.0);
        let inside = sample.position - self.surface;
        let sound = sample.sound() & inside.finite();
        let booked = self.energy.book(sample.work);
        let moved = T::choose(sound, sample.displacement, zero);
        let last = self.last.unwrap_or(T::of(f64::NAN));
        let now = T::choose(sound, inside, last);
        // Where it was, and not where the displacement leads back to: an edge of a cell is met to the bit.
        let before = T::choose(last.finite(), last, now - moved);
        self.last = (self.last.is_some() || now.finite().any()).then_some(now);
        let (inwards, outwards) = (moved.above(zero), moved.below(zero));

        let applied = T::choose(sound, sample.applied.larger(zero), zero);
        let ahead = now + self.look * moved;
        let mut most = T::choose(ahead.below(zero), zero, T::largest());
        for index in 0..N {
            let kept = self.forces[index];
            let pressed = inwards & self.touched(index, before, now);
            self.forces[index] = T::choose(pressed, applied, kept);
            most = T::choose(self.touched(index, ahead, now), most.smaller(kept), most);
        }
        let accepted = booked & sound & effort.finite();
        let bounded = T::choose(outwards, effort.smaller(most), effort);
        limiting(bounded, self.energy.value(), accepted)
    }
}

account_in_sum!(impl[T: Scalar, const N: usize, A: Accumulator<T>] MemoryBased<T, N, A>, in T, is energy);

impl<T: Scalar, const N: usize, A: Accumulator<T> + Snapshot> Snapshot for MemoryBased<T, N, A> {
    /// The last depth, m, NaN in a lane that has none, the forces in the cells, N, and the energy, J.
    type State = (Option<T>, SVector<T, N>, A::State);

    fn state(&self) -> Self::State {
        (self.last, SVector::from(self.forces), self.energy.state())
    }

    fn restored(self, (last, forces, energy): Self::State) -> Result<Self, ParameterError> {
        if let Some(depth) = last {
            Requirement::Finite.check_known("stored depth", depth)?;
        }
        let forces = Requirement::NonNegative.check_axes("stored force", forces)?.into();
        Ok(Self { last, forces, energy: self.energy.restored(energy)?, ..self })
    }
}
