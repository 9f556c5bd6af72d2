//! Readings, observers and what else has no tick of a stabilizer, over random ticks.

use lyapunov::poses::{Angle, Pose, Screw, WithPose};
use lyapunov::readings::{Differenced, PartSpeeds, Poses, Steady};
use lyapunov::stabilizers::{EnergyTank, TankLimits, WaveFilter, WaveFollower, WaveTransform};
use lyapunov::telemetry::EnergyMeter;
use lyapunov::{
    CheckedSample, Dissipation, MovingReading, Observer, ParameterError, PortEnergy, PortSample,
    Reading, Readings, Scalar, Signal, Stabilizer,
};
use nalgebra::{Quaternion, UnitQuaternion, Vector3, Vector4, Vector6};

use crate::run::{MOST, Run};
use crate::signals::{Done, Named, Of, axes, bodies, each, every, n};
use crate::stabilizers::inner;

type OfPoses<T> = Readings<WithPose<T>, Differenced, Steady, Poses<T>>;

/// Every tick of readings: `read` is told the time, the position, the velocity and the applied effort.
pub(crate) fn read<V: Named>(
    ticks: u64,
    name: &str,
    mut read: impl FnMut(f64, V, V, V) -> CheckedSample<V>,
) {
    let mut run = Run::begin(ticks);
    let mut now = 0.0;
    for _ in 0..run.ticks {
        let (position, velocity) = (run.signal(MOST[0]), run.signal(MOST[1]));
        let applied = run.signal(MOST[3]);
        now += run.period();
        tell(&mut run, &read(now, position, velocity, applied));
    }
    run.end(name, V::NAME);
}

fn tell<V: Signal<Scalar: Scalar<Mask = bool>>>(run: &mut Run, told: &CheckedSample<V>) {
    run.tell_sample(&told.sample);
    let flags = [told.accepted, told.jumped, told.late, told.timed];
    run.hash(flags.iter().rev().fold(0, |sum, &flag| 2 * sum + u64::from(flag)));
}

/// Every tick of readings of poses: `read` is told the time, the pose, the twist and the applied wrench.
fn read_poses<T: Scalar>(
    ticks: u64,
    (name, signal): (&str, &str),
    mut read: impl FnMut(f64, Pose<T>, WithPose<T>, WithPose<T>) -> CheckedSample<WithPose<T>>,
) where
    Screw<T>: Signal<Scalar = T>,
    T: Scalar<Mask = bool>,
{
    let mut run = Run::begin(ticks);
    let mut now = 0.0;
    for _ in 0..run.ticks {
        let position: Vector3<T> = run.signal(MOST[0]);
        let quaternion: Vector4<T> = run.signal(1.0);
        let turned = UnitQuaternion::new_unchecked(Quaternion::from(quaternion));
        let velocity: Screw<T> = run.signal(MOST[1]);
        let applied: Screw<T> = run.signal(MOST[3]);
        now += run.period();
        let told = read(now, Pose::new(position, turned), velocity.into(), applied.into());
        let CheckedSample { sample, accepted, jumped, late, timed } = told;
        let sample = sample.map(sample.period, |pose| pose.screw);
        tell(&mut run, &CheckedSample { sample, accepted, jumped, late, timed });
    }
    run.end(name, signal);
}

pub(crate) fn watching(ticks: u64) -> Done {
    every!(V {
        let mut observer = Observer::of((PortEnergy, Dissipation::of(n(0.5))?));
        let mut run = Run::begin(ticks);
        for _ in 0..ticks {
            let sample: PortSample<V> = run.sample();
            let sum: Of<V> = observer.observe(&sample, V::splat(n(0.0)));
            run.tell(sum);
        }
        run.end("observer", V::NAME)
    });
    pub(crate) fn fresh<V: Named>() -> Result<Readings<V>, ParameterError> {
        Readings::every(n(0.001))?.no_faster_than(n(16.0))
    }
    every!(V {
        let mut it = fresh::<V>()?;
        read::<V>(ticks, "readings", |_, position, _, applied| it.read(Reading { position, applied }))
    });
    every!(V {
        let mut it = fresh::<V>()?.measured();
        read::<V>(ticks, "readings_measured", |_, position, velocity, applied| {
            it.read_moving(MovingReading { position, velocity, applied })
        })
    });
    axes!(V {
        let mut it = fresh::<V>()?.low_passed(n(30.0))?;
        read::<V>(ticks, "readings_low_passed", |_, position, _, applied| it.read(Reading { position, applied }))
    });
    axes!(V {
        let mut it = fresh::<V>()?.windowed::<16>(8, n(0.001))?;
        read::<V>(ticks, "readings_windowed", |_, position, _, applied| it.read(Reading { position, applied }))
    });
    axes!(V {
        let mut it = fresh::<V>()?.clocked();
        read::<V>(ticks, "readings_clocked", |now, position, _, applied| it.read_at(now, Reading { position, applied }))
    });
    axes!(V {
        let mut it = fresh::<V>()?.measured().clocked();
        read::<V>(ticks, "readings_measured_clocked", |now, position, velocity, applied| {
            it.read_moving_at(now, MovingReading { position, velocity, applied })
        })
    });
    turned(ticks)
}

/// Readings of poses.
fn turned(ticks: u64) -> Done {
    fn fresh<T: Angle>() -> Result<OfPoses<T>, ParameterError> {
        let fastest = PartSpeeds { translation: n(16.0), rotation: n(2000.0) };
        Readings::every(n(0.001))?.of_poses().no_faster_than(fastest)
    }
    each!(T in [f32, f64] {
        let mut it = fresh::<T>()?;
        let name = ("readings_of_poses", <Screw<T> as Named>::NAME);
        read_poses::<T>(ticks, name, |_, position, _, applied| it.read(Reading { position, applied }))
    });
    each!(T in [f32, f64] {
        let mut it = fresh::<T>()?.measured();
        let name = ("readings_of_poses_measured", <Screw<T> as Named>::NAME);
        read_poses::<T>(ticks, name, |_, position, velocity, applied| {
            it.read_moving(MovingReading { position, velocity, applied })
        })
    });
    each!(T in [f32, f64] {
        let mut it = fresh::<T>()?.low_passed(n(30.0))?;
        let name = ("readings_of_poses_low_passed", <Screw<T> as Named>::NAME);
        read_poses::<T>(ticks, name, |_, position, _, applied| it.read(Reading { position, applied }))
    });
    each!(T in [f32, f64] {
        let mut it = fresh::<T>()?.windowed::<16>(8, n(0.001))?;
        let name = ("readings_of_poses_windowed", <Screw<T> as Named>::NAME);
        read_poses::<T>(ticks, name, |_, position, _, applied| it.read(Reading { position, applied }))
    });
    each!(T in [f32, f64] {
        let mut it = fresh::<T>()?.clocked();
        let name = ("readings_of_poses_clocked", <Screw<T> as Named>::NAME);
        read_poses::<T>(ticks, name, |now, position, _, applied| it.read_at(now, Reading { position, applied }))
    });
    each!(T in [f32, f64] {
        let mut it = fresh::<T>()?.measured().clocked();
        let name = ("readings_of_poses_measured_clocked", <Screw<T> as Named>::NAME);
        read_poses::<T>(ticks, name, |now, position, velocity, applied| {
            it.read_moving_at(now, MovingReading { position, velocity, applied })
        })
    });
    Ok(())
}

/// Blocks that are asked something of signals.
pub(crate) fn asked(ticks: u64) -> Done {
    every!(V {
        let wave = WaveTransform::new(n(2.0))?;
        let mut run = Run::begin(ticks);
        for _ in 0..ticks {
            let (one, other): (V, V) = (run.signal(MOST[1]), run.signal(MOST[3]));
            let ((there, back), (flow, effort)) = (wave.encode(one, other), wave.decode(one, other));
            let ((driven, sent), (moved, returned)) = (wave.effort(one, other), wave.flow(one, other));
            [there, back, flow, effort, driven, sent, moved, returned].into_iter().for_each(|it| run.tell_all(it));
        }
        run.end("wave_transform", V::NAME)
    });
    every!(V {
        let mut filter = WaveFilter::new(n(0.25))?;
        let mut run = Run::begin(ticks);
        for _ in 0..ticks {
            let wave: V = run.signal(MOST[3]);
            run.tell_all(filter.pass(wave));
        }
        run.end("wave_filter", V::NAME)
    });
    every!(V {
        let follower = WaveFollower::new(WaveTransform::new(n(2.0))?, n(50.0), n(1.5))?;
        let mut run = Run::begin(ticks);
        for _ in 0..ticks {
            let (there, error, velocity): (V, V, V) =
                (run.signal(MOST[3]), run.signal(MOST[0]), run.signal(MOST[1]));
            let following = follower.follow(there, error, velocity);
            [following.flow, following.effort, following.back].into_iter().for_each(|it| run.tell_all(it));
        }
        run.end("wave_follower", V::NAME)
    });
    every!(V {
        let store = TankLimits { start: n(0.01), floor: n(0.001), ceiling: n(0.02), power: n(1.0) };
        let mut tank = EnergyTank::<Of<V>>::new(store)?;
        let mut run = Run::begin(ticks);
        for _ in 0..ticks {
            let (period, dissipated) = (run.period(), run.number(0.5));
            let (wished, flow): (V, V) = (run.signal(MOST[3]), run.signal(MOST[1]));
            let passed = tank.pass(Scalar::of(period), Scalar::of(dissipated), wished, flow);
            run.tell_all(passed);
            run.tell(tank.energy());
        }
        run.end("energy_tank", V::NAME)
    });
    every!(V {
        let (mut lolc, mut meter) = (inner::<Of<V>>()?, EnergyMeter::<Of<V>>::new());
        let mut run = Run::begin(ticks);
        for _ in 0..ticks {
            let sample: PortSample<V> = run.sample();
            let effort = run.signal(MOST[3]);
            meter.add(&sample, &lolc.stabilize(&sample, effort));
        }
        let told = meter.summary();
        run.hash(told.ticks);
        [told.active, told.rejected, told.now, told.least, told.most].into_iter().for_each(|it| run.tell(it));
        [told.asked, told.absorbed, told.shortfall, told.largest_shortfall].into_iter().for_each(|it| run.tell(it));
        run.end("energy_meter", V::NAME)
    });
    Ok(())
}
