//! The loops as straight code on concrete types, without a call into the library.

mod lolc;
mod loops;
mod masses;
mod readings;
mod stabilizers;
mod walls;

macro_rules! hand {
    ($real:ident) => {
        pub(crate) mod $real {
            use lyapunov::bodies::held_input;
            use nalgebra::Matrix3;

            use crate::numbers::{
                BOUND_DAMPING, BUDGET, DAMPING, DEVICE_DAMPING, DEVICE_MASS, FASTEST, HOLD, MOST,
                OPERATOR_DAMPING, OPERATOR_MASS, OPERATOR_STIFFNESS, PERIOD, POWER, ROOM, START,
                STEPS, STIFFNESS,
            };

            super::masses::masses!($real);
            super::walls::walls!($real);
            super::stabilizers::stabilizers!($real);
            super::loops::loops!($real);
            super::lolc::lolc!($real);
            super::readings::readings!($real);
        }
    };
}

hand!(f32);
hand!(f64);
