//! Ticks without the checks of each sample, whose numbers are looked at afterwards.
//!
//! A step of LOLC keeps four questions in every tick: whether its numbers are finite, whether the credit is, whether anything
//! moves, and whether the displacement lies where a product gives the quotient. On moderate numbers the answers are known.
//! So the port here asks none of them and keeps what tells, after some ticks, whether its numbers were moderate. If they were,
//! its bits are those of the library's step; if not, its ticks are thrown away.

use lyapunov::{Mask, OnePort, PortSample, Scalar, environments::Wall};

use super::backward::{Fuse, Period};
use super::parts::Crediting;

/// The largest moderate parameter of a port, and the largest moderate |position| and displacement, m. With [`PERIODS`], every
/// product in a step stays below 1e25.
pub(super) const MODERATE: f64 = 1e6;

/// Moderate periods, s.
pub(super) const PERIODS: std::ops::RangeInclusive<f64> = 1e-5..=1.0;

/// The largest moderate sum, J, and force of an earlier tick, N: far below the end of `f32`, and the ticks between two looks
/// change it by less than its last digits.
pub(super) const LARGE: f64 = 1e30;

/// The account of a stabilizer for some ticks.
#[derive(Clone, Copy, Debug)]
pub(super) struct Account<T, C> {
    pub(super) energy: T,
    /// The largest damping, N·s/m.
    pub(super) most: T,
    pub(super) candidate: C,
}

/// A stabilized wall for some ticks.
#[derive(Clone, Copy, Debug)]
pub(super) struct SurePort<T, C> {
    pub(super) wall: Wall<T>,
    pub(super) period: Period<T>,
    pub(super) ticks: u64,
    pub(super) left: u64,
    pub(super) answer: T,
    pub(super) account: Account<T, C>,
    /// The wall's position, m.
    pub(super) surface: T,
    /// The least |displacement| of a tick that moved, m.
    pub(super) least: T,
}

/// Numbers of a tick whose force waits for a quotient.
#[derive(Clone, Copy, Debug)]
pub(super) struct Asked<T> {
    velocity: T,
    /// The inverse of what the damping divides the debt by, below 0.
    inverse: T,
}

impl<T: Fuse, C: Crediting<T>> SurePort<T, C> {
    /// Takes a sample, up to the division.
    #[inline(always)]
    pub(super) fn ask(&mut self, sample: &PortSample<T>) -> Asked<T> {
        let moved = sample.displacement;
        let velocity = self.period.divide_near(moved);
        if self.left == 0 {
            self.left = self.ticks;
            self.answer = self.wall.respond(&PortSample { velocity, ..*sample });
        }
        self.left -= 1;
        let square = velocity * velocity * sample.period;
        let zero = T::zero();
        let size = moved.magnitude();
        self.least = T::choose(size.above(zero), self.least.smaller(size), self.least);
        let Account { energy, candidate, .. } = &mut self.account;
        *energy += candidate.sure_decrease(sample, square, self.surface);
        Asked { velocity, inverse: T::of(-1.0) / (square * margin()) }
    }

    /// The corrected force, N.
    #[inline(always)]
    pub(super) fn reply(&self, asked: Asked<T>) -> T {
        let Asked { velocity, inverse } = asked;
        // Without motion the product is infinite or NaN, and alpha is any number from 0 to the most, of which nothing comes.
        let alpha = (self.account.energy * inverse).smaller(self.account.most).larger(T::zero());
        self.answer + velocity * alpha
    }

    /// Whether the numbers of every lane were moderate since the last look: `reach` is the largest |position| of them, which
    /// passes over a NaN, and `position` the present one, which does not.
    #[inline(always)]
    pub(super) fn was_sure(&self, reach: T, position: T) -> bool {
        // The end of the range of the quotient, twice, for what is rounded: `v² T` is above the smallest normal number.
        let least = T::of(2.0) * T::smallest_normal().sqrt();
        let near = reach.below(T::of(MODERATE)) & position.finite();
        let paid = self.account.energy.magnitude().below(T::of(LARGE));
        (near & paid & self.least.above(least)).all()
    }
}

/// The margin by which LOLC rounds alpha up.
#[inline(always)]
fn margin<T: Scalar>() -> T {
    T::of(1.0) - T::of(4.0) * T::epsilon()
}

#[cfg(test)]
mod tests {
    use lyapunov::bodies::{Body, Impedance};
    use lyapunov::stabilizers::Account as _;
    use lyapunov::{DampingLimit, Lolc, Plant, PortEnergy};
    use proptest::prelude::*;

    use super::super::port::StabilizedWall;
    use super::*;

    /// Numbers of a loop.
    #[derive(Clone, Copy, Debug)]
    struct Numbers {
        stiffness: f64,
        damping: f64,
        surface: f64,
        most: f64,
        drag: f64,
        rate: f64,
        start: f64,
    }

    const NUMBERS: Numbers = Numbers {
        stiffness: 8000.0,
        damping: 2.0,
        surface: 0.0,
        most: 50.0,
        drag: 0.2,
        rate: 1000.0,
        start: -0.004,
    };

    /// Runs 64 ticks with and without checks, after as many `before`, and tells whether they needed none.
    fn is_sure<T: Fuse<Mask = bool>>(numbers: Numbers, before: usize) -> bool {
        let Numbers { stiffness, damping, surface, most, drag, rate, start } = numbers;
        let [mass, spring] = [0.3, 50.0].map(T::of);
        let impedance = Impedance { mass, damping: T::of(drag), stiffness: spring };
        let mut plant = Body::new(impedance, T::of(1.0 / rate)).unwrap();
        plant = plant.starting(T::of(start), T::zero());
        let wall = Wall::new(T::of(stiffness), T::of(damping)).unwrap().at(T::of(surface));
        let limit = DampingLimit::at(T::of(most)).unwrap();
        let lolc = Lolc::new((PortEnergy, wall.dissipation()), limit);
        let mut port = StabilizedWall::new(wall, 10, lolc, 1.0 / rate).sure(T::of(surface));
        let mut sample = plant.start();
        for _ in 0..before {
            sample = plant.advance(port.respond(&sample).effort);
        }
        let Some(mut sure) = port.unchecked(&sample) else { return false };
        let (mut other, mut seen, mut reach) = (plant, sample, T::zero());
        let (mut is_same, mut energy) = (true, T::zero());
        for _ in 0..64 {
            reach = reach.larger(seen.position.magnitude());
            let asked = sure.ask(&seen);
            seen = other.advance(sure.reply(asked));
            let correction = port.respond(&sample);
            sample = plant.advance(correction.effort);
            energy = correction.observed_energy;
            is_same &= correction.accepted && alike(energy, sure.account.energy);
            is_same &=
                alike(sample.position, seen.position) && alike(sample.velocity, seen.velocity);
        }
        let is_sure = sure.was_sure(reach, seen.position);
        assert!(!is_sure || is_same, "{numbers:?}");
        port.follow(&sure);
        port.catch_up();
        assert!(!is_sure || alike(port.stabilizer().observed_energy(), energy));
        is_sure
    }

    fn alike<T: Scalar>(one: T, other: T) -> bool {
        one.lane(0).to_bits() == other.lane(0).to_bits()
    }

    #[test]
    fn numbers_of_a_hand_are_moderate_and_ends_of_the_range_are_not() {
        for before in [0, 64] {
            assert!(is_sure::<f64>(NUMBERS, before) && is_sure::<f32>(NUMBERS, before));
        }
        for start in [1e-25, -1e7, 1e30] {
            assert!(!is_sure::<f32>(Numbers { start, ..NUMBERS }, 0), "{start}");
        }
        assert!(!is_sure::<f64>(Numbers { start: 1e-160, ..NUMBERS }, 0));
        // At rest nothing moves, and no quotient is small.
        assert!(is_sure::<f32>(Numbers { start: 0.0, ..NUMBERS }, 0));
        // Each number of the port by itself.
        let rest = Numbers { start: 0.0, ..NUMBERS };
        for immoderate in [Numbers { damping: 1e7, ..rest }, Numbers { most: 1e7, ..rest }] {
            assert!(!is_sure::<f32>(immoderate, 0) && !is_sure::<f64>(immoderate, 0));
        }
        // As far away as is moderate, until a wall throws the hand farther.
        let far = Numbers { stiffness: 9e5, start: -9e5, ..NUMBERS };
        for (before, moderate) in [(32, true), (128, false)] {
            let sure = [is_sure::<f32>(far, before), is_sure::<f64>(far, before)];
            assert_eq!(sure, [moderate; 2], "{before}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]

        #[test]
        fn sure_ticks_have_the_bits_of_checked_ones(
            (stiffness, damping) in (-1.0..6.0_f64, -3.0..6.0_f64),
            surface in prop_oneof![Just(0.0), -0.01..0.01_f64],
            (most, drag) in (-2.0..6.0_f64, -3.0..3.0_f64),
            rate in prop_oneof![Just(1000.0), 1.0..1e5_f64],
            size in prop_oneof![-200.0..8.0_f64, -40.0..-15.0_f64, -5.0..0.0_f64],
            sign in prop_oneof![Just(-1.0), Just(1.0)],
            before in prop_oneof![Just(0_usize), 0..200_usize],
        ) {
            let powers = [stiffness, damping, most, drag, size].map(|it| 10_f64.powf(it));
            let [stiffness, damping, most, drag, size] = powers;
            let numbers =
                Numbers { stiffness, damping, surface, most, drag, rate, start: sign * size };
            is_sure::<f64>(numbers, before);
            is_sure::<f32>(numbers, before);
        }
    }
}
