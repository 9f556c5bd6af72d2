#!/bin/sh
# Instructions and bytes of flash of steps in f32 on a Cortex-M4F, counted in the disassembly.
# Needs the target (`rustup target add thumbv7em-none-eabihf`) and llvm-objdump (Debian: llvm).
set -eu
cd "$(dirname "$0")/.."
target=thumbv7em-none-eabihf
cargo rustc --quiet --release -p lyapunov-cortex-m --target $target -- -C target-cpu=cortex-m4 -C codegen-units=1
llvm-objdump -d --no-show-raw-insn target/$target/release/liblyapunov_cortex_m.rlib 2>/dev/null | awk '
    /^[0-9a-f]+ <_ZN/ {
        name = $2; sub(/^<_ZN17lyapunov_cortex_m[0-9]+/, "", name); sub(/17h[0-9a-f]+E>:$/, "", name)
        count[name] = 0; order[++steps] = name
    }
    # A literal of the pool is data: its bytes count, and it is no instruction.
    /^ +[0-9a-f]+:/ {
        bytes[name] = strtonum("0x" substr($1, 1, length($1) - 1))
        last[name] = /\.word/ || /\.w[ \t]/ || /\tv/ || /\tbl\t/ || /mov[wt]\t/ ? 4 : 2
        if (!/\.word/) { count[name]++; branches[name] += /\tbl\t/ }
    }
    END {
        printf "%-12s %12s %6s %6s\n", "step", "instructions", "bytes", "calls"
        for (at = 1; at <= steps; at++) {
            name = order[at]
            printf "%-12s %12d %6d %6d\n", name, count[name], bytes[name] + last[name], branches[name]
        }
    }'
