//! Random effects.

use toml::Table;

use super::draw::Draw;
use super::drawn::{numbers, table};
use super::size::Size;

/// Probability of an effect.
const RARELY: f64 = 0.2;

/// Any of the effects; a scene may reject those that do not go together.
pub(super) fn drawn(draw: &mut Draw, size: &Size) -> Table {
    let seed = i64::from(draw.below(u32::MAX));
    let seeded = |key: &str, number: f64| table([(key, number.into()), ("seed", seed.into())]);
    let mut effects = Table::new();
    let mut put = |name: &str, keys: Table| drop(effects.insert(name.to_owned(), keys.into()));
    if draw.chance(RARELY) {
        put("encoder", numbers([("resolution", draw.decades(-6.0, 0.0) * size.length)]));
    }
    if draw.chance(RARELY) {
        put("delay", table([("ticks", i64::from(draw.below(6)).into())]));
    }
    if draw.chance(RARELY) {
        put("saturation", numbers([("force", draw.decades(-4.0, 1.0) * size.force())]));
    }
    if draw.chance(RARELY) {
        put(
            "filter",
            match draw.chance(0.5) {
                true => numbers([("cutoff", draw.decades(-2.0, 0.0) * size.rate)]),
                false => table([("window", i64::from(1 + draw.below(20)).into())]),
            },
        );
    }
    if draw.chance(RARELY) {
        put("noise", seeded("deviation", draw.decades(-7.0, -2.0) * size.length));
    }
    if draw.chance(RARELY) {
        put("jitter", seeded("deviation", draw.decades(-4.0, -0.5) * size.period()));
    }
    if draw.chance(RARELY) {
        let mut lost = seeded("probability", draw.between(0.0, 0.9));
        lost.insert("policy".into(), draw.pick(&["hold", "zero"]).into());
        put("dropout", lost);
    }
    if draw.chance(RARELY) {
        let (coulomb, more) = (draw.decades(-5.0, -1.0), draw.decades(-5.0, -1.0));
        let speed = draw.decades(-3.0, 0.0) * size.length * size.rate;
        let [coulomb, breakaway] = [coulomb, coulomb + more].map(|share| share * size.force());
        put(
            "friction",
            numbers([("coulomb", coulomb), ("static", breakaway), ("stribeck_velocity", speed)]),
        );
    }
    if draw.chance(0.5 * RARELY) {
        put("load", numbers([("force", draw.between(-0.1, 0.1) * size.force())]));
    }
    if draw.chance(0.5 * RARELY) {
        let [start, duration] = [(); 2].map(|()| draw.between(0.0, 200.0) * size.period());
        let force = draw.between(-1.0, 1.0) * size.force();
        put("pulse", numbers([("start", start), ("duration", duration), ("force", force)]));
    }
    effects
}
