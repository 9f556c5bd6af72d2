#!/usr/bin/env python3
"""Regions of the lower crates that a run did not execute, of llvm-cov's JSON.

    coverage.py EXPORT ROOT

A function counts where any part of it was executed: of what no tick calls (accounts, changes between ticks, texts) the number
is told. One instance of a generic function is enough for a region. Of refusals, the ways out of a `?`, the number is told too.
"""

import json
import sys
from collections import defaultdict
from pathlib import Path

CODE = 0  # the kind of a region of code, not of a gap or a branch


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


def main():
    export, root = json.loads(Path(sys.argv[1]).read_text(encoding="utf-8")), Path(sys.argv[2]).resolve()
    counts = functions(export, root)
    called = {place: regions for place, regions in counts.items() if any(regions.values())}
    missed = sorted((place[0], region) for place, regions in called.items() for region, count in regions.items() if not count)
    told = [(name, region, text(root, name, region)) for name, region in missed]
    rest = [f"{name}:{region[0]}:{region[1]}: {code}" for name, region, code in told if code != "?"]
    print("\n".join(rest))
    whole = sum(len(regions) for regions in called.values())
    print(f"{whole - len(missed)} of {whole} regions of {len(called)} functions were executed; of the others {len(missed) - len(rest)} are")
    print(f"refusals and {len(rest)} are above; {len(counts) - len(called)} functions were not called")


if __name__ == "__main__":
    main()
