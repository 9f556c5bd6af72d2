//! Poses, twists and wrenches: the port of a rigid body.

mod angle;
mod axes;
mod jacobian;
mod logarithm;
mod pose;
mod pose_track;
mod screw;
mod spatial;
mod task_port;
mod with_pose;

pub use angle::Angle;
pub use axes::{Axes, BodyAxes, WorldAxes};
pub use jacobian::Jacobian;
pub use pose::Pose;
pub use pose_track::PoseTrack;
pub use screw::Screw;
pub use spatial::Spatial;
pub use task_port::TaskPort;
pub use with_pose::WithPose;
