//! A stabilizer and a candidate of your own, generic over scalars, vectors and lanes; docs/own-stabilizer.md goes through them.

use lyapunov::{
    Correction, DampingLimit, Held, LyapunovCandidate, Observer, OnePort, ParameterError, Plant,
    PortEnergy, PortSample, Requirement, Scalar, Signal, Stabilizer,
    accumulators::Plain,
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::Wall,
    lanes::AutoF64x4,
    laws::{self, Samples},
};
use nalgebra::Vector3;

/// The port's energy, credited with what dry friction on every axis must have dissipated: `−ΔV = Σ fᵢ Δxᵢ + F |Δxᵢ|`.
///
/// The path between two samples is at least `|Δx|` long, so the credit is a lower bound as long as each axis has at least
/// this friction.
#[derive(Clone, Copy, Debug)]
pub struct DryFriction<T> {
    force: T,
}

impl<T: Scalar> DryFriction<T> {
    /// The credit of a friction of `force` N.
    ///
    /// # Errors
    /// `force` below 0, infinite or NaN.
    pub fn of(force: T) -> Result<Self, ParameterError> {
        Ok(Self { force: Requirement::NonNegative.check("friction", force)? })
    }
}

impl<V: Signal> LyapunovCandidate<V> for DryFriction<V::Scalar> {
    fn decrease(&mut self, sample: &PortSample<V>) -> V::Scalar {
        let path = sample.displacement.map(Scalar::magnitude).sum();
        let credit = self.force * path;
        let sound = credit.finite();
        sample.work.sum() + V::Scalar::choose(sound, credit, V::Scalar::of(0.0))
    }
}

/// Stabilizer that pays a debt only while the environment pushes along with the motion, so that free motion and the way in
/// never feel it: `α = min(−L / (v² T), limit)` where `L < 0` and `f · v < 0`, else 0.
#[derive(Clone, Copy, Debug)]
pub struct WhileGiving<T, C> {
    observer: Observer<C, Held, Plain<T>>,
    limit: DampingLimit<T>,
}

impl<T: Scalar, C> WhileGiving<T, C> {
    /// The stabilizer that watches `candidate` and injects at most `limit`.
    pub fn new(candidate: C, limit: DampingLimit<T>) -> Self {
        Self { observer: Observer::of(candidate), limit }
    }
}

impl<V: Signal, C: LyapunovCandidate<V>> Stabilizer<V> for WhileGiving<V::Scalar, C> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let (zero, tiny) = (V::Scalar::of(0.0), V::Scalar::smallest_normal());
        let sum = self.observer.observe(sample, effort);
        let square = sample.velocity.inner(sample.velocity) * sample.period;

        // Rejected is what makes a number of this step that is not finite, in that lane only.
        let sound = sample.sound() & effort.finite() & square.finite();
        let velocity = V::choose(sound, sample.velocity, V::zero());
        let effort = V::choose(sound, effort, V::zero());
        let square = V::Scalar::choose(sound, square, zero);

        let debt = (-sum).larger(zero);
        let giving = effort.inner(velocity).below(zero);
        let moving = square.above(tiny);
        // A select computes both sides: the divisor is sound also where the quotient is not chosen.
        let wanted = (debt / square.larger(tiny)).smaller(self.limit.most());
        let alpha = V::Scalar::choose(giving & moving, wanted, zero);

        Correction {
            effort: effort + velocity.scale(alpha),
            observed_energy: sum,
            alpha,
            shortfall: (debt - alpha * square).larger(zero),
            accepted: sound,
        }
        .checked()
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    keeps_the_laws::<f64>()?;
    keeps_the_laws::<f32>()?;
    keeps_the_laws::<Vector3<f64>>()?;
    keeps_the_laws::<AutoF64x4>()?;
    keeps_the_laws::<Vector3<AutoF64x4>>()?;
    println!("both keep the laws on scalars, vectors and lanes\n");

    println!("largest swing in each half second, mm");
    for (name, cap) in [("only observed", 0.0), ("stabilized", 0.5)] {
        print!("{name:14}");
        for swing in swings(cap)? {
            print!("{:9.3}", 1e3 * swing);
        }
        println!();
    }
    Ok(())
}

/// Checks both over the samples that ship.
fn keeps_the_laws<V: Signal>() -> Result<(), Box<dyn std::error::Error>> {
    let of = V::Scalar::of;
    let limit = DampingLimit::of_mass(of(0.5), of(0.2), of(1e-3))?;
    let candidate = DryFriction::of(of(0.02))?;
    let stabilizer = WhileGiving::new(candidate, limit);
    let samples = Samples::<V>::new(of(1e-3));
    laws::candidate(&candidate, samples)?;
    laws::stabilizer(&stabilizer, samples)?;
    laws::ledger(&stabilizer, &candidate, limit.most(), samples)?;
    Ok(())
}

/// Two seconds of a hand on a wall that responds at 100 Hz under 1 kHz.
fn swings(cap: f64) -> Result<[f64; 4], ParameterError> {
    let (period, mass) = (1e-3, 0.3);
    let hand = Impedance { mass, damping: 0.2, stiffness: 50.0 };
    let mut body = Body::new(hand, period)?.starting(-0.004, 0.0);
    let stabilizer = WhileGiving::new(PortEnergy, DampingLimit::of_mass(cap, mass, period)?);
    let mut port = Wall::new(8000.0, 2.0)?.held(10)?.stabilized(stabilizer).differenced();
    let (mut sample, mut swings) = (body.start(), [0.0_f64; 4]);
    for tick in 0..2000 {
        sample = body.advance(port.respond(&sample));
        swings[tick / 500] = swings[tick / 500].max(sample.position.magnitude());
    }
    Ok(swings)
}
