"""Tables of times in the docs, each between two comments."""

import json
import re
import subprocess

import history

SCALARS = ["f64", "f32"]
FINEST = [
    ("exact", None, "f64", "exact"),
    ("exact", None, "f32", "exact, f32"),
    ("rk4", 1, "f64", "rk4, 1 step"),
    ("rk4", 10, "f64", "rk4, 10 steps"),
    ("rk4", 100, "f64", "rk4, 100 steps"),
    ("dop853", 1e-6, "f64", "dop853, 1e-06"),
    ("dopri5", 1e-9, "f64", "dopri5, 1e-09"),
    ("implicit-midpoint", 10, "f64", "implicit-midpoint, 10 steps"),
    ("semi-implicit-euler", 1, "f64", "semi-implicit-euler, 1 step"),
    ("semi-implicit-euler", 100, "f64", "semi-implicit-euler, 100 steps"),
]


def markdown(headings, rows):
    """A table in Markdown."""
    lines = ["| " + " | ".join(str(cell) for cell in line) + " |" for line in [headings, *rows]]
    lines.insert(1, "|" + "---|" * len(headings))
    return "\n".join(lines).replace("|  |", "| |")


def step(measured, _):
    """The README's step of LOLC, and the force that waits for a step."""
    size = {"f64": 24, "f32": 12}
    rows = []
    for scalar in SCALARS:
        for axes, name in [(1, "1 axis"), (3, "3 axes")]:
            bench = f"step/held/{scalar}/{axes}dof/random"
            times = [f"{measured[f'{bench}/{form}']:.1f}" for form in ["generic", "hand"]]
            rows.append([f"`{scalar}`, {name}", *times, size[scalar]])
    latencies = []
    for scalar in SCALARS:
        for mix in ["idle", "random", "always"]:
            bench = f"latency/sampled/{scalar}/{mix}"
            ratio = measured.ratio(f"{bench}/generic", f"{bench}/literal")
            latencies.append([f"`{scalar}`, {mix}", f"{ratio:.2f}"])
    return {
        "README.md": {"step": markdown(["", "ns a tick", "by hand", "bytes of state"], rows)},
        "docs/stabilizers.md": {
            "latency": markdown(["from force in to force out, sampled work", "over the printed recursion"], latencies)
        },
    }


def stabilizers(measured, _):
    """The steps that have a form by hand, and what telemetry costs."""
    names = {"popc": "`Popc`", "lolc": "`Lolc`", "force-bound": "`ForceBound`", "tank": "`Tank`"}
    rows = []
    for name, shown in names.items():
        cells = []
        for port in [f"{scalar}/{axes}dof" for scalar in SCALARS for axes in [1, 3, 6]]:
            bench = f"stabilizers/{name}/{port}"
            ratio = measured.ratio(bench, f"stabilizers/{name}-by-hand/{port}")
            cells.append(f"{measured[bench]:.1f} ({ratio:.2f})")
        rows.append([shown, *cells])
    headings = ["", *[f"`{scalar}`, {axes}" for scalar in SCALARS for axes in ["1 axis", "3 axes", "6 axes"]]]
    chosen = {
        "popc": "`Popc`",
        "popc-member": "`Member::Popc`",
        "popc-boxed": "`Box<dyn Stabilizer>`",
        "popc-recorded": "`Popc`, with ring and meter",
    }
    telemetry = [[shown, f"{measured[f'stabilizers/{name}/f64/1dof']:.1f}"] for name, shown in chosen.items()]
    return {
        "docs/stabilizers.md": {"stabilizers": markdown(headings, rows)},
        "docs/telemetry.md": {"stabilizers": markdown(["", "ns a tick"], telemetry)},
    }


def scene(measured, _):
    """Scenes beside the same loops composed by type."""
    rows = []
    for effects in ["0", "2", "4", "8", "8-random"]:
        row = [effects.replace("-", ", ")]
        for scalar in ["f64", "f64x8"]:
            pair = [f"scene/{form}/{scalar}/{effects}" for form in ["built", "typed"]]
            lanes = 8 if scalar == "f64x8" else 1
            row += [f"{lanes * measured[bench]:.0f}" for bench in pair]
            row.append(f"{measured.ratio(*pair):.2f}")
        rows.append(row)
    headings = ["effects", "f64: scene", "by type", "ratio", "f64x8: scene", "by type", "ratio"]
    return {"docs/effects/costs.md": {"scene": markdown(headings, rows)}}


def map_(measured, _):
    """Rollout-steps of a map's plain kernel."""
    rows = []
    for scalar in SCALARS:
        one = f"map/scalar/{scalar}"
        sets = [one, *[name for name in measured if re.fullmatch(rf"map/lanes/{scalar}(/.*)?", name)]]
        for bench in sets:
            rows.append([f"`{bench}`", f"{1e3 / measured[bench]:.0f}", f"{measured.ratio(one, bench):.1f}"])
    headings = ["one core", "million rollout-steps per second", "of `scalar`"]
    return {"docs/map.md": {"map": markdown(headings, rows)}}


def prices(_, results):
    """The price list."""
    return {"docs/effects/prices.md": {"prices": fenced(results / "prices.txt")}}


def peers(_, results):
    """Exact motion beside other projects."""
    return {"docs/peers.md": {"peers": fenced(results / "peers.txt")}}


def accuracy(_, results):
    """The settings and ledgers of the accuracy study."""
    lolc, none = [json.loads((results / f"accuracy-paper-8k-{name}.json").read_text()) for name in ["lolc", "none"]]
    rows = []
    for propagator, detail, scalar, shown in FINEST:

        def row(study):
            for row in study["rows"]:
                if (row["propagator"], row["scalar"]) == (propagator, scalar):
                    if detail in (row["steps_per_tick"], row["tolerance"]):
                        return row
            raise KeyError(shown)

        one, other = row(lolc), row(none)
        horizon = one["horizon_s"]
        believed = "the end" if horizon is None else f"{horizon:.2f} s"
        time = f"{one['ns_per_simulated_second'] / 1e3:.3g} µs"
        errors = [f"{it['max_error']:.1e} m" for it in (one, other)]
        rows.append([shown, time, errors[0], believed, errors[1]])
    ends = [f"{study['errors_until_s']:.2f} s" for study in (lolc, none)]
    headings = [
        "setting",
        "per simulated s",
        f"largest error, LOLC ({ends[0]})",
        "believed for",
        f"largest error, none ({ends[1]})",
    ]
    ledgers = [
        [row["scalar"], row["ledger"], f"{row['error_j']:.1e} J", f"{row['ns_per_tick']:.1f} ns"]
        for row in lolc["ledger"]
    ]
    return {
        "docs/accuracy.md": {
            "accuracy": markdown(headings, rows),
            "ledger": markdown(["scalar", "ledger", "error", "per tick"], ledgers),
        }
    }


PARTS = {
    "step": step,
    "stabilizers": stabilizers,
    "scene": scene,
    "map": map_,
    "prices": prices,
    "peers": peers,
    "accuracy": accuracy,
}


def fenced(file):
    """The text of a file, as the terminal shows it."""
    text = file.read_text().strip("\n")
    return f"```text\n{text}\n```"


def write(root, results, measured, parts):
    """Writes the tables of `parts`; returns what could not be written, and why."""
    rust = subprocess.run(["rustc", "--version"], check=True, capture_output=True, text=True).stdout
    place = f"On {history.machine()}, with {' '.join(rust.split()[:2])}:"
    skipped = []
    for part in parts:
        if part not in PARTS:
            continue
        for page, blocks in PARTS[part](measured, results).items():
            text = (root / page).read_text()
            for name, block in blocks.items():
                block = f"{place}\n\n{block}"
                pattern = rf"(<!-- measured: {name} -->\n\n).*?(\n\n<!-- end -->)"
                text, count = re.subn(pattern, lambda found: found[1] + block + found[2], text, flags=re.DOTALL)
                if count == 0:
                    skipped.append(f"a table of {page}, which has no place called `{name}`")
            (root / page).write_text(text)
    return skipped
