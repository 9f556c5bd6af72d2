//! Run of a teleoperator's loop.

use std::ops::ControlFlow;

use lyapunov::{AdmittanceSample, Correction, HeldFlow, ParameterError, Plant, PortSample, Scalar};

use super::building::{self, AnyChannel};
use super::entrant::Entrant;
use super::link::{Coordination, Link, Message, Slave};
use crate::files::scene::{self, Refused};
use crate::files::teleoperation::Teleoperator;
use crate::simulate::building::AnyPlant;

/// Two devices, a channel each way, and the link that turns motion and force into messages.
struct Rig<T: Scalar> {
    master: AnyPlant<T>,
    slave: AnyPlant<T>,
    there: AnyChannel<T>,
    back: AnyChannel<T>,
    link: Box<dyn Link<T>>,
    stiffness: T,
    damping: T,
    period: T,
}

/// One tick of a run: positions and velocities in m and m/s, the force on the master in N.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tick {
    pub(crate) master: [f64; 2],
    pub(crate) slave: [f64; 2],
    /// The position commanded to the slave.
    pub(crate) command: f64,
    pub(crate) felt: f64,
    /// The energy that the link has taken from the motion of both devices, J.
    pub(crate) taken: f64,
    /// The energy that has crossed the master's port and the commanded one, J.
    pub(crate) crossed: f64,
    /// The energies that the corrections at master and slave are about to dissipate, J.
    pub(crate) burnt: [f64; 2],
    /// The debt of both ends that this tick cannot serve, J.
    pub(crate) shortfall: f64,
}

impl Tick {
    /// The energy that the master's port and the commanded one have absorbed once the corrections are made, J.
    pub(crate) fn kept(&self) -> f64 {
        self.crossed + self.burnt[0] + self.burnt[1]
    }

    pub(crate) fn is_finite(&self) -> bool {
        let moved = self.master.iter().chain(&self.slave).all(|it| it.is_finite());
        moved
            && [self.command, self.felt, self.taken, self.kept(), self.shortfall]
                .iter()
                .all(|it| it.is_finite())
    }
}

/// The samples of both ports on a tick, and what is known from the tick before.
struct State<T: Scalar> {
    master: PortSample<T>,
    slave: PortSample<T>,
    load: PortSample<T>,
    /// The position commanded to the slave, m.
    command: T,
    arrived: Message<T>,
    /// The energy that the link has taken from the motion of both devices, J.
    taken: f64,
    /// The energy that has crossed the master's port and the commanded one, J.
    crossed: f64,
}

/// Builds the loop of `file` under `entrant` and drops it.
pub(crate) fn build(file: &Teleoperator, entrant: Entrant) -> Result<(), Refused> {
    match file.scalar {
        scene::Scalar::F64 => Rig::<f64>::of(file, entrant).map(drop),
        scene::Scalar::F32 => Rig::<f32>::of(file, entrant).map(drop),
    }
}

/// Runs `file` under `entrant` until the end, until the range is left, or until `each` of the ticks breaks off.
///
/// # Errors
/// A file that was never checked.
pub(crate) fn run(
    file: &Teleoperator,
    entrant: Entrant,
    each: &mut dyn FnMut(Tick) -> ControlFlow<()>,
) -> Result<(), ParameterError> {
    match file.scalar {
        scene::Scalar::F64 => run_in::<f64>(file, entrant, each),
        scene::Scalar::F32 => run_in::<f32>(file, entrant, each),
    }
}

fn run_in<T: Scalar>(
    file: &Teleoperator,
    entrant: Entrant,
    each: &mut dyn FnMut(Tick) -> ControlFlow<()>,
) -> Result<(), ParameterError> {
    let mut rig = Rig::<T>::of(file, entrant).map_err(|(_, error)| error)?;
    let mut state = rig.start();
    for _ in 0..=file.ticks() {
        let tick = rig.step(&mut state);
        if !tick.is_finite() || each(tick).is_break() {
            break;
        }
    }
    Ok(())
}

impl<T: Scalar> Rig<T> {
    fn of(file: &Teleoperator, entrant: Entrant) -> Result<Self, Refused> {
        let [there, back] = building::channels(file)?;
        Ok(Self {
            master: building::master(file)?,
            slave: building::slave(file)?,
            there,
            back,
            link: building::link(file, entrant)?,
            stiffness: T::of(file.coordination.stiffness.get()),
            damping: T::of(file.coordination.damping.get()),
            period: building::period(file),
        })
    }

    fn start(&self) -> State<T> {
        let (master, slave) = (self.master.start(), self.slave.start());
        let zero = T::of(0.0);
        let load = AdmittanceSample::starting(self.period, zero).into();
        let command = slave.position;
        let arrived = (zero, zero);
        State { master, slave, load, command, arrived, taken: 0.0, crossed: 0.0 }
    }

    /// One tick, and the motion to the next.
    fn step(&mut self, state: &mut State<T>) -> Tick {
        let State { master, slave, load, command, arrived, taken, crossed } = state;
        let (felt, sent) = self.link.at_master(master, *arrived);
        let message = self.there.carry(sent);
        let coordination = Coordination {
            stiffness: self.stiffness,
            damping: self.damping,
            error: *command - slave.position,
            velocity: slave.velocity,
        };
        let end = Slave { load, motion: slave, coordination };
        let (moves, pull, answer) = self.link.at_slave(&end, message);
        *arrived = self.back.carry(answer);
        let tick = Tick {
            master: [master.position, master.velocity].map(|it| it.lane(0)),
            slave: [slave.position, slave.velocity].map(|it| it.lane(0)),
            command: command.lane(0),
            felt: felt.effort.lane(0),
            taken: *taken,
            crossed: *crossed,
            burnt: [burnt(master, &felt), burnt(load, &moves)],
            shortfall: (felt.shortfall + moves.shortfall).lane(0),
        };
        let flow = moves.effort;
        *master = self.master.advance(felt.effort);
        *slave = self.slave.advance(-pull);
        *command += flow * self.period;
        *load = HeldFlow {
            period: self.period,
            momentum: T::of(0.0),
            effort: -pull,
            impulse: -pull * self.period,
            flow,
        }
        .sample()
        .into();
        *taken += (master.work + slave.work).lane(0);
        *crossed += (master.work + load.work).lane(0);
        tick
    }
}

/// The energy that a correction is about to dissipate, J.
fn burnt<T: Scalar>(sample: &PortSample<T>, correction: &Correction<T>) -> f64 {
    (correction.alpha * (sample.velocity * sample.velocity * sample.period)).lane(0)
}
