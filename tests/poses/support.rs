//! Random poses, and rigid motions with thirty digits.

use lyapunov::{
    Scalar,
    accumulators::DoubleDouble,
    poses::{Angle, Axes, Pose, Screw},
};
use nalgebra::{Matrix3, Matrix4, Quaternion, UnitQuaternion, Vector3, Vector4};

pub(crate) use crate::dice::Dice;

/// One value at a time.
pub(crate) trait Real: Angle + Into<f64> {}

impl Real for f32 {}
impl Real for f64 {}

impl Dice {
    pub(crate) fn vector<T: Scalar>(&mut self, size: f64) -> Vector3<T> {
        Vector3::from_fn(|_, _| T::of(self.within(size)))
    }

    /// Of length 1, in every direction alike enough.
    pub(crate) fn direction(&mut self) -> Vector3<f64> {
        loop {
            let some: Vector3<f64> = self.vector(1.0);
            if (0.1..1.0).contains(&some.norm()) {
                return some.normalize();
            }
        }
    }

    pub(crate) fn screw<T: Scalar, F: Axes>(&mut self, along: f64, about: f64) -> Screw<T, F> {
        Screw::new(self.vector(along), self.vector(about))
    }

    /// A pose anywhere within 1 m.
    pub(crate) fn pose<T: Scalar>(&mut self) -> Pose<T> {
        let position = self.vector(1.0);
        let turn = UnitQuaternion::from_scaled_axis(self.direction() * self.within(3.1));
        pose(position, turn.into_inner().coords.into())
    }
}

/// The pose of a position and a quaternion `(i, j, k, w)`, rounded and not normalized afterwards.
pub(crate) fn pose<T: Scalar>(position: Vector3<T>, [i, j, k, w]: [f64; 4]) -> Pose<T> {
    let numbers = Vector4::new(i, j, k, w).map(T::of);
    Pose::new(position, UnitQuaternion::new_unchecked(Quaternion::from(numbers)))
}

/// The numbers of a quaternion, `(i, j, k, w)`, as they were given to [`pose`].
pub(crate) fn quaternion<T: Real>(numbers: [T; 4]) -> [f64; 4] {
    numbers.map(Into::into)
}

pub(crate) type Long = DoubleDouble;

fn long<const N: usize>(numbers: [f64; N]) -> [Long; N] {
    numbers.map(Long::from)
}

fn hat([x, y, z]: [Long; 3]) -> Matrix3<Long> {
    let zero = Long::of(0.0);
    Matrix3::new(zero, -z, y, z, zero, -x, -y, x, zero)
}

fn identity<const N: usize>() -> nalgebra::SMatrix<Long, N, N> {
    nalgebra::SMatrix::from_fn(|row, column| Long::of(if row == column { 1.0 } else { 0.0 }))
}

/// The rotation of a quaternion of any length, `1 + 2 (w [v] + [v]²) / |q|²`.
pub(crate) fn rotation(quaternion: [f64; 4]) -> Matrix3<Long> {
    let [i, j, k, w] = long(quaternion);
    let cross = hat([i, j, k]);
    let twice = Long::of(2.0) / (i * i + j * j + k * k + w * w);
    identity() + (cross * w + cross * cross).map(|entry| entry * twice)
}

/// The rigid motion of a position and a quaternion.
pub(crate) fn motion(position: [f64; 3], quaternion: [f64; 4]) -> Matrix4<Long> {
    joined(rotation(quaternion), Vector3::from(long(position)))
}

fn joined(turn: Matrix3<Long>, shift: Vector3<Long>) -> Matrix4<Long> {
    let mut whole = identity::<4>();
    whole.fixed_view_mut::<3, 3>(0, 0).copy_from(&turn);
    whole.fixed_view_mut::<3, 1>(0, 3).copy_from(&shift);
    whole
}

/// `exp` of the twist `(v, ω)`, by the series of the exponential of its matrix, scaled by 2¹⁰ and squared ten times.
pub(crate) fn exponential(translation: [f64; 3], rotation: [f64; 3]) -> Matrix4<Long> {
    let scale = Long::of(2f64.powi(-10));
    let mut twist = Matrix4::from_element(Long::of(0.0));
    twist.fixed_view_mut::<3, 3>(0, 0).copy_from(&hat(long(rotation)));
    twist.fixed_view_mut::<3, 1>(0, 3).copy_from(&Vector3::from(long(translation)));
    let twist = twist.map(|entry| entry * scale);
    let (mut sum, mut term) = (identity::<4>(), identity::<4>());
    for order in 1..16 {
        term = (term * twist).map(|entry| entry / Long::of(f64::from(order)));
        sum += term;
    }
    for _ in 0..10 {
        sum *= sum;
    }
    sum
}

/// The angle between two rotations that are near each other, rad, and the distance of the positions.
pub(crate) fn apart(one: &Matrix4<Long>, other: &Matrix4<Long>) -> (f64, f64) {
    let change = one - other;
    let square = |rows: usize, first: usize, columns: usize| {
        let view = change.view((0, first), (rows, columns));
        view.iter().map(|entry| entry.high() * entry.high()).sum::<f64>()
    };
    (square(3, 0, 3).sqrt() / 2f64.sqrt(), square(3, 3, 1).sqrt())
}

pub(crate) fn wide<T: Real>(vector: Vector3<T>) -> [f64; 3] {
    vector.map(Into::into).into()
}
