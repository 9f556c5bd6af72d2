"""History of ratios: a row for each machine, commit and bench."""

import csv
import re
import subprocess
from pathlib import Path

FILE = Path("benches/history.csv")
COLUMNS = ["machine", "commit", "date", "bench", "ratio"]

# A bench, and what it is compared with: the ratio is the time of the first over that of the second.
PAIRS = [
    (r"(step/.*)/generic", r"\1/hand"),
    (r"((?:step|latency)/.*)/generic", r"\1/literal"),
    (r"stabilizers/(popc|lolc|force-bound|tank)/(.*)", r"stabilizers/\1-by-hand/\2"),
    (r"stabilizers/popc-(?:member|boxed|recorded)/(.*)", r"stabilizers/popc/\1"),
    (r"(plant/.*)/increment", r"\1/naive"),
    (r"lanes/f\d+x\d+", r"lanes/f64"),
    (r"scene/built/(.*)", r"scene/typed/\1"),
    (r"map/lanes/(f\d+)(?:/.*)?", r"map/scalar/\1"),
    (r"map/measures-lanes/(f\d+)(?:/.*)?", r"map/measures-scalar/\1"),
]


def ratios(estimates):
    """The ratios, by `BENCH over OTHER`."""
    found = {}
    for name in estimates:
        for pattern, other in PAIRS:
            match = re.fullmatch(pattern, name)
            ratio = match and estimates.ratio(name, match.expand(other))
            if not ratio:
                continue
            found[f"{name} over {match.expand(other).rsplit('/', 1)[-1]}"] = ratio
    return found


def gains(file):
    """The ratios of the table that the bench of boxes prints, by `BENCH over single`: lanes over single runs."""
    rows = [[cell.strip() for cell in line.strip("|\n").split("|")] for line in file.read_text().splitlines()]
    sets = rows[0][2:]
    return {
        f"boxes/{row[0]}/{name} over single": 1 / float(gain)
        for row in rows[2:]
        for name, gain in zip(sets, row[2:])
    }


def machine():
    """The processor's name and the number of its cores."""
    information = Path("/proc/cpuinfo").read_text() if Path("/proc/cpuinfo").exists() else ""
    names = re.findall(r"^model name\s*: (.*)$", information, re.MULTILINE)
    if not names:
        return "unknown"
    family = re.findall(r"^cpu family\s*: (.*)$|^model\s*: (.*)$", information, re.MULTILINE)[:2]
    numbers = "-".join("".join(pair) for pair in family)
    name = re.sub(r"\((R|TM)\)|CPU|@.*", "", names[0])
    return f"{' '.join(name.split())} ({numbers}), {len(names)} cores"


def commit(root):
    """The commit that was measured, with a `+` if the sources differ from it."""

    def git(*words):
        return subprocess.run(["git", *words], cwd=root, check=True, capture_output=True, text=True).stdout

    changed = git("status", "--porcelain", "--untracked-files=no", "--", "*.rs", "*.toml", "Cargo.lock")
    return git("rev-parse", "--short=10", "HEAD").strip() + ("+" if changed else "")


def read(root):
    """The rows so far."""
    file = root / FILE
    if not file.exists():
        return []
    with file.open(newline="") as text:
        return list(csv.DictReader(text))


def append(root, date, found):
    """Adds a row for each of the ratios `found`; a repetition replaces the row of before."""
    here = {"machine": machine(), "commit": commit(root), "date": date}
    new = [{**here, "bench": bench, "ratio": f"{found[bench]:.4g}"} for bench in sorted(found)]
    places = {(row["machine"], row["commit"], row["bench"]) for row in new}
    old = [row for row in read(root) if (row["machine"], row["commit"], row["bench"]) not in places]
    with (root / FILE).open("w", newline="") as text:
        writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(old + new)
