//! The tables of a tuning in the terminal.

use lyapunov::DampingLimit;

use super::objective::{Objective, Term};
use super::study::{Tuned, Tuning};
use super::trial::Trial;
use crate::files::Scene;
use crate::measure::Summary;
use crate::show::described;
use crate::show::table::{Cell, Heading, Table};
use crate::simulate::family::StabilizerName;
use crate::simulate::{Criterion, Rollout, in_space};
use crate::studies::explain::Hint;
use crate::text::{folded, found, given};

/// The table of default against tuned, under a head that says how they were found.
pub fn table(name: &str, tuning: &Tuning, tuned: &[Tuned]) -> String {
    let Tuning { objective, trials, runs, seed, .. } = tuning;
    let judges = tuned.first().map_or(0, |one| one.judged[1].runs());
    let head = format!(
        "{name}, objective {objective}\n{} settings of {runs} runs for each stabilizer, seed {seed}; judged on {judges} \
         other runs\n",
        trials + 1
    );
    format!(
        "{}{}\n{}\n{}{}",
        textwrap::fill(&head, 100),
        signs(tuned),
        numbers(tuned),
        costs(tuning.objective, tuned),
        remarks(tuning.objective, tuned)
            .iter()
            .map(|it| folded("note: ", it) + "\n")
            .collect::<String>()
    )
}

/// Remarks on a judgement: runs that are too short, costs that are all the duration, stabilizers that chance may order, caps,
/// a saturation.
pub(super) fn remarks(objective: Objective, tuned: &[Tuned]) -> Vec<String> {
    let judged = || tuned.iter().flat_map(|one| &one.judged);
    let runs = judged().map(Trial::runs).max().unwrap_or(0);
    let short = judged().map(Trial::too_short).max().unwrap_or(0);
    let settles = judged().any(|trial| trial.settle() > 0);
    let bounded = judged().any(|trial| trial.bounded() > 0);
    let counts = objective.weight(Term::Settling) > 0.0;
    let own = tuned.first().is_some_and(|one| Criterion::of(&one.scene).shortage.is_some());
    let why = if own {
        "as the scene itself is"
    } else {
        "as a moved mass or stiffness swings more slowly"
    };
    let too_short = (short > 0).then(|| {
        format!(
            "up to {short} of {runs} runs are too short to judge, {why}: give a longer duration"
        )
    });
    let idle = (counts && bounded && !settles).then(|| {
        "no judged run settles, so each counts its whole duration: give a longer one, or another --objective \
         where they rest elsewhere"
            .to_owned()
    });
    let saturated = tuned.first().and_then(|one| described::saturated(&one.scene));
    let others = [level(tuned), exceeded_caps(tuned), saturated, near_floor(tuned)];
    too_short.into_iter().chain(idle).chain(others.into_iter().flatten()).collect()
}

/// The remark on a cap that was tuned, which the search takes down to where runs begin to grow.
fn near_floor(tuned: &[Tuned]) -> Option<String> {
    let mut numbers = tuned.iter().flat_map(|one| one.settings[1].numbers());
    let is_cap = numbers.any(|it| it.name() == "damping_cap");
    let told = "a tuned damping_cap may stand close to the floor below which the loop is lost: sweep it, and stay at twice \
                the floor or above (docs/tune.md)";
    is_cap.then(|| told.to_owned())
}

/// The settings whose damping cap is too high for the delay of the scene, if there are any.
fn exceeded_caps(tuned: &[Tuned]) -> Option<String> {
    let told = tuned.iter().flat_map(|one| {
        ["default", "tuned"].into_iter().zip(&one.settings).filter_map(move |(word, setting)| {
            let sentence = described::exceeded_cap(&setting.on(&one.scene).ok()?)?;
            Some((format!("{} {word}", one.name), sentence))
        })
    });
    let (names, sentences): (Vec<_>, Vec<_>) = told.unzip();
    // The limit is that of the delay, which all settings share.
    Some(format!("{}: {}", names.join(", "), sentences.first()?))
}

/// The signs of a scene in which no force acts or which starts in balance, a line each: there is nothing to tune for then.
pub(super) fn signs(tuned: &[Tuned]) -> String {
    let Some(Tuned { scene, .. }) = tuned.first() else { return String::new() };
    let run = in_space!(scene, Axes => Rollout::<Axes>::of(scene).map(|it| Summary::of(scene, it)));
    let Ok(run) = run else { return String::new() };
    let idle = if run.acts() { Vec::new() } else { run.look_at() };
    let signs = idle.into_iter().map(|it| folded("look at: ", &it.text));
    let calm = Hint::of(&run).remark().map(|it| folded("note: ", &it));
    signs.chain(calm).map(|line| line + "\n").collect()
}

/// The stabilizers that the judged runs do not tell apart from the best, which is the best of them by chance too.
fn level(tuned: &[Tuned]) -> Option<String> {
    let best = Tuned::best(tuned).filter(|best| best.judged[1].bounded() > 0)?;
    let names: Vec<&str> = best.level(tuned).into_iter().map(StabilizerName::name).collect();
    let name = best.name.name();
    (!names.is_empty()).then(|| {
        format!("{name} comes first; these runs do not tell it apart from {}", names.join(", "))
    })
}

/// The numbers as the scene sets them and tuned.
pub(super) fn numbers(tuned: &[Tuned]) -> Table {
    let mut table = Table::new([
        Heading::word("stabilizer"),
        Heading::word("parameter"),
        Heading::number("default"),
        Heading::number("tuned"),
        Heading::word("unit"),
    ]);
    for one in tuned {
        let [default, best] = &one.settings;
        if default.numbers().is_empty() {
            table.push([
                one.name.name().into(),
                "none to tune".into(),
                "".into(),
                "".into(),
                "".into(),
            ]);
        }
        for (index, (before, after)) in default.numbers().iter().zip(best.numbers()).enumerate() {
            let name = if index == 0 { one.name.name() } else { "" };
            let value = |value: f64| {
                if value.is_finite() { given(value).to_string() } else { "inf".into() }
            };
            table.push([
                name.into(),
                before.name().into(),
                value(before.value).into(),
                value(after.value).into(),
                before.unit.into(),
            ]);
            if before.name() == "damping_cap" {
                // A program of your own may take the limit itself, and not its share of m / T.
                let [before, after] = [before, after].map(|cap| limit(&one.scene, cap.value));
                table.push(["".into(), "damping limit".into(), before, after, "N.s/m".into()]);
            }
        }
    }
    table
}

/// The damping limit that a cap in m / T is on `scene`, N·s/m.
fn limit(scene: &Scene, cap: f64) -> Cell {
    // A limit is finite, and without a cap the largest number would stand here.
    if cap.is_infinite() {
        return "inf".into();
    }
    scene.damping(cap).limit::<f64>().ok().map(DampingLimit::most).into()
}

/// The costs of both settings on the runs that tuning never saw.
pub(super) fn costs(objective: Objective, tuned: &[Tuned]) -> Table {
    let unit = match objective.unit() {
        "" => String::new(),
        unit => format!("\n{unit}"),
    };
    let mut table = Table::new([
        Heading::word("stabilizer"),
        Heading::number("bounded,\nsettle,\ndefault"),
        Heading::number("bounded,\nsettle,\ntuned"),
        Heading::number(format!("mean\ncost,\ndefault{unit}")),
        Heading::number(format!("mean\ncost,\ntuned{unit}")),
        Heading::number(format!("change with\n95 % interval{unit}")),
        Heading::word("tuned is"),
    ]);
    for one in tuned {
        let held = one.judged.each_ref().map(|it| format!("{}, {}", it.bounded(), it.settle()));
        let [before, after] = one.judged.each_ref().map(|it| it.cost());
        let change = one.judged[1].change_from(&one.judged[0]);
        let change = change.map(|(change, half)| format!("{} +- {}", found(change), found(half)));
        let [default, best] = held;
        table.push([
            one.name.name().into(),
            default.into(),
            best.into(),
            before.into(),
            after.into(),
            change.into(),
            word(one).into(),
        ]);
    }
    table
}

/// Comparison of the tuned setting, and whether it keeps every run bounded.
fn word(one: &Tuned) -> String {
    let (word, judged) = (one.change().word(), &one.judged[1]);
    let short = judged.too_short();
    let grow = judged.runs() - judged.bounded() - short;
    let mut told = match judged.bounded() {
        0 if short == 0 => return "none bounded".to_owned(),
        0 => "none bounded".to_owned(),
        _ => word.to_owned(),
    };
    for (count, what) in [(grow, "grow"), (short, "too short")] {
        if count > 0 {
            told += &format!("; {count} {what}");
        }
    }
    told
}
