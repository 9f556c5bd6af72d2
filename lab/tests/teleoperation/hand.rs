//! Hand-written runs of the shipped files, which use nothing of the library but its random numbers.

use approx::abs_diff_eq;
use lyapunov::effects::{Random, Source};
use lyapunov_lab::teleoperation::{Entrant, Score, Teleoperator};

use crate::teleoperation::shipped::{NAMES, compared, parsed, text};

const T: f64 = 1e-3;
const MASS: f64 = 0.3;
const DAMPING: f64 = 1.0;
const HAND: f64 = 100.0;
const START: f64 = -0.01;
const WALL: f64 = 2000.0;
const SURFACE: f64 = -0.005;
const K: f64 = 200.0;
const B: f64 = 2.0;
const CAP: f64 = 0.5;
const SPEED: f64 = 0.02;

/// Allowed distance between two runs, m: the part of the start's energy, 5 mJ, that the rounding of a ledger hides
/// moves a device in its hand by `√(2 ε E / k)`, 0.15 nm.
const FINEST: f64 = 1e-9;

type Motion = [f64; 2];
type Message = (f64, f64);

/// `m ẍ + b ẋ + k x = force` after `t` s: the closed form of a swing that dies out.
fn sprung(stiffness: f64, force: f64, [x, v]: Motion, t: f64) -> Motion {
    let (decay, rest) = (DAMPING / (2.0 * MASS), force / stiffness);
    let rate = (stiffness / MASS - decay * decay).sqrt();
    let (c, s, e) = ((rate * t).cos(), (rate * t).sin(), (-decay * t).exp());
    let (away, slope) = (x - rest, (v + decay * (x - rest)) / rate);
    let velocity = (slope * rate - decay * away) * c - (away * rate + decay * slope) * s;
    [rest + e * (away * c + slope * s), e * velocity]
}

/// The same motion without a spring.
fn free(force: f64, [x, v]: Motion, t: f64) -> Motion {
    let (last, gone) = (force / DAMPING, -(-DAMPING * t / MASS).exp_m1());
    let excess = v - last;
    [x + last * t + excess * gone * MASS / DAMPING, last + excess * (1.0 - gone)]
}

/// The slave after `t` s, in pieces inside and outside the wall; bisection finds the instants between them.
fn walled(force: f64, from: Motion, t: f64) -> Motion {
    let within = from[0] > SURFACE || (from[0] == SURFACE && from[1] > 0.0);
    let piece = |t: f64| {
        if within {
            let [x, v] = sprung(WALL, force, [from[0] - SURFACE, from[1]], t);
            [SURFACE + x, v]
        } else {
            free(force, from, t)
        }
    };
    let beyond = |[x, _]: Motion| if within { x < SURFACE } else { x > SURFACE };
    if !beyond(piece(t)) {
        return piece(t);
    }
    let (mut near, mut far) = (0.0, t);
    for _ in 0..100 {
        let middle = 0.5 * (near + far);
        if beyond(piece(middle)) { far = middle } else { near = middle }
    }
    let [_, v] = piece(far);
    walled(force, [SURFACE, v], t - far)
}

/// Channel that keeps every message ever sent, with the tick on which it arrives.
struct Post {
    least: f64,
    spread: f64,
    loss: f64,
    lag: Random<f64>,
    losing: Random<f64>,
    sent: Message,
    letters: Vec<(usize, Message)>,
}

impl Post {
    fn of(file: &Teleoperator, seed: u64) -> Self {
        Self {
            least: file.channel.delay.get().into(),
            spread: file.channel.spread.get().into(),
            loss: file.channel.loss.get(),
            lag: Random::new(|_| seed, Source::Lag),
            losing: Random::new(|_| seed, Source::Loss),
            sent: (0.0, 0.0),
            letters: Vec::new(),
        }
    }

    fn carry(&mut self, message: Message) -> Message {
        if self.losing.uniform() >= self.loss {
            self.sent = message;
        }
        let (now, drawn) = (self.letters.len(), self.lag.uniform());
        let lag = self.least + (drawn * (self.spread + 1.0)).floor();
        self.letters.push((now + lag as usize, self.sent));
        let newest = self.letters.iter().rev().find(|(arrives, _)| *arrives <= now);
        newest.map_or((0.0, 0.0), |(_, message)| *message)
    }
}

/// One port's passivity controller.
#[derive(Default)]
struct Port {
    absorbed: f64,
    gave: f64,
    burnt: f64,
    received: f64,
    most: f64,
}

impl Port {
    /// Books `work`, of which the channel `asked` for so much; the damping, the account before it, and what it leaves unpaid.
    fn serve(&mut self, [asked, work]: [f64; 2], velocity: f64, joined: bool) -> (f64, f64, f64) {
        self.absorbed += asked.max(0.0);
        self.gave += (-asked).max(0.0);
        self.burnt += work - asked;
        let sum = if joined { self.received } else { self.absorbed } - self.gave + self.burnt;
        let square = velocity * velocity * T;
        let moves = sum < 0.0 && square > f64::MIN_POSITIVE;
        let alpha = if moves { (-sum / square).min(self.most) } else { 0.0 };
        (alpha, sum, (-sum - alpha * square).max(0.0))
    }
}

/// Result of a run.
#[derive(Debug, Default)]
struct Found {
    master: Vec<f64>,
    slave: Vec<f64>,
    command: f64,
    drift: f64,
    energy: f64,
    felt: f64,
    kept: f64,
    shortfall: f64,
    active: [usize; 2],
}

fn run(file: &Teleoperator, entrant: Entrant) -> Found {
    let seed = file.channel.seed.map_or(0, |seed| seed.get());
    let (mut there, mut back) = (Post::of(file, seed), Post::of(file, !seed));
    let mut near = Port { most: CAP * MASS / T, ..Port::default() };
    let mut far = Port { most: CAP / ((K + B / T) * T), ..Port::default() };
    let (guarded, waves) = (entrant != Entrant::None, entrant == Entrant::Waves);
    let joined = matches!(entrant, Entrant::TwoPort | Entrant::Compensated);
    let ([mut x, mut v], [mut y, mut w]) = ([START, 0.0], [START, 0.0]);
    let (mut found, mut arrived) = (Found { command: START, ..Found::default() }, (0.0, 0.0));
    let (mut works, mut load, mut drift, mut crossed) = ([[0.0; 2]; 2], 0.0, 0.0, 0.0);
    for _ in 0..=file.ticks() {
        let root = (2.0 * B).sqrt();
        let (asked, mut force, mut sent) = (arrived.0, arrived.0, v);
        let (mut alphas, mut unpaid) = ([0.0; 2], 0.0);
        if waves {
            (force, sent) = (B * v - root * arrived.0, root * v - arrived.0);
        } else if guarded {
            near.received = near.received.max(arrived.1);
            let (alpha, _, short) = near.serve(works[0], v, joined);
            (force, unpaid, alphas[0]) = (force + alpha * v, short, alpha);
        }
        let (signal, energy) = there.carry((sent, near.absorbed));
        let spring = K * (found.command - y);
        let (mut flow, mut pull) = (signal, 0.0);
        if waves {
            // F = spring + B (v − w) and v = (√(2b) u − F) / b with b = B.
            flow = (root * signal - spring + B * w) / (2.0 * B);
        } else if guarded {
            far.received = far.received.max(energy);
            let (beta, sum, short) = far.serve(works[1], load, joined);
            (flow, unpaid, alphas[1]) = (flow + beta * load, unpaid + short, beta);
            if entrant == Entrant::Compensated {
                let back = (-drift / T).clamp(-SPEED, SPEED);
                let answer = (K * T + B) * back.abs() * (flow.abs() + back.abs());
                let draw = (answer - back * load) * T;
                flow += back * if draw > sum.max(0.0) { sum.max(0.0) / draw } else { 1.0 };
                drift += (flow - signal) * T;
            }
        }
        pull += spring + B * (flow - w);
        let answer = if waves { root * flow - signal } else { pull };
        arrived = back.carry((answer, far.absorbed));

        let depth = (y - SURFACE).max(0.0);
        let energy = MASS * (v * v + w * w) + HAND * x * x + WALL * depth * depth;
        found.master.push(x);
        found.slave.push(y);
        found.energy = found.energy.max(0.5 * energy);
        found.drift = found.command - x;
        found.felt = found.felt.max(force.abs());
        let burnt = [alphas[0] * v * v * T, alphas[1] * load * load * T];
        found.kept = found.kept.min(crossed + burnt[0] + burnt[1]);
        found.shortfall = found.shortfall.max(unpaid);
        for (count, burnt) in found.active.iter_mut().zip(burnt) {
            *count += usize::from(burnt > 1e-9 * 0.5 * HAND * START * START);
        }

        let before = x;
        [x, v] = sprung(HAND, -force, [x, v], T);
        [y, w] = walled(pull, [y, w], T);
        found.command += flow * T;
        let moved = x - before;
        works = [[asked * moved, force * moved], [-pull * signal * T, -pull * flow * T]];
        crossed += works[0][1] + works[1][1];
        load = -pull;
    }
    found
}

impl Found {
    #[track_caller]
    fn equals(&self, score: &Score) {
        let last = self.master.len() - 1;
        let (x, y) = (self.master[last], self.slave[last]);
        let pairs = self.master.iter().zip(&self.slave);
        let error = pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
        let deepest = self.slave.iter().copied().fold(SURFACE, f64::max) - SURFACE;
        for (what, told, hand, size) in [
            ("energy", score.energy, 1e3 * self.energy, 1e3 * self.energy),
            ("error", score.error, 1e3 * error, 1e3 * error),
            ("error at the end", score.error_end, 1e3 * (x - y), 1e3 * error),
            ("drift", score.drift, 1e3 * self.drift, 1e3 * error),
            ("force felt", score.felt, self.felt, self.felt),
            ("contact", score.contact, WALL * deepest, WALL * deepest),
            ("least energy", score.kept, 1e3 * self.kept, 1.0 + 1e3 * self.kept.abs()),
            ("shortfall", score.shortfall, 1e3 * self.shortfall, 1.0 + 1e3 * self.shortfall),
        ] {
            let told = told.unwrap();
            let near = (told - hand).abs() <= 1e-7 * size;
            assert!(near, "{what} of {}: {told}, {hand}", score.stabilizer);
        }
        for (told, count) in [score.active_master, score.active_slave].into_iter().zip(self.active)
        {
            let share = 100.0 * count as f64 / self.master.len() as f64;
            // Where a correction is about the threshold, rounding decides whether it counts.
            assert!(
                abs_diff_eq!(told, share, epsilon = 0.1),
                "{}: {told}, {share}",
                score.stabilizer
            );
        }
    }
}

#[test]
fn every_row_matches_the_hand_written_run() {
    for name in NAMES {
        let file = parsed(&text(name));
        let comparison = compared(&file);
        for ((entrant, curves), score) in comparison.curves().zip(comparison.scores()) {
            let found = run(&file, entrant);
            let mut size = 0.01;
            for (device, told, hand) in
                [("master", &curves.master, &found.master), ("slave", &curves.slave, &found.slave)]
            {
                assert_eq!(told.len(), hand.len());
                for ((t, told), hand) in told.iter().zip(hand) {
                    size = hand.abs().max(size);
                    let near = (told - hand).abs() <= FINEST + 1e-8 * size;
                    let name = format!("{device} of {} in {name}", entrant.name());
                    assert!(near, "{name} at {t} s: {told}, {hand}");
                }
            }
            found.equals(score);
        }
    }
}
