#!/usr/bin/env bash
# Builds the page into one file, target/web/index.html, or the file that is named; installs what that needs below target/.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
target=${CARGO_TARGET_DIR:-$here/../target}
mkdir -p "$target/web"
target=$(cd "$target" && pwd)
out=${1:-$target/web/index.html}
tools=$target/web/tools

rustup target add wasm32-unknown-unknown >/dev/null 2>&1 || true
if [ ! -d "$tools/node_modules/axe-core" ] || [ ! -d "$tools/node_modules/binaryen" ]; then
    mkdir -p "$tools"
    (cd "$tools" && npm install --silent --no-audit --no-fund --no-save esbuild@0.28 axe-core@4 binaryen)
fi

# The places of panics name files: not those of the machine that built it. The folders of other crates are there once fetched.
cargo fetch --quiet --manifest-path "$here/Cargo.toml"
places="--remap-path-prefix=$(cd "$here/.." && pwd)= --remap-path-prefix=$(rustc --print sysroot)="
for folder in "${CARGO_HOME:-$HOME/.cargo}"/registry/src/*/; do
    places+=" --remap-path-prefix=$folder="
done
# The names that functions keep until they are packed tell what each part takes.
RUSTFLAGS="-C target-feature=+simd128 -C symbol-mangling-version=v0 $places" cargo build --quiet --release --manifest-path "$here/Cargo.toml" \
    --target wasm32-unknown-unknown --target-dir "$target/web/cargo" --lib
built=$target/web/cargo/wasm32-unknown-unknown/release/lyapunov_web.wasm
node "$here/build.mjs" "$built" "$tools/node_modules" "$out"
