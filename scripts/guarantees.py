#!/usr/bin/env python3
"""Check of docs/guarantees.md: every promise has evidence that is there, and that ran.

    guarantees.py               the named tests exist and are not ignored, the named scripts are called by .ci/run, and the
                                longer commands exist: files, words that a script is given, ignored tests, examples
    guarantees.py TESTS STEPS   the same; each test is told as passed in the log of `cargo test`, and each script has a step in
                                the log of .ci/run; what said SKIPPED is named, and fails nothing

The README, the contributing page and those pages of docs that are no evidence themselves may promise only in a paragraph or row
that leads to a page with evidence.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "docs/guarantees.md"
LONGER = "## Longer, behind scripts"
STRONG = r"no panic|panics?|guarantee[ds]?|proven|proved|cannot fail"
# The README promises with more words than the other pages, which also describe.
README_WORDS = re.compile(rf"\b({STRONG}|never|always|promises?|bit for bit)\b", re.I)
WORDS = re.compile(rf"\b({STRONG})\b", re.I)
EVIDENCE = ["guarantees", "proofs", "hard", "stabilizers", "embedded"]
LEADS = re.compile(rf"\]\((\.\./)*(docs/)?({'|'.join(EVIDENCE)})\.md")
PAGES = ["README.md", "CONTRIBUTING.md", "bindings/c/README.md", "docs/*.md", "docs/effects/*.md"]


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


def script_fault(name, steps):
    """What is wrong with a script as evidence, or nothing."""
    called = (ROOT / ".ci/run").read_text(encoding="utf-8")
    if not re.search(rf"^\s*(step|evidence) {re.escape(name)}$", called, re.M):
        return "not called by .ci/run"
    if steps is None:
        return None
    step = re.search(rf"^== {re.escape(name)} \(after.*?^== took", steps, re.M | re.S)
    if not step:
        return "has no step that ended in the log"
    skipped(name, step[0])
    return None


# In their order, each once.
SKIPPED = {}


def skipped(name, log):
    """Notes what a log says was skipped."""
    SKIPPED.update((f"not shown here, {name}: {line.strip()}", None) for line in re.findall(r"^.*SKIPPED.*$", log, re.M))


def test_fault(path, function, tests):
    """What is wrong with a test as evidence, or nothing."""
    text = path.read_text(encoding="utf-8")
    written = re.search(rf"((?:^\s*#\[[^\n]*\]\n)*)^\s*(?:pub )?fn {function}\(", text, re.M)
    if not (written and "#[test]" in written[1]) and not made(function, text):
        return "no such test"
    if written and "#[ignore" in written[1]:
        return "the test is ignored"
    if tests is None or any(ran(path, function, target) for target in re.split(r"^ +Running (?:unittests )?", tests, flags=re.M)):
        return None
    return "the test did not run, or failed"


def made(function, text):
    """Whether a macro of tests/properties/support makes tests of the function, one for each type."""
    return re.search(rf"^crate::support::(each_type|every_port|every_real)!\([^;]*\b{function}\b", text, re.M) is not None


def ran(path, function, target):
    """Whether the log of a target, which begins with its root file, tells a test of the file as passed."""
    root = target.split(" ", 1)[0].removeprefix("../")
    # In the root file itself there is no module of its name; a file may have modules inside.
    module = r"(\S+::)?" if str(path).endswith(f"/{root}") else rf"(\S+::)?{path.stem}::(\S+::)?"
    # What a macro makes of a function has a name for each type.
    return re.search(rf"^test {module}{function}(::\w+)?( - should panic)? \.\.\. ok$", target, re.M) is not None


def missing(evidence, tests, steps):
    """What is wrong with a piece of evidence, or nothing."""
    name, _, function = evidence.partition("::")
    path = ROOT / name.split()[0]
    if not path.is_file():
        return "no such file"
    return test_fault(path, function, tests) if function else script_fault(name, steps)


def longer(text):
    """What is wrong with the commands of the table of longer scripts."""
    table = text.split(LONGER)[1].split("\n## ")[0]
    commands = [line.split(" | ")[0] for line in table.splitlines() if line.startswith("| `")]
    return [f"{cell[2:]}: {fault}" for cell in commands for fault in command_faults(re.findall(r"`([^`]+)`", cell))]


def command_faults(pieces):
    """What is wrong with a command, and with further words that may be in the place of its own."""
    program, *words = " ".join(pieces).split()
    words = [word for word in words if re.fullmatch(r"[a-z][a-z-]*", word)]
    if program == "cargo":
        return cargo_faults(pieces[0])
    path = ROOT / (program if "/" in program else "cli/src/commands/mod.rs")
    if not path.is_file():
        return [f"there is no {program}"]
    known = path.read_text(encoding="utf-8").lower()
    return [f"{program} knows no {word}" for word in words if not re.search(rf"\b{word}\b", known)]


def cargo_faults(command):
    """What is wrong with a test or an example that cargo is asked to run."""
    if example := re.search(r"--example (\w+)", command):
        return [] if (ROOT / f"examples/{example[1]}.rs").is_file() else [f"there is no example {example[1]}"]
    name = next(word for word in reversed(re.sub(r" -- | --ignored", " ", command).split()) if not word.startswith("-"))
    ignored = re.compile(rf"#\[ignore[^\n]*\]\s*(pub )?fn \w*{name}\w*\(")
    tests = (path for folder in ("cli/tests", "lab/tests") for path in (ROOT / folder).rglob("*.rs"))
    return [] if any(ignored.search(path.read_text(encoding="utf-8")) for path in tests) else [f"no ignored test is called {name}"]


def unfounded(page):
    """Paragraphs and rows of a page that promise and lead to no evidence."""
    text = re.sub(r"```.*?```", "", page.read_text(encoding="utf-8"), flags=re.S)
    words = README_WORDS if page == ROOT / "README.md" else WORDS
    blocks = re.split(r"\n\s*\n|\n(?=[|-])", text)
    return [block.strip() for block in blocks if words.search(block) and not LEADS.search(block)]


def main():
    if len(sys.argv) not in (1, 3):
        sys.exit(__doc__)
    logs = [Path(name).read_text(encoding="utf-8", errors="replace") for name in sys.argv[1:]]
    tests, steps = logs or (None, None)
    skipped("tests", tests or "")
    page = PAGE.read_text(encoding="utf-8")
    wrong, count = longer(page), 0
    for promise, cell in rows(page):
        pieces = re.findall(r"`([^`]+)`", cell)
        count += len(pieces)
        wrong += [] if pieces else [f"no evidence: {promise}"]
        for piece in pieces:
            fault = missing(piece, tests, steps)
            wrong += [f"{piece}: {fault}, of: {promise}"] if fault else []
    for page in sorted(path for pattern in PAGES for path in ROOT.glob(pattern)):
        if page.stem not in EVIDENCE:
            name = page.relative_to(ROOT)
            wrong += [f"{name} promises and leads to no evidence: {block[:100]}" for block in unfounded(page)]
    seen = "" if not logs else f" and ran, but for {len(SKIPPED)} that said SKIPPED" if SKIPPED else " and ran"
    print("\n".join(list(SKIPPED) + (wrong or [f"{count} pieces of evidence are there{seen}"])))
    sys.exit(1 if wrong else 0)


main()
