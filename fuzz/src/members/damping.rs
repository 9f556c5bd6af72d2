//! Members that add damping, on one axis.

use lyapunov_core::{
    Compensated, Dissipation, InContact, Plain, PortEnergy, Readings, StorageFunction,
};
use lyapunov_embedded::Reads;
use lyapunov_stabilizers::{
    LeastNorm, Lolc, NoStabilizer, Plausibility, Popc, ReferenceDamper, StabilizerExt,
    WatchdogTimes, WindowedCredit,
};

use super::{Member, limit, popc};
use crate::Real;
use crate::check::Manner::{Answers, Damps, Holds, Passes, Shapes};
use crate::drive::{copied, stored};

/// Adds all of them.
pub(super) fn list<T: Real>(members: &mut Vec<Member>) {
    plain::<T>(members);
    credit::<T>(members);
    shaping::<T>(members);
    candidates::<T>(members);
    guarded::<T>(members);
}

fn plain<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "none",
        run: |bytes| stored::<T, _>(bytes, Passes, Ok(NoStabilizer)),
    });
    members.push(Member {
        name: "popc",
        run: |bytes| {
            let popc = popc::<T>(bytes)?;
            stored::<T, _>(bytes, Damps(popc.limit().most()), Ok(popc))
        },
    });
    members.push(Member {
        name: "popc-sampled",
        run: |bytes| {
            let popc = popc::<T>(bytes)?;
            stored::<T, _>(bytes, Damps(popc.limit().most()), Ok(popc.sampled()))
        },
    });
    members.push(Member {
        name: "popc-compensated",
        run: |bytes| {
            let popc = popc::<T>(bytes)?;
            let most = popc.limit().most();
            stored::<T, _>(bytes, Damps(most), Ok(popc.summed_in::<Compensated<T>>()))
        },
    });
}

fn credit<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "popc-budgeted",
        run: |bytes| {
            let popc = popc::<T>(bytes)?;
            let member = popc.budgeted(bytes.parameter());
            stored::<T, _>(bytes, Damps(popc.limit().most()), member)
        },
    });
    members.push(Member {
        name: "popc-bounded",
        run: |bytes| {
            let popc = popc::<T>(bytes)?;
            let member = popc.bounded(bytes.parameter());
            stored::<T, _>(bytes, Damps(popc.limit().most()), member)
        },
    });
    members.push(Member {
        name: "popc-windowed",
        run: |bytes| {
            let popc = popc::<T>(bytes)?;
            let sum = WindowedCredit::<T, Plain<T>, 8>::of_ticks(bytes.ticks(20))?;
            stored::<T, _>(bytes, Damps(popc.limit().most()), Ok(popc.summed_by(sum)))
        },
    });
    members.push(Member {
        name: "popc-contact-reset",
        run: |bytes| {
            let popc = popc::<T>(bytes)?;
            let contact = InContact { position: bytes.number::<T>() };
            stored::<T, _>(bytes, Damps(popc.limit().most()), Ok(popc.reset_at(contact)))
        },
    });
}

fn shaping<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "popc-threshold",
        run: |bytes| {
            let popc = popc::<T>(bytes)?;
            let shaped = popc.above_velocity(bytes.parameter());
            stored::<T, _>(bytes, Shapes(popc.limit().most()), shaped)
        },
    });
    members.push(Member {
        name: "popc-spread",
        run: |bytes| {
            let popc = popc::<T>(bytes)?;
            let shaped = popc.spread_over(bytes.ticks(40));
            stored::<T, _>(bytes, Shapes(popc.limit().most()), shaped)
        },
    });
    members.push(Member {
        name: "popc-rate-limited",
        run: |bytes| {
            let popc = popc::<T>(bytes)?;
            let shaped = popc.rate_limited::<T>(bytes.parameter());
            stored::<T, _>(bytes, Shapes(popc.limit().most()), shaped)
        },
    });
    members.push(Member {
        name: "popc-rising",
        run: |bytes| {
            let popc = popc::<T>(bytes)?;
            let shaped = popc.rising_over(bytes.ticks(40));
            stored::<T, _>(bytes, Shapes(popc.limit().most()), shaped)
        },
    });
}

fn candidates<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "lolc",
        run: |bytes| {
            let limit = limit(bytes)?;
            let lolc = Lolc::new((PortEnergy, Dissipation::of(bytes.parameter::<T>())?), limit);
            stored::<T, _>(bytes, Damps(limit.most()), Ok(lolc))
        },
    });
    members.push(Member {
        name: "lolc-spring",
        run: |bytes| {
            let (limit, stiffness) = (limit(bytes)?, bytes.positive::<T>());
            let spring = move |x: T, _v: T| stiffness * x * x;
            let stored = StorageFunction::starting(spring, bytes.number(), bytes.number());
            copied::<T, _>(bytes, Damps(limit.most()), Ok(Lolc::new(stored, limit)))
        },
    });
    members.push(Member {
        name: "popc-reference",
        run: |bytes| {
            let (limit, stiffness) = (limit(bytes)?, bytes.positive::<T>());
            let spring = move |x: T, _v: T| stiffness * x * x;
            let stored = StorageFunction::starting(spring, T::of(0.0), T::of(0.0));
            copied::<T, _>(bytes, Damps(limit.most()), Ok(Lolc::new((PortEnergy, stored), limit)))
        },
    });
    members.push(Member {
        name: "reference-following",
        run: |bytes| {
            let (limit, stiffness) = (limit(bytes)?, bytes.positive::<T>());
            let spring = move |x: T, _v: T| stiffness * x * x;
            let stored = StorageFunction::starting(spring, T::of(0.0), T::of(0.0));
            let depth = |x: T| x.larger(T::of(0.0));
            let wall = ReferenceDamper::starting(bytes.parameter(), depth, bytes.number())?;
            let lolc = Lolc::new((PortEnergy, (stored, wall)), limit);
            copied::<T, _>(bytes, Damps(limit.most()), Ok(lolc))
        },
    });
    members.push(Member {
        name: "least-norm",
        run: |bytes| {
            let limit = limit::<T>(bytes)?;
            let member = LeastNorm::new(PortEnergy, limit, bytes.positive());
            stored::<T, _>(bytes, Damps(limit.most()), member)
        },
    });
}

fn guarded<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "popc-plausible",
        run: |bytes| {
            let popc: Popc<T> = popc(bytes)?;
            let limits = Plausibility { speed: bytes.parameter(), effort: bytes.parameter() };
            stored::<T, _>(bytes, Damps(popc.limit().most()), popc.plausible(limits))
        },
    });
    members.push(Member {
        name: "popc-watched",
        run: |bytes| {
            let popc: Popc<T> = popc(bytes)?;
            let times = WatchdogTimes { hold: bytes.parameter(), rise: bytes.parameter() };
            stored::<T, _>(bytes, Holds, popc.watched(times))
        },
    });
    members.push(Member {
        name: "popc-readings",
        run: |bytes| {
            let popc: Popc<T> = popc(bytes)?;
            let readings = Readings::every(bytes.positive::<T>())?;
            copied::<T, _>(bytes, Answers, Ok(Reads(readings, popc)))
        },
    });
}
