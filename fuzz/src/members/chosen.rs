//! Member that is chosen at run time: every one of the enumeration, on one axis.

use lyapunov_core::{Dissipation, ParameterError, PortEnergy};
use lyapunov_stabilizers::{
    AlongDirection, AxisWeights, DirectedDamping, EnergyBounding, ForceBound, ForceBounding,
    LeastNorm, Lolc, Member as Chosen, NoStabilizer, SlopeBound, StabilizerExt, Tank,
    WindowedCredit,
};

use super::{Member, limit, popc, store};
use crate::check::Manner::{self, Damps, Passes, Reduces, Rejects, Shapes};
use crate::drive::stored;
use crate::tick::signal;
use crate::{Bytes, Real};

/// Adds it.
pub(super) fn list<T: Real>(members: &mut Vec<Member>) {
    members.push(Member {
        name: "popc-member",
        run: |bytes| {
            let (manner, member) = any::<T>(bytes)?;
            stored::<T, _>(bytes, manner, Ok(member))
        },
    });
}

/// The member that bytes choose, and its promises.
fn any<T: Real>(bytes: &mut Bytes<'_>) -> Result<(Manner<T>, Chosen<T>), ParameterError> {
    let names = Chosen::<T>::NAMES;
    let name = names[usize::from(bytes.byte()) % names.len()];
    let popc = popc::<T>(bytes)?;
    let most = popc.limit().most();
    Ok(match name {
        "none" => (Passes, Chosen::NoStabilizer(NoStabilizer)),
        "popc" => (Damps(most), Chosen::Popc(popc)),
        "lolc" => {
            let candidate = (PortEnergy, Dissipation::of(bytes.parameter())?);
            (Damps(most), Chosen::Lolc(Lolc::new(candidate, popc.limit())))
        }
        "popc-bounded" => (Damps(most), Chosen::Bounded(popc.bounded(bytes.parameter())?)),
        "popc-windowed" => {
            let window = WindowedCredit::of_ticks(bytes.ticks(20))?;
            (Damps(most), Chosen::Windowed(popc.summed_by(window)))
        }
        "popc-threshold" => {
            (Shapes(most), Chosen::Threshold(popc.above_velocity(bytes.parameter())?))
        }
        "popc-spread" => (Shapes(most), Chosen::Spread(popc.spread_over(bytes.ticks(40))?)),
        "popc-rate-limited" => {
            (Shapes(most), Chosen::RateLimited(popc.rate_limited(bytes.parameter())?))
        }
        "popc-rising" => (Shapes(most), Chosen::Rising(popc.rising_over(bytes.ticks(40))?)),
        "popc-weighted" => {
            let weights = AxisWeights::new(bytes.positive())?;
            (Shapes(most), Chosen::Weighted(DirectedDamping::new(popc, weights, limit(bytes)?)))
        }
        "popc-directed" => {
            let along = AlongDirection::new(signal::<T>(bytes))?;
            (Rejects, Chosen::Directed(DirectedDamping::new(popc, along, limit(bytes)?)))
        }
        "force-bound" => (Reduces, Chosen::ForceBound(ForceBound::new(bytes.parameter())?)),
        "tank" => (Reduces, Chosen::Tank(Tank::new(PortEnergy, store(bytes))?)),
        "energy-bounding" => {
            let rates = EnergyBounding::new(bytes.parameter(), bytes.parameter())?;
            (Rejects, Chosen::EnergyBounding(rates))
        }
        "force-bounding" => {
            (Reduces, Chosen::ForceBounding(ForceBounding::of_damping(bytes.parameter())?))
        }
        "least-norm" => {
            let filter = LeastNorm::new(PortEnergy, popc.limit(), bytes.positive())?;
            (Damps(most), Chosen::LeastNorm(filter))
        }
        "slope-bound" => (Reduces, Chosen::SlopeBound(SlopeBound::new(bytes.positive())?)),
        other => panic!("{other} is not driven"),
    })
}
