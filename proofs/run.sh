#!/usr/bin/env bash
# The proofs about the steps (docs/proofs.md): `run.sh` asks about one axis, `run.sh all` everything.
set -euo pipefail
cd "$(dirname "$0")/.."
mode=${1:-quick}
case $mode in quick | all) ;; *) echo "usage: proofs/run.sh [quick|all]"; exit 2 ;; esac
built=$PWD/target/proofs

venv=$built/venv
if [ ! -x "$venv/bin/python" ] || ! "$venv/bin/python" -c 'import bitwuzla, z3' 2>/dev/null; then
    rm -rf "$venv"
    if ! { python3 -m venv "$venv" && "$venv/bin/pip" install --quiet bitwuzla z3-solver; } >/dev/null 2>&1; then
        echo "SKIPPED: the proofs: bitwuzla and z3-solver cannot be installed by pip here"
        exit 0
    fi
fi
if ! command -v gappa >/dev/null && ! apt-get install --quiet --yes gappa >/dev/null 2>&1; then
    echo "SKIPPED: the proofs: there is no gappa, and apt-get install gappa failed"
    exit 0
fi

# The queries are written anew from the crates' own steps.
CARGO_TARGET_DIR=$built cargo build --quiet --release --manifest-path proofs/Cargo.toml
# The tape that they are written from tells what the real steps tell, bit by bit.
CARGO_TARGET_DIR=$built cargo test --quiet --release --manifest-path proofs/Cargo.toml
rm -rf "$built/queries"
"$built/release/lyapunov-proofs" "$built/queries"
# What is not decided fails, so a query gets far more than the half minute of the longest one.
"$venv/bin/python" proofs/solve.py "$built/queries/index.tsv" 120 "$built/results-$mode.tsv" "$mode"
[ "$mode" = quick ] || "$venv/bin/python" proofs/table.py "$built/results-all.tsv" docs/proofs.md
