//! Guides on the page, with labels that cover as little as possible.

use super::axes::Axes;
use super::curve::Curve;
use super::drawing::{Anchor, Drawing, Lettering};
use super::geometry::{Place, Rect};
use super::guide::{Direction, Guide};
use super::palette::{FAINT_INK, Stroke};
use super::text::{self, Weight};

const SIZE: f64 = 10.5;
const DESCENT: f64 = 3.0;
const HEIGHT: f64 = SIZE + DESCENT;

pub(super) fn draw_lines(drawing: &mut Drawing, guides: &[Guide], axes: &Axes) {
    for line in guides.iter().filter_map(|guide| line(guide, axes)) {
        drawing.lines(&[line], Stroke::dashed(FAINT_INK, 0.9));
    }
}

/// Writes the labels where they cover least of the curves, of other guides and of the areas already `taken`.
pub(super) fn draw_labels(
    drawing: &mut Drawing,
    guides: &[Guide],
    axes: &Axes,
    curves: &[Curve],
    mut taken: Vec<Rect>,
) {
    for (index, guide) in guides.iter().enumerate() {
        let Some(line) = line(guide, axes).filter(|_| !guide.label.trim().is_empty()) else {
            continue;
        };
        let label = text::fitted(&guide.label, SIZE, Weight::Regular, axes.area.width - 12.0);
        let width = text::width(&label, SIZE, Weight::Regular);
        let others: Vec<(Place, Place)> = guides
            .iter()
            .enumerate()
            .filter(|(other, _)| *other != index)
            .filter_map(|(_, guide)| self::line(guide, axes))
            .collect();
        let cost = |site: &Site| {
            let hidden: usize = curves.iter().map(|curve| curve.pieces_within(&site.area)).sum();
            let crossed = others.iter().filter(|(from, to)| site.area.cut(*from, *to).is_some());
            let overlaps = taken.iter().filter(|other| other.overlaps(&site.area));
            hidden + 3 * crossed.count() + 1000 * overlaps.count()
        };
        let best = sites(guide.direction, line, axes.area, width).into_iter().min_by_key(cost);
        if let Some(site) = best {
            site.draw(drawing, &label);
            taken.push(site.area);
        }
    }
}

/// Place for a label.
#[derive(Debug, Clone, Copy)]
struct Site {
    area: Rect,
    /// The label reads from bottom to top.
    upright: bool,
}

impl Site {
    fn draw(&self, drawing: &mut Drawing, label: &str) {
        let area = self.area;
        let lettering = Lettering {
            halo: true,
            upright: self.upright,
            ..Lettering::new(SIZE, FAINT_INK, Anchor::Start)
        };
        let place = if self.upright {
            (area.right() - DESCENT, area.bottom())
        } else {
            (area.left, area.bottom() - DESCENT)
        };
        drawing.text(place, lettering, label);
    }
}

fn line(guide: &Guide, axes: &Axes) -> Option<(Place, Place)> {
    let area = axes.area;
    match guide.direction {
        Direction::Horizontal if axes.y.contains(guide.at) => {
            let (_, y) = axes.place((axes.x.low, guide.at));
            Some(((area.left, y), (area.right(), y)))
        }
        Direction::Vertical if axes.x.contains(guide.at) => {
            let (x, _) = axes.place((guide.at, axes.y.low));
            Some(((x, area.bottom()), (x, area.top)))
        }
        _ => None,
    }
}

/// Places for a label beside its line, the preferred ones first. Where curves fill the frame, the
/// label of a horizontal line stands outside, at the line's end; where vertical lines stand close, a label stands upright.
fn sites(direction: Direction, line: (Place, Place), frame: Rect, width: f64) -> Vec<Site> {
    const ALONG: [f64; 7] = [1.0, 0.0, 0.5, 0.75, 0.25, 0.875, 0.125];
    const APART: [f64; 3] = [2.0, 7.0, 12.0];
    let inner = frame.grown(-5.0);
    let (x, y) = line.0;
    let mut sites: Vec<Site> = Vec::new();
    for apart in APART {
        for share in ALONG {
            let corners = match direction {
                Direction::Horizontal => {
                    let left = inner.left + share * (inner.width - width);
                    [(left, y - apart - HEIGHT), (left, y + apart)]
                }
                Direction::Vertical => {
                    let top = inner.top + (1.0 - share) * (inner.height - HEIGHT);
                    [(x + apart + 2.0, top), (x - apart - 2.0 - width, top)]
                }
            };
            let areas = corners.map(|(left, top)| Rect::new(left, top, width, HEIGHT));
            sites.extend(areas.map(|area| Site { area, upright: false }));
        }
    }
    sites.retain(|Site { area, .. }| {
        frame.contains((area.left, area.top)) && frame.contains((area.right(), area.bottom()))
    });
    if direction == Direction::Horizontal && width <= frame.height {
        let top = (y - 0.5 * width).min(frame.bottom() - width).max(frame.top);
        let area = Rect::new(frame.right() + 2.0, top, HEIGHT, width);
        sites.push(Site { area, upright: true });
    }
    if direction == Direction::Vertical && width <= inner.height {
        let lefts = [x + 2.0, x - 2.0 - HEIGHT];
        let areas = lefts.map(|left| Rect::new(left, inner.top, HEIGHT, width));
        sites.extend(areas.map(|area| Site { area, upright: true }));
    }
    sites
}
