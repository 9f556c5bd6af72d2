//! The report page of a tuning.

use maud::html;

use super::study::{Tuned, Tuning};
use super::table::{costs, numbers};
use crate::show::html;

/// The page of a tuning of the scene called `name`, as HTML.
pub fn page(name: &str, tuning: &Tuning, tuned: &[Tuned]) -> String {
    let Tuning { objective, trials, runs, seed, moves } = tuning;
    let judges = tuned.first().map_or(0, |one| one.judged[1].runs());
    let percent = |share: f64| format!("{} %", 100.0 * share);
    let body = html! {
        p {
            "Objective " code { (objective.to_string()) } ", " (trials + 1) " settings of " (runs)
            " runs for each stabilizer, seed " (seed) ". Computed by " (html::maker("lyapunov tune")) "."
        }
        h2 { "Default against tuned" }
        (costs(*objective, tuned).to_html("short"))
        p {
            "Both settings on " (judges) " runs that the search never saw. Each run moves the clock's phase over "
            (percent(moves.phase)) " of a tick, and by up to " (percent(moves.mass)) " the masses, "
            (percent(moves.damping)) " the dampings and " (percent(moves.stiffness)) " the stiffness of the hand. \
             The change is the mean over the runs that are bounded in both, run by run."
        }
        h2 { "The numbers" }
        (numbers(tuned).to_html("short"))
        @for one in tuned {
            h2 { "Scene with " (one.name) ", tuned" }
            pre { (one.text().unwrap_or_default()) }
        }
    };
    html::page(&format!("Tuning on {name}"), &body)
}
