//! Steps of the family against recursions by hand and worked examples, on few types.
//!
//! The modules of `tests/family` that check one type or two are taken as they are; those that check every lane and
//! every vector cost minutes of building after each changed line.

mod asked;
mod axes;
mod constraint;
mod controller;
mod directed;
mod drift;
mod every_member;
mod inertia;
mod late;
mod limits;
mod messages;
mod metrics;
mod parts;
mod path;
mod plausible;
mod restored;
mod retuned;
mod room;
mod shaped;
mod stores;
mod watched;

#[path = "../family/account.rs"]
mod account;
#[path = "../family/admittance.rs"]
mod admittance;
#[path = "../family/adversary.rs"]
mod adversary;
#[path = "../family/aimed.rs"]
mod aimed;
#[path = "../family/coupling.rs"]
mod coupling;
#[path = "../support/dice.rs"]
mod dice;
#[path = "../family/energy_bounding.rs"]
mod energy_bounding;
#[path = "../family/force_bound.rs"]
mod force_bound;
#[path = "../family/force_bounding.rs"]
mod force_bounding;
#[path = "../family/input_to_state.rs"]
mod input_to_state;
#[path = "../family/least_norm.rs"]
mod least_norm;
#[path = "../family/memory_based.rs"]
mod memory_based;
#[path = "../family/neutral.rs"]
mod neutral;
#[path = "../family/path_memory.rs"]
mod path_memory;
#[path = "../properties/per_axis.rs"]
mod per_axis;
#[path = "../family/reference.rs"]
mod reference;
#[path = "../family/shaping.rs"]
mod shaping;
#[path = "../family/slope_bound.rs"]
mod slope_bound;
#[path = "../family/support.rs"]
mod support;
#[path = "../family/tank.rs"]
mod tank;
#[path = "../family/two_layer.rs"]
mod two_layer;
#[path = "../family/two_port_worked.rs"]
mod two_port_worked;
#[path = "../family/waves.rs"]
mod waves;
#[path = "../family/worked.rs"]
mod worked;
