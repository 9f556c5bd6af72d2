#!/usr/bin/env python3
"""Table of what was shown of each member: made of results, or held against docs/proofs.md.

    table.py RESULTS            prints the table
    table.py RESULTS PAGE       fails where the page says more than the results
"""

import csv
import sys
from pathlib import Path

COLUMNS = ["file", "member", "property", "scalar", "axes", "expected", "mutant", "said", "seconds"]
PROPERTIES = ["finite", "rejected", "untimed", "memory", "limit", "opposes", "within", "told", "served", "reduces"]
FORMATS = ["f16", "f32", "f64"]
HEAD = ["member", "axes", *PROPERTIES]


def shown(rows, member, axes, name):
    """The formats in which `name` was shown, or None where it was not asked."""
    asked = [row for row in rows if row["member"] == member and row["axes"] == axes and row["property"] == name]
    if not asked:
        return None
    good = {row["scalar"] for row in asked if row["said"] == row["expected"]}
    return set(FORMATS) if "every" in good else good & set(FORMATS)


def served(rows, member, axes):
    """The formats in which a debt below the limit is served in full: the line, two ranges, and the least squares."""
    parts = [shown(rows, member, axes, name) for name in ("line", "served-normal", "served-largest")]
    # It is asked of the sum and of v² T, whatever led to them: on three axes it is the same query.
    parts.append(shown(rows, member, "1", "served-least"))
    return None if None in parts else set.intersection(*parts)


def cell(formats):
    """What a cell says of the formats in which something was shown."""
    if formats is None:
        return ""
    if formats == set(FORMATS):
        return "all"
    return " ".join(name for name in FORMATS if name in formats) or "open"


def table(rows):
    """The lines of the table, as lists of cells."""
    rows = [row for row in rows if not row["mutant"] and row["scalar"] != "reals" and row["property"] != "rounding"]
    lines = []
    for member in dict.fromkeys(row["member"] for row in rows):
        for axes in ("1", "3"):
            if any(row["member"] == member and row["axes"] == axes for row in rows):
                of = lambda name: served(rows, member, axes) if name == "served" else shown(rows, member, axes, name)
                lines.append([f"`{member}`", axes, *(cell(of(name)) for name in PROPERTIES)])
    return lines


def read(page):
    """The lines of the page's table."""
    lines = [line.strip().strip("|").split("|") for line in page.read_text(encoding="utf-8").splitlines() if line.startswith("|")]
    cells = [[cell.strip() for cell in line] for line in lines]
    start = cells.index(HEAD) + 2
    return [line for line in cells[start:] if len(line) == len(HEAD)]


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        lines = table([dict(zip(COLUMNS, row)) for row in csv.reader(file, delimiter="\t")])
    if len(sys.argv) == 2:
        for line in [HEAD, ["---"] * len(HEAD), *lines]:
            print(f"| {' | '.join(line)} |")
        return
    found = {(line[0], line[1]): line for line in lines}
    said = {(line[0], line[1]): line for line in read(Path(sys.argv[2]))}
    worse = [f"{key[0]}, {key[1]} axes: no line" for key in found.keys() ^ said.keys()]
    for key in found.keys() & said.keys():
        for name, mine, page in zip(HEAD, found[key], said[key]):
            weaker = page != mine and mine != "all" and not (page == "open")
            worse += [f"{key[0]}, {key[1]} axes, {name}: the page says {page}, shown is {mine}"] if weaker else []
    print("\n".join(worse) or "docs/proofs.md says no more than was shown")
    sys.exit(1 if worse else 0)


main()
