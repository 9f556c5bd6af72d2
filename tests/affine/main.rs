//! Control-affine plants: their ports, the models, their Lyapunov functions, and stabilized loops.

mod lanes;
mod laws;
mod loops;
mod measured;
mod models;
mod popc;
mod refused;
mod truth;

use lyapunov::{
    Scalar,
    models::{
        AdmittanceDevice, DcMotor, Ground, InvertedPendulum, MotorParts, ProstheticLeg, RigidLink,
        TwoLinkArm,
    },
};
use nalgebra::SVector;

/// Uniform in [-1, 1): splitmix64 (Steele, Lea and Flood, OOPSLA 2014).
struct Draw(u64);

impl Draw {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((bits ^ (bits >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vector<T: Scalar, const N: usize>(&mut self, size: f64) -> SVector<T, N> {
        SVector::from_fn(|_, _| T::from_lanes(|_| size * self.next()))
    }
}

fn pendulum<T: Scalar>() -> InvertedPendulum<T> {
    InvertedPendulum::new(T::of(0.5), T::of(0.4), T::of(0.002)).expect("a pendulum")
}

fn motor<T: Scalar>() -> DcMotor<T> {
    let parts = MotorParts {
        inertia: T::of(1e-4),
        friction: T::of(1e-5),
        torque_constant: T::of(0.05),
        resistance: T::of(1.0),
        inductance: T::of(0.02),
    };
    DcMotor::new(parts).expect("a motor")
}

/// A device in a hand of 1 kN/m.
fn device<T: Scalar>() -> AdmittanceDevice<T> {
    AdmittanceDevice::new(T::of(1000.0)).expect("a device")
}

fn arm<T: Scalar>() -> TwoLinkArm<T> {
    let [upper, lower] = [(2.0, 0.4), (1.0, 0.3)].map(|(m, l)| RigidLink::rod(T::of(m), T::of(l)));
    TwoLinkArm::new(upper, lower).expect("an arm")
}

fn leg<T: Scalar>() -> ProstheticLeg<T> {
    let [thigh, shank] = [(4.0, 0.4), (2.5, 0.45)].map(|(m, l)| RigidLink::rod(T::of(m), T::of(l)));
    let ground = Ground { stiffness: T::of(2e4), damping: T::of(0.5), drag: T::of(0.2) };
    ProstheticLeg::new(thigh, shank, [T::of(0.3), T::of(-0.6)], ground).expect("a leg")
}
