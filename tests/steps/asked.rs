//! The input-to-state stable port: what it asks, tells and keeps.

use approx::assert_relative_eq;
use lyapunov::{
    Correction, OnePort, ParameterError, PortSample, Snapshot, stabilizers::InputToState,
};
use nalgebra::Vector2;

const PERIOD: f64 = 0.25; // s
const SLOPE: f64 = 8.0; // N/m
const FEED: f64 = 0.5; // s

/// Keeps what it was asked, and answers the next of some forces, whatever it was asked.
#[derive(Clone)]
struct Answers {
    asked: Vec<PortSample<f64>>,
    forces: Vec<f64>,
}

impl OnePort<f64> for Answers {
    fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
        self.asked.push(*sample);
        self.forces[self.asked.len() - 1]
    }

    fn correction(&self) -> Correction<f64> {
        Correction { alpha: 3.0, observed_energy: -2.0, ..Correction::none(1.0) }
    }
}

impl Snapshot for Answers {
    type State = ();

    fn state(&self) {}

    fn restored(self, _state: ()) -> Result<Self, ParameterError> {
        Ok(self)
    }
}

fn answering(forces: &[f64]) -> Answers {
    Answers { asked: Vec::new(), forces: forces.to_vec() }
}

fn moved(position: f64, displacement: f64) -> PortSample<f64> {
    let start = PortSample::starting(PERIOD, position, displacement / PERIOD);
    PortSample { displacement, ..start }
}

/// `q = x − f / μ`, `v' = v − ḟ / μ`, `F = f + τ ḟ`, line by line, in whole numbers of powers of two.
#[test]
fn it_asks_a_little_before() {
    let forces = [4.0, 6.0, -2.0, 10.0];
    let mut answers = answering(&forces);
    let mut given = Vec::new();
    {
        let mut port = InputToState::new(&mut answers, SLOPE, FEED).expect("a port");
        for tick in 0..4 {
            given.push(port.respond(&moved(f64::from(tick) + 1.0, 1.0)));
        }
    }
    let (mut last, mut shift) = (0.0, 0.0);
    for (tick, force) in forces.into_iter().enumerate() {
        let asked = answers.asked[tick];
        let now = last / SLOPE;
        assert_eq!((asked.period, asked.applied), (PERIOD, last));
        assert_eq!(asked.position, tick as f64 + 1.0 - now);
        assert_eq!(asked.displacement, 1.0 - (now - shift));
        assert_eq!(asked.velocity, 4.0 - (now - shift) / PERIOD);
        assert_eq!(given[tick], force + FEED * (force - last) / PERIOD);
        (last, shift) = (force, now);
    }
}

/// The steepest `|Δf| / |Δq|` so far, times the share; also on two axes.
#[test]
fn the_slope_is_the_steepest_that_was_seen() {
    let mut port =
        InputToState::adaptive(answering(&[0.0, 6.0, 7.0, 47.0]), 2.0, 0.0).expect("one");
    let slopes: Vec<f64> = (0..4)
        .map(|tick| {
            port.respond(&moved(f64::from(tick), 1.0));
            port.slope()
        })
        .collect();
    // 6 N over a metre. Then q goes from 1 to 2 − 6 / 12 and to 3 − 7 / 12: 1 N over half a metre, 40 N over 11 / 12.
    assert_eq!(slopes[..3], [0.0, 12.0, 12.0]);
    assert_relative_eq!(slopes[3], 2.0 * 40.0 * 12.0 / 11.0, max_relative = 1e-14);

    /// `x + 3 y` along `(3, 4)`.
    struct Slanted;
    impl OnePort<Vector2<f64>> for Slanted {
        fn respond(&mut self, sample: &PortSample<Vector2<f64>>) -> Vector2<f64> {
            Vector2::new(3.0, 4.0) * (sample.position.x + 3.0 * sample.position.y)
        }
    }
    let mut port = InputToState::adaptive(Slanted, 2.0, 0.0).expect("a port");
    for position in [Vector2::zeros(), Vector2::new(0.0, 2.0)] {
        port.respond(&PortSample::starting(PERIOD, position, Vector2::zeros()));
    }
    assert_eq!(port.slope(), 2.0 * 5.0 * 3.0);
}

#[test]
fn what_is_told_is_of_the_port_inside() {
    let mut port = InputToState::new(answering(&[4.0]), SLOPE, FEED).expect("a port");
    port.respond(&moved(0.0, 0.0));
    let told: Correction<f64> = port.correction();
    assert_eq!((told.effort, told.alpha, told.observed_energy), (1.0, 3.0, -2.0));
}

/// After a spoilt tick, whatever the port inside makes of it, nothing but finite numbers is kept: the memory is accepted.
#[test]
fn a_spoilt_tick_leaves_nothing_behind() {
    for (position, answer) in [(f64::NAN, 2.0), (1.0, f64::NAN), (f64::INFINITY, f64::INFINITY)] {
        for first in [true, false] {
            let (forces, made) = (vec![4.0, answer, 6.0], |forces: &[f64]| {
                InputToState::adaptive(answering(forces), 2.0, FEED).expect("a port")
            });
            let mut port = made(&forces[usize::from(first)..]);
            if !first {
                port.respond(&moved(0.0, 0.0));
            }
            let before = port.state();
            port.respond(&moved(position, 1.0));
            let after = port.state();
            assert_eq!((after.1, after.2), (before.1, before.2), "{position} and {answer}");
            assert!(made(&forces).restored(after).is_ok(), "{after:?}");
            assert!(port.respond(&moved(2.0, 1.0)).is_finite());
        }
    }
}

#[test]
fn what_cannot_be_right_is_named() {
    let refused = |made: Result<InputToState<Answers, f64>, ParameterError>| {
        let error = made.err().expect("refused");
        (error.parameter, error.value)
    };
    let port = || answering(&[]);
    assert_eq!(refused(InputToState::new(port(), 0.0, 0.0)), ("largest slope", 0.0));
    assert_eq!(refused(InputToState::new(port(), -1.0, 0.0)), ("largest slope", -1.0));
    assert_eq!(refused(InputToState::new(port(), 1.0, -1.0)), ("rate feed-forward", -1.0));
    let name = "share of the slope";
    for share in [1.0, 0.9, -1.5] {
        assert_eq!(refused(InputToState::adaptive(port(), share, 0.0)), (name, share));
    }
    let least = InputToState::<_, f64>::adaptive(port(), 1.0 + f64::EPSILON, 0.0);
    assert!(least.is_ok() && InputToState::<_, f64>::new(port(), f64::INFINITY, 0.0).is_ok());
    let told = InputToState::<_, f64>::new(port(), 0.0, 0.0).err().expect("refused");
    assert_eq!(told.to_string(), "largest slope is 0.0; it must be above 0 (infinity: no limit)");
}
