//! Four stabilizers as straight code on concrete types, without a call into the library.

use super::{BOUND_DAMPING, CREDIT, MOST, STORE};

macro_rules! hand {
    ($real:ident) => {
        pub(crate) mod $real {
            use lyapunov::{PortSample, laws::Samples};
            use nalgebra::SVector;

            use super::{BOUND_DAMPING, CREDIT, MOST, STORE};

            /// A sample and an effort.
            #[derive(Clone, Copy)]
            pub(crate) struct Sample<const N: usize> {
                period: $real,
                velocity: [$real; N],
                displacement: [$real; N],
                work: [$real; N],
                effort: [$real; N],
                #[expect(dead_code, reason = "part of a sample, unused here")]
                rest: [[$real; N]; 2],
            }

            pub(crate) fn samples<const N: usize>(period: f64) -> Vec<Sample<N>> {
                let seen =
                    |(sample, effort): (PortSample<SVector<$real, N>>, SVector<$real, N>)| Sample {
                        period: sample.period,
                        velocity: sample.velocity.into(),
                        displacement: sample.displacement.into(),
                        work: sample.work.into(),
                        effort: effort.into(),
                        rest: [sample.position.into(), sample.applied.into()],
                    };
                Samples::new(period as $real).map(seen).collect()
            }

            #[derive(Clone, Copy)]
            #[expect(dead_code, reason = "part of a correction, unused here")]
            pub(crate) struct Told<const N: usize> {
                effort: [$real; N],
                sum: $real,
                alpha: $real,
                shortfall: $real,
                accepted: bool,
            }

            impl<const N: usize> Told<N> {
                pub(crate) const NOTHING: Self =
                    Self { effort: [0.0; N], sum: 0.0, alpha: 0.0, shortfall: 0.0, accepted: true };
            }

            #[inline(always)]
            fn dot<const N: usize>(a: &[$real; N], b: &[$real; N]) -> $real {
                let mut sum = a[0] * b[0];
                for axis in 1..N {
                    sum += a[axis] * b[axis];
                }
                sum
            }

            #[inline(always)]
            fn total<const N: usize>(a: &[$real; N]) -> $real {
                let mut sum = a[0];
                for axis in 1..N {
                    sum += a[axis];
                }
                sum
            }

            pub(crate) trait Tick<const N: usize> {
                fn tick(&mut self, seen: &Sample<N>) -> Told<N>;
            }

            #[inline(never)]
            pub(crate) fn block<const N: usize>(
                stabilizer: &mut impl Tick<N>,
                samples: &[Sample<N>],
                told: &mut [Told<N>],
            ) {
                for (seen, told) in samples.iter().zip(told) {
                    *told = stabilizer.tick(seen);
                }
            }

            /// The observer/controller over held work.
            struct Controller {
                sum: $real,
                most: $real,
            }

            impl Controller {
                const NEW: Self = Self { sum: 0.0, most: MOST as $real };

                #[inline(always)]
                fn correct<const N: usize>(
                    &mut self,
                    decrease: $real,
                    square: $real,
                    velocity: &[$real; N],
                    effort: &[$real; N],
                ) -> Told<N> {
                    let least = $real::MIN_POSITIVE;
                    let divisor = square * (1.0 - 4.0 * $real::EPSILON);
                    let inverse = -1.0 / if divisor > least { divisor } else { least };
                    let most = if square > least { self.most } else { 0.0 };
                    self.sum += decrease;
                    let sum = self.sum;
                    let alpha = sum * inverse;
                    let alpha = if alpha < most { alpha } else { most };
                    let alpha = if alpha > 0.0 { alpha } else { 0.0 };
                    let served = sum + alpha * square;
                    let mut out = *effort;
                    for axis in 0..N {
                        out[axis] += velocity[axis] * alpha;
                    }
                    let shortfall = 0.0 - if served < 0.0 { served } else { 0.0 };
                    let accepted = (served + total(&out)).is_finite();
                    Told { effort: out, sum, alpha, shortfall, accepted }
                }

                #[inline(always)]
                fn tick<const N: usize>(
                    &mut self,
                    decrease: $real,
                    square: $real,
                    seen: &Sample<N>,
                ) -> Told<N> {
                    let before = self.sum;
                    let mut told = self.correct(decrease, square, &seen.velocity, &seen.effort);
                    told.accepted &= seen.period > 0.0;
                    if told.accepted {
                        return told;
                    }
                    let fits = (before + decrease).is_finite();
                    self.sum = before;
                    let decrease = if fits { decrease } else { 0.0 };
                    Told { accepted: false, ..self.correct(decrease, 0.0, &[0.0; N], &[0.0; N]) }
                }
            }

            pub(crate) struct Popc(Controller);

            impl Popc {
                pub(crate) const NEW: Self = Self(Controller::NEW);
            }

            impl<const N: usize> Tick<N> for Popc {
                #[inline(always)]
                fn tick(&mut self, seen: &Sample<N>) -> Told<N> {
                    let square = dot(&seen.velocity, &seen.velocity) * seen.period;
                    self.0.tick(total(&seen.work), square, seen)
                }
            }

            pub(crate) struct Lolc(Controller, $real);

            impl Lolc {
                pub(crate) const NEW: Self = Self(Controller::NEW, CREDIT as $real);
            }

            impl<const N: usize> Tick<N> for Lolc {
                #[inline(always)]
                fn tick(&mut self, seen: &Sample<N>) -> Told<N> {
                    let square = dot(&seen.velocity, &seen.velocity) * seen.period;
                    let burnt = self.1 * square;
                    let credit = if burnt.is_finite() { burnt } else { 0.0 };
                    self.0.tick(total(&seen.work) + credit, square, seen)
                }
            }

            #[inline(always)]
            fn scaled<const N: usize>(
                effort: &[$real; N],
                factor: $real,
                accepted: bool,
            ) -> ([$real; N], bool) {
                let (mut out, mut finite) = ([0.0; N], accepted);
                for axis in 0..N {
                    finite &= effort[axis].is_finite();
                }
                for axis in 0..N {
                    out[axis] = if finite { effort[axis] * factor } else { 0.0 };
                }
                (out, finite)
            }

            pub(crate) struct Bound {
                damping: $real,
                energy: $real,
            }

            impl Bound {
                pub(crate) const NEW: Self = Self { damping: BOUND_DAMPING as $real, energy: 0.0 };
            }

            impl<const N: usize> Tick<N> for Bound {
                #[inline(always)]
                fn tick(&mut self, seen: &Sample<N>) -> Told<N> {
                    let moved = dot(&seen.displacement, &seen.displacement);
                    let change = total(&seen.work) + self.damping * (moved / seen.period);
                    let booked = (self.energy + change).is_finite();
                    self.energy += if booked { change } else { 0.0 };
                    let sum = self.energy;
                    let share = (4.0 - 64.0 * $real::EPSILON) * self.damping;
                    let most = (share * (if sum > 0.0 { sum } else { 0.0 } / seen.period)).sqrt();
                    let size = dot(&seen.effort, &seen.effort).sqrt();
                    let factor = if size > most { most / size } else { 1.0 };
                    let sound = booked && (size + most).is_finite();
                    let (effort, accepted) = scaled(&seen.effort, factor, sound);
                    let shortfall = if -sum > 0.0 { -sum } else { 0.0 };
                    Told { effort, sum, alpha: 0.0, shortfall, accepted }
                }
            }

            pub(crate) struct Tank {
                energy: $real,
                room: $real,
                power: $real,
            }

            impl Tank {
                pub(crate) const NEW: Self = Self {
                    energy: (STORE[0] - STORE[1]) as $real,
                    room: (STORE[2] - STORE[1]) as $real,
                    power: STORE[3] as $real,
                };
            }

            impl<const N: usize> Tick<N> for Tank {
                #[inline(always)]
                fn tick(&mut self, seen: &Sample<N>) -> Told<N> {
                    let work = total(&seen.work);
                    let booked = (self.energy + work).is_finite();
                    let filled = self.energy + if booked { work } else { 0.0 };
                    self.energy = if filled < self.room { filled } else { self.room };
                    let sum = self.energy;
                    let kept = 1.0 - 4.0 * <$real>::EPSILON;
                    let available = if sum > 0.0 { sum } else { 0.0 } * kept / seen.period;
                    let most = if available < self.power { available } else { self.power };
                    let given = -dot(&seen.effort, &seen.velocity);
                    let factor = if given > most { most / given } else { 1.0 };
                    let sound = (given + seen.period + work).is_finite();
                    let (effort, accepted) = scaled(&seen.effort, factor, sound);
                    let shortfall = if -sum > 0.0 { -sum } else { 0.0 };
                    Told { effort, sum, alpha: 0.0, shortfall, accepted }
                }
            }
        }
    };
}

hand!(f32);
hand!(f64);
