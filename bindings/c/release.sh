#!/usr/bin/env bash
# Puts archives for programs without Rust into target/release-archives: release.sh [--wheels FOLDER] [MACHINE...]
# Machines: x86_64-linux aarch64-linux cortex-m0 cortex-m4f cortex-m7, all of them by default. FOLDER has wheels of the same version,
# as `maturin build --release --out FOLDER` in bindings/python makes them. What cannot be built here is SKIPPED, and the
# script ends with 3.
set -euo pipefail
cd "$(dirname "$0")"

out=$PWD/target/release-archives
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}
version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)
skipped=0

one_version() {
    local file
    for file in "CMakeLists.txt:VERSION $version" "cmake/lyapunov-config-version.cmake:\"$version\"" "cmake/lyapunov.pc:Version: $version"; do
        grep -qF "${file#*:}" "${file%%:*}" || { echo "${file%%:*} is not of version $version, which Cargo.toml has"; exit 1; }
    done
    if [ -f ../python/Cargo.toml ] && ! grep -q "^version = \"$version\"\|^version.workspace" ../python/Cargo.toml; then
        echo "../python/Cargo.toml is not of version $version, which Cargo.toml has"
        exit 1
    fi
}

triple() {
    case $1 in
        x86_64-linux) echo x86_64-unknown-linux-gnu ;;
        aarch64-linux) echo aarch64-unknown-linux-gnu ;;
        cortex-m0) echo thumbv6m-none-eabi ;;
        cortex-m4f | cortex-m7) echo thumbv7em-none-eabihf ;;
        *) echo "$1 is no machine; x86_64-linux, aarch64-linux, cortex-m0, cortex-m4f and cortex-m7 are" >&2; return 1 ;;
    esac
}

# Puts the library of a machine at a path.
library() {
    local machine=$1 triple folder=$CARGO_TARGET_DIR flags=()
    triple=$(triple "$machine")
    if [ "$machine" = cortex-m7 ]; then
        # Of one triple with the M4F, but with doubles in hardware: built beside it.
        folder=$CARGO_TARGET_DIR/cortex-m7
        flags=(-- -C target-cpu=cortex-m7)
    fi
    if [ "$(rustc -vV | sed -n 's/^host: //p')" = "$triple" ]; then
        cargo rustc --quiet --release --features library --crate-type staticlib || return 1
        cp "$CARGO_TARGET_DIR/release/liblyapunov_c.a" "$2"
        return
    fi
    if ! [ -d "$(rustc --print sysroot)/lib/rustlib/$triple" ] && ! rustup target add "$triple" >/dev/null 2>&1; then
        echo "SKIPPED: $machine: the target $triple cannot be had here (rustup target add failed)"
        return 3
    fi
    cargo rustc --quiet --release --features library --crate-type staticlib --target "$triple" --target-dir "$folder" "${flags[@]}" || return 1
    cp "$folder/$triple/release/liblyapunov_c.a" "$2"
}

archive() {
    local name=lyapunov-$version-$1 made code=0
    made=$(mktemp -d)
    mkdir -p "$made/$name/include" "$made/$name/lib/cmake/lyapunov" "$made/$name/lib/pkgconfig"
    library "$1" "$made/$name/lib/liblyapunov_c.a" || code=$?
    if [ $code != 0 ]; then
        rm -r "$made"
        return $code
    fi
    cp include/lyapunov.h include/lyapunov.hpp "$made/$name/include"
    cp cmake/*.cmake "$made/$name/lib/cmake/lyapunov"
    cp cmake/lyapunov.pc "$made/$name/lib/pkgconfig"
    cp -r examples ../../LICENSE-MIT ../../LICENSE-APACHE "$made/$name"
    # Without links to pages that are not in the archive.
    sed 's/\[\([^]]*\)\](\.\.[^)]*)/\1/g' README.md >"$made/$name/README.md"
    # The same bytes of the same files, whoever packs them and when.
    tar --sort=name --mtime=@0 --owner=0 --group=0 --numeric-owner -C "$made" -c "$name" | gzip -n >"$out/$name.tar.gz"
    rm -r "$made"
}

wheels=
if [ "${1:-}" = --wheels ]; then
    wheels=$(realpath "${2:?--wheels needs a folder}")
    shift 2
fi
one_version
machines=("$@")
[ $# -gt 0 ] || machines=(x86_64-linux aarch64-linux cortex-m0 cortex-m4f cortex-m7)
for machine in "${machines[@]}"; do triple "$machine" >/dev/null; done
rm -rf "$out"
mkdir -p "$out"
for machine in "${machines[@]}"; do
    code=0
    archive "$machine" || code=$?
    case $code in
        0) ;;
        3) skipped=3 ;;
        *) echo "$machine: the archive was not made" >&2; exit 1 ;;
    esac
done
if [ -n "$wheels" ]; then
    cp "$wheels"/*-"$version"-*.whl "$out" || { echo "$wheels has no wheel of version $version"; exit 1; }
fi
(cd "$out" && find . -type f ! -name SHA256SUMS -printf '%P\n' | sort | xargs sha256sum >SHA256SUMS)
cat "$out/SHA256SUMS"
exit $skipped
