//! Plant of the reference: one mass or two, with or without friction.

use crate::effects::integrate::gain;
use crate::effects::scene::{Friction, Scene};

/// Position and velocity of the device, then of the operator, on one axis.
pub(crate) type State = [f64; 4];

/// The plant on one axis during one tick.
pub(crate) struct Plant {
    device: [f64; 2],
    operator: [f64; 2],
    stiffness: f64,
    rest: f64,
    link: Option<[f64; 2]>,
    friction: Option<Friction>,
    /// Force held on the device over the tick: the push less the port's force.
    force: f64,
}

#[derive(Clone, Copy, PartialEq)]
enum Phase {
    Sticks,
    Slides(f64),
}

impl Plant {
    /// The plant under `grip`, the operator's stiffness and damping, with its spring at `rest`.
    pub(crate) fn new(scene: &Scene, grip: [f64; 2], rest: f64, force: f64) -> Self {
        let ([stiffness, damping], link) = (grip, scene.link);
        let (operator, device) = match link {
            Some(_) => ([scene.operator.mass, damping], scene.device),
            None => {
                let [mass, own] = scene.device;
                ([1.0, 0.0], [scene.operator.mass + mass, damping + own])
            }
        };
        Self { device, operator, stiffness, rest, link, friction: scene.friction, force }
    }

    /// Every force on the device but friction.
    fn others(&self, [x, v, y, w]: State) -> f64 {
        let held = match self.link {
            Some([k, b]) => k * (y - x) + b * (w - v),
            None => self.stiffness * (self.rest - x),
        };
        held - self.device[1] * v + self.force
    }

    fn rate(&self, state: State, phase: Phase) -> State {
        let [x, v, y, w] = state;
        let others = self.others(state);
        let pull = match (self.friction, phase) {
            (Some(law), Phase::Slides(direction)) => others - direction * law.at(v),
            _ => others,
        };
        let (dx, dv) = match phase {
            Phase::Sticks => (0.0, 0.0),
            Phase::Slides(_) => (v, pull / self.device[0]),
        };
        let Some([k, b]) = self.link else {
            return [dx, dv, 0.0, 0.0];
        };
        let on_operator =
            self.stiffness * (self.rest - y) - self.operator[1] * w - k * (y - x) - b * (w - v);
        [dx, dv, w, on_operator / self.operator[0]]
    }

    /// Step that resolves the fastest dynamics.
    fn step(&self, state: State, phase: Phase) -> f64 {
        let [k, b] = self.link.unwrap_or_default();
        let speed = |[mass, damping]: [f64; 2], stiffness: f64| {
            (damping + b) / mass + ((stiffness + k) / mass).sqrt()
        };
        let mut fastest = match self.link {
            None => speed(self.device, self.stiffness),
            Some(_) => speed(self.device, 0.0) + speed(self.operator, self.stiffness),
        };
        if let Some(law) = self.friction {
            let slope = (law.breakaway - law.coulomb) / (law.stribeck_velocity * self.device[0]);
            // Far above that velocity the law is flat, and only the way down to it needs resolving.
            let far = state[1].abs() > 20.0 * law.stribeck_velocity;
            let room = if far { 0.5 * state[1].abs() } else { law.stribeck_velocity };
            fastest += slope + self.rate(state, phase)[1].abs() / room;
        }
        0.3 / fastest.max(1e-9)
    }

    /// The state after `interval` s.
    pub(crate) fn advance(&self, mut state: State, interval: f64) -> State {
        let mut phase = Phase::Slides(1.0);
        if let Some(law) = self.friction {
            phase = if state[1] == 0.0 {
                self.leaving_rest(law, state)
            } else {
                Phase::Slides(state[1].signum())
            };
        }
        let mut left = interval;
        while left > 0.0 {
            // Equal steps, so that none is left over by rounding.
            let step = left / (left / self.step(state, phase)).ceil().max(1.0);
            let moved = |part: f64| {
                let gained = gain(state, part * step, |state| self.rate(state, phase));
                std::array::from_fn(|index| state[index] + gained[index])
            };
            let over = |after: State| self.friction.is_some_and(|law| self.ends(law, phase, after));
            if !over(moved(1.0)) {
                (state, left) = (moved(1.0), if step < left { left - step } else { 0.0 });
                continue;
            }
            let law = self.friction.expect("only friction ends a phase");
            let (mut low, mut high) = (0.0, 1.0);
            for _ in 0..60 {
                let middle = 0.5 * (low + high);
                if over(moved(middle)) {
                    high = middle;
                } else {
                    low = middle;
                }
            }
            state = moved(high);
            left -= high * step;
            phase = match phase {
                Phase::Sticks => Phase::Slides(self.others(state).signum()),
                Phase::Slides(_) => {
                    state[1] = 0.0;
                    self.leaving_rest(law, state)
                }
            };
        }
        state
    }

    fn leaving_rest(&self, law: Friction, state: State) -> Phase {
        let others = self.others(state);
        if others.abs() <= law.breakaway { Phase::Sticks } else { Phase::Slides(others.signum()) }
    }

    fn ends(&self, law: Friction, phase: Phase, state: State) -> bool {
        match phase {
            Phase::Sticks => self.others(state).abs() > law.breakaway,
            Phase::Slides(direction) => state[1] * direction < 0.0,
        }
    }
}

impl Friction {
    fn at(&self, v: f64) -> f64 {
        let part = v / self.stribeck_velocity;
        self.coulomb + (self.breakaway - self.coulomb) * (-part * part).exp()
    }
}
