#!/usr/bin/env python3
"""Check of docs/guarantees.md: every promise has evidence that is there, and that ran.

    guarantees.py          the named tests exist and are not ignored, the named scripts are called by .ci/run
    guarantees.py LOG      the same, and each test is told as passed in the log of `cargo test`

The README may use a word of promise only in a paragraph or row that leads to a page with evidence.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/guarantees.md"
LONGER = "## Longer, behind scripts"
WORDS = re.compile(r"\b(no panic|panics?|never|always|guarantee[ds]?|promises?|bit for bit|proven|proved|cannot fail)\b", re.I)
LEADS = re.compile(r"\]\(docs/(guarantees|proofs|hard|stabilizers|embedded)\.md")


def rows(text):
    """The cells of each row of the page's tables of promises, with the promise of a row that goes on."""
    promise = ""
    for line in text.split(LONGER)[0].splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split(" | ")]
        if not line.startswith("|") or cells[0].startswith("---") or cells[0] == "promise":
            continue
        cells = [cell.strip(" |") for cell in cells]
        promise = cells[0] or promise
        yield promise, cells[-1]


def missing(evidence, called, log):
    """What is wrong with a piece of evidence, or nothing."""
    name, _, function = evidence.partition("::")
    path = ROOT / name.split()[0]
    if not path.is_file():
        return "no such file"
    if not function:
        return None if re.search(rf"^\s*step {re.escape(name)}$", called, re.M) else "not called by .ci/run"
    found = re.search(rf"((?:^\s*#\[[^\n]*\]\n)*)^\s*(?:pub )?fn {function}\(", path.read_text(encoding="utf-8"), re.M)
    if not found or "#[test]" not in found[1]:
        return "no such test"
    if "#[ignore" in found[1]:
        return "the test is ignored"
    if log is not None and not re.search(rf"^test (\S+::)?{function}( - should panic)? \.\.\. ok$", log, re.M):
        return "the test did not run, or failed"
    return None


def unfounded(text):
    """Paragraphs and rows of the README that promise and lead to no evidence."""
    text = re.sub(r"```.*?```", "", text, flags=re.S)
    blocks = re.split(r"\n\s*\n|\n(?=[|-])", text)
    return [block.strip() for block in blocks if WORDS.search(block) and not LEADS.search(block)]


def main():
    log = Path(sys.argv[1]).read_text(encoding="utf-8", errors="replace") if len(sys.argv) > 1 else None
    called = (ROOT / ".ci/run").read_text(encoding="utf-8")
    wrong, count = [], 0
    for promise, cell in rows(PAGE.read_text(encoding="utf-8")):
        pieces = re.findall(r"`([^`]+)`", cell)
        count += len(pieces)
        wrong += [] if pieces else [f"no evidence: {promise}"]
        for piece in pieces:
            fault = missing(piece, called, log)
            wrong += [f"{piece}: {fault}, of: {promise}"] if fault else []
    for block in unfounded((ROOT / "README.md").read_text(encoding="utf-8")):
        wrong.append(f"README promises and leads to no evidence: {block[:100]}")
    print("\n".join(wrong) or f"{count} pieces of evidence are there" + (" and ran" if log else ""))
    sys.exit(1 if wrong else 0)


main()
