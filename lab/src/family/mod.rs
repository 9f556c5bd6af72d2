//! The family of stabilizers by name, each with parameters that come from the scene.
//!
//! A [`Member`] is one of them; docs/family.md says what each is set to. `compare`, `map` and `hard` take the same
//! names. What has two ends, or only means something on several axes, is not here.
//!
//! ```
//! use lyapunov_lab::{Rollout, Summary, family::Member, paper};
//!
//! let scene = paper::Case::Plain8k.scene()?;
//! let member: Member = "popc-bounded".parse()?;
//! let summary = Summary::of(&scene, Rollout::stabilized_by(&scene, member.on::<f64>(&scene)?)?);
//! assert!(summary.settled.is_some() || summary.rows == 1001);
//! assert!("popc-bound".parse::<Member>().unwrap_err().to_string().contains("`popc-bounded`"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod basis;
pub(crate) mod contender;
mod list;
mod make;
mod member;
mod reference;

pub(crate) use basis::Basis;
pub use contender::Contender;
pub use list::{Members, NoMembers};
pub use member::{Member, NoMember};
pub(crate) use reference::Reference;
