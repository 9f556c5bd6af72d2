//! Energy balance of a run, by cause.

use lyapunov::{
    DampingLimit, HeldTick, Lolc, OnePort, ParameterError, Plant, PortEnergy, PortSample,
    Stabilizer,
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::Wall,
};

use super::ensemble::{Control, DURATION, START, Setting};

/// Steps within a tick for the energy that the dampers dissipate.
const FINE: usize = 40;

/// Energy balance of one run from the paper's start, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Balance {
    /// Stored in the operator's spring at the start.
    pub start: f64,
    /// Dissipated by the dampers of operator and device.
    pub burnt: f64,
    /// Taken by the wall's force; negative where the loop generated energy.
    pub wall: f64,
    /// Taken by the controller's force.
    pub controller: f64,
    /// Stored in motion and spring at the end.
    pub end: f64,
}

impl Balance {
    /// Energy that the causes do not explain: the error of the fine integration.
    pub fn residual(&self) -> f64 {
        self.start - self.burnt - self.wall - self.controller - self.end
    }

    /// Energy balance of one run of `setting` over held work.
    ///
    /// # Errors
    /// A number that a part rejects.
    pub fn of(setting: &Setting) -> Result<Self, ParameterError> {
        let period = setting.period();
        let hand = Impedance { mass: 0.3, damping: 0.201, stiffness: 50.0 };
        let wall = Wall::new(setting.stiffness, setting.damping)?;
        let limit = DampingLimit::of_mass(setting.cap, hand.mass, period)?;
        let fine = Body::new(hand, period / FINE as f64)?.starting(START, 0.0);
        let popc = Lolc::new(PortEnergy, limit);
        let lolc = Lolc::new((PortEnergy, wall.dissipation()), limit);
        let port = wall.held((setting.servo_rate / 100.0).round() as u32)?;
        let ticks = (DURATION * setting.servo_rate).round() as usize;
        Ok(match setting.control {
            Control::None => follow(hand, period, ticks, fine, port, |_, force| force),
            Control::Popc => {
                let mut popc = popc;
                follow(hand, period, ticks, fine, port, |d, f| popc.stabilize(d, f).effort)
            }
            Control::Lolc => {
                let mut lolc = lolc;
                follow(hand, period, ticks, fine, port, |d, f| lolc.stabilize(d, f).effort)
            }
        })
    }
}

fn follow(
    hand: Impedance<f64>,
    period: f64,
    ticks: usize,
    mut fine: Body<f64>,
    mut port: impl OnePort<f64>,
    mut stabilize: impl FnMut(&PortSample<f64>, f64) -> f64,
) -> Balance {
    let stored = |d: &PortSample<f64>| {
        0.5 * (hand.mass * d.velocity * d.velocity + hand.stiffness * d.position * d.position)
    };
    let mut now = fine.start();
    let mut balance = Balance { start: stored(&now), ..Balance::default() };
    let (mut moved, mut applied) = (0.0, 0.0);
    for _ in 0..ticks {
        let seen = HeldTick {
            period,
            position: now.position,
            velocity: moved / period,
            displacement: moved,
            applied,
        }
        .sample();
        let force = port.respond(&seen);
        applied = stabilize(&seen, force);
        let before = now.position;
        let mut squares = 0.5 * now.velocity * now.velocity;
        for _ in 0..FINE {
            now = fine.advance(applied);
            squares += now.velocity * now.velocity;
        }
        squares -= 0.5 * now.velocity * now.velocity;
        moved = now.position - before;
        balance.burnt += hand.damping * squares * period / FINE as f64;
        balance.wall += force * moved;
        balance.controller += (applied - force) * moved;
    }
    balance.end = stored(&now);
    balance
}
