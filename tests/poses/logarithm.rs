//! Displacement between two poses: it leads from one to the other, by a matrix exponential with thirty digits.

use lyapunov::poses::{BodyAxes, Pose, Screw, WorldAxes};
use nalgebra::{Isometry3, UnitQuaternion, Vector3};

use crate::support::{Dice, Real, apart, exponential, motion, pose, quaternion, wide};

/// A pose as its exact numbers.
#[derive(Clone, Copy)]
struct Numbers<T> {
    position: Vector3<T>,
    quaternion: [T; 4],
}

impl<T: Real> Numbers<T> {
    fn of(position: Vector3<f64>, quaternion: [f64; 4]) -> Self {
        Self { position: position.map(T::of), quaternion: quaternion.map(T::of) }
    }

    fn pose(&self) -> Pose<T> {
        pose(self.position, quaternion(self.quaternion))
    }

    fn matrix(&self) -> nalgebra::Matrix4<crate::support::Long> {
        motion(wide(self.position), quaternion(self.quaternion))
    }
}

/// Errors of the displacement: of its rotation in units of `ε θ`, of its translation in units of `ε |p₁ − p₀|`.
fn errors<T: Real>(from: Numbers<T>, to: Numbers<T>) -> [f64; 4] {
    let unit: f64 = T::epsilon().into();
    let moved = (to.position - from.position).map(Into::into).norm();
    let relative = |(turned, shifted): (f64, f64), angle: f64| {
        [turned / (unit * angle), if moved > 0.0 { shifted / (unit * moved) } else { shifted }]
    };

    let body = Screw::<T, BodyAxes>::between(&from.pose(), &to.pose());
    let led = from.matrix() * exponential(wide(body.translation), wide(body.rotation));
    let [turned, shifted] =
        relative(apart(&led, &to.matrix()), body.rotation.map(Into::into).norm());

    // Along the world's axes the rotation is about the reference point itself.
    let world = Screw::<T, WorldAxes>::between(&from.pose(), &to.pose());
    let mut led =
        exponential([0.0; 3], wide(world.rotation)) * motion([0.0; 3], quaternion(from.quaternion));
    for (axis, shift) in wide(world.translation).into_iter().enumerate() {
        led[(axis, 3)] = from.matrix()[(axis, 3)] + shift.into();
    }
    let [turned_in_world, shifted_in_world] =
        relative(apart(&led, &to.matrix()), world.rotation.map(Into::into).norm());
    [turned, shifted, turned_in_world, shifted_in_world]
}

/// Two random poses, `angle` from each other and `distance` apart, rounded to the scalar.
fn pair<T: Real>(dice: &mut Dice, angle: f64, distance: f64) -> [Numbers<T>; 2] {
    let start = UnitQuaternion::from_scaled_axis(dice.direction() * dice.within(3.0));
    let end = start * UnitQuaternion::from_scaled_axis(dice.direction() * angle);
    let position: Vector3<f64> = dice.vector(1.0);
    let there = position + dice.direction() * distance;
    [(position, start), (there, end)].map(|(position, turn)| {
        let numbers = turn.into_inner().coords.into();
        Numbers::of(position, numbers)
    })
}

/// The largest errors over many pairs of an angle.
fn sweep<T: Real>(angle: f64, distance: f64) -> [f64; 4] {
    let mut dice = Dice::of(angle.to_bits() ^ 77);
    let mut most = [0.0; 4];
    for _ in 0..100 {
        let [from, to] = pair::<T>(&mut dice, angle, distance);
        if from.quaternion == to.quaternion {
            continue;
        }
        for (most, error) in most.iter_mut().zip(errors(from, to)) {
            *most = f64::max(*most, error);
        }
    }
    most
}

/// The bound that the type states: a few units in the last place of the rotation, however small it is, and of the
/// distance.
fn is_accurate<T: Real>() {
    let unit: f64 = T::epsilon().into();
    let small = (0..40).map(|step| unit * 0.3 * 10f64.powf(f64::from(step) * 0.4));
    let half_turn = core::f64::consts::PI;
    let near = (0..20).map(|step| half_turn - 10f64.powi(-step));
    for angle in small.filter(|&angle| angle < half_turn).chain(near).chain([0.5, 1.0, 2.0]) {
        for distance in [0.0, 1e-6, 0.3] {
            let [turned, shifted, in_world, shifted_in_world] = sweep::<T>(angle, distance);
            let bound = 4.0;
            assert!(turned < bound && in_world < bound, "{angle:e}: {turned} {in_world}");
            assert!(shifted < 2.0 * bound, "{angle:e}, {distance:e}: {shifted}");
            assert!(shifted_in_world < 1.0, "{angle:e}, {distance:e}: {shifted_in_world}");
        }
    }
}

#[test]
fn it_leads_from_pose_to_pose() {
    is_accurate::<f64>();
    is_accurate::<f32>();
}

/// Quaternions that differ in their last bits only.
#[test]
fn the_last_bits_of_a_reading_count() {
    let mut dice = Dice::of(5);
    for _ in 0..2000 {
        let [from, mut to] = pair::<f32>(&mut dice, 0.0, 0.0);
        let bump = (dice.within(4.0).abs() as usize).min(3);
        to.quaternion[bump] = f32::from_bits(to.quaternion[bump].to_bits() + 1);
        let [turned, _, in_world, _] = errors(from, to);
        assert!(turned < 4.0 && in_world < 4.0, "{turned} {in_world}");
    }
}

/// `q` and `−q`, and quaternions of other lengths, are the same orientation.
#[test]
fn the_sign_and_the_length_of_a_quaternion_do_not_matter() {
    let mut dice = Dice::of(6);
    for _ in 0..2000 {
        let angle = dice.within(3.2);
        let [from, to] = pair::<f64>(&mut dice, angle, 0.2);
        let times = |numbers: Numbers<f64>, factor: f64| Numbers {
            quaternion: numbers.quaternion.map(|number| number * factor),
            ..numbers
        };
        let whole = Screw::<f64, BodyAxes>::between(&from.pose(), &to.pose());
        for (one, other) in [(-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0), (4.0, 4.0), (-0.5, 0.5)] {
            let (from, to) = (times(from, one).pose(), times(to, other).pose());
            assert_eq!(Screw::<f64, BodyAxes>::between(&from, &to), whole);
        }
        // The difference of quaternions of different lengths is no smaller than they are: relative to sin(θ/2) its
        // rounding is up to (|q₀| + |q₁|) / |q₁| times as large.
        let [turned, shifted, ..] = errors(times(from, 3.0), times(to, 1.0 / 7.0));
        let bound = 4.0 * 22.0 / whole.rotation.norm().min(1.0);
        assert!(turned < bound && shifted < bound, "{turned} {shifted} at {angle}");
    }
}

/// Past half a turn the nearer way is the other one.
#[test]
fn it_is_the_shorter_way() {
    let turned = |angle: f64| Pose::from(Isometry3::rotation(Vector3::z() * angle));
    for (to, expected) in
        [(3.1, 3.1), (3.2, 3.2 - core::f64::consts::TAU), (6.2, 6.2 - core::f64::consts::TAU)]
    {
        let moved = Screw::<f64, WorldAxes>::between(&turned(0.0), &turned(to));
        assert!((moved.rotation.z - expected).abs() < 4e-15, "{to}");
    }
    let mut last = turned(0.0);
    for tick in 1..10_000 {
        let now = turned(f64::from(tick) * 0.01);
        let moved = Screw::<f64, WorldAxes>::between(&last, &now);
        assert!((moved.rotation.z - 0.01).abs() < 1e-12, "tick {tick}");
        last = now;
    }
}

#[test]
fn nalgebra_agrees() {
    let mut dice = Dice::of(7);
    for _ in 0..2000 {
        let (from, to): (Pose<f64>, Pose<f64>) = (dice.pose(), dice.pose());
        let (one, other) = (Isometry3::from(from), Isometry3::from(to));
        let expected = (other.rotation * one.rotation.inverse()).scaled_axis();
        let world = Screw::<f64, WorldAxes>::between(&from, &to);
        let near_half_turn = (expected.norm() - core::f64::consts::PI).abs() < 1e-6;
        assert!(near_half_turn || (world.rotation - expected).norm() < 1e-13);
        let seen: Screw<f64, BodyAxes> = world.along(&from);
        let body = Screw::<f64, BodyAxes>::between(&from, &to);
        assert!((seen.rotation - body.rotation).norm() < 1e-14);
        let point = Vector3::new(0.1, -0.2, 0.3);
        assert!((from.point(point) - (one * nalgebra::Point3::from(point)).coords).norm() < 1e-15);
        assert!((from.to_body(from.to_world(point)) - point).norm() < 1e-15);
        let both = Isometry3::from(from.then(&to));
        assert!((both.to_matrix() - (one * other).to_matrix()).norm() < 1e-14);
    }
}

/// Moving by a displacement is the exponential, and the way back is the logarithm.
fn moves<T: Real>() {
    let unit: f64 = T::epsilon().into();
    let mut dice = Dice::of(8);
    for step in 0..4000 {
        let size = 10f64.powf(-f64::from(step % 80) / 10.0);
        let [from, _] = pair::<T>(&mut dice, 1.0, 0.0);
        let by = Screw::<T, BodyAxes>::new(
            dice.vector(size),
            (dice.direction() * size * 3.0).map(T::of),
        );
        let there = by.moving(&from.pose());
        let led = from.matrix() * exponential(wide(by.translation), wide(by.rotation));
        let found = Isometry3::from(there);
        let numbers: [T; 4] = found.rotation.into_inner().coords.into();
        let reached = motion(wide(found.translation.vector), quaternion(numbers));
        let (turned, shifted) = apart(&led, &reached);
        assert!(turned < 8.0 * unit && shifted < 8.0 * unit, "{size}: {turned:e} {shifted:e}");
        let back = Screw::<T, BodyAxes>::between(&from.pose(), &there) - by;
        let [along, about] =
            [back.translation, back.rotation].map(|part| part.map(Into::into).norm());
        assert!(along < 16.0 * unit && about < 8.0 * unit, "{size}: {along:e} {about:e}");

        let by: Screw<T, WorldAxes> = Screw::new(by.translation, by.rotation);
        let back = Screw::<T, WorldAxes>::between(&from.pose(), &by.moving(&from.pose())) - by;
        let [along, about] =
            [back.translation, back.rotation].map(|part| part.map(Into::into).norm());
        assert!(along < 2.0 * unit && about < 8.0 * unit, "{size}: {along:e} {about:e}");
    }
}

#[test]
fn moving_is_the_exponential() {
    moves::<f64>();
    moves::<f32>();
}

/// A constant twist, in closed form: a body that slides along x at 0.3 m/s and turns about z at 2 rad/s is on a circle.
#[test]
fn a_constant_twist_is_found_exactly() {
    let (speed, rate) = (0.3, 2.0);
    let at = |time: f64| {
        let (sine, cosine) = f64::sin_cos(rate * time);
        let place = Vector3::new(sine, 1.0 - cosine, 0.0) * (speed / rate);
        Pose::from(Isometry3::new(place, Vector3::z() * (rate * time)))
    };
    for period in [1e-6, 1e-3, 0.1, 1.0, 1.5] {
        let moved = Screw::<f64, BodyAxes>::between(&at(0.4), &at(0.4 + period));
        let expected = Screw::<f64, BodyAxes>::new(
            Vector3::x() * (speed * period),
            Vector3::z() * (rate * period),
        );
        let error = moved - expected;
        let most = error.translation.norm().max(error.rotation.norm());
        assert!(most < 4e-16, "{period}: {most:e}");
    }
}

#[test]
fn what_is_not_finite_is_told() {
    let pose = Pose::at(Vector3::new(0.0, 0.0, 0.0));
    let nothing = pose_of([0.0; 4]);
    let bad = pose_of([f64::NAN, 0.0, 0.0, 1.0]);
    for other in [nothing, bad, Pose::at(Vector3::new(f64::INFINITY, 0.0, 0.0))] {
        for moved in [Screw::<f64, BodyAxes>::between(&pose, &other), Screw::between(&other, &pose)]
        {
            let sum = moved.translation.sum() + moved.rotation.sum();
            assert!(!sum.is_finite());
        }
    }
    let still = Screw::<f64, BodyAxes>::between(&pose, &pose);
    assert_eq!(still, Screw::default());
}

fn pose_of(numbers: [f64; 4]) -> Pose<f64> {
    pose(Vector3::zeros(), numbers)
}
