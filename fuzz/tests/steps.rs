//! Every member over random bytes: ten million ticks in all, or as many as `FUZZ_TICKS` asks for.

use lyapunov_embedded::{Number, Visit, visit};
use lyapunov_fuzz::{Bytes, Real, members, random};

/// Ticks of all members in both scalars, at least. The bytes of a longer run begin with those of a shorter one.
fn asked() -> usize {
    // Miri keeps the environment from what it runs.
    let usual = if cfg!(miri) { 4_000 } else { 10_000_000 };
    let asked = std::env::var("FUZZ_TICKS").ok();
    asked.map_or(usual, |count| count.parse().expect("FUZZ_TICKS is a number of ticks"))
}

/// Bytes of a run at most.
const LENGTH: u64 = 2000;

/// Drives every member over random bytes, and tells how many ticks that were.
fn drive<T: Real>(least: usize) -> usize {
    let (mut all, mut broken) = (0, Vec::new());
    let members = members::<T>();
    let each = least.div_ceil(members.len());
    for (index, member) in members.iter().enumerate() {
        let (mut ticks, mut runs) = (0, 0_u64);
        while ticks < each {
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
            assert!(runs < 100 * each as u64, "{} refuses its parameters", member.name);
        }
        all += ticks;
    }
    assert!(broken.is_empty(), "{broken:#?}");
    all
}

#[test]
fn as_many_ticks_of_any_bits_as_asked_break_no_promise() {
    let asked = asked();
    let [double, single] = [drive::<f64>, drive::<f32>].map(|drive| drive(asked.div_ceil(2)));
    println!("{} ticks", double + single);
    assert!(double + single >= asked, "{double} and {single}");
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
