//! A step through the shared library of C beside the same step in Rust behind a call that is not inlined.
//!
//! `cargo run --release -p lyapunov-equal --bin cost -- target/release/liblyapunov_c.so`: the two take turns, and the ratio is of
//! the medians.

use std::ffi::{CString, c_char, c_int, c_void};
use std::hint::black_box;
use std::time::Instant;

use lyapunov::{
    Correction, DampingLimit, Dissipation, Lolc, Popc, PortEnergy, PortSample, Stabilizer,
};

const TICKS: usize = 4096;
const TURNS: usize = 401;

unsafe extern "C" {
    fn dlopen(path: *const c_char, flags: c_int) -> *mut c_void;
    fn dlsym(library: *mut c_void, name: *const c_char) -> *mut c_void;
}

/// Status of C: only the code, its last number, is looked at.
#[repr(C)]
struct Status {
    words: [u64; 4],
}

#[repr(C)]
#[derive(Clone, Copy, Default)]
struct Sample<T> {
    numbers: [T; 6],
}

#[repr(C)]
#[derive(Clone, Copy, Default)]
struct Told<T> {
    numbers: [T; 4],
    flags: [u32; 2],
}

fn symbol(library: *mut c_void, name: &str) -> Result<*mut c_void, String> {
    let c_name = CString::new(name).map_err(|error| error.to_string())?;
    // SAFETY: an open library and a name that ends with a zero.
    let found = unsafe { dlsym(library, c_name.as_ptr()) };
    if found.is_null() { Err(format!("the library has no {name}")) } else { Ok(found) }
}

fn median(times: &mut [f64]) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn timed(run: impl FnOnce()) -> f64 {
    let start = Instant::now();
    run();
    start.elapsed().as_secs_f64() * 1e9 / TICKS as f64
}

macro_rules! cost {
    ($library:ident, $name:literal, $number:ident, $rust:ty, $fresh:expr, $given:expr) => {{
        type Init = unsafe extern "C" fn(*mut [u64; 8], *const [$number; 3], u32) -> Status;
        type Step = unsafe extern "C" fn(
            *mut [u64; 8],
            *const Sample<$number>,
            $number,
            *mut Told<$number>,
        ) -> u32;

        #[inline(never)]
        fn rust_step(
            block: &mut $rust,
            sample: &PortSample<$number>,
            effort: $number,
        ) -> Correction<$number> {
            block.stabilize(sample, effort)
        }

        // SAFETY: functions of the library, as its header declares them.
        let (init, step, abi) = unsafe {
            let init: Init =
                std::mem::transmute(symbol($library, concat!("lyapunov_", $name, "_init_abi"))?);
            let step: Step =
                std::mem::transmute(symbol($library, concat!("lyapunov_", $name, "_step"))?);
            let abi: unsafe extern "C" fn() -> u32 =
                std::mem::transmute(symbol($library, "lyapunov_abi")?);
            (init, step, abi())
        };
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
        let forms: Vec<_> = samples
            .iter()
            .map(|it| Sample {
                numbers: [
                    it.period,
                    it.position,
                    it.velocity,
                    it.displacement,
                    it.applied,
                    it.work,
                ],
            })
            .collect();
        let mut block: $rust = $fresh;
        let (mut storage, mut out) = ([0_u64; 8], Told::<$number>::default());
        // SAFETY: storage and parameters are no smaller than those of the header.
        let status = unsafe { init(&mut storage, &$given, abi) };
        if status.words[3] >> 32 != 0 {
            return Err(concat!($name, " was refused").into());
        }
        let in_rust = black_box(
            rust_step as fn(&mut $rust, &PortSample<$number>, $number) -> Correction<$number>,
        );
        let through_c = black_box(step);
        let (mut rust, mut c) = (Vec::new(), Vec::new());
        for _ in 0..TURNS {
            rust.push(timed(|| {
                for sample in &samples {
                    black_box(&in_rust(&mut block, sample, 1.0));
                }
            }));
            c.push(timed(|| {
                for form in &forms {
                    // SAFETY: as above; the storage was initialised.
                    unsafe { through_c(&mut storage, form, 1.0, &mut out) };
                    black_box(&out);
                }
            }));
        }
        let (rust, c) = (median(&mut rust), median(&mut c));
        println!(
            "{:<9} in Rust {rust:6.2} ns   through C {c:6.2} ns   ratio {:.3}",
            $name,
            c / rust
        );
    }};
}

fn main() -> Result<(), String> {
    let path = std::env::args().nth(1).ok_or("give the path of liblyapunov_c.so")?;
    let c_path = CString::new(path.as_str()).map_err(|error| error.to_string())?;
    // SAFETY: a path that ends with a zero; 2 resolves all symbols now.
    let library = unsafe { dlopen(c_path.as_ptr(), 2) };
    if library.is_null() {
        return Err(format!("{path} cannot be loaded; build it with --crate-type cdylib"));
    }
    let error = |error: lyapunov::ParameterError| error.to_string();
    let narrow = DampingLimit::at(80.0_f32).map_err(error)?;
    let wide = DampingLimit::at(80.0_f64).map_err(error)?;
    let credit = Dissipation::of(0.5).map_err(error)?;
    cost!(library, "popc_f32", f32, Popc<f32>, Popc::new(PortEnergy, narrow), [80.0, 0.0, 0.0]);
    cost!(library, "popc_f64", f64, Popc<f64>, Popc::new(PortEnergy, wide), [80.0, 0.0, 0.0]);
    cost!(library, "lolc_f64", f64, Lolc<f64, (PortEnergy, Dissipation<f64>)>, Lolc::new((PortEnergy, credit), wide), [80.0, 0.5, 0.0]);
    Ok(())
}
