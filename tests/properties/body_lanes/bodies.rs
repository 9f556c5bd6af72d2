//! Bodies with friction and jitter, of one number or of lanes.

use lyapunov::effects::{Random, Source};
use lyapunov::{
    ParameterError, Plant, Scalar,
    bodies::{
        Body, DampedMass, ElasticJoint, Friction, Impedance, Jitter, Linear, OperatedBody,
        PlantExt, Stribeck, Transition, TwoMassBody, TwoMassParts,
    },
};

use super::lane::Lane;

/// A body that tells of one lane, besides its sample, its heat and transitions.
pub(super) trait Told<T: Scalar>: Plant<T> {
    fn told(&self, lane: usize) -> (f64, Vec<(f64, Transition)>);
}

impl<T: Scalar, B: Linear<T, S>, const S: usize> Told<T> for Friction<B, T, S> {
    fn told(&self, lane: usize) -> (f64, Vec<(f64, Transition)>) {
        (self.heat().lane(lane), self.transitions().last(lane).collect())
    }
}

impl<T: Scalar, B: OperatedBody<T>, G: FnMut() -> T> Told<T> for Jitter<B, B::Parts, T, G> {
    fn told(&self, _lane: usize) -> (f64, Vec<(f64, Transition)>) {
        (0.0, Vec::new())
    }
}

pub(super) type Made<T> = Result<Box<dyn Told<T>>, ParameterError>;

/// The numbers of all lanes.
fn each<T: Scalar>(lanes: &[Lane], number: impl Fn(&Lane) -> f64) -> T {
    T::from_lanes(|lane| number(&lanes[lane]))
}

fn law<T: Scalar>(lanes: &[Lane]) -> Stribeck<T> {
    let [coulomb, breakaway, stribeck_velocity] = [0, 1, 2].map(|at| each(lanes, |it| it.law[at]));
    Stribeck { coulomb, breakaway, stribeck_velocity }
}

fn impedance<T: Scalar>(lanes: &[Lane]) -> Impedance<T> {
    let [mass, damping, stiffness] = [0, 1, 2].map(|at| each(lanes, |it| it.body[at]));
    Impedance { mass, damping, stiffness }
}

fn two_masses<T: Scalar>(lanes: &[Lane]) -> TwoMassParts<T> {
    let of = |at: usize| each::<T>(lanes, |it| it.link[at]);
    TwoMassParts {
        operator: impedance(lanes),
        device: DampedMass { mass: of(0), damping: of(1) },
        link: ElasticJoint { stiffness: of(2), damping: of(3) },
    }
}

fn block<T: Scalar>(lanes: &[Lane]) -> Result<Body<T>, ParameterError> {
    let [position, velocity] = [0, 1].map(|at| each(lanes, |it| it.start[at]));
    Ok(Body::new(impedance(lanes), each(lanes, |it| it.period))?.starting(position, velocity))
}

fn pair<T: Scalar>(lanes: &[Lane]) -> Result<TwoMassBody<T>, ParameterError> {
    let [position, velocity] = [0, 1].map(|at| each(lanes, |it| it.start[at]));
    let period = each(lanes, |it| it.period);
    Ok(TwoMassBody::new(two_masses(lanes), period)?.starting(position, velocity))
}

pub(super) fn rubbed_block<T: Scalar>(lanes: &[Lane]) -> Made<T> {
    Ok(Box::new(Friction::new(block(lanes)?, impedance(lanes), law(lanes))?))
}

pub(super) fn rubbed_pair<T: Scalar>(lanes: &[Lane]) -> Made<T> {
    Ok(Box::new(Friction::new(pair(lanes)?, two_masses(lanes), law(lanes))?))
}

fn jittered<T, B>(body: B, parts: B::Parts, lanes: &[Lane]) -> Made<T>
where
    T: Scalar + 'static,
    B: OperatedBody<T, Parts: 'static> + 'static,
{
    let seeds: Vec<u64> = lanes.iter().map(|lane| lane.push.seed).collect();
    let mut random = Random::new(|lane| seeds[lane], Source::Jitter);
    let deviation = each(lanes, |it| it.deviation);
    Ok(Box::new(body.jittered(parts, deviation, move || random.normal())?))
}

pub(super) fn jittered_block<T: Scalar + 'static>(lanes: &[Lane]) -> Made<T> {
    jittered(block(lanes)?, impedance(lanes), lanes)
}

pub(super) fn jittered_pair<T: Scalar + 'static>(lanes: &[Lane]) -> Made<T> {
    jittered(pair(lanes)?, two_masses(lanes), lanes)
}

pub(super) fn both_on_a_block<T: Scalar + 'static>(lanes: &[Lane]) -> Made<T> {
    let body = Friction::new(block(lanes)?, impedance(lanes), law(lanes))?;
    jittered(body, impedance(lanes), lanes)
}

pub(super) fn both_on_a_pair<T: Scalar + 'static>(lanes: &[Lane]) -> Made<T> {
    let body = Friction::new(pair(lanes)?, two_masses(lanes), law(lanes))?;
    jittered(body, two_masses(lanes), lanes)
}
