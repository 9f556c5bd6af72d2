//! Stiffness limits of a scene.

use lyapunov::bodies::Impedance;

use super::{LinearPart, NotLinear, rules};
use crate::files::scene::{Filter, Integrator, Scene, Velocity};
use crate::text::{found, given};

/// The largest stiffness of a scene's environment by each formula, N/m; its `Display` is the table of `lyapunov bound`.
///
/// A limit is 0 where no stiffness from 0 on passes, and none where the formula does not apply. All are about the
/// scene's own [linear part](LinearPart), with everything but the stiffness as in the scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Limits {
    /// The scene's own stiffness, if its environment has one.
    pub stiffness: Option<f64>,
    /// For any passive operator: [`LinearPart::passive_max_stiffness`].
    pub passive: Option<f64>,
    /// By Gil's rule, `(b + B) / (T / 2 + t_d)`, with `b` of device and operator.
    pub gil: Option<f64>,
    /// By Abbott and Okamura, `min(2 b / T, 2 f_c / Δ)`, where the scene has friction and an encoder.
    pub friction_quantization: Option<f64>,
    /// Of the loop itself: the upper end of [`LinearPart::stable_stiffness`].
    pub exact: Option<f64>,
    /// The stiffness from which the loop itself is stable, 0 except for a loop that needs one.
    pub exact_from: Option<f64>,
    /// [`LinearPart::spectral_radius`] at the scene's own stiffness.
    pub spectral_radius: Option<f64>,
    /// Remarks that the numbers need.
    pub notes: Vec<String>,
}

impl Limits {
    /// The limits of `scene`.
    pub fn of(scene: &Scene) -> Self {
        let part = LinearPart::of(scene);
        let finite = |value: Option<f64>| value.filter(|value| value.is_finite());
        let sound = part.as_ref().ok();
        let spectral_radius = finite(sound.map(LinearPart::spectral_radius));
        // A limit does not depend on the scene's own stiffness, which may be out of range by itself.
        let soft = |part: &LinearPart| {
            let environment = Impedance { stiffness: 0.0, ..part.environment };
            LinearPart { environment, ..*part }.spectral_radius()
        };
        let within = sound.filter(|part| soft(part).is_finite());
        let range = within.map(|part| part.stable_stiffness().unwrap_or([0.0, 0.0]));
        let passive = finite(within.map(LinearPart::passive_max_stiffness));
        let mut notes = notes(scene, part, range, passive);
        if spectral_radius.is_none() && part.is_ok() {
            notes.push("the loop is out of the range of the numbers".to_owned());
        }
        Self {
            stiffness: scene.environment.kind().impedance().map(|it| it.stiffness),
            passive,
            gil: finite(rules::gil(scene)),
            friction_quantization: finite(rules::friction_quantization(scene)),
            exact: finite(range.map(|[_, end]| end)),
            exact_from: range.map(|[start, _]| start),
            spectral_radius,
            notes,
        }
    }

    /// The limits by name, with the key of each in JSON.
    pub fn named(&self) -> [(&'static str, &'static str, Option<f64>); 4] {
        [
            ("passive_max_stiffness", "passive, any operator", self.passive),
            ("gil_max_stiffness", "Gil's rule", self.gil),
            (
                "friction_quantization_max_stiffness",
                "friction and encoder",
                self.friction_quantization,
            ),
            ("exact_max_stiffness", "linear loop stable, this operator", self.exact),
        ]
    }
}

fn notes(
    scene: &Scene,
    part: Result<LinearPart, NotLinear>,
    range: Option<[f64; 2]>,
    passive: Option<f64>,
) -> Vec<String> {
    let effects = &scene.effects;
    let mut notes = Vec::new();
    let mut note = |holds: bool, text: &str| {
        if holds {
            notes.push(text.to_owned());
        }
    };
    if let Err(reason) = part {
        note(true, &format!("passive and exact limit do not apply: {reason}"));
    }
    let uses_velocity = part.is_ok_and(|part| part.needs_velocity());
    note(
        uses_velocity && scene.velocity == Velocity::Exact,
        "no stiffness is passive with an exact velocity: a sample of it costs no energy",
    );
    if passive == Some(0.0) && scene.velocity != Velocity::Exact {
        damping_note(scene, part).into_iter().for_each(|text| note(true, &text));
    }
    note(
        range == Some([0.0, 0.0]),
        "no stiffness makes the linear loop stable: it does not decay for any above 0",
    );
    note(
        range.is_some_and(|[_, end]| end.is_infinite()),
        "the exact limit is none: the linear loop is stable for all",
    );
    friction_notes(scene).into_iter().for_each(|text| note(true, text));
    let kind = scene.environment.kind();
    let left_out = kind.impedance_note();
    left_out.into_iter().for_each(|text| note(true, text));
    note(scene.dimensions() > 1, "along the normal of the surface, as if it were flat");
    note(
        effects.dropout.is_some_and(|it| it.probability.get() > 0.0),
        "Gil's rule knows nothing of lost answers",
    );
    note(
        effects.filter.is_some_and(|it| !matches!(it, Filter::Window(ticks) if ticks.get() == 1)),
        "Gil's rule knows nothing of the filter",
    );
    note(
        kind.impedance().is_some_and(|it| it.mass > 0.0),
        "Gil's rule knows nothing of the environment's mass",
    );
    note(
        scene.link.is_some(),
        "Gil's rule knows nothing of the link: it takes hand and device as one mass",
    );
    note(
        scene.integrator != Integrator::Exact,
        "the limits are those of the exact motion: the scene's integrator adds its own error",
    );
    note(effects.jitter.is_some(), "the period is the nominal one, without jitter");
    note(scene.operator.grip.is_some(), "the grip is the one at the start");
    note(scene.stabilizer.is_some(), "the limits are those of the loop without its stabilizer");
    notes
}

/// The reason why no stiffness is passive: sampled damping and mass have to be paid by the device's own damping, and so has any
/// spring.
fn damping_note(scene: &Scene, part: Result<LinearPart, NotLinear>) -> Option<String> {
    let part = part.ok()?;
    let LinearPart { environment, device, .. } = part;
    let alone = LinearPart { environment: Impedance { stiffness: 0.0, ..environment }, ..part };
    let (needed, own) = (alone.passive_damping(), given(device.damping));
    if needed == 0.0 {
        return (device.damping == 0.0).then(|| {
            "no stiffness is passive: the device has no damping, and a sampled spring needs some"
                .to_owned()
        });
    }
    let (name, damping) = (scene.environment.name(), given(environment.damping));
    let parts = match environment.mass > 0.0 {
        true => format!("mass, with a damping of {damping} N.s/m,"),
        false => format!("damping of {damping} N.s/m"),
    };
    (needed >= device.damping).then(|| {
        format!(
            "no stiffness is passive: the {name}'s {parts} alone needs {} N.s/m of the device, which has {own}",
            found(needed)
        )
    })
}

/// Assumptions of the limit of friction and encoder that the scene does not meet.
fn friction_notes(scene: &Scene) -> Vec<&'static str> {
    let effects = &scene.effects;
    if effects.friction.is_none() || effects.encoder.is_none() {
        return vec!["the limit of friction and encoder is for scenes with both"];
    }
    if scene.dimensions() > 1 {
        return vec![
            "the limit of friction and encoder is for one axis: friction along the surface pays for nothing across it",
        ];
    }
    let delays = effects.delay.is_some_and(|it| it.ticks.get() > 0);
    let damps = scene.environment.kind().impedance().is_some_and(|it| it.damping > 0.0);
    let all = [
        (delays, "the limit of friction and encoder knows nothing of the delay"),
        (damps, "the limit of friction and encoder knows nothing of the wall's damper"),
    ];
    all.into_iter().filter_map(|(holds, text)| holds.then_some(text)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The notes on a scene with `more`, and whether its own stiffness is within Gil's rule and the exact limit.
    fn of(more: &str) -> (Vec<String>, [bool; 2]) {
        let text = format!(
            "duration = 3\nservo_rate = 1000\ndevice = {{ mass = 0.12, damping = 0.3 }}\n\
             operator = {{ mass = 0.15, damping = 4, stiffness = 400, rest = 0.02 }}\n\
             environment.wall = {{ stiffness = 2500, damping = 1 }}\neffects.delay.ticks = 1\n{more}"
        );
        let limits = Limits::of(&Scene::parse(&text, "test").unwrap());
        let within = |limit: Option<f64>| limit.is_some_and(|limit| limit > 2500.0);
        (limits.notes, [limits.gil, limits.exact].map(within))
    }

    /// A soft link lets the device swing on its own, and Gil's rule passes what is not stable.
    #[test]
    fn a_link_is_told_to_be_none_of_gil_s_rule() {
        let is_told = |notes: &[String]| notes.iter().any(|note| note.contains("of the link"));
        let (notes, within) = of("");
        assert_eq!((is_told(&notes), within), (false, [true, true]));
        let (notes, within) = of("link = { stiffness = 800, damping = 0.2 }\n");
        assert_eq!((is_told(&notes), within), (true, [true, false]));
    }
}
