//! Bad numbers, which do not pass for "no contact", and large ones, which are not lost.

use proptest::array::uniform16;
use proptest::prelude::any;
use proptest::prop_assert;

use lyapunov::{LyapunovCandidate, OnePort, PortSample};

use super::models::{Environment, Example2, Hunt, Layered, Moving, Parts, Plain, Varying};
use crate::support::{Bits, CASES, Real, hold};

/// The kind of a force: 0, another number, or not a number.
fn kind(force: f64) -> &'static str {
    match force {
        0.0 => "nothing",
        _ if force.is_nan() => "NaN",
        _ => "a force",
    }
}

fn one_sided<E: Environment, T: Real>() {
    hold(CASES, uniform16(any::<Bits>()), |bits| {
        let parts = Parts::<T>::of(&bits, 0);
        // At the first call a moving surface stands at its position as well.
        let sample = parts.sample([bits[10], bits[11]], 0);
        let nan = T::of(f64::NAN);
        let outside = parts.position - T::of(0.01);
        let inside = parts.position + T::of(0.01);
        let away = T::of(if bits[12] % 2 == 0 { 1e25 } else { -1e25 });
        let still = T::of(0.0);
        for (position, velocity, answer) in [
            (nan, sample.velocity, "NaN"),
            (nan, nan, "NaN"),
            (inside, nan, "NaN"),
            (outside, nan, "nothing"),
            (parts.position, nan, "nothing"),
            (parts.position, T::of(1.0), "nothing"),
            (away, still, if away.f64() > 0.0 { "a force" } else { "nothing" }),
        ] {
            let sample = PortSample { position, velocity, ..sample };
            let (mut port, mut term) = E::build(parts);
            let found = port.respond(&sample).f64();
            prop_assert!(kind(found) == answer, "{found} is not {answer}: {sample:?}");
            let credit = term.decrease(&sample).f64();
            let contact = position.f64() > parts.position.f64();
            prop_assert!(contact || credit == 0.0, "credit {credit} out of contact");
        }
        Ok(())
    });
}

fn two_sided<E: Environment, T: Real>() {
    hold(CASES, uniform16(any::<Bits>()), |bits| {
        let parts = Parts::<T>::of(&bits, 0);
        let sample = parts.sample([bits[10], bits[11]], 0);
        let (mut port, _) = E::build(parts);
        let found = port.respond(&PortSample { position: T::of(f64::NAN), ..sample });
        prop_assert!(found.f64().is_nan(), "{found:?} for a position that is not known");
        Ok(())
    });
}

mod check {
    use super::*;

    pub(super) fn what_only_pushes<T: Real>() {
        one_sided::<Plain, T>();
        one_sided::<Layered, T>();
        one_sided::<Hunt, T>();
        one_sided::<Moving, T>();
    }

    pub(super) fn what_also_pulls<T: Real>() {
        two_sided::<Varying, T>();
        two_sided::<Example2<false>, T>();
    }
}

crate::support::every_real!(what_only_pushes, what_also_pulls);

/// An environment's memory keeps nothing of a NaN: neither a count nor the last velocity.
#[test]
fn the_next_sample_is_sound_again() {
    fn heals<E: Environment>() {
        let parts = Parts::<f64>::of(&[7; 16], 0);
        let ((mut spoilt, _), (mut sound, _)) = (E::build(parts), E::build(parts));
        let sample = PortSample { position: parts.position + 0.05, ..parts.sample([1, 2], 0) };
        for (position, velocity) in [(f64::NAN, f64::NAN), (sample.position, f64::INFINITY)] {
            spoilt.respond(&PortSample { position, velocity, ..sample });
            sound.respond(&sample);
            assert_eq!(spoilt.respond(&sample), sound.respond(&sample));
        }
    }
    heals::<Moving>();
    heals::<Varying>();
    heals::<Example2<false>>();
}
