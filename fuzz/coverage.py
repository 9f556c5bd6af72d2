#!/usr/bin/env python3
"""Regions of the lower crates that a run did not execute, of llvm-cov's JSON.

    coverage.py EXPORT ROOT

A function counts where any part of it was executed: of what no tick calls (accounts, changes between ticks, texts) the number
is told. One instance of a generic function is enough for a region. Of refusals, the ways out of a `?` in a function that returns a
`Result`, the number is told too. Fails where another region was not executed, unless it is one of UNREACHED, and where one of those was.
"""

import json
import re
import sys
from collections import Counter, defaultdict
from pathlib import Path

CODE = 0  # the kind of a region of code, not of a gap or a branch
# What no step of a member reaches, and why: file and text of a region, how often it is there.
UNREACHED = {
    ("lyapunov-core/src/scalar.rs", "f64::NAN"): (1, "a lane beyond the last"),
    ("lyapunov-core/src/signal.rs", "T::zero"): (1, "a vector of no axis"),
    ("lyapunov-core/src/signal.rs", "only"): (1, "a vector of one axis"),
    ("lyapunov-core/src/signal.rs", "*only"): (1, "a vector of one axis"),
    ("stabilizers/src/credit/windowed_credit.rs", "}"): (2, "a window without slots"),
    ("stabilizers/src/member.rs", "Err(another(Self::NAMES, stored, own))"): (1, "the memory of another member is refused"),
    ("stabilizers/src/member.rs", "another"): (1, "the memory of another member is refused"),
    ("stabilizers/src/member.rs", "Self::NAMES"): (1, "the memory of another member is refused"),
    ("stabilizers/src/parts/part_limits.rs", "parameter"): (1, "a moment of inertia is refused under its name"),
}


def functions(export, root):
    """By place of a function, the times that each of its regions was executed, over all instances."""
    counts = defaultdict(lambda: defaultdict(int))
    for function in export["data"][0]["functions"]:
        path = Path(function["filenames"][0]).resolve()
        if not any(path.is_relative_to(root / crate) for crate in ("lyapunov-core/src", "stabilizers/src")):
            continue
        regions = [region for region in function["regions"] if region[7] == CODE]
        if regions:
            place = (str(path.relative_to(root)), *regions[0][:4])
            for start, column, end, last, count, *_ in regions:
                counts[place][start, column, end, last] += count
    return counts


def text(root, name, region):
    """What a region says, on one line."""
    start, column, end, last = region
    lines = (root / name).read_text(encoding="utf-8").splitlines()[start - 1 : end]
    # Columns are of bytes.
    whole = [line.encode() for line in lines]
    whole[-1] = whole[-1][: last - 1]
    whole[0] = whole[0][column - 1 :]
    return " ".join(b" ".join(whole).decode(errors="replace").split())[:90]


def returns_result(root, name, region):
    """Whether the function around a region returns a `Result`."""
    before = (root / name).read_text(encoding="utf-8").splitlines()[: region[0]]
    start = max(at for at, line in enumerate(before) if re.search(r"\bfn \w", line))
    return "Result<" in " ".join(before[start:]).split("{")[0]


def main():
    export, root = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]).resolve()
    counts = functions(export, root)
    called = {place: regions for place, regions in counts.items() if any(regions.values())}
    missed = sorted((place[0], region) for place, regions in called.items() for region, count in regions.items() if not count)
    told = [(name, region, text(root, name, region)) for name, region in missed]
    rest = [(name, region, code) for name, region, code in told if code != "?" or not returns_result(root, name, region)]
    whole = sum(len(regions) for regions in called.values())
    print(f"{whole - len(missed)} of {whole} regions of {len(called)} functions were executed; of the others {len(missed) - len(rest)} are")
    print(f"refusals and {len(rest)} are below; {len(counts) - len(called)} functions were not called")
    found = Counter((name, code) for name, _, code in rest)
    for name, region, code in rest:
        print(f"{name}:{region[0]}:{region[1]}: {code}: {UNREACHED.get((name, code), (0, 'NOT EXECUTED'))[1]}")
    wrong = [place for place in UNREACHED.keys() | found.keys() if found[place] != UNREACHED.get(place, (0, ""))[0]]
    for name, code in sorted(wrong):
        print(f"WRONG: {name}: {code}: {found[name, code]} such regions, {UNREACHED.get((name, code), (0, ''))[0]} are in UNREACHED")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
