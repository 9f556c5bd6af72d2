//! Loops of known truth, integrated finely and without the library.

use std::fmt::Write;

/// Device, hand and wall of a loop, and what its log suffers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Truth {
    pub(super) mass: f64,
    pub(super) damping: f64,
    pub(super) stiffness: f64,
    pub(super) rest: f64,
    /// Position, stiffness and damping of the wall.
    pub(super) wall: [f64; 3],
    /// Deviation of the position's noise, m, and the encoder's step, m.
    pub(super) noise: f64,
    pub(super) encoder: f64,
    /// Deviation of the noise of another sensor, which wrote the log, m. The loop does not see it.
    pub(super) blur: f64,
    /// Ticks by which the force acts late on the device.
    pub(super) late: usize,
    /// Share of the last velocity in the one that the wall sees, 0 without a filter, and the force that it is clipped at, N.
    pub(super) filter: f64,
    pub(super) limit: f64,
    /// Amplitude of a hand that swings its rest at 2 Hz, m.
    pub(super) swing: f64,
}

/// A device at rest on a spring, and a damped wall in its way.
pub(super) const PLAIN: Truth = Truth {
    mass: 0.3,
    damping: 2.1,
    stiffness: 200.0,
    rest: 0.01,
    wall: [0.002, 1000.0, 10.0],
    noise: 0.0,
    encoder: 0.0,
    blur: 0.0,
    late: 0,
    filter: 0.0,
    limit: f64::INFINITY,
    swing: 0.0,
};

/// Numbers that look random, by the generator of Marsaglia (xorshift).
pub(super) struct Chance(u64);

impl Chance {
    pub(super) fn new(seed: u64) -> Self {
        let mut chance = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        (0..20).for_each(|_| {
            chance.even();
        });
        chance
    }

    /// Even in [0, 1).
    pub(super) fn even(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Normal, by Box and Muller.
    fn normal(&mut self) -> f64 {
        let (one, other) = (1.0 - self.even(), self.even());
        (-2.0 * one.ln()).sqrt() * (std::f64::consts::TAU * other).cos()
    }

    /// A factor within a fifth of 1.
    fn about_one(&mut self) -> f64 {
        0.8 + 0.4 * self.even()
    }
}

impl Truth {
    /// The same with device, hand and wall within a fifth.
    pub(super) fn varied(self, chance: &mut Chance) -> Self {
        let [place, stiffness, damping] = self.wall;
        Self {
            mass: self.mass * chance.about_one(),
            damping: self.damping * chance.about_one(),
            stiffness: self.stiffness * chance.about_one(),
            rest: self.rest * chance.about_one(),
            wall: [place, stiffness * chance.about_one(), damping * chance.about_one()],
            ..self
        }
    }

    /// A log at 1 kHz of `rows` rows, from about −4 mm on.
    pub(super) fn log(&self, rows: usize, chance: &mut Chance) -> String {
        const PERIOD: f64 = 1e-3;
        const STEPS: u32 = 10;
        let [place, stiffness, damping] = self.wall;
        let (mut x, mut v) = (-0.004 + 0.004 * chance.even(), 0.0);
        let (mut last, mut speed, mut forces) = (None, 0.0, Vec::new());
        let mut log = String::from("t,x,f\n");
        for row in 0..rows {
            let time = PERIOD * row as f64;
            let mut seen = x + self.noise * chance.normal();
            if self.encoder > 0.0 {
                seen = (seen / self.encoder).round() * self.encoder;
            }
            let difference = last.map_or(0.0, |last| (seen - last) / PERIOD);
            speed = self.filter * speed + (1.0 - self.filter) * difference;
            last = Some(seen);
            let depth = seen - place;
            let force =
                if depth > 0.0 { (stiffness * depth + damping * speed).max(0.0) } else { 0.0 };
            let force = force.min(self.limit);
            forces.push(force);
            let told = seen + self.blur * chance.normal();
            writeln!(log, "{time:?},{told:?},{force:?}").unwrap();
            let acting = if row < self.late { 0.0 } else { forces[row - self.late] };
            for step in 0..STEPS {
                let length = PERIOD / f64::from(STEPS);
                (x, v) = self.stepped(time + length * f64::from(step), length, (x, v), acting);
            }
        }
        log
    }

    /// A step of the classical method of Runge and Kutta.
    fn stepped(&self, time: f64, step: f64, (x, v): (f64, f64), force: f64) -> (f64, f64) {
        let rate = |time: f64, x: f64, v: f64| {
            let rest = self.rest + self.swing * (2.0 * std::f64::consts::TAU * time).sin();
            (v, (-self.damping * v - self.stiffness * (x - rest) - force) / self.mass)
        };
        let after = |share: f64, (dx, dv): (f64, f64)| {
            rate(time + share * step, x + share * step * dx, v + share * step * dv)
        };
        let first = rate(time, x, v);
        let second = after(0.5, first);
        let third = after(0.5, second);
        let fourth = after(1.0, third);
        let mean = |of: fn(&(f64, f64)) -> f64| {
            (of(&first) + 2.0 * of(&second) + 2.0 * of(&third) + of(&fourth)) / 6.0
        };
        (x + step * mean(|it| it.0), v + step * mean(|it| it.1))
    }
}
