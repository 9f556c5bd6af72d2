//! Hashes of every member on this processor, a line for each: `host [TICKS]`, ticks from each of five seeds; `host planted` is a
//! step that allocates, which RealtimeSanitizer must catch.

use lyapunov_core::{Correction, PortSample, Signal, Stabilizer};
use lyapunov_embedded::{BLOCK, Number, Visit, hash, step, visit};

struct Print {
    scalar: &'static str,
    ticks: usize,
}

impl<T: Number> Visit<T> for Print {
    fn member<V, S>(&mut self, name: &'static str, member: S)
    where
        V: Signal<Scalar = T>,
        S: Stabilizer<V> + Copy + Send + Sync + 'static,
    {
        let hash = hash::<V, S>(member, self.ticks, 0, step);
        println!("{name} {} {:016x}", self.scalar, hash.0);
    }
}

/// What no step may do.
#[derive(Clone, Copy)]
struct Planted;

impl Stabilizer<f64> for Planted {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        Correction::none(std::hint::black_box(vec![sample.work, effort])[1])
    }
}

fn main() {
    let word = std::env::args().nth(1);
    if word.as_deref() == Some("planted") {
        println!("{:016x}", hash::<f64, _>(Planted, 1, 0, step).0);
        return;
    }
    let ticks = word.map_or(Ok(BLOCK), |ticks| ticks.parse());
    let ticks = ticks.expect("a number of ticks");
    visit::<f32>(&mut Print { scalar: "f32", ticks }).expect("the parameters");
    visit::<f64>(&mut Print { scalar: "f64", ticks }).expect("the parameters");
}
