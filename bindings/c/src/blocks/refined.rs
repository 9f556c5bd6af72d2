//! Refinements of LOLC: limits of its credit, gentler corrections, chosen directions, limits of what a sample can be.
//!
//! All refine LOLC with the credit of a damper; with a device damping of 0 that is POPC.

use lyapunov::accumulators::{Compensated, Plain};
use lyapunov::candidates::InContact;
use lyapunov::stabilizers::{
    AlongDirection, AxisWeights, BoundedCredit, ContactReset, DirectedDamping, InertiaLimit,
    InertiaMetric, JointInertia, PartLimits, PerAxis, PerPart, Plausibility, Plausible, RateLimit,
    SoftStart, Spread, StabilizerExt, VelocityThreshold, Watchdog, WatchdogTimes, WindowedCredit,
};
use lyapunov::{DampingLimit, Dissipation, Held, Lolc, PortEnergy, Requirement, Sampled};
use nalgebra::SMatrix;

use crate::export::blocks;
use crate::limits::limit;
use crate::named::named;
use crate::number::Number;
use crate::port::AxesForm;

/// LOLC with the credit of the device's damper.
type Inner<T> = Lolc<T, (PortEnergy, Dissipation<T>)>;

/// Credit of a rigid body's two dampings.
type BodyCredit<T> = PerPart<Dissipation<T>, Dissipation<T>>;

/// The matrix of these rows.
fn matrix<T: Number, const N: usize>(rows: &[AxesForm<T, N>; N]) -> SMatrix<T, N, N> {
    SMatrix::from_fn(|row, column| rows[row].axis[column])
}

blocks! {
    /// LOLC over the paper's sampled work (Lolc::sampled), the power at the sampling instant. It misses what leaks between
    /// samples, and reads no `work`: look at the `accepted` of a reading.
    lolc_sampled on every = {
        "lolc_sampled";
        Lolc<T, (PortEnergy, Dissipation<T>), Sampled>, whole 3 + 0;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
        };
        |given| lolc::Block::build(&given.lolc).map(Lolc::sampled);
        [life stabilizer account]
    }
    /// LOLC with a compensated sum (Lolc::summed_in Compensated): in float too it keeps its digits for a year.
    lolc_compensated on every = {
        "lolc_compensated";
        Lolc<T, (PortEnergy, Dissipation<T>), Held, Compensated<T>>, whole 4 + 0;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
        };
        |given| {
            let inner = lolc::Block::build(&lolc::Parameters { budget: 0.0, ..given.lolc })?;
            inner.summed_in().budgeted(given.lolc.budget)
        };
        [life stabilizer account]
    }
    /// LOLC that carries a bounded credit from tick to tick (BoundedCredit).
    bounded_credit on every = {
        "bounded_credit";
        BoundedCredit<Inner<T>, T>, whole 4 + 0;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
            /// The most credit that is carried, J.
            most: T,
        };
        |given| lolc::Block::build(&given.lolc)?.bounded(given.most);
        [life stabilizer account]
    }
    /// LOLC whose credit expires after a window of ticks, kept in 8 slots (WindowedCredit): it expires between 7 and 8 times
    /// `ticks` later.
    windowed_credit on every = {
        "windowed_credit";
        Lolc<T, (PortEnergy, Dissipation<T>), Held, WindowedCredit<T, Plain<T>, 8>>, words;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
            /// Ticks of each of the 8 slots.
            ticks: u32,
        };
        |given| {
            let inner = lolc::Block::build(&lolc::Parameters { budget: 0.0, ..given.lolc })?;
            inner.summed_by(WindowedCredit::of_ticks(given.ticks)?).budgeted(given.lolc.budget)
        };
        [life stabilizer account]
    }
    /// LOLC that forfeits its credit whenever it comes into contact with a wall (ContactReset).
    contact_reset on line = {
        "contact_reset";
        ContactReset<Inner<T>, InContact<T>, T>, words;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
            /// Position of the wall's surface, m; contact is beyond it.
            surface: T,
        };
        |given| {
            let position = Requirement::Finite.check("surface", given.surface)?;
            Ok(lolc::Block::build(&given.lolc)?.reset_at(InContact { position }))
        };
        [life stabilizer account]
    }
    /// LOLC that corrects only from a velocity on (VelocityThreshold).
    velocity_threshold on every = {
        "velocity_threshold";
        VelocityThreshold<Inner<T>, T>, whole 4 + 0;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
            /// The velocity, m/s.
            velocity: T,
        };
        |given| lolc::Block::build(&given.lolc)?.above_velocity(given.velocity);
        [life stabilizer account]
    }
    /// LOLC that pays a debt in parts (Spread).
    spread on every = {
        "spread";
        Spread<Inner<T>, T>, whole 5 + 0;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
            /// How many parts, one a tick.
            ticks: u32,
        };
        |given| lolc::Block::build(&given.lolc)?.spread_over(given.ticks);
        [life stabilizer account]
    }
    /// LOLC whose correction rises over the first ticks of each engagement (SoftStart).
    soft_start on every = {
        "soft_start";
        SoftStart<Inner<T>, T>, whole 5 + 0;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
            /// How many ticks.
            ticks: u32,
        };
        |given| lolc::Block::build(&given.lolc)?.rising_over(given.ticks);
        [life stabilizer account]
    }
    /// LOLC whose correction grows no faster than a rate (RateLimit).
    rate_limit on every = {
        "rate_limit";
        RateLimit<Inner<T>, V>, whole 4 + 1;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
            /// The rate on each axis, N/s.
            rate: T,
        };
        |given| lolc::Block::build(&given.lolc)?.rate_limited(given.rate);
        [life stabilizer account]
    }
    /// LOLC that dissipates on some axes more than on others (DirectedDamping with AxisWeights).
    axis_weights on every = {
        "axis_weights";
        DirectedDamping<Inner<T>, AxisWeights<V>, T>, whole 4 + 1;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
            /// Weight of each axis, 0 to 1: an axis of 0 does not feel the controller.
            weights: Form,
        };
        |given| {
            let weights = AxisWeights::new(V::of(given.weights))?;
            let inner = lolc::Block::build(&given.lolc)?;
            Ok(DirectedDamping::new(inner, weights, limit(given.lolc.damping_limit)?))
        };
        [life stabilizer account]
    }
    /// LOLC that dissipates in one direction only (DirectedDamping with AlongDirection).
    along_direction on every = {
        "along_direction";
        DirectedDamping<Inner<T>, AlongDirection<V>, T>, whole 4 + 1;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
            /// The direction, of any length above 0.
            direction: Form,
        };
        |given| {
            let along = AlongDirection::new(V::of(given.direction))?;
            let inner = lolc::Block::build(&given.lolc)?;
            Ok(DirectedDamping::new(inner, along, limit(given.lolc.damping_limit)?))
        };
        [life stabilizer account]
    }
    /// LOLC that slows coupled axes in proportion, by their inertia matrix (DirectedDamping with InertiaMetric). A posture that
    /// changes is told by `retune`, before each step.
    inertia_metric on spaces = {
        "inertia_metric";
        DirectedDamping<Inner<T>, InertiaMetric<T, AXES>, T>, whole 5 + AXES;
        {
            /// The stabilizer; its damping limit is that of the matrix's largest absolute row sum as mass.
            lolc: lolc::Parameters,
            /// Rows of the inertia matrix, kg or kg.m^2; only the lower triangle is read.
            inertia: [Form; AXES],
        };
        |given| {
            let metric = InertiaMetric::new(super::matrix(&given.inertia))?;
            let inner = lolc::Block::build(&given.lolc)?;
            Ok(DirectedDamping::new(inner, metric, limit(given.lolc.damping_limit)?))
        };
        [life stabilizer account]
    }
    /// LOLC within what the joints of a mechanism can use in its present posture (InertiaLimit with JointInertia), which is
    /// told by `retune`, before each step.
    inertia_limit on spaces = {
        "inertia_limit";
        InertiaLimit<Inner<T>, JointInertia<T, AXES>, T>, whole 4 + AXES;
        {
            /// The stabilizer; its damping limit may be infinity.
            lolc: lolc::Parameters,
            /// Rows of the inertia matrix, kg or kg.m^2; only the lower triangle is read.
            inertia: [Form; AXES],
            /// Share of the damping that removes most in one tick; 0.5 is usual.
            cap: T,
            /// The period, s.
            period: T,
            /// Ticks until an effort acts.
            late: u32,
        };
        |given| {
            let inertia = JointInertia::new(super::matrix(&given.inertia))?;
            let inner = lolc::Block::build(&given.lolc)?;
            Ok(InertiaLimit::new(inner, inertia, given.cap, given.period)?.delayed(given.late))
        };
        [life stabilizer account]
    }
    /// LOLC that rejects samples and efforts which no device can have (Plausible).
    plausible on every = {
        "plausible";
        Plausible<Inner<T>, T>, whole 5 + 0;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
            /// The largest speed on an axis, m/s; infinity: no limit.
            speed: T,
            /// The largest effort on an axis that your controller can ask for or your motor apply, N: beyond it the tick is
            /// rejected and not clipped, so take a number well above both. Infinity: no limit.
            effort: T,
        };
        |given| {
            let limits = Plausibility { speed: given.speed, effort: given.effort };
            lolc::Block::build(&given.lolc)?.plausible(limits)
        };
        [life stabilizer account]
    }
    /// LOLC that holds its last effort for a while without sound samples, then lets go, and comes back gently (Watchdog).
    watchdog on every = {
        "watchdog";
        Watchdog<Inner<T>, V>, whole 7 + 1;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
            /// How long the last effort is held, s; infinity: for ever.
            hold: T,
            /// How long the environment rises at the start and after a silence, s.
            rise: T,
        };
        |given| {
            let times = WatchdogTimes { hold: given.hold, rise: given.rise };
            lolc::Block::build(&given.lolc)?.watched(times)
        };
        [life stabilizer account]
    }
    /// What a loop on real hardware wants at once: LOLC with a bounded credit, a correction that grows no faster than a rate,
    /// implausible samples rejected, and a watchdog (Watchdog of Plausible of RateLimit of BoundedCredit).
    safeguarded on every = {
        "safeguarded";
        Watchdog<Plausible<RateLimit<BoundedCredit<Inner<T>, T>, V>, T>, V>, whole 11 + 2;
        {
            /// The stabilizer.
            lolc: lolc::Parameters,
            /// The most credit that is carried, J; infinity: no limit.
            most: T,
            /// The rate of the correction on each axis, N/s; infinity: no limit.
            rate: T,
            /// The largest speed on an axis, m/s; infinity: no limit.
            speed: T,
            /// The largest effort on an axis that your controller can ask for or your motor apply, N: beyond it the tick is
            /// rejected and not clipped, so take a number well above both. Infinity: no limit.
            effort: T,
            /// How long the last effort is held without sound samples, s.
            hold: T,
            /// How long the environment rises at the start and after a silence, s.
            rise: T,
        };
        |given| {
            let inner = lolc::Block::build(&given.lolc)?.bounded(given.most)?;
            let limits = Plausibility { speed: given.speed, effort: given.effort };
            let times = WatchdogTimes { hold: given.hold, rise: given.rise };
            inner.rate_limited(given.rate)?.plausible(limits)?.watched(times)
        };
        [life stabilizer account]
    }
    /// LOLC with a sum for each axis (PerAxis): what one axis absorbed does not pay for another.
    per_axis on spaces = {
        "per_axis";
        PerAxis<Inner<T>, AXES>, whole 0 + 3;
        {
            /// The stabilizer of each axis.
            axes: [lolc::Parameters; AXES],
        };
        |given| {
            let mut axes = [lolc::Block::build(&given.axes[0])?; AXES];
            for (axis, given) in axes.iter_mut().zip(&given.axes) {
                *axis = lolc::Block::build(given)?;
            }
            Ok(PerAxis::of(axes))
        };
        [life stabilizer]
    }
    /// LOLC with a sum for translation and one for rotation (PerPart).
    per_part on bodies = {
        "per_part";
        PerPart<Inner<T>, Inner<T>>, whole 6 + 0;
        {
            /// The stabilizer of translation: N.s/m, J.
            translation: lolc::Parameters,
            /// The stabilizer of rotation: N.m.s/rad, J.
            rotation: lolc::Parameters,
        };
        |given| {
            let rotation = lolc::Block::build(&given.rotation)?;
            Ok(PerPart::of(lolc::Block::build(&given.translation)?, rotation))
        };
        [life stabilizer]
    }
    /// LOLC with one sum for a rigid body, and a damping limit for each part (DirectedDamping::within PartLimits).
    part_limits on bodies = {
        "part_limits";
        DirectedDamping<Lolc<T, (PortEnergy, BodyCredit<T>)>, AxisWeights<V>, T>, whole 5 + 1;
        {
            /// Largest damping of translation, N.s/m.
            translation_limit: T,
            /// Largest damping of rotation, N.m.s/rad.
            rotation_limit: T,
            /// Damping of translation that the device surely has, N.s/m.
            translation_damping: T,
            /// Damping of rotation that the device surely has, N.m.s/rad.
            rotation_damping: T,
            /// Energy stored in the loop at the start, which may come back, J; usually 0. Only init reads it: `retune` does
            /// not, and later there is `grant`.
            budget: T => 0.0,
        };
        |given| {
            let damping = |field, damping| named(field, Dissipation::of(damping));
            let translation = damping("translation_damping", given.translation_damping)?;
            let rotation = damping("rotation_damping", given.rotation_damping)?;
            let credit = PerPart::of(translation, rotation);
            let inner = Lolc::new((PortEnergy, credit), DampingLimit::at(T::INFINITY)?);
            let limits = PartLimits {
                translation: named("translation_limit", limit(given.translation_limit))?,
                rotation: named("rotation_limit", limit(given.rotation_limit))?,
            };
            Ok(DirectedDamping::within(inner.budgeted(given.budget)?, limits))
        };
        [life stabilizer account]
    }
}
