//! Parts of a scene in words.

use lyapunov::DampingLimit;

use crate::files::scene::{
    Basis, Candidate, Effects, Filter, Integrator, Ledger, Link, Lolc, Motion, Operator, Parameter,
    Policy, Popc, Scene, Stabilizer, Work,
};
use crate::simulate::Stabilizing;
use crate::text::{at_commas, counted, found, given, listed, shorten};

/// The sentence above a scene on a page, without its full stop.
pub(crate) const EVERY_NUMBER: &str = "Every number, with its default in place; where environment_rate and damping_cap are not \
     written, they follow from servo_rate and from the delay";

/// The environment in a line, without its name.
pub(crate) fn environment(scene: &Scene) -> String {
    scene.environment.kind().words(|number| given(number).to_string())
}

/// The line of a summary that tells the stabilizer and its numbers.
pub(crate) fn stabilizer(scene: &Scene, stabilizing: &Stabilizing) -> String {
    if let Stabilizing::Foreign(name) = stabilizing {
        return format!("  stabilizer   {name}, which is the program's own");
    }
    let observer = |booking: String| {
        let cap = scene.damping_cap();
        let cap = match cap.is_infinite() {
            true => "no damping cap".to_owned(),
            false => {
                let share = scene.written_cap().map_or_else(|| found(cap), given);
                let limit = scene.damping(cap).limit::<f64>().ok().map(DampingLimit::most);
                let limit = limit.map_or_else(String::new, |it| format!(", {} N.s/m", found(it)));
                format!("damping cap {share} m / T{limit}")
            }
        };
        at_commas("  stabilizer   ", &format!("{booking}, {cap}"))
    };
    match scene.stabilizer {
        None => "  stabilizer   none".to_owned(),
        Some(Stabilizer::Popc(Popc { work, ledger, .. })) => {
            observer(format!("POPC: {}", booking(work, ledger)))
        }
        Some(Stabilizer::Lolc(Lolc { work, candidate, ledger, .. })) => {
            let candidate = match candidate {
                Candidate::MassSpringDamper => "mass-spring-damper",
                Candidate::DeviceDamping => "device-damping",
                Candidate::Spring => "spring",
            };
            observer(format!("LOLC: {candidate}, {}", booking(work, ledger)))
        }
        Some(other) => {
            let parameters = other.kind().parameters(&Basis::of(scene));
            let numbers: Vec<String> = parameters.iter().filter_map(number).collect();
            listed(&format!("  stabilizer   {}: ", other.name()), &numbers)
        }
    }
}

/// The sentence about a damping cap that is too high for the delay of a scene, if it is.
pub(crate) fn exceeded_cap(scene: &Scene) -> Option<String> {
    let (limit, ticks) = (given(scene.exceeded_cap()?), scene.delay_ticks());
    let ticks = counted(ticks as usize, "tick");
    Some(format!("the damping cap is above {limit} m / T, the limit for a delay of {ticks}"))
}

/// The remark on the saturation of a scene, which bounds what would grow without it.
pub(crate) fn saturated(scene: &Scene) -> Option<String> {
    let told = "a saturation may bound a run that grows without it: compare the runs that settle";
    scene.effects.saturation.map(|_| told.to_owned())
}

/// A number of a stabilizer in words; none where it has no value.
fn number(parameter: &Parameter) -> Option<String> {
    let value = parameter.value()?;
    let value = if value.is_infinite() { "inf".to_owned() } else { given(value).to_string() };
    Some(format!("{} {value} {}", parameter.name(), parameter.unit).trim_end().to_owned())
}

fn booking(work: Work, ledger: Ledger) -> String {
    let ledger = match ledger {
        Ledger::Plain => "",
        Ledger::Compensated => ", compensated ledger",
        Ledger::Wide => ", wide ledger",
    };
    format!("{} work{ledger}", work.name())
}

/// The effects of a scene in words, one entry each.
pub(crate) fn effects(scene: &Scene) -> Vec<String> {
    let Effects {
        encoder,
        delay,
        saturation,
        filter,
        noise,
        jitter,
        dropout,
        friction,
        load,
        pulse,
    } = scene.effects;
    let policy = |policy| if policy == Policy::Hold { "hold" } else { "zero" };
    [
        encoder.map(|it| format!("encoder {} m", given(it.resolution.get()))),
        delay.map(|it| format!("delay {}", counted(it.ticks.get().into(), "tick"))),
        saturation.map(|it| format!("saturation {} N", given(it.force.get()))),
        filter.map(|it| match it {
            Filter::Cutoff(cutoff) => format!("low pass {} Hz", given(cutoff.get())),
            Filter::Window(ticks) => format!("window {}", counted(ticks.get().into(), "tick")),
        }),
        noise.map(|it| format!("noise {} m", given(it.deviation.get()))),
        jitter.map(|it| format!("jitter {} s", given(it.deviation.get()))),
        dropout.map(|it| {
            let percent = given(100.0 * it.probability.get());
            format!("dropout {percent} % ({})", policy(it.policy))
        }),
        friction.map(|it| {
            let (sliding, resting) = (it.coulomb.get(), it.breakaway());
            let more = if resting > sliding {
                format!(", {} N at rest", given(resting))
            } else {
                String::new()
            };
            format!("friction {} N{more}", given(sliding))
        }),
        load.map(|it| format!("load {} N", given(it.force.get()))),
        pulse.map(|it| {
            let (start, duration) = (given(it.start.get()), given(it.duration.get()));
            format!("pulse {} N from {start} s for {duration} s", given(it.force.get()))
        }),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The integrator in words, unless motion is exact.
pub(crate) fn integrator(integrator: Integrator) -> Option<String> {
    let name = integrator.name();
    let in_steps = |steps: u32| format!("{name} in {}", counted(steps as usize, "step"));
    let within = |tolerance| format!("{name} within {}", given(tolerance));
    integrator.steps_per_tick().map(in_steps).or(integrator.tolerance().map(within))
}

/// The operator's and the link's extras in words, one entry each.
pub(crate) fn operator(scene: &Scene) -> Vec<String> {
    let Operator { motion, grip, .. } = &scene.operator;
    let link = scene.link.map(|Link { stiffness, damping }| {
        format!("link {} N/m, {} N.s/m", given(stiffness.get()), given(damping.get()))
    });
    let motion = motion.as_ref().map(|motion| match motion {
        Motion::Step { at, to } => {
            format!("step to {} mm at {} s", given(1e3 * to.get()), given(at.get()))
        }
        Motion::Ramp { at, to, rate } => format!(
            "ramp to {} mm from {} s at {} m/s",
            given(1e3 * to.get()),
            given(at.get()),
            given(rate.get())
        ),
        Motion::Sine { amplitude, frequency } => {
            format!("sine of {} mm at {} Hz", given(1e3 * amplitude.get()), given(frequency.get()))
        }
        Motion::File { path, .. } => {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            format!("motion of {}", shorten(&name))
        }
    });
    let grip =
        grip.as_ref().map(|grip| format!("grip changes {}", counted(grip.times.len(), "time")));
    [link, motion, grip].into_iter().flatten().collect()
}
