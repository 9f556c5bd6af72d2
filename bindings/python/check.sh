#!/usr/bin/env bash
# Builds the wheel and checks it: tests, types, the command; with `long` under valgrind too. Run it from anywhere; it installs
# what it needs under target/.
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
if [ "${1:-}" = long ]; then
    memory() {
        command -v valgrind >/dev/null || { echo "SKIPPED: valgrind is not here (Debian: valgrind)"; return; }
        PYTHONMALLOC=malloc valgrind --log-file="$target/valgrind.log" --num-callers=100 --leak-check=full --show-leak-kinds=definite,possible \
            python -m pytest --quiet -p no:cacheprovider --rootdir "$here" "$here"/tests/test_{blocks,batch,copies,hostile,refusals}.py
        python - "$target/valgrind.log" <<'END'
import re, sys

# Python itself reads what it never wrote. What is made once, where the module begins, is never given back; that it is told shows
# that the library's frames are seen.
records = re.split(r"^==\d+== *\n", open(sys.argv[1]).read(), flags=re.M)
ours = [record for record in records if "_lyapunov.abi3.so" in record or ".rs:" in record]
begun = [record for record in ours if "lost in loss record" in record and "__pyo3_module_exec" in record]
faults = [record for record in ours if record not in begun and "possibly lost" not in record]
assert begun, "valgrind does not see the library"
sys.exit("\n".join(faults) if faults else print(f"valgrind: {len(records)} records, none of them a fault of the library"))
END
    }
    step memory
fi
