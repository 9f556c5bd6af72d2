//! Hand-written runs of the shipped files, which use nothing of the library but its random numbers.

use lyapunov::effects::{Random, Source};
use lyapunov_lab::compare::Named;
use lyapunov_lab::teleoperation::{Entrant, Teleoperator};

use crate::teleoperation::found::Found;
use crate::teleoperation::shipped::{NAMES, compared, parsed, text};

const T: f64 = 1e-3;
const MASS: f64 = 0.3;
const DAMPING: f64 = 1.0;
const HAND: f64 = 100.0;
const START: f64 = -0.01;
pub(super) const WALL: f64 = 2000.0;
pub(super) const SURFACE: f64 = -0.005;
const K: f64 = 200.0;
const B: f64 = 2.0;
const CAP: f64 = 0.5;
const SPEED: f64 = 0.02;
const SHARE: f64 = 0.1;
const WAVE: f64 = 8.0;

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
    letters: Vec<(usize, Option<Message>)>,
}

impl Post {
    fn of(file: &Teleoperator, seed: u64) -> Self {
        Self {
            least: file.channel.delay.get().into(),
            spread: file.channel.spread.get().into(),
            loss: file.channel.loss.get(),
            lag: Random::new(|_| seed, Source::Lag),
            losing: Random::new(|_| seed, Source::Loss),
            letters: Vec::new(),
        }
    }

    fn carry(&mut self, message: Message) -> Message {
        let kept = (self.losing.uniform() >= self.loss).then_some(message);
        let (now, drawn) = (self.letters.len(), self.lag.uniform());
        let lag = self.least + (drawn * (self.spread + 1.0)).floor();
        self.letters.push((now + lag as usize, kept));
        let arrived = |(arrives, kept): &(usize, Option<Message>)| kept.filter(|_| *arrives <= now);
        self.letters.iter().rev().find_map(arrived).unwrap_or((0.0, 0.0))
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

/// One end's tank.
#[derive(Default)]
struct Tank {
    held: f64,
    received: f64,
    sent: f64,
}

impl Tank {
    /// Takes in what is new of `told` and the `work` of the last tick, and sends a share; the force that is left of the
    /// `wished` one at `velocity`, and the debt.
    fn serve(&mut self, told: f64, work: f64, wished: f64, velocity: f64) -> (f64, f64) {
        self.held += (told - self.received).max(0.0) + work;
        self.received = self.received.max(told);
        let packet = SHARE * self.held.max(0.0);
        self.held -= packet;
        self.sent += packet;
        let most = self.held.max(0.0) / (velocity.abs() * T);
        let left = if self.held > 0.0 { wished.clamp(-most, most) } else { 0.0 };
        (left, (-self.held).max(0.0))
    }
}

/// One tick at one end: the force on the master or the velocity commanded, what acts on the device, the message, the
/// damping or mobility, and what is left unpaid.
struct Answer {
    given: f64,
    acts: f64,
    sent: Message,
    alpha: f64,
    unpaid: f64,
}

/// What an end knows of the tick before: the work that the channel asked for and that was done at the port, the work of
/// the device's own motion, and the force that came in.
#[derive(Clone, Copy, Default)]
struct Before {
    works: [f64; 2],
    own: f64,
    load: f64,
}

/// The law of one entrant at both ends.
enum Law {
    None,
    Ports { near: Port, far: Port, joined: bool, speed: f64, drift: f64 },
    Tanks { near: Tank, far: Tank, level: f64, gain: f64 },
    Line { damping: f64, share: f64, there: f64, back: f64 },
}

impl Law {
    fn of(file: &Teleoperator, entrant: Entrant) -> Self {
        let longest = f64::from(file.channel.delay.get() + file.channel.spread.get());
        let trip = (2.0 * longest + 1.0) * T;
        let ports = |joined, speed| Self::Ports {
            near: Port { most: CAP * MASS / T, ..Port::default() },
            far: Port { most: CAP / ((K + B / T) * T), ..Port::default() },
            joined,
            speed,
            drift: 0.0,
        };
        let line = |damping, share| Self::Line { damping, share, there: 0.0, back: 0.0 };
        match entrant {
            Entrant::None => Self::None,
            Entrant::Popc => ports(false, 0.0),
            Entrant::TwoPort => ports(true, 0.0),
            Entrant::Compensated => ports(true, SPEED),
            Entrant::TwoLayer => {
                let level = 0.5 * HAND * START * START;
                let (near, far) = (Tank::default(), Tank::default());
                Self::Tanks { near, far, level, gain: (B + K * trip) / level }
            }
            Entrant::Waves => line(B, 1.0),
            Entrant::MatchedWaves => line(WAVE, 1.0),
            Entrant::FilteredWaves => line(WAVE, T / (T + 0.1 * trip)),
        }
    }

    fn near(&mut self, (signal, energy): Message, before: Before, v: f64) -> Answer {
        let root = (2.0 * WAVE).sqrt();
        let (acts, sent, alpha, unpaid) = match self {
            Self::None => (signal, (v, 0.0), 0.0, 0.0),
            Self::Ports { near, joined, .. } => {
                near.received = near.received.max(energy);
                let (alpha, _, unpaid) = near.serve(before.works, v, *joined);
                (signal + alpha * v, (v, near.absorbed), alpha, unpaid)
            }
            Self::Tanks { near, level, gain, .. } => {
                let (left, unpaid) = near.serve(energy, before.own, signal, v);
                let damping = *gain * (*level - near.held).max(0.0);
                (left + damping * v, (v, near.sent), damping, unpaid)
            }
            Self::Line { share, there, .. } => {
                *there += *share * (root * v - signal - *there);
                (WAVE * v - root * signal, (*there, 0.0), 0.0, 0.0)
            }
        };
        Answer { given: acts, acts, sent, alpha, unpaid }
    }

    /// At the slave, which is `error` behind the command and moves at `w`.
    fn far(&mut self, (signal, energy): Message, before: Before, error: f64, w: f64) -> Answer {
        let pull = |flow: f64, damping: f64| K * error + damping * (flow - w);
        let acting = |given: f64, told, alpha, unpaid| {
            let acts = pull(given, B);
            Answer { given, acts, sent: (acts, told), alpha, unpaid }
        };
        match self {
            Self::None => acting(signal, 0.0, 0.0, 0.0),
            Self::Ports { far, joined, speed, drift, .. } => {
                far.received = far.received.max(energy);
                let (beta, sum, unpaid) = far.serve(before.works, before.load, *joined);
                let mut flow = signal + beta * before.load;
                let back = (-*drift / T).clamp(-*speed, *speed);
                let answer = (K * T + B) * back.abs() * (flow.abs() + back.abs());
                let draw = (answer - back * before.load) * T;
                let credit = (sum + (flow * before.load).min(0.0) * T).max(0.0);
                flow += back * if draw > credit { credit / draw } else { 1.0 };
                *drift += (flow - signal) * T;
                acting(flow, far.absorbed, beta, unpaid)
            }
            Self::Tanks { far, .. } => {
                let (acts, unpaid) = far.serve(energy, before.own, pull(signal, B), w);
                Answer { given: signal, acts, sent: (acts, far.sent), alpha: 0.0, unpaid }
            }
            Self::Line { damping, share, back, .. } => {
                // F = K e + B' (v − w) and v = (√(2b) u − F) / b.
                let root = (2.0 * WAVE).sqrt();
                let given = (root * signal - K * error + *damping * w) / (WAVE + *damping);
                *back += *share * (root * given - signal - *back);
                let acts = pull(given, *damping);
                Answer { given, acts, sent: (*back, 0.0), alpha: 0.0, unpaid: 0.0 }
            }
        }
    }
}

fn run(file: &Teleoperator, entrant: Entrant) -> Found {
    let seed = file.channel.seed.map_or(0, |seed| seed.get());
    let (mut there, mut back) = (Post::of(file, seed), Post::of(file, !seed));
    let mut law = Law::of(file, entrant);
    let ([mut x, mut v], [mut y, mut w]) = ([START, 0.0], [START, 0.0]);
    let (mut found, mut arrived) = (Found { command: START, ..Found::default() }, (0.0, 0.0));
    let ([mut near, mut far], mut crossed, mut taken) = ([Before::default(); 2], 0.0, 0.0);
    for tick in 0..=file.ticks() {
        let asked = arrived.0;
        let felt = law.near(arrived, near, v);
        let message = there.carry(felt.sent);
        let moves = law.far(message, far, found.command - y, w);
        arrived = back.carry(moves.sent);

        let depth = (y - SURFACE).max(0.0);
        if depth > 0.0 {
            found.touch.get_or_insert(tick as f64 / 1e3);
        }
        let energy = MASS * (v * v + w * w) + HAND * x * x + WALL * depth * depth;
        found.master.push(x);
        found.slave.push(y);
        found.energy = found.energy.max(0.5 * energy);
        found.drift = found.command - x;
        found.felt = found.felt.max(felt.acts.abs());
        if tick >= 4500 {
            found.felt_end += felt.acts / 501.0;
        }
        let burnt = [felt.alpha * v * v * T, moves.alpha * far.load * far.load * T];
        found.given = found.given.max(-taken);
        found.kept = found.kept.min(crossed + burnt[0] + burnt[1]);
        found.shortfall = found.shortfall.max(felt.unpaid + moves.unpaid);
        for (count, burnt) in found.active.iter_mut().zip(burnt) {
            *count += usize::from(burnt > 1e-9 * 0.5 * HAND * START * START);
        }

        let ([last_x, last_y], pull) = ([x, y], moves.acts);
        [x, v] = sprung(HAND, -felt.acts, [x, v], T);
        [y, w] = walled(pull, [y, w], T);
        found.command += moves.given * T;
        let (moved, own) = (x - last_x, felt.acts * (x - last_x));
        near = Before { works: [asked * moved, own], own, load: 0.0 };
        let works = [-pull * message.0 * T, -pull * moves.given * T];
        far = Before { works, own: -pull * (y - last_y), load: -pull };
        crossed += near.works[1] + far.works[1];
        taken += near.own + far.own;
    }
    found
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
