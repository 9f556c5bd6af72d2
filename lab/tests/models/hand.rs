//! Two hand-written models that use nothing of the library but the file.

use approx::abs_diff_eq;
use lyapunov_lab::Verdict;
use lyapunov_lab::compare::Named;
use lyapunov_lab::models::{Entrant, Model, Plant, Score};

use crate::models::shipped::{compared, curve, model};

type State = [f64; 2];

/// Plant with one coordinate and its rate, whose flow is the rate.
struct Hand {
    /// The acceleration in a state under an input.
    acceleration: Box<dyn Fn(State, f64) -> f64>,
    value: Box<dyn Fn(State) -> f64>,
    law: Box<dyn Fn(State) -> f64>,
    most: f64,
    period: f64,
}

/// Result of a run.
#[derive(Debug, Default)]
struct Found {
    values: Vec<f64>,
    effort: f64,
    active: usize,
    shortfall: f64,
    taken: f64,
}

impl Hand {
    /// The state and the integral of the rate a period later, by the classical Runge-Kutta method.
    fn moved(&self, x: State, input: f64) -> (State, f64) {
        let h = self.period;
        let rate = |x: State| [x[1], (self.acceleration)(x, input), x[1]];
        let after = |k: [f64; 3], by: f64| [x[0] + by * k[0], x[1] + by * k[1]];
        let k1 = rate(x);
        let k2 = rate(after(k1, h / 2.0));
        let k3 = rate(after(k2, h / 2.0));
        let k4 = rate(after(k3, h));
        let [place, rate, integral] =
            [0, 1, 2].map(|i| h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
        ([x[0] + place, x[1] + rate], integral)
    }

    fn run(&self, model: &Model, entrant: Entrant) -> Found {
        let (delay, decay) = (model.controller.delay.get() as usize, model.stabilizer.decay.get());
        let mut x = [0, 1].map(|i| model.initial[i].get());
        let (mut found, mut commands) = (Found::default(), Vec::new());
        let (mut sum, mut effort, mut integral) = (0.0, 0.0, 0.0);
        let ticks = (model.duration.get() * model.servo_rate.get()).round() as usize;
        for tick in 0..=ticks {
            let value = (self.value)(x);
            let lost = found.values.last().map_or(0.0, |before| before - value);
            sum += match entrant {
                Entrant::None => 0.0,
                Entrant::Popc => effort * integral,
                Entrant::Decrease => lost,
                Entrant::Decay => lost - decay * value * self.period,
            };
            let square = x[1] * x[1] * self.period;
            let alpha = if sum < 0.0 && square > f64::MIN_POSITIVE {
                (-sum / square).min(self.most)
            } else {
                0.0
            };
            found.shortfall = found.shortfall.max(-sum - alpha * square);
            commands.push(-(self.law)(x));
            effort = if tick < delay { 0.0 } else { commands[tick - delay] } + alpha * x[1];
            found.values.push(value);
            found.effort = found.effort.max(effort.abs());
            found.active += usize::from(alpha > 0.0);
            let flow = x[1];
            (x, integral) = self.moved(x, -effort);
            found.taken += if tick < ticks { alpha * flow * integral } else { 0.0 };
        }
        found
    }

    fn equals(&self, model: &Model) {
        let comparison = compared(model);
        for (entrant, score) in Entrant::ALL.iter().copied().zip(comparison.scores()) {
            let name = entrant.name();
            let found = self.run(model, entrant);
            let told = curve(&comparison, entrant);
            assert_eq!(told.len(), found.values.len(), "{name}");
            for (tick, (told, hand)) in told.iter().zip(&found.values).enumerate() {
                let size = hand.max(found.values[0]);
                assert!(
                    abs_diff_eq!(told, hand, epsilon = 1e-9 * size),
                    "{name} at {tick}: {told}, {hand}"
                );
            }
            found.equals(score);
        }
    }
}

impl Found {
    #[track_caller]
    fn equals(&self, score: &Score) {
        let largest = self.values.iter().copied().fold(0.0, f64::max);
        let most = self.values[0].max(largest);
        for (what, told, hand, size) in [
            ("largest V", score.largest, largest, most),
            ("V at the end", score.end, self.values[self.values.len() - 1], most),
            ("effort", score.effort, self.effort, self.effort),
            ("shortfall", score.shortfall, self.shortfall, most),
            ("taken", score.taken, self.taken, most.max(self.taken)),
        ] {
            let told = told.unwrap();
            assert!(
                abs_diff_eq!(told, hand, epsilon = 1e-9 * size),
                "{what} of {}: {told}, {hand}",
                score.stabilizer
            );
        }
        let last = self.values.len() - 1;
        let tail = self.values[(9 * last).div_ceil(10)..].iter().copied().fold(0.0, f64::max);
        let verdict = match (largest > 4.0 * self.values[0], tail <= 0.0025 * self.values[0]) {
            (true, _) => Verdict::Grows,
            (_, true) => Verdict::Settles,
            _ => Verdict::Swinging,
        };
        assert_eq!(score.verdict, verdict, "{}", score.stabilizer);
        let share = 100.0 * self.active as f64 / self.values.len() as f64;
        // Where the debt is about zero, rounding decides whether the tick counts as active.
        assert!(abs_diff_eq!(score.active, share, epsilon = 0.1), "{}: {share}", score.stabilizer);
    }
}

#[test]
fn van_der_pol_matches_the_hand_written_loop() {
    let model = model("van-der-pol");
    let Plant::VanDerPol(plant) = model.plant else { panic!("{model:?}") };
    assert_eq!((plant.mu.get(), model.servo_rate.get()), (1.0, 100.0));
    let hand = Hand {
        acceleration: Box::new(|[x, v], u| (1.0 - x * x) * v - x + u),
        value: Box::new(|[x, v]| 0.5 * (x * x + v * v)),
        law: Box::new(|_| 0.0),
        most: 0.5 / 0.01,
        period: 0.01,
    };
    hand.equals(&model);
}

#[test]
fn the_pendulum_matches_the_hand_written_loop() {
    let model = model("inverted-pendulum");
    let (mass, length, damping, gravity) = (0.5, 0.4, 0.002, 9.80665);
    let (stiffness, derivative) = (6.0, 0.4);
    let (inertia, weight) = (mass * length * length, mass * gravity * length);
    let hand = Hand {
        acceleration: Box::new(move |[angle, rate], torque| {
            (weight * angle.sin() - damping * rate + torque) / inertia
        }),
        value: Box::new(move |[angle, rate]| {
            let half = (0.5 * angle).sin();
            0.5 * (inertia * rate * rate + stiffness * angle * angle) - 2.0 * weight * half * half
        }),
        law: Box::new(move |[angle, rate]| -stiffness * angle - derivative * rate),
        most: 0.0125 * inertia / 1e-3,
        period: 1e-3,
    };
    hand.equals(&model);
}
