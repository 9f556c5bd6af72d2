#!/usr/bin/env bash
# Builds the wheel and checks it: tests, types, the command. Run it from anywhere; it installs what it needs under target/.
set -euo pipefail
cd "$(dirname "$0")"
target=${CARGO_TARGET_DIR:-$PWD/../../target}
export CARGO_TARGET_DIR=$target CARGO_INCREMENTAL=0

skipped() { printf '\n== SKIPPED: %s\n' "$*"; exit 0; }
step() { printf '\n== %s\n' "$*"; "$@"; }

python=$(command -v python3) || skipped "the Python package: there is no python3"
"$python" -c 'import sys; sys.exit(sys.version_info < (3, 10))' || skipped "the Python package: $("$python" --version) is older than 3.10"
venv=$target/python-venv
if [ ! -x "$venv/bin/pip" ]; then
    "$python" -m venv "$venv" || skipped "the Python package: python3 -m venv failed"
fi
"$venv/bin/pip" install --quiet 'maturin>=1.9,<2' -r requirements.txt \
    || skipped "the Python package: its tools cannot be installed from the registry"
export VIRTUAL_ENV=$venv PATH=$venv/bin:$PATH

# In the profile of the tests, whose dependencies it finds built as far as their features agree. The lab has others, is built again
# for it, and takes less to build without optimization than what is asked of it here takes longer.
export CARGO_PROFILE_DEV_OPT_LEVEL=0
rm -rf "$target/wheels"
step maturin build --quiet --profile dev --out "$target/wheels"
pip install --quiet --force-reinstall --no-deps "$target"/wheels/*.whl
step mypy --strict python/lyapunov
step mypy --strict tests/typed.py
step pyright --pythonpath "$venv/bin/python" python/lyapunov tests/typed.py
# Stubs and the compiled part name the same things with the same arguments, in the wheel.
stubs() { (cd "$target" && python -m mypy.stubtest lyapunov._lyapunov --concise --allowlist <(echo 'lyapunov\._lyapunov\.__all__')); }
step stubs
# From a folder without the sources, so that it is the wheel that is tested.
here=$PWD
cd "$target"
step python -m pytest --quiet -rs --durations=8 -p no:cacheprovider --rootdir "$here" "$here/tests" \
    "$here"/examples/tests/test_{handle,notebooks}.py
