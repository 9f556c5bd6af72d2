//! Exact arithmetic: the passivity of the members that claim it, as invariants of their own steps over the reals.

use lyapunov_core::{HeldTick, PortEnergy, Requirement, Scalar, Snapshot, Stabilizer};
use lyapunov_stabilizers::{
    DampingLimit, EnergyBounding, EnergyTank, ForceBound, ForceBounding, LeastNorm, Lolc, Sharing,
    SlopeBound, Tank, TankLimits, TwoLayer, TwoPortSide, WaveFilter, WaveTransform,
};

use nalgebra::SVector;

use crate::fresh::{Axes, equal, parameter};
use crate::paths::{self, Path, assume};
use crate::smt::Query;
use crate::symbolic::{Symbolic, Truth};
use crate::tape::{self, Node, Place};

type Of = Symbolic;

/// Claim of a member in exact arithmetic.
pub(crate) struct Claim {
    pub(crate) name: &'static str,
    pub(crate) paths: fn() -> Vec<Path<Truth>>,
    /// Numbers that are free but for what other claims show of them.
    pub(crate) cuts: fn() -> Vec<(Symbolic, Truth)>,
}

impl Claim {
    /// A path on which the claim does not hold.
    pub(crate) fn query(&self) -> Query {
        self.ask(|path| vec![!path.result])
    }

    /// A path on which all that is assumed holds; there must be one, or the claim says nothing.
    pub(crate) fn possible(&self) -> Query {
        self.ask(|_| vec![])
    }

    fn ask(&self, goal: impl Fn(&Path<Truth>) -> Vec<Truth>) -> Query {
        let paths = (self.paths)();
        let cuts = (self.cuts)();
        let cases = paths
            .into_iter()
            .map(|path| {
                let decided =
                    path.decided.iter().map(|(truth, held)| if *held { *truth } else { !*truth });
                path.known
                    .iter()
                    .copied()
                    .chain(decided)
                    .chain(cuts.iter().map(|it| it.1))
                    .chain(goal(&path))
                    .collect()
            })
            .collect();
        Query { cases, cuts: cuts.into_iter().map(|it| it.0).collect() }
    }
}

fn zero() -> Of {
    Of::of(0.0)
}

fn positive(name: &str) -> Of {
    parameter(name, Requirement::Positive, 1.0)
}

fn not_negative(name: &str) -> Of {
    parameter(name, Requirement::NonNegative, 1.0)
}

fn at_least(a: Of, b: Of) -> Truth {
    !a.below(b)
}

fn free(name: &str) -> Of {
    Of::free(name, 0.0)
}

/// A tick of the given `period` under the held `force`.
fn tick<V: Axes>(period: Of, force: V, moved: V, name: &str) -> HeldTick<V> {
    HeldTick {
        period,
        position: V::called(&format!("{name}.position"), 0.0),
        velocity: V::called(&format!("{name}.velocity"), 1.0),
        displacement: moved,
        applied: force,
    }
}

/// Force bounding: what the account holds after a tick, the forces and the damper of the next one cannot make negative.
fn force_bounded<S: Stabilizer<Of> + Snapshot<State = (Of, SVector<Of, 0>)>>(
    make: impl Fn(Of) -> S,
) -> Vec<Path<Truth>> {
    paths::every(|| {
        let (damping, period) = (not_negative("damping"), positive("period"));
        let mut bound =
            make(damping).restored((free("energy"), SVector::zeros())).expect("a memory");
        let first = tick(period, free("applied"), free("moved"), "first");
        let before = paths::step(|| bound.stabilize(&first.sample(), free("asked")));
        assume(
            at_least(before.observed_energy, zero())
                & at_least(Of::largest(), before.observed_energy),
        );
        let next = tick(period, before.effort, free("moved on"), "next");
        let after = paths::step(|| bound.stabilize(&next.sample(), free("asked next")));
        at_least(after.observed_energy, zero())
    })
}

/// Energy bounding: `E ≥ F² / (2 c)` is kept, with `E` the energy of port and damper, over a sample that spans any time up to
/// `2 b / c`.
fn energy_bounded<B>(make: impl Fn(Of, Of) -> (EnergyBounding<Of, B>, Of)) -> Vec<Path<Truth>>
where
    EnergyBounding<Of, B>: Stabilizer<Of> + Snapshot<State = (Of, Of)>,
{
    paths::every(|| {
        let (damping, usual, period) = (positive("damping"), positive("usual"), positive("period"));
        let (bounding, slope) = make(damping, usual);
        assume(at_least(Of::of(2.0) * damping, slope * period));
        let (force, energy) = (free("force"), free("energy"));
        let two = Of::of(2.0);
        assume(at_least(two * slope * energy, force * force));
        let mut bounding = bounding.restored((force, energy)).expect("a memory");
        paths::step(|| {
            bounding.stabilize(&tick(period, force, free("moved"), "tick").sample(), free("asked"))
        });
        let (force, energy) = bounding.state();
        at_least(two * slope * energy, force * force)
    })
}

/// Energy bounding as published; its root is free but for what the claim beside it shows.
fn energy_bounded_as_published() -> Vec<Path<Truth>> {
    energy_bounded(|damping, usual| {
        let (rise, release) = (positive("c1"), positive("c2"));
        assume(!release.above(rise) & at_least(damping, rise * usual));
        let bounding = EnergyBounding::new(rise, release).expect("constants");
        (bounding.on_damping(damping, usual).expect("a damping"), release)
    })
}

/// The root in the published band: `S ≥ 0` and `S² ≤ F² + (c2 Δx)²`.
fn root_of_the_band() -> Vec<Path<Truth>> {
    energy_bounded_as_published();
    paths::every(|| band_root().1)
}

/// The root of what is left over a sample longer than `T`: `K ≥ 0` and
/// `K² ≤ F² + 2 c2 (F Δx + b Δx² / T(k))`.
fn root_of_a_longer_sample() -> Vec<Path<Truth>> {
    energy_bounded_as_published();
    paths::every(|| {
        let longest = positive("usual").larger(positive("period"));
        assume(at_least(Of::of(2.0) * positive("damping"), positive("c2") * longest));
        longer_root().1
    })
}

/// The root of the band, which is recorded first, and what is said of it.
fn band_root() -> (Of, Truth) {
    let size = root(|roots| roots.next());
    let (force, given) = (free("force"), positive("c2") * free("moved"));
    (size, at_least(size, zero()) & at_least(force * force + given * given, size * size))
}

/// The root of a longer sample, which is recorded last, and what is said of it.
fn longer_root() -> (Of, Truth) {
    let size = root(|roots| roots.last());
    let [damping, usual, period, release] = ["damping", "usual", "period", "c2"].map(positive);
    let (force, moved, one) = (free("force"), free("moved"), Of::of(1.0));
    let burnt = damping / usual * (usual / period).smaller(one) * (moved * moved);
    let left = force * force + Of::of(2.0) * release * (force * moved + burnt);
    (size, at_least(size, zero()) & at_least(left, size * size))
}

/// One of the products with a root on the tape.
fn root(which: impl FnOnce(&mut dyn Iterator<Item = Place>) -> Option<Place>) -> Of {
    let place = tape::with(|tape| {
        which(&mut tape.places().filter(|place| match tape.node(*place) {
            Node::Mul(_, root) => matches!(tape.node(root), Node::Root(_)),
            _ => false,
        }))
    });
    place.map(Symbolic).expect("a root on the tape")
}

/// Tank: its content stays, if the next displacement is a share of `v T`.
fn tank() -> Vec<Path<Truth>> {
    paths::every(|| {
        let (room, power, period) =
            (not_negative("room"), not_negative("power"), positive("period"));
        let store = TankLimits { start: zero(), floor: zero(), ceiling: room, power };
        let mut tank = Tank::new(PortEnergy, store)
            .expect("a tank")
            .restored(((), free("energy")))
            .expect("a memory");
        let first = tick(period, free("applied"), free("moved"), "first");
        let before = paths::step(|| tank.stabilize(&first.sample(), free("asked")));
        assume(at_least(before.observed_energy, zero()));
        let share = not_negative("share");
        assume(!share.above(Of::of(1.0)));
        let next = tick(period, before.effort, share * first.velocity * period, "next");
        let after = paths::step(|| tank.stabilize(&next.sample(), free("asked next")));
        at_least(after.observed_energy, zero())
    })
}

/// Energy tank with the bounded valve: `floor ≤ E ≤ ceiling` is kept, and what is drawn is what the port takes out.
fn energy_tank() -> Vec<Path<Truth>> {
    paths::every(|| {
        let [floor, ceiling, energy, power] =
            ["floor", "ceiling", "energy", "power"].map(not_negative);
        assume(at_least(energy, floor) & at_least(ceiling, energy));
        let store = TankLimits { start: energy, floor, ceiling, power };
        let mut tank = EnergyTank::new(store).expect("a tank");
        let (period, burnt, flow) = (positive("period"), not_negative("dissipated"), free("flow"));
        let given = paths::step(|| tank.pass(period, burnt, free("wished"), flow));
        let after = tank.energy();
        let paid = at_least(energy + burnt * period - given * flow * period, after);
        at_least(after, floor) & at_least(ceiling, after) & paid
    })
}

/// Least norm: `L(n+1) ≥ (1 − γ) L(n)`, if the next displacement is `v T`, below the limit.
fn least_norm() -> Vec<Path<Truth>> {
    paths::every(|| {
        let (limit, decay, period) = (not_negative("limit"), positive("decay"), positive("period"));
        assume(!decay.above(Of::of(1.0)));
        let limit = DampingLimit::at(limit).expect("a limit");
        let filter = LeastNorm::new(PortEnergy, limit, decay).expect("a decay");
        let mut filter = filter.restored(((), free("energy"))).expect("a memory");
        let first = tick(period, free("applied"), free("moved"), "first");
        let before = paths::step(|| filter.stabilize(&first.sample(), free("asked")));
        let square = first.velocity * first.velocity * period;
        assume(before.alpha.below(limit.most()) & square.above(Of::smallest_normal()));
        let next = tick(period, before.effort, first.velocity * period, "next");
        let after = paths::step(|| filter.stabilize(&next.sample(), free("asked next")));
        at_least(after.observed_energy, (Of::of(1.0) - decay) * before.observed_energy)
    })
}

/// Observer/controller: below its limit what is served is the debt, to the last joule.
fn served() -> Vec<Path<Truth>> {
    paths::every(|| {
        let limit = DampingLimit::at(not_negative("limit")).expect("a limit");
        let mut popc =
            Lolc::new(PortEnergy, limit).restored(((), free("energy"))).expect("a memory");
        let period = positive("period");
        let now = tick(period, free("applied"), free("moved"), "now");
        let told = paths::step(|| popc.stabilize(&now.sample(), free("asked")));
        let square = now.velocity * now.velocity * period;
        assume(told.observed_energy.below(zero()) & told.alpha.below(limit.most()));
        assume(square.above(Of::smallest_normal()));
        equal(told.observed_energy + told.alpha * square, zero())
    })
}

/// Slope bound before a spring that is no softer than the slope: `2 μ E ≥ F²` is kept, `μ = 2 b / T`.
fn slope_bound() -> Vec<Path<Truth>> {
    paths::every(|| {
        let (slope, spring, period) = (positive("slope"), positive("spring"), positive("period"));
        assume(at_least(spring, slope));
        let (position, moved, held) = (free("position"), free("moved"), free("held"));
        let asked = spring * (position - moved);
        let force = asked - held;
        let energy = free("energy of port and damper");
        let two = Of::of(2.0);
        assume(at_least(two * slope * energy, force * force));
        let bound = SlopeBound::<Of>::new(slope).expect("a slope");
        let mut bound = bound.restored((asked, held, zero())).expect("a memory");
        let told = paths::step(|| {
            bound.stabilize(&tick(period, force, moved, "tick").sample(), spring * position)
        });
        // The damper b = μ T / 2 burns at least b Δx² / T.
        let after = energy + told.observed_energy + slope / two * moved * moved;
        at_least(two * slope * after, told.effort * told.effort)
    })
}

/// Side of a two-port: `L` less what was received and booked is the energy of its port less what it tells as absorbed.
///
/// The other side books no more than that, so both sums together are no more than the energy of both ports.
fn two_port() -> Vec<Path<Truth>> {
    paths::every(|| {
        let limit = DampingLimit::at(not_negative("limit")).expect("a limit");
        let [received, booked, absorbed] = ["received", "booked", "absorbed"].map(not_negative);
        let energy = free("energy");
        let memory = ((received, booked, absorbed, free("asked before")), energy);
        let mut side = TwoPortSide::<Of>::new(limit).restored(memory).expect("a memory");
        let now = tick(positive("period"), free("applied"), free("moved"), "now");
        paths::step(|| side.stabilize(&now.sample(), free("asked")));
        let ((_, booked_now, absorbed_now, _), energy_now) = side.state();
        let told = absorbed_now - absorbed;
        let port = now.applied * now.displacement;
        equal(energy_now - booked_now, energy - booked + port - told)
            & equal(booked_now, received)
            & at_least(told, zero())
    })
}

/// End of two layers: tank and what it sent, less what it received and booked, change by the energy of its port.
fn two_layer() -> Vec<Path<Truth>> {
    paths::every(|| {
        let share = not_negative("share");
        assume(!share.above(Of::of(1.0)));
        let sharing = Sharing { start: zero(), share };
        let end = TwoLayer::master(sharing, not_negative("level"), not_negative("gain"));
        let [received, booked, sent] = ["received", "booked", "sent"].map(not_negative);
        let energy = free("energy");
        let mut end =
            end.expect("an end").restored((energy, received, booked, sent)).expect("a memory");
        let now = tick(positive("period"), free("applied"), free("moved"), "now");
        paths::step(|| end.stabilize(&now.sample(), free("asked")));
        let (energy_now, _, booked_now, sent_now) = end.state();
        let port = now.applied * now.displacement;
        equal(energy_now + sent_now - booked_now, energy + sent - booked + port)
            & equal(booked_now, received)
            & at_least(sent_now, sent)
    })
}

/// Waves: the power at the port is half the difference of their squares.
fn waves() -> Vec<Path<Truth>> {
    paths::every(|| {
        let waves = WaveTransform::new(positive("impedance")).expect("an impedance");
        let (flow, effort) = (free("flow"), free("effort"));
        let (there, back) = waves.encode(flow, effort);
        let two = Of::of(2.0);
        equal(two * flow * effort, there * there - back * back)
    })
}

/// Filter of waves: `s² + (1 − r) / r · s²` stored falls by no less than what goes out beyond what comes in.
fn filtered() -> Vec<Path<Truth>> {
    paths::every(|| {
        let share = positive("share");
        assume(!share.above(Of::of(1.0)));
        let (wave, sent) = (free("wave"), free("sent"));
        let mut filter = WaveFilter::new(share).expect("a share").restored(sent).expect("a memory");
        let out = paths::step(|| filter.pass(wave));
        let kept = Of::of(1.0) - share;
        // Times the share: out² ≤ wave² + (1 − r) / r (sent² − out²).
        at_least(share * wave * wave + kept * (sent * sent - out * out), share * out * out)
    })
}

pub(crate) const CLAIMS: &[Claim] = &[
    Claim { name: "popc-serves", paths: served, cuts: Vec::new },
    Claim {
        name: "force-bound",
        paths: || force_bounded(|b| ForceBound::new(b).expect("a damping")),
        cuts: Vec::new,
    },
    Claim {
        name: "force-bounding",
        paths: || force_bounded(|b| ForceBounding::of_damping(b).expect("a damping")),
        cuts: Vec::new,
    },
    Claim { name: "energy-bounding-root", paths: root_of_the_band, cuts: Vec::new },
    Claim { name: "energy-bounding-longer", paths: root_of_a_longer_sample, cuts: Vec::new },
    Claim {
        name: "energy-bounding",
        paths: energy_bounded_as_published,
        cuts: || vec![band_root(), longer_root()],
    },
    Claim {
        name: "energy-bounding-tight",
        paths: || {
            energy_bounded(|damping, usual| {
                let slope = Of::of(2.0) * (damping / usual);
                (EnergyBounding::tight(damping, usual).expect("a damping"), slope)
            })
        },
        cuts: Vec::new,
    },
    Claim { name: "slope-bound", paths: slope_bound, cuts: Vec::new },
    Claim { name: "tank", paths: tank, cuts: Vec::new },
    Claim { name: "energy-tank", paths: energy_tank, cuts: Vec::new },
    Claim { name: "least-norm", paths: least_norm, cuts: Vec::new },
    Claim { name: "two-port", paths: two_port, cuts: Vec::new },
    Claim { name: "two-layer", paths: two_layer, cuts: Vec::new },
    Claim { name: "wave-transform", paths: waves, cuts: Vec::new },
    Claim { name: "wave-filter", paths: filtered, cuts: Vec::new },
];
