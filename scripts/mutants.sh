#!/usr/bin/env bash
# Whether the tests notice a changed line: cargo-mutants over steps, ledgers and accumulators.
# `mutants.sh all` tries every mutant; `mutants.sh FILE...` those of some files of one package; `mutants.sh sample N [FILE...]`
# every N-th one; `mutants.sh named` the changes that went unnoticed once; `mutants.sh rest COUNT SEED` a random sample of those
# of plants, lab, figures and command. Survivors are listed.
set -euo pipefail
cd "$(dirname "$0")/.."
root=$PWD
# Dependencies are built once for all runs.
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$root/target} CARGO_INCREMENTAL=1
export PATH="$CARGO_TARGET_DIR/tools/bin:$PATH"
# Copies build here: elsewhere a build of this folder would take the changed parts of a copy for its own, by their age.
changed=$CARGO_TARGET_DIR/changed

core=(accumulator candidate correction dissipation double_double ledger observer parameter port_sample scalar signal)
core=("${core[@]/#/lyapunov-core/src/}")
core=("${core[@]/%/.rs}")
steps=('stabilizers/src/**/*.rs')

# The tests of a file: package and target.
tests_of() {
    case $1 in
    lyapunov-core/*) echo lyapunov-core sums ;;
    stabilizers/*) echo lyapunov-steps steps ;;
    *) echo "no cheap test covers $1" >&2 && return 2 ;;
    esac
}

tool() {
    command -v cargo-mutants >/dev/null || cargo install --quiet --locked --root "$CARGO_TARGET_DIR/tools" cargo-mutants
}

# Changes files in a copy; the first argument is the folder of results, then options and files.
mutate() {
    local name=$1 package target files=() options=() status=0
    shift
    while [[ ${1:-} == --* ]]; do options+=("$1" "$2") && shift 2; done
    read -r package target < <(tests_of "$1")
    for file in "$@"; do
        [[ $(tests_of "$file") == "$package $target" ]] || { echo "$file needs other tests than $1" >&2 && return 2; }
        files+=(--file "$file")
    done
    # Changed are files of every package, not of the one in this folder only.
    tool
    # Its own run without a change would ask the package of the file for tests, so that run is here. A change may make a
    # loop endless: it is given 30 s.
    cargo test --quiet --profile mutants -p "$package" --test "$target"
    CARGO_TARGET_DIR=$changed cargo mutants --workspace --baseline skip --timeout 30 --test-package "$package" \
        --output "$CARGO_TARGET_DIR/mutants-$name" --cargo-arg=--test="$target" "${options[@]}" "${files[@]}" || status=$?
    # 2 and 3: some were missed, or made a test endless.
    case $status in 0 | 2 | 3) cat "$CARGO_TARGET_DIR/mutants-$name/mutants.out/missed.txt" ;; *) return "$status" ;; esac
}

# File, line as it is, and as it becomes: what no operator of cargo-mutants makes.
named() {
    local copy file from to package target survived=0
    copy=$(mktemp -d)
    git ls-files -z | xargs -0 cp --parents -t "$copy"
    cd "$copy"
    while IFS='|' read -r file from to; do
        [ -n "$file" ] || continue
        grep -qF -- "$from" "$file" || { echo "$file has no line with: $from" && return 2; }
        FROM=$from TO=$to perl -0pi -e 's/\Q$ENV{FROM}\E/$ENV{TO}/' "$file"
        read -r package target < <(tests_of "$file")
        if CARGO_TARGET_DIR=$changed cargo test --quiet --profile mutants -p "$package" --test "$target" \
            >"$copy/log" 2>&1; then
            echo "SURVIVED $file: $from -> $to" && survived=1
        elif grep -q '^error' "$copy/log" && ! grep -q '^test result: FAILED' "$copy/log"; then
            echo "DOES NOT BUILD $file: $from -> $to" && survived=1
        else
            echo "caught $file: $from -> $to"
        fi
        cp "$root/$file" "$file"
    done <<'CHANGES'
lyapunov-core/src/accumulator.rs|Self { sum: most, error: T::zero() }|Self { sum: most, error: self.error }
lyapunov-core/src/accumulator.rs|self.sum.smaller(most)|self.sum.larger(most)
lyapunov-core/src/accumulator.rs|.smaller(T::zero()).larger(sum)|.larger(sum)
lyapunov-core/src/accumulator.rs|raised.add(-most)|raised.add(most)
lyapunov-core/src/ledger.rs|displacement = sample.velocity.scale(period)|displacement = sample.displacement
lyapunov-core/src/dissipation.rs|& burnt.finite()|
stabilizers/src/lolc.rs|T::of(1.0) - T::of(4.0) * T::epsilon()|T::of(1.0) + T::of(4.0) * T::epsilon()
stabilizers/src/lolc.rs|T::of(1.0) - T::of(4.0) * T::epsilon()|T::of(1.0)
stabilizers/src/lolc.rs|.smaller(limit).larger(zero)|.larger(zero)
stabilizers/src/lolc.rs|.smaller(limit).larger(zero)|.smaller(limit)
stabilizers/src/lolc.rs|self.observer.ledger.credit(Requirement::NonNegative.check("budget", energy)?)|Requirement::NonNegative.check("budget", energy)?
stabilizers/src/lolc.rs|booked.credit(decrease);|
stabilizers/src/lolc.rs|Ledger::choose::<T>(accepted, self.observer.ledger, booked)|self.observer.ledger
stabilizers/src/two_port/one_way.rs|energy.above(self.received) & energy.finite()|energy.finite()
stabilizers/src/two_layer.rs|energy.above(self.received) & energy.finite()|energy.finite()
stabilizers/src/credit/windowed_credit.rs|self.sum.lower(window);|
stabilizers/src/credit/bounded_credit.rs|self.stabilizer.limit_credit(self.most);|
stabilizers/src/tank/mod.rs|.smaller(self.power)|
CHANGES
    cd "$root"
    rm -r "$copy"
    return "$survived"
}

case ${1:?all, named, sample N, rest COUNT SEED or files} in
all)
    mutate core "${core[@]}"
    mutate steps "${steps[@]}"
    ;;
sample)
    shard=0/$2
    shift 2
    if [ $# -gt 0 ]; then
        mutate sample --sharding round-robin --shard "$shard" "$@"
    else
        mutate core-sample --sharding round-robin --shard "$shard" "${core[@]}"
        mutate steps-sample --sharding round-robin --shard "$shard" "${steps[@]}"
    fi
    ;;
named) named ;;
rest)
    tool
    cargo mutants --workspace --list --json --file 'plants/src/**' --file 'lab/src/**' --file 'figures/src/**' \
        --file 'cli/src/**' >"$CARGO_TARGET_DIR/rest.json"
    CARGO_TARGET_DIR=$changed python3 scripts/mutants_rest.py "$CARGO_TARGET_DIR/rest.json" "${2:-300}" "${3:-1}" "$changed/copy"
    ;;
*) mutate "$(basename "$1" .rs)" "$@" ;;
esac
