#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| lyapunov_fuzz_readers::readers(bytes));
