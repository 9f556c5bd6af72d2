#!/usr/bin/env bash
# Measures again what the docs say about time, and keeps a history of the ratios.
#
#   scripts/measure.sh [--date YYYY-MM-DD] [PART…]
#
# Parts, all by default: step, stabilizers, plant, lanes, scene, map (criterion's benches), boxes (lanes of boxes), prices,
# accuracy, peers. A part rewrites its tables in the docs, between the comments `<!-- measured: NAME -->` and
# `<!-- end -->`. The ratios of the benches go to benches/history.csv, a row each, with the date of the commit unless
# another is given, and docs/benches.md and docs/figures/benches.svg are drawn from that. Run it on a machine that does
# nothing else.
# Needs python3; the part `peers` installs its Python packages into target/peers-python.
set -euo pipefail
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-target}
results=$PWD/$target/measured
[ "${target#/}" = "$target" ] || results=$target/measured
benches=(step stabilizers plant lanes scene map)
reports=(boxes prices accuracy peers)

date= parts=()
while [ $# -gt 0 ]; do
    case $1 in
        --date) date=${2:?"--date needs a day, as in --date 2026-01-31"}; shift 2 ;;
        -h | --help) sed -n '2,/^set /{/^set /!s/^# \{0,1\}//p}' "$0"; exit ;;
        *) parts+=("$1"); shift ;;
    esac
done
[ ${#parts[@]} -gt 0 ] || parts=("${benches[@]}" "${reports[@]}")
for part in "${parts[@]}"; do
    case " ${benches[*]} ${reports[*]} " in
        *" $part "*) ;;
        *) echo "there is no part \`$part\`; the parts are ${benches[*]} ${reports[*]}" >&2; exit 2 ;;
    esac
done
command -v python3 >/dev/null || { echo "SKIPPED: the tables, since there is no python3" >&2; exit 1; }

lyapunov() { cargo run --quiet --release -p lyapunov-cli -- "$@"; }

# What a part prints, in a file of its own that is there only when it is complete.
into() {
    local file=$results/$1
    shift
    "$@" >"$file.part"
    mv "$file.part" "$file"
}

mkdir -p "$results"
measured=()
for part in "${parts[@]}"; do
    echo "== $part" >&2
    case $part in
        step | stabilizers | plant | lanes) package=lyapunov ;;
        *) package=lyapunov-lab ;;
    esac
    case $part in
        step | stabilizers | plant | lanes | scene | map)
            # Estimates of an older build would stand beside these.
            rm -rf "${results:?}/criterion/$part"
            CRITERION_HOME=$results/criterion/$part cargo bench --quiet -p $package --bench "$part" -- --noplot >&2
            ;;
        boxes) into boxes.md cargo bench --quiet -p lyapunov-lab --bench lanes ;;
        prices) into prices.txt lyapunov effects ;;
        accuracy)
            for scene in paper-8k-lolc paper-8k-none; do
                into "accuracy-$scene.json" lyapunov accuracy "scenes/$scene.toml" --json
            done
            ;;
        peers)
            benches/peers/python/install.sh >/dev/null
            into peers.txt cargo run --quiet --release -p lyapunov-peers
            ;;
    esac
    measured+=("$part")
done
python3 scripts/measure/main.py --results "$results" ${date:+--date "$date"} "${measured[@]}"
