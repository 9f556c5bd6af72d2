//! The laws, and the loop on a simulated device.

use lyapunov::bodies::{RigidBody, RigidParts};
use lyapunov::laws::{self, Samples};
use lyapunov::poses::{Pose, Screw, WithPose};
use lyapunov::{lanes::AutoF64x4, prelude::*};
use nalgebra::Vector3;
use out_of_tree::{DryFriction, WhileGiving, own, shipped};

fn keeps_the_laws<V: Signal>() {
    let of = V::Scalar::of;
    let (samples, limit) = (Samples::<V>::new(of(1e-3)), DampingLimit::at(of(100.0)).unwrap());
    let law = WhileGiving::new(PortEnergy, limit);
    laws::stabilizer(&law, samples).unwrap();
    laws::ledger(&law, &PortEnergy, limit.most(), samples).unwrap();
    laws::candidate(&DryFriction::of(of(0.02)).unwrap(), samples).unwrap();
}

#[test]
fn the_laws_hold() {
    keeps_the_laws::<f32>();
    keeps_the_laws::<AutoF64x4>();
    keeps_the_laws::<Vector3<f64>>();
}

#[test]
fn the_loop_holds_the_handle_through_lost_and_wild_readings() {
    let moments = Vector3::new(2e-4, 3e-4, 4e-4);
    let parts = RigidParts { mass: 0.4, moments, damping: 0.5, rotational_damping: 5e-4 };
    let start = Pose::at(Vector3::new(0.3, 0.0, 0.004));
    let mut device = RigidBody::new(parts, 1e-3, 1).unwrap().starting(start, Screw::default());
    let mut control = own(start).unwrap();
    let (mut applied, mut now) = (Screw::default(), start);
    for tick in 0..3000 {
        let pose = match tick {
            500..503 => None,
            900 => Some(Pose::at(Vector3::new(0.3, 0.0, 5.0))),
            _ => Some(now),
        };
        applied = control.tick(pose, applied);
        if tick == 1500 {
            let state = control.stabilizer.state();
            control.stabilizer = own(start).unwrap().stabilizer.restored(state).unwrap();
        }
        let hand = Screw::new(Vector3::new(0.0, 0.0, 2.0), Vector3::zeros()); // 2 N down
        now = device.advance(WithPose::of(applied + hand)).position.pose;
    }
    assert!(now.position.z.abs() < 0.002, "{}", now.position.z);
    let told = control.energies.summary();
    assert_eq!((told.ticks, told.rejected), (3000, 4.0));
    assert_eq!(control.log.csv().to_string().lines().count(), 65);
    control.set_period(0.5e-3).unwrap();
    control.stabilizer.stabilizer_mut().stabilizer_mut().observer.ledger.owe(1e-3_f32).unwrap();
    let popc = shipped("popc", start).unwrap().tick(Some(start), Screw::default());
    assert_eq!(popc, Screw::default());
}
