#!/usr/bin/env bash
# The lower crates under Miri: no undefined behaviour, and no leak, in what their tests execute (docs/fuzzing.md).
#   miri.sh            the examples and tests of the three crates, and every member over random bytes, on big-endian s390x
# It needs a nightly compiler with the components miri and rust-src, and says SKIPPED without.
set -euo pipefail
cd "$(dirname "$0")/.."
# On x86-64 Miri stops at the processor check of libm's fma.
target=s390x-unknown-linux-gnu
if ! cargo +nightly miri --version >/dev/null 2>&1; then
    rustup component add --toolchain nightly miri rust-src >/dev/null 2>&1 \
        || { echo "SKIPPED: no nightly compiler with miri and rust-src"; exit 0; }
fi
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}/miri
# Miri spoils the last digits of `powi` and the like at random; tests take exact powers of two from them. The crates call none.
export MIRIFLAGS="${MIRIFLAGS:-} -Zmiri-deterministic-floats"
# Seeds come from the tests, so nothing of the machine is needed.
# Left out are four examples that go through thousands of ticks, which takes Miri minutes each.
cargo +nightly miri test --target "$target" -p lyapunov-core -p lyapunov-plants -p lyapunov-stabilizers -- \
    --skip src/laws/mod.rs --skip laws::stabilizer::limiter \
    --skip affine_plant::AffinePlant --skip rigid_body::RigidBody
cargo +nightly miri test --target "$target" --manifest-path fuzz/Cargo.toml -p lyapunov-fuzz
