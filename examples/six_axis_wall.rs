//! A six-axis device that meets a stiff wall with an edge: the force at the edge is a torque about the handle.
//!
//! ```text
//! pose ──▶ readings ──▶ wall at eight corners ── wrench ──▶ one sum, or one each for the parts ── effort ──▶ device
//! ```
//!
//! The handle is a box in a hand that presses it against the wall with 4 N. Its numbers are made up.

use lyapunov::{
    DampingLimit, OnePort, ParameterError, Plant, Popc, PortEnergy, PortSample, Reading, Readings,
    Signal, Stabilizer,
    bodies::{PlantExt, RigidBody, RigidParts},
    environments::{BodyPoints, Contact, Plane},
    poses::{BodyAxes, Pose, Screw, WithPose},
    readings::PartSpeeds,
    stabilizers::{BodyInertia, DirectedDamping, NoStabilizer, PartLimits, PerPart},
};
use nalgebra::{Isometry3, Vector3};

const PERIOD: f64 = 1e-3; // s
const MASS: f64 = 0.4; // kg
const HALF: Vector3<f64> = Vector3::new(0.06, 0.03, 0.02); // m: half the edges of the box
const STIFFNESS: f64 = 15_000.0; // N/m at each corner

type Sample = PortSample<WithPose<f64>>;

/// What is seen of two seconds.
#[derive(Default)]
struct Seen {
    /// Largest kinetic energy in each quarter of a second, mJ.
    kinetic: [f64; 8],
    /// Largest torque about the handle, N·m.
    torque: f64,
    /// Most energy that the port had given beyond what it took, mJ.
    given: f64,
}

fn moments() -> Vector3<f64> {
    let [x, y, z] = HALF.map(|half| half * half).into();
    Vector3::new(y + z, z + x, x + y) * (MASS / 3.0)
}

fn kinetic(sample: &Sample) -> f64 {
    let twist: Screw<f64, BodyAxes> = sample.velocity.screw.along(&sample.position.pose);
    let turning = moments().component_mul(&twist.rotation).dot(&twist.rotation);
    0.5 * (MASS * twist.translation.norm_squared() + turning)
}

fn run(mut stabilizer: impl Stabilizer<WithPose<f64>>) -> Result<Seen, ParameterError> {
    let side = |corner: usize, bit: usize| if corner & bit == 0 { -1.0 } else { 1.0 };
    let corners: [Vector3<f64>; 8] = core::array::from_fn(|corner| {
        HALF.component_mul(&Vector3::new(side(corner, 1), side(corner, 2), side(corner, 4)))
    });
    let floor = Plane::new(Vector3::zeros(), Vector3::z())?;
    let mut wall = BodyPoints::of(Contact::with(floor, STIFFNESS, 0.0)?, corners);

    let parts =
        RigidParts { mass: MASS, moments: moments(), damping: 1.0, rotational_damping: 5e-4 };
    let leaning = Isometry3::new(Vector3::new(0.0, 0.0, 0.04), Vector3::new(0.25, 0.0, 0.0));
    let pressing = WithPose::of(Screw::new(Vector3::new(0.0, 0.0, -4.0), Vector3::zeros()));
    let mut device = RigidBody::new(parts, PERIOD, 2)?
        .starting(Pose::from(leaning), Screw::default())
        .pushed(move |_| pressing);

    let fastest = PartSpeeds { translation: 5.0, rotation: 100.0 }; // m/s, rad/s
    let mut readings = Readings::every(PERIOD)?.of_poses().no_faster_than(fastest)?;
    let (mut now, mut applied) = (device.start(), WithPose::default());
    let (mut seen, mut taken) = (Seen::default(), 0.0);
    for tick in 0..2000 {
        // All that the controller has: the pose that is read and the wrench that acted.
        let reading = Reading { position: now.position.pose, applied };
        let sample = readings.read(reading).sample;
        applied = stabilizer.stabilize(&sample, wall.respond(&sample)).effort;

        taken += now.work.sum();
        seen.given = seen.given.max(-1e3 * taken);
        seen.torque = seen.torque.max(applied.screw.rotation.norm());
        let most = &mut seen.kinetic[tick / 250];
        *most = most.max(1e3 * kinetic(&now));
        now = device.advance(applied);
    }
    Ok(seen)
}

fn main() -> Result<(), ParameterError> {
    let inertia = BodyInertia { mass: MASS, moment: moments().min() };
    let limits = PartLimits::of_body(0.5, inertia, PERIOD)?;
    let unlimited = Popc::new(PortEnergy, DampingLimit::at(f64::INFINITY)?);
    let [moving, turning] =
        [limits.translation, limits.rotation].map(|it| Popc::new(PortEnergy, it));

    println!(
        "limits: {} N·s/m, {:.4} N·m·s/rad",
        limits.translation.most(),
        limits.rotation.most()
    );
    println!(
        "largest kinetic energy in each quarter of a second, mJ; torque, N·m; energy given, mJ"
    );
    let none = run(NoStabilizer)?;
    let one = run(DirectedDamping::within(unlimited, limits))?;
    let each = run(PerPart::of(moving, turning))?;
    for (name, seen) in [("none", &none), ("one sum", &one), ("one each", &each)] {
        println!("{name:9} {:9.3?} {:6.2} {:9.2}", seen.kinetic, seen.torque, seen.given);
    }
    assert!(none.kinetic[7] > 2.0 * none.kinetic[0] && none.torque > 1.0, "it is thrown about");
    for seen in [one, each] {
        assert!(seen.kinetic[7] < 0.5 * seen.kinetic[0], "it comes to rest");
        assert!(seen.given < 0.05 * none.given, "little is given beyond what was taken");
    }
    Ok(())
}
