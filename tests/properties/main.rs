//! Properties that a user of the library relies on, each against something that is not the library: a closed form, a
//! fine integration, or the tick contract in straight code.

mod support;

mod accumulators;
mod adaptors;
mod detection;
mod device_damping;
mod environments;
mod friction;
mod friction_limits;
mod friction_of_two;
mod guard;
mod lanes;
mod popc;
mod propagation;
mod recursion;
mod rollouts;
mod served_sum;
mod truth;
