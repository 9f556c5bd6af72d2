//! Long runs of chaotic loops, in which each row follows from the rows before it.

use crate::effects::compare::follows;
use crate::effects::reference::Row;
use crate::effects::run::rows;
use crate::effects::scene::{Dropout, Environment, Filter, Friction, Kind, Motion, Scene};
use approx::abs_diff_eq;

/// The paper's loop at its soft wall, chaotic under its stabilizer.
fn chaotic() -> Scene {
    let wall = Environment::Wall { position: 0.0, stiffness: 8e3, damping: 2.0 };
    let mut scene = Scene::calm().touching(wall).with(Kind::MassSpringDamper, false, 0.5);
    (scene.duration, scene.servo_rate, scene.hold) = (20.0, 1000.0, 10);
    scene
}

#[test]
fn every_row_of_long_runs_follows() {
    let dropout = |zero| Some(Dropout { probability: 0.2, seed: 77, zero });
    let friction = Some(Friction { coulomb: 0.05, breakaway: 0.1, stribeck_velocity: 0.01 });
    for scene in [
        Scene { dropout: dropout(false), ..chaotic() },
        Scene { dropout: dropout(true), exact: true, ..chaotic() },
        Scene {
            noise: Some((2e-6, 3)),
            encoder: Some(1e-5),
            filter: Some(Filter::Window(16)),
            ..chaotic()
        },
        Scene { noise: Some((2e-6, 3)), filter: Some(Filter::Cutoff(80.0)), ..chaotic() },
        Scene { jitter: Some((5e-5, 3)), exact: true, ..chaotic() },
        Scene { jitter: Some((5e-5, 3)), link: Some([2e4, 1.0]), exact: true, ..chaotic() },
        Scene { friction, exact: true, ..chaotic() },
    ] {
        follows(&scene).unwrap_or_else(|error| panic!("{error}"));
    }
}

/// The noise is Gaussian: mean, deviation, the share within one and two deviations, and no memory.
#[test]
fn noise_is_gaussian_without_memory() {
    let deviation = 4e-6;
    let scene = Scene { noise: Some((deviation, 2024)), duration: 60.0, ..chaotic() };
    let noise = |row: &Row| (row[2] - row[1]) / deviation;
    let told: Vec<f64> = rows(&scene).unwrap().iter().map(noise).collect();
    let count = told.len() as f64;
    let mean_of = |values: &mut dyn Iterator<Item = f64>| values.sum::<f64>() / count;
    let share =
        |within: f64| mean_of(&mut told.iter().map(|z| f64::from(u8::from(z.abs() < within))));
    let next = mean_of(&mut told.windows(2).map(|pair| pair[0] * pair[1]));
    let fourth = mean_of(&mut told.iter().map(|z| z.powi(4)));
    // The tolerance of each is five standard errors.
    let error = 5.0 / count.sqrt();
    for (what, got, want, spread) in [
        ("mean", mean_of(&mut told.iter().copied()), 0.0, 1.0),
        ("variance", mean_of(&mut told.iter().map(|z| z * z)), 1.0, 1.5),
        ("fourth moment", fourth, 3.0, 10.0),
        ("share within one", share(1.0), 0.682_689, 0.5),
        ("share within two", share(2.0), 0.954_500, 0.3),
        ("product with the next", next, 0.0, 1.0),
    ] {
        assert!(abs_diff_eq!(got, want, epsilon = spread * error), "{what}: {got} is not {want}");
    }
}

/// Under `hold` a lost answer leaves the force as it was, under `zero` the force is zero.
#[test]
fn dropout_loses_its_share() {
    for zero in [false, true] {
        let dropout = Some(Dropout { probability: 0.3, seed: 11, zero });
        let mut scene = Scene { dropout, ..chaotic() };
        scene.environment = Environment::Spring { position: 0.0, stiffness: 100.0 };
        // The hand always moves, so that two answers are never equal by chance.
        scene.motion = Some(Motion::Sine { amplitude: 0.003, frequency: 1.7 });
        let told = rows(&scene).unwrap();
        let answers: Vec<&Row> = told.iter().step_by(scene.hold).collect();
        let lost = |pair: &&[&Row]| pair[1][4] == if zero { 0.0 } else { pair[0][4] };
        let lost = answers.windows(2).filter(lost).count() as f64;
        let (count, share) = ((answers.len() - 1) as f64, 0.3);
        let deviation = (count * share * (1.0 - share)).sqrt();
        assert!(abs_diff_eq!(lost, share * count, epsilon = 4.0 * deviation), "{lost} of {count}");
    }
}
