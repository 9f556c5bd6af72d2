//! A stabilizer written outside the workspace: checked by the laws, and compared with the others on a scene.

use std::error::Error;
use std::path::Path;

use lyapunov::{Correction, PortSample, Signal, Stabilizer, laws};
use lyapunov_lab::Scene;
use lyapunov_lab::compare::{Comparison, Entrants};

/// A virtual coupling damper that always acts: `f_out = f + b v`.
#[derive(Clone, Copy)]
struct CouplingDamper<T> {
    damping: T, // N·s/m
}

impl<V: Signal> Stabilizer<V> for CouplingDamper<V::Scalar> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let damped = effort + sample.velocity.scale(self.damping);
        Correction { alpha: self.damping, ..Correction::none(damped) }.checked()
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let damper = CouplingDamper { damping: 4.0 };
    laws::stabilizer(&damper, laws::Samples::<f64>::new(0.01))?;
    println!("the coupling damper keeps the laws of a stabilizer\n");

    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/paper-8k-none.toml");
    let scene = Scene::load(&path)?;
    let entrants = Entrants::<f64>::standard().with("coupling damper", move |_| Ok(damper));
    print!("{}", Comparison::of("8 kN/m", &scene, &entrants)?);
    Ok(())
}
