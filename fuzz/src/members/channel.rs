//! Members at the ends of a channel, on one axis.

use lyapunov_embedded::{Looped, Waves};
use lyapunov_stabilizers::{
    DriftCompensated, Sharing, TwoLayer, TwoPortSide, WaveFilter, WaveFollower, WaveTransform,
};

use super::{Member, limit};
use crate::Real;
use crate::check::Manner::{Answers, Damps, Rejects};
use crate::drive::{copied, stored};

/// Adds all of them.
pub(super) fn list<T: Real>(members: &mut Vec<Member>) {
    sides::<T>(members);
    ends::<T>(members);
}

fn sides<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "two-port",
        run: |bytes| {
            let limit = limit(bytes)?;
            copied::<T, _>(bytes, Damps(limit.most()), Ok(Looped(TwoPortSide::<T>::new(limit))))
        },
    });
    members.push(Member {
        name: "two-port-sampled",
        run: |bytes| {
            let limit = limit(bytes)?;
            let mut side = TwoPortSide::<T>::new(limit).sampled();
            side.receive(bytes.number());
            stored::<T, _>(bytes, Damps(limit.most()), Ok(side))
        },
    });
    members.push(Member {
        name: "drift-compensated",
        run: |bytes| {
            let mut side = TwoPortSide::<T>::new(limit(bytes)?);
            side.receive(bytes.number());
            let (speed, impedance) = (bytes.parameter(), bytes.parameter());
            if bytes.byte() % 2 == 0 {
                let member: DriftCompensated<_, T> = DriftCompensated::new(side, speed)?;
                stored::<T, _>(bytes, Rejects, member.meeting(impedance))
            } else {
                let member: DriftCompensated<_, T> = DriftCompensated::new(side.sampled(), speed)?;
                stored::<T, _>(bytes, Rejects, member.meeting(impedance))
            }
        },
    });
}

fn ends<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "two-layer",
        run: |bytes| {
            let share = T::of(f64::from(bytes.byte()) / 250.0);
            let sharing = Sharing { start: bytes.parameter(), share };
            let master: TwoLayer<T> =
                TwoLayer::master(sharing, bytes.parameter(), bytes.parameter())?;
            copied::<T, _>(bytes, Rejects, Ok(Looped(master)))
        },
    });
    members.push(Member {
        name: "waves",
        run: |bytes| {
            let transform = WaveTransform::new(bytes.positive::<T>())?;
            let follower = WaveFollower::matched(transform, bytes.positive())?;
            let filter: WaveFilter<T> = WaveFilter::new(T::of(f64::from(bytes.byte()) / 250.0))?;
            copied::<T, _>(bytes, Answers, Ok(Waves { transform, filter, follower }))
        },
    });
}
