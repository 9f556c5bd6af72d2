//! A scene in one line, but for its stabilizer.

use std::fmt;

use crate::files::scene::Scene;
use crate::show::described;
use crate::text::numbers::given;

pub(super) struct Setting<'a>(pub(super) &'a Scene);

impl fmt::Display for Setting<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let scene = self.0;
        let (duration, rate) = (given(scene.duration.get()), given(scene.servo_rate.get()));
        write!(f, "{duration} s at {rate} Hz")?;
        if scene.environment_ratio() > 1 {
            write!(f, " over {} Hz", given(scene.environment_rate()))?;
        }
        write!(f, ", {} {}", scene.environment.name(), described::environment(scene))
    }
}
