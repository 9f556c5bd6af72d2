//! Poses, twists and wrenches, each against a matrix exponential with thirty digits, a closed form or a fine integration.

mod arm;
mod body_points;
#[path = "../support/dice.rs"]
mod dice;
mod energy;
mod inertia;
mod logarithm;
mod orientation_spring;
mod parts;
mod readings;
mod rigid_body;
mod scaled;
mod support;
mod task_port;
mod track;
mod work;
