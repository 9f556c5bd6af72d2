//! Laws of the environments of one axis, in straight `f64`.

use std::f64::consts::TAU;

use lyapunov::{
    Dissipation, HeldTick, LyapunovCandidate, OnePort, PortSample, Scalar,
    bodies::Impedance,
    environments::{
        HuntCrossley, LayeredWall, MassSpringDamper, MovingWall, Spring, VaryingSpring, Wall,
    },
};

use crate::support::{Bits, log_between, unit};

/// Parameters of the environments.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parts<T> {
    pub(crate) position: T,
    pub(crate) stiffness: [T; 2],
    pub(crate) damping: T,
    pub(crate) depth: T,
    pub(crate) exponent: T,
    pub(crate) mass: T,
    pub(crate) amplitude: T,
    pub(crate) frequency: T,
    pub(crate) rate: T,
}

/// A number for each lane, the first lane being `first`.
pub(crate) fn each<T: Scalar>(bits: Bits, first: usize, of: impl Fn(Bits) -> f64) -> T {
    let mixed = |lane: usize| {
        let spread = (lane as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let mixed = (bits ^ spread).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        (mixed ^ mixed >> 29).wrapping_mul(0x94d0_49bb_1331_11eb)
    };
    T::from_lanes(|lane| of(mixed(first + lane)))
}

impl<T: Scalar> Parts<T> {
    pub(crate) fn of(bits: &[Bits; 16], first: usize) -> Self {
        let log = |which: usize, least: f64, most: f64| {
            each(bits[which], first, |bits| log_between(bits, least, most))
        };
        Self {
            position: each(bits[0], first, |bits| unit(bits) - 0.5),
            stiffness: [log(1, 10.0, 1e5), log(2, 10.0, 1e5)],
            damping: log(3, 1e-2, 50.0),
            depth: log(4, 1e-4, 1e-2),
            exponent: log(5, 0.5, 4.0),
            mass: log(6, 1e-3, 1.0),
            amplitude: log(7, 1e-5, 1e-2),
            frequency: log(8, 1e-2, 100.0),
            rate: log(9, 50.0, 1e4),
        }
    }

    /// A motion near the surface, in and out of contact.
    pub(crate) fn sample(&self, bits: [Bits; 2], first: usize) -> PortSample<T> {
        let [x, v] = bits;
        let position = self.position + each(x, first, |bits| 0.02 * (unit(bits) - 0.5));
        let velocity = each(v, first, |bits| 4.0 * (unit(bits) - 0.5));
        let period = T::of(1.0) / self.rate;
        HeldTick {
            period,
            position,
            velocity,
            displacement: velocity * period,
            applied: T::of(0.0),
        }
        .sample()
    }

    pub(crate) fn widened(&self) -> Parts<f64> {
        let [first, second] = self.stiffness;
        Parts {
            position: self.position.lane(0),
            stiffness: [first.lane(0), second.lane(0)],
            damping: self.damping.lane(0),
            depth: self.depth.lane(0),
            exponent: self.exponent.lane(0),
            mass: self.mass.lane(0),
            amplitude: self.amplitude.lane(0),
            frequency: self.frequency.lane(0),
            rate: self.rate.lane(0),
        }
    }
}

/// One reading: number of the call, position, velocity, velocity at the call before, and the time since then.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    pub(crate) call: u32,
    pub(crate) x: f64,
    pub(crate) v: f64,
    pub(crate) before: f64,
    pub(crate) period: f64,
}

/// Force and credit, each with the sum of the magnitudes that it is rounded from.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Answer {
    pub(crate) force: [f64; 2],
    pub(crate) credit: [f64; 2],
    /// The depth, and the magnitudes in it: within their rounding, contact is undecided.
    pub(crate) depth: [f64; 2],
}

/// An environment of one axis.
pub(crate) trait Environment {
    /// The port and the credit of its own damper.
    fn build<T: Scalar>(parts: Parts<T>) -> (impl OnePort<T>, impl LyapunovCandidate<T>);

    fn law(parts: &Parts<f64>, reading: Sample) -> Answer;
}

fn nothing<T: Scalar>() -> impl LyapunovCandidate<T> {
    Dissipation::of(T::of(0.0)).expect("no damping")
}

/// A one-sided environment that dissipates `burnt` in contact.
fn pushing(depth: f64, force: [f64; 2], burnt: f64, size: f64) -> Answer {
    let [force, force_size] = force;
    let contact = depth > 0.0;
    Answer {
        force: [if contact { f64::max(0.0, force) } else { 0.0 }, force_size],
        credit: [if contact { burnt } else { 0.0 }, size],
        depth: [depth, 0.0],
    }
}

/// The wall of the contract.
pub(crate) struct Plain;

impl Environment for Plain {
    fn build<T: Scalar>(parts: Parts<T>) -> (impl OnePort<T>, impl LyapunovCandidate<T>) {
        let wall = Wall::new(parts.stiffness[0], parts.damping).expect("a wall");
        let wall = wall.at(parts.position);
        (wall, wall.dissipation())
    }

    fn law(parts: &Parts<f64>, Sample { x, v, period, .. }: Sample) -> Answer {
        let (k, b, p) = (parts.stiffness[0], parts.damping, x - parts.position);
        let burnt = b * v * v * period;
        pushing(p, [k * p + b * v, k * p.abs() + b * v.abs()], burnt, burnt)
    }
}

pub(crate) struct Layered;

impl Environment for Layered {
    fn build<T: Scalar>(parts: Parts<T>) -> (impl OnePort<T>, impl LyapunovCandidate<T>) {
        let wall = LayeredWall::new(parts.depth, parts.stiffness, parts.damping);
        let wall = wall.expect("a layered wall").at(parts.position);
        (wall, wall.dissipation())
    }

    fn law(parts: &Parts<f64>, Sample { x, v, period, .. }: Sample) -> Answer {
        let ([k1, k2], b, p) = (parts.stiffness, parts.damping, x - parts.position);
        // The area under the stiffness over the depth.
        let spring = k1 * p.min(parts.depth) + k2 * (p - parts.depth).max(0.0);
        let size = k1 * parts.depth + (k1 + k2) * p.abs() + b * v.abs();
        pushing(p, [spring + b * v, size], b * v * v * period, b * v * v * period)
    }
}

pub(crate) struct Hunt;

impl Environment for Hunt {
    fn build<T: Scalar>(parts: Parts<T>) -> (impl OnePort<T>, impl LyapunovCandidate<T>) {
        let contact = HuntCrossley::new(parts.stiffness[0], parts.exponent, parts.damping);
        let contact = contact.expect("a contact").at(parts.position);
        (contact, contact.dissipation())
    }

    fn law(parts: &Parts<f64>, Sample { x, v, period, .. }: Sample) -> Answer {
        let (p, d, e) = (x - parts.position, parts.damping, parts.exponent);
        let spring = parts.stiffness[0] * (e * p.abs().ln()).exp();
        // A power passes on the rounding of its base and of its own logarithm.
        let wider = 1.0 + e + (e * p.abs().ln()).abs();
        let size = spring * (1.0 + d * v.abs()) * wider;
        let burnt = spring * d * v * v * period;
        pushing(p, [spring * (1.0 + d * v), size], burnt, burnt * wider)
    }
}

pub(crate) struct Moving;

impl Environment for Moving {
    fn build<T: Scalar>(parts: Parts<T>) -> (impl OnePort<T>, impl LyapunovCandidate<T>) {
        let wall = Wall::new(parts.stiffness[0], parts.damping).expect("a wall");
        let wall = wall.at(parts.position);
        let moving = MovingWall::new(wall, parts.amplitude, parts.frequency, parts.rate);
        let moving = moving.expect("a moving wall");
        (moving, moving.dissipation(parts.rate).expect("its damper"))
    }

    fn law(parts: &Parts<f64>, reading: Sample) -> Answer {
        let (k, b, a) = (parts.stiffness[0], parts.damping, parts.amplitude);
        let phase = TAU * (parts.frequency * (f64::from(reading.call) / parts.rate));
        let speed = TAU * parts.frequency * a;
        let p = reading.x - (parts.position + a * phase.sin());
        let v = reading.v - speed * phase.cos();
        let whole = reading.x.abs() + parts.position.abs() + a;
        let fast = reading.v.abs() + speed;
        let burnt = b * v * v * reading.period;
        let force = [k * p + b * v, k * whole + b * fast];
        let answer = pushing(p, force, burnt, b * fast * fast * reading.period);
        Answer { depth: [p, whole], ..answer }
    }
}

pub(crate) struct Varying;

impl Environment for Varying {
    fn build<T: Scalar>(parts: Parts<T>) -> (impl OnePort<T>, impl LyapunovCandidate<T>) {
        let spring = Spring::new(parts.stiffness[0]).expect("a spring").at(parts.position);
        let spring = VaryingSpring::new(spring, parts.stiffness[1], parts.frequency, parts.rate);
        (spring.expect("a varying spring"), nothing())
    }

    fn law(parts: &Parts<f64>, reading: Sample) -> Answer {
        let ([k, a], p) = (parts.stiffness, reading.x - parts.position);
        let phase = TAU * (parts.frequency * (f64::from(reading.call) / parts.rate));
        let size = (k + a) * p.abs();
        Answer { force: [(k + a * phase.sin()) * p, size], credit: [0.0, 0.0], depth: [1.0, 0.0] }
    }
}

/// The mass-spring-damper, passive or with a damping below 0.
pub(crate) struct Example2<const ACTIVE: bool>;

impl<const ACTIVE: bool> Environment for Example2<ACTIVE> {
    fn build<T: Scalar>(parts: Parts<T>) -> (impl OnePort<T>, impl LyapunovCandidate<T>) {
        let Parts { mass, damping, stiffness: [stiffness, _], .. } = parts;
        let damping = if ACTIVE { -damping } else { damping };
        let port = MassSpringDamper::new(Impedance { mass, damping, stiffness });
        let port = port.expect("a mass-spring-damper").at(parts.position);
        (port, port.dissipation())
    }

    fn law(parts: &Parts<f64>, reading: Sample) -> Answer {
        let Sample { x, v, before, period, .. } = reading;
        let (p, k, m) = (x - parts.position, parts.stiffness[0], parts.mass);
        let b = if ACTIVE { -parts.damping } else { parts.damping };
        let size = m * (v.abs() + before.abs()) / period + parts.damping * v.abs() + k * p.abs();
        let burnt = if ACTIVE { 0.0 } else { b * v * v * period };
        Answer {
            force: [m * (v - before) / period + b * v + k * p, size],
            credit: [burnt, burnt],
            depth: [1.0, 0.0],
        }
    }
}
