//! Signs of a mistake in the numbers of a scene.

use std::f64::consts::TAU;

use super::{FASTEST, Oddity, REACH, SLOWEST, STRONGEST, Sign};
use crate::files::Scene;
use crate::files::scene::{Effects, Motion};
use crate::simulate::criterion::sampled;
use crate::simulate::equilibrium::{driven, last_pull};
use crate::text::{found, given};

/// Mass that no hand moves to and fro, kg.
const HEAVY: f64 = 30.0;

/// Time of a swing on the spring that holds it, s, up to which a heavier mass is moved all the same.
const SWING: f64 = 8.0;

/// Mass that no device is below, kg: a gram.
const LIGHT: f64 = 1e-3;

/// Speed at which no hand starts, m/s.
const FAST: f64 = 20.0;

/// Stiffness below which a wall gives way by a hand's length to a light touch, N/m: 0.1 m to 1 N.
const SOFT: f64 = 10.0;

/// Stiffness above which nothing is, N/m: a metre of steel rod, 8 mm thick, has 1e7.
const STIFF: f64 = 1e7;

/// Stiffness that no grip has, N/m.
const GRIP: f64 = 1e5;

/// Errors of a position that no encoder has, m: half a finger's width.
const COARSE: f64 = 5e-3;

/// Angle by which a step of an integrator turns a swing, rad, above which its error shows.
const COARSE_TURN: f64 = 0.5;

/// Force limit that nobody feels, N: a tenth of the weight of a gram.
const FAINT: f64 = 1e-3;

/// A number of a scene, and the bounds that no sound scene leaves.
struct Bounded {
    key: String,
    value: f64,
    unit: &'static str,
    least: f64,
    most: f64,
    /// The units in which the number may be given, where it is too large and where it is too small.
    mistaken: [&'static str; 2],
}

impl Bounded {
    fn oddity(&self) -> Option<Oddity> {
        let size = self.value.abs();
        let ([large, small], unit) = (self.mistaken, self.unit);
        let (bound, most, other) = if size > self.most {
            (self.most, "more", large)
        } else if size > 0.0 && size < self.least {
            (self.least, "less", small)
        } else {
            return None;
        };
        let (key, value, bound) = (&self.key, given(self.value), given(bound));
        let text =
            format!("{key} is {value} {unit}, {most} than {bound} {unit}: is it in {other}?");
        Some(Oddity::new(Sign::Unit, text))
    }
}

/// The signs of the numbers of `scene`.
pub(super) fn signs(scene: &Scene) -> Vec<Oddity> {
    let units = bounded(scene).into_iter().filter_map(|number| number.oddity());
    let turned = [spring(scene), damper(scene), coarse(scene)];
    let folded = folded(scene);
    units.chain(travel(scene)).chain(folded).chain(turned.into_iter().flatten()).collect()
}

/// Swings faster than half the rate that samples them, as which slower ones are seen.
fn folded(scene: &Scene) -> impl Iterator<Item = Oddity> {
    let hand = driven(scene).map(|it| ("operator.motion".to_owned(), it, scene.servo_rate.get()));
    let frequency = scene.environment.kind().frequency();
    let environment = format!("environment.{}", scene.environment.name());
    let environment = frequency.map(|it| (environment, it, scene.environment_rate()));
    let too_fast = hand.into_iter().chain(environment).filter(|(_, it, rate)| *it > 0.5 * rate);
    too_fast.map(|(key, frequency, rate)| {
        let (seen, frequency, rate) =
            (found(sampled(frequency, rate)), given(frequency), given(rate));
        let text = format!(
            "{key}.frequency is {frequency} Hz, more than half of the {rate} Hz that sample it: it moves as if it were {seen} Hz"
        );
        Oddity::new(Sign::Unit, text)
    })
}

/// Steps of an integrator that are long for the fastest swing of hand and device on their springs.
fn coarse(scene: &Scene) -> Option<Oddity> {
    let steps = scene.integrator.steps_per_tick()?;
    let (hand, device) = (&scene.operator, scene.device.mass.get());
    let pull = hand.stiffness.get();
    let square = match scene.link {
        None => pull / (hand.mass.get() + device),
        // At most the sum of both: of the link between the masses, and of the hand's spring on its own.
        Some(link) => {
            link.stiffness.get() * (device.recip() + hand.mass.get().recip())
                + pull / hand.mass.get()
        }
    };
    let step = scene.period() / f64::from(steps);
    let turn = step * square.sqrt();
    (turn > COARSE_TURN && turn.is_finite()).then(|| {
        let (step, turn) = (found(1e3 * step), found(turn));
        let text = format!(
            "a step of the integrator, {step} ms, turns the fastest swing by {turn} rad: give more steps_per_tick, or \
             integrator = \"exact\""
        );
        Oddity::new(Sign::Coarse, text)
    })
}

fn bounded(scene: &Scene) -> Vec<Bounded> {
    let operator = &scene.operator;
    let masses = ["g", "t"];
    let (hand, own) = (operator.stiffness.get(), scene.device.mass.get());
    let together = own + operator.mass.get();
    let (device, holder) = scene.link.map_or((together, hand), |it| (own, it.stiffness.get()));
    let heavy = |mass: f64, spring: f64| {
        if TAU * (mass / spring).sqrt() > SWING { HEAVY } else { f64::INFINITY }
    };
    let (device, operator_mass) = (heavy(device, holder), heavy(operator.mass.get(), hand));
    let mut all = vec![
        number("servo_rate", scene.servo_rate.get(), "Hz", [SLOWEST, FASTEST], ["mHz", "kHz"]),
        number("device.mass", own, "kg", [LIGHT, device], masses),
        number("operator.mass", operator.mass.get(), "kg", up_to(operator_mass), masses),
        number(
            "operator.stiffness",
            operator.stiffness.get(),
            "N/m",
            up_to(GRIP),
            ["mN/m", "N/mm"],
        ),
        number(
            "initial.velocity",
            scene.initial.velocity.get(),
            "m/s",
            up_to(FAST),
            ["mm/s", "km/s"],
        ),
    ];
    if let Some(impedance) = scene.environment.kind().impedance() {
        let key = format!("environment.{}.stiffness", scene.environment.name());
        let least = if scene.surface().is_some() { SOFT } else { 0.0 };
        let units = ["mN/m", "N/mm"];
        all.push(number(&key, impedance.stiffness, "N/m", [least, STIFF], units));
    }
    all.extend(bounded_of(&scene.effects));
    all
}

fn bounded_of(effects: &Effects) -> impl Iterator<Item = Bounded> {
    let (lengths, forces) = (["mm", "km"], ["mN", "kN"]);
    let numbers = [
        effects.encoder.map(|it| {
            let size = it.resolution.get();
            number("effects.encoder.resolution", size, "m", up_to(COARSE), lengths)
        }),
        effects.noise.map(|it| {
            number("effects.noise.deviation", it.deviation.get(), "m", up_to(COARSE), lengths)
        }),
        effects
            .load
            .map(|it| number("effects.load.force", it.force.get(), "N", up_to(STRONGEST), forces)),
        effects
            .pulse
            .map(|it| number("effects.pulse.force", it.force.get(), "N", up_to(STRONGEST), forces)),
        effects.saturation.map(|it| {
            let range = [FAINT, f64::INFINITY];
            number("effects.saturation.force", it.force.get(), "N", range, forces)
        }),
    ];
    numbers.into_iter().flatten()
}

fn number(
    key: &str,
    value: f64,
    unit: &'static str,
    [least, most]: [f64; 2],
    mistaken: [&'static str; 2],
) -> Bounded {
    Bounded { key: key.to_owned(), value, unit, least, most, mistaken }
}

fn up_to(most: f64) -> [f64; 2] {
    [0.0, most]
}

/// A way from the start to where the hand pulls that no arm goes.
fn travel(scene: &Scene) -> Option<Oddity> {
    let (start, rest) = (scene.initial.position.get(), scene.operator.rest.get());
    if last_pull(scene) == 0.0 {
        return None;
    }
    let to = scene.operator.motion.as_ref().map(|motion| match motion {
        Motion::Step { to, .. } | Motion::Ramp { to, .. } => ("operator.motion.to", to.get()),
        Motion::Sine { amplitude, .. } => ("operator.motion.amplitude", rest + amplitude.get()),
        Motion::File { samples, .. } => {
            let far = |one: f64, other: f64| if other.abs() > one.abs() { other } else { one };
            ("operator.motion.path", samples.iter().fold(rest, |most, it| far(most, it.1)))
        }
    });
    let ways = [("operator.rest", rest)].into_iter().chain(to);
    let (key, place) = ways.into_iter().find(|(_, place)| (place - start).abs() > REACH)?;
    let way = found((place - start).abs());
    let text =
        format!("from initial.position to {key} are {way} m, further than arms reach: in mm?");
    Some(Oddity::new(Sign::Unit, text))
}

/// A spring that pulls away by more than the hand holds.
fn spring(scene: &Scene) -> Option<Oddity> {
    let pull = scene.environment.kind().impedance()?.stiffness;
    let hold = last_pull(scene);
    if !(pull < 0.0 && pull + hold <= 0.0) {
        return None;
    }
    let (name, pull, hold) = (scene.environment.name(), given(pull), given(hold));
    let text = format!(
        "environment.{name} pushes away by {pull} N/m, and the hand holds {hold} N/m: reversed?"
    );
    Some(Oddity::new(Sign::Reversed, text))
}

/// A damper that drives the motion by more than device and hand burn.
fn damper(scene: &Scene) -> Option<Oddity> {
    let drive = scene.environment.kind().impedance()?.damping;
    let burns = scene.device.damping.get() + scene.operator.damping.get();
    if !(drive < 0.0 && drive + burns < 0.0) {
        return None;
    }
    let (name, drive, burns) = (scene.environment.name(), given(drive), given(burns));
    let text = format!(
        "environment.{name}.damping is {drive} N.s/m, and device and hand burn {burns}: reversed?"
    );
    Some(Oddity::new(Sign::Reversed, text))
}
