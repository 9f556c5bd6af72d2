//! Readings of a device: what is read in, samples out.

use lyapunov::poses::{Angle, WithPose};
use lyapunov::readings::{
    Clocked, Differenced, LowPassed, Measured, PartSpeeds, Poses, Steady, Windowed,
};
use lyapunov::{MovingReading, ParameterError, Reading, Readings};

use crate::export::blocks;
use crate::port::Port;
use crate::poses::PoseForm;
use crate::readings::CheckedForm;

/// The longest window of velocities, ticks.
const WINDOW: usize = 16;

/// The readings that all the others are made of.
fn every<V: Port>(period: V::Scalar, fastest: V::Scalar) -> Result<Readings<V>, ParameterError> {
    Readings::every(period)?.no_faster_than(fastest)
}

/// Readings of poses with twists by differences.
type OfPoses<T> = Readings<WithPose<T>, Differenced, Steady, Poses<T>>;

fn poses<T: Angle>(period: T, translation: T, rotation: T) -> Result<OfPoses<T>, ParameterError> {
    Readings::every(period)?.of_poses().no_faster_than(PartSpeeds { translation, rotation })
}

blocks! {
    /// Readings at a fixed period (Readings::every), with velocities by differences: the memory of a port. The first reading
    /// displaces nothing, one that is NaN or jumps is rejected, the next spans the gap.
    readings on every = {
        "readings";
        Readings<V>, whole 4 + 3;
        {
            /// The period, s.
            period: T,
            /// The fastest motion, m/s, above 0; infinity: no limit.
            fastest: T,
        };
        |given| every::<V>(given.period, given.fastest);
        [life reading place]
    }
    /// Readings at a fixed period, with velocities that the device measures (Readings::measured).
    readings_measured on every = {
        "readings_measured";
        Readings<V, Measured>, whole 4 + 3;
        {
            /// The period, s.
            period: T,
            /// The fastest motion, m/s, above 0; infinity: no limit.
            fastest: T,
        };
        |given| Ok(every::<V>(given.period, given.fastest)?.measured());
        [life moving_reading place]
    }
    /// Readings at a fixed period, with velocities through a low pass (Readings::low_passed).
    readings_low_passed on axes = {
        "readings_low_passed";
        Readings<V, LowPassed<V>>, words;
        {
            /// The period, s.
            period: T,
            /// The fastest motion, m/s, above 0; infinity: no limit.
            fastest: T,
            /// Cutoff of the low pass, Hz.
            cutoff: T,
        };
        |given| every::<V>(given.period, given.fastest)?.low_passed(given.cutoff);
        [life reading place]
    }
    /// Readings at a fixed period, with velocities over up to 16 readings (Readings::windowed).
    readings_windowed on axes = {
        "readings_windowed";
        Readings<V, Windowed<V, WINDOW>>, words;
        {
            /// The period, s.
            period: T,
            /// The fastest motion, m/s, above 0; infinity: no limit.
            fastest: T,
            /// The number of readings, 1 to 16.
            ticks: u32,
            /// Largest distance from a line, m: a count of the encoder, or the noise.
            band: T,
        };
        |given| every::<V>(given.period, given.fastest)?.windowed(given.ticks, given.band);
        [life reading place]
    }
    /// Readings at the times of a clock (Readings::clocked), with velocities by differences.
    readings_clocked on axes = {
        "readings_clocked";
        Readings<V, Differenced, Clocked>, words;
        {
            /// The period that is meant, s.
            period: T,
            /// The fastest motion, m/s, above 0; infinity: no limit. Over less than a period a jump
            /// counts as one over a whole period, so that the velocity may be above it.
            fastest: T,
        };
        |given| Ok(every::<V>(given.period, given.fastest)?.clocked());
        [life reading_at place]
    }
    /// Readings at the times of a clock, with velocities that the device measures.
    readings_measured_clocked on axes = {
        "readings_measured_clocked";
        Readings<V, Measured, Clocked>, words;
        {
            /// The period that is meant, s.
            period: T,
            /// The fastest motion, m/s, above 0; infinity: no limit. Over less than a period a jump
            /// counts as one over a whole period.
            fastest: T,
        };
        |given| Ok(every::<V>(given.period, given.fastest)?.measured().clocked());
        [life moving_reading_at place]
    }
    /// Readings of poses at a fixed period (Readings::of_poses), with twists by differences. The position of a sample is the sum of the
    /// displacements from one accepted pose to the next. A pose that is not finite, or whose quaternion is 0, is rejected.
    readings_of_poses on bodies = {
        "readings_of_poses";
        OfPoses<T>, whole 50 + 0;
        {
            /// The period, s.
            period: T,
            /// The fastest motion of the reference point, m/s, above 0; infinity: no limit.
            fastest_translation: T,
            /// The fastest rotation, rad/s, above 0; infinity: no limit.
            fastest_rotation: T,
        };
        |given| poses(given.period, given.fastest_translation, given.fastest_rotation);
        [life pose_reading place]
    }
    /// Readings of poses at a fixed period, with twists that the device measures.
    readings_of_poses_measured on bodies = {
        "readings_of_poses_measured";
        Readings<WithPose<T>, Measured, Steady, Poses<T>>, whole 50 + 0;
        {
            /// The period, s.
            period: T,
            /// The fastest motion of the reference point, m/s, above 0; infinity: no limit.
            fastest_translation: T,
            /// The fastest rotation, rad/s, above 0; infinity: no limit.
            fastest_rotation: T,
        };
        |given| Ok(poses(given.period, given.fastest_translation, given.fastest_rotation)?.measured());
        [life moving_pose_reading place]
    }
    /// Readings of poses at a fixed period, with twists through a low pass.
    readings_of_poses_low_passed on bodies = {
        "readings_of_poses_low_passed";
        Readings<WithPose<T>, LowPassed<WithPose<T>>, Steady, Poses<T>>, words;
        {
            /// The period, s.
            period: T,
            /// The fastest motion of the reference point, m/s, above 0; infinity: no limit.
            fastest_translation: T,
            /// The fastest rotation, rad/s, above 0; infinity: no limit.
            fastest_rotation: T,
            /// Cutoff of the low pass, Hz.
            cutoff: T,
        };
        |given| poses(given.period, given.fastest_translation, given.fastest_rotation)?.low_passed(given.cutoff);
        [life pose_reading place]
    }
    /// Readings of poses at a fixed period, with twists over up to 16 readings.
    readings_of_poses_windowed on bodies = {
        "readings_of_poses_windowed";
        Readings<WithPose<T>, Windowed<WithPose<T>, WINDOW>, Steady, Poses<T>>, words;
        {
            /// The period, s.
            period: T,
            /// The fastest motion of the reference point, m/s, above 0; infinity: no limit.
            fastest_translation: T,
            /// The fastest rotation, rad/s, above 0; infinity: no limit.
            fastest_rotation: T,
            /// The number of readings, 1 to 16.
            ticks: u32,
            /// Largest distance from a line, m and rad.
            band: T,
        };
        |given| poses(given.period, given.fastest_translation, given.fastest_rotation)?.windowed(given.ticks, given.band);
        [life pose_reading place]
    }
    /// Readings of poses at the times of a clock, with twists by differences.
    readings_of_poses_clocked on bodies = {
        "readings_of_poses_clocked";
        Readings<WithPose<T>, Differenced, Clocked, Poses<T>>, words;
        {
            /// The period that is meant, s.
            period: T,
            /// The fastest motion of the reference point, m/s, above 0; infinity: no limit.
            fastest_translation: T,
            /// The fastest rotation, rad/s, above 0; infinity: no limit. Over less than a period a jump
            /// counts as one over a whole period, so that the twist may be above it.
            fastest_rotation: T,
        };
        |given| Ok(poses(given.period, given.fastest_translation, given.fastest_rotation)?.clocked());
        [life pose_reading_at place]
    }
    /// Readings of poses at the times of a clock, with twists that the device measures.
    readings_of_poses_measured_clocked on bodies = {
        "readings_of_poses_measured_clocked";
        Readings<WithPose<T>, Measured, Clocked, Poses<T>>, words;
        {
            /// The period that is meant, s.
            period: T,
            /// The fastest motion of the reference point, m/s, above 0; infinity: no limit.
            fastest_translation: T,
            /// The fastest rotation, rad/s, above 0; infinity: no limit. Over less than a period a jump
            /// counts as one over a whole period.
            fastest_rotation: T,
        };
        |given| Ok(poses(given.period, given.fastest_translation, given.fastest_rotation)?.measured().clocked());
        [life moving_pose_reading_at place]
    }
}
