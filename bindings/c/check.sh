#!/usr/bin/env bash
# The checks of the library for C and C++ that fit into every run; `check.sh long` takes more ticks and more machines, and runs Miri.
# Installs what it needs where apt-get can. A check that cannot run says SKIPPED and why.
set -euo pipefail
cd "$(dirname "$0")"

long=${1:-}
host_ticks=$([ "$long" = long ] && echo 1000000 || echo 20000)
bare_ticks=$([ "$long" = long ] && echo 10000 || echo 100)
bare_targets=(thumbv7em-none-eabihf)
# The M7 runs the M4F's program, as it takes its library.
boards=("mps2-an386 cortex-m4" "mps2-an500 cortex-m4")
if [ "$long" = long ]; then
    bare_targets+=(thumbv6m-none-eabi)
    # A Cortex-M3, which has the M0's instructions and more: QEMU's M0 has no room for all blocks.
    boards+=("mps2-an385 cortex-m0")
fi
out=$PWD/target/check
mkdir -p "$out"
rm -f "$out"/*.elf
export CARGO_TARGET_DIR=$PWD/target

step() { printf '\n== %s\n' "$1"; }
skipped() { printf '\n== SKIPPED: %s\n' "$*"; }
have() { command -v "$1" >/dev/null; }

install_what_is_missing() {
    local packages=()
    have clang || packages+=(clang)
    have cmake || packages+=(cmake)
    have valgrind || packages+=(valgrind)
    have pkg-config || packages+=(pkg-config)
    have arm-none-eabi-gcc || packages+=(gcc-arm-none-eabi libnewlib-arm-none-eabi)
    have qemu-system-arm || packages+=(qemu-system-arm)
    [ -d /usr/include/eigen3 ] || packages+=(libeigen3-dev)
    [ ${#packages[@]} -eq 0 ] && return
    have apt-get && [ "$(id -u)" = 0 ] || return 0
    { apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -qq -y "${packages[@]}"; } >"$out/apt.log" 2>&1 ||
        echo "apt-get could not install: ${packages[*]}"
}

archive() { # of a target, or of this machine
    cargo rustc --quiet --release --features library --crate-type "${2:-staticlib}" ${1:+--target "$1"}
}

warnings=(-Wall -Wextra -Wpedantic -Wconversion -Werror -Wno-psabi)

compiles_without_a_warning() {
    local compiler file standard
    for compiler in gcc clang; do
        have $compiler || { skipped "$compiler is not here: nothing is compiled with it"; continue; }
        for standard in c99 c11; do
            for file in examples/*.c tests/c/hard.c tests/c/equal.c; do
                $compiler -std=$standard "${warnings[@]}" -Iinclude -fsyntax-only "$file"
            done
        done
    done
    for compiler in g++ clang++; do
        have $compiler || { skipped "$compiler is not here: nothing is compiled with it"; continue; }
        for file in examples/*.cpp; do
            $compiler -std=c++17 -fno-exceptions "${warnings[@]}" -Iinclude -fsyntax-only "$file"
            [ -d /usr/include/eigen3 ] &&
                $compiler -std=c++17 "${warnings[@]}" -Iinclude -isystem /usr/include/eigen3 -fsyntax-only "$file"
        done
        echo '#include <lyapunov.h>' | $compiler -std=c++17 -x c++ "${warnings[@]}" -Iinclude -fsyntax-only -
    done
}

tells_in_one_error_why_it_does_not_compile() { # flags, the error's beginning
    local compiler
    for compiler in g++ clang++; do
        have $compiler || continue
        # shellcheck disable=SC2086
        if echo '#include <lyapunov.hpp>' | $compiler $1 -Iinclude -x c++ -fsyntax-only - 2>"$out/told.log" ||
            ! grep -q "error: .*$2" "$out/told.log" || [ "$(grep -c 'error:' "$out/told.log")" != 1 ]; then
            echo "$compiler $1 has not the one error '$2':"
            cat "$out/told.log"
            return 1
        fi
    done
}

warns_of_a_refusal_that_nobody_looks_at() {
    local compiler init='lyapunov_popc_f32_init(storage, given);'
    for compiler in gcc clang; do
        have $compiler || continue
        # Compiled to the end: gcc does not warn where it only looks at the syntax.
        if echo "#include <lyapunov.h>
            void ignores(lyapunov_popc_f32 *storage, const lyapunov_popc_f32_parameters *given) { $init }" |
            $compiler -std=c99 -Werror=unused-result -Iinclude -x c -S -o /dev/null - 2>"$out/ignored.log"; then
            echo "$compiler does not warn where the status of init is ignored"
            return 1
        fi
        grep -q 'unused-result' "$out/ignored.log" || { cat "$out/ignored.log"; return 1; }
    done
}

refused_to_compile() { # compiler, cases in the words of the classes' test, flags
    local compiler=$1 case
    for case in $2; do
        if $compiler -std=c++17 -Werror=unused-result -Iinclude "${@:3}" -DREFUSED="$case" -fsyntax-only tests/c/classes.cpp 2>"$out/refused.log"; then
            echo "tests/c/classes.cpp compiles with REFUSED=$case: numbers that are not the vector's are read, a refusal is not looked at, or there is no such signal"
            return 1
        fi
        grep -qE 'numbers one after another|numbers of a matrix have no order|nodiscard|1, 3 or 6 axes' "$out/refused.log" || { cat "$out/refused.log"; return 1; }
    done
}

classes() { # what they take and answer, and what must not compile
    local compiler standard eigen=(-DWITH_EIGEN -isystem /usr/include/eigen3)
    [ -d /usr/include/eigen3 ] || { skipped "classes with Eigen's vectors: Eigen is not here"; eigen=(); }
    for compiler in g++ clang++; do
        have $compiler || { skipped "classes with $compiler: it is not here"; continue; }
        for standard in c++17 c++20; do
            $compiler -std=$standard -g "${warnings[@]}" -fsanitize=address,undefined -fno-sanitize-recover=all -Iinclude "${eigen[@]}" \
                tests/c/classes.cpp "$library" -lm -o "$out/classes"
            "$out/classes"
        done
        refused_to_compile $compiler "1 2 3 8 9"
        [ ${#eigen[@]} -eq 0 ] || refused_to_compile $compiler "4 5 6 7" "${eigen[@]}"
    done
}

shares() { # of a shared library, what it exports
    nm -D --defined-only "$1" | awk '$2 == "T" && $3 ~ /^lyapunov_/ { print $3 }' | sort
}

exports_what_the_header_says() {
    grep -o '^LYAPUNOV_API [^;]*(' include/lyapunov.h | sed 's/($//; s/.*[ *]//' | sort >"$out/declared"
    shares target/release/liblyapunov_c.so >"$out/exported"
    diff "$out/declared" "$out/exported"
}

installs() { # where find_package and pkg-config find it
    if ! have cmake || ! have pkg-config; then
        skipped "installing: it needs cmake and pkg-config"
        return
    fi
    rm -rf "$out/prefix" "$out/installed"
    if ! {
        cmake -S . -B "$out/built" -DLYAPUNOV_BUILT="$CARGO_TARGET_DIR" -DCMAKE_INSTALL_PREFIX="$out/prefix" &&
            cmake --build "$out/built" && cmake --install "$out/built" &&
            cmake -S examples -B "$out/installed" -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$out/prefix" &&
            cmake --build "$out/installed"
    } >"$out/install.log" 2>&1; then
        cat "$out/install.log"
        return 1
    fi
    if [ -e "$out/installed/lyapunov" ]; then
        echo "find_package did not find what was installed: the examples built the library anew"
        return 1
    fi
    # shellcheck disable=SC2046
    gcc -std=c99 examples/own_candidate.c -o "$out/own_candidate" \
        $(PKG_CONFIG_PATH="$out/prefix/lib/pkgconfig" pkg-config --cflags --libs lyapunov)
    "$out/own_candidate" >/dev/null
    echo "find_package and pkg-config find it"
    # The examples install nothing of their own, and so nothing at all.
    rm -rf "$out/nothing"
    cmake --install "$out/examples" --prefix "$out/nothing" >"$out/install.log"
    if [ -e "$out/nothing" ]; then
        echo "a project that has this folder by add_subdirectory installs the library's files as its own"
        return 1
    fi
}

bytes_are_equal() { # how many ticks
    local rust
    target/release/lyapunov-equal "$1" >"$out/equal.rust" &
    rust=$!
    "$out/equal" "$1" >"$out/equal.c"
    wait $rust
    diff "$out/equal.rust" "$out/equal.c"
    echo "$(wc -l <"$out/equal.rust") blocks, $1 ticks each: equal"
}

bare() { # output, flags of the processor, sources
    local output=$1 flags=$2
    shift 2
    # shellcheck disable=SC2086
    arm-none-eabi-gcc $flags -mthumb -std=c11 -Iinclude -ffunction-sections -fdata-sections "$@" -Wl,--gc-sections,-z,noexecstack -o "$output"
}

no_panic_is_linked() {
    ! arm-none-eabi-nm -C "$1" | grep -iE 'panic|rust_begin_unwind|core::fmt|__rust_alloc'
}

flash() { # target, flags, its name in the README: bytes of code and of memory beyond a loop without a stabilizer, as the README has them
    local name
    for name in empty by_hand small; do
        bare "$out/$name.elf" "$2" -Os -nostartfiles -Wl,--entry=loop "tests/bare/$name.c" "target/$1/release/liblyapunov_c.a"
    done
    no_panic_is_linked "$out/small.elf"
    arm-none-eabi-size "$out/empty.elf" "$out/by_hand.elf" "$out/small.elf" | awk -v target="$1" -v row="$(grep "^| $3 |" README.md)" '
        # Other versions of the compilers give a few bytes more or less.
        function differs(now, told) { return now < 0.96 * told || now > 1.04 * told }
        BEGIN { split(row, told, "|") }
        NR == 2 { text = $1; data = $2 + $3 }
        NR > 2 {
            at = NR == 3 ? 4 : 3
            flash = $1 - text; memory = $2 + $3 - data
            printf "%s %-8s %5d bytes of flash, %3d of memory\n", target, NR == 3 ? "by hand" : "library", flash, memory
            if (differs(flash, told[at]) || differs(memory, told[at + 2])) {
                printf "README.md has%s and%s\n", told[at], told[at + 2]
                failed = 1
            }
        }
        END { exit failed }'
}

example_in_flash() { # flags of the Cortex-M4F: bytes of the README's first example, as its table has them
    local row flags told now failed=0
    while IFS='|' read -r row flags; do
        # shellcheck disable=SC2086
        bare "$out/example.elf" "$1" -Os -nostartfiles -Wl,--entry=loop $flags tests/bare/example.c target/thumbv7em-none-eabihf/release/liblyapunov_c.a
        no_panic_is_linked "$out/example.elf"
        now=$(arm-none-eabi-size "$out/example.elf" "$out/empty.elf" | awk 'NR == 2 { now = $1 } NR == 3 { print now - $1 }')
        told=$(grep "^| $row |" README.md | awk -F'|' '{ print $3 + 0 }')
        echo "the first example, $row: $now bytes of flash"
        if [ $((100 * now)) -lt $((96 * told)) ] || [ $((100 * now)) -gt $((104 * told)) ]; then
            echo "README.md has $told bytes of it"
            failed=1
        fi
    done <<'END'
as above|-DTEXT
without the text of a refusal|
with a constant limit|-DCONSTANT_LIMIT -DTEXT
with a constant limit, without the text|-DCONSTANT_LIMIT
END
    return $failed
}

on_a_microcontroller() {
    local target processor name flags board at running=() failed=0
    if ! have arm-none-eabi-gcc; then
        skipped "microcontrollers: arm-none-eabi-gcc is not here (Debian: gcc-arm-none-eabi, libnewlib-arm-none-eabi)"
        return
    fi
    for target in "${bare_targets[@]}"; do
        if ! [ -d "$(rustc --print sysroot)/lib/rustlib/$target" ] && ! rustup target add $target >/dev/null 2>&1; then
            skipped "$target: the target cannot be had here (rustup target add failed)"
            continue
        fi
        step "$target"
        archive $target
        case $target in
            thumbv6m*) processor=cortex-m0 name=Cortex-M0 flags=-mcpu=cortex-m0 ;;
            *) processor=cortex-m4 name=Cortex-M4F flags="-mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard" ;;
        esac
        flash $target "$flags" $name
        [ $name != Cortex-M4F ] || example_in_flash "$flags"
        have qemu-system-arm || { skipped "running on $processor: qemu-system-arm is not here"; continue; }
        bare "$out/$processor.elf" "$flags" -O1 --specs=rdimon.specs -nostartfiles -T tests/bare/mps2.ld \
            tests/bare/start.c tests/c/equal.c "$(arm-none-eabi-gcc $flags -mthumb -print-file-name=crti.o)" \
            "$(arm-none-eabi-gcc $flags -mthumb -print-file-name=rdimon-crt0.o)" "target/$target/release/liblyapunov_c.a" \
            "$(arm-none-eabi-gcc $flags -mthumb -print-file-name=crtn.o)"
    done
    target/release/lyapunov-equal "$bare_ticks" >"$out/equal.bare"
    # At once: each takes one processor for minutes.
    for board in "${boards[@]}"; do
        # shellcheck disable=SC2086
        equals_on_a_board $board >"$out/${board% *}.log" 2>&1 &
        running+=($!)
    done
    for at in "${!boards[@]}"; do
        wait "${running[at]}" || failed=1
        cat "$out/${boards[at]% *}.log"
    done
    return $failed
}

equals_on_a_board() { # board, processor that the program is for
    local started=$SECONDS
    [ -f "$out/$2.elf" ] || { skipped "$2 on $1: there is no program for it, see above"; return; }
    timeout 5400 qemu-system-arm -M "$1" -nographic -monitor none -serial none \
        -semihosting-config enable=on,target=native,arg=equal,arg="$bare_ticks" -kernel "$out/$2.elf" | diff "$out/equal.bare" -
    echo "$2 on $1: $(wc -l <"$out/equal.bare") blocks, $bare_ticks ticks each: equal; $((SECONDS - started)) s"
}

install_what_is_missing

# Beside the build of the library, which keeps one processor busy.
lints_and_tests() {
    step "formatting and lints"
    cargo fmt --all --check
    cargo clippy --quiet --features describe --all-targets -- -D warnings
    step "the header and its classes are those of the functions, and keep what compiled programs rely on"
    cargo test --quiet --features describe
}
(lints_and_tests) >"$out/lints.log" 2>&1 &
lints=$!

step "the library"
archive
# For what it exports, and for what a step costs.
archive "" cdylib
cargo build --quiet --release -p lyapunov-equal --bins
step "what it exports"
exports_what_the_header_says
step "no warning"
compiles_without_a_warning
warns_of_a_refusal_that_nobody_looks_at
tells_in_one_error_why_it_does_not_compile -std=c++14 'lyapunov.hpp needs C++17'
tells_in_one_error_why_it_does_not_compile '-std=c++17 -DStatus=int' 'a macro Status'
tells_in_one_error_why_it_does_not_compile '-std=c++17 -Dread(a,b,c)=a' 'a macro read'
library=target/release/liblyapunov_c.a
step "examples by cmake"
if have cmake; then
    cmake -S examples -B "$out/examples" -DCMAKE_BUILD_TYPE=Release -DLYAPUNOV_BUILT="$CARGO_TARGET_DIR" >"$out/cmake.log" || { cat "$out/cmake.log"; exit 1; }
    cmake --build "$out/examples"
else
    skipped "the examples by cmake: cmake is not here"
fi
step "installed, and found again"
installs
step "classes"
classes
step "hard inputs"
for compiler in gcc clang; do
    have $compiler || { skipped "hard inputs with $compiler: it is not here"; continue; }
    $compiler -std=c11 -g "${warnings[@]}" -fsanitize=address,undefined -fno-sanitize-recover=all -Iinclude tests/c/hard.c $library -lm -o "$out/hard"
    "$out/hard"
    $compiler -std=c11 -g -fsanitize=address,undefined -fno-sanitize-recover=all -Iinclude tests/c/equal.c $library -o "$out/equal.$compiler"
    "$out/equal.$compiler" 200 >"$out/equal.short"
    target/release/lyapunov-equal 200 | diff - "$out/equal.short"
    echo "$compiler, address and undefined behaviour: $(wc -l <"$out/equal.short") blocks, 200 ticks each: no finding, equal"
done
gcc -O1 -std=c11 "${warnings[@]}" -Iinclude tests/c/equal.c $library -o "$out/equal"
if have valgrind; then
    gcc -std=c11 -g -Iinclude tests/c/hard.c $library -lm -o "$out/hard"
    for program in hard equal; do
        valgrind --quiet --error-exitcode=1 "$out/$program" 20 >"$out/valgrind.log" ||
            { head -100 "$out/valgrind.log"; exit 1; }
    done
    echo "valgrind: hard inputs, and $(wc -l <"$out/valgrind.log") blocks over 20 ticks: no finding"
else
    skipped "hard inputs under valgrind: it is not here"
fi
step "C equals Rust"
bytes_are_equal "$host_ticks"
on_a_microcontroller
wait $lints || { cat "$out/lints.log"; exit 1; }
cat "$out/lints.log"
# Those machines for which the library is built by now, or all of them.
if [ "$long" = long ]; then tests/frames.sh long; else tests/frames.sh "$(uname -m)-linux" cortex-m4f; fi
step "what a step costs through C"
tests/cost.sh
[ "$long" = long ] || exit 0
step "every byte is initialised (Miri)"
cargo +nightly miri --version >/dev/null 2>&1 || rustup component add --toolchain nightly miri rust-src >/dev/null 2>&1 || true
if cargo +nightly miri --version >/dev/null 2>&1; then
    # The padding of a block would be read here before it is written. For s390x: on x86-64 libm has assembly, which Miri cannot run.
    MIRIFLAGS=-Zmiri-disable-isolation cargo +nightly miri test --quiet --target s390x-unknown-linux-gnu --target-dir target/miri --test bytes
else
    skipped "Miri: it is not here (rustup component add miri rust-src --toolchain nightly)"
fi
