//! Energies that the body of a scene stores, receives and dissipates.

use std::ops::Add;

use lyapunov::{
    ParameterError,
    trajectories::{Constant, Ramp, RampParts, Samples, Sine, Step, Trajectory},
};
use nalgebra::{DMatrix, DVector};

use crate::files::scene::{Motion, Scene};
use crate::simulate::{Space, Tick};

/// Terms of a series in a matrix whose rows sum to at most a half.
const TERMS: u32 = 24;

/// Sweeps of the balancing.
const SWEEPS: u32 = 32;

type Value = Box<dyn Fn(u64) -> f64>;

/// The body of a scene, with all that acts on it from outside the port; its axes move independently, each by the same
/// numbers.
pub(super) struct Body {
    scene: Scene,
    rest: Value,
    push: Value,
    shape: Shape,
    next: usize,
}

/// The body between two changes of grip.
struct Shape {
    /// The operator's stiffness and damping, N/m and N·s/m.
    stiffness: f64,
    damping: f64,
    /// `∫ v² dt` of the device, of the operator and of one relative to the other, from the state at the start of a
    /// tick.
    burnt: [DMatrix<f64>; 3],
    /// The device's velocity at the end of a tick, from the same state.
    velocity: Vec<f64>,
}

/// Position and velocity of operator and device at a tick; both are the same without a link.
#[derive(Clone, Copy, Debug)]
pub(super) struct Masses<V> {
    pub(super) operator: [V; 2],
    pub(super) device: [V; 2],
}

impl<V: Space<Scalar = f64>> Masses<V> {
    /// The masses at `tick`.
    pub(super) fn at<S: Space<Double = V>>(tick: &Tick<S>) -> Self {
        let of = |position: S, velocity: S| [position.double(), velocity.double()];
        let device = of(tick.truth.position, tick.truth.velocity);
        let operator = tick.operator.map_or(device, |it| of(it.position, it.velocity));
        Self { operator, device }
    }

    /// The masses along an axis.
    fn along(self, axis: usize) -> Masses<f64> {
        let of = |[position, velocity]: [V; 2]| [position.axis(axis), velocity.axis(axis)];
        Masses { operator: of(self.operator), device: of(self.device) }
    }
}

/// Energies of a tick beside the port, J.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Passed {
    /// Given by the hand, which moves its rest or its grip, before the tick.
    pub(super) hand: f64,
    /// Given by load and pulse.
    pub(super) push: f64,
    /// Dissipated in device, operator and link.
    pub(super) burnt: [f64; 3],
    /// Gained by kinetic and spring energy.
    pub(super) gained: f64,
    /// Stored at the end.
    pub(super) stored: f64,
}

impl Add for Passed {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            hand: self.hand + other.hand,
            push: self.push + other.push,
            burnt: std::array::from_fn(|index| self.burnt[index] + other.burnt[index]),
            gained: self.gained + other.gained,
            stored: self.stored + other.stored,
        }
    }
}

impl Body {
    pub(super) fn of(scene: &Scene) -> Result<Self, ParameterError> {
        let (operator, rate) = (&scene.operator, scene.servo_rate.get());
        let load = scene.effects.load.map_or(0.0, |load| load.force.get());
        let load = Constant::new(load)?;
        let pulse = scene.effects.pulse.map(|it| it.on_ticks(rate)).transpose()?;
        let push = move |tick| -> f64 {
            let load: f64 = load.at(tick);
            load + pulse.as_ref().map_or(0.0, |pulse| pulse.at(tick))
        };
        let shape = Shape::of(scene, operator.stiffness.get(), operator.damping.get());
        let (scene, rest) = (scene.clone(), rest(scene)?);
        Ok(Self { scene, rest, push: Box::new(push), shape, next: 0 })
    }

    /// The energies from `tick` to the next, while the body moves `from` to `to` for `span` s under `effort` at the port.
    pub(super) fn pass<V: Space<Scalar = f64>>(
        &mut self,
        (tick, span): (u64, f64),
        from: Masses<V>,
        to: Masses<V>,
        effort: V,
    ) -> Passed {
        let axes = 0..V::DIMENSIONS;
        let before = |axis: usize| {
            let own = self.scene.operator.rest.axis(axis);
            let rest = tick.checked_sub(1).map_or(own, |last| self.rest(last, axis));
            self.stored(from.along(axis), rest)
        };
        let before: Vec<f64> = axes.clone().map(before).collect();
        self.grip(tick);
        let along = |axis: usize| {
            let (from, to) = (from.along(axis), to.along(axis));
            self.pass_along(axis, (tick, span, before[axis]), from, to, effort.axis(axis))
        };
        axes.map(along).reduce(Add::add).unwrap_or_default()
    }

    /// The energies along an axis over `span` s from `tick` on, where the body stored `before` until then.
    fn pass_along(
        &self,
        axis: usize,
        (tick, span, before): (u64, f64, f64),
        from: Masses<f64>,
        to: Masses<f64>,
        effort: f64,
    ) -> Passed {
        let rest = self.rest(tick, axis);
        let push = if axis == 0 { (self.push)(tick) } else { 0.0 };
        let (start, stored) = (self.stored(from, rest), self.stored(to, rest));
        let mut state = self.state(from, rest, effort - push);
        if self.scene.effects.friction.is_some() {
            self.shape.rub(&mut state, to.device[1]);
        }
        let burnt = &self.shape.burnt;
        let share = span / self.scene.period();
        let burn = |index: usize, damping: f64| {
            damping * (state.transpose() * &burnt[index] * &state)[0] * share
        };
        let device = self.scene.device.damping.get();
        let link = self.scene.link.map_or(0.0, |link| link.damping.get());
        Passed {
            hand: start - before,
            push: push * (to.device[0] - from.device[0]),
            burnt: [burn(0, device), burn(1, self.shape.damping), burn(2, link)],
            gained: stored - before,
            stored,
        }
    }

    /// The rest position of the operator's spring, which moves along the first axis.
    fn rest(&self, tick: u64, axis: usize) -> f64 {
        if axis == 0 { (self.rest)(tick) } else { self.scene.operator.rest.axis(axis) }
    }

    /// Applies the grip of a tick.
    fn grip(&mut self, tick: u64) {
        let Some(grip) = &self.scene.operator.grip else { return };
        let rows = grip.times.iter().zip(&grip.stiffness).zip(&grip.damping);
        let due = rows
            .skip(self.next)
            .take_while(|((time, _), _)| self.scene.tick_of(time.get()) <= tick);
        let Some((count, ((_, stiffness), damping))) = due.enumerate().last() else { return };
        self.next += count + 1;
        self.shape = Shape::of(&self.scene, stiffness.get(), damping.get());
    }

    fn stored(&self, masses: Masses<f64>, rest: f64) -> f64 {
        let scene = &self.scene;
        let kinetic = |mass: f64, velocity: f64| 0.5 * mass * velocity * velocity;
        let link = scene.link.map_or(0.0, |link| link.stiffness.get());
        let stretch = masses.operator[0] - masses.device[0];
        let deflection = masses.operator[0] - rest;
        kinetic(scene.operator.mass.get(), masses.operator[1])
            + kinetic(scene.device.mass.get(), masses.device[1])
            + 0.5 * self.shape.stiffness * deflection * deflection
            + 0.5 * link * stretch * stretch
    }

    fn state(&self, masses: Masses<f64>, rest: f64, effort: f64) -> DVector<f64> {
        let from = |origin: f64, [position, velocity]: [f64; 2]| [position - origin, velocity];
        // Of a link only its stretch: a stiff one would drown in the rounding of two long ways.
        let mut state = match self.scene.link {
            None => from(rest, masses.device).to_vec(),
            Some(_) => {
                let [device, operator] =
                    [from(masses.operator[0], masses.device), from(rest, masses.operator)];
                [device, operator].concat()
            }
        };
        state.push(effort);
        DVector::from_vec(state)
    }
}

impl Shape {
    fn of(scene: &Scene, stiffness: f64, damping: f64) -> Self {
        let (device, operator) = (scene.device, scene.operator.mass.get());
        let (m, b) = (device.mass.get(), device.damping.get());
        let (rates, outputs) = match scene.link {
            None => {
                let (m, b) = (m + operator, b + damping);
                let rates = [[0.0, 1.0, 0.0], [-stiffness / m, -b / m, -1.0 / m], [0.0; 3]];
                let rates = DMatrix::from_row_slice(3, 3, &rates.concat());
                (rates, [vec![0.0, 1.0, 0.0], vec![0.0, 1.0, 0.0], vec![0.0; 3]])
            }
            Some(link) => {
                let (kl, bl) = (link.stiffness.get(), link.damping.get());
                let pulled = [-kl / m, -(b + bl) / m, 0.0, bl / m, -1.0 / m];
                let held = [kl, bl, -stiffness, -(damping + bl), 0.0].map(|it| it / operator);
                let stretch = [0.0, 1.0, 0.0, -1.0, 0.0];
                let rates = [stretch, pulled, [0.0, 0.0, 0.0, 1.0, 0.0], held, [0.0; 5]];
                let rates = DMatrix::from_row_slice(5, 5, &rates.concat());
                let row = |device: f64, operator: f64| vec![0.0, device, 0.0, operator, 0.0];
                (rates, [row(1.0, 0.0), row(0.0, 1.0), row(1.0, -1.0)])
            }
        };
        let [device, operator, link] =
            outputs.map(|row| squared(&rates, &DVector::from_vec(row), scene.period()));
        Self { stiffness, damping, burnt: [device.0, operator.0, link.0], velocity: device.1 }
    }

    /// Adds to the effort in `state` the friction that, held over the tick, leads to the device's velocity `end`.
    fn rub(&self, state: &mut DVector<f64>, end: f64) {
        let effort = state.len() - 1;
        let alone: f64 = self.velocity.iter().zip(state.iter()).map(|(gain, it)| gain * it).sum();
        let friction = (end - alone) / self.velocity[effort];
        state[effort] += if friction.is_finite() { friction } else { 0.0 };
    }
}

/// `∫ (c exp(A t))ᵀ (c exp(A t)) dt` from 0 to `period`, and the row of the velocity in `exp(A period)`: by series over a short
/// part, which is then doubled, `G(2 t) = G(t) + exp(A t)ᵀ G(t) exp(A t)`.
fn squared(rates: &DMatrix<f64>, output: &DVector<f64>, period: f64) -> (DMatrix<f64>, Vec<f64>) {
    // In units in which rows and columns are alike a stiff link takes as many doublings as its frequency asks for, and not
    // as many as its stiffness over a small mass; each doubles the rounding. They are powers of two, so they round nothing.
    let mut rates = rates.clone();
    let units = balanced(&mut rates);
    let output = output.component_mul(&units);
    let size = rates.row_iter().map(|row| row.iter().map(|it| it.abs()).sum::<f64>());
    let size = period * size.fold(0.0, f64::max);
    let halvings = if size > 0.25 { (size / 0.25).log2().ceil().min(1100.0) as i32 } else { 0 };
    let short = period / 2f64.powi(halvings);
    let n = rates.nrows();
    let (mut power, mut square) = (DMatrix::identity(n, n), &output * output.transpose());
    let (mut moved, mut sum) = (power.clone(), &square * short);
    for term in 1..=TERMS {
        let share = short / f64::from(term);
        power = &power * &rates * share;
        moved += &power;
        square = (rates.transpose() * &square + &square * &rates) * share;
        sum += &square * (short / f64::from(term + 1));
    }
    for _ in 0..halvings {
        sum = &sum + moved.transpose() * &sum * &moved;
        moved = &moved * &moved;
    }
    let row = (0..n).map(|column| units[1] * moved[(1, column)] / units[column]).collect();
    (DMatrix::from_fn(n, n, |row, column| sum[(row, column)] / units[row] / units[column]), row)
}

/// Units, powers of two, in which rows and columns of `rates` are alike: `D⁻¹ A D` (Parlett and Reinsch 1969). The sweeps
/// are counted, since numbers near the ends of the range may never agree.
fn balanced(rates: &mut DMatrix<f64>) -> DVector<f64> {
    let n = rates.nrows();
    let mut units = DVector::from_element(n, 1.0);
    for _ in 0..SWEEPS {
        let mut is_balanced = true;
        for own in 0..n {
            let others = (0..n).filter(|other| *other != own);
            let column: f64 = others.clone().map(|row| rates[(row, own)].abs()).sum();
            let row: f64 = others.map(|column| rates[(own, column)].abs()).sum();
            let octaves = (0.5 * (row.log2() - column.log2())).round();
            if !octaves.is_finite() || octaves.abs() < 1.0 {
                continue;
            }
            let unit = 2f64.powi(octaves as i32);
            rates.column_mut(own).scale_mut(unit);
            rates.row_mut(own).scale_mut(1.0 / unit);
            units[own] *= unit;
            is_balanced = false;
        }
        if is_balanced {
            break;
        }
    }
    units
}

/// The rest position of the operator's spring along the first axis, tick by tick.
fn rest(scene: &Scene) -> Result<Value, ParameterError> {
    let (rest, rate) = (scene.operator.rest.get(), scene.servo_rate.get());
    Ok(match &scene.operator.motion {
        None => Box::new(move |_| rest),
        Some(Motion::Step { at, to }) => {
            let trajectory = Step::new(rest, to.get(), at.get(), rate)?;
            Box::new(move |tick| trajectory.at(tick))
        }
        Some(Motion::Ramp { at, to, rate: speed }) => {
            let (to, at) = (to.get(), at.get());
            let parts = RampParts { from: rest, to, rate: speed.get(), at };
            let trajectory = Ramp::new(parts, rate)?;
            Box::new(move |tick| trajectory.at(tick))
        }
        Some(Motion::Sine { amplitude, frequency }) => {
            let trajectory = Sine::new(rest, amplitude.get(), frequency.get(), rate)?;
            Box::new(move |tick| trajectory.at(tick))
        }
        Some(Motion::File { samples, .. }) => {
            let trajectory = Samples::new(std::sync::Arc::clone(samples), rate)?;
            Box::new(move |tick| trajectory.at(tick))
        }
    })
}

#[cfg(test)]
mod tests {
    use super::super::Trial;
    use crate::files::Scene;

    /// A hand of 8 g without a spring behind a link of 9e8 N/m, 6 mm from a rest that does not pull: a random scene in
    /// which 0.18 nJ were left over, the rounding of the 16 kJ that a link of 6 mm would store.
    #[test]
    fn a_stiff_link_that_does_not_move_moves_no_energy() {
        let text = "duration = 0.001\nservo_rate = 9000.0\ndevice.mass = 3.0\nlink.stiffness = 9e8\n\
            operator = { mass = 0.008, damping = 2000.0, rest = 0.006 }\nenvironment.wall.stiffness = 3e9\n";
        let scene = Scene::parse(text, "test").unwrap();
        let trial = Trial::of::<f64>(&scene).unwrap();
        assert_eq!((trial.whole.closing, trial.whole.operator, trial.moved), (0.0, 0.0, 0.0));
    }

    /// A hand of 30 mg behind a link of 5e7 N/m, whose stiffness over that mass is 4.6e4 over the period squared: a random
    /// scene in which 3e-9 of the energy were left over.
    #[test]
    fn a_hand_that_swings_fast_behind_a_stiff_link_leaves_rounding_only() {
        let text = "duration = 0.0002\nservo_rate = 6020.0\ndevice = { mass = 0.4, damping = 3.0 }\n\
            link.stiffness = 5e7\noperator = { mass = 3e-5, damping = 30.0 }\ninitial.velocity = 2000.0\n\
            environment.wall = { position = 1.0, stiffness = 6e4 }\n";
        let scene = Scene::parse(text, "test").unwrap();
        let trial = Trial::of::<f64>(&scene).unwrap();
        assert!(trial.moved > 1e5, "{} J", trial.moved);
        let left = trial.whole.closing.abs() / trial.moved;
        assert!(left < 1e-12, "{left:e}");
    }
}
