//! Quantities of a loop that set the numbers of its stabilizers.

use lyapunov::{DampingLimit, ParameterError, Scalar};

use super::directed_damping::Direction;
use super::{Reference, Search};
use crate::files::scene::{Damping, Scene};

/// Cells of a memory.
pub(super) const CELLS: usize = 256;

/// Slots of a credit window.
pub(super) const SLOTS: usize = 8;

/// A cell of a memory where nothing tells how far a tick moves, m.
const SMALLEST_CELL: f64 = 1e-6;

/// A loop's quantities that set the numbers of its stabilizers.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Basis {
    /// The quantities that make the damping limit, with the default cap.
    pub(crate) limit: Damping,
    /// The device's damping, N·s/m.
    pub(crate) damping: f64,
    /// The energy that the motion starts with, or that the hand's spring has at the start where the hand goes, J: the
    /// scale of all energies.
    pub(crate) energy: f64,
    /// The speed at which the mass has that energy, m/s.
    pub(crate) speed: f64,
    /// The duration of a swing of the hand, s.
    pub(crate) swing: f64,
    /// One count of the encoder, m.
    pub(crate) count: Option<f64>,
    /// Ticks by which a force acts late.
    pub(crate) delay: u32,
    /// Servo ticks per tick of the environment.
    pub(crate) ratio: u32,
    /// The position where contact begins, m.
    pub(crate) surface: Option<f64>,
    /// The largest change of the environment's answer over a change of position, N/m; none where there is no bound.
    pub(crate) steepest: Option<f64>,
    /// The damper on a proxy that makes any answer of the environment passive, N·s/m.
    pub(crate) drag: f64,
    /// The energy that the environment stores; none where it is no function of position and velocity.
    pub(crate) reference: Option<Reference>,
    /// The damper of the ideal wall, N·s/m, and where it begins, m; none without a wall.
    pub(crate) damper: Option<[f64; 2]>,
    /// The direction in which the environment pushes, the first axis where that is none in particular.
    pub(crate) normal: Direction,
    /// Position and velocity at the start, m and m/s.
    pub(crate) start: [f64; 2],
    /// The energy of a plane, a sphere or a box that is pressed at the start, J; 0 on a line.
    pub(crate) pressed: f64,
    /// The scene, for an own stabilizer that looks there; none without one.
    pub(crate) scene: Option<Box<Scene>>,
}

impl Basis {
    /// The energy that the environment stores at the start, J; not below 0.
    pub(crate) fn stored(&self) -> f64 {
        let [x, v] = self.start;
        self.reference.as_ref().map_or(self.pressed, |it| it.stored::<f64>(x, v)).max(0.0)
    }

    /// The speed above which a velocity is more than noise, m/s. The difference of two positions that are one count
    /// apart may round to either side of one count a tick, and the next speed is two.
    pub(super) fn threshold(&self) -> f64 {
        self.count.map_or(0.01 * self.speed, |count| 1.5 * count / self.limit.period)
    }

    /// The number of ticks over which a correction is spread, or rises.
    pub(super) fn ticks(&self) -> u32 {
        self.ratio.max(2)
    }

    /// The fastest that a correction of `cap` m / T may grow, N/s: to the largest correction at the hand's speed within
    /// those ticks; no limit where the speed is unknown.
    pub(super) fn rate(&self, cap: f64) -> f64 {
        let Damping { port_mass, period, .. } = self.limit;
        let most = cap * port_mass / period * self.speed;
        let rate = most / (f64::from(self.ticks()) * period);
        if rate > 0.0 { rate } else { f64::INFINITY }
    }

    /// The length of each of the cells of a memory, m: one count of the encoder, else one tick's motion at the swing's
    /// speed, or more where they would not reach [twice as deep](Self::depth) as the energy presses.
    pub(super) fn cell(&self) -> f64 {
        let moved = self.count.unwrap_or(self.speed * self.limit.period);
        let reaching = 2.0 * self.depth() / CELLS as f64;
        let cell = moved.max(reaching);
        if cell > 0.0 && cell.is_finite() { cell } else { SMALLEST_CELL }
    }

    /// The depth at which a spring as stiff as the environment holds the energy that the motion starts with, m; 0 where
    /// there is no such stiffness.
    fn depth(&self) -> f64 {
        let stiffness = self.steepest.filter(|it| *it > 0.0 && it.is_finite());
        stiffness.map_or(0.0, |stiffness| (2.0 * self.energy / stiffness).sqrt())
    }

    /// What the device's damper takes from a displacement of a tick, over the square of that, N/m: `b / T`.
    pub(super) fn burns(&self) -> f64 {
        self.damping / self.limit.period
    }

    /// Ticks from a displacement to the force that answers it acting, and half of the tick that it then acts.
    pub(super) fn lateness(&self) -> f64 {
        0.5 + f64::from(self.delay)
    }

    /// The key of the device's damping where that is 0.
    pub(super) fn undamped(&self) -> Option<&'static str> {
        (self.damping == 0.0).then_some("device.damping")
    }

    /// The damping limit of `cap` m / T.
    pub(super) fn limit<T: Scalar>(&self, cap: f64) -> Result<DampingLimit<T>, ParameterError> {
        Damping { cap, ..self.limit }.limit()
    }

    /// Caps worth a try: up to the damping that would stop the mass within a tick, or for a late force up to half of
    /// that from which on the damper itself makes it swing.
    pub(super) fn caps(&self) -> Option<Search> {
        let most = 2.0 * Damping::default_cap(self.delay);
        Search::ratios(0.02 * most, most)
    }

    /// Energies worth a try about that of the start.
    pub(super) fn energies(&self) -> Option<Search> {
        Search::ratios(1e-3 * self.energy, 10.0 * self.energy)
    }

    /// Numbers of ticks worth a try for what takes a few.
    pub(super) fn spans(&self) -> Option<Search> {
        Search::ratios(1.0, 16.0 * f64::from(self.ticks()))
    }

    /// Dampings worth a try for a law that relies on no more than the device has.
    pub(super) fn dampings(&self) -> Option<Search> {
        Search::ratios(0.1 * self.damping, self.damping)
    }
}
