//! A scene in one line, but for its stabilizer.

use std::fmt;

use crate::scene::{Environment, Scene};
use crate::summary::given;

pub(super) struct Setting<'a>(pub(super) &'a Scene);

impl fmt::Display for Setting<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scene = self.0;
        let Environment::Wall(wall) = scene.environment;
        let (duration, rate) = (given(scene.duration.get()), given(scene.servo_rate.get()));
        write!(f, "{duration} s at {rate} Hz")?;
        if scene.environment_ratio() > 1 {
            write!(f, " over {} Hz", given(scene.environment_rate()))?;
        }
        let (stiffness, damping) = (given(wall.stiffness.get()), given(wall.damping.get()));
        write!(f, ", wall {stiffness} N/m {damping} N.s/m")
    }
}
