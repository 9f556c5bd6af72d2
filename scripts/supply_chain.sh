#!/usr/bin/env bash
# What the crates are built of, and whether others can build them: each feature by itself, the oldest
# compiler, the oldest dependencies, licences and sources, the public interface, and the same binary twice.
# `supply_chain.sh` runs every check; `supply_chain.sh features public-api` runs those two.
# Tools that are missing are installed into target/tools.
set -euo pipefail
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-$PWD/target}
library=(lyapunov lyapunov-core lyapunov-plants lyapunov-stabilizers)
export PATH="$target/tools/bin:$PATH"

skipped() { printf 'SKIPPED: %s\n' "$*"; }
packages() { printf -- '-p %s ' "${library[@]}"; }
toolchain() { rustup toolchain list 2>/dev/null | grep -q "^$1" || rustup toolchain install --profile minimal "$1" >/dev/null 2>&1; }
tool() { command -v "$1" >/dev/null || cargo install --quiet --locked --root "$target/tools" "$1"; }

# Each feature adds nothing that another one needs.
features() {
    local crate feature
    for crate in "${library[@]}"; do
        cargo check --quiet --locked -p "$crate" --no-default-features
        for feature in alloc approx defmt serde; do
            grep -q "^$feature = " <(manifest "$crate") || continue
            cargo check --quiet --locked -p "$crate" --no-default-features --features "$feature"
        done
        cargo check --quiet --locked -p "$crate" --all-features
    done
}

manifest() {
    case $1 in
    lyapunov) cat Cargo.toml ;;
    lyapunov-core) cat lyapunov-core/Cargo.toml ;;
    *) cat "${1#lyapunov-}/Cargo.toml" ;;
    esac
}

# The compiler that Cargo.toml calls the oldest.
oldest-compiler() {
    local version
    version=$(sed -n 's/^rust-version = "\(.*\)"$/\1/p' Cargo.toml)
    toolchain "$version" || { skipped "Rust $version cannot be had here"; return 0; }
    # shellcheck disable=SC2046
    CARGO_TARGET_DIR="$target/oldest" cargo "+$version" check --quiet --locked --all-features $(packages)
    CARGO_TARGET_DIR="$target/oldest" cargo "+$version" check --quiet --locked -p lyapunov-cli
}

# The oldest versions that the manifests of the library allow.
oldest-dependencies() {
    local copy
    copy=$(mktemp -d)
    git ls-files -z | xargs -0 cp --parents -t "$copy"
    # Resolving for the oldest is not stable in cargo; it is asked of the stable one, so that the rest is.
    (
        cd "$copy"
        rm Cargo.lock
        # Of the library only: the lab and the command are used with their lock.
        sed -i 's/^members = .*/members = ["lyapunov-core", "plants", "stabilizers"]/; /^default-members = /d' Cargo.toml
        RUSTC_BOOTSTRAP=1 cargo update --quiet -Z direct-minimal-versions
        # shellcheck disable=SC2046
        CARGO_TARGET_DIR="$target/oldest-dependencies" cargo check --quiet --locked --all-features $(packages)
    )
    rm -r "$copy"
}

licences() {
    tool cargo-deny
    cargo deny --locked --log-level error check bans licenses sources
    # The command and the benches may hold a crate in two versions.
    cargo deny --locked --workspace --log-level error check licenses sources
}

# docs/api holds the public interface of each crate of the library, an item a line.
public-api() {
    local crate
    for crate in "${library[@]}"; do
        interface "$crate" | diff -u "docs/api/$crate.txt" - || {
            echo "the public interface of $crate changed: if you mean it, run scripts/supply_chain.sh write-public-api"
            return 1
        }
    done
}

write-public-api() {
    local crate
    for crate in "${library[@]}"; do interface "$crate" >"docs/api/$crate.txt"; done
}

# Rustdoc's JSON is not stable either.
interface() {
    tool cargo-public-api
    RUSTC_BOOTSTRAP=1 cargo public-api -sss --all-features -p "$1" 2>/dev/null
}

# Two folders, two builds, one binary.
same-binary() {
    local folder sums=()
    for folder in one two; do
        rm -rf "$target/same/$folder"
        mkdir -p "$target/same/$folder"
        git ls-files -z | xargs -0 cp --parents -t "$target/same/$folder"
        (
            cd "$target/same/$folder"
            CARGO_TARGET_DIR=target RUSTFLAGS="--remap-path-prefix=$PWD=/lyapunov --remap-path-prefix=${CARGO_HOME:-$HOME/.cargo}=/cargo" \
                cargo build --quiet --release --locked -p lyapunov-cli
        )
        sums+=("$(sha256sum <"$target/same/$folder/target/release/lyapunov")")
    done
    [ "${sums[0]}" = "${sums[1]}" ] || { echo "two builds of one commit differ"; return 1; }
    rm -r "$target/same"
}

checks=("$@")
[ $# -gt 0 ] || checks=(features oldest-compiler oldest-dependencies licences public-api same-binary)
for check in "${checks[@]}"; do
    case $check in
    features | oldest-compiler | oldest-dependencies | licences | public-api | write-public-api | same-binary) ;;
    *) echo "there is no check '$check'"; exit 2 ;;
    esac
    printf '\n-- %s\n' "$check"
    "$check"
done
