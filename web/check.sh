#!/usr/bin/env bash
# Builds the page and the docs around it and looks at both in a headless Chromium; says SKIPPED where one of the tools cannot be had.
# The page is compared with the command that is named; without a name that is built.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/.." && pwd)
target=${CARGO_TARGET_DIR:-$root/target}
mkdir -p "$target"
target=$(cd "$target" && pwd)

skipped() { printf 'SKIPPED: the page: %s\n' "$*"; exit 0; }
for tool in node npm xz; do command -v "$tool" >/dev/null || skipped "it needs $tool"; done
chromium=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || skipped "it needs chromium"
sysroot=$(rustc --print sysroot)
[ -d "$sysroot/lib/rustlib/wasm32-unknown-unknown" ] || rustup target add wasm32-unknown-unknown >/dev/null 2>&1 ||
    skipped "the target wasm32-unknown-unknown cannot be had here (rustup target add failed)"

command=${1:+$(cd "$(dirname "$1")" && pwd)/$(basename "$1")}
if [ -z "$command" ]; then
    (cd "$root" && cargo build --quiet -p lyapunov-cli)
    command=$target/debug/lyapunov
fi
cargo fmt --manifest-path "$here/Cargo.toml" --check
"$here/build.sh"
book=$root/docs/book
cargo fmt --manifest-path "$book/Cargo.toml" --check
CARGO_TARGET_DIR=$target cargo test --quiet --manifest-path "$book/Cargo.toml" --doc
"$root/docs/site/build.sh"
node "$here/test.mjs" "$target/web/index.html" "$command" "$chromium" "$target/web/tools"
