#!/usr/bin/env bash
# Puts archives for programs without Rust into target/release-archives: release.sh [MACHINE...], all of them by default.
# Machines: x86_64-linux aarch64-linux cortex-m0 cortex-m4f cortex-m7. What cannot be built here is SKIPPED, and the script fails at the end.
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
        cargo rustc --quiet --release --features library --crate-type staticlib,cdylib
        cp "$CARGO_TARGET_DIR/release/liblyapunov_c.a" "$2"
        return
    fi
    if ! [ -d "$(rustc --print sysroot)/lib/rustlib/$triple" ] && ! rustup target add "$triple" >/dev/null 2>&1; then
        echo "SKIPPED: $machine: the target $triple cannot be had here (rustup target add failed)"
        return 1
    fi
    cargo rustc --quiet --release --features library --crate-type staticlib --target "$triple" --target-dir "$folder" "${flags[@]}"
    cp "$folder/$triple/release/liblyapunov_c.a" "$2"
}

archive() {
    local name=lyapunov-$version-$1 made
    made=$(mktemp -d)
    mkdir -p "$made/$name/include" "$made/$name/lib/cmake/lyapunov" "$made/$name/lib/pkgconfig"
    if ! library "$1" "$made/$name/lib/liblyapunov_c.a"; then
        rm -r "$made"
        return 1
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

one_version
machines=("$@")
[ $# -gt 0 ] || machines=(x86_64-linux aarch64-linux cortex-m0 cortex-m4f cortex-m7)
for machine in "${machines[@]}"; do triple "$machine" >/dev/null; done
rm -rf "$out"
mkdir -p "$out"
for machine in "${machines[@]}"; do
    archive "$machine" || skipped=1
done
# The wheels of the same version, where bindings/python/check.sh has built them.
find "${LYAPUNOV_WHEELS:-../../target/wheels}" -name "*-$version-*.whl" -exec cp {} "$out" \; 2>/dev/null || true
(cd "$out" && sha256sum -- *.tar.gz *.whl 2>/dev/null >SHA256SUMS || sha256sum -- *.tar.gz >SHA256SUMS)
cat "$out/SHA256SUMS"
exit $skipped
