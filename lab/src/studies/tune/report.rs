//! The report page of a tuning.

use maud::html;

use super::picture::figure;
use super::study::{Tuned, Tuning};
use super::table::{costs, numbers, remarks, signs};
use crate::show::beside::beside;
use crate::show::csv::{self, Field};
use crate::show::html;

/// The page of a tuning of the scene called `name`, as HTML; `command` made it.
pub fn page(name: &str, tuning: &Tuning, tuned: &[Tuned], command: &str) -> String {
    let Tuning { objective, trials, runs, seed, .. } = tuning;
    let moves = tuning.moved(tuned);
    let judges = tuned.first().map_or(0, |one| one.judged[1].runs());
    let percent = |share: f64| format!("{} %", 100.0 * share);
    let scenes = tuned
        .iter()
        .map(|one| (format!("{}.toml", one.name), format!("the scene with {}, tuned", one.name)));
    let scenes: Vec<_> = scenes.collect();
    let mut files =
        vec![("tune.csv", "the numbers, default and tuned"), ("tune.json", "all numbers")];
    files.extend(scenes.iter().map(|(name, content)| (&name[..], &content[..])));
    let body = html! {
        p {
            "Objective " code { (objective.to_string()) } ", " (trials + 1) " settings of " (runs)
            " runs for each stabilizer, seed " (seed) ". Computed by " (html::maker(command)) "."
        }
        @for sign in signs(tuned).lines() { p { (sign) } }
        h2 { "Default against tuned" }
        (html::figure(Some("tune"), &figure(name, *objective, tuned), &html! {
            "Means over the runs that stay bounded; a setting under which none does has no bar."
        }))
        (costs(*objective, tuned).to_html("short"))
        @for remark in remarks(*objective, tuned) { p { (remark) } }
        p {
            "Both settings on " (judges) " runs that the search never saw. Each run moves "
            @if moves.phase > 0.0 { "the clock's phase over " (percent(moves.phase)) " of a tick, and " }
            "by up to " (percent(moves.mass)) " the masses, "
            (percent(moves.damping)) " the dampings and " (percent(moves.stiffness)) " the stiffness of the hand. \
             The change is the mean over the runs that are bounded in both, run by run."
        }
        h2 { "The numbers" }
        (numbers(tuned).to_html("short"))
        (beside(&files))
        @for one in tuned {
            h2 { "Scene with " (one.name) ", tuned" }
            pre { (one.text().unwrap_or_default()) }
        }
    };
    html::page(&format!("Tuning on {name}"), &body)
}

/// The numbers of each stabilizer, by default and tuned, as comma-separated values; an infinite number is empty.
pub fn csv(tuned: &[Tuned]) -> String {
    let rows = tuned.iter().flat_map(|one| {
        let [default, best] = &one.settings;
        default.numbers().iter().zip(best.numbers()).map(|(before, after)| {
            let values = [before.value, after.value].map(|it| Some(it).filter(|it| it.is_finite()));
            let words = [one.name.name(), before.key].map(Field::Text);
            words.into_iter().chain(values.map(Field::from)).chain([Field::Text(before.unit)])
        })
    });
    csv::text(["stabilizer", "key", "default", "tuned", "unit"], rows)
}
