#!/usr/bin/env bash
# The fuzz targets (docs/fuzzing.md).
#   run.sh                         each over random bytes that are the same every time; not the readers, which the tests of cli have
#   run.sh ticks COUNT             the steps alone, over so many ticks in all: 1000000000 takes five minutes of a core
#   run.sh TARGET MINUTES [JOBS]   steps, poses or readers, under libFuzzer with the address sanitizer; a case that it finds is
#                                  left in artifacts/TARGET
#   run.sh coverage                which regions of the steps the random test of `cargo test` executes
# It installs cargo-fuzz where it is needed and missing.
set -euo pipefail
cd "$(dirname "$0")"
target=${1:-tests}
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/../target}

coverage() {
    local tools
    rustup component add llvm-tools >/dev/null 2>&1 || true
    tools=$(rustc --print sysroot)/lib/rustlib/$(rustc -vV | sed -n 's/^host: //p')/bin
    [ -x "$tools/llvm-cov" ] || { echo "SKIPPED: coverage needs the component llvm-tools"; exit 0; }
    local out=$CARGO_TARGET_DIR/coverage
    rm -rf "$out/profiles"
    # One instance of each generic function counts as covered where any of them is.
    RUSTFLAGS="-C instrument-coverage" LLVM_PROFILE_FILE="$out/profiles/%p.profraw" \
        cargo test --quiet --target-dir "$out"
    "$tools/llvm-profdata" merge -sparse "$out"/profiles/*.profraw -o "$out/all.profdata"
    local objects=() binary
    for binary in "$out"/debug/deps/{steps,poses}-*; do
        if [ -x "$binary" ] && [ ! -d "$binary" ]; then objects+=(-object "$binary"); fi
    done
    "$tools/llvm-cov" export "${objects[@]}" -instr-profile "$out/all.profdata" >"$out/all.json"
    python3 coverage.py "$out/all.json" .. | tee "$out/missed.txt"
}

case $target in
    tests) cargo test --quiet; exit ;;
    ticks)
        FUZZ_TICKS=${2:?"number of ticks"} cargo test --quiet --test steps -- --nocapture as_many_ticks
        exit
        ;;
    coverage) coverage; exit ;;
    steps | poses) folder=. ;;
    readers) folder=readers ;;
    *) echo "usage: fuzz/run.sh [coverage | ticks COUNT | steps|poses|readers MINUTES [JOBS]]"; exit 2 ;;
esac
minutes=${2:?"minutes"}
jobs=${3:-1}
command -v cargo-fuzz >/dev/null || cargo install --quiet cargo-fuzz
# The sanitizer is an option that stable compilers hide.
corpus=$folder/corpus/$target
mkdir -p "$corpus"
if [ "$target" = readers ] && [ -z "$(ls "$corpus")" ]; then
    # The first byte chooses the reader: that of scenes, of models, of teleoperators, of logs.
    for kind in 0:. 1:models 2:teleoperation 3:logs; do
        for file in ../scenes/"${kind#*:}"/*.[ct]*; do
            { printf "\\x0${kind%%:*}"; head -c 4000 "$file"; } >"$corpus/${kind%%:*}-$(basename "$file")"
        done
    done
fi
RUSTC_BOOTSTRAP=1 cargo fuzz run --fuzz-dir "$folder" --features libfuzzer "$target" -- \
    -max_total_time=$((minutes * 60)) -max_len=4096 -print_final_stats=1 -fork="$jobs"
