//! Environments at their neutral values, equal to simpler ones to the last bit.

use proptest::array::uniform16;
use proptest::collection::vec;
use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::TestCaseResult;

use lyapunov::{
    Dissipation, LyapunovCandidate, OnePort, PortSample,
    bodies::Impedance,
    environments::{
        HuntCrossley, LayeredWall, MassSpringDamper, MovingWall, Spring, VaryingSpring, Wall,
    },
};

use super::models::Parts;
use crate::support::{Bits, CASES, Port, Real, drive_of, hold};

type Both<T> = (Box<dyn OnePort<T>>, Box<dyn LyapunovCandidate<T>>);

fn both<T: Real>(
    port: impl OnePort<T> + 'static,
    term: impl LyapunovCandidate<T> + 'static,
) -> Both<T> {
    (Box::new(port), Box::new(term))
}

/// Equal bits, with `−0` taken for 0.
fn alike<T: Real>(a: T, b: T) -> bool {
    a == b || (a.f64().is_nan() && b.f64().is_nan())
}

fn equal<T: Real>(drives: &[PortSample<T>], one: Both<T>, other: Both<T>) -> TestCaseResult {
    let ((mut one, mut its), (mut other, mut others)) = (one, other);
    for sample in drives {
        let (a, b) = (one.respond(sample), other.respond(sample));
        prop_assert!(alike(a, b), "{a:?} is not {b:?} for {sample:?}");
        let (a, b) = (its.decrease(sample), others.decrease(sample));
        prop_assert!(alike(a, b), "credit {a:?} is not {b:?} for {sample:?}");
    }
    Ok(())
}

mod check {
    use super::*;

    pub(super) fn neutral_values<T: Real + Port<Scalar = T>>() {
        let samples = vec(uniform16(any::<Bits>()), 1..16);
        hold(CASES, (uniform16(any::<Bits>()), samples), |(bits, samples)| {
            let parts = Parts::<T>::of(&bits, 0);
            let (zero, one) = (T::of(0.0), T::of(1.0));
            let Parts { position, stiffness: [k, other], damping, depth, .. } = parts;
            let Parts { frequency, rate, .. } = parts;
            let tame = bits[15] % 2 == 0;
            let drives: Vec<_> =
                samples.iter().map(|bits| drive_of::<T>(*bits, tame, one / rate).0).collect();

            let wall = Wall::new(k, damping).expect("a wall").at(position);
            let wall = || both(wall, wall.dissipation());
            let moving = Wall::new(k, damping).expect("a wall").at(position);
            let moving = MovingWall::new(moving, zero, frequency, rate).expect("at rest");
            equal(&drives, both(moving, moving.dissipation(rate).expect("one")), wall())?;
            for (depth, layers) in [(depth, [k, k]), (zero, [other, k]), (T::largest(), [k, other])]
            {
                let layered = LayeredWall::new(depth, layers, damping).expect("layers");
                let layered = layered.at(position);
                equal(&drives, both(layered, layered.dissipation()), wall())?;
            }

            let undamped = Wall::new(k, zero).expect("a wall").at(position);
            let linear = HuntCrossley::new(k, one, zero).expect("linear").at(position);
            let undamped = both(undamped, undamped.dissipation());
            equal(&drives, both(linear, linear.dissipation()), undamped)?;

            let none = || Dissipation::of(zero).expect("none");
            let spring = Spring::new(k).expect("a spring").at(position);
            let constant = VaryingSpring::new(spring, zero, frequency, rate).expect("constant");
            equal(&drives, both(constant, none()), both(spring, none()))?;
            let massless = Impedance { mass: zero, damping: zero, stiffness: k };
            let massless = MassSpringDamper::new(massless).expect("a spring").at(position);
            equal(&drives, both(massless, massless.dissipation()), both(spring, none()))
        });
    }
}

crate::support::every_real!(neutral_values);
