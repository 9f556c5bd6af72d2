//! Places of texts and of magnified parts.

use resvg::usvg::{Group, Node, Rect, Text};

use super::gallery::{gallery, noise, sampled, wordy};
use super::read;
use crate::axes::Axes;
use crate::magnifier::arrange;
use crate::*;

/// The gallery, a figure that is mostly text, and one whose rows have longer names than its numbers have digits.
pub(super) fn figures() -> impl Iterator<Item = (&'static str, Figure)> {
    let rows = vec!["gaps".to_owned(), "rows that nobody reads".to_owned()];
    let curve = sampled(100, 1.0, |_, time| time * time);
    let named = Figure::new("rows below numbers")
        .with_panel(Panel::new("numbers", "time, s", "x").with_series(Series::line("", 0, curve)))
        .with_panel(Panel::new("rows", "time, s", "").with_rows(rows));
    gallery().into_iter().chain([("wordy", wordy()), ("rows", named)])
}

/// Every text of a drawing and the box around it.
fn texts(group: &Group) -> Vec<(String, Rect)> {
    let of = |node: &Node| match node {
        Node::Group(group) => texts(group),
        Node::Text(text) => {
            let chunks = text.chunks().iter().map(|chunk| chunk.text());
            vec![(chunks.collect::<String>(), ink(text))]
        }
        _ => Vec::new(),
    };
    group.children().iter().flat_map(of).collect()
}

/// The box of a text without the height above and below its letters, which a line leaves.
fn ink(text: &Text) -> Rect {
    let (line, transform) = (text.abs_bounding_box(), text.abs_transform());
    let is_upright = transform.kx.abs() > transform.sx.abs();
    let [across, along] = if is_upright { [0.18, 0.0] } else { [0.0, 0.18] };
    let (width, height) = (across * line.width(), along * line.height());
    Rect::from_ltrb(
        line.left() + width,
        line.top() + height,
        line.right() - width,
        line.bottom() - height,
    )
    .unwrap()
}

/// Whether two boxes have more in common than an edge.
fn overlap(one: &Rect, other: &Rect) -> bool {
    let common = |a: [f32; 2], b: [f32; 2]| a[1].min(b[1]) - a[0].max(b[0]);
    let across = common([one.left(), one.right()], [other.left(), other.right()]);
    let along = common([one.top(), one.bottom()], [other.top(), other.bottom()]);
    across.min(along) > 0.5
}

#[test]
fn no_text_touches_another_or_leaves_the_page() {
    for (name, figure) in figures() {
        let tree = read(&figure.to_svg());
        let texts = texts(tree.root());
        let page = tree.size();
        assert!(texts.len() > 5, "{name}");
        for (index, (text, place)) in texts.iter().enumerate() {
            let is_within = place.left() >= 0.0
                && place.top() >= 0.0
                && place.right() <= page.width()
                && place.bottom() <= page.height();
            assert!(is_within, "{name}: {text} at {place:?}");
            for (other, at) in &texts[..index] {
                assert!(!overlap(place, at), "{name}: {text} at {place:?}, {other} at {at:?}");
            }
        }
    }
}

/// A part that would hide curves stands beside the frame where there is room, and inside it where there is none or where
/// it is asked for.
#[test]
fn a_magnified_part_hides_curves_only_where_it_must() {
    let crowded = sampled(20_000, 2.0, |index, time| (200.0 * time).sin() + noise(index));
    let panel = |inset: Inset| {
        Panel::new("", "", "").with_series(Series::line("", 0, crowded.clone())).with_inset(inset)
    };
    let inset = Inset::over(1.0, 1.1);
    for (inset, width, stands_beside) in [
        (inset, 500.0, true),
        (inset, 150.0, false),
        (inset.placed(Placement::Inside), 500.0, false),
        (inset.placed(Placement::Beside), 500.0, true),
        (inset.placed(Placement::Beside), 150.0, false),
    ] {
        let whole = Axes {
            area: geometry::Rect::new(40.0, 10.0, width, 200.0),
            x: span::Span { low: 0.0, high: 2.0 },
            y: span::Span { low: -2.0, high: 2.0 },
        };
        let (main, magnifier) = arrange(&panel(inset), whole);
        let outer = magnifier.expect("a magnified part").outer;
        assert_eq!(outer.left >= main.area.right(), stands_beside, "{inset:?} {width}");
        assert!(outer.right() <= whole.area.right() && outer.left >= whole.area.left);
    }
}

/// Drawings that stay. A hash says that something changed, not that it is right: look at `pictures_to_look_at` before it is
/// written anew.
#[test]
fn drawings_are_as_they_were() {
    let hash = |text: &str| {
        let next = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01B3);
        text.bytes().fold(0xCBF2_9CE4_8422_2325, next)
    };
    let found = figures().map(|(name, figure)| format!("{name} {:016x}", hash(&figure.to_svg())));
    assert_eq!(
        found.collect::<Vec<_>>(),
        [
            "swings 4b284d98d8b90b85",
            "four c7f032eff52e3f1f",
            "hostile 13a4651cdc596f37",
            "crowded 3e0dbf9e1dfcaca3",
            "fields 574170df90860793",
            "wordy e1ba528a4882f431",
            "rows d36b9669cdb83f2b",
        ]
    );
}
