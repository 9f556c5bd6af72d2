//! Members: the family, each with any parameters, any memory and any sample.

use lyapunov_core::{
    Compensated, Dissipation, Held, InContact, Mask, Plain, PortEnergy, Requirement, Scalar, Signal,
};
use lyapunov_stabilizers::{
    AlongDirection, AxisWeights, DampingLimit, DirectedDamping, EnergyBounding, ForceBound,
    ForceBounding, LeastNorm, Lolc, MemoryBased, NoStabilizer, PathMemory, PerAxis, Plausibility,
    Popc, Sharing, SlopeBound, StabilizerExt, Tank, TankLimits, TwoLayer, TwoPortSide,
    WatchdogTimes, WindowedCredit,
};
use nalgebra::{SVector, Vector3};

use crate::fresh::{Axes, meets, parameter};
use crate::paths::assume;
use crate::properties::Kind::{self, Any, Damps, Reduces, Serves, Shapes};
use crate::seen::{Made, Seen, nothing_more, step};
use crate::symbolic::{Symbolic, Truth};

/// Member: its name, what it does, and its step seen on every path.
pub(crate) struct Member {
    pub(crate) name: &'static str,
    pub(crate) kind: Kind,
    pub(crate) seen: fn() -> Vec<Seen>,
}

type Of = Symbolic;

fn limit() -> DampingLimit<Of> {
    DampingLimit::at(parameter("limit", Requirement::Limit, 1e6)).expect("a limit")
}

fn popc() -> Popc<Of> {
    Popc::new(PortEnergy, limit())
}

fn damps<S>(stabilizer: S) -> Made<S> {
    Made { stabilizer, limit: Some(limit().most()) }
}

fn other<S>(stabilizer: S) -> Made<S> {
    Made { stabilizer, limit: None }
}

fn positive(name: &str) -> Of {
    parameter(name, Requirement::Positive, 1.0)
}

fn not_negative(name: &str) -> Of {
    parameter(name, Requirement::NonNegative, 1.0)
}

fn never_negative(value: Of) -> Truth {
    meets(Requirement::NonNegative, value)
}

fn none_negative<const N: usize>(values: &SVector<Of, N>) -> Truth {
    values.iter().fold(Truth::of(true), |all, value| all & never_negative(*value))
}

fn credited() -> (PortEnergy, Dissipation<Of>) {
    (PortEnergy, Dissipation::of(not_negative("damping")).expect("a damping"))
}

fn tank() -> Tank<Of, PortEnergy> {
    let witnesses = [("start", 2.0), ("floor", 1.0), ("ceiling", 3.0), ("power", 1.0)];
    let [start, floor, ceiling, power] = witnesses.map(|(name, value)| Of::free(name, value));
    assume(never_negative(floor) & never_negative(start - floor));
    assume(meets(Requirement::Limit, ceiling - start) & meets(Requirement::Limit, power));
    Tank::new(PortEnergy, TankLimits { start, floor, ceiling, power }).expect("a tank")
}

fn energy_bounding<V: Axes>() -> EnergyBounding<V> {
    let (rise, release) = (positive("c1"), positive("c2"));
    assume(!release.above(rise));
    EnergyBounding::new(rise, release).expect("constants")
}

type Window = WindowedCredit<Of, Plain<Of>, 8>;

fn windowed<V: Axes>() -> Vec<Seen> {
    let made = || {
        let sum = Window::of_ticks(5).expect("a window");
        let popc: Popc<Of, Held, Window> = popc().summed_by(sum);
        damps(popc)
    };
    step::<V, _>(made, |(_, (_, slots, _, _))| none_negative(slots))
}

fn directed<V: Axes>() -> Vec<Seen> {
    let made = || {
        let direction = V::called("direction", 1.0);
        assume(direction.map(|axis| axis * Of::of(0.0)).sum().finite());
        assume(direction.axes().iter().fold(Truth::of(false), |any, it| {
            any | !it.below(Of::of(0.0)) | it.below(Of::of(0.0))
        }));
        let along = AlongDirection::new(direction).expect("a direction");
        damps(DirectedDamping::new(popc(), along, limit()))
    };
    step::<V, _>(made, nothing_more)
}

fn weighted<V: Axes>() -> Vec<Seen> {
    let made = || {
        let weights = V::called("weight", 0.5);
        for weight in weights.axes() {
            assume(never_negative(weight) & meets(Requirement::AtMost(1.0), weight));
        }
        let weights = AxisWeights::new(weights).expect("weights");
        damps(DirectedDamping::new(popc(), weights, limit()))
    };
    step::<V, _>(made, nothing_more)
}

fn two_layer<V: Axes>() -> Vec<Seen> {
    let made = || {
        let share = not_negative("share");
        assume(meets(Requirement::AtMost(1.0), share));
        let sharing = Sharing { start: Of::of(0.0), share };
        let end = TwoLayer::master(sharing, not_negative("level"), not_negative("gain"));
        other(end.expect("an end"))
    };
    step::<V, _>(made, |(_, received, booked, sent)| {
        none_negative(&Vector3::new(*received, *booked, *sent))
    })
}

fn plausible<V: Axes>() -> Vec<Seen> {
    let most = |name: &str| parameter(name, Requirement::Limit, 1e6);
    let limits = || Plausibility { speed: most("speed"), effort: most("strongest") };
    step::<V, _>(|| damps(popc().plausible(limits()).expect("limits")), nothing_more)
}

/// The member of this name and kind.
const fn member(name: &'static str, kind: Kind, seen: fn() -> Vec<Seen>) -> Member {
    Member { name, kind, seen }
}

/// Controllers with their forms of a sum.
fn controllers<V: Axes>() -> Vec<Member> {
    vec![
        member("none", Any, || step::<V, _>(|| other(NoStabilizer), nothing_more)),
        member("popc", Serves, || step::<V, _>(|| damps(popc()), nothing_more)),
        member("popc-sampled", Serves, || step::<V, _>(|| damps(popc().sampled()), nothing_more)),
        member("popc-compensated", Serves, || {
            let made = || damps(popc().summed_in::<Compensated<Of>>());
            step::<V, _>(made, |(_, (sum, error))| (*sum + *error).finite())
        }),
        member("lolc", Serves, || {
            step::<V, _>(|| damps(Lolc::new(credited(), limit())), nothing_more)
        }),
        member("lolc-sampled", Serves, || {
            step::<V, _>(|| damps(Lolc::new(credited(), limit()).sampled()), nothing_more)
        }),
        member("popc-bounded", Serves, || {
            let most = || parameter("most", Requirement::Limit, 1.0);
            step::<V, _>(|| damps(popc().bounded(most()).expect("a bound")), nothing_more)
        }),
        member("popc-windowed", Serves, windowed::<V>),
    ]
}

/// A controller within what shapes its correction.
fn shaped<V: Axes>() -> Vec<Member> {
    vec![
        member("popc-threshold", Shapes, || {
            let made = || {
                let speed = not_negative("threshold");
                assume((speed * speed).finite());
                damps(popc().above_velocity(speed).expect("a speed"))
            };
            step::<V, _>(made, nothing_more)
        }),
        member("popc-spread", Shapes, || {
            let made = || damps(popc().spread_over(5).expect("ticks"));
            step::<V, _>(made, |(_, part)| never_negative(*part))
        }),
        member("popc-rate-limited", Shapes, || {
            let rate = || parameter("rate", Requirement::Limit, 1.0);
            step::<V, _>(|| damps(popc().rate_limited::<V>(rate()).expect("a rate")), nothing_more)
        }),
        member("popc-rising", Shapes, || {
            let made = || damps(popc().rising_over(5).expect("ticks"));
            step::<V, _>(made, |(_, engaged)| never_negative(*engaged))
        }),
        member("popc-weighted", Shapes, weighted::<V>),
        member("popc-directed", Shapes, directed::<V>),
        member("popc-watched", Any, || {
            let times = || WatchdogTimes {
                hold: parameter("hold", Requirement::Limit, 1.0),
                rise: not_negative("rise"),
            };
            let made = || other(popc().watched::<V>(times()).expect("times"));
            step::<V, _>(made, |(_, _, silence, risen)| {
                never_negative(*silence) & never_negative(*risen)
            })
        }),
    ]
}

/// The family beside POPC and LOLC.
fn further<V: Axes>() -> Vec<Member> {
    vec![
        member("least-norm", Damps, || {
            let made = || {
                let decay = positive("decay");
                assume(meets(Requirement::AtMost(1.0), decay));
                damps(LeastNorm::new(PortEnergy, limit(), decay).expect("a decay"))
            };
            step::<V, _>(made, nothing_more)
        }),
        member("two-port", Serves, || {
            let made = || damps(TwoPortSide::<V>::new(limit()));
            step::<V, _>(made, |((received, booked, absorbed, _), _)| {
                none_negative(&Vector3::new(*received, *booked, *absorbed))
            })
        }),
        member("two-layer", Any, two_layer::<V>),
        member("force-bound", Reduces, || {
            let made = || other(ForceBound::new(not_negative("damping")).expect("a damping"));
            step::<V, _>(made, nothing_more)
        }),
        member("force-bounding", Reduces, || {
            let bounding = || ForceBounding::of_damping(not_negative("damping"));
            step::<V, _>(|| other(bounding().expect("a damping")), nothing_more)
        }),
        member("tank", Reduces, || step::<V, _>(|| other(tank()), nothing_more)),
        member("energy-bounding", Any, || {
            step::<V, _>(|| other(energy_bounding::<V>()), nothing_more)
        }),
        member("slope-bound", Reduces, || {
            let made = || {
                let bound = SlopeBound::<V>::new(positive("slope")).expect("a slope");
                other(bound.creeping(not_negative("creep")).expect("a creep"))
            };
            step::<V, _>(made, nothing_more)
        }),
    ]
}

/// The members that serve every signal.
fn of_every_signal<V: Axes>() -> impl Iterator<Item = Member> {
    [controllers::<V>(), shaped::<V>(), further::<V>()].into_iter().flatten()
}

/// The members on one axis.
pub(crate) fn on_one_axis() -> Vec<Member> {
    let alone = [
        member("popc-plausible", Damps, plausible::<Of>),
        member("popc-contact-reset", Serves, || {
            let contact = || InContact { position: surface() };
            step::<Of, _>(|| damps(popc().reset_at(contact())), nothing_more)
        }),
        member("memory-based", Any, || {
            let memory = || MemoryBased::<Of, 4>::beyond(surface(), depth());
            let made = || other(memory().expect("a memory"));
            step::<Of, _>(made, |(_, forces, _)| none_negative(forces))
        }),
        member("path-memory", Any, || {
            let memory = || PathMemory::<Of, 4>::beyond(surface(), depth());
            let made = || other(memory().expect("a memory"));
            step::<Of, _>(made, |(forces, energy)| none_negative(forces) & never_negative(-*energy))
        }),
    ];
    of_every_signal::<Of>().chain(alone).collect()
}

fn surface() -> Of {
    parameter("surface", Requirement::Finite, 0.0)
}

fn depth() -> Of {
    let depth = positive("depth");
    assume(meets(Requirement::Positive, depth / Of::of(4.0)));
    depth
}

/// The members on three axes.
pub(crate) fn on_three_axes() -> Vec<Member> {
    let alone = [
        // An axis that nothing resolves is at rest for what is inside, beside others that move.
        member("popc-plausible", Shapes, plausible::<Vector3<Of>>),
        member("per-axis", Any, || {
            let made = || damps(PerAxis::of([popc(), popc(), popc()]));
            step::<Vector3<Of>, _>(made, |_| Truth::of(true))
        }),
    ];
    of_every_signal::<Vector3<Of>>().chain(alone).collect()
}
