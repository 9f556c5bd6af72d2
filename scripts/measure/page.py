"""Page of the ratios over time, drawn from their history."""

from html import escape

import history

PAGE = "docs/benches.md"
PICTURE = "docs/figures/benches.svg"

WIDTH, HEIGHT, GAP, TOP = 300, 150, 40, 30
COLUMNS = 3

INTRODUCTION = """# Ratios over time

How the ratios of the benches moved from commit to commit, for whoever wonders whether a change made something slower. A ratio
is the time of the first bench over that of the second, medians of one run; under 1 the first is faster. `scripts/measure.sh` adds
the rows of a machine to [benches/history.csv](../benches/history.csv) and writes this page. Compare commits on one machine
only. A `+` behind a commit: with changes that were not committed.

In the names, `generic` is the library, `hand` the same on plain numbers and `literal` the paper's steps 4 to 6 as printed; `idle`,
`random` and `always` say how often the controller acts; `held` and `sampled` are the kinds of work; `3dof` is three axes.

![The ratios of each family of benches over the commits](figures/benches.svg)

*A line for each ratio, over the commits measured on the machine with the most measurements; the dashed line is 1.*
"""


def write(root):
    """Writes the page and its picture."""
    rows = history.read(root)
    text = INTRODUCTION
    for machine in reversed(list(dict.fromkeys(row["machine"] for row in rows))):
        own = [row for row in rows if row["machine"] == machine]
        text += f"\n## {machine}\n\n{table(own)}"
    (root / PAGE).write_text(text)
    machines = [row["machine"] for row in rows]
    most = max(machines, key=machines.count)
    (root / PICTURE).write_text(picture([row for row in rows if row["machine"] == most]))


def commits(rows):
    """The commits of the rows, the oldest first."""
    dates = {row["commit"]: row["date"] for row in rows}
    return sorted(dates, key=lambda commit: dates[commit])


def by_bench(rows):
    """For each bench its ratios by commit."""
    benches = {}
    for row in rows:
        benches.setdefault(row["bench"], {})[row["commit"]] = float(row["ratio"])
    return dict(sorted(benches.items()))


def table(rows):
    """The first ratio of each bench, the one before the last, and the last."""
    dates = {row["commit"]: row["date"] for row in rows}
    order = commits(rows)
    text = f"Last measured: `{order[-1]}` of {dates[order[-1]]}; {len(order)} in all, from {dates[order[0]]} on.\n\n"
    text += "| bench | first | before | last |\n|---|---|---|---|\n"
    for bench, ratios in by_bench(rows).items():
        values = [f"{ratios[commit]:.3g}" for commit in order if commit in ratios]
        before = values[-2] if len(values) > 1 else ""
        one, other = bench.split(" over ")
        text += f"| `{one}` over `{other}` | {values[0]} | {before} | {values[-1]} |\n"
    return text


def picture(rows):
    """The ratios as SVG, a panel for each family."""
    order = commits(rows)
    families = {}
    for bench, ratios in by_bench(rows).items():
        families.setdefault(bench.split("/")[0], []).append((bench, ratios))
    lines = -(-len(families) // COLUMNS)
    width = COLUMNS * (WIDTH + GAP) + GAP
    height = lines * (HEIGHT + GAP + TOP) + GAP
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
        'font-family="DejaVu Sans, sans-serif" font-size="11">',
        f'<rect width="{width}" height="{height}" fill="white"/>',
    ]
    for index, (family, benches) in enumerate(families.items()):
        left = GAP + index % COLUMNS * (WIDTH + GAP)
        top = TOP + index // COLUMNS * (HEIGHT + GAP + TOP)
        parts += panel(family, benches, order, left, top)
    return "\n".join([*parts, "</svg>"]) + "\n"


def panel(family, benches, order, left, top):
    """A family's panel, with a line for each bench."""
    values = [value for _, ratios in benches for value in ratios.values()]
    most = 1.1 * max([1.0, *values])

    def height(value):
        return top + HEIGHT * (1 - value / most)

    def place(commit):
        return left + WIDTH * (order.index(commit) + 0.5) / len(order)

    bottom = top + HEIGHT
    parts = [
        f'<text x="{left}" y="{top - 8}" font-size="13">{escape(family)}</text>',
        f'<path d="M{left} {top}V{bottom}H{left + WIDTH}" fill="none" stroke="#444"/>',
        f'<path d="M{left} {height(1):.1f}H{left + WIDTH}" stroke="#888" stroke-dasharray="4 3"/>',
    ]
    for value in sorted({0.0, 1.0, most / 1.1}):
        if value in (0.0, 1.0) or abs(value - 1) > 0.15 * most:
            y = height(value) + 4
            parts.append(f'<text x="{left - 4}" y="{y:.1f}" text-anchor="end">{value:.3g}</text>')
    for commit in dict.fromkeys([order[0], order[-1]]):
        x, text = place(commit), escape(commit[:7])
        parts.append(f'<text x="{x:.1f}" y="{bottom + 14}" text-anchor="middle">{text}</text>')
    for bench, ratios in benches:
        at = [(place(commit), height(ratios[commit])) for commit in order if commit in ratios]
        line = "L".join(f"{x:.1f} {y:.1f}" for x, y in at)
        parts.append(f'<g stroke="#1f5fa8" fill="#1f5fa8" stroke-opacity="0.5" fill-opacity="0.5"><title>{escape(bench)}</title>')
        parts.append(f'<path d="M{line}" fill="none"/>')
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.5" stroke="none"/>' for x, y in at]
        parts.append("</g>")
    return parts
