"""Writes what was measured into the docs, and the ratios of the benches into their history."""

import argparse
import subprocess
import sys
from pathlib import Path

import history
import page
import tables
from estimates import Estimates

ROOT = Path(__file__).resolve().parents[2]


def date_of_commit():
    shown = ["git", "log", "-1", "--format=%cs"]
    return subprocess.run(shown, cwd=ROOT, check=True, capture_output=True, text=True).stdout.strip()


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--results", type=Path, required=True)
    parser.add_argument("--date")
    parser.add_argument("parts", nargs="+")
    given = parser.parse_args()
    estimates = Estimates.below(given.results / "criterion", given.parts)
    ratios = history.ratios(estimates)
    if "boxes" in given.parts:
        ratios |= history.gains(given.results / "boxes.md")
    if ratios:
        history.append(ROOT, given.date or date_of_commit(), ratios)
        page.write(ROOT)
    skipped = tables.write(ROOT, given.results, estimates, given.parts)
    for reason in skipped:
        print(f"SKIPPED: {reason}", file=sys.stderr)


if __name__ == "__main__":
    main()
