//! Hashes of every member on this processor, a line for each: `host [TICKS]`, ticks from each of five seeds.

use lyapunov_core::{Signal, Stabilizer};
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

fn main() {
    let ticks = std::env::args().nth(1).map_or(Ok(BLOCK), |ticks| ticks.parse());
    let ticks = ticks.expect("a number of ticks");
    visit::<f32>(&mut Print { scalar: "f32", ticks }).expect("the parameters");
    visit::<f64>(&mut Print { scalar: "f64", ticks }).expect("the parameters");
}
