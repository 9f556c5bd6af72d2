//! The tables of a tuning in the terminal.

use super::objective::{Objective, Term};
use super::study::{Tuned, Tuning};
use crate::measure::Summary;
use crate::show::table::{Cell, Heading, Table};
use crate::simulate::{Rollout, in_space};
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
        "{}{}\n{}\n{}",
        textwrap::fill(&head, 100),
        signs(tuned),
        numbers(tuned),
        costs(tuning.objective, tuned)
    )
}

/// The signs of a scene in which no force acts, a line each: there is nothing to tune for then.
pub(super) fn signs(tuned: &[Tuned]) -> String {
    let Some(Tuned { scene, .. }) = tuned.first() else { return String::new() };
    let run = in_space!(scene, Axes => Rollout::<Axes>::of(scene).map(|it| Summary::of(scene, it)));
    let idle = run.ok().filter(|run| !run.acts()).map(|run| run.look_at());
    idle.into_iter().flatten().map(|it| folded("look at: ", &it.text) + "\n").collect()
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
        }
    }
    table
}

/// The costs of both settings on the runs that tuning never saw.
pub(super) fn costs(objective: Objective, tuned: &[Tuned]) -> Table {
    let unit = match objective.unit() {
        "" => String::new(),
        unit => format!("\n{unit}"),
    };
    // A run that does not settle costs its duration, which looks like a time of settling.
    let tells_settled = objective.weight(Term::Settling) > 0.0;
    let settled = if tells_settled { &["settle,\ndefault", "settle,\ntuned"][..] } else { &[] };
    let bounded = [
        Heading::word("stabilizer"),
        Heading::number("bounded,\ndefault"),
        Heading::number("bounded,\ntuned"),
    ];
    let others = [
        Heading::number(format!("mean\ncost,\ndefault{unit}")),
        Heading::number(format!("mean\ncost,\ntuned{unit}")),
        Heading::number(format!("change with\n95 % interval{unit}")),
        Heading::word("tuned is"),
    ];
    let settled = settled.iter().map(|heading| Heading::number(*heading));
    let mut table = Table::new(bounded.into_iter().chain(settled).chain(others));
    for one in tuned {
        let bounded = one.judged.each_ref().map(|it| format!("{} of {}", it.bounded(), it.runs()));
        let [before, after] = one.judged.each_ref().map(|it| it.cost());
        let change = one.judged[1].change_from(&one.judged[0]);
        let change = change.map(|(change, half)| format!("{} +- {}", found(change), found(half)));
        let settled = one.judged.each_ref().map(|it| format!("{} of {}", it.settled(), it.runs()));
        let settled = settled.into_iter().filter(|_| tells_settled);
        let name = std::iter::once(one.name.name().into());
        let counts = bounded.into_iter().chain(settled).map(Cell::from);
        let others = [before.into(), after.into(), change.into(), word(one).into()];
        table.push(name.chain(counts).chain(others).collect::<Vec<_>>());
    }
    table
}

/// Comparison of the tuned setting, and whether it keeps every run bounded.
fn word(one: &Tuned) -> String {
    let (word, judged) = (one.change().word(), &one.judged[1]);
    match judged.runs() - judged.bounded() {
        0 => word.to_owned(),
        _ if judged.bounded() == 0 => "none bounded".to_owned(),
        grow => format!("{word}; {grow} grow"),
    }
}
