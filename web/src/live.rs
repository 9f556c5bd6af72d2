//! Loops that run while someone holds the hand.

use std::cell::RefCell;

use lyapunov::bodies::{Body, Impedance, OperatedBody};
use lyapunov::{OnePort, Plant, PortSample};
use lyapunov_lab::scene::Scene;
use lyapunov_lab::{Assembly, Port};

use crate::exchange::{answer, bytes};
use crate::scene::stabilized;

thread_local! {
    static LOOPS: RefCell<Vec<Option<Live>>> = const { RefCell::new(Vec::new()) };
}

/// One loop: the scene's port, and a body whose hand is moved from outside.
struct Live {
    scene: Scene,
    body: Body<f64>,
    port: Port<f64>,
    sample: PortSample<f64>,
    tick: u64,
}

/// The part of a scene that one mass on a line does not show; none where a hand holds it.
fn beyond(scene: &Scene) -> Option<&'static str> {
    let effects = &scene.effects;
    let all = [
        (scene.dimensions() > 1, "a space, of which the first axis is shown"),
        (scene.link.is_some(), "a link"),
        (effects.friction.is_some(), "friction"),
        (effects.jitter.is_some(), "jitter"),
        (effects.load.is_some(), "a load"),
        (effects.pulse.is_some(), "a pulse"),
    ];
    all.into_iter().find_map(|(has, name)| has.then_some(name))
}

impl Live {
    /// The loop of `scene`, at standstill at `place`.
    fn of(scene: Scene, place: f64) -> Result<Self, String> {
        if let Some(beyond) = beyond(&scene) {
            return Err(format!("The hand moves one mass on a line, and this scene has {beyond}"));
        }
        let parts = Impedance {
            mass: scene.operator.mass.get() + scene.device.mass.get(),
            damping: scene.operator.damping.get() + scene.device.damping.get(),
            stiffness: scene.operator.stiffness.get(),
        };
        let body = Body::new(parts, scene.period()).map_err(|error| error.to_string())?;
        let body = body.resting_at(place).starting(place, 0.0);
        let Assembly { port, .. } = Assembly::of(&scene).map_err(|error| error.to_string())?;
        let sample = body.start();
        Ok(Self { scene, body, port, sample, tick: 0 })
    }

    /// One tick: time, true position, force on the plant, injected damping, observed energy.
    fn tick(&mut self, hand: f64) -> [f64; 5] {
        let applied = self.port.respond(&self.sample);
        let correction = self.port.correction();
        let row = [
            self.tick as f64 * self.scene.period(),
            self.sample.position,
            applied,
            correction.alpha,
            correction.observed_energy,
        ];
        self.body.rest_at(hand);
        self.body.advance_into(applied, &mut self.sample);
        self.tick += 1;
        row
    }
}

/// Puts the scene of the input, under the stabilizer in its first line, at `place` m into loop `index`.
#[unsafe(no_mangle)]
pub extern "C" fn hold(index: usize, place: f64) -> u32 {
    answer(|text| {
        let live = Live::of(stabilized(text)?, place)?;
        LOOPS.with_borrow_mut(|loops| {
            if loops.len() <= index {
                loops.resize_with(index + 1, || None);
            }
            loops[index] = Some(live);
        });
        Ok(Vec::new())
    })
}

/// Moves loop `index` by some ticks, its hand evenly from `from` m to `to` m; the output has a row for each.
#[unsafe(no_mangle)]
pub extern "C" fn advance(index: usize, ticks: usize, from: f64, to: f64) -> u32 {
    answer(|_| {
        LOOPS.with_borrow_mut(|loops| {
            let live = loops.get_mut(index).and_then(Option::as_mut);
            let live = live.ok_or_else(|| format!("there is no loop {index}"))?;
            let share = |tick: usize| (tick + 1) as f64 / ticks as f64;
            let rows = (0..ticks).flat_map(|it| live.tick(from + (to - from) * share(it)));
            Ok(bytes(rows))
        })
    })
}
