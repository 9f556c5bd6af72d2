//! Energy balance of a run, by cause.

use lyapunov::{
    DampingLimit, Lolc, OnePort, ParameterError, Plant, PortEnergy, PortSample, Stabilizer,
    bodies::{Body, Impedance},
    effects::OnePortExt,
    environments::Wall,
};

use super::ensemble::{Control, Loop, Run, Steps, measured};
use super::measures::WINDOW;
use super::member::Member;

/// Steps within a tick for the energy that the dampers dissipate.
const FINE: usize = 40;

/// Energy balance of one run, from the first tick until it has settled, J.
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

    /// Energy balance of the single run of `member` in front of `wall`, under our steps, until it has settled.
    ///
    /// # Errors
    /// A number that a part rejects.
    pub fn of(
        control: Control,
        member: &Member,
        [stiffness, damping]: [f64; 2],
    ) -> Result<Self, ParameterError> {
        let looped = Loop { control, steps: Steps::Ours };
        let measures = measured(looped, &[Run { member, wall: [stiffness, damping] }])?;
        let settled = measures.first().and_then(|run| run.settled).unwrap_or(WINDOW);
        let (scene, period) = (&member.scene, member.scene.period());
        let hand = Impedance {
            mass: scene.port_mass(),
            damping: scene.operator.damping.get() + scene.device.damping.get(),
            stiffness: scene.operator.stiffness.get(),
        };
        let wall = Wall::new(stiffness, damping)?;
        let limit = DampingLimit::of_mass(member.cap, member.limit_mass, period)?;
        let start = (scene.initial.position.get(), scene.initial.velocity.get());
        let body = Body::new(hand, period)?.starting(start.0, start.1);
        let fine = Body::new(hand, period / FINE as f64)?;
        let plant = Finely { hand, body, fine };
        let port = wall.held(u32::try_from(scene.environment_ratio()).unwrap_or(u32::MAX))?;
        let ticks = (settled * member.rate()).round() as usize;
        Ok(match control {
            Control::None => plant.follow(ticks, port, |_, force| force),
            Control::Popc => {
                let mut popc = Lolc::new(PortEnergy, limit);
                plant.follow(ticks, port, |d, f| popc.stabilize(d, f).effort)
            }
            Control::Lolc => {
                let mut lolc = Lolc::new((PortEnergy, wall.dissipation()), limit);
                plant.follow(ticks, port, |d, f| lolc.stabilize(d, f).effort)
            }
        })
    }
}

/// A plant whose motion within a tick is seen in fine steps.
struct Finely {
    hand: Impedance<f64>,
    body: Body<f64>,
    fine: Body<f64>,
}

impl Finely {
    fn follow(
        mut self,
        ticks: usize,
        mut port: impl OnePort<f64>,
        mut stabilize: impl FnMut(&PortSample<f64>, f64) -> f64,
    ) -> Balance {
        let mut now = self.body.start();
        let mut balance = Balance { start: self.stored(&now), ..Balance::default() };
        for _ in 0..ticks {
            let seen = PortSample { velocity: now.displacement / now.period, ..now };
            let force = port.respond(&seen);
            let applied = stabilize(&seen, force);
            balance.burnt += self.burnt(&now, applied);
            now = self.body.advance(applied);
            balance.wall += force * now.displacement;
            balance.controller += (applied - force) * now.displacement;
        }
        balance.end = self.stored(&now);
        balance
    }

    /// Stored in motion and spring, J.
    fn stored(&self, at: &PortSample<f64>) -> f64 {
        let Impedance { mass, stiffness, .. } = self.hand;
        0.5 * (mass * at.velocity * at.velocity + stiffness * at.position * at.position)
    }

    /// Dissipated by the damper over the tick from `now` on, J: `b ∫ v² dt` by the trapezoidal rule.
    fn burnt(&self, now: &PortSample<f64>, applied: f64) -> f64 {
        let mut body = self.fine.starting(now.position, now.velocity);
        let mut squares = 0.5 * now.velocity * now.velocity;
        let mut last = squares;
        for _ in 0..FINE {
            let velocity = body.advance(applied).velocity;
            squares += velocity * velocity;
            last = 0.5 * velocity * velocity;
        }
        self.hand.damping * (squares - last) * now.period / FINE as f64
    }
}
