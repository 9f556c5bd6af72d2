//! Properties that a user of the library relies on, each against something that is not the library: a closed form, a
//! fine integration, or the tick contract in straight code.

mod support;

mod accumulators;
mod adaptors;
mod balance;
mod courses;
mod detection;
mod device_damping;
mod guard;
mod lanes;
mod linked;
mod perturbed;
mod popc;
mod propagation;
mod recursion;
mod rollouts;
mod served_sum;
mod truth;
