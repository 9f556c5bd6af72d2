//! Every member over random bytes: ten million ticks in all.

use lyapunov_embedded::{Number, Visit, visit};
use lyapunov_fuzz::{Bytes, Real, members, random};

/// Ticks of each member in each scalar; with 46 members in two scalars ten million in all.
const TICKS: usize = if cfg!(miri) { 40 } else { 110_000 };

/// Bytes of a run at most.
const LENGTH: u64 = 2000;

/// Drives every member over random bytes, and tells how many ticks that were.
fn drive<T: Real>() -> usize {
    let (mut all, mut broken) = (0, Vec::new());
    for (index, member) in members::<T>().iter().enumerate() {
        let (mut ticks, mut runs) = (0, 0_u64);
        while ticks < TICKS {
            let seed = runs << 8 | index as u64;
            let bytes = random(seed, (runs.wrapping_mul(97) % LENGTH) as usize + 16);
            let run = std::panic::catch_unwind(|| (member.run)(&mut Bytes::of(&bytes)));
            match run {
                Ok(driven) => ticks += driven.unwrap_or(0),
                Err(_) => {
                    broken.push(format!(
                        "{} in {}, seed {seed}",
                        member.name,
                        std::any::type_name::<T>()
                    ));
                    break;
                }
            }
            runs += 1;
            assert!(runs < 100 * TICKS as u64, "{} refuses its parameters", member.name);
        }
        all += ticks;
    }
    assert!(broken.is_empty(), "{broken:#?}");
    all
}

#[test]
fn ten_million_ticks_of_any_bits_break_no_promise() {
    let ticks = drive::<f64>() + drive::<f32>();
    assert!(cfg!(miri) || ticks >= 10_000_000, "{ticks}");
}

/// The names of `tests/embedded`, which has every exported type.
struct Names(Vec<&'static str>);

impl<T: Number> Visit<T> for Names {
    fn member<V, S>(&mut self, name: &'static str, _member: S)
    where
        V: lyapunov_core::Signal<Scalar = T>,
        S: lyapunov_core::Stabilizer<V> + Copy + Send + Sync + 'static,
    {
        // It is there to be compared with, and promises nothing.
        if name != "by-hand" {
            self.0.push(name);
        }
    }
}

#[test]
fn every_member_is_driven() {
    let mut names = Names(Vec::new());
    visit::<f64>(&mut names).expect("the parameters");
    let mut driven: Vec<_> = members::<f64>().iter().map(|it| it.name).collect();
    names.0.sort_unstable();
    driven.sort_unstable();
    assert_eq!(driven, names.0);
}
