//! One tick as the meters see it.

use std::collections::VecDeque;

use lyapunov::{ForceLaw, Kinematics};

use crate::Row;
use crate::scene::{Scene, Wall};

/// One row, and what it does not tell: the plant's own velocity, and the environment's share of what acts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tick {
    pub(crate) row: Row,
    /// The plant's own velocity at the tick, m/s.
    pub(crate) velocity: f64,
    /// What would act now were there no controller behind the saturation and the delay, N:
    /// `f_e(n) = clip(f_env(n − d))`, 0 for `n < d`. The rest of `f_act` is the controller's.
    pub(crate) environment: f64,
}

impl Tick {
    /// The controller's share of the force on the plant, N.
    pub(crate) fn controller(&self) -> f64 {
        self.row.f_act - self.environment
    }

    /// How deep the plant truly is beyond the surface, m.
    pub(super) fn depth(&self, wall: Wall) -> f64 {
        self.row.x - wall.position.get()
    }

    /// The force of the wall's law on the true motion, without sampling, hold, encoder, saturation or delay, N.
    pub(super) fn ideal(&self, law: &impl ForceLaw<f64>) -> f64 {
        law.force(&Kinematics::at(self.row.x, self.velocity))
    }
}

/// Makes ticks out of rows, with the environment's force saturated and delayed as the whole force is.
#[derive(Clone, Debug)]
pub(crate) struct Share {
    most: f64,
    waiting: VecDeque<f64>,
}

impl Share {
    /// The share in `scene`, whose saturation is at `most` N.
    pub(crate) fn new(scene: &Scene, most: f64) -> Self {
        let ticks = scene.effects.delay.map_or(0, |delay| delay.ticks.get());
        Self { most, waiting: VecDeque::from(vec![0.0; ticks.into()]) }
    }

    pub(crate) fn tick(&mut self, row: Row, velocity: f64) -> Tick {
        self.waiting.push_back(row.f_env.clamp(-self.most, self.most));
        Tick { row, velocity, environment: self.waiting.pop_front().unwrap_or_default() }
    }
}

/// The wall of a scene, if that is what it has.
pub(super) fn wall(scene: &Scene) -> Option<Wall> {
    scene.environment.wall().copied()
}

#[cfg(test)]
mod tests {
    use super::super::samples::{row, scene};
    use super::*;

    #[test]
    fn the_environment_s_share_is_clipped_and_late_as_the_whole_is() {
        let late = scene("effects.delay.ticks = 2\neffects.saturation.force = 3.0\n");
        let mut share = Share::new(&late, 3.0);
        let forces = [1.0, 5.0, -7.0, 2.0];
        let acting = forces.map(|force| share.tick(Row { f_env: force, ..row() }, 0.0).environment);
        assert_eq!(acting, [0.0, 0.0, 1.0, 3.0]);

        let mut prompt = Share::new(&scene(""), f64::INFINITY);
        let tick = prompt.tick(Row { f_env: 4.0, f_act: 4.5, ..row() }, 0.0);
        assert_eq!((tick.environment, tick.controller()), (4.0, 0.5));
    }

    #[test]
    fn the_ideal_wall_never_pulls_and_knows_the_surface() {
        let wall = wall(&scene("")).unwrap().law().unwrap(); // 1000 N/m, 2 N·s/m, surface at 1 mm
        let at =
            |x: f64, velocity: f64| Tick { row: Row { x, ..row() }, velocity, environment: 0.0 };
        assert_eq!(at(0.001, 1.0).ideal(&wall), 0.0);
        assert_eq!(at(0.0005, 1.0).ideal(&wall), 0.0);
        assert!((at(0.003, 0.5).ideal(&wall) - 3.0).abs() < 1e-12);
        assert_eq!(at(0.003, -5.0).ideal(&wall), 0.0);
    }
}
