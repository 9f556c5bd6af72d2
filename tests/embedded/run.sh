#!/usr/bin/env bash
# The whole family on other processors: one hash everywhere, and on Cortex-M instructions, stack and flash of a step.
#   run.sh         Cortex-M4F, M7 and M0 under QEMU, and this processor in debug and release, against docs/embedded.md
#   run.sh write   the same, and writes the tables of docs/embedded.md
#   run.sh all     the same as without a word, and wasm32 (node), aarch64 and big-endian s390x (QEMU),
#                  RealtimeSanitizer, and s390x under Miri
# It installs what it needs; what cannot be had is SKIPPED, loudly.
set -euo pipefail
cd "$(dirname "$0")"
mode=${1:-boards}
root=$(cd ../.. && pwd)
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$root/target}
out=$CARGO_TARGET_DIR/embedded
mkdir -p "$out"

skipped() { printf 'SKIPPED: %s\n' "$*"; }
target() { [ -d "$(rustc --print sysroot)/lib/rustlib/$1" ] || rustup target add "$1" >/dev/null 2>&1; }
# program NAME PACKAGE...: a program, or the packages of Debian that bring it.
program() {
    command -v "$1" >/dev/null && return
    { apt-get update -qq && apt-get install -y -qq --no-install-recommends "${@:2}"; } >/dev/null 2>&1
    command -v "$1" >/dev/null
}
same() {
    if ! cmp -s "$out/host.txt" "$1"; then
        echo "$2 tells other hashes than this processor:"
        diff "$out/host.txt" "$1" | head
        return 1
    fi
    echo "$2: $(wc -l <"$1") hashes agree"
}

# board NAME TARGET MACHINE MEMORY FLAGS...
board() {
    local name=$1 machine=$3 program=$CARGO_TARGET_DIR/$2/release/board
    cargo rustc --quiet --release --features board --bin board --target "$2" -- \
        -C link-arg=-Tlink.x -L "memory/$4" "${@:5}"
    # An instruction is 256 ns of the time that the timer shows.
    qemu-system-arm -machine "$machine" -nographic -semihosting-config enable=on,target=native \
        -icount shift=8 -kernel "$program" >"$out/$name.txt"
    arm-none-eabi-objdump -d --no-show-raw-insn "$program" >"$out/$name.asm"
    cut -d ' ' -f 1-3 "$out/$name.txt" >"$out/$name.hashes"
    same "$out/$name.hashes" "Cortex-$name"
}

boards() {
    if ! target thumbv7em-none-eabihf || ! target thumbv6m-none-eabi; then
        skipped "Cortex-M4F, M7 and M0: rustup cannot add their targets here"
    elif ! program qemu-system-arm qemu-system-arm || ! program arm-none-eabi-objdump binutils-arm-none-eabi; then
        skipped "Cortex-M4F, M7 and M0: they need qemu-system-arm and arm-none-eabi-objdump"
    else
        board m4f thumbv7em-none-eabihf mps2-an386 mps2 -C target-cpu=cortex-m4
        board m7 thumbv7em-none-eabihf mps2-an500 mps2 -C target-cpu=cortex-m7
        board m0 thumbv6m-none-eabi microbit microbit
        python3 report.py $([ "$mode" != write ] || echo --write) "$(rustc --version | cut -d ' ' -f 2)" "$out"
        echo "docs/embedded.md tells what was measured; no step reaches a panic or an allocation"
    fi
}

wasm() {
    if ! target wasm32-wasip1 || ! command -v node >/dev/null; then
        skipped "wasm32: it needs the target wasm32-wasip1 and node"
        return
    fi
    for features in -simd128 +simd128; do
        cargo rustc --quiet --release --bin host --target wasm32-wasip1 -- -C target-feature=$features
        node --no-warnings wasm.mjs "$CARGO_TARGET_DIR/wasm32-wasip1/release/host.wasm" >"$out/wasm.txt"
        same "$out/wasm.txt" "wasm32, $features"
    done
}

big_endian() {
    if ! target s390x-unknown-linux-gnu || ! program qemu-s390x qemu-user ||
        ! program s390x-linux-gnu-gcc gcc-s390x-linux-gnu libc6-dev-s390x-cross; then
        skipped "s390x under QEMU: it needs the target s390x-unknown-linux-gnu, qemu-s390x and s390x-linux-gnu-gcc"
        return
    fi
    CARGO_TARGET_S390X_UNKNOWN_LINUX_GNU_LINKER=s390x-linux-gnu-gcc \
        cargo build --quiet --release --bin host --target s390x-unknown-linux-gnu
    qemu-s390x -L /usr/s390x-linux-gnu "$CARGO_TARGET_DIR/s390x-unknown-linux-gnu/release/host" >"$out/s390x.txt"
    same "$out/s390x.txt" "s390x, big-endian"
}

aarch64() {
    if ! target aarch64-unknown-linux-musl || ! program qemu-aarch64 qemu-user; then
        skipped "aarch64: it needs the target aarch64-unknown-linux-musl and qemu-aarch64"
        return
    fi
    CARGO_TARGET_AARCH64_UNKNOWN_LINUX_MUSL_LINKER=rust-lld \
        cargo build --quiet --release --bin host --target aarch64-unknown-linux-musl
    qemu-aarch64 "$CARGO_TARGET_DIR/aarch64-unknown-linux-musl/release/host" >"$out/aarch64.txt"
    same "$out/aarch64.txt" aarch64
}

nightly() { rustup toolchain install nightly --profile minimal -c miri,rust-src >/dev/null 2>&1; }

miri() {
    if ! nightly; then
        skipped "s390x under Miri: no nightly with miri can be had here"
        return
    fi
    # Miri takes its time: fewer ticks, here and there.
    "$CARGO_TARGET_DIR/release/host" 8 >"$out/host.txt"
    cargo +nightly miri run --quiet --bin host --target s390x-unknown-linux-gnu -- 8 >"$out/s390x.txt"
    same "$out/s390x.txt" "s390x under Miri, 40 ticks of each"
}

realtime() {
    if ! nightly; then
        skipped "RealtimeSanitizer: no nightly can be had here"
        return
    fi
    local program=$CARGO_TARGET_DIR/realtime/x86_64-unknown-linux-gnu/release/host
    RUSTFLAGS="--cfg realtime -Zsanitizer=realtime" cargo +nightly build --quiet --release --bin host \
        --target x86_64-unknown-linux-gnu --target-dir "$CARGO_TARGET_DIR/realtime"
    if "$program" planted >"$out/planted.txt" 2>&1 || ! grep -q "unsafe-library-call" "$out/planted.txt"; then
        echo "RealtimeSanitizer does not catch a step that allocates:"
        cat "$out/planted.txt"
        return 1
    fi
    "$program" >"$out/realtime.txt"
    same "$out/realtime.txt" "RealtimeSanitizer finds no allocation, lock or system call in a step (and the planted one), and"
}

cargo build --quiet --release --bin host
"$CARGO_TARGET_DIR/release/host" >"$out/host.txt"
# Every member is in the list, lanes are their scalar runs, and this processor without optimization.
cargo test --quiet --release
cargo run --quiet --bin host >"$out/debug.txt"
same "$out/debug.txt" "this processor in debug"
boards
if [ "$mode" = all ]; then
    wasm
    aarch64
    big_endian
    realtime
    miri
fi
