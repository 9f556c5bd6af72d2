#!/usr/bin/env python3
"""Solver of queries: asks each one of an index, and writes what came of it.

    solve.py INDEX SECONDS RESULTS quick|all

Queries over every format and over the reals go to z3, those about bits to bitwuzla, scripts to Gappa; each may take SECONDS.
Fails where an answer is not the expected one, undecided included, and where no query notices a mutant. A query that is expected to
be `open` is told as long as nothing refutes it.
"""

import csv
import subprocess
import sys
import time
from collections import defaultdict
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path

COLUMNS = ["file", "member", "property", "scalar", "axes", "expected", "mutant"]


def bits(path, seconds):
    """What bitwuzla says."""
    import bitwuzla

    options = bitwuzla.Options()
    options.set(bitwuzla.Option.TIME_LIMIT_PER, int(seconds * 1000))
    parser = bitwuzla.Parser(bitwuzla.TermManager(), options)
    text = path.read_text(encoding="utf-8").replace("(check-sat)\n", "")
    parser.parse(text, parse_only=True, parse_file=False)
    return str(parser.bitwuzla().check_sat()).split(".")[-1].lower()


def orders(path, seconds):
    """What z3 says."""
    import z3

    solver = z3.Solver()
    solver.set("timeout", int(seconds * 1000))
    solver.from_file(str(path))
    return str(solver.check())


def roundings(path, seconds):
    """What Gappa says; a warning is a hint that it could not check."""
    try:
        run = subprocess.run(["gappa", str(path)], capture_output=True, text=True, timeout=seconds, check=False)
    except subprocess.TimeoutExpired:
        return "undecided"
    return "proved" if run.returncode == 0 and not run.stderr.strip() else "not proved"


def ask(job):
    """What is said of one file, and after how many seconds."""
    path, scalar, seconds = job
    start = time.monotonic()
    if path.suffix == ".gappa":
        said = roundings(path, seconds)
    else:
        said = (orders if scalar in ("every", "reals") else bits)(path, seconds)
    said = said if said in ("sat", "unsat", "proved", "not proved") else "undecided"
    return said, time.monotonic() - start


def chosen(row, mode):
    """Whether `mode` asks the query."""
    if mode == "all" or row["scalar"] == "reals":
        return True
    if row["mutant"]:
        return row["property"] in ("limit", "finite", "served-normal") and row["scalar"] in ("every", "f32")
    heavy = row["scalar"] == "f64" and row["property"] in ("served-least", "finite", "memory")
    return row["axes"] == "1" and row["property"] != "rounding" and not heavy


def judge(rows, answers):
    """The lines to print, and whether all is as expected."""
    lines, noticed, good = [], defaultdict(list), True
    for row, (said, took) in zip(rows, answers):
        if row["mutant"]:
            noticed[row["mutant"]] += [row["file"]] if said not in (row["expected"], "undecided") else []
        elif row["expected"] == "open" and said != "sat":
            lines.append(f"open: {row['file']} is {said} after {took:.0f} s")
        elif said != row["expected"]:
            good = False
            lines.append(f"FAILED: {row['file']} is {said}, expected {row['expected']}")
    for mutant, files in noticed.items():
        good = good and bool(files)
        lines.append(f"mutant {mutant}: " + (f"noticed by {', '.join(files)}" if files else "NOT NOTICED"))
    return lines, good


def main():
    index, seconds, results, mode = sys.argv[1:]
    index = Path(index)
    with index.open(encoding="utf-8") as file:
        rows = [dict(zip(COLUMNS, row)) for row in csv.reader(file, delimiter="\t")]
    rows = [row for row in rows if chosen(row, mode)]
    jobs = [(index.parent / row["file"], row["scalar"], float(seconds)) for row in rows]
    start = time.monotonic()
    answers = []
    with ProcessPoolExecutor(2) as pool, open(results, "w", encoding="utf-8") as out:
        for row, answer in zip(rows, pool.map(ask, jobs)):
            answers.append(answer)
            print(*row.values(), answer[0], f"{answer[1]:.1f}", sep="\t", file=out, flush=True)
    lines, good = judge(rows, answers)
    print("\n".join(lines))
    decided = sum(said != "undecided" for said, _ in answers)
    print(f"{len(rows)} queries, {decided} decided, {time.monotonic() - start:.0f} s")
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
