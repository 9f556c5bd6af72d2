//! Random scene of a case.

use toml::{Table, Value};

use super::draw::Draw;
use super::size::Size;
use super::{effects, environment, hand};
use crate::files::Scene;
use crate::files::scene::{
    Candidate, Cap, Ledger, Lolc, Parameter, Popc, Spacing, Stabilizer, Work,
};
use crate::simulate::family::{BasicName, StabilizerName};

/// Ticks of a scene.
const TICKS: f64 = 400.0;

/// Draws for one scene, some of which break a rule between their values.
const ATTEMPTS: u32 = 64;

/// The scene of a case under one of `members`: a function of the draw alone. None if no draw fits.
pub(super) fn scene(mut draw: Draw, members: &[StabilizerName]) -> Option<Scene> {
    (0..ATTEMPTS).find_map(|_| {
        let scene = looped(&mut draw)?;
        let member = draw.pick(members);
        stabilized(&mut draw, &scene, member)
    })
}

/// A table with these keys.
pub(super) fn table<const N: usize>(keys: [(&str, Value); N]) -> Table {
    keys.into_iter().map(|(key, value)| (key.to_owned(), value)).collect()
}

/// A table of numbers with these keys.
pub(super) fn numbers<const N: usize>(keys: [(&str, f64); N]) -> Table {
    table(keys.map(|(key, number)| (key, number.into())))
}

/// A table with one table in it.
pub(super) fn only(key: &str, inner: Table) -> Table {
    table([(key, inner.into())])
}

/// A coordinate on each of `axes` axes; on a line a number.
pub(super) fn place(axes: usize, mut coordinate: impl FnMut() -> f64) -> Value {
    match axes {
        1 => coordinate().into(),
        several => (0..several).map(|_| Value::from(coordinate())).collect::<Vec<_>>().into(),
    }
}

/// A loop without a stabilizer.
fn looped(draw: &mut Draw) -> Option<Scene> {
    let size = Size::drawn(draw);
    let axes = draw.pick(&[1, 1, 1, 1, 1, 2, 3]);
    let mut scene = table([
        ("duration", (TICKS / size.rate).into()),
        ("servo_rate", size.rate.into()),
        ("environment", environment::drawn(draw, &size, axes).into()),
    ]);
    if draw.chance(0.2) {
        scene.insert("environment_rate".into(), (size.rate / f64::from(2 + draw.below(5))).into());
    }
    if draw.chance(0.3) {
        scene.insert("velocity".into(), "exact".into());
    }
    if draw.chance(0.1) {
        let method = draw.pick(&["semi-implicit-euler", "implicit-midpoint", "rk4"]);
        scene.insert("integrator".into(), method.into());
        scene.insert("steps_per_tick".into(), i64::from(1 + draw.below(8)).into());
    }
    if axes > 1 {
        scene.insert("space".into(), table([("dimensions", (axes as i64).into())]).into());
    }
    scene.extend(hand::drawn(draw, &size, axes));
    scene.insert("effects".into(), effects::drawn(draw, &size).into());
    Scene::parse(&toml::to_string(&scene).ok()?, "a random scene").ok()
}

/// The same loop under `member`, some of whose numbers are drawn; none if it takes no part.
fn stabilized(draw: &mut Draw, scene: &Scene, member: StabilizerName) -> Option<Scene> {
    if let StabilizerName::Basic(basic) = member {
        return observed(draw, scene, basic);
    }
    if !member.fits(scene) {
        return None;
    }
    let numbers: Vec<_> = member
        .parameters(scene)
        .iter()
        .filter_map(|it| Some((it.name(), number(draw, it)?)))
        .collect();
    let written = member.written_in(scene, &numbers);
    written.or_else(|_| member.written_in(scene, &[])).ok()
}

/// A number from the range in which it is searched for; mostly none.
fn number(draw: &mut Draw, parameter: &Parameter) -> Option<f64> {
    let search = parameter.search.filter(|_| draw.chance(0.4))?;
    let number = match search.spacing {
        Spacing::Linear => draw.between(search.lower, search.upper),
        Spacing::Logarithmic => draw.decades(libm::log10(search.lower), libm::log10(search.upper)),
    };
    Some(if parameter.is_whole { number.round() } else { number })
}

/// The same loop under POPC or LOLC.
fn observed(draw: &mut Draw, scene: &Scene, basic: BasicName) -> Option<Scene> {
    let work = draw.pick(&[Work::Held, Work::Held, Work::Sampled]);
    let ledger = draw.pick(&[Ledger::Plain, Ledger::Plain, Ledger::Compensated, Ledger::Wide]);
    let share = draw.between(0.0, 2.0);
    let cap =
        draw.pick(&[None, Some(0.0), Some(0.5), Some(share), Some(share), Some(f64::INFINITY)]);
    let damping_cap = cap.and_then(|cap| Cap::new(cap).ok());
    let candidate = match basic {
        BasicName::NoStabilizer => return None,
        BasicName::Popc => None,
        BasicName::LolcSpring => Some(Candidate::Spring),
        BasicName::LolcDeviceDamping => Some(Candidate::DeviceDamping),
        BasicName::Lolc | BasicName::LolcMassSpringDamper => Some(Candidate::MassSpringDamper),
    };
    let mut draft = scene.to_draft();
    draft.stabilizer = Some(match candidate {
        None => Stabilizer::Popc(Popc { work, ledger, damping_cap }),
        Some(candidate) => Stabilizer::Lolc(Lolc { work, candidate, ledger, damping_cap }),
    });
    draft.check().ok()
}
