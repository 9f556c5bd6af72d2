#!/usr/bin/env bash
# Builds the units for this machine: build.sh LIBRARY FOLDER [HEADERS] puts FOLDER/fmi2 and FOLDER/fmi3 with POPC and LOLC.
# HEADERS is a folder with the headers of FMI 2.0 and 3.0; without it those of the Python package fmpy are used.
set -euo pipefail
library=$(realpath "$1")
mkdir -p "$2"
out=$(realpath "$2")
here=$(cd "$(dirname "$0")" && pwd)
headers=${3:-$(python3 -c 'import importlib.util as u; print(u.find_spec("fmpy").submodule_search_locations[0] + "/c-code")')}
version=$(sed -n 's/^version = "\(.*\)"/\1/p' "$here/../Cargo.toml")
compiler=${CC:-cc}
warnings=(-Wall -Wextra -Wpedantic -Wconversion -Werror)
machine=$(uname -m)

for fmi in 2 3; do
    folder=$([ $fmi = 2 ] && echo linux64 || echo "$machine-linux")
    for block in popc lolc; do
        name=lyapunov_$block
        made=$out/made/fmi$fmi/$name
        rm -rf "$made" "$out/fmi$fmi/$name.fmu"
        mkdir -p "$made/binaries/$folder" "$out/fmi$fmi"
        flags=(-std=c11 -O2 "-DFMI=$fmi" "-DVERSION=\"$version\"" -I"$here" -I"$here/../include")
        [ $block = popc ] || flags+=(-DLOLC)
        "$compiler" "${flags[@]}" "${warnings[@]}" "$here/describe.c" -o "$out/describe"
        "$out/describe" >"$made/modelDescription.xml"
        # What is absent does not look at what it is given.
        "$compiler" "${flags[@]}" "${warnings[@]}" -Wno-unused-parameter -isystem "$headers" -fPIC -fvisibility=hidden -shared \
            "$here/unit.c" "$here/instance.c" "$here/fmi$fmi.c" "$here/fmi${fmi}_absent.c" "$library" \
            -Wl,--exclude-libs,ALL -Wl,--gc-sections -Wl,--no-undefined -o "$made/binaries/$folder/$name.so"
        # By Python, which is where fmpy is; a fixed date makes the same bytes of the same files.
        python3 - "$made" "$out/fmi$fmi/$name.fmu" <<'ZIP'
import pathlib, sys, zipfile

made = pathlib.Path(sys.argv[1])
with zipfile.ZipFile(sys.argv[2], "w", zipfile.ZIP_DEFLATED) as archive:
    for path in sorted(path for path in made.rglob("*") if path.is_file()):
        archive.writestr(zipfile.ZipInfo(path.relative_to(made).as_posix()), path.read_bytes(), zipfile.ZIP_DEFLATED)
ZIP
    done
done
rm "$out/describe"
