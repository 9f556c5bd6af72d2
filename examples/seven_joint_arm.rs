//! A seven-joint arm that is pushed against a stiff virtual table, through its Jacobian.
//!
//! ```text
//! joints ─ Δq, τ ─▶ task port ─ ΔX, F ─▶ table, stabilizer within the inertia of the posture ─ F ─▶ Jᵀ F ─ τ ─▶ joints
//! ```
//!
//! The arm is a Franka Emika Panda. Its kinematics are the maker's table of Denavit-Hartenberg parameters; masses and
//! inertias are those that Gaz, Cognetti, Oliva, Robuffo Giordano and De Luca identified (IEEE Robotics and Automation
//! Letters 4(4), 2019). The joints' friction, the tool and the task are made up. Gravity is compensated.

use core::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use lyapunov::{
    DampingLimit, HeldTick, OnePort, ParameterError, Popc, PortEnergy, PortSample, Stabilizer,
    environments::{BodyPoints, Contact, Plane},
    integrators::{Integrator, RungeKutta4, State},
    models::{ArmLink, SerialArm},
    poses::{Pose, Screw, TaskPort},
    stabilizers::{BodyInertia, DirectedDamping, Inertia, InertiaLimit, PartLimits, TaskInertia},
};
use nalgebra::{Matrix3, SVector, Vector3};

const PERIOD: f64 = 1e-3; // s
const FRICTION: f64 = 0.5; // N·m·s/rad in each joint
const PUSH: Vector3<f64> = Vector3::new(0.0, 0.0, -20.0); // N

type Joints = SVector<f64, 7>;

/// Length, twist, offset; mass; centre; inertia xx, yy, zz, xy, xz, yz. SI units.
type Row = ([f64; 3], f64, [f64; 3], [f64; 6]);

#[rustfmt::skip]
const PANDA: [Row; 7] = [
    ([0.0, 0.0, 0.333], 4.970684, [3.875e-3, 2.081e-3, -0.04762],
        [0.70337, 0.70661, 9.117e-3, -1.39e-4, 6.772e-3, 0.019169]),
    ([0.0, -FRAC_PI_2, 0.0], 0.646926, [-3.141e-3, -0.02872, 3.495e-3],
        [7.962e-3, 0.02811, 0.025995, -3.925e-3, 0.010254, 7.04e-4]),
    ([0.0, FRAC_PI_2, 0.316], 3.228604, [0.027518, 0.039252, -0.066502],
        [0.037242, 0.036155, 0.01083, -4.761e-3, -0.011396, -0.012805]),
    ([0.0825, FRAC_PI_2, 0.0], 3.587895, [-0.05317, 0.104419, 0.027454],
        [0.025853, 0.019552, 0.028323, 7.796e-3, -1.332e-3, 8.641e-3]),
    ([-0.0825, -FRAC_PI_2, 0.384], 1.225946, [-0.011953, 0.041065, -0.038437],
        [0.035549, 0.029474, 8.627e-3, -2.117e-3, -4.037e-3, 2.29e-4]),
    ([0.0, FRAC_PI_2, 0.0], 1.666555, [0.060149, -0.014117, -0.010517],
        [1.964e-3, 4.354e-3, 5.433e-3, 1.09e-4, -1.158e-3, 3.41e-4]),
    ([0.088, FRAC_PI_2, 0.0], 0.735522, [0.010517, -4.252e-3, 0.061597],
        [0.012516, 0.010027, 4.815e-3, -4.28e-4, -1.196e-3, -7.41e-4]),
];

fn panda() -> Result<SerialArm<f64, 7>, ParameterError> {
    let links = PANDA.map(|([length, twist, offset], mass, centre, [xx, yy, zz, xy, xz, yz])| {
        let inertia = Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
        ArmLink { length, twist, offset, mass, centre: centre.into(), inertia }
    });
    let flange = Pose::at(Vector3::z() * 0.107);
    SerialArm::new(links, flange)
}

/// What is seen of two seconds.
struct Seen {
    /// Largest speed of the tool in each quarter of a second, mm/s.
    speeds: [f64; 8],
    /// Least and largest apparent mass along the motion, kg.
    masses: [f64; 2],
}

fn run(cap: f64) -> Result<Seen, ParameterError> {
    let arm = panda()?;
    let angles = [0.0, -FRAC_PI_4, 0.0, -3.0 * FRAC_PI_4, 0.0, FRAC_PI_2, FRAC_PI_4];
    let mut state = State { position: Joints::from(angles), velocity: Joints::zeros() };
    let start = arm.at(state.position);
    let surface = start.tool().position - Vector3::z() * 0.005; // 5 mm below the tool
    let table = Contact::with(Plane::new(surface, Vector3::z())?, 40_000.0, 0.0)?;
    let mut table = BodyPoints::of(table, [Vector3::y() * 0.04, Vector3::y() * -0.04]); // an edge

    // One sum; damping is shared as by a body of 1 kg and 0.01 kg·m², and limited by the arm's own inertia.
    let body = BodyInertia { mass: 1.0, moment: 0.01 };
    let unlimited = Popc::new(PortEnergy, DampingLimit::at(f64::INFINITY)?);
    let shared = DirectedDamping::within(unlimited, PartLimits::of_body(1e3, body, PERIOD)?);
    let inertia = TaskInertia::new(&start.jacobian(), start.inertia())?;
    let mut popc = InertiaLimit::new(shared, inertia, cap, PERIOD)?;
    let mut port = TaskPort::starting(start.tool(), &start.jacobian());

    let mut joints = PortSample::starting(PERIOD, state.position, state.velocity);
    let mut seen = Seen { speeds: [0.0; 8], masses: [f64::INFINITY, 0.0] };
    for tick in 0..2000 {
        let posture = arm.at(state.position);
        let jacobian = posture.jacobian();
        let inertia = TaskInertia::new(&jacobian, posture.inertia())?;
        popc.tell(inertia);
        let sample = port.tell(&joints, posture.tool(), &jacobian);
        let effort = popc.stabilize(&sample, table.respond(&sample)).effort;
        let torque = port.torques(effort);

        // The rest is the world's: a hand that pushes the tool down, friction, and the arm's own motion.
        let hand = jacobian.torques(Screw::new(PUSH, Vector3::zeros()));
        let others = hand - state.velocity * FRICTION;
        let State { position: moved, velocity } =
            RungeKutta4.step(&arm, state, torque - others, PERIOD);
        state = State { position: state.position + moved, velocity: state.velocity + velocity };
        joints = HeldTick {
            period: PERIOD,
            position: state.position,
            velocity: moved / PERIOD,
            displacement: moved,
            applied: torque,
        }
        .sample();

        let along = sample.velocity.screw.translation;
        let speed: &mut f64 = &mut seen.speeds[tick / 250];
        *speed = speed.max(1e3 * along.norm());
        if along.norm() > 1e-3 {
            let mass = inertia.apparent(Screw::new(along, Vector3::zeros()));
            seen.masses = [seen.masses[0].min(mass), seen.masses[1].max(mass)];
        }
    }
    Ok(seen)
}

fn main() -> Result<(), ParameterError> {
    println!("largest speed of the tool in each quarter of a second, mm/s");
    let (without, with) = (run(0.0)?, run(0.5)?);
    println!("without stabilizer  {:7.1?}", without.speeds);
    println!("with                {:7.1?}", with.speeds);
    let [least, most] = with.masses;
    println!("the apparent mass along the motion was between {least:.2} and {most:.2} kg");
    assert!(without.speeds[7] > 100.0, "it hammers on the table");
    assert!(with.speeds[7] < 20.0, "it comes to rest on it");
    Ok(())
}
