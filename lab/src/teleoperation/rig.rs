//! The loop of a teleoperator, run.

use lyapunov::{AdmittanceSample, Correction, Plant, PortSample, Scalar};

use super::building::{self, AnyChannel, Refused};
use super::contestant::Contestant;
use super::coordination::Coordination;
use super::link::{Link, Message};
use super::meter::{Meter, Tick};
use super::score::Outcome;
use super::teleoperator::Teleoperator;
use crate::building::AnyPlant;
use crate::scene;
use crate::subjects::{CompareError, Watch};

/// Ticks between two reports of progress.
const BREATH: u64 = 1 << 14;

/// Two devices, a channel each way and what makes messages of motion and force.
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

/// What both ports tell on a tick, and what is known from the tick before.
struct State<T: Scalar> {
    master: PortSample<T>,
    slave: PortSample<T>,
    load: PortSample<T>,
    /// Where the slave is wanted, m.
    command: T,
    arrived: Message<T>,
    /// What has crossed both ports, J.
    crossed: f64,
}

/// Builds the loop of `file` under `contestant` and lets it go.
pub(super) fn build(file: &Teleoperator, contestant: Contestant) -> Result<(), Refused> {
    match file.scalar {
        scene::Scalar::F64 => Rig::<f64>::of(file, contestant).map(drop),
        scene::Scalar::F32 => Rig::<f32>::of(file, contestant).map(drop),
    }
}

/// What `contestant` comes to on `file`.
pub(super) fn run(
    file: &Teleoperator,
    contestant: Contestant,
    watch: &Watch<'_>,
) -> Result<Outcome, CompareError> {
    match file.scalar {
        scene::Scalar::F64 => run_in::<f64>(file, contestant, watch),
        scene::Scalar::F32 => run_in::<f32>(file, contestant, watch),
    }
}

fn run_in<T: Scalar>(
    file: &Teleoperator,
    contestant: Contestant,
    watch: &Watch<'_>,
) -> Result<Outcome, CompareError> {
    let mut rig =
        Rig::<T>::of(file, contestant).map_err(|(_, error)| CompareError::Parameter(error))?;
    let (mut state, mut meter) = (rig.start(), Meter::new(file));
    for tick in 1..=file.ticks() + 1 {
        if !rig.step(&mut state, &mut meter) {
            break;
        }
        if tick % BREATH == 0 && watch(BREATH).is_break() {
            return Err(CompareError::Stopped);
        }
    }
    // What was not run counts as done: a run that leaves the range has no more ticks.
    let told = meter.ticks() / BREATH * BREATH;
    let ended = watch(file.ticks() + 1 - told);
    if ended.is_break() { Err(CompareError::Stopped) } else { Ok(meter.finish(contestant)) }
}

impl<T: Scalar> Rig<T> {
    fn of(file: &Teleoperator, contestant: Contestant) -> Result<Self, Refused> {
        let [there, back] = building::channels(file)?;
        Ok(Self {
            master: building::master(file)?,
            slave: building::slave(file)?,
            there,
            back,
            link: building::link(file, contestant)?,
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
        State { master, slave, load, command, arrived: (zero, zero), crossed: 0.0 }
    }

    /// One tick, and the motion to the next; whether everything is still within range.
    fn step(&mut self, state: &mut State<T>, meter: &mut Meter) -> bool {
        let State { master, slave, load, command, arrived, crossed } = state;
        let (felt, sent) = self.link.at_master(master, *arrived);
        let message = self.there.carry(sent);
        let coordination = Coordination::new(self.stiffness, self.damping, *command, slave);
        let (moves, pull, answer) = self.link.at_slave(load, message, &coordination);
        *arrived = self.back.carry(answer);
        let tick = Tick {
            master: [master.position, master.velocity].map(|it| it.lane(0)),
            slave: [slave.position, slave.velocity].map(|it| it.lane(0)),
            command: command.lane(0),
            felt: felt.effort.lane(0),
            crossed: *crossed,
            burnt: [burnt(master, &felt), burnt(load, &moves)],
            shortfall: (felt.shortfall + moves.shortfall).lane(0),
        };
        let sound = tick.is_finite();
        if sound {
            meter.add(tick);
        }
        let flow = moves.effort;
        *master = self.master.advance(felt.effort);
        *slave = self.slave.advance(-pull);
        *command += flow * self.period;
        *load =
            AdmittanceSample::new(self.period, T::of(0.0), -pull, -pull * self.period, flow).into();
        *crossed += (master.work + load.work).lane(0);
        sound
    }
}

/// What a correction is about to burn, J.
fn burnt<T: Scalar>(sample: &PortSample<T>, correction: &Correction<T>) -> f64 {
    (correction.alpha * (sample.velocity * sample.velocity * sample.period)).lane(0)
}
