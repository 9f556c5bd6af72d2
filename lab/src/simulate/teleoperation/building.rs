//! The way from a teleoperator to its loop.

use lyapunov::{
    self as library, DampingLimit, ParameterError, Popc, PortEnergy, Requirement, Scalar,
    bodies::{Body, Impedance, IntegratedPlant},
    channels::{ConstantDelay, LossyChannel, VaryingDelay},
    integrators::{EventLocating, Exact, WalledOscillator},
    stabilizers::{
        DriftCompensated, NoStabilizer, Sharing, TwoLayer, TwoPortSide, WaveFilter, WaveFollower,
        WaveTransform,
    },
};

use super::entrant::Entrant;
use super::link::{Layers, Link, Message, Velocities, Waves};
use crate::files::scene::{Refused, Seed, standing_out};
use crate::files::teleoperation::{Channel, Teleoperator, Wall};
use crate::simulate::building::AnyPlant;

/// Room for the messages under way: the longest delay and the widest spread.
const ROOM: usize = 2049;

/// Any channel, boxed.
pub(super) type AnyChannel<T> = Box<dyn library::channels::Channel<Message<T>>>;

/// The master in the hand.
pub(super) fn master<T: Scalar>(file: &Teleoperator) -> Result<AnyPlant<T>, Refused> {
    let it = file.master;
    let (mass, damping) = (T::of(it.mass.get()), T::of(it.damping.get()));
    let parts = Impedance { mass, damping, stiffness: T::of(it.hand_stiffness.get()) };
    let refused = among([
        ("master.mass", it.mass.get()),
        ("master.damping", it.damping.get()),
        ("master.hand_stiffness", it.hand_stiffness.get()),
        ("servo_rate", file.servo_rate.get()),
    ]);
    let body = Body::<T>::new(parts, period(file)).map_err(refused)?;
    Ok(AnyPlant::new(body.starting(T::of(it.start.get()), T::of(0.0))))
}

/// The slave, with the wall in front of it as one piecewise motion.
pub(super) fn slave<T: Scalar>(file: &Teleoperator) -> Result<AnyPlant<T>, Refused> {
    let it = file.slave;
    let refused = among([
        ("slave.mass", it.mass.get()),
        ("slave.damping", it.damping.get()),
        ("slave.wall.stiffness", it.wall.map_or(1.0, |wall| wall.stiffness.get())),
        ("servo_rate", file.servo_rate.get()),
    ]);
    let (mass, damping) = (T::of(it.mass.get()), T::of(it.damping.get()));
    let parts = Impedance { mass, damping, stiffness: T::of(0.0) };
    let (start, rest) = (T::of(file.master.start.get()), T::of(0.0));
    let Some(Wall { position, stiffness }) = it.wall else {
        let body = Body::<T>::new(parts, period(file)).map_err(refused)?;
        return Ok(AnyPlant::new(body.starting(start, rest)));
    };
    let (position, stiffness) = (T::of(position.get()), T::of(stiffness.get()));
    let walled = WalledOscillator::new(parts, stiffness, position).map_err(&refused)?;
    let walled =
        IntegratedPlant::<T, _, _>::new(walled, EventLocating::new(Exact::new()), period(file), 1);
    Ok(AnyPlant::new(walled.map_err(refused)?.starting(start, rest)))
}

/// The channels there and back.
pub(super) fn channels<T: Scalar>(file: &Teleoperator) -> Result<[AnyChannel<T>; 2], Refused> {
    // Without randomness nothing is drawn.
    let seed = file.channel.seed.map_or(0, Seed::get);
    Ok([channel(file.channel, seed)?, channel(file.channel, !seed)?])
}

fn channel<T: Scalar>(it: Channel, seed: u64) -> Result<AnyChannel<T>, Refused> {
    let silence = (T::of(0.0), T::of(0.0));
    let (least, most) = (it.delay.get(), it.delay.get() + it.spread.get());
    if most == least {
        let delay = ConstantDelay::<Message<T>, ROOM>::new(least.into(), silence);
        losing(delay.map_err(in_table("channel.delay"))?, it, seed)
    } else {
        let delay = VaryingDelay::<Message<T>, ROOM>::new(least.into(), most.into(), seed, silence);
        losing(delay.map_err(in_table("channel.spread"))?, it, seed)
    }
}

fn losing<T: Scalar>(
    channel: impl library::channels::Channel<Message<T>> + 'static,
    it: Channel,
    seed: u64,
) -> Result<AnyChannel<T>, Refused> {
    let loss = it.loss.get();
    if loss == 0.0 {
        return Ok(Box::new(channel));
    }
    Ok(Box::new(LossyChannel::new(channel, loss, seed).map_err(in_table("channel.loss"))?))
}

/// The link by which `entrant` joins master and slave.
pub(super) fn link<T: Scalar>(
    file: &Teleoperator,
    entrant: Entrant,
) -> Result<Box<dyn Link<T>>, Refused> {
    let (cap, period) = (T::of(file.stabilizer.damping_cap.get()), period::<T>(file));
    let rate = ("servo_rate", file.servo_rate.get());
    let (stiffness, damping) = (file.coordination.stiffness.get(), file.coordination.damping.get());
    let damper = DampingLimit::of_mass(cap, T::of(file.master.mass.get()), period);
    // A held velocity meets a damper at once, as it meets a spring of B / T within a tick.
    let stiffness = T::of(stiffness) + T::of(damping) / period;
    let mobility = DampingLimit::of_stiffness(cap, stiffness, period);
    let mass = ("master.mass", file.master.mass.get());
    let springs = [
        ("coordination.stiffness", file.coordination.stiffness.get()),
        ("coordination.damping", file.coordination.damping.get()),
    ];
    let damper = damper.map_err(among([mass, rate]))?;
    let mobility = mobility.map_err(among([springs[0], springs[1], rate]))?;
    Ok(match entrant {
        Entrant::None => {
            Box::new(Velocities { master: Box::new(NoStabilizer), slave: Box::new(NoStabilizer) })
        }
        Entrant::Popc => Box::new(Velocities {
            master: Box::new(Popc::new(PortEnergy, damper)),
            slave: Box::new(Popc::new(PortEnergy, mobility)),
        }),
        Entrant::TwoPort => Box::new(Velocities {
            master: Box::new(TwoPortSide::new(damper)),
            slave: Box::new(TwoPortSide::new(mobility)),
        }),
        Entrant::Compensated => {
            let speed = T::of(file.stabilizer.drift_compensated.speed.get());
            let slave = DriftCompensated::new(TwoPortSide::new(mobility), speed)
                .and_then(|slave| slave.meeting(stiffness * period))
                .map_err(in_table("stabilizer.drift-compensated.speed"))?;
            Box::new(Velocities {
                master: Box::new(TwoPortSide::new(damper)),
                slave: Box::new(slave),
            })
        }
        Entrant::TwoLayer => Box::new(layers(file).map_err(in_table("stabilizer.two-layer"))?),
        Entrant::Waves => Box::new(waves(file, file.coordination.damping.get(), 0.0)?),
        Entrant::MatchedWaves => Box::new(waves(file, file.wave_impedance(), 0.0)?),
        Entrant::FilteredWaves => {
            Box::new(waves(file, file.wave_impedance(), file.wave_filter_time())?)
        }
    })
}

/// Tanks that are empty at the start, so that the hand pays for everything.
fn layers<T: Scalar>(file: &Teleoperator) -> Result<Layers<T>, ParameterError> {
    let it = file.layers();
    let sharing = Sharing { start: T::of(0.0), share: T::of(it.share) };
    Ok(Layers {
        master: TwoLayer::master(sharing, T::of(it.level), T::of(it.gain))?,
        slave: TwoLayer::slave(sharing)?,
    })
}

/// Waves before a slave with a damper of `damping` N·s/m, past filters with a time constant of `time` s.
fn waves<T: Scalar>(file: &Teleoperator, damping: f64, time: f64) -> Result<Waves<T>, Refused> {
    let refused = in_table("stabilizer.wave-variables.impedance");
    let transform = WaveTransform::new(T::of(file.wave_impedance())).map_err(&refused)?;
    let stiffness = T::of(file.coordination.stiffness.get());
    let follower = WaveFollower::new(transform, stiffness, T::of(damping)).map_err(refused)?;
    let period = period::<T>(file);
    let filter = WaveFilter::new(period / (period + T::of(time)))
        .map_err(in_table("stabilizer.wave-variables.filter_time"))?;
    Ok(Waves { transform, follower, there: filter, back: filter })
}

/// The servo period, s.
pub(super) fn period<T: Scalar>(file: &Teleoperator) -> T {
    T::of(file.servo_rate.get().recip())
}

/// The number that stands out among those that a block was made of, whichever of them it names.
fn among<const N: usize>(numbers: [(&'static str, f64); N]) -> impl Fn(ParameterError) -> Refused {
    move |error| {
        let (parameter, value) =
            standing_out(numbers.to_vec()).unwrap_or((error.parameter, error.value));
        (parameter, ParameterError { parameter, value, requirement: Requirement::InRange })
    }
}

fn in_table(key: &'static str) -> impl Fn(ParameterError) -> Refused {
    move |error| (key, error)
}
