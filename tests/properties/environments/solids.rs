//! Solids: what enters is pushed out, by the nearest point of the surface.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use nalgebra::{SVector, Vector2, Vector3};
use proptest::array::uniform16;
use proptest::prelude::any;
use proptest::prop_assert;
use proptest::test_runner::TestCaseResult;

use lyapunov::lanes::{AutoF32x8, AutoF64x4, AutoF64x8};
use lyapunov::{
    LyapunovCandidate, OnePort, PortSample, Scalar, Signal,
    environments::{Contact, Cuboid, Plane, Solid, Sphere, Wall},
};

use super::models::each;
use crate::support::{Bits, CASES, Real, bad, hold, hostile, log_between, same, unit};

/// Parameters of solids, and a motion near them.
#[derive(Clone, Copy, Debug)]
struct Parts<T: Scalar, const N: usize> {
    center: SVector<T, N>,
    /// A normal, or half the edges: no axis is 0.
    edges: SVector<T, N>,
    radius: T,
    stiffness: T,
    damping: T,
    sample: PortSample<SVector<T, N>>,
}

impl<T: Scalar, const N: usize> Parts<T, N> {
    fn of(bits: &[Bits; 16], first: usize) -> Self {
        let vector = |at: usize, scale: f64| {
            SVector::from_fn(|axis, _| {
                each(bits[at + axis], first, |bits| scale * (unit(bits) - 0.5))
            })
        };
        let log = |at: usize, least: f64, most: f64| {
            each(bits[at], first, |bits| log_between(bits, least, most))
        };
        let center = vector(0, 1.0);
        let period = T::of(1e-3);
        Self {
            center,
            edges: SVector::from_fn(|axis, _| log(3 + axis, 0.02, 0.2)),
            radius: log(6, 0.02, 0.3),
            stiffness: log(7, 10.0, 1e4),
            damping: log(8, 0.1, 100.0),
            sample: PortSample::starting(period, center + vector(9, 0.3), vector(12, 4.0)),
        }
    }

    fn plane(&self) -> Plane<SVector<T, N>> {
        Plane::new(self.center, self.edges).expect("a plane")
    }

    fn sphere(&self) -> Sphere<SVector<T, N>> {
        Sphere::new(self.center, self.radius).expect("a sphere")
    }

    fn cuboid(&self) -> Cuboid<SVector<T, N>> {
        Cuboid::new(self.center, self.edges).expect("a box")
    }

    fn contact<S>(&self, solid: S) -> Contact<S, T> {
        Contact::with(solid, self.stiffness, self.damping).expect("a contact")
    }
}

fn wide<T: Scalar, const N: usize>(of: SVector<T, N>) -> [f64; N] {
    std::array::from_fn(|axis| of[axis].lane(0))
}

/// Depth and normal in straight `f64`: of a plane, a ball and a box, seen from `from` their center.
fn nearest<const N: usize>(which: usize, from: [f64; N], edges: [f64; N], radius: f64) -> Seen<N> {
    let length = |of: [f64; N]| of.iter().map(|x| x * x).sum::<f64>().sqrt();
    match which {
        0 => {
            let normal = edges.map(|x| x / length(edges));
            (-(0..N).map(|axis| from[axis] * normal[axis]).sum::<f64>(), normal)
        }
        1 => (radius - length(from), from.map(|x| x / length(from))),
        _ => {
            // Each face is a plane; the nearest one decides.
            let faces = (0..N).flat_map(|axis| [(axis, 1.0), (axis, -1.0)]);
            let distance = |(axis, side): (usize, f64)| edges[axis] - side * from[axis];
            let nearest =
                faces.min_by(|a, b| distance(*a).total_cmp(&distance(*b))).expect("a face");
            let normal = std::array::from_fn(|axis| match axis == nearest.0 {
                true => nearest.1,
                false => 0.0,
            });
            (distance(nearest), normal)
        }
    }
}

type Seen<const N: usize> = (f64, [f64; N]);

fn follows<T: Real, S: Solid<SVector<T, N>> + Copy, const N: usize>(
    which: usize,
    solid: impl Fn(&Parts<T, N>) -> S,
) {
    hold(CASES, uniform16(any::<Bits>()), |bits| {
        let parts = Parts::<T, N>::of(&bits, 0);
        let (x, v, c) =
            (wide(parts.sample.position), wide(parts.sample.velocity), wide(parts.center));
        let from: [f64; N] = std::array::from_fn(|axis| x[axis] - c[axis]);
        let (k, b) = (parts.stiffness.f64(), parts.damping.f64());
        let (depth, normal) = nearest(which, from, wide(parts.edges), parts.radius.f64());
        let leaving: f64 = (0..N).map(|axis| v[axis] * normal[axis]).sum();
        // Lengths and velocities are below one and four; near an edge, or the middle of a ball, rounding decides the
        // normal.
        let slack = 64.0 * T::unit();
        let distance = from.iter().fold(0.0, |sum, x| sum + x * x).sqrt();
        let turned = if which == 1 { slack / distance } else { slack };
        let mut by_axis: Vec<f64> =
            (0..N).map(|axis| parts.edges[axis].f64() - from[axis].abs()).collect();
        by_axis.sort_by(f64::total_cmp);
        let undecided =
            which == 2 && (by_axis[1] - by_axis[0] < slack || from.iter().any(|x| x.abs() < slack));
        if depth.abs() < slack || turned > 1e-3 || undecided {
            return Ok(());
        }
        let push = if depth > 0.0 { f64::max(0.0, k * depth - b * leaving) } else { 0.0 };
        let contact = parts.contact(solid(&parts));
        let (mut port, mut term) = (contact, contact.dissipation());
        let effort = wide(port.respond(&parts.sample));
        let off = slack * (k + 4.0 * b) + turned * (k * depth.abs() + 8.0 * b);
        for axis in 0..N {
            let exact = -push * normal[axis];
            prop_assert!(
                abs_diff_eq!(effort[axis], exact, epsilon = off),
                "{effort:?}, {axis}: {exact:e}"
            );
        }
        let burnt = if depth > 0.0 { b * leaving * leaving * 1e-3 } else { 0.0 };
        let credit = term.decrease(&parts.sample).f64();
        let off = (slack + turned) * b * 16.0 * 1e-3;
        prop_assert!(abs_diff_eq!(credit, burnt, epsilon = off), "credit {credit:e} for {burnt:e}");
        prop_assert!(depth > 0.0 || (credit == 0.0 && effort == [0.0; N]), "out of contact");
        Ok(())
    });
}

mod check {
    use super::*;

    pub(super) fn plane<T: Real>() {
        follows::<T, _, 2>(0, Parts::plane);
        follows::<T, _, 3>(0, Parts::plane);
    }

    pub(super) fn sphere<T: Real>() {
        follows::<T, _, 2>(1, Parts::sphere);
        follows::<T, _, 3>(1, Parts::sphere);
    }

    pub(super) fn cuboid<T: Real>() {
        follows::<T, _, 2>(2, Parts::cuboid);
        follows::<T, _, 3>(2, Parts::cuboid);
    }

    /// A plane that faces `−x` is the wall, in effort and credit, bit for bit, whatever the motion along it.
    pub(super) fn facing_back_a_plane_is_the_wall<T: Real>() {
        hold(CASES, uniform16(any::<Bits>()), |bits| {
            let Parts { center, stiffness, damping, sample, .. } = Parts::<T, 2>::of(&bits, 0);
            let facing = Vector2::new(-parts_length::<T>(bits[15]), T::of(0.0));
            let plane = Plane::new(center, facing).expect("a plane");
            let mut contact = Contact::with(plane, stiffness, damping).expect("a contact");
            let mut wall = Wall::new(stiffness, damping).expect("a wall").at(center[0]);
            let alone = PortSample::starting(sample.period, sample.position[0], sample.velocity[0]);
            let effort = contact.respond(&sample);
            prop_assert!(effort[0] == wall.respond(&alone) && effort[1] == T::of(0.0));
            let (mut one, mut other) = (contact.dissipation(), wall.dissipation());
            prop_assert!(one.decrease(&sample) == other.decrease(&alone));
            Ok(())
        });
    }

    /// The length of a normal, from the smallest number to the largest.
    fn parts_length<T: Real>(bits: Bits) -> T {
        match hostile::<T>(bits).magnitude() {
            length if length > T::of(0.0) => length,
            _ => T::largest(),
        }
    }

    /// With a NaN on any axis no effort passes for a number.
    pub(super) fn nan_on_an_axis_is_not_hidden<T: Real>() {
        hold(CASES, uniform16(any::<Bits>()), |bits| {
            let parts = Parts::<T, 3>::of(&bits, 0);
            let (axis, nan) = (bits[15] as usize % 3, T::of(f64::NAN));
            let PortSample { position, velocity, .. } = parts.sample;
            let mut unknown = position;
            unknown[axis] = nan;
            let mut alone = parts.center;
            alone[axis] = nan;
            let mut swift = velocity;
            swift[axis] = nan;
            for (position, velocity) in
                [(unknown, velocity), (alone, velocity), (alone, swift), (parts.center, swift)]
            {
                let sample = PortSample { position, velocity, ..parts.sample };
                let lost = |effort: SVector<T, 3>| !effort.finite();
                prop_assert!(lost(parts.contact(parts.sphere()).respond(&sample)), "{sample:?}");
                let boxed = parts.contact(parts.cuboid()).respond(&sample);
                let plane = parts.contact(parts.plane()).respond(&sample);
                // On the surface of a plane there is no contact, nor along the face of a box.
                prop_assert!(lost(boxed) || position == parts.center, "{sample:?}");
                prop_assert!(lost(plane) || position == parts.center, "{sample:?}");
            }
            Ok(())
        });
    }
}

crate::support::every_real!(
    plane,
    sphere,
    cuboid,
    facing_back_a_plane_is_the_wall,
    nan_on_an_axis_is_not_hidden,
);

fn lanes_equal<L: Scalar, R: Real, const N: usize>() {
    fn one<L, R, S, Q, const N: usize>(
        bits: &[Bits; 16],
        solid: impl Fn(&Parts<L, N>) -> S,
        alone: impl Fn(&Parts<R, N>) -> Q,
    ) -> TestCaseResult
    where
        L: Scalar,
        R: Real,
        S: Solid<SVector<L, N>> + Copy,
        Q: Solid<SVector<R, N>> + Copy,
    {
        let spoil = |bits: Bits, first: usize| match bits % 8 {
            0 => each::<L>(bits, first, |bits| bad::<R>(bits >> 3).f64()),
            1 => each::<L>(bits, first, |bits| hostile::<R>(bits >> 3).f64()),
            _ => L::of(0.0),
        };
        let mut parts = Parts::<L, N>::of(bits, 0);
        let spoilt = spoil(bits[15], 0);
        parts.sample.position[0] += spoilt;
        let contact = parts.contact(solid(&parts));
        let effort = { contact }.respond(&parts.sample);
        let credit = contact.dissipation().decrease(&parts.sample);
        for lane in 0..L::LANES {
            let mut parts = Parts::<R, N>::of(bits, lane);
            parts.sample.position[0] += R::of(spoilt.lane(lane));
            let contact = parts.contact(alone(&parts));
            let expected = { contact }.respond(&parts.sample);
            for axis in 0..N {
                prop_assert!(same(effort[axis].lane(lane), expected[axis].f64()), "lane {lane}");
            }
            let expected = contact.dissipation().decrease(&parts.sample).f64();
            prop_assert!(same(credit.lane(lane), expected), "credit of lane {lane}");
        }
        Ok(())
    }
    hold(CASES / 10, uniform16(any::<Bits>()), |bits| {
        one::<L, R, _, _, N>(&bits, Parts::plane, Parts::plane)?;
        one::<L, R, _, _, N>(&bits, Parts::sphere, Parts::sphere)?;
        one::<L, R, _, _, N>(&bits, Parts::cuboid, Parts::cuboid)
    });
}

#[test]
fn lanes() {
    lanes_equal::<AutoF64x4, f64, 2>();
    lanes_equal::<AutoF64x8, f64, 3>();
    lanes_equal::<AutoF32x8, f32, 3>();
}

/// A vector turned about an axis through the origin by an angle with this sine and cosine.
fn turned(of: Vector3<f64>, about: usize, (sine, cosine): (f64, f64)) -> Vector3<f64> {
    let (one, other) = ((about + 1) % 3, (about + 2) % 3);
    let mut turned = of;
    turned[one] = cosine * of[one] - sine * of[other];
    turned[other] = sine * of[one] + cosine * of[other];
    turned
}

/// Turning the scene turns the answer, and leaves the credit as it is.
#[test]
fn the_frame_does_not_matter() {
    hold(CASES, uniform16(any::<Bits>()), |bits| {
        let parts = Parts::<f64, 3>::of(&bits, 0);
        let about = bits[15] as usize % 3;
        let turn = |of: Vector3<f64>| turned(of, about, (6.0 * unit(bits[15])).sin_cos());
        let Parts { center, edges, sample, .. } = parts;
        let (position, velocity) = (turn(sample.position), turn(sample.velocity));
        let moved = Parts {
            center: turn(center),
            edges: turn(edges),
            sample: PortSample { position, velocity, ..sample },
            ..parts
        };
        let off = (sample.position - center).norm().min(1.0) * 1e-12;
        for (mut one, mut other, depth) in [
            (
                Box::new(parts.contact(parts.plane())) as Box<dyn OnePort<Vector3<f64>>>,
                Box::new(moved.contact(moved.plane())) as Box<dyn OnePort<Vector3<f64>>>,
                parts.plane().nearest(sample.position).depth,
            ),
            (
                Box::new(parts.contact(parts.sphere())),
                Box::new(moved.contact(moved.sphere())),
                parts.sphere().nearest(sample.position).depth,
            ),
        ] {
            if depth.abs() < 1e-12 || off < 1e-15 {
                continue;
            }
            let (a, b) = (turn(one.respond(&sample)), other.respond(&moved.sample));
            let size = parts.stiffness + 4.0 * parts.damping;
            prop_assert!((a - b).norm() <= 1e-12 * size, "{a} is not {b}");
        }
        Ok(())
    });
}

/// At the center `+x`; in a box the first of equal axes, and in the middle of it the side `+`.
#[test]
fn ties_of_the_nearest_face() {
    let ball = Sphere::new(Vector3::new(1.0, 2.0, 3.0), 0.5).expect("a ball");
    let middle = ball.nearest(Vector3::new(1.0, 2.0, 3.0));
    assert_eq!((middle.depth, middle.normal), (0.5, Vector3::x()));
    let cube = Cuboid::new(Vector3::zeros(), Vector3::repeat(1.0)).expect("a cube");
    for (at, depth, normal) in [
        (Vector3::zeros(), 1.0, Vector3::x()),
        (-Vector3::zeros(), 1.0, Vector3::x()),
        (Vector3::new(0.0, -0.5, 0.5), 0.5, -Vector3::y()),
        (Vector3::new(-0.5, 0.5, 0.5), 0.5, -Vector3::x()),
        (Vector3::new(0.25, 0.5, -0.75), 0.25, -Vector3::z()),
    ] {
        let found = cube.nearest(at);
        assert_eq!((found.depth, found.normal), (depth, normal), "at {at}");
    }
    let flat = Cuboid::new(Vector2::zeros(), Vector2::new(2.0, 0.5)).expect("a slab");
    assert_eq!(flat.nearest(Vector2::zeros()).normal, Vector2::y());
}

/// The surface itself is outside, its inner neighbour inside; a solid does not pull on a point that leaves fast.
#[test]
fn contact_is_strict_and_only_pushes() {
    let ball = Sphere::new(Vector2::zeros(), 0.5).expect("a ball");
    let mut contact = Contact::with(ball, 1e3, 10.0).expect("a contact");
    let inner = f64::from_bits(0.5f64.to_bits() - 1);
    for (x, v, force) in
        [(0.5, -1.0, 0.0), (inner, -1.0, -10.0), (0.4, 11.0, 0.0), (0.4, 0.0, -1e2)]
    {
        let sample = PortSample::starting(1e-3, Vector2::new(x, 0.0), Vector2::new(v, 0.0));
        let effort = contact.respond(&sample);
        assert!((effort - Vector2::new(force, 0.0)).norm() < 1e-10, "{effort} at {x}");
        let burnt: f64 = if x < 0.5 { 10.0 * v * v * 1e-3 } else { 0.0 };
        assert_abs_diff_eq!(contact.dissipation().decrease(&sample), burnt, epsilon = 1e-15);
    }
}

/// A normal is a direction, however long or short it was given.
#[test]
fn lengths_beyond_the_range_of_a_square() {
    for size in [5e-324, 1e-200, 1e200, f64::MAX] {
        let plane = Plane::new(Vector2::zeros(), Vector2::new(size, size)).expect("a plane");
        let normal = plane.nearest(Vector2::zeros()).normal;
        assert!((normal - Vector2::repeat(0.5f64.sqrt())).norm() < 1e-15, "{size:e}: {normal}");
        let ball = Sphere::new(Vector2::zeros(), 1.0).expect("a ball");
        let seen = ball.nearest(Vector2::new(size.min(1e300), 0.0));
        assert_eq!((seen.normal, seen.depth), (Vector2::x(), 1.0 - size.min(1e300)));
    }
}
