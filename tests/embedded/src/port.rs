//! What is no stabilizer by itself, in the place of one.

use lyapunov_core::{
    Correction, OnePort, PortSample, Reading, Readings, Scalar, Signal, Stabilizer,
};
use lyapunov_stabilizers::{
    Constraint, EnergyTank, TwoLayer, TwoPortSide, Valve, WaveFilter, WaveFollower, WaveTransform,
};

/// Spring of `0` N/m.
#[derive(Clone, Copy)]
pub struct Spring<T>(pub T);

impl<V: Signal> OnePort<V> for Spring<V::Scalar> {
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        sample.position.scale(self.0)
    }
}

/// Port that answers by itself, with the effort added.
#[derive(Clone, Copy)]
pub struct Answering<P>(pub P);

impl<V: Signal, P: OnePort<V>> Stabilizer<V> for Answering<P> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        Correction { effort: self.0.respond(sample) + effort, ..self.0.correction() }
    }
}

/// Readings before a stabilizer: it is told position and applied effort, and makes the rest.
#[derive(Clone, Copy)]
pub struct Reads<S, V: Signal>(pub Readings<V>, pub S);

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for Reads<S, V> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let reading = Reading { position: sample.position, applied: sample.applied };
        self.1.stabilize(&self.0.read(reading).sample, effort)
    }
}

/// An end of a channel whose other end it is itself: it receives what it sent on the tick before.
#[derive(Clone, Copy)]
pub struct Looped<S>(pub S);

impl<V: Signal> Stabilizer<V> for Looped<TwoPortSide<V>> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        self.0.receive(self.0.absorbed());
        self.0.stabilize(sample, effort)
    }
}

impl<V: Signal> Stabilizer<V> for Looped<TwoLayer<V::Scalar>> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        self.0.receive(self.0.sent());
        self.0.stabilize(sample, effort)
    }
}

/// A follower's end of a wave channel, with a filter; the effort stands for the wave that comes in.
#[derive(Clone, Copy)]
pub struct Waves<V: Signal> {
    pub transform: WaveTransform<V::Scalar>,
    pub filter: WaveFilter<V>,
    pub follower: WaveFollower<V::Scalar>,
}

impl<V: Signal> Stabilizer<V> for Waves<V> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (there, back) = self.transform.encode(sample.velocity, effort);
        let filtered = self.filter.pass(there);
        let followed = self.follower.follow(filtered, sample.displacement, sample.velocity);
        let (flow, felt) = self.transform.decode(filtered, back);
        Correction {
            effort: felt + followed.effort,
            observed_energy: flow.sum(),
            shortfall: followed.flow.sum(),
            ..Correction::none(effort)
        }
        .checked()
    }
}

/// A tank that passes what it can of the effort.
#[derive(Clone, Copy)]
pub struct Draws<T, L>(pub EnergyTank<T, L>);

impl<V: Signal, L: Valve<V::Scalar>> Stabilizer<V> for Draws<V::Scalar, L> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let dissipated = sample.velocity.inner(sample.velocity);
        let passed = self.0.pass(sample.period, dissipated, effort, sample.velocity);
        Correction { observed_energy: self.0.energy(), ..Correction::none(passed) }
    }
}

/// The inputs of a constraint that says that the effort must not give energy: the least, and Sontag's.
#[derive(Clone, Copy)]
pub struct Constrained;

impl<V: Signal> Stabilizer<V> for Constrained {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let zero = V::Scalar::of(0.0);
        let constraint = Constraint { drift: effort.inner(sample.velocity), gain: sample.velocity };
        let (least, sontag) = (constraint.least_norm(), constraint.sontag());
        let accepted = least.feasible & sontag.feasible;
        let told = Correction::none(V::choose(accepted, least.input, V::zero())).checked();
        let sum = sontag.input.sum();
        let alpha = V::Scalar::choose(sum.finite(), sum, zero);
        Correction { alpha, accepted: told.accepted & accepted, ..told }
    }
}
