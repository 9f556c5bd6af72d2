//! Report page of the limits of a scene.

use maud::html;

use super::RadiusCurve;
use super::table::lines;
use crate::files::Scene;
use crate::measure::Limits;
use crate::show::beside::beside;
use crate::show::html;
use crate::show::labelled::labelled;

/// The page of the `limits` of `scene`, which is called `name`, as HTML; `command` made it.
pub fn page(
    name: &str,
    scene: &Scene,
    limits: &Limits,
    curve: Option<&RadiusCurve>,
    command: &str,
) -> String {
    let mut files = vec![("bound.json", "the numbers")];
    if curve.is_some() {
        files.push(("bound.csv", "the curve"));
    }
    let body = html! {
        p { "By " (html::maker(command)) ". These are formulas about the linear part of the scene, contact assumed; what a \
             run does is another question, which " code { "lyapunov run" } " answers." }
        (labelled(&lines(limits)))
        h2 { "How stiff the environment may be" }
        (limits.table().to_html("short"))
        @if let Some(curve) = curve {
            @let caption = html! {
                "Where the curve is below 1 the linear loop is stable. Everything but the stiffness is as in the scene."
            };
            (html::figure(Some("bound"), &curve.figure(name), &caption))
        }
        @if !limits.notes.is_empty() {
            h2 { "Notes" }
            ul { @for note in &limits.notes { li { (note) } } }
        }
        (beside(&files))
        h2 { "Scene" }
        pre { (toml::to_string(scene).unwrap_or_default()) }
    };
    html::page(&format!("Limits of {name}"), &body)
}
