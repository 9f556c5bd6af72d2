"""What the boards told, as the tables of docs/embedded.md: checked, or written with --write.

report.py [--write] RUSTC FOLDER, with BOARD.txt (what the program printed), BOARD.asm (its disassembly) for each board.
"""

import re
import sys
from pathlib import Path

BOARDS = {"m4f": "M4F", "m7": "M7", "m0": "M0"}
PAGE = Path(__file__).parents[2] / "docs" / "embedded.md"
MARKS = ("<!-- tables of tests/embedded/report.py -->", "<!-- end of tables -->")
FORBIDDEN = re.compile(r"panic|rust_begin_unwind|unwrap_failed|expect_failed|alloc|4core3fmt|core::fmt")


class Function:
    """One function of a disassembly: its bytes, its frame, what it calls."""

    def __init__(self, address, name):
        self.address, self.name = address, name
        self.end, self.frame, self.calls, self.unknown = address, 0, set(), None

    def read(self, address, text):
        operation, _, operands = text.partition("\t")
        if operation != "bmi.n":  # The linker fills what alignment leaves with it.
            self.end = address + 2
        name = operation.split(".")[0]
        target = re.match(r"(?:\w+, )?([0-9a-f]+) <", operands)
        if name in ("push", "vpush"):
            self.frame += pushed(operands, 8 if "d" in operands.split("{")[1][:1] else 4)
        elif name in ("sub", "subw") and operands.startswith("sp,"):
            self.frame += constant(operands, self.name)
        elif name == "add" and operands.startswith("sp, r"):
            self.unknown = text
        elif re.search(r"\[sp, #-\d+\]!", operands):
            self.frame += int(re.search(r"#-(\d+)", operands)[1])
        elif name in ("bl", "b", "cbz", "cbnz") or re.fullmatch(r"b[a-z]{2}", name) and target:
            self.calls.add(int(target[1], 16))
        elif name in ("blx", "bx") and operands.strip() != "lr":
            self.unknown = text


def pushed(operands, each):
    """Bytes of a list of registers."""
    registers = 0
    for part in operands.strip("{} ").split(","):
        first, _, last = part.strip().strip("{}").partition("-")
        registers += int(last[1:]) - int(first[1:]) + 1 if last else 1
    return each * registers


def constant(operands, name):
    number = re.search(r"#(\d+)", operands)
    if not number:
        sys.exit(f"{name}: a frame that is not a constant: sub {operands}")
    return int(number[1])


def functions(path):
    """Functions of a disassembly by address."""
    found, current = {}, None
    for line in path.read_text().splitlines():
        if head := re.match(r"([0-9a-f]{8}) <(.+)>:$", line):
            address = int(head[1], 16)
            current = found.setdefault(address, Function(address, head[2]))
        elif current and (body := re.match(r" +([0-9a-f]+):\t(.+)", line)):
            text = re.sub(r"\s*[@;].*", "", body[2])
            width = 4 if re.match(r"(\.word|bl\b|\w+\.w\b|v\w+)", text) else 2
            current.read(int(body[1], 16) + width - 2, text)
    for function in found.values():
        function.calls = {call for call in function.calls if call in found} - {function.address}
    return found


def reached(code, start):
    """Functions that a call of `start` may reach, in any order."""
    seen, left = set(), [start]
    while left:
        address = left.pop()
        if address not in seen:
            seen.add(address)
            left += code[address].calls
    return [code[address] for address in seen]


def deepest(code, address, above=()):
    """Bytes of stack of the deepest path."""
    if address in above:
        sys.exit(f"{code[address].name} calls itself, so its stack has no bound")
    inside = (deepest(code, call, above + (address,)) for call in code[address].calls)
    return code[address].frame + max(inside, default=0)


def audited(code, board, name, start):
    """Stack and flash of a step, which reaches no panic, no allocation and nothing unknown."""
    within = reached(code, start)
    for function in within:
        if FORBIDDEN.search(function.name):
            sys.exit(f"{board}: a step of {name} reaches {function.name}")
        if function.unknown:
            sys.exit(f"{board}: {name}: {function.name} goes where cannot be told: {function.unknown}")
    return deepest(code, start), sum(function.end - function.address for function in within)


def board(folder, key):
    """Rows of one board: hash, instructions of the longest step, bytes of the value, stack, flash."""
    code, rows = functions(folder / f"{key}.asm"), {}
    for line in (folder / f"{key}.txt").read_text().splitlines():
        name, scalar, told, _, most, address, size = line.split()
        stack, flash = audited(code, BOARDS[key], f"{name}/{scalar}", int(address, 16))
        rows[name, scalar] = told, int(most), int(size), stack, flash
    main = next(it for it in code.values() if it.name == "main")
    if not any(FORBIDDEN.search(it.name) for it in reached(code, main.address)):
        sys.exit(f"{BOARDS[key]}: no panic is found where there are some: the search is blind")
    return rows


def table(heads, rows):
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows]


def tables(boards, rustc):
    names = [name for name, scalar in boards["m4f"] if scalar == "f32"]
    both = [(key, scalar) for key in boards for scalar in ("f32", "f64")]
    heads = [f"{BOARDS[key]} `{scalar}`" for key, scalar in both]

    def of(name, field):
        return [boards[key][name, scalar][field] for key, scalar in both]

    first = [[f"`{name}`"] + [f"`{boards['m4f'][name, scalar][0]}`" for scalar in ("f32", "f64")] for name in names]
    second = [[f"`{name}`", *of(name, 1)] for name in names]
    third = [[f"`{name}`", *of(name, 2)[:2], *of(name, 3)] for name in names]
    fourth = [[f"`{name}`", *of(name, 4)] for name in names]
    return [
        "## Hashes", "", *table(["member", "`f32`", "`f64`"], first), "",
        f"## Instructions of the longest step, by rustc {rustc}", "", *table(["member", *heads], second), "",
        "## Bytes of the value, and of stack", "", *table(["member", "value `f32`", "`f64`", *heads], third), "",
        "## Bytes of flash", "", *table(["member", *heads], fourth),
    ]  # fmt: skip


def main():
    write = "--write" in sys.argv
    rustc, folder = sys.argv[-2], Path(sys.argv[-1])
    boards = {key: board(folder, key) for key in BOARDS}
    page = PAGE.read_text()
    before, rest = page.split(MARKS[0])
    old, after = rest.split(MARKS[1])
    new = tables(boards, rustc)
    if write:
        PAGE.write_text(before + MARKS[0] + "\n" + "\n".join(new) + "\n" + MARKS[1] + after)
        return
    told = old.strip().splitlines()
    end = new.index("") + 1 + new[2:].index("") + 1
    if told[:end] != new[:end]:
        sys.exit(difference(told[:end], new[:end]) + "\nA change of a hash is a decision with a page.")
    if f"by rustc {rustc}" not in old:
        print(f"SKIPPED: instructions, stack and flash on the page are of another compiler than rustc {rustc}")
    elif not alike(told, new):
        sys.exit(difference(told, new) + "\ntests/embedded/run.sh write writes the tables.")


def alike(told, new):
    """Whether all numbers are within one per cent and what the folder of a build moves: an instruction, 16 bytes of padding."""
    number = re.compile(r"\b\d+\b")
    if [number.sub("0", line) for line in told] != [number.sub("0", line) for line in new]:
        return False
    slack = 1
    for a, b in zip(told, new):
        slack = 16 if b.startswith("## Bytes") else slack
        pairs = zip(map(int, number.findall(a)), map(int, number.findall(b)))
        if any(abs(there - here) > slack + here // 100 for there, here in pairs):
            return False
    return True


def difference(told, new):
    pairs = [f"docs/embedded.md: {a}\nmeasured:         {b}" for a, b in zip(told, new) if a != b]
    return "\n".join(pairs[:10]) or "docs/embedded.md has other rows than were measured"


main()
