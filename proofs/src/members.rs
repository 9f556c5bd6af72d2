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
use crate::properties::Kind;
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

/// The members that serve every signal.
fn of_every_signal<V: Axes>() -> Vec<Member> {
    vec![
        Member {
            name: "none",
            kind: Kind::Any,
            seen: || step::<V, _>(|| other(NoStabilizer), nothing_more),
        },
        Member {
            name: "popc",
            kind: Kind::Serves,
            seen: || step::<V, _>(|| damps(popc()), nothing_more),
        },
        Member {
            name: "popc-sampled",
            kind: Kind::Serves,
            seen: || step::<V, _>(|| damps(popc().sampled()), nothing_more),
        },
        Member {
            name: "popc-compensated",
            kind: Kind::Serves,
            seen: || {
                step::<V, _>(
                    || damps(popc().summed_in::<Compensated<Of>>()),
                    |(_, (sum, error))| (*sum + *error).finite(),
                )
            },
        },
        Member {
            name: "lolc",
            kind: Kind::Serves,
            seen: || step::<V, _>(|| damps(Lolc::new(credited(), limit())), nothing_more),
        },
        Member {
            name: "lolc-sampled",
            kind: Kind::Serves,
            seen: || step::<V, _>(|| damps(Lolc::new(credited(), limit()).sampled()), nothing_more),
        },
        Member {
            name: "popc-bounded",
            kind: Kind::Serves,
            seen: || {
                let most = || parameter("most", Requirement::Limit, 1.0);
                step::<V, _>(|| damps(popc().bounded(most()).expect("a bound")), nothing_more)
            },
        },
        Member { name: "popc-windowed", kind: Kind::Serves, seen: windowed::<V> },
        Member {
            name: "popc-threshold",
            kind: Kind::Shapes,
            seen: || {
                let speed = || {
                    let speed = not_negative("threshold");
                    assume((speed * speed).finite());
                    speed
                };
                step::<V, _>(
                    || damps(popc().above_velocity(speed()).expect("a speed")),
                    nothing_more,
                )
            },
        },
        Member {
            name: "popc-spread",
            kind: Kind::Shapes,
            seen: || {
                step::<V, _>(
                    || damps(popc().spread_over(5).expect("ticks")),
                    |(_, part)| never_negative(*part),
                )
            },
        },
        Member {
            name: "popc-rate-limited",
            kind: Kind::Shapes,
            seen: || {
                let rate = || parameter("rate", Requirement::Limit, 1.0);
                step::<V, _>(
                    || damps(popc().rate_limited::<V>(rate()).expect("a rate")),
                    nothing_more,
                )
            },
        },
        Member {
            name: "popc-rising",
            kind: Kind::Shapes,
            seen: || {
                step::<V, _>(
                    || damps(popc().rising_over(5).expect("ticks")),
                    |(_, engaged)| never_negative(*engaged),
                )
            },
        },
        Member { name: "popc-weighted", kind: Kind::Shapes, seen: weighted::<V> },
        Member { name: "popc-directed", kind: Kind::Shapes, seen: directed::<V> },
        Member {
            name: "popc-watched",
            kind: Kind::Any,
            seen: || {
                let times = || WatchdogTimes {
                    hold: parameter("hold", Requirement::Limit, 1.0),
                    rise: not_negative("rise"),
                };
                let made = || other(popc().watched::<V>(times()).expect("times"));
                step::<V, _>(made, |(_, _, silence, risen)| {
                    never_negative(*silence) & never_negative(*risen)
                })
            },
        },
        Member {
            name: "least-norm",
            kind: Kind::Damps,
            seen: || {
                let decay = || {
                    let decay = positive("decay");
                    assume(meets(Requirement::AtMost(1.0), decay));
                    decay
                };
                step::<V, _>(
                    || damps(LeastNorm::new(PortEnergy, limit(), decay()).expect("a decay")),
                    nothing_more,
                )
            },
        },
        Member {
            name: "two-port",
            kind: Kind::Serves,
            seen: || {
                step::<V, _>(
                    || damps(TwoPortSide::<V>::new(limit())),
                    |((received, booked, absorbed, _), _)| {
                        none_negative(&Vector3::new(*received, *booked, *absorbed))
                    },
                )
            },
        },
        Member { name: "two-layer", kind: Kind::Any, seen: two_layer::<V> },
        Member {
            name: "force-bound",
            kind: Kind::Reduces,
            seen: || {
                step::<V, _>(
                    || other(ForceBound::new(not_negative("damping")).expect("a damping")),
                    nothing_more,
                )
            },
        },
        Member {
            name: "force-bounding",
            kind: Kind::Reduces,
            seen: || {
                step::<V, _>(
                    || {
                        other(
                            ForceBounding::of_damping(not_negative("damping")).expect("a damping"),
                        )
                    },
                    nothing_more,
                )
            },
        },
        Member {
            name: "tank",
            kind: Kind::Reduces,
            seen: || step::<V, _>(|| other(tank()), nothing_more),
        },
        Member {
            name: "energy-bounding",
            kind: Kind::Any,
            seen: || step::<V, _>(|| other(energy_bounding::<V>()), nothing_more),
        },
        Member {
            name: "slope-bound",
            kind: Kind::Reduces,
            seen: || {
                let made = || {
                    let bound = SlopeBound::<V>::new(positive("slope")).expect("a slope");
                    other(bound.creeping(not_negative("creep")).expect("a creep"))
                };
                step::<V, _>(made, nothing_more)
            },
        },
    ]
}

/// The members on one axis.
pub(crate) fn on_one_axis() -> Vec<Member> {
    let mut members = of_every_signal::<Of>();
    members.push(Member { name: "popc-plausible", kind: Kind::Damps, seen: plausible::<Of> });
    members.push(Member {
        name: "popc-contact-reset",
        kind: Kind::Serves,
        seen: || {
            let contact = || InContact { position: parameter("surface", Requirement::Finite, 0.0) };
            step::<Of, _>(|| damps(popc().reset_at(contact())), nothing_more)
        },
    });
    members.push(Member {
        name: "memory-based",
        kind: Kind::Any,
        seen: || {
            let made = || {
                other(
                    MemoryBased::<Of, 4>::beyond(
                        parameter("surface", Requirement::Finite, 0.0),
                        depth(),
                    )
                    .expect("a memory"),
                )
            };
            step::<Of, _>(made, |(_, forces, _)| none_negative(forces))
        },
    });
    members.push(Member {
        name: "path-memory",
        kind: Kind::Any,
        seen: || {
            let made = || {
                other(
                    PathMemory::<Of, 4>::beyond(
                        parameter("surface", Requirement::Finite, 0.0),
                        depth(),
                    )
                    .expect("a memory"),
                )
            };
            step::<Of, _>(made, |(forces, debt)| none_negative(forces) & never_negative(*debt))
        },
    });
    members
}

fn depth() -> Of {
    let depth = positive("depth");
    assume(meets(Requirement::Positive, depth / Of::of(4.0)));
    depth
}

/// The members on three axes.
pub(crate) fn on_three_axes() -> Vec<Member> {
    let mut members = of_every_signal::<Vector3<Of>>();
    // An axis that nothing resolves is at rest for what is inside, beside others that move.
    let seen = plausible::<Vector3<Of>>;
    members.push(Member { name: "popc-plausible", kind: Kind::Shapes, seen });
    members.push(Member {
        name: "per-axis",
        kind: Kind::Any,
        seen: || {
            step::<Vector3<Of>, _>(
                || damps(PerAxis::of([popc(), popc(), popc()])),
                |_| Truth::of(true),
            )
        },
    });
    members
}
