//! Report pages, each one self-contained file.

use lyapunov_figures::Figure;
use maud::{DOCTYPE, Markup, PreEscaped, html};

const STYLE: &str = include_str!("html.css");

/// What a page may load: nothing that is not in it.
const POLICY: &str =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";

const DATA: &str = include_str!("page/data.js");
const TABLES: &str = include_str!("page/tables.js");
const CURVES: [&str; 2] = [include_str!("page/curves.js"), include_str!("page/plots.js")];
const CELLS: &str = include_str!("page/cells.js");

/// The plotting library, with its style and its licence.
const UPLOT: &str = include_str!("uplot/uPlot.iife.min.js");
const UPLOT_STYLE: &str = include_str!("uplot/uPlot.min.css");
const UPLOT_LICENSE: &str = include_str!("uplot/LICENSE");

/// A page with `title` as its heading.
pub(crate) fn page(title: &str, body: &Markup) -> String {
    // Names are escaped, so only `figure` writes these.
    let [has_curves, has_cells] =
        ["<figure class=\"curves\"", "<figure class=\"cells\""].map(|it| body.0.contains(it));
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (title) }
                @if has_curves { style { (PreEscaped(UPLOT_STYLE)) } }
                style { (PreEscaped(STYLE)) }
            }
            body {
                h1 { (title) }
                (body)
                (script(&[DATA, TABLES]))
                @if has_curves {
                    (script(&["/* uPlot\n", UPLOT_LICENSE, "\n*/\n", UPLOT]))
                    (script(&CURVES))
                }
                @if has_cells { (script(&[CELLS])) }
            }
        }
    };
    page.into_string() + "\n"
}

fn script(parts: &[&str]) -> Markup {
    html! { script { (PreEscaped(parts.concat())) } }
}

/// The command that made something, and its version.
pub(crate) fn maker(command: &str) -> Markup {
    html! { code { (command) } ", lyapunov " (env!("CARGO_PKG_VERSION")) }
}

/// A text in which what stands between backticks is code.
pub(crate) fn coded(text: &str) -> Markup {
    html! {
        @for (index, part) in text.split('`').enumerate() {
            @if index % 2 == 1 { code { (part) } } @else { (part) }
        }
    }
}

/// A figure with a caption: drawn as SVG, with its data for curves that can be zoomed or cells that tell their numbers.
pub(crate) fn figure(id: Option<&str>, figure: &Figure, caption: &Markup) -> Markup {
    let has_cells = figure.panels.iter().any(|panel| panel.heat.is_some());
    html! {
        figure class=(if has_cells { "cells" } else { "curves" }) id=[id] {
            div.wide { (PreEscaped(figure.to_svg())) }
            script.data type="text/plain" { (figure.to_data()) }
            figcaption { (caption) }
        }
    }
}

/// Values for the script of the page, by the name of their element.
pub(crate) fn values(id: &str, values: &serde_json::Value) -> Markup {
    // No text can end the element.
    let json = values.to_string().replace('<', "\\u003c");
    html! { script id=(id) type="application/json" { (PreEscaped(json)) } }
}

/// A verdict in the colour of its `class`: `yes`, `no` or `open`.
pub(crate) fn verdict(class: &str, word: &str) -> Markup {
    html! { span class=(class) { (word) } }
}

#[cfg(test)]
mod tests {
    use super::*;
    use lyapunov_figures::{HeatMap, Panel, Series};

    const HOSTILE: &str = "</script><script>alert(1)</script><figure class=\"curves\">";

    fn drawn(panel: Panel) -> String {
        let caption = html! { (HOSTILE) };
        page(HOSTILE, &figure(Some(HOSTILE), &Figure::new(HOSTILE).with_panel(panel), &caption))
    }

    #[test]
    fn the_library_is_in_pages_with_curves_and_only_there() {
        let panel = || Panel::new(HOSTILE, HOSTILE, HOSTILE);
        let curves = drawn(panel().with_series(Series::line(HOSTILE, 0, vec![(0.0, 1.0)])));
        assert!(
            curves.contains("var uPlot=") && curves.contains("Copyright (c) 2022 Leon Sorokin")
        );
        let cells = drawn(panel().with_heat(HeatMap::new(1, vec![1.0])));
        assert!(!cells.contains("var uPlot=") && cells.contains("class Cells"));
        let words = page(HOSTILE, &html! { p { (HOSTILE) } });
        assert!(!words.contains("var uPlot=") && !words.contains("class Cells"));
    }

    #[test]
    fn what_stands_between_backticks_is_code() {
        let told = coded("`lyapunov explain` says <why>").into_string();
        assert_eq!(told, "<code>lyapunov explain</code> says &lt;why&gt;");
    }

    #[test]
    fn no_name_becomes_a_script() {
        let panel = Panel::new(HOSTILE, HOSTILE, HOSTILE).with_series(Series::line(
            HOSTILE,
            0,
            vec![(0.0, 1.0)],
        ));
        let named = values("axes", &serde_json::json!({ "command": HOSTILE })).into_string();
        for text in [drawn(panel), named] {
            assert!(!text.contains("<script>alert"), "{text}");
        }
    }
}
