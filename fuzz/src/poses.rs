//! Fuzz of the arithmetic of poses, and of readings of them.

use lyapunov_core::{
    Axes, BodyAxes, CheckedSample, Clocked, Differenced, Jacobian, PortSample, Pose, PoseTrack,
    Poses, Reading, Readings, Scalar, Screw, Signal, Snapshot, TaskPort, WithPose, WorldAxes,
};
use nalgebra::{Quaternion, UnitQuaternion, Vector2, Vector3};

use crate::tick::signal;
use crate::{Bytes, Real};

/// Poses, twists and wrenches of any numbers.
///
/// The first byte chooses the scalar and the axes.
pub fn poses(bytes: &[u8]) {
    let [kind, rest @ ..] = bytes else { return };
    let mut rest = Bytes::of(rest);
    match kind % 4 {
        0 => run::<f64, WorldAxes>(&mut rest),
        1 => run::<f64, BodyAxes>(&mut rest),
        2 => run::<f32, WorldAxes>(&mut rest),
        _ => run::<f32, BodyAxes>(&mut rest),
    }
}

fn run<T: Real, F: Axes>(bytes: &mut Bytes<'_>) {
    let start = pose::<T>(bytes);
    let mut readings = Track::<T, F>::starting(start, bytes);
    let mut last = start;
    while !bytes.at_end() {
        let next = pose::<T>(bytes);
        moves::<T, F>(&last, &next);
        let ordinary = bytes.byte() % 4 != 0;
        let mut screw = || -> Screw<T, F> {
            if ordinary { Screw::default().map(|_| bytes.ordinary()) } else { signal(bytes) }
        };
        let (twist, wrench) = (screw(), screw());
        turns(&next, twist.rotation);
        carries::<T, F>(&next, twist, wrench);
        readings.read(&next, bytes);
        last = next;
    }
}

/// A pose of any numbers; often one of a body near the origin.
fn pose<T: Real>(bytes: &mut Bytes<'_>) -> Pose<T> {
    let ordinary = bytes.byte() % 4 != 0;
    let mut number = || if ordinary { bytes.ordinary() } else { bytes.number::<T>() };
    let position = Vector3::from([(); 3].map(|()| number()));
    let [i, j, k, w] = [(); 4].map(|()| number());
    Pose::new(position, UnitQuaternion::new_unchecked(Quaternion::new(w, i, j, k)))
}

/// Whether every number is 0 or of a size whose products and quotients stay in range.
fn sized<V: Signal<Scalar: Real>>(signal: V) -> bool {
    let (least, most) = (V::Scalar::of(1e-6), V::Scalar::of(1e6));
    let mut sized = true;
    signal.map(|axis| {
        let size = axis.magnitude();
        sized &= size == V::Scalar::of(0.0) || (size >= least && size <= most);
        axis
    });
    sized
}

/// The size of the largest number.
fn size<V: Signal<Scalar: Real>>(signal: V) -> V::Scalar {
    let mut most = V::Scalar::of(0.0);
    signal.map(|axis| {
        most = most.larger(axis.magnitude());
        axis
    });
    most
}

fn oriented<T: Real>(pose: &Pose<T>) -> bool {
    let numbers = pose.orientation().into_inner().coords;
    numbers.dot(&numbers) > T::of(0.5)
}

/// The same pose by a quaternion of length 1, for which accuracy is promised.
fn unit<T: Real>(pose: &Pose<T>) -> Pose<T> {
    Pose::new(pose.position, pose.orientation())
}

/// A displacement leads from one pose to the other, and its rotation is no more than half a turn.
fn moves<T: Real, F: Axes>(from: &Pose<T>, to: &Pose<T>) {
    let moved = Screw::<T, F>::between(from, to);
    let sound = sized(*from) && sized(*to) && oriented(from) && oriented(to);
    if !sound {
        // It may be anything, but no panic; and what is not finite does not pass for a displacement.
        let told = from.finite() && to.finite();
        assert!(told || !moved.finite(), "{from:?} {to:?} {moved:?}");
        return;
    }
    let (from, to) = (&unit(from), &unit(to));
    let moved = Screw::<T, F>::between(from, to);
    assert!(moved.finite(), "{from:?} {to:?} {moved:?}");
    let turn = moved.rotation.inner(moved.rotation).sqrt();
    // Half a turn and the roundings of an angle, of an axis' length and of this sum.
    let half = T::of(core::f64::consts::PI) * (T::of(1.0) + T::of(8.0) * T::epsilon());
    assert!(turn <= half, "{from:?} {to:?} {moved:?}");
    let back = moved.moving(from);
    let far = size(from.position).larger(size(to.position)).larger(T::of(1.0));
    let tolerance = T::of(256.0) * T::epsilon();
    let off = size(back.position - to.position);
    assert!(off <= far * tolerance, "{from:?} {to:?} {moved:?} {back:?}");
    let (there, here) = (back.orientation(), to.orientation());
    let same = there.into_inner().coords.dot(&here.into_inner().coords).magnitude();
    assert!(same >= T::of(1.0) - tolerance, "{from:?} {to:?} {moved:?} {back:?}");
}

/// Turned into the body and back, a vector is the same; and its length stays.
fn turns<T: Real>(pose: &Pose<T>, vector: Vector3<T>) {
    let back = pose.to_world(pose.to_body(vector));
    if !(sized(*pose) && sized(vector) && oriented(pose)) {
        return;
    }
    let tolerance = size(vector) * T::of(256.0) * T::epsilon();
    assert!(size(back - vector) <= tolerance, "{pose:?} {vector:?} {back:?}");
    let turned = pose.to_world(vector);
    let (before, after) = (vector.dot(&vector), turned.dot(&turned));
    let off = (before - after).magnitude();
    assert!(off <= tolerance * size(vector), "{pose:?} {vector:?} {turned:?}");
    let point = pose.point(vector);
    let whole = pose.then(&Pose::at(vector));
    assert!(point == whole.position, "{pose:?} {vector:?}");
}

/// Power is the same along any axes and on both sides of a Jacobian.
fn carries<T: Real, F: Axes>(pose: &Pose<T>, twist: Screw<T, F>, wrench: Screw<T, F>) {
    let jacobian: Jacobian<T, 2, F> = Jacobian::of([twist, wrench]);
    let mut port = TaskPort::starting(pose, &jacobian);
    let joints = PortSample::starting(T::of(1e-3), Vector2::zeros(), Vector2::zeros());
    let sample = port.tell(&joints, pose, &jacobian);
    let torques = port.torques(WithPose::of(wrench));
    if !(sized(*pose) && sized(twist) && sized(wrench) && oriented(pose)) {
        return;
    }
    assert!(sample.finite() && torques.finite(), "{pose:?} {twist:?} {wrench:?}");
    let power = twist.inner(wrench);
    let world = twist.along::<WorldAxes>(pose).inner(wrench.along::<WorldAxes>(pose));
    let scale = T::of(18.0) * size(twist) * size(wrench);
    let tolerance = scale * T::of(256.0) * T::epsilon();
    assert!((power - world).magnitude() <= tolerance, "{pose:?} {twist:?} {wrench:?}");
    assert!((torques[0] - power).magnitude() <= tolerance, "{pose:?} {twist:?} {wrench:?}");
}

type OfPoses<T, F> = Readings<WithPose<T, F>, Differenced, Clocked, Poses<T, F>>;

/// Readings of poses, and a track of the same.
struct Track<T: Real, F: Axes> {
    readings: OfPoses<T, F>,
    track: PoseTrack<T, F>,
    now: f64,
}

impl<T: Real, F: Axes> Track<T, F> {
    fn starting(pose: Pose<T>, bytes: &mut Bytes<'_>) -> Self {
        let period = T::of(1e-3);
        let readings = Readings::every(period).expect("a period").of_poses().clocked();
        Self { readings, track: PoseTrack::from(pose), now: bytes.number() }
    }

    /// What is accepted is finite; and the track that is restored goes on alike.
    fn read(&mut self, pose: &Pose<T>, bytes: &mut Bytes<'_>) {
        self.now = if bytes.byte() % 4 == 0 { bytes.number() } else { self.now + 1e-3 };
        let applied = WithPose::of(signal(bytes));
        let reading = Reading { position: *pose, applied };
        let CheckedSample { sample, accepted, .. } = self.readings.read_at(self.now, reading);
        let motion = [sample.position, sample.velocity, sample.displacement];
        let finite = motion.iter().all(|it| it.finite()) && sample.period.finite();
        assert!(!accepted || finite, "{pose:?} at {}: {sample:?}", self.now);

        let mut restored = self.track.restored(self.track.state()).expect("a finite track");
        let (told, again) = (self.track.tell(pose), restored.tell(pose));
        assert!(told.finite() == again.finite(), "{pose:?} {told:?} {again:?}");
        assert!(!told.finite() || told == again, "{pose:?} {told:?} {again:?}");
        let screw = self.track.state().0.screw;
        assert!(screw.finite(), "{pose:?} left {screw:?}");
    }
}
