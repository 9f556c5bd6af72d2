//! Rollouts on lanes, with parameters of their own in each lane: each lane equals its scalar run bit for bit.

use nalgebra::SVector;
use proptest::array::uniform32;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::lanes::{AutoF32x4, AutoF32x8, AutoF64x4, AutoF64x8, WideF32x8, WideF64x4};
use lyapunov::{
    DampingLimit, Dissipation, Lolc, LyapunovCandidate, Mask, OnePort, Plant, PortEnergy, Scalar,
    Signal, Stabilizer,
    accumulators::{Accumulator, Compensated, Plain, Wide},
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::{MassSpringDamper, Wall},
};

use crate::support::{Bits, CASES, Faulty, Real, hold, log_between, same, unit};

const TICKS: usize = 30;

/// The parameters of up to eight rollouts, and their common ones.
struct Parameters {
    bits: [Bits; 32],
}

impl Parameters {
    /// A number that differs from lane to lane.
    fn each<T: Scalar>(&self, first: usize, which: usize, least: f64, most: f64) -> T {
        let bits = |lane: usize| {
            let spread = (lane as u64 + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
            (self.bits[which] ^ spread).wrapping_mul(0xbf58_476d_1ce4_e5b9)
        };
        T::from_lanes(|lane| log_between(bits(first + lane), least, most))
    }

    /// The calls from which and until which efforts are NaN, in some lanes.
    fn fault<T: Scalar>(&self, first: usize) -> (T, T) {
        let faulty = |lane: usize| self.bits[31] >> lane & 1 == 1;
        let from = |lane: usize| if faulty(lane) { 5.0 + lane as f64 } else { 1e3 };
        (
            T::from_lanes(|lane| from(first + lane)),
            T::from_lanes(|lane| from(first + lane) + (self.bits[30] % 4) as f64),
        )
    }

    fn body<V: Signal>(&self, first: usize) -> (Body<V>, DampingLimit<V::Scalar>) {
        let mass = self.each(first, 0, 0.1, 2.0);
        let (damping, stiffness) =
            (self.each(first, 1, 1e-3, 2.0), self.each(first, 2, 10.0, 200.0));
        let period = self.each(first, 3, 1e-3, 1e-2);
        let start = V::splat(-self.each::<V::Scalar>(first, 4, 1e-3, 5e-3));
        let flow = V::splat(self.each(first, 5, 0.1, 0.5));
        let body = Body::new(Impedance { mass, damping, stiffness }, period).expect("a body");
        let cap = self.each(first, 6, 0.1, 1.0);
        let limit = DampingLimit::of_mass(cap, mass, period).expect("a limit");
        (body.starting(start, flow), limit)
    }

    /// All effects around `environment`; returns every number of the run, and which samples were accepted.
    fn run<V, S>(
        &self,
        first: usize,
        environment: impl OnePort<V>,
        stabilizer: S,
        mut plant: Body<V>,
    ) -> (Vec<V::Scalar>, Vec<<V::Scalar as Scalar>::Mask>)
    where
        V: Signal,
        S: Stabilizer<V>,
    {
        let (from, until) = self.fault(first);
        let mut port = Faulty::between(environment, from, until)
            .held(1 + (self.bits[7] % 3) as u32)
            .expect("a hold")
            .stabilized(stabilizer)
            .saturated(self.each(first, 8, 1.0, 20.0))
            .expect("a saturation")
            .delayed::<2>((self.bits[9] % 3) as u32)
            .expect("a delay")
            .differenced()
            .encoded(self.each(first, 10, 1e-7, 1e-4))
            .expect("an encoder");
        let (mut numbers, mut accepted) = (Vec::new(), Vec::new());
        let mut sample = plant.start();
        for _ in 0..TICKS {
            let effort = port.respond(&sample);
            let correction = port.correction();
            for signal in [sample.position, sample.velocity, effort, correction.effort] {
                signal.map(|axis| {
                    numbers.push(axis);
                    axis
                });
            }
            numbers.extend([correction.observed_energy, correction.alpha, correction.shortfall]);
            accepted.push(correction.accepted);
            sample = plant.advance(effort);
        }
        (numbers, accepted)
    }

    fn at_a_wall<T: Scalar, A: Accumulator<T>>(&self, first: usize) -> (Vec<T>, Vec<T::Mask>) {
        let wall = Wall::new(self.each(first, 11, 500.0, 2e4), self.each(first, 12, 0.1, 5.0));
        let wall = wall.expect("a wall").at(-self.each::<T>(first, 13, 1e-4, 1e-3));
        let (body, limit) = self.body::<T>(first);
        self.stabilized::<T, A>(first, wall, (PortEnergy, wall.dissipation()), limit, body)
    }

    fn on_axes<T: Scalar, A: Accumulator<T>>(&self, first: usize) -> (Vec<T>, Vec<T::Mask>) {
        let environment = MassSpringDamper::new(Impedance {
            mass: self.each(first, 11, 1e-3, 1e-2),
            damping: self.each(first, 12, 0.1, 5.0),
            stiffness: self.each(first, 14, 500.0, 5e3),
        });
        let (body, limit) = self.body::<SVector<T, 3>>(first);
        let mut axis = 0.0;
        let start = SVector::<T, 3>::splat(self.each(first, 4, 1e-3, 5e-3)).map(|start| {
            axis += 1.0;
            start / T::of(axis)
        });
        let body = body.starting(start, start.scale(self.each(first, 15, 1.0, 100.0)));
        let damper = Dissipation::of(self.each(first, 16, 1e-3, 1.0)).expect("a damping");
        let environment = environment.expect("an environment");
        self.stabilized::<_, A>(first, environment, (PortEnergy, damper), limit, body)
    }

    fn stabilized<V: Signal, A: Accumulator<V::Scalar>>(
        &self,
        first: usize,
        environment: impl OnePort<V>,
        candidate: impl LyapunovCandidate<V>,
        limit: DampingLimit<V::Scalar>,
        body: Body<V>,
    ) -> (Vec<V::Scalar>, Vec<<V::Scalar as Scalar>::Mask>) {
        let lolc = Lolc::new(candidate, limit).summed_in::<A>();
        match self.bits[17] % 4 {
            0 => self.run(first, environment, lolc.sampled(), body),
            _ => self.run(first, environment, lolc, body),
        }
    }
}

/// Every lane equals its run alone.
fn agree<L, T, A, B>()
where
    L: Scalar,
    T: Real,
    A: Accumulator<L>,
    B: Accumulator<T>,
{
    hold(CASES, uniform32(any::<Bits>()), |bits| {
        let parameters = Parameters { bits };
        for axes in [1, 3] {
            let (numbers, accepted) = match axes {
                1 => parameters.at_a_wall::<L, A>(0),
                _ => parameters.on_axes::<L, A>(0),
            };
            for lane in 0..L::LANES {
                let (alone, decided) = match axes {
                    1 => parameters.at_a_wall::<T, B>(lane),
                    _ => parameters.on_axes::<T, B>(lane),
                };
                prop_assert!(alone.len() == numbers.len());
                let apart = numbers
                    .iter()
                    .zip(alone)
                    .position(|(n, alone)| !same(n.lane(lane), alone.f64()));
                prop_assert!(apart.is_none(), "lane {lane} of {axes} axes, number {apart:?}");
                let equal = accepted.iter().zip(&decided).all(|(m, truth)| m.lane(lane) == *truth);
                prop_assert!(equal, "acceptance in lane {lane} of {axes} axes");
            }
        }
        Ok(())
    });
}

/// The runs are worth comparing: the controller acts, samples are rejected in some lanes and not in others, and nothing
/// blows up.
#[test]
fn rollouts_are_worth_comparing() {
    let seen = std::cell::Cell::new([0usize; 3]);
    hold(500, uniform32(any::<Bits>()), |bits| {
        let parameters = Parameters { bits };
        let (numbers, accepted) = parameters.at_a_wall::<AutoF64x4, Plain<AutoF64x4>>(0);
        prop_assert!(numbers.iter().all(|n| (0..4).all(|lane| n.lane(lane).abs() < 1e6)));
        let mut now = seen.get();
        // Position, velocity, effort, the correction's effort, sum, alpha.
        now[0] += usize::from(numbers.chunks(7).any(|row| row[5].lane(0) > 0.0));
        now[1] += usize::from(accepted.iter().any(|mask| !mask.all() && mask.any()));
        now[2] += usize::from(unit(bits[0]) > 0.5 && accepted.iter().all(|mask| mask.all()));
        seen.set(now);
        Ok(())
    });
    assert!(seen.get().iter().all(|count| *count > 10), "{:?}", seen.get());
}

macro_rules! rollouts {
    ($($name:ident: $lanes:ident of $real:ident in $sum:ident),+ $(,)?) => {$(
        #[test]
        fn $name() {
            agree::<$lanes, $real, $sum<$lanes>, $sum<$real>>();
        }
    )+};
}

rollouts! {
    auto_f32x4: AutoF32x4 of f32 in Plain,
    auto_f32x8: AutoF32x8 of f32 in Plain,
    auto_f64x4: AutoF64x4 of f64 in Plain,
    auto_f64x8: AutoF64x8 of f64 in Plain,
    wide_f32x8: WideF32x8 of f32 in Plain,
    wide_f64x4: WideF64x4 of f64 in Plain,
    auto_f32x8_compensated: AutoF32x8 of f32 in Compensated,
    wide_f64x4_compensated: WideF64x4 of f64 in Compensated,
    auto_f32x4_wide: AutoF32x4 of f32 in Wide,
    auto_f32x8_wide: AutoF32x8 of f32 in Wide,
}
