//! Ticks that studies tell as done: they add up to those of the runs.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicU64, Ordering};

use lyapunov_lab::compare::{Compared, Comparison, Energies, Entrants, Names, TradeOff};
use lyapunov_lab::family::StabilizerName;
use lyapunov_lab::{Scene, models, teleoperation};

use crate::models::shipped::model;
use crate::teleoperation::shipped::{parsed, text};

const SCENE: &str = "
duration = 20.0
servo_rate = 1000.0
operator = { mass = 0.1, damping = 1.0, stiffness = 200.0, rest = 0.01 }
device = { mass = 0.2, damping = 0.5 }
environment.wall = { stiffness = 200.0, damping = 1.0 }
";

#[derive(Default)]
struct Told(AtomicU64);

impl Told {
    fn add(&self, ticks: u64) -> ControlFlow<()> {
        self.0.fetch_add(ticks, Ordering::Relaxed);
        ControlFlow::Continue(())
    }

    /// The ticks that were told since the last call.
    fn taken(&self) -> u64 {
        self.0.swap(0, Ordering::Relaxed)
    }
}

/// A run of 20 s at 1 kHz has 20,001 rows. A trade-off has 12 by 12 walls, and its runs are no longer than those of the scene.
#[test]
fn a_comparison_tells_every_tick_once() {
    let scene = Scene::parse(SCENE, "test").unwrap();
    let names = ["none", "popc"].map(|name| name.parse::<StabilizerName>().unwrap());
    let (entrants, told) = (Entrants::<f64>::of(names), Told::default());
    let watch = |ticks| told.add(ticks);
    let comparison = Comparison::watched("test", &scene, &entrants, &watch).unwrap();
    assert_eq!(told.taken(), 2 * 20_001);
    Energies::of(&comparison, &entrants, &watch).unwrap();
    assert_eq!(told.taken(), 2 * 20_001);
    let (runs, ticks) = TradeOff::runs(&scene).unwrap();
    assert!(runs == 144 && (2..=20_001).contains(&ticks), "{runs} runs of {ticks} ticks");
    TradeOff::of(&comparison, &entrants, &watch).unwrap().unwrap();
    assert_eq!(told.taken(), 2 * runs * ticks);
}

#[test]
fn teleoperators_and_models_tell_every_tick_once() {
    fn check<C: Compared>(file: &C::File) {
        let (names, told) = (Names::default(), Told::default());
        C::of("test", file, &names, &|ticks| told.add(ticks)).unwrap();
        assert_eq!(told.taken(), names.iter().count() as u64 * C::ticks(file));
    }
    check::<teleoperation::Comparison>(&parsed(&text("lossy")));
    check::<models::Comparison>(&model("dc-motor"));
}
