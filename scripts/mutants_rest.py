"""Mutants of plants, lab, figures and command: a random sample of those of cargo-mutants, all in one build.

    mutants_rest.py LIST COUNT SEED FOLDER

LIST is what `cargo mutants --list --json` prints. These crates take minutes to build, so a copy of the project, in FOLDER, holds
each sampled mutant beside the code that it changes, and the variable MUTANT names the one that runs. Each test runs once to see
which mutants it reaches; then each mutant runs the tests that reach it, the shortest first, until one fails. Prints what
was missed and how many tests reach it, and how many of each crate were caught.
"""

import concurrent.futures
import dataclasses
import json
import os
import pathlib
import random
import resource
import shutil
import subprocess
import sys
import tempfile
import time

# What the copy calls: whether a mutant runs, and a note of the first time that it could have.
SWITCH = """
use std::io::Write;
use std::sync::LazyLock;
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

static RUNS: LazyLock<usize> = LazyLock::new(|| std::env::var("MUTANT").map_or(usize::MAX, |k| k.parse().unwrap()));
static REACHED: [AtomicBool; 4096] = [const { AtomicBool::new(false) }; 4096];

#[inline]
pub fn runs(k: usize) -> bool {
    if !REACHED[k].load(Relaxed) && !REACHED[k].swap(true, Relaxed) {
        note(k);
    }
    *RUNS == k
}

#[cold]
fn note(k: usize) {
    if let Ok(path) = std::env::var("MUTANT_REACHED") {
        let file = std::fs::OpenOptions::new().append(true).create(true).open(path);
        // A test may make writing fail.
        let _ = file.and_then(|mut file| writeln!(file, "{k}"));
    }
}
"""


@dataclasses.dataclass
class Test:
    program: str
    folder: str
    name: str
    seconds: float = 0.0


def place(text, span):
    """The two ends of a span as places in a text."""
    starts = [0]
    for line in text.splitlines(keepends=True):
        starts.append(starts[-1] + len(line))
    return tuple(starts[span[end]["line"] - 1] + span[end]["column"] - 1 for end in ("start", "end"))


def body(text, start, end):
    """Where the body of a function begins: after its first brace that is in no comment and no attribute."""
    at = start
    for line in text[start:end].splitlines(keepends=True):
        if not line.lstrip().startswith(("//", "#")) and "{" in line:
            return at + line.index("{") + 1
        at += len(line)
    return None


class Copy:
    """The project with many mutants in it."""

    def __init__(self, folder, candidates, count):
        self.folder = folder
        self.waiting = list(candidates)
        self.count = count
        self.chosen = {}
        self.refused = 0
        self.next = 0
        for file in subprocess.run(["git", "ls-files"], text=True, capture_output=True, check=True).stdout.splitlines():
            to = folder / file
            to.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(file, to, follow_symlinks=False)
        (folder / "mutant/src").mkdir(parents=True)
        (folder / "mutant/src/lib.rs").write_text(SWITCH)
        (folder / "mutant/Cargo.toml").write_text('[package]\nname = "mutant"\nedition = "2024"\n')
        manifest = folder / "Cargo.toml"
        manifest.write_text(manifest.read_text().replace("members = [", 'members = ["mutant", ', 1))
        for package in ("plants", "lab", "figures", "cli"):
            manifest = folder / package / "Cargo.toml"
            text = manifest.read_text()
            manifest.write_text(text.replace("\n[dependencies]\n", '\n[dependencies]\nmutant = { path = "../mutant" }\n', 1))

    def fill(self):
        """Chooses mutants until there are enough: one function is not within another."""
        taken = {}
        for mutant in self.chosen.values():
            taken.setdefault(mutant["file"], set()).add(place(self.text(mutant), mutant["function"]["span"]))
        while len(self.chosen) < self.count and self.waiting:
            mutant = self.waiting.pop()
            text = self.text(mutant)
            start, end = place(text, mutant["function"]["span"])
            others = taken.setdefault(mutant["file"], set())
            nested = any((a, b) != (start, end) and a < end and start < b for a, b in others)
            begins = body(text, start, end)
            if nested or begins is None or "const fn" in text[start:begins]:
                self.refused += 1
                continue
            others.add((start, end))
            self.chosen[self.next] = mutant
            self.next += 1

    @staticmethod
    def text(mutant):
        return pathlib.Path(mutant["file"]).read_text()

    def write(self):
        """Writes every changed file; the lines of each mutant come back, by file."""
        files = {}
        for k, mutant in self.chosen.items():
            files.setdefault(mutant["file"], {}).setdefault(place(self.text(mutant), mutant["function"]["span"]), []).append(k)
        lines = {}
        for file, functions in files.items():
            text = pathlib.Path(file).read_text()
            out, at = "", 0
            for (start, end), ks in sorted(functions.items()):
                begins = body(text, start, end)
                out += text[at:begins]
                for k in ks:
                    a, b = place(text, self.chosen[k]["span"])
                    first = out.count("\n") + 2
                    out += f"\nif ::mutant::runs({k}) {{\n{text[begins:a]}{self.chosen[k]['replacement']}{text[b : end - 1]}\n}} else "
                    lines.setdefault(file, []).append((first, out.count("\n") + 1, k))
                out += "{" + text[begins : end - 1] + "}"
                at = end - 1
            (self.folder / file).write_text(out + text[at:])
        return lines

    def settle(self):
        """Drops what does not compile, and draws others for it."""
        while True:
            self.fill()
            lines = self.write()
            bad = set()
            for message in cargo(self.folder, ["check", "--workspace", "--exclude", "lyapunov-peers", "--exclude", "lyapunov-python"]):
                if message.get("reason") != "compiler-message" or message["message"]["level"] != "error":
                    continue
                spans = [s for s in message["message"]["spans"] if s["is_primary"]] or message["message"]["spans"]
                for span in spans:
                    hits = [k for a, b, k in lines.get(span["file_name"], []) if a <= span["line_start"] and span["line_end"] <= b]
                    # An error after a mutant, as in the code as it is, says that the two do not go together.
                    near = [(span["line_start"] - b, k) for a, b, k in lines.get(span["file_name"], []) if b <= span["line_start"]]
                    bad.update(hits or ([min(near)[1]] if near else []))
            print(f"{len(self.chosen)} mutants, of which {len(bad)} do not compile", file=sys.stderr)
            if not bad:
                return
            for k in bad:
                file = self.chosen.pop(k)["file"]
                self.refused += 1
                shutil.copy(file, self.folder / file)


def cargo(folder, words):
    """The messages of a build."""
    run = subprocess.run(["cargo", *words, "--message-format", "json"], cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return [json.loads(line) for line in run.stdout.splitlines() if line.startswith("{")]


def limits():
    # A changed loop can ask for all memory.
    resource.setrlimit(resource.RLIMIT_AS, (12 << 30, 12 << 30))


def passes(test, temporary, timeout, **variables):
    """Whether a test passes, in time."""
    with tempfile.TemporaryDirectory(dir=temporary, ignore_cleanup_errors=True) as own:
        process = subprocess.Popen(
            [test.program, "--exact", test.name],
            cwd=test.folder,
            env={**os.environ, "TMPDIR": own, "CARGO_MANIFEST_DIR": test.folder, **variables},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
            start_new_session=True,
            preexec_fn=limits,
        )
        try:
            return process.wait(timeout) == 0
        except subprocess.TimeoutExpired:
            return False
        finally:
            try:
                os.killpg(process.pid, 9)
            except ProcessLookupError:
                pass
            process.wait()


def tests_of(folder):
    """Every test of the project, without a change."""
    tests = []
    for message in cargo(folder, ["test", "--no-run"]):
        if message.get("reason") == "compiler-message" and message["message"]["level"] == "error":
            sys.exit(message["message"]["rendered"])
        if message.get("reason") == "compiler-artifact" and message["profile"]["test"] and message["executable"]:
            listed = subprocess.run([message["executable"], "--list"], text=True, capture_output=True, check=False).stdout
            at = str(pathlib.Path(message["manifest_path"]).parent)
            tests += [Test(message["executable"], at, line[: -len(": test")]) for line in listed.splitlines() if line.endswith(": test")]
    return tests


def reaches(tests, chosen, temporary, workers):
    """The tests that reach each mutant; tests that fail without one are left out."""
    reaching, broken = {k: [] for k in chosen}, []

    def reach(test):
        note = temporary / f"reached-{id(test)}"
        began = time.monotonic()
        passed = passes(test, temporary, 1200, MUTANT_REACHED=str(note))
        test.seconds = time.monotonic() - began
        return passed, {int(k) for k in note.read_text().split()} if note.exists() else set()

    for test, (passed, reached) in zip(tests, workers.map(reach, tests)):
        if not passed:
            broken.append(test.name)
            continue
        for k in reached & reaching.keys():
            reaching[k].append(test)
    print(f"{len(tests)} tests; without a mutant these fail, and are not asked: {broken}", file=sys.stderr)
    return reaching


def survivors(reaching, temporary, workers):
    """The mutants that no test notices."""

    def caught(k):
        tests = sorted(reaching[k], key=lambda test: test.seconds)
        return not all(passes(test, temporary, 20 + 10 * test.seconds, MUTANT=str(k)) for test in tests)

    missed = []
    for n, (k, noticed) in enumerate(zip(reaching, workers.map(caught, reaching)), 1):
        if not noticed:
            missed.append(k)
        if n % 20 == 0:
            print(f"{n} of {len(reaching)}, {len(missed)} missed", file=sys.stderr)
    return missed


def main():
    listed, count, seed, folder = sys.argv[1], int(sys.argv[2]), int(sys.argv[3]), pathlib.Path(sys.argv[4]).resolve()
    candidates = json.loads(pathlib.Path(listed).read_text())
    # What is in no function runs before any test, and what is a test judges itself.
    candidates = [it for it in candidates if it["function"] and "tests" not in pathlib.Path(it["file"]).with_suffix("").parts]
    candidates.sort(key=lambda m: m["name"])
    random.Random(seed).shuffle(candidates)
    shutil.rmtree(folder, ignore_errors=True)
    copy = Copy(folder, candidates, count)
    copy.settle()
    workers = concurrent.futures.ThreadPoolExecutor(os.cpu_count())
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as temporary:
        reaching = reaches(tests_of(folder), copy.chosen, pathlib.Path(temporary), workers)
        missed = survivors(reaching, temporary, workers)
    for k in sorted(missed, key=lambda k: copy.chosen[k]["name"]):
        print(f"{copy.chosen[k]['name']}: {len(reaching[k]) or 'no'} tests reach it")
    for package in ("plants", "lab", "figures", "cli"):
        of = [k for k, mutant in copy.chosen.items() if mutant["file"].startswith(package)]
        print(f"{package}: {len(of)} mutants, {len(set(of) - set(missed))} caught")
    print(f"seed {seed}, of {len(candidates)}; {copy.refused} more do not compile here")


main()
