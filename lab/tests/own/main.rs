//! Own stabilizers among those that ship. A target of its own, since they are entered once for a whole program.

macro_rules! own {
    ($Type:ident, $name:literal, $numbers:expr, $promise:ident, |$on:pat_param| $made:expr) => {
        pub(crate) struct $Type;

        impl OwnStabilizer for $Type {
            const NAME: &'static str = $name;
            const NUMBERS: &'static [OwnNumber] = &$numbers;
            const PROMISE: Promise = Promise::$promise;

            fn make<V: Signal>(
                $on: &Loop<'_>,
            ) -> Result<impl Stabilizer<V> + 'static, ParameterError> {
                $made
            }
        }
    };
}

mod cut;
mod soak;

use std::fmt::Debug;
use std::ops::ControlFlow;
use std::sync::Once;

use lyapunov::{
    Correction, Dissipation, LyapunovCandidate, ParameterError, PortEnergy, PortSample, Scalar,
    Signal, Stabilizer,
};
use lyapunov_lab::compare::{Comparison, Entrants};
use lyapunov_lab::family::{StabilizerName, StabilizerNames};
use lyapunov_lab::hard::{Catalogue, Row};
use lyapunov_lab::map::{Grid, Outcome, Run};
use lyapunov_lab::own::{
    Allowed, Loop, OwnCandidate, OwnNumber, OwnStabilizer, Promise, Roster, RosterError, Search,
};
use lyapunov_lab::scenes::text_of;
use lyapunov_lab::tune::Tuning;
use lyapunov_lab::{Rollout, SVector, Scene, Space, Summary, scene};

/// POPC written out, whose sum keeps the share `kept` from tick to tick.
struct Hand<T> {
    sum: T,
    limit: T,
    kept: T,
}

impl<V: Signal> Stabilizer<V> for Hand<V::Scalar> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let choose = <V::Scalar as Signal>::choose;
        let (zero, tiny) = (V::Scalar::of(0.0), V::Scalar::smallest_normal());
        let square = sample.velocity.inner(sample.velocity) * sample.period;
        let work = sample.work.sum();
        let booked = (self.sum + work).finite();
        let work = choose(booked, work, zero);
        let sound = booked & sample.sound() & effort.finite() & square.finite();
        let square = choose(sound, square, zero);
        let velocity = V::choose(sound, sample.velocity, V::zero());
        let effort = V::choose(sound, effort, V::zero());

        let most = choose(square.above(tiny), self.limit, zero);
        let margin = V::Scalar::of(1.0) - V::Scalar::of(4.0) * V::Scalar::epsilon();
        let inverse = V::Scalar::of(-1.0) / (square * margin).larger(tiny);
        let sum = self.sum + work;
        // What this tick's damping does is in the work of the next sample.
        self.sum = sum * self.kept;
        let alpha = (sum * inverse).smaller(most).larger(zero);
        let served = sum + alpha * square;
        Correction {
            effort: effort + velocity.scale(alpha),
            observed_energy: sum,
            alpha,
            shortfall: zero - served.smaller(zero),
            accepted: sound,
        }
    }
}

fn hand<T: Scalar>(on: &Loop<'_>, kept: f64) -> Result<Hand<T>, ParameterError> {
    let limit = on.damping_limit::<T>()?.most();
    Ok(Hand { sum: T::of(0.0), limit, kept: T::of(kept) })
}

/// Time in which the sum leaks away.
const LEAK: OwnNumber = OwnNumber::new("leak", "s", Allowed::Positive, |on| 20.0 * on.period())
    .searched(|default, _| Search::ratios(0.1 * default, 10.0 * default));

/// The share that a leak leaves from tick to tick.
fn left(on: &Loop<'_>) -> f64 {
    1.0 - on.period() / on.number::<f64>(LEAK).max(on.period())
}

const CAP: OwnNumber = OwnNumber::DAMPING_CAP;
const COUNT: OwnNumber = OwnNumber::new("count", "ticks", Allowed::Ticks, |_| 4.0);
const SIZE: OwnNumber = OwnNumber::new("size", "m", Allowed::Positive, |_| f64::NAN);

own!(MyPopc, "my-popc", [CAP], Serves, |on| hand::<V::Scalar>(on, 1.0));
own!(Leaky, "leaky", [CAP, LEAK], Damps, |on| hand::<V::Scalar>(on, left(on)));
own!(LeakyLiar, "leaky-liar", [CAP, LEAK], Serves, |on| hand::<V::Scalar>(on, left(on)));
own!(Idle, "idle", [], Damps, |on| hand::<V::Scalar>(on, 1.0)
    .map(|hand| Hand { limit: V::Scalar::of(0.0), ..hand }));
own!(IdleLiar, "idle-liar", [], Serves, |on| hand::<V::Scalar>(on, 1.0)
    .map(|hand| Hand { limit: V::Scalar::of(0.0), ..hand }));
own!(Choosy, "choosy", [COUNT, SIZE], Damps, |on| {
    assert!(on.number::<f64>(SIZE) > 0.0 && on.number::<f64>(COUNT) >= 1.0);
    hand::<V::Scalar>(on, 1.0)
});
/// Damping of the device's own damper, as the library's candidate has it.
struct MyDamping;

impl OwnCandidate for MyDamping {
    const NAME: &'static str = "my-damping";

    fn make<V: Signal>(
        on: &Loop<'_>,
    ) -> Result<impl LyapunovCandidate<V> + 'static, ParameterError> {
        Ok((PortEnergy, Dissipation::of(V::Scalar::of(on.damping()))?))
    }
}

/// The name, of those that ship and the own ones of this file.
fn name(name: &str) -> StabilizerName {
    static ENTERED: Once = Once::new();
    ENTERED.call_once(|| {
        let roster = Roster::new()
            .stabilizer::<MyPopc>()
            .stabilizer::<Leaky>()
            .stabilizer::<LeakyLiar>()
            .stabilizer::<Idle>()
            .stabilizer::<IdleLiar>()
            .stabilizer::<Choosy>()
            .stabilizer::<cut::Cutter>()
            .stabilizer::<cut::Choosing>()
            .stabilizer::<soak::Hasty>()
            .stabilizer::<soak::Halving>()
            .stabilizer::<soak::Exacting>()
            .stabilizer::<soak::Dozing>()
            .stabilizer::<soak::Dazed>()
            .candidate::<MyDamping>();
        roster.enter().unwrap();
    });
    name.parse().unwrap_or_else(|error| panic!("{error}"))
}

fn parsed(text: &str) -> Scene {
    name("none");
    Scene::parse(text, "test").unwrap_or_else(|fault| panic!("{fault}"))
}

fn shipped(scene: &str) -> Scene {
    parsed(text_of(scene).unwrap())
}

/// The runs of `scene` under two names, number by number as text: shortest digits, so equal texts are equal bits.
fn rows<V: Space + Debug>(scene: &Scene) -> Vec<String> {
    Rollout::<V>::of(scene).unwrap().map(|tick| format!("{tick:?}")).collect()
}

#[test]
fn a_popc_by_hand_is_popc_bit_for_bit_in_scenes() {
    let mut compared = 0;
    for (scene, table) in [("hold", "[stabilizer.popc]"), ("delay", ""), ("plane", "")] {
        let text = text_of(scene).unwrap().replace(table, "");
        for written in ["", "damping_cap = 0.1\n"] {
            for scalar in ["f64", "f32"] {
                let with = |name: &str| {
                    let table = format!("\n[stabilizer.{name}]\n{written}");
                    let text = text.split("[stabilizer").next().unwrap_or(&text);
                    parsed(&format!("scalar = \"{scalar}\"\n{text}{table}"))
                };
                let [popc, mine] = ["popc", "my-popc"].map(with);
                let [popc, mine] = match (scene, scalar) {
                    ("plane", "f64") => [popc, mine].map(|it| rows::<SVector<f64, 2>>(&it)),
                    ("plane", _) => [popc, mine].map(|it| rows::<SVector<f32, 2>>(&it)),
                    (_, "f64") => [popc, mine].map(|it| rows::<f64>(&it)),
                    _ => [popc, mine].map(|it| rows::<f32>(&it)),
                };
                assert!(popc == mine, "{scene} {scalar} {written}");
                compared += popc.len();
            }
        }
    }
    assert!(compared > 10_000, "{compared}");
}

#[test]
fn a_popc_by_hand_is_popc_in_compare_map_and_tune() {
    name("none");
    let scene = shipped("hold");
    let names = ["popc", "my-popc"].map(name);
    let comparison = Comparison::of("hold", &scene, &Entrants::<f64>::of(names)).unwrap();
    let scores: Vec<_> = comparison.scores().cloned().collect();
    assert_eq!(scores[1].stabilizer, "my-popc");
    assert!(scores[0].active.is_some_and(|share| share > 0.0), "{:?}", scores[0]);
    let same = |score: &lyapunov_lab::compare::Score| {
        let (stabilizer, step_time, state_bytes) = (String::new(), None, 0);
        lyapunov_lab::compare::Score { stabilizer, step_time, state_bytes, ..score.clone() }
    };
    assert_eq!(same(&scores[0]), same(&scores[1]));

    let axis = |text: &str| text.parse().unwrap();
    let axes = ["environment.wall.stiffness=500..9000:4", "stabilizer.popc.damping_cap=0.1..1.0:3"];
    let map = |names: &[StabilizerName]| -> Vec<Vec<Outcome>> {
        let axes = axes.map(axis);
        let [x, y] = axes;
        let grid = Grid::new(scene.clone(), x, y, names.iter().copied()).unwrap();
        let mut all = Vec::new();
        let put = &mut |_: u64, outcomes: &[Vec<Outcome>]| {
            all.extend_from_slice(outcomes);
            Ok(())
        };
        Run::one_by_one(&grid, Some(1)).unwrap().cells(0..12, &|| true, put).unwrap();
        all
    };
    let cells = map(&names);
    assert_eq!(cells.len(), 12);
    assert!(cells.iter().all(|cell| cell[0] == cell[1]), "{cells:?}");
    assert!(cells.iter().any(|cell| cell != &cells[0]));

    let tuning = Tuning { trials: 6, runs: 2, ..Tuning::default() };
    let tuned = names.map(|it| tuning.of(&scene, it, &|_| ControlFlow::Continue(())).unwrap());
    let [popc, mine] = &tuned;
    assert_eq!((&popc.judged, &popc.seen), (&mine.judged, &mine.seen));
    assert_ne!(popc.settings[0], popc.settings[1]);
    let value = |at: usize| tuned.each_ref().map(|it| it.settings[at].numbers()[0].value);
    assert!(value(0)[0] == value(0)[1] && value(1)[0] == value(1)[1]);
    // The scene with it is ready to run, and runs as that with POPC does.
    let text = mine.text().unwrap();
    assert!(text.contains("[stabilizer.my-popc]\ndamping_cap = "), "{text}");
    assert_eq!(rows::<f64>(&parsed(&text)), rows::<f64>(&popc.scene));
}

#[test]
fn an_own_candidate_is_watched_by_lolc() {
    let own = name("lolc-my-damping");
    for scene in [shipped("hold"), shipped("press-1khz")] {
        let rows = [name("lolc-device-damping"), own].map(|name| {
            let rollout = Rollout::<f64>::under(&scene, name).unwrap();
            rollout.map(|tick| format!("{tick:?}")).collect::<Vec<_>>()
        });
        assert!(rows[0] == rows[1] && rows[0].len() > 1000);
    }
    let keys: Vec<_> = own.parameters(&shipped("hold")).iter().map(|it| it.key).collect();
    assert_eq!(keys, ["stabilizer.lolc-my-damping.damping_cap"]);
}

#[test]
fn hard_judges_by_what_is_declared() {
    let of = |it: &str| Catalogue::of(Some(name(it)), &|| ControlFlow::Continue(())).unwrap();
    let [mine, popc] = ["my-popc", "popc"].map(of);
    assert!(mine.passed(), "{mine}");
    let measured = |catalogue: &Catalogue| -> Vec<_> {
        let bits = |it: &Row| [it.measured, it.largest_force_n].map(f64::to_bits);
        catalogue.rows.iter().map(|row| (row.case, bits(row), row.promised)).collect()
    };
    assert_eq!(measured(&mine), measured(&popc));

    for (honest, liar) in [("leaky", "leaky-liar"), ("idle", "idle-liar")] {
        let [honest, liar] = [honest, liar].map(of);
        assert!(honest.passed(), "{honest}");
        let over = honest.rows.iter().filter(|row| row.measured > row.bound).count();
        assert!(over > 0 && honest.to_string().contains("does not promise"), "{honest}");
        assert!(!liar.passed(), "{liar}");
        assert_eq!(honest.rows.len(), liar.rows.len());
    }
    assert!(of("leaky-liar").rows.iter().any(|row| row.broken.is_some()));
    assert!(of("lolc-my-damping").passed());
    // It needs a number that no case writes.
    assert!(of("choosy").rows.is_empty());
}

#[test]
fn names_and_lists_of_names_know_own_ones() {
    name("none");
    let told = "my-pop".parse::<StabilizerName>().unwrap_err().to_string();
    assert!(told.contains("did you mean `my-popc`?") && told.contains("lolc-my-damping"), "{told}");
    let all: StabilizerNames = "all".parse().unwrap();
    assert_eq!(all.len(), StabilizerName::ALL.len() + 14);
    let fits = all.on(&shipped("hold"));
    assert!(fits.contains(&name("my-popc")) && !fits.contains(&name("choosy")));
    assert_eq!(StabilizerName::all().last(), Some(name("lolc-my-damping")));
}

fn fault(table: &str) -> String {
    name("none");
    let text = text_of("hold").unwrap().replace("[stabilizer.popc]", table);
    Scene::parse(&text, "hold.toml").unwrap_err().to_string()
}

#[test]
fn faults_in_own_tables_are_told_as_those_in_others() {
    let told = fault("[stabilizer.leaky]\nleek = 0.1");
    assert!(told.contains("hold.toml:24:1: unknown key `leek` in [stabilizer.leaky]"), "{told}");
    assert!(told.contains("did you mean `leak`?"), "{told}");
    assert!(told.contains("known keys here: damping_cap, leak"), "{told}");
    let told = fault("[stabilizer.leaky]\nleak = -1.0");
    assert!(
        told.contains("hold.toml:24:8: `stabilizer.leaky.leak` must be finite and greater"),
        "{told}"
    );
    assert!(told.contains("the unit is s; for example: leak = 1.0  # s"), "{told}");
    let told = fault("[stabilizer.choosy]\ncount = 2.5\nsize = 1.0");
    assert!(told.contains("`stabilizer.choosy.count` must be a whole number"), "{told}");
    let told = fault("[stabilizer.choosy]");
    assert!(told.contains("`stabilizer.choosy.size` has no default on this loop"), "{told}");
    let told = fault("[stabilizer.leeky]");
    assert!(
        told.contains("unknown key `leeky`") && told.contains("did you mean `leaky`?"),
        "{told}"
    );
    let told = fault("[stabilizer]\nleaky = \"yes\"");
    assert!(told.contains("`stabilizer.leaky` must be a table"), "{told}");
    let scene = parsed(
        &text_of("hold")
            .unwrap()
            .replace("[stabilizer.popc]", "[stabilizer.choosy]\ncount = 3\nsize = 0.5"),
    );
    let text = toml::to_string(&scene).unwrap();
    assert!(text.contains("[stabilizer.choosy]\ncount = 3\nsize = 0.5"), "{text}");
    assert_eq!(parsed(&text), scene);
}

#[test]
fn the_schema_has_own_tables() {
    name("none");
    let validator = jsonschema::validator_for(&scene::schema()).unwrap();
    let valid = |table: &str| {
        let text = text_of("hold").unwrap().replace("[stabilizer.popc]", table);
        let value: toml::Value = toml::from_str(&text).unwrap();
        validator.is_valid(&serde_json::to_value(value).unwrap())
    };
    assert!(valid("[stabilizer.leaky]\nleak = 0.1") && valid("[stabilizer.choosy]\ncount = 2"));
    for wrong in ["leaky]\nleak = 0.0", "leaky]\nleek = 1.0", "choosy]\ncount = 2.5", "nobody]"] {
        assert!(!valid(&format!("[stabilizer.{wrong}")), "{wrong}");
    }
}

own!(Shadow, "popc", [], Damps, |on| hand::<V::Scalar>(on, 1.0));
own!(Everybody, "all", [], Damps, |on| hand::<V::Scalar>(on, 1.0));
own!(Shouting, "My Popc", [], Damps, |on| hand::<V::Scalar>(on, 1.0));
own!(Keyed, "keyed", [OwnNumber::new("a b", "", Allowed::Finite, |_| 0.0)], Damps, |on| hand::<
    V::Scalar,
>(on, 1.0));
own!(KeyedTwice, "keyed", [CAP, CAP], Damps, |on| hand::<V::Scalar>(on, 1.0));

#[test]
fn a_roster_says_what_is_wrong_with_it() {
    name("none");
    let told = |roster: Roster| roster.enter().unwrap_err();
    assert_eq!(told(Roster::new().stabilizer::<Shadow>()), RosterError::Shipped("popc"));
    assert_eq!(told(Roster::new().stabilizer::<Everybody>()), RosterError::Shipped("all"));
    assert_eq!(told(Roster::new().stabilizer::<Shouting>()), RosterError::Name("My Popc"));
    assert_eq!(told(Roster::new().stabilizer::<Keyed>()), RosterError::Key("keyed", "a b"));
    let twice = RosterError::KeyTwice("keyed", "damping_cap");
    assert_eq!(told(Roster::new().stabilizer::<KeyedTwice>()), twice);
    let twice = Roster::new().candidate::<MyDamping>().candidate::<MyDamping>();
    assert_eq!(told(twice), RosterError::Twice("lolc-my-damping"));
    assert_eq!(told(Roster::new().stabilizer::<MyPopc>()), RosterError::Late);
    for error in [RosterError::Shipped("popc"), RosterError::Name("A"), RosterError::Late] {
        assert!(error.to_string().contains("\n  = "), "{error}");
    }
}

#[test]
fn a_summary_tells_what_ran() {
    let scene = shipped("hold");
    let line = |summary: &Summary| {
        let text = summary.to_string();
        text.lines().find(|line| line.contains("  stabilizer ")).unwrap().to_owned()
    };
    let foreign = Hand { sum: 0.0, limit: 5.0, kept: 1.0 };
    let foreign = Summary::of(&scene, Rollout::<f64>::stabilized_by(&scene, foreign).unwrap());
    assert_eq!(line(&foreign), "  stabilizer   Hand, which is the program's own");
    assert!(
        foreign.to_string().contains("\n  controller ") && !foreign.to_string().contains("POPC")
    );
    let under = |it| Summary::of(&scene, Rollout::<f64>::under(&scene, name(it)).unwrap());
    assert_eq!(line(&under("leaky")), "  stabilizer   leaky: damping_cap 0.5 m / T, leak 0.02 s");
    assert_eq!(
        line(&under("tank")),
        line(&{
            let tank = name("tank").written_in(&scene, &[]).unwrap();
            Summary::of(&tank, Rollout::<f64>::of(&tank).unwrap())
        })
    );
    let none = under("none");
    assert_eq!(line(&none), "  stabilizer   none");
    assert!(none.to_json("hold").contains("\"stabilizer\": null"));
    let own = Summary::of(&scene, Rollout::<f64>::of(&scene).unwrap());
    assert!(line(&own).contains("POPC"), "{own}");
}
