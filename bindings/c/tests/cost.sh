#!/usr/bin/env bash
# What a step costs through C, beside the same step in Rust: times, and instructions as callgrind counts them. Called by check.sh;
# needs the shared library of check.sh.
set -euo pipefail
cd "$(dirname "$0")/.."

target=${CARGO_TARGET_DIR:-$PWD/target}
library=$target/release/liblyapunov_c.so
cost=$target/release/cost

cargo build --quiet --release -p lyapunov-equal --bin cost
"$cost" "$library"
if ! command -v valgrind >/dev/null; then
    printf '\n== SKIPPED: counting instructions: valgrind is not here\n'
    exit
fi
counts=$(mktemp)
trap 'rm -f "$counts"' EXIT
for block in popc_f32 popc_f64 popc_f32x3 popc_f64x3 lolc_f32 lolc_f64 lolc_f32x3 lolc_f64x3; do
    # One turn of each is 4096 calls.
    valgrind --quiet --tool=callgrind --callgrind-out-file="$counts" "$cost" "$library" $block 1 >/dev/null 2>&1
    callgrind_annotate "$counts" | awk -v block=$block '
        { gsub(",", "", $1) }
        /cost::rust_step/ { rust = $1 / 4096 }
        $0 ~ "lyapunov_" block "_step" { c = $1 / 4096 }
        END { printf "%-10s instructions: in Rust %6.1f   through C %6.1f   ratio %.3f\n", block, rust, c, c / rust }'
done
