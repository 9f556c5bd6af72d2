#!/usr/bin/env bash
# Runs the tests of all robots against the wheel that ../check.sh has built, with packages of their own under target/, 0.6 GB of them.
set -euo pipefail
cd "$(dirname "$0")"
target=${CARGO_TARGET_DIR:-$PWD/../../../target}
skipped() { printf '\n== SKIPPED: %s\n' "$*"; exit 0; }

wheels=("$target"/wheels/*.whl)
[ -e "${wheels[0]}" ] || { echo "there is no wheel in $target/wheels: run bindings/python/check.sh" >&2; exit 1; }
venv=$target/robots-venv
if [ ! -x "$venv/bin/pip" ]; then
    python3 -m venv "$venv" || skipped "the robots: python3 -m venv failed"
fi
"$venv/bin/pip" install --quiet -r requirements.txt \
    || skipped "the robots: their tools cannot be installed from the registry"
"$venv/bin/pip" install --quiet --force-reinstall --no-deps "${wheels[@]}"
tests=$PWD/tests
cd "$target"
"$venv/bin/python" -m pytest --quiet -rs -p no:cacheprovider --rootdir "$tests" "$tests"/test_{handle,robots}.py
