#!/usr/bin/env bash
# Sets up target/peers-python with the packages of requirements.txt. A package that cannot be installed is reported and
# left out; its rows are then SKIPPED.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
environment=$here/../../../target/peers-python
python3 -m venv "$environment"
while read -r package; do
    "$environment/bin/pip" install --quiet "$package" || echo "SKIPPED: $package cannot be installed here" >&2
done < "$here/requirements.txt"
"$environment/bin/pip" list
