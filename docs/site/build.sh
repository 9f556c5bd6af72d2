#!/usr/bin/env bash
# Builds the documentation into target/site, with the page that web/build.sh made in the chapters of its book; installs MkDocs
# below target/.
set -euo pipefail
root=$(cd "$(dirname "$0")/../.." && pwd)
target=${CARGO_TARGET_DIR:-$root/target}
target=$(cd "$target" && pwd)
page=$target/web/index.html
[ -f "$page" ] || { echo "the page is not built yet: run web/build.sh first"; exit 1; }
tools=$target/web/site-tools
if [ ! -x "$tools/bin/mkdocs" ]; then
    python3 -m venv "$tools"
    "$tools/bin/pip" install --quiet "mkdocs==1.6.*" "latex2mathml==3.*" "pygments==2.*"
fi
# Warnings are errors; quiet, it would not count them.
told=$(LYAPUNOV_PAGE=$page "$tools/bin/mkdocs" build --strict --clean --config-file "$root/mkdocs.yml" --site-dir "$target/site" 2>&1) ||
    { echo "$told"; exit 1; }
echo "$target/site/index.html"
