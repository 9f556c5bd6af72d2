#!/usr/bin/env bash
# The tests of the three lower crates under Miri, on big-endian s390x: undefined behaviour, in ours and in what we use.
# On x86-64 Miri stops where libm asks the processor whether it has a fused multiply-add.
# Last results: docs/embedded.md.
set -euo pipefail
cd "$(dirname "$0")/.."
if ! rustup toolchain install nightly --profile minimal -c miri,rust-src >/dev/null 2>&1; then
    echo "SKIPPED: Miri: no nightly with miri can be had here"
    exit 0
fi
target=s390x-unknown-linux-gnu
cargo +nightly miri setup --quiet --target $target
# A doc test is a program of its own; those of a crate run one after the other.
cargo +nightly miri test --quiet --target $target -p lyapunov-core -p lyapunov-plants -p lyapunov-stabilizers "$@"
