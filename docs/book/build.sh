#!/usr/bin/env bash
# Builds the book into target/book from the chapters and the page that web/build.sh made; installs MkDocs below target/.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
target=${CARGO_TARGET_DIR:-$here/../../target}
target=$(cd "$target" && pwd)
page=$target/web/index.html
[ -f "$page" ] || { echo "the page is not built yet: run web/build.sh first"; exit 1; }
tools=$target/web/book-tools
if [ ! -x "$tools/bin/mkdocs" ]; then
    python3 -m venv "$tools"
    "$tools/bin/pip" install --quiet "mkdocs==1.6.*" "latex2mathml==3.*" "pygments==2.*"
fi
"$tools/bin/mkdocs" build --quiet --strict --clean --config-file "$here/mkdocs.yml" --site-dir "$target/book"
cp "$page" "$target/book/touch.html"
echo "$target/book/index.html"
