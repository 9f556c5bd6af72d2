//! Random environment.

use toml::Table;

use super::draw::Draw;
use super::drawn::{numbers, only, place, table};
use super::size::Size;

/// An environment for as many axes.
pub(super) fn drawn(draw: &mut Draw, size: &Size, axes: usize) -> Table {
    let stiffness = draw.decades(-4.0, 1.5) * size.stiffness();
    let damping = if draw.chance(0.5) { draw.decades(-4.0, 0.3) * size.damping() } else { 0.0 };
    let matter = numbers([("stiffness", stiffness), ("damping", damping)]);
    let (name, mut keys) = match axes {
        1 => on_a_line(draw, size, matter),
        several => in_space(draw, size, several, matter),
    };
    if axes == 1 {
        keys.insert("position".into(), draw.between(-0.1 * size.length, 0.1 * size.length).into());
    }
    only(name, keys)
}

/// The environment of one axis, half of the time a wall, without its position; `matter` has a stiffness and a damping.
fn on_a_line(draw: &mut Draw, size: &Size, matter: Table) -> (&'static str, Table) {
    let stiffness = matter["stiffness"].clone();
    let share = draw.between(0.0, 1.0);
    let (length, most) = (size.length, stiffness.as_float().unwrap_or(0.0));
    let rate = draw.decades(-3.0, -0.5) * size.rate;
    let swing = numbers([("amplitude", share * length), ("frequency", rate)]);
    let with = |more: Table| matter.clone().into_iter().chain(more).collect::<Table>();
    match draw.below(14) {
        0 => ("spring", numbers([("stiffness", most * draw.pick(&[1.0, 1.0, -0.01]))])),
        1 => ("mass-spring-damper", with(numbers([("mass", 0.3 * share * size.mass)]))),
        2 => {
            let layers = vec![stiffness, (most * draw.decades(-1.0, 1.0)).into()];
            let layers = table([("depth", (share * length).into()), ("stiffness", layers.into())]);
            ("layered-wall", with(layers))
        }
        3 => {
            let exponent = draw.between(0.7, 2.5);
            let damping = draw.decades(-2.0, 1.0) / (length * size.rate);
            let stiffness = most * libm::pow(length, 1.0 - exponent);
            let keys = [("stiffness", stiffness), ("exponent", exponent), ("damping", damping)];
            ("hunt-crossley", numbers(keys))
        }
        4 => ("moving-wall", with(swing)),
        5 => {
            let swing = numbers([("amplitude", share * most), ("frequency", rate)]);
            ("varying-spring", table([("stiffness", stiffness)]).into_iter().chain(swing).collect())
        }
        6 => {
            let cubic = share * most / (length * length);
            ("cubic-spring", table([("stiffness", stiffness), ("cubic", cubic.into())]))
        }
        _ => ("wall", matter),
    }
}

/// A solid in several axes.
fn in_space(draw: &mut Draw, size: &Size, axes: usize, matter: Table) -> (&'static str, Table) {
    let around = |draw: &mut Draw| place(axes, || draw.between(-size.length, size.length));
    let (name, keys) = match draw.below(3) {
        0 => {
            let normal = place(axes, || draw.between(-1.0, 1.0));
            ("plane", table([("point", around(draw)), ("normal", normal)]))
        }
        1 => {
            let radius = draw.between(0.1, 2.0) * size.length;
            ("sphere", table([("center", around(draw)), ("radius", radius.into())]))
        }
        _ => {
            let half = place(axes, || draw.between(0.1, 2.0) * size.length);
            ("box", table([("center", around(draw)), ("half", half)]))
        }
    };
    (name, matter.into_iter().chain(keys).collect())
}
