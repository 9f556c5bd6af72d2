//! Remarks on what a scene makes of its axes.

use super::axis::Axis;
use crate::files::scene::{Filter, Scene, Stabilizer};
use crate::show::described::saturated;
use crate::text::{found, given};

/// The remarks that a map or sweep of `scene` along `axes` needs.
pub(super) fn remarks(scene: &Scene, axes: &[&Axis]) -> impl Iterator<Item = String> {
    [in_ticks(scene, axes), in_counts(scene, axes), saturated(scene)].into_iter().flatten()
}

/// One count of the encoder as a velocity, where an axis changes the length of a tick.
fn in_counts(scene: &Scene, axes: &[&Axis]) -> Option<String> {
    let rate = axes.iter().find(|axis| axis.key == "servo_rate")?;
    let count = scene.plain_count()?;
    let is_one = !axes.iter().any(|axis| axis.key == "effects.encoder.resolution");
    is_one.then(|| {
        let [from, to] = [rate.from, rate.to].map(|rate| (found(1e3 * count * rate), given(rate)));
        format!(
            "one count of the encoder is a velocity of {} mm/s at {} Hz and {} mm/s at {} Hz",
            from.0, from.1, to.0, to.1
        )
    })
}

/// Numbers that count ticks, where an axis changes the length of one.
fn in_ticks(scene: &Scene, axes: &[&Axis]) -> Option<String> {
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

    fn told(effects: &str, axes: &[&str]) -> Vec<String> {
        let text = format!(
            "duration = 1\nservo_rate = 1000\ndevice.mass = 1\n{effects}\nenvironment.wall.stiffness = 1000\n"
        );
        let axes: Vec<Axis> = axes.iter().map(|axis| axis.parse().unwrap()).collect();
        let scene = Scene::parse(&text, "test").unwrap();
        remarks(&scene, &axes.iter().collect::<Vec<_>>()).collect()
    }

    const RATE: &str = "servo_rate=500..4000:8";

    #[test]
    fn a_rate_is_told_to_change_what_counts_ticks() {
        assert!(told("", &[RATE]).is_empty());
        assert!(told("effects.delay.ticks = 2", &["device.mass=1..2:2"]).is_empty());
        assert_eq!(
            told("effects.delay.ticks = 2", &["device.mass=1..2:2", RATE]),
            [
                "effects.delay.ticks counts servo ticks, and a tick lasts 2 ms at 500 Hz and 0.25 ms at 4000 Hz"
            ]
        );
        let spread = &told("stabilizer.popc-spread.ticks = 4", &[RATE])[0];
        assert!(spread.starts_with("stabilizer.popc-spread.ticks counts servo ticks"), "{spread}");
        let both = told("effects.filter.window = 4", &[RATE, "effects.delay.ticks=0..2:3"]);
        assert!(both[0].starts_with("effects.delay.ticks and effects.filter.window count "));
    }

    #[test]
    fn a_rate_is_told_to_change_the_velocity_of_a_count() {
        let encoder = "effects.encoder.resolution = 5e-5";
        assert_eq!(
            told(encoder, &[RATE]),
            ["one count of the encoder is a velocity of 25 mm/s at 500 Hz and 200 mm/s at 4000 Hz"]
        );
        assert!(told(encoder, &["device.mass=1..2:2"]).is_empty());
        assert!(told(encoder, &[RATE, "effects.encoder.resolution=1e-6..1e-3:2"]).is_empty());
        assert!(told(&format!("velocity = \"exact\"\n{encoder}"), &[RATE]).is_empty());
    }

    #[test]
    fn a_saturation_is_told_to_bound_runs() {
        let limit = told("effects.saturation.force = 8", &["device.mass=1..2:2"]);
        assert_eq!(
            limit,
            ["a saturation may bound a run that grows without it: compare the runs that settle"]
        );
    }
}
