//! Remark on what a scene counts in servo ticks.

use super::axis::Axis;
use crate::files::scene::{Filter, Scene, Stabilizer};
use crate::text::given;

/// The remark for a map or sweep of `scene` along `axes`; none where no axis changes the length of a tick, or nothing is
/// counted in ticks.
pub(super) fn note(scene: &Scene, axes: &[&Axis]) -> Option<String> {
    let rate = axes.iter().find(|axis| axis.key == "servo_rate")?;
    let varied = |key: &str| axes.iter().any(|axis| axis.key == key);
    let counted = [
        ("effects.delay.ticks", scene.delay_ticks() > 0),
        ("effects.filter.window", matches!(scene.effects.filter, Some(Filter::Window(_)))),
        (
            "stabilizer.popc-spread.ticks",
            matches!(scene.stabilizer, Some(Stabilizer::PopcSpread(_))),
        ),
        (
            "stabilizer.popc-rising.ticks",
            matches!(scene.stabilizer, Some(Stabilizer::PopcRising(_))),
        ),
    ];
    let keys = counted.iter().filter(|(key, counts)| *counts || varied(key));
    let keys: Vec<&str> = keys.map(|(key, _)| *key).collect();
    let [from, to] = [rate.from, rate.to].map(|rate| (given(1e3 / rate), given(rate)));
    let counts = if keys.len() == 1 { "counts" } else { "count" };
    (!keys.is_empty()).then(|| {
        format!(
            "{} {counts} servo ticks, and a tick lasts {} ms at {} Hz and {} ms at {} Hz",
            keys.join(" and "),
            from.0,
            from.1,
            to.0,
            to.1
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(effects: &str, axes: &[&str]) -> Option<String> {
        let text = format!(
            "duration = 1\nservo_rate = 1000\ndevice.mass = 1\n{effects}\nenvironment.wall.stiffness = 1000\n"
        );
        let axes: Vec<Axis> = axes.iter().map(|axis| axis.parse().unwrap()).collect();
        note(&Scene::parse(&text, "test").unwrap(), &axes.iter().collect::<Vec<_>>())
    }

    #[test]
    fn a_rate_is_told_to_change_what_counts_ticks() {
        let rate = "servo_rate=500..4000:8";
        assert_eq!(told("", &[rate]), None);
        assert_eq!(told("effects.delay.ticks = 2", &["device.mass=1..2:2"]), None);
        assert_eq!(
            told("effects.delay.ticks = 2", &["device.mass=1..2:2", rate]).unwrap(),
            "effects.delay.ticks counts servo ticks, and a tick lasts 2 ms at 500 Hz and 0.25 ms at 4000 Hz"
        );
        let spread = told("stabilizer.popc-spread.ticks = 4", &[rate]).unwrap();
        assert!(spread.starts_with("stabilizer.popc-spread.ticks counts servo ticks"), "{spread}");
        let both = told("effects.filter.window = 4", &[rate, "effects.delay.ticks=0..2:3"]);
        assert!(both.unwrap().starts_with("effects.delay.ticks and effects.filter.window count "));
    }
}
