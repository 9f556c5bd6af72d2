#!/usr/bin/env bash
# Archives without Rust, units of FMI, the controller of ros2_control: called by check.sh, after the library is built.
# `frames.sh long` builds every archive; else those of the machines that are given.
set -euo pipefail
cd "$(dirname "$0")/.."

export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}
library=$CARGO_TARGET_DIR/release/liblyapunov_c.a
out=$PWD/target/check/frames
rm -rf "$out"
mkdir -p "$out"

step() { printf '\n== %s\n' "$1"; }
skipped() { printf '\n== SKIPPED: %s\n' "$*"; }
have() { command -v "$1" >/dev/null; }

# The folders of PATH in which there is no Rust.
without_rust() {
    local folder kept=()
    while IFS= read -rd: folder; do
        [ -e "$folder/cargo" ] || [ -e "$folder/rustc" ] || [ -e "$folder/rustup" ] || kept+=("$folder")
    done <<<"$PATH:"
    (IFS=: && echo "${kept[*]}")
}

unpacked() { # of a machine: the archive's folder
    tar -xzf target/release-archives/lyapunov-*-"$1".tar.gz -C "$out"
    echo "$out"/lyapunov-*-"$1"
}

archive_builds_a_program() { # machine, folder of the archive
    local what=$1 folder=$2
    env -i HOME="$out" PATH="$plain" cmake -S "$folder/examples" -B "$folder/build" -DCMAKE_BUILD_TYPE=Release >"$out/cmake.log" ||
        { cat "$out/cmake.log"; return 1; }
    env -i HOME="$out" PATH="$plain" cmake --build "$folder/build" >"$out/build.log" 2>&1 || { cat "$out/build.log"; return 1; }
    echo "$what: $(grep -c '^.*Running ' "$out/build.log") examples built and run from the archive, without Rust"
}

bare_archive_links() { # machine, flags
    local folder
    folder=$(unpacked "$1")
    # shellcheck disable=SC2086
    env -i PATH="$plain" arm-none-eabi-gcc $2 -mthumb -Os -std=c11 -I"$folder/include" -nostartfiles -ffunction-sections \
        -Wl,--entry=loop,--gc-sections tests/bare/small.c "$folder/lib/liblyapunov_c.a" -Wl,-z,noexecstack -o "$out/$1.elf" 2>"$out/ld.log" || { cat "$out/ld.log"; return 1; }
    echo "$1: linked from the archive, without Rust; $(arm-none-eabi-readelf -A "$out/$1.elf" | sed -n 's/^ *Tag_CPU_name: //p')"
}

archives_need_no_rust() {
    local machine plain folder code=0
    ./release.sh "$@" >"$out/release.log" || code=$?
    if [ $code != 0 ]; then
        cat "$out/release.log"
        [ $code = 3 ] || return 1
        skipped "some archives, see above"
    fi
    (cd target/release-archives && sha256sum --check --quiet SHA256SUMS)
    plain=$(without_rust)
    if PATH=$plain have cargo || ! PATH=$plain have cmake || ! PATH=$plain have cc; then
        skipped "programs without Rust: cmake or cc are beside cargo in PATH"
        return
    fi
    for machine in "$@"; do
        [ -f "$(echo target/release-archives/lyapunov-*-"$machine".tar.gz)" ] || continue
        case $machine in
            "$(uname -m)-linux")
                folder=$(unpacked "$machine")
                archive_builds_a_program "$machine" "$folder"
                # The same program by pkg-config.
                if have pkg-config; then
                    # shellcheck disable=SC2046
                    env -i PATH="$plain" PKG_CONFIG_PATH="$folder/lib/pkgconfig" sh -c \
                        "cc $folder/examples/wall.c \$(pkg-config --cflags --libs lyapunov) -o $out/wall && $out/wall" >/dev/null
                    echo "$machine: the C example built by pkg-config and run"
                fi
                ;;
            aarch64-linux)
                if have aarch64-linux-gnu-gcc && have qemu-aarch64; then
                    folder=$(unpacked "$machine")
                    env -i PATH="$plain" aarch64-linux-gnu-gcc -O2 -static -I"$folder/include" "$folder/examples/wall.c" \
                        "$folder/lib/liblyapunov_c.a" -o "$out/wall.aarch64"
                    qemu-aarch64 "$out/wall.aarch64" >"$out/wall.log" || { cat "$out/wall.log"; return 1; }
                    echo "$machine: the C example built from the archive and run by qemu-aarch64"
                else
                    skipped "running the archive of $machine: it needs aarch64-linux-gnu-gcc and qemu-aarch64 (Debian: gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user)"
                fi
                ;;
            *)
                have arm-none-eabi-gcc || { skipped "linking the archive of $machine: arm-none-eabi-gcc is not here"; continue; }
                case $machine in
                    cortex-m0) bare_archive_links $machine "-mcpu=cortex-m0" ;;
                    cortex-m4f) bare_archive_links $machine "-mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -mfloat-abi=hard" ;;
                    cortex-m7) bare_archive_links $machine "-mcpu=cortex-m7 -mfpu=fpv5-d16 -mfloat-abi=hard" ;;
                    *) skipped "running the archive of $machine on this machine" ;;
                esac
                ;;
        esac
    done
}

units_of_fmi() {
    local venv=$CARGO_TARGET_DIR/fmu-venv
    if ! [ -x "$venv/bin/pip" ] && ! python3 -m venv "$venv" 2>"$out/venv.log"; then
        skipped "units of FMI: python3 -m venv failed (Debian: python3-venv)"
        return
    fi
    if ! "$venv/bin/python" -c 'import fmpy' 2>/dev/null && ! "$venv/bin/pip" install --quiet 'fmpy>=0.3.22,<0.4' 2>"$out/pip.log"; then
        skipped "units of FMI: fmpy, which has the headers and runs them, cannot be installed from the registry"
        return
    fi
    [ "$(uname -s)" = Linux ] || { skipped "units of FMI: they are built for Linux"; return; }
    PATH=$venv/bin:$PATH fmu/build.sh "$library" target/fmu
    cargo build --quiet --release -p lyapunov-equal --example fmu
    "$venv/bin/python" fmu/test.py target/fmu "$CARGO_TARGET_DIR/release/examples/fmu" 2>"$out/fmu.log" >"$out/fmu.txt" ||
        { cat "$out/fmu.txt" "$out/fmu.log"; return 1; }
    grep '^fmi' "$out/fmu.txt"
}

controller() {
    have cmake || { skipped "the controller of ros2_control: cmake is not here"; return; }
    cmake -S ros2_control -B "$out/ros2_control" -DCMAKE_BUILD_TYPE=Release -DLYAPUNOV_BUILT="$CARGO_TARGET_DIR" >"$out/ros.log" 2>&1 ||
        { cat "$out/ros.log"; return 1; }
    cmake --build "$out/ros2_control" >>"$out/ros.log" 2>&1 || { cat "$out/ros.log"; return 1; }
    ctest --test-dir "$out/ros2_control" --output-on-failure >"$out/ctest.log" || { cat "$out/ctest.log"; return 1; }
    echo "its logic: $(sed -n 's/^\(.*tests passed\).*/\1/p' "$out/ctest.log")"
    if grep -q SKIPPED "$out/ros.log"; then
        skipped "the controller against ROS 2: ros2_control is not here (source its setup.bash first)"
    fi
}

install_what_is_missing() {
    have aarch64-linux-gnu-gcc && have qemu-aarch64 && return
    have apt-get && [ "$(id -u)" = 0 ] || return 0
    DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends gcc-aarch64-linux-gnu libc6-dev-arm64-cross qemu-user \
        >"$out/apt.log" 2>&1 || echo "apt-get could not install gcc-aarch64-linux-gnu, libc6-dev-arm64-cross, qemu-user"
}

machines=(x86_64-linux aarch64-linux cortex-m0 cortex-m4f cortex-m7)
if [ "${1:-}" != long ]; then
    machines=("$@")
else
    install_what_is_missing
fi
step "archives for programs without Rust: ${machines[*]}"
archives_need_no_rust "${machines[@]}"
step "units of FMI 2.0 and 3.0"
units_of_fmi
step "a controller of ros2_control"
controller
