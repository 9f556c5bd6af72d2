//! Work of a held wrench: booked over the displacement, against a fine integration of the motion.

use lyapunov::{
    Signal,
    poses::{Axes, BodyAxes, Pose, Screw, WorldAxes},
};
use nalgebra::{UnitQuaternion, Vector3};

use crate::support::{Dice, pose};

/// Motion whose twist, along the axes in question, is `start + growth · t`.
#[derive(Clone, Copy)]
struct Motion<F> {
    start: Screw<f64, F>,
    growth: Screw<f64, F>,
}

impl<F: Axes> Motion<F> {
    fn random(dice: &mut Dice) -> Self {
        Self { start: dice.screw(0.5, 3.0), growth: dice.screw(20.0, 100.0) }
    }

    fn twist(&self, time: f64) -> Screw<f64, F> {
        self.start + self.growth.scale(time)
    }

    /// The work of a held `wrench` on this motion over `period`: the integral is that of a line.
    fn work(&self, wrench: Screw<f64, F>, period: f64) -> f64 {
        wrench.inner(self.twist(period / 2.0)) * period
    }

    /// The pose after `period`, by nalgebra in small steps of the midpoint rule, extrapolated once.
    fn end(&self, from: &Pose<f64>, period: f64) -> Pose<f64> {
        let steps = |count: u32| {
            let step = period / f64::from(count);
            let mut at = nalgebra::Isometry3::from(*from);
            for index in 0..count {
                let twist = self.twist((f64::from(index) + 0.5) * step);
                let half = |turn: nalgebra::UnitQuaternion<f64>, about: Vector3<f64>| {
                    F::to_world(&pose(Vector3::zeros(), turn.into_inner().coords.into()), about)
                };
                // Both parts along the world's axes, at the middle of the step.
                let middle = {
                    let about = half(at.rotation, twist.rotation);
                    UnitQuaternion::from_scaled_axis(about * (step / 2.0)) * at.rotation
                };
                let (along, about) =
                    (half(middle, twist.translation), half(middle, twist.rotation));
                at.translation.vector += along * step;
                at.rotation = UnitQuaternion::from_scaled_axis(about * step) * at.rotation;
            }
            at
        };
        let (coarse, fine) = (steps(500), steps(1000));
        let position =
            fine.translation.vector + (fine.translation.vector - coarse.translation.vector) / 3.0;
        let change = (fine.rotation * coarse.rotation.inverse()).scaled_axis() / 3.0;
        let turn = UnitQuaternion::from_scaled_axis(change) * fine.rotation;
        pose(position, turn.into_inner().coords.into())
    }
}

/// What is booked less what was done, over `period`.
fn error<F: Axes>(motion: &Motion<F>, wrench: Screw<f64, F>, from: &Pose<f64>, period: f64) -> f64 {
    let moved = Screw::<f64, F>::between(from, &motion.end(from, period));
    wrench.inner(moved) - motion.work(wrench, period)
}

/// The stated third-order term, with brackets written out.
type Term<F> = fn(&Motion<F>, Screw<f64, F>) -> f64;

fn in_world(motion: &Motion<WorldAxes>, wrench: Screw<f64>) -> f64 {
    -wrench.rotation.dot(&motion.start.rotation.cross(&motion.growth.rotation)) / 12.0
}

fn in_body(motion: &Motion<BodyAxes>, wrench: Screw<f64, BodyAxes>) -> f64 {
    let Motion { start, growth } = motion;
    let along =
        start.rotation.cross(&growth.translation) + start.translation.cross(&growth.rotation);
    let about = start.rotation.cross(&growth.rotation);
    (wrench.translation.dot(&along) + wrench.rotation.dot(&about)) / 12.0
}

/// The error falls with the third power of the period, and towards the stated term.
fn is_of_third_order<F: Axes>(term: Term<F>) {
    let mut dice = Dice::of(21);
    for _ in 0..20 {
        let motion = Motion::<F>::random(&mut dice);
        let (from, wrench) = (dice.pose(), dice.screw(10.0, 1.0));
        let expected = term(&motion, wrench);
        // The next term is of one order more.
        let [long, short] =
            [8e-3, 4e-3].map(|period: f64| error(&motion, wrench, &from, period) / period.powi(3));
        let at_once = 2.0 * short - long;
        let size =
            wrench.translation.norm() * (20.0 * 3.0 + 0.5 * 100.0) + 300.0 * wrench.rotation.norm();
        assert!((at_once - expected).abs() < 0.01 * size / 12.0, "{at_once} for {expected}");
        assert!((long - expected).abs() < 0.2 * size / 12.0, "{long} for {expected}");
    }
}

#[test]
fn along_the_worlds_axes() {
    is_of_third_order(in_world);
}

#[test]
fn along_the_bodys_axes() {
    is_of_third_order(in_body);
}

/// The part of a force along the world's axes is exact whatever the motion, and all of it where the twist is constant.
#[test]
fn exactly_where_it_is_said() {
    let mut dice = Dice::of(22);
    for _ in 0..20 {
        let (from, force) = (dice.pose(), Screw::new(dice.vector(10.0), Vector3::zeros()));
        let motion = Motion::<WorldAxes>::random(&mut dice);
        assert!(error(&motion, force, &from, 0.02).abs() < 1e-10);

        let steady = Motion::<BodyAxes> { start: dice.screw(0.5, 3.0), growth: Screw::default() };
        assert!(error(&steady, dice.screw(10.0, 1.0), &from, 0.1).abs() < 1e-9);
        let steady = Motion::<WorldAxes> { start: dice.screw(0.5, 3.0), growth: Screw::default() };
        assert!(error(&steady, dice.screw(10.0, 1.0), &from, 0.1).abs() < 1e-9);
    }
}

/// The stated bound, `|τ| θ² δ / 12`, at 1 kHz: an axis that turns by a radian in a tenth of a second.
#[test]
fn at_a_usual_rate_it_is_small() {
    let motion = Motion::<WorldAxes> {
        start: Screw::new(Vector3::zeros(), Vector3::x() * 10.0),
        growth: Screw::new(Vector3::zeros(), Vector3::y() * 100.0),
    };
    let torque = Screw::new(Vector3::zeros(), Vector3::z());
    let found = error(&motion, torque, &Pose::at(Vector3::zeros()), 1e-3);
    let (turned, swept): (f64, f64) = (10.0 * 1e-3, 100.0 * 1e-3 / 10.0);
    assert!(found.abs() <= 1.01 * turned * turned * swept / 12.0, "{found:e}");
    assert!(found.abs() > 0.9 * turned * turned * swept / 12.0, "{found:e}");
}
