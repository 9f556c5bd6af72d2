//! Energy balance by cause: the stored energy is what came in by the port, the external forces, the moving rest and the
//! changing grip, less what each damper dissipated.

use lyapunov::{
    Plant, PortSample,
    bodies::{
        Body, DampedMass, ElasticJoint, Impedance, OperatedBody, PlantExt, TwoMassBody,
        TwoMassParts,
    },
    trajectories::{Constant, Pulse, Samples, Trajectory},
};

use crate::support::quadrature;

const RATE: f64 = 1000.0;

/// A body whose energies follow from its sample.
trait Told: OperatedBody<f64> + Copy {
    /// The operator's position, and the stiffness of its spring.
    fn held(&self, sample: &PortSample<f64>, parts: Self::Parts) -> (f64, f64);

    /// Kinetic energy and that of the link, J.
    fn stored(&self, sample: &PortSample<f64>, parts: Self::Parts) -> f64;

    /// The power that each damper dissipates now, W.
    fn burning(&self, sample: &PortSample<f64>, parts: Self::Parts) -> [f64; 3];
}

impl Told for Body<f64> {
    fn held(&self, sample: &PortSample<f64>, parts: Self::Parts) -> (f64, f64) {
        (sample.position, parts.stiffness)
    }

    fn stored(&self, sample: &PortSample<f64>, parts: Self::Parts) -> f64 {
        parts.mass * sample.velocity.powi(2) / 2.0
    }

    fn burning(&self, sample: &PortSample<f64>, parts: Self::Parts) -> [f64; 3] {
        [parts.damping * sample.velocity.powi(2), 0.0, 0.0]
    }
}

impl Told for TwoMassBody<f64> {
    fn held(&self, _drive: &PortSample<f64>, parts: Self::Parts) -> (f64, f64) {
        (self.operator().0, parts.operator.stiffness)
    }

    fn stored(&self, sample: &PortSample<f64>, parts: Self::Parts) -> f64 {
        let TwoMassParts { operator, device, link } = parts;
        let (position, velocity) = self.operator();
        operator.mass * velocity.powi(2) / 2.0
            + device.mass * sample.velocity.powi(2) / 2.0
            + link.stiffness * (position - sample.position).powi(2) / 2.0
    }

    fn burning(&self, sample: &PortSample<f64>, parts: Self::Parts) -> [f64; 3] {
        let (_, velocity) = self.operator();
        [
            parts.operator.damping * velocity.powi(2),
            parts.device.damping * sample.velocity.powi(2),
            parts.link.damping * (velocity - sample.velocity).powi(2),
        ]
    }
}

/// A wall with an additional force on each tick: the law of the port does not matter here.
fn effort(tick: u64, position: f64) -> f64 {
    400.0 * (position - 0.01).max(0.0) + 0.3 * ((tick * 7 % 5) as f64 - 2.0)
}

fn at(trajectory: &impl Trajectory<f64>, tick: u64) -> f64 {
    trajectory.at(tick)
}

/// The energy of one cause, and the sum of its magnitudes.
#[derive(Default)]
struct Book {
    energy: f64,
    size: f64,
}

impl Book {
    fn enter(&mut self, joules: f64) {
        self.energy += joules;
        self.size += joules.abs();
    }
}

/// Runs `body` in the whole chain and, beside it, the same by hand, tick by tick, with its energies.
fn closes<B: Told>(body: B, own: B::Parts, grips: [(u64, B::Parts); 2]) {
    let rows = [(0.0, 0.002), (0.1, 0.02), (0.25, -0.01), (0.5, 0.005)];
    let hand = Samples::new(rows, RATE).expect("a hand");
    let load = Constant::new(-0.7).expect("a load");
    let pulse = Pulse::new(6.0, 0.05, 0.02, RATE).expect("a pulse");
    let mut chain =
        body.led_by(hand).gripped(own, grips).expect("a grip").pushed(load).pushed(pulse);
    let (mut plain, mut parts) = (body, own);
    let mut sample = chain.start();
    let mut rest = 0.002;
    let spring = |plain: &B, sample: &PortSample<f64>, parts, rest: f64| {
        let (position, stiffness) = plain.held(sample, parts);
        stiffness * (position - rest).powi(2) / 2.0
    };
    let first = plain.stored(&sample, parts) + spring(&plain, &sample, parts, rest);
    let [mut port, mut pushes, mut moved, mut gripped, mut burnt] =
        [(); 5].map(|()| Book::default());
    let nodes = quadrature(1.0 / RATE);
    for tick in 0..600u64 {
        let before = spring(&plain, &sample, parts, rest);
        if let Some((_, changed)) = grips.iter().find(|(at, _)| *at == tick) {
            parts = *changed;
            plain.reshape(parts, 1.0 / RATE).expect("a grip");
        }
        gripped.enter(spring(&plain, &sample, parts, rest) - before);
        let before = spring(&plain, &sample, parts, rest);
        rest = at(&hand, tick);
        plain.rest_at(rest);
        moved.enter(spring(&plain, &sample, parts, rest) - before);

        let force = effort(tick, sample.position);
        let [loaded, pulsed] = [at(&load, tick), at(&pulse, tick)];
        let applied = force - pulsed - loaded;
        for (interval, weight) in &nodes {
            let mut within = plain;
            within.reshape(parts, *interval).expect("a part of a tick");
            let sample = within.advance(applied);
            within
                .burning(&sample, parts)
                .into_iter()
                .for_each(|watts| burnt.enter(watts * weight));
        }
        let told = plain.advance(applied);
        sample = chain.advance(force);
        assert_eq!((sample.position, sample.velocity), (told.position, told.velocity), "{tick}");
        assert_eq!(sample.work, force * sample.displacement);
        port.enter(sample.work);
        pushes.enter((loaded + pulsed) * sample.displacement);

        let stored = plain.stored(&sample, parts) + spring(&plain, &sample, parts, rest);
        let came = first - port.energy + pushes.energy + moved.energy + gripped.energy;
        let size =
            first + stored + port.size + pushes.size + moved.size + gripped.size + burnt.size;
        let off = (came - burnt.energy - stored).abs();
        assert!(off <= 1e-12 * size, "{off:e} of {size:e} J at {tick}");
    }
    for (cause, book) in
        [("port", port), ("pushes", pushes), ("rest", moved), ("grip", gripped), ("heat", burnt)]
    {
        assert!(book.size > 1e-5, "{cause} did next to nothing: {:e} J", book.size);
    }
}

#[test]
fn the_energy_of_one_mass_balances() {
    let parts = |damping, stiffness| Impedance { mass: 0.3, damping, stiffness };
    let own = parts(0.2, 50.0);
    let body = Body::new(own, 1.0 / RATE).expect("a body").resting_at(0.002).starting(-0.004, 0.1);
    closes(body, own, [(120, parts(2.0, 400.0)), (300, parts(0.0, 20.0))]);
}

#[test]
fn the_energy_of_two_masses_balances() {
    for (mass, stiffness, damping) in [(0.2, 5000.0, 1.0), (0.01, 2e4, 0.0), (5.0, 1e5, 3.0)] {
        let parts = |hold, spring| TwoMassParts {
            operator: Impedance { mass: 0.1, damping: hold, stiffness: spring },
            device: DampedMass { mass, damping: 0.05 },
            link: ElasticJoint { stiffness, damping },
        };
        let own = parts(0.2, 50.0);
        let plant = TwoMassBody::new(own, 1.0 / RATE).expect("two masses");
        let plant = plant.resting_at(0.002).starting(-0.004, 0.1);
        closes(plant, own, [(120, parts(2.0, 400.0)), (300, parts(0.0, 20.0))]);
    }
}
