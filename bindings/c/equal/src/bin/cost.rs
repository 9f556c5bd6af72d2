//! A step through the shared library of C beside the same step in Rust behind a call that is not inlined.
//!
//! `tests/cost.sh` runs it. `cost LIBRARY [BLOCK [TURNS]]`: the two take turns, and the ratio is of the medians.

use std::ffi::{CString, c_char, c_int, c_void};
use std::hint::black_box;
use std::time::Instant;

use lyapunov::{
    Correction, DampingLimit, Dissipation, Lolc, ParameterError, Popc, PortEnergy, PortSample,
    Scalar, Signal, Stabilizer,
};
use nalgebra::Vector3;

const TICKS: usize = 4096;

unsafe extern "C" {
    fn dlopen(path: *const c_char, flags: c_int) -> *mut c_void;
    fn dlsym(library: *mut c_void, name: *const c_char) -> *mut c_void;
}

/// Storage, status and correction of C, or more than that; the code is the last number of a status.
type Room = [u64; 8];
type Status = [u64; 4];

/// An effort as it is handed over, in C and in Rust alike: one number by value, several where they are.
trait Handed: Signal {
    type Effort: Copy;
    const ONE: Self::Effort;
    fn of(effort: Self::Effort) -> Self;
}

macro_rules! handed {
    ($($number:ident),+) => {$(
        impl Handed for $number {
            type Effort = Self;
            const ONE: Self = 1.0;
            #[inline(always)]
            fn of(effort: Self) -> Self {
                effort
            }
        }

        impl Handed for Vector3<$number> {
            type Effort = &'static Self;
            const ONE: &'static Self = &Vector3::new(1.0, 1.0, 1.0);
            #[inline(always)]
            fn of(effort: &'static Self) -> Self {
                *effort
            }
        }
    )+};
}

handed!(f32, f64);

type Init<T> = unsafe extern "C" fn(*mut Room, *const [T; 3], u32) -> StatusForm;
type Step<V> = unsafe extern "C" fn(
    *mut Room,
    *const <V as Signal>::Scalar,
    <V as Handed>::Effort,
    *mut Room,
) -> u32;

#[repr(C)]
struct StatusForm(Status);

#[inline(never)]
fn rust_step<V: Handed, S: Stabilizer<V>>(
    block: &mut S,
    sample: &PortSample<V>,
    effort: V::Effort,
) -> Correction<V> {
    block.stabilize(sample, V::of(effort))
}

/// The measurement: of which library and blocks, and how often.
struct Bench {
    library: *mut c_void,
    only: Option<String>,
    turns: usize,
}

impl Bench {
    fn symbol(&self, name: &str) -> Result<*mut c_void, String> {
        let c_name = CString::new(name).map_err(|error| error.to_string())?;
        // SAFETY: an open library and a name that ends with a zero.
        let found = unsafe { dlsym(self.library, c_name.as_ptr()) };
        if found.is_null() { Err(format!("the library has no {name}")) } else { Ok(found) }
    }

    /// Measures the block called `name`, made of the parameters `given`, beside `block`.
    fn cost<V: Handed, S: Stabilizer<V>>(
        &self,
        name: &str,
        mut block: S,
        given: [V::Scalar; 3],
    ) -> Result<(), String> {
        if self.only.as_ref().is_some_and(|only| only != name) {
            return Ok(());
        }
        // SAFETY: functions of the library, as its header declares them.
        let (init, step, abi) = unsafe {
            let init: Init<V::Scalar> =
                std::mem::transmute(self.symbol(&format!("lyapunov_{name}_init_abi"))?);
            let step = std::mem::transmute_copy::<_, Step<V>>(
                &self.symbol(&format!("lyapunov_{name}_step"))?,
            );
            let abi: unsafe extern "C" fn() -> u32 =
                std::mem::transmute(self.symbol("lyapunov_abi")?);
            (init, step, abi())
        };
        let samples: Vec<PortSample<V>> = (0..TICKS).map(sample).collect();
        let forms: Vec<_> = samples.iter().flat_map(numbers).collect();
        let (mut storage, mut out) = (Room::default(), Room::default());
        // SAFETY: storage and parameters are no smaller than those of the header.
        let StatusForm(status) = unsafe { init(&mut storage, &given, abi) };
        if status[3] >> 32 != 0 {
            return Err(format!("{name} was refused"));
        }
        let in_rust = black_box(rust_step::<V, S> as fn(&mut S, &_, _) -> _);
        let through_c = black_box(step);
        let (mut rust, mut c) = (Vec::new(), Vec::new());
        for _ in 0..self.turns {
            rust.push(timed(|| {
                for sample in &samples {
                    black_box(&in_rust(&mut block, sample, V::ONE));
                }
            }));
            c.push(timed(|| {
                for form in forms.chunks_exact(forms.len() / TICKS) {
                    // SAFETY: as above; the storage was initialised, and a form has all numbers of a sample.
                    unsafe { through_c(&mut storage, form.as_ptr(), V::ONE, &mut out) };
                    black_box(&out);
                }
            }));
        }
        let (rust, c) = (median(&mut rust), median(&mut c));
        println!("{name:<10} in Rust {rust:6.2} ns   through C {c:6.2} ns   ratio {:.3}", c / rust);
        Ok(())
    }
}

fn sample<V: Signal>(tick: usize) -> PortSample<V> {
    let phase = tick as f64 * 0.01;
    let all = |number: f64| V::splat(V::Scalar::of(number));
    PortSample {
        period: V::Scalar::of(1e-3),
        position: all(phase.sin()),
        velocity: all(0.1 * phase.cos()),
        displacement: all(1e-4 * phase.cos()),
        applied: all(2.0 * phase.sin()),
        work: all(2e-4 * phase.sin() * phase.cos()),
    }
}

/// The numbers of a sample, in the order of C.
fn numbers<V: Signal>(sample: &PortSample<V>) -> Vec<V::Scalar> {
    let mut numbers = vec![sample.period];
    let PortSample { position, velocity, displacement, applied, work, .. } = *sample;
    for signal in [position, velocity, displacement, applied, work] {
        signal.map(|axis| {
            numbers.push(axis);
            axis
        });
    }
    numbers
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

fn popc<T: Scalar>() -> Result<Popc<T>, ParameterError> {
    Ok(Popc::new(PortEnergy, DampingLimit::at(T::of(80.0))?))
}

fn lolc<T: Scalar>() -> Result<Lolc<T, (PortEnergy, Dissipation<T>)>, ParameterError> {
    let candidate = (PortEnergy, Dissipation::of(T::of(0.5))?);
    Ok(Lolc::new(candidate, DampingLimit::at(T::of(80.0))?))
}

fn main() -> Result<(), String> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().ok_or("give the path of liblyapunov_c.so")?;
    let only = arguments.next();
    let turns = arguments.next().map_or(Ok(401), |turns| turns.parse());
    let turns = turns.map_err(|error| format!("turns: {error}"))?;
    let c_path = CString::new(path.as_str()).map_err(|error| error.to_string())?;
    // SAFETY: a path that ends with a zero; 2 resolves all symbols now.
    let library = unsafe { dlopen(c_path.as_ptr(), 2) };
    if library.is_null() {
        return Err(format!("{path} cannot be loaded; build it with --crate-type cdylib"));
    }
    let bench = Bench { library, only, turns };
    let error = |error: ParameterError| error.to_string();
    bench.cost::<f32, _>("popc_f32", popc().map_err(error)?, [80.0, 0.0, 0.0])?;
    bench.cost::<f64, _>("popc_f64", popc().map_err(error)?, [80.0, 0.0, 0.0])?;
    bench.cost::<Vector3<f32>, _>("popc_f32x3", popc().map_err(error)?, [80.0, 0.0, 0.0])?;
    bench.cost::<Vector3<f64>, _>("popc_f64x3", popc().map_err(error)?, [80.0, 0.0, 0.0])?;
    bench.cost::<f32, _>("lolc_f32", lolc().map_err(error)?, [80.0, 0.5, 0.0])?;
    bench.cost::<f64, _>("lolc_f64", lolc().map_err(error)?, [80.0, 0.5, 0.0])?;
    bench.cost::<Vector3<f32>, _>("lolc_f32x3", lolc().map_err(error)?, [80.0, 0.5, 0.0])?;
    bench.cost::<Vector3<f64>, _>("lolc_f64x3", lolc().map_err(error)?, [80.0, 0.5, 0.0])
}
