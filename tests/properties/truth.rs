//! Held work against the energy that really crossed the port: `∫ f(t) v(t) dt` over the motion between the ticks.

use proptest::array::uniform16;
use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::TestCaseResult;

use lyapunov::{
    DampingLimit, Lolc, Observer, OnePort, Plant, PortEnergy, PortSample, Scalar,
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::{MassSpringDamper, Spring, Wall},
};

use crate::support::{
    Bits, Motion, Port, Real, State, hold, log_between, ordinary, runge_kutta, unit,
};

const TICKS: usize = 100;

/// A loop: its body, and where it starts.
struct Loop<V: Port> {
    motion: Motion,
    period: V::Scalar,
    rest: V,
    start: V,
    velocity: V,
}

impl<V: Port> Loop<V> {
    fn from(bits: &[Bits; 16]) -> Self {
        let of = V::Scalar::of;
        let size = |bits, least, most| of(log_between(bits, least, most)).f64();
        let (mass, stiffness) = (size(bits[0], 0.1, 2.0), size(bits[1], 20.0, 500.0));
        let damping = of(2.0 * unit(bits[2])).f64();
        Self {
            motion: Motion { mass, damping, stiffness, rest: 0.0 },
            period: of(log_between(bits[3], 2e-3, 1e-2)),
            rest: V::from_axes(|_| ordinary(bits[4], 1e-3)),
            start: V::from_axes(|axis| ordinary(bits[5 + axis], 5e-3)),
            velocity: V::from_axes(|axis| ordinary(bits[8 + axis], 0.2)),
        }
    }

    fn body(&self) -> Body<V> {
        let Motion { mass, damping, stiffness, .. } = self.motion;
        let [mass, damping, stiffness] = [mass, damping, stiffness].map(V::Scalar::of);
        Body::new(Impedance { mass, damping, stiffness }, self.period)
            .expect("a body")
            .resting_at(self.rest)
            .starting(self.start, self.velocity)
    }

    fn limit(&self) -> DampingLimit<V::Scalar> {
        let of = V::Scalar::of;
        DampingLimit::of_mass(of(0.5), of(self.motion.mass), self.period).expect("a limit")
    }

    fn begin(&self, axis: usize) -> (Motion, State) {
        let (position, velocity) = (self.start.axis(axis).f64(), self.velocity.axis(axis).f64());
        (Motion { rest: self.rest.axis(axis).f64(), ..self.motion }, State { position, velocity })
    }

    /// Runs the loop closed by `port`: for each tick the effort that then applied, the sample, and the observed energy
    /// inside of saturation and delay.
    fn run(&self, mut port: impl OnePort<V>) -> Vec<(V, PortSample<V>, V::Scalar)> {
        let (mut plant, mut sample) = (self.body(), self.body().start());
        (0..TICKS)
            .map(|_| {
                let effort = port.respond(&sample);
                let seen = (effort, sample, port.correction().observed_energy);
                sample = plant.advance(effort);
                seen
            })
            .collect()
    }

    /// The work of the recorded efforts up to each tick over the motion that they cause, and the sum of magnitudes:
    /// only the efforts come from the run.
    fn true_work(&self, run: &[(V, PortSample<V>, V::Scalar)]) -> Vec<(f64, f64)> {
        let period = self.period.f64();
        let nodes = self.motion.nodes(period);
        let whole = self.motion.over(period);
        let mut sums = vec![(0.0, 0.0); run.len()];
        for axis in 0..V::AXES {
            let (motion, mut state) = self.begin(axis);
            let (mut work, mut size) = (0.0, 0.0);
            for (tick, (effort, ..)) in run.iter().enumerate() {
                sums[tick].0 += work;
                sums[tick].1 += size;
                let effort = effort.axis(axis).f64();
                let now: f64 = nodes
                    .iter()
                    .map(|(gain, weight)| {
                        weight * effort * gain.step(&motion, state, effort).velocity
                    })
                    .sum();
                work += now;
                size += now.abs();
                state = whole.step(&motion, state, effort);
            }
        }
        sums
    }
}

/// The observer at the plant and the one inside both report the true work.
fn is_true<V: Port>(run: &[(V, PortSample<V>, V::Scalar)], truth: &[(f64, f64)]) -> TestCaseResult {
    let share = if V::Scalar::unit() < 1e-10 { 1e-10 } else { 1e-5 };
    let mut observer = Observer::of(PortEnergy);
    let mut rounding = 0.0;
    for ((effort, sample, inside), (work, size)) in run.iter().zip(truth) {
        // Both ends of a displacement are rounded positions.
        let ends =
            sample.applied.times(sample.position).axes().map(|fx| fx.f64().abs()).sum::<f64>();
        rounding += 2.0 * V::Scalar::unit() * ends;
        let sum: V::Scalar = observer.observe(sample, *effort);
        for sum in [sum.f64(), inside.f64()] {
            let off = (sum - work).abs();
            let bound = share * size + rounding;
            prop_assert!(off <= bound, "{sum:e} J instead of {work:e} of {size:e}");
        }
    }
    let applied = run.iter().any(|(effort, ..)| effort.axes().any(|f| f.f64() != 0.0));
    prop_assert!(applied, "nothing applied");
    Ok(())
}

/// Hold, stabilizer, saturation, delay and velocity by `bits`, around `environment`.
fn closed<V: Port>(
    bits: &[Bits; 16],
    looped: &Loop<V>,
    environment: impl OnePort<V>,
) -> Vec<(V, PortSample<V>, V::Scalar)> {
    let force = V::Scalar::of(log_between(bits[12], 0.3, 30.0));
    let port = environment
        .held(1 + (bits[13] % 4) as u32)
        .expect("a hold")
        .stabilized(Lolc::new(PortEnergy, looped.limit()))
        .saturated(force)
        .expect("a saturation")
        .delayed::<3>((bits[14] % 4) as u32)
        .expect("a delay");
    if bits[15] & 1 == 0 { looped.run(port) } else { looped.run(port.differenced()) }
}

mod check {
    use super::*;
    use crate::support::CASES;

    pub(super) fn of_a_spring<V: Port>() {
        hold(CASES, uniform16(any::<Bits>()), |bits| {
            let looped = Loop::<V>::from(&bits);
            let stiffness = V::Scalar::of(log_between(bits[11], 100.0, 5000.0));
            let run = closed(&bits, &looped, Spring::new(stiffness).expect("a spring"));
            is_true(&run, &looped.true_work(&run))
        });
    }

    pub(super) fn of_a_mass_spring_damper<V: Port>() {
        hold(CASES, uniform16(any::<Bits>()), |bits| {
            let looped = Loop::<V>::from(&bits);
            let of = |value: f64| V::Scalar::of(value);
            let impedance = Impedance {
                mass: of(0.2 * looped.motion.mass * unit(bits[10])),
                damping: of(2.0 * unit(bits[9])),
                stiffness: of(log_between(bits[11], 100.0, 5000.0)),
            };
            let run = closed(&bits, &looped, MassSpringDamper::new(impedance).expect("one"));
            is_true(&run, &looped.true_work(&run))
        });
    }
}

crate::support::every_port!(of_a_spring, of_a_mass_spring_damper);

mod walls {
    use super::*;
    use crate::support::CASES;

    fn wall<T: Port<Scalar = T> + Real>(bits: &[Bits; 16]) -> Wall<T> {
        let (stiffness, damping) = (log_between(bits[11], 500.0, 2e4), 4.0 * unit(bits[10]));
        let wall = Wall::new(T::of(stiffness), T::of(damping)).expect("a wall");
        // Deep enough in contact to push from the start, however fast the mass recedes.
        wall.at(Loop::<T>::from(bits).start - T::of(2e-3))
    }

    fn check<T: Port<Scalar = T> + Real>() {
        hold(CASES, uniform16(any::<Bits>()), |bits| {
            let looped = Loop::<T>::from(&bits);
            let run = closed(&bits, &looped, wall(&bits));
            is_true(&run, &looped.true_work(&run))
        });
    }

    #[test]
    fn f32() {
        check::<f32>();
    }

    #[test]
    fn f64() {
        check::<f64>();
    }

    /// The same truth by a method without a closed form, on fewer loops.
    #[test]
    fn by_runge_kutta() {
        hold(100, uniform16(any::<Bits>()), |bits| {
            let looped = Loop::<f64>::from(&bits);
            let run = closed(&bits, &looped, wall(&bits));
            let (motion, mut state) = looped.begin(0);
            let (mut truth, mut work, mut size) = (Vec::new(), 0.0, 0.0);
            for (effort, ..) in &run {
                truth.push((work, size));
                let now;
                (state, now, _) = runge_kutta(&motion, state, *effort, looped.period, 200);
                work += now;
                size += now.abs();
            }
            is_true(&run, &truth)
        });
    }

    /// An encoder hides less than its resolution times the effort on each tick.
    fn with_an_encoder<T: Port<Scalar = T> + Real>() {
        hold(CASES, uniform16(any::<Bits>()), |bits| {
            let looped = Loop::<T>::from(&bits);
            let resolution = T::of(log_between(bits[12], 1e-6, 1e-3));
            let port = wall::<T>(&bits)
                .stabilized(Lolc::new(PortEnergy, looped.limit()))
                .delayed::<3>((bits[14] % 4) as u32)
                .expect("a delay")
                .differenced()
                .encoded(resolution)
                .expect("an encoder");
            let run = looped.run(port);
            let rounding = if T::unit() < 1e-10 { 1e-10 } else { 1e-5 };
            let mut hidden = 0.0;
            for ((effort, _, sum), (work, size)) in run.iter().zip(looped.true_work(&run)) {
                let off = (sum.f64() - work).abs();
                prop_assert!(off <= hidden + rounding * size, "off by {off:e} of {hidden:e}");
                hidden += effort.f64().abs() * resolution.f64();
            }
            Ok(())
        });
    }

    #[test]
    fn with_an_encoder_f32() {
        with_an_encoder::<f32>();
    }

    #[test]
    fn with_an_encoder_f64() {
        with_an_encoder::<f64>();
    }
}
