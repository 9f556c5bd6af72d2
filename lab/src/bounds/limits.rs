//! All limits of a scene.

use super::{LinearPart, NotLinear, friction, gil, linear_part::impedance};
use crate::Scene;
use crate::scene::{Environment, Filter, Velocity};

/// How stiff the environment of a scene may be, by each formula, N/m; shown, it is the table of `lyapunov bound`.
///
/// A limit is 0 where no stiffness from 0 on passes, and none where the formula does not apply. All are about the scene's own
/// [linear part](LinearPart), everything but the stiffness as the scene has it.
#[derive(Clone, Debug, PartialEq)]
pub struct Limits {
    /// The scene's own stiffness, if its environment has one.
    pub stiffness: Option<f64>,
    /// For any passive operator: [`LinearPart::passive_max_stiffness`].
    pub passive: Option<f64>,
    /// By Gil's rule, `(b + B) / (T / 2 + t_d)`, `b` of device and operator.
    pub gil: Option<f64>,
    /// By Abbott and Okamura, `min(2 b / T, 2 f_c / Δ)`, where the scene has friction and an encoder.
    pub friction_quantization: Option<f64>,
    /// The loop itself: the upper end of [`LinearPart::stable_stiffness`].
    pub exact: Option<f64>,
    /// The stiffness from which on the loop itself is stable, 0 but for a loop that needs one.
    pub exact_from: Option<f64>,
    /// [`LinearPart::spectral_radius`] at the scene's own stiffness.
    pub spectral_radius: Option<f64>,
    /// What a number does not say by itself.
    pub notes: Vec<String>,
}

impl Limits {
    /// The limits of `scene`.
    pub fn of(scene: &Scene) -> Self {
        let part = LinearPart::of(scene);
        let sound = part.as_ref().ok();
        let range = sound.map(|part| part.stable_stiffness().unwrap_or([0.0, 0.0]));
        let passive = sound.map(LinearPart::passive_max_stiffness);
        Self {
            stiffness: impedance(&scene.environment).map(|it| it.stiffness),
            passive,
            gil: gil::max_stiffness(scene),
            friction_quantization: friction::max_stiffness(scene),
            exact: range.map(|[_, end]| end).filter(|end| end.is_finite()),
            exact_from: range.map(|[start, _]| start),
            spectral_radius: sound.map(LinearPart::spectral_radius),
            notes: notes(scene, part, range),
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
            ("exact_max_stiffness", "exact, this operator", self.exact),
        ]
    }
}

fn notes(
    scene: &Scene,
    part: Result<LinearPart, NotLinear>,
    range: Option<[f64; 2]>,
) -> Vec<String> {
    let (effects, environment) = (&scene.effects, &scene.environment);
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
    note(
        range == Some([0.0, 0.0]),
        "no stiffness is stable: the loop grows, or does not decay, for any above 0",
    );
    note(
        range.is_some_and(|[_, end]| end.is_infinite()),
        "the exact limit is none: all are stable",
    );
    note(
        effects.friction.is_none() || effects.encoder.is_none(),
        "the limit of friction and encoder is for scenes with both",
    );
    note(matches!(environment, Environment::LayeredWall(_)), "the stiffness is the first layer's");
    note(
        matches!(environment, Environment::VaryingSpring(_)),
        "the stiffness is the spring's mean; what swings may add energy of its own",
    );
    note(
        matches!(environment, Environment::MovingWall(_)),
        "the wall is taken to stand; what moves may add energy of its own",
    );
    note(
        matches!(environment, Environment::HuntCrossley(it) if it.exponent.get() == 1.0),
        "the wall's damper grows with the depth and is left out, as at the surface",
    );
    note(scene.dimensions() > 1, "along the normal of the surface, as if it were flat");
    note(
        effects.dropout.is_some_and(|it| it.probability.get() > 0.0),
        "Gil's rule knows nothing of lost answers",
    );
    note(
        matches!(effects.filter, Some(Filter::Cutoff(_) | Filter::Window(_))),
        "Gil's rule knows nothing of the filter",
    );
    note(effects.jitter.is_some(), "the period is the nominal one, without jitter");
    note(scene.operator.grip.is_some(), "the grip is the one at the start");
    note(scene.stabilizer.is_some(), "the limits are those of the loop without its stabilizer");
    notes
}
