//! Properties that a user of the library relies on, each against something outside the library: a closed form, a fine
//! integration, or the tick contract in straight code.

mod support;

mod accumulators;
mod adaptive_window;
mod adaptors;
mod balance;
mod body_lanes;
mod delayed_limit;
mod detection;
mod device_damping;
mod double_double;
mod dropout;
mod environments;
mod filter_order;
mod friction;
mod friction_isotropic;
mod friction_limits;
mod friction_of_two;
mod guard;
mod hold_order;
mod lanes;
mod linked;
mod lost_messages;
mod low_pass;
mod measurement_lanes;
mod noise;
mod per_axis;
mod per_axis_laws;
mod perturbed;
mod popc;
mod propagation;
mod random;
mod recursion;
mod rollouts;
mod served_sum;
mod trajectories;
mod truth;
