//! A step through the function of C beside the same step in Rust behind a call that is not inlined.
//!
//! `cargo bench` in bindings/c. The two take turns; the ratio is of the medians.

use std::hint::black_box;
use std::time::Instant;

use lyapunov::{Correction, Dissipation, Lolc, Popc, PortEnergy, PortSample, Stabilizer};
use lyapunov_c::kept::{Kind, Storage};
use lyapunov_c::port::{CorrectionForm, SampleForm};

const TICKS: usize = 4096;
const TURNS: usize = 301;

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn ns(run: impl FnOnce()) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64() * 1e9 / TICKS as f64
}

macro_rules! cost {
    ($name:literal, $block:ident, $module:ident, $number:ident, $rust:ty, $fresh:expr, $given:expr) => {{
        use lyapunov_c::blocks::$block::$module as c;

        #[inline(never)]
        fn rust_step(
            block: &mut $rust,
            sample: &PortSample<$number>,
            effort: $number,
        ) -> Correction<$number> {
            block.stabilize(sample, effort)
        }

        let samples: Vec<PortSample<$number>> = (0..TICKS)
            .map(|tick| {
                let phase = tick as $number * 0.01;
                PortSample {
                    period: 1e-3,
                    position: phase.sin(),
                    velocity: 0.1 * phase.cos(),
                    displacement: 1e-4 * phase.cos(),
                    applied: 2.0 * phase.sin(),
                    work: 2e-4 * phase.sin() * phase.cos(),
                }
            })
            .collect();
        let forms: Vec<_> = samples.iter().map(SampleForm::of).collect();
        let mut block: $rust = $fresh;
        let mut storage = core::mem::MaybeUninit::<Storage<c::Block>>::zeroed();
        let parameters: <c::Block as Kind>::Parameters = $given;
        // SAFETY: both are variables of this function.
        let status =
            unsafe { c::life::init_abi(storage.as_mut_ptr(), &parameters, lyapunov_c::abi::ABI) };
        assert_eq!(status.code, 0);
        let mut out = CorrectionForm::<$number>::of(&Correction::none(0.0));
        let (in_rust, through_c) = (
            black_box(rust_step as fn(&mut $rust, &_, _) -> _),
            black_box(
                c::stabilizer::step as unsafe extern "C" fn(*mut _, *const _, _, *mut _) -> _,
            ),
        );
        let (mut rust, mut c_times) = (Vec::new(), Vec::new());
        for _ in 0..TURNS {
            rust.push(ns(|| {
                for sample in &samples {
                    black_box(&in_rust(&mut block, sample, 1.0));
                }
            }));
            c_times.push(ns(|| {
                for form in &forms {
                    // SAFETY: all are variables of this function, and the storage was initialised.
                    unsafe { through_c(storage.as_mut_ptr(), form, 1.0, &mut out) };
                    black_box(&out);
                }
            }));
        }
        let (rust, c) = (median(rust), median(c_times));
        println!("{:<10} Rust {rust:6.2} ns   C {c:6.2} ns   ratio {:.3}", $name, c / rust);
    }};
}

fn main() {
    let limit32 = lyapunov::DampingLimit::at(80.0_f32).unwrap();
    let limit64 = lyapunov::DampingLimit::at(80.0_f64).unwrap();
    cost!(
        "popc_f32",
        popc,
        of_f32,
        f32,
        Popc<f32>,
        Popc::new(PortEnergy, limit32),
        c::Parameters { damping_limit: 80.0, budget: 0.0 }
    );
    cost!(
        "popc_f64",
        popc,
        of_f64,
        f64,
        Popc<f64>,
        Popc::new(PortEnergy, limit64),
        c::Parameters { damping_limit: 80.0, budget: 0.0 }
    );
    cost!("lolc_f64", lolc, of_f64, f64, Lolc<f64, (PortEnergy, Dissipation<f64>)>,
        Lolc::new((PortEnergy, Dissipation::of(0.5).unwrap()), limit64),
        c::Parameters { damping_limit: 80.0, device_damping: 0.5, budget: 0.0 });
}
