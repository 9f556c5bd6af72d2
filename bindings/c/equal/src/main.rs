//! The reference for tests/c/equal.c, by the library in Rust alone: every block over random ticks, as a hash of its answers.
//!
//! Nothing here goes through the functions of C. `cargo run --release -p lyapunov-equal --bin lyapunov-equal -- 1000000`

mod run;
mod signals;
mod stabilizers;
mod watching;

fn main() -> signals::Done {
    let ticks = std::env::args().nth(1).and_then(|ticks| ticks.parse().ok()).unwrap_or(10_000);
    stabilizers::controllers(ticks)?;
    stabilizers::refined(ticks)?;
    stabilizers::family(ticks)?;
    watching::watching(ticks)?;
    watching::asked(ticks)
}
