//! Random hand, device and start.

use toml::Table;

use super::draw::Draw;
use super::drawn::{numbers, place, table};
use super::size::Size;

/// The tables of operator, device, link and start.
pub(super) fn drawn(draw: &mut Draw, size: &Size, axes: usize) -> Table {
    let share = draw.between(0.0, 1.0);
    let damping = draw.decades(-7.0, -1.0) * size.damping();
    let (operator, device) = (share * size.mass, (1.0 - 0.999 * share) * size.mass);
    let device = numbers([("mass", device), ("damping", 0.1 * damping)]);
    let mut hand = table([
        ("mass", operator.into()),
        ("damping", damping.into()),
        ("stiffness", (draw.decades(-9.0, -2.0) * size.stiffness()).into()),
        ("rest", place(axes, || draw.between(-size.length, size.length))),
    ]);
    if draw.chance(0.2) {
        hand.insert("motion".into(), motion(draw, size).into());
    }
    if draw.chance(0.15) {
        hand.insert("grip".into(), grip(draw, size).into());
    }
    let speed = 0.1 * size.length * size.rate;
    let start = table([
        ("position", place(axes, || draw.between(-3.0, 1.0) * size.length)),
        ("velocity", place(axes, || draw.between(-2.0, 2.0) * speed)),
    ]);
    let mut tables =
        table([("operator", hand.into()), ("device", device.into()), ("initial", start.into())]);
    if operator > 0.0 && draw.chance(0.2) {
        let link = numbers([
            ("stiffness", draw.decades(-3.0, 1.0) * size.stiffness()),
            ("damping", draw.decades(-4.0, 0.0) * size.damping()),
        ]);
        tables.insert("link".into(), link.into());
    }
    tables
}

/// A motion of the point of rest.
fn motion(draw: &mut Draw, size: &Size) -> Table {
    let at = draw.between(0.0, 300.0) * size.period();
    let to = draw.between(-size.length, size.length);
    match draw.below(3) {
        0 => table([("kind", "step".into()), ("at", at.into()), ("to", to.into())]),
        1 => {
            let rate = draw.decades(-3.0, 0.0) * size.length * size.rate;
            let way = numbers([("at", at), ("to", to), ("rate", rate)]);
            [("kind".to_owned(), "ramp".into())].into_iter().chain(way).collect()
        }
        _ => {
            let frequency = draw.decades(-3.0, -0.5) * size.rate;
            let swing = numbers([("amplitude", to), ("frequency", frequency)]);
            [("kind".to_owned(), "sine".into())].into_iter().chain(swing).collect()
        }
    }
}

/// Two changes of grip.
fn grip(draw: &mut Draw, size: &Size) -> Table {
    let first = draw.between(1.0, 150.0);
    let times = [first, first + draw.between(1.0, 150.0)].map(|tick| tick * size.period());
    let stiffness = [(); 2].map(|()| draw.decades(-9.0, -2.0) * size.stiffness());
    let damping = [(); 2].map(|()| draw.decades(-7.0, -1.0) * size.damping());
    let list = |numbers: [f64; 2]| numbers.map(toml::Value::from).to_vec().into();
    table([("times", list(times)), ("stiffness", list(stiffness)), ("damping", list(damping))])
}
