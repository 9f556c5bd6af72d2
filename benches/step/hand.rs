//! Steps by hand, as straight code on concrete types without a call into the library, and the paper's steps taken
//! literally.

use super::samples::{DAMPING, LIMIT, Sample};

macro_rules! hand {
    ($module:ident, $real:ident) => {
        pub(crate) mod $module {
            use super::{DAMPING, LIMIT, Sample};

            pub(crate) struct State {
                sum: $real,
                limit: $real,
                damping: $real,
            }

            impl State {
                pub(crate) fn new() -> Self {
                    Self { sum: 0.0, limit: LIMIT as $real, damping: DAMPING as $real }
                }
            }

            #[derive(Clone, Copy)]
            pub(crate) struct Out<const N: usize> {
                pub(crate) effort: [$real; N],
                pub(crate) sum: $real,
                pub(crate) alpha: $real,
                pub(crate) shortfall: $real,
                pub(crate) accepted: bool,
            }

            impl<const N: usize> Default for Out<N> {
                fn default() -> Self {
                    Self { effort: [0.0; N], sum: 0.0, alpha: 0.0, shortfall: 0.0, accepted: false }
                }
            }

            #[inline(always)]
            fn sum_of<const N: usize>(a: &[$real; N]) -> $real {
                let mut sum = a[0];
                for i in 1..N {
                    sum += a[i];
                }
                sum
            }

            #[inline(always)]
            fn dot<const N: usize>(a: &[$real; N], b: &[$real; N]) -> $real {
                let mut sum = a[0] * b[0];
                for i in 1..N {
                    sum += a[i] * b[i];
                }
                sum
            }

            /// The sample, with a force that waits for the one before where the loop is a chain; `none` is 0.
            #[inline(always)]
            fn waiting<const N: usize, const CHAIN: bool>(
                s: &Sample<$real, N>,
                none: $real,
                before: $real,
            ) -> Sample<$real, N> {
                let effort = if CHAIN { s.effort.map(|f| f + none * before) } else { s.effort };
                Sample { effort, ..*s }
            }

            /// α, the corrected effort and the rest, alike for both kinds of work; whether all of it is finite.
            #[inline(always)]
            fn correct<const N: usize>(
                state: &State,
                s: &Sample<$real, N>,
                sum: $real,
                square: $real,
                out: &mut Out<N>,
            ) -> bool {
                let margin = 1.0 - 4.0 * $real::EPSILON;
                let least = $real::MIN_POSITIVE;
                let divisor = square * margin;
                let inverse = -1.0 / if divisor > least { divisor } else { least };
                let limit = if square > least { state.limit } else { 0.0 };
                let alpha = sum * inverse;
                let alpha = if alpha < limit { alpha } else { limit };
                let alpha = if alpha > 0.0 { alpha } else { 0.0 };
                let served = sum + alpha * square;
                for i in 0..N {
                    out.effort[i] = s.effort[i] + alpha * s.velocity[i];
                }
                let probe = sum_of(&out.effort);
                out.sum = sum;
                out.alpha = alpha;
                out.shortfall = 0.0 - if served < 0.0 { served } else { 0.0 };
                out.accepted = (served + probe).is_finite() & (s.period > 0.0);
                out.accepted
            }

            /// The step for a rejected sample: no effort; the energy of the past is booked if finite.
            #[inline]
            fn reject<const N: usize>(
                state: &mut State,
                before: $real,
                energy: $real,
                out: &mut Out<N>,
            ) {
                let sum = if (before + energy).is_finite() { before + energy } else { before };
                state.sum = sum;
                let shortfall = if -sum > 0.0 { -sum } else { 0.0 };
                *out = Out { effort: [0.0; N], sum, alpha: 0.0, shortfall, accepted: false };
            }

            #[inline(never)]
            pub(crate) fn sampled<const N: usize, const CHAIN: bool>(
                state: &mut State,
                none: $real,
                samples: &[Sample<$real, N>],
                out: &mut [Out<N>],
            ) {
                let mut last = 0.0;
                for (s, out) in samples.iter().zip(out) {
                    let s = &waiting::<N, CHAIN>(s, none, last);
                    let square = dot(&s.velocity, &s.velocity) * s.period;
                    let crossed = s.velocity.map(|v| v * s.period);
                    let energy = dot(&s.effort, &crossed) + state.damping * square;
                    let moving = if square > $real::MIN_POSITIVE { square } else { 0.0 };
                    let most = -state.limit * moving;
                    let before = state.sum;
                    let sum = before + energy;
                    let raised = before + (energy - most);
                    let raised = if raised < 0.0 { raised } else { 0.0 };
                    state.sum = if raised > sum { raised } else { sum };
                    if !correct(state, s, sum, square, out) {
                        reject(state, before, energy, out);
                    }
                    last = out.effort[0];
                }
            }

            #[inline(never)]
            pub(crate) fn held<const N: usize, const CHAIN: bool>(
                state: &mut State,
                none: $real,
                samples: &[Sample<$real, N>],
                out: &mut [Out<N>],
            ) {
                let mut last = 0.0;
                for (s, out) in samples.iter().zip(out) {
                    let s = &waiting::<N, CHAIN>(s, none, last);
                    let square = dot(&s.velocity, &s.velocity) * s.period;
                    let mut energy = s.work[0];
                    for i in 1..N {
                        energy += s.work[i];
                    }
                    energy += state.damping * square;
                    let before = state.sum;
                    state.sum = before + energy;
                    if !correct(state, s, state.sum, square, out) {
                        reject(state, before, energy, out);
                    }
                    last = out.effort[0];
                }
            }

            pub(crate) struct Literal {
                sum: $real,
                alpha: $real,
                square: $real,
                damping: $real,
            }

            impl Literal {
                pub(crate) fn new() -> Self {
                    Self { sum: 0.0, alpha: 0.0, square: 0.0, damping: DAMPING as $real }
                }
            }

            /// Steps 4 to 6 as printed, with the period left out and the division on every tick.
            #[inline(never)]
            pub(crate) fn literal<const CHAIN: bool>(
                state: &mut Literal,
                none: $real,
                samples: &[Sample<$real, 1>],
                forces: &mut [$real],
            ) {
                let mut last = 0.0;
                for (s, force) in samples.iter().zip(forces) {
                    let (f, v) = (waiting::<1, CHAIN>(s, none, last).effort[0], s.velocity[0]);
                    let square = v * v;
                    state.sum += f * v + state.alpha * state.square + state.damping * square;
                    // The choice comes before the division, so that no branch can skip the division.
                    let debt = if -state.sum > 0.0 { -state.sum } else { 0.0 };
                    state.alpha = debt / square;
                    state.square = square;
                    *force = f + state.alpha * v;
                    last = *force;
                }
            }
        }
    };
}

hand!(f64s, f64);
hand!(f32s, f32);
