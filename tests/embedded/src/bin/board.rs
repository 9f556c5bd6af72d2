//! Hashes of every member on a Cortex-M, with the instructions of each step by a clock that counts them: a line for each.
//!
//! `member, scalar, hash, instructions of all steps, of the longest, address of the step, bytes of the member`. Under
//! `qemu -icount` time is instructions, so the SysTick counts them.
#![no_std]
#![no_main]

use core::hint::black_box;
use core::panic::PanicInfo;
use core::sync::atomic::{Ordering, compiler_fence};

use cortex_m::Peripherals;
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::entry;
use cortex_m_semihosting::{debug, hprintln};
use lyapunov_core::{Correction, PortSample, Signal, Stabilizer};
use lyapunov_embedded::{BLOCK, Number, Visit, hash, step, visit};

/// Counts of a timer of 24 bits that runs downwards.
const MOST: u32 = 0x00FF_FFFF;

/// Rounds of a loop of two instructions.
const ROUNDS: u32 = 20_000;

/// Ticks of the timer while `work` runs.
#[inline(always)]
fn ticks<R>(work: impl FnOnce() -> R) -> (u32, R) {
    let start = SYST::get_current();
    compiler_fence(Ordering::SeqCst);
    let result = work();
    compiler_fence(Ordering::SeqCst);
    (start.wrapping_sub(SYST::get_current()) & MOST, result)
}

/// Ticks of the timer to instructions.
struct Clock {
    /// Of reading the timer twice.
    idle: u32,
    /// Of [`ROUNDS`] rounds.
    known: u32,
}

impl Clock {
    fn new() -> Self {
        let mut timer = Peripherals::take().expect("the first call").SYST;
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(MOST);
        timer.clear_current();
        timer.enable_counter();
        let (idle, ()) = ticks(|| ());
        // A round for each cycle that is asked for.
        let [none, long] = [0, ROUNDS].map(|cycles| ticks(|| cortex_m::asm::delay(cycles)).0);
        Self { idle, known: long - none }
    }

    fn instructions(&self, ticks: u32) -> u32 {
        let (ticks, known) = (u64::from(ticks - self.idle), u64::from(self.known));
        ((ticks * u64::from(2 * ROUNDS) + known / 2) / known) as u32
    }
}

struct Counted<'a> {
    scalar: &'static str,
    clock: &'a Clock,
}

impl<T: Number> Visit<T> for Counted<'_> {
    #[inline(never)]
    fn member<V, S>(&mut self, name: &'static str, member: S)
    where
        V: Signal<Scalar = T>,
        S: Stabilizer<V> + Copy + Send + Sync + 'static,
    {
        let (mut all, mut most) = (0, 0);
        let step: fn(&mut S, &PortSample<V>, V) -> Correction<V> = step;
        let hash = hash::<V, S>(member, BLOCK, 0, |member, sample, effort| {
            let step = black_box(step);
            let (ticks, told) = ticks(|| step(member, sample, effort));
            let count = self.clock.instructions(ticks);
            all += count;
            most = most.max(count);
            told
        });
        let (scalar, address, bytes) = (self.scalar, step as usize & !1, size_of::<S>());
        hprintln!("{} {} {:016x} {} {} {:x} {}", name, scalar, hash.0, all, most, address, bytes);
    }
}

#[entry]
fn main() -> ! {
    let clock = Clock::new();
    visit::<f32>(&mut Counted { scalar: "f32", clock: &clock }).expect("the parameters");
    visit::<f64>(&mut Counted { scalar: "f64", clock: &clock }).expect("the parameters");
    debug::exit(debug::EXIT_SUCCESS);
    unreachable!("the program has ended")
}

#[panic_handler]
fn panicked(info: &PanicInfo<'_>) -> ! {
    hprintln!("{}", info);
    debug::exit(debug::EXIT_FAILURE);
    loop {}
}
