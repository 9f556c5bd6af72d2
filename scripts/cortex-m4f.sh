#!/bin/sh
# Instructions and bytes of flash of steps in f32 on a Cortex-M4F, counted in the disassembly.
# Needs the target (`rustup target add thumbv7em-none-eabihf`), llvm-objdump and llvm-size (Debian: llvm).
set -eu
cd "$(dirname "$0")/.."
target=thumbv7em-none-eabihf
cargo rustc --quiet --release -p lyapunov-cortex-m --target $target -- -C target-cpu=cortex-m4 -C codegen-units=1
code=target/$target/release/liblyapunov_cortex_m.rlib
{ llvm-size -A $code 2>/dev/null; llvm-objdump -d --no-show-raw-insn $code 2>/dev/null; } | awk '
    function named(symbol) {
        sub(/^.*lyapunov_cortex_m[0-9]+/, "", symbol)
        sub(/17h[0-9a-f]+E.*$/, "", symbol)
        return symbol
    }
    # The section of a function has its constants too.
    /^\.text\._ZN/ { bytes[named($1)] = $2 }
    /^[0-9a-f]+ <_ZN/ { name = named($2); order[++steps] = name }
    /^ +[0-9a-f]+:/ && !/\.word/ && !/\tnop/ { count[name]++; calls[name] += /\tbl\t/ }
    END {
        printf "%-12s %12s %6s %6s\n", "step", "instructions", "calls", "bytes"
        for (at = 1; at <= steps; at++) {
            name = order[at]
            printf "%-12s %12d %6d %6d\n", name, count[name], calls[name], bytes[name]
        }
    }'
