//! The published laws, each set for a loop.

use lyapunov::{
    DampingLimit, LyapunovCandidate, ParameterError, PortEnergy, Requirement, Scalar,
    StorageFunction,
    environments::{ForceLaw, Kinematics},
    stabilizers::{
        EnergyBounding, ForceBounding, LeastNorm, MemoryBased, ReferenceDamper, ReferenceFollowing,
    },
};

use super::Basis;
use crate::files::scene::Render;
use crate::simulate::building::{AnyStabilizer, Space};

/// Cells of a memory of forces.
const CELLS: usize = 256;

/// A cell where nothing tells how far a tick moves, m.
const SMALLEST_CELL: f64 = 1e-6;

/// Room for forces under way: few, and as many as a scene may delay.
const FEW: usize = 16;
const MOST: usize = 1024;

/// Device damping that energy bounding needs.
const DEVICE_DAMPING: &str = "device.damping";

/// Whether a stabilizer was refused because the device has no damping.
pub(crate) fn lacks_damping(error: &ParameterError) -> bool {
    error.parameter == DEVICE_DAMPING
}

type Made<T> = Result<AnyStabilizer<T>, ParameterError>;

impl Basis {
    /// Energy bounding, which needs a damping of the device.
    pub(super) fn energy_bounding<T: Scalar + Space>(&self) -> Made<T> {
        let damping = Requirement::Positive.check(DEVICE_DAMPING, T::of(self.damping))?;
        let period = T::of(self.limit.period);
        let bounding = EnergyBounding::delayed(damping, period, self.delay)?;
        Ok(AnyStabilizer::called(bounding))
    }

    /// Force bounding that sets aside what is under way.
    pub(super) fn force_bounding<T: Scalar + Space>(&self) -> Made<T> {
        let bounding = ForceBounding::of_damping(T::of(self.damping))?;
        Ok(match self.delay as usize {
            0 => AnyStabilizer::called(bounding),
            1..=FEW => AnyStabilizer::called(bounding.delayed::<FEW>(self.delay)?),
            _ => AnyStabilizer::called(bounding.delayed::<MOST>(self.delay)?),
        })
    }

    /// Memory-based passivation beyond the surface, or the origin where there is none.
    pub(super) fn memory_based<T: Scalar + Space>(&self) -> Made<T> {
        let surface = T::of(self.surface.unwrap_or(0.0));
        let depth = T::of(self.cell() * CELLS as f64);
        let memory = MemoryBased::<T, CELLS>::beyond(surface, depth)?.delayed(self.delay);
        Ok(AnyStabilizer::called(memory))
    }

    /// One count of the encoder, else one tick's motion at the swing's speed, m.
    fn cell(&self) -> f64 {
        let moved = self.count.unwrap_or(self.speed * self.limit.period);
        if moved > 0.0 { moved } else { SMALLEST_CELL }
    }

    /// The least-norm filter that may spend all in a tick.
    pub(super) fn least_norm<T: Scalar + Space>(&self) -> Made<T> {
        let filter = LeastNorm::new(PortEnergy, self.limit.limit()?, T::of(1.0))?;
        Ok(AnyStabilizer::called(filter))
    }

    /// Reference energy following with what the ideal wall dissipates; elsewhere with what is stored alone.
    pub(super) fn reference_following<T: Scalar + Space>(&self) -> Made<T> {
        let start = self.start.map(T::of);
        let following = Following { limit: self.limit.limit()?, start, damper: self.damper };
        match &self.reference {
            None => following.of(|_, _| T::zero()),
            Some(reference) => reference.render(following),
        }
    }
}

/// Reference of a store and a damper, from a position and a velocity on.
struct Following<T: Scalar> {
    limit: DampingLimit<T>,
    start: [T; 2],
    /// Of the ideal wall: N·s/m, and where it begins, m.
    damper: Option<[f64; 2]>,
}

impl<T: Scalar + Space> Following<T> {
    fn of(self, stored: impl Fn(T, T) -> T + 'static) -> Made<T> {
        let [x, v] = self.start;
        let [damping, surface] = self.damper.unwrap_or([0.0; 2]).map(T::of);
        let depth = move |x: T| (x - surface).larger(T::zero());
        let damper = ReferenceDamper::starting(damping, depth, x)?;
        let reference = (StorageFunction::starting(stored, x, v), damper);
        let following = ReferenceFollowing::new((PortEnergy, reference), self.limit);
        Ok(AnyStabilizer::called(following))
    }
}

impl<T: Scalar + Space> Render<T> for Following<T> {
    type Made = AnyStabilizer<T>;

    fn render(
        self,
        environment: impl ForceLaw<T> + 'static,
        _credit: impl LyapunovCandidate<T> + 'static,
    ) -> Made<T> {
        self.of(move |x, v| environment.stored(&Kinematics::at(x, v)))
    }
}
