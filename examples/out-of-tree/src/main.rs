//! A stabilizer written outside the workspace: it passes the laws, and meets POPC on a scene.

use std::error::Error;
use std::path::Path;

use lyapunov::{Action, DampingLimit, Drive, Popc, PortEnergy, Signal, Stabilizer, laws};
use lyapunov_lab::{Rollout, Row, Scene, Summary};

/// A virtual coupling damper that is always there: `f_out = f + b v`.
#[derive(Clone, Copy)]
struct CouplingDamper<T> {
    damping: T, // N·s/m
}

impl<V: Signal> Stabilizer<V> for CouplingDamper<V::Scalar> {
    fn stabilize(&mut self, drive: &Drive<V>, effort: V) -> Action<V> {
        let damped = effort + drive.velocity.scale(self.damping);
        Action { alpha: self.damping, ..Action::none(damped) }.checked()
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let damper = CouplingDamper { damping: 4.0 };
    laws::stabilizer(&damper, laws::Samples::<f64>::new(0.01))?;
    println!("the coupling damper keeps the laws of a stabilizer\n");

    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/paper-8k-none.toml");
    let scene = Scene::load(&path)?;
    let mass = scene.operator.mass.get() + scene.device.mass.get();
    let limit = DampingLimit::of_mass(0.5, mass, scene.period())?;
    let popc = Popc::new(PortEnergy, limit);

    println!("8 kN/m at 100 Hz     settled      peak force   burnt by the stabilizer");
    tell("nothing", &scene, Rollout::<f64>::of(&scene)?);
    tell("coupling damper", &scene, Rollout::<f64>::stabilized_by(&scene, damper)?);
    tell("POPC", &scene, Rollout::<f64>::stabilized_by(&scene, popc)?);
    Ok(())
}

fn tell(name: &str, scene: &Scene, rows: impl Iterator<Item = Row>) {
    let summary = Summary::of(scene, rows);
    let settled = summary.settled.map_or("no".to_owned(), |time| format!("{time:.2} s"));
    let (peak, burnt) = (summary.environment_peak, 1e3 * summary.injected);
    println!("{name:20} {settled:12} {peak:7.3e} N   {burnt:7.2} mJ");
}
