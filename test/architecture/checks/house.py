# SPDX-License-Identifier: BSD-3-Clause
"""The module diagram, generated from the table of dependencies, so that it is always correct.

    python3 test/architecture/check.py house .          is resources/pictures/house.svg up to date?
    python3 test/architecture/checks/house.py .         draws it
"""

import sys
from pathlib import Path
from xml.sax.saxutils import escape

if __name__ == "__main__":
    sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from checks import arrows, sources  # noqa: E402

PICTURE = "resources/pictures/house.svg"
WIDTH, MARGIN, BOX, STEP, SPACE, SWEEPS = 1180, 20, (190, 44), 92, 232, 12
INK, LINE, PAPER = "#1c2733", "#8a97a5", "#ffffff"
FILL = {"engine": "#dcebf7", "toolkit": "#e3f0dd", "app": "#f6e7cf"}
SAID = {"engine": "engine: C++ and Eigen, no VTK, no Qt", "toolkit": "toolkit: may use VTK", "app": "programs"}


def kind(layer):
    return "engine" if layer <= 6 else "toolkit" if layer <= 7 else "app"


def places(rows):
    """Name -> (x, y) of the center of its box: layer 0 at the bottom, each near its neighbors in the graph."""
    layers = sorted({layer for layer, _, _ in rows.values()})
    y = {layer: MARGIN + 60 + STEP * (len(layers) - 1 - i) for i, layer in enumerate(layers)}
    floors = {layer: [name for name, (each, _, _) in rows.items() if each == layer] for layer in layers}
    near = {name: list(uses) + [other for other, (_, used, _) in rows.items() if name in used]
            for name, (_, uses, _) in rows.items()}
    x = {name: WIDTH * (i + 1) / (len(names) + 1) for names in floors.values() for i, name in enumerate(names)}
    for _ in range(SWEEPS):
        for names in floors.values():
            wish = {name: sum(x[other] for other in near[name]) / len(near[name]) if near[name] else x[name]
                    for name in names}
            names.sort(key=lambda name: (wish[name], name))
            for i, name in enumerate(names):
                left = x[names[i - 1]] + SPACE if i else MARGIN + BOX[0] / 2
                right = WIDTH - MARGIN - BOX[0] / 2 - SPACE * (len(names) - 1 - i)
                x[name] = min(max(wish[name], left), right)
    return {name: (round(x[name]), y[layer]) for name, (layer, _, _) in rows.items()}


def draw(root):
    """The diagram as SVG text; the same bytes each time."""
    table = sources.table(sources.read(Path(root) / "modules/README.md"), "arrows")
    drawn, _ = arrows.drawn(root)
    knows = {sources.quoted(row[1])[0]: row[4] for row in table}
    every = {sources.quoted(row[1])[0] for row in table if row[2] == "every module"}
    rows = {name: (layer, uses, knows[name]) for name, (layer, uses) in drawn.items()}
    middle = places(rows)
    height = max(y for _, y in middle.values()) + BOX[1] + MARGIN
    lines, boxes = [], []
    for name, (layer, uses, what) in rows.items():
        x, y = middle[name]
        for used in [] if name in every else uses:
            to_x, to_y = middle[used]
            begin, end = y + BOX[1] / 2, to_y - BOX[1] / 2
            bend = (begin + end) / 2
            lines.append(f'<path d="M{x} {begin:g} C{x} {bend:g} {to_x} {bend:g} {to_x} {end:g}" '
                         f'marker-end="url(#tip)"/>')
        boxes.append(f'<rect x="{x - BOX[0] / 2:g}" y="{y - BOX[1] / 2:g}" width="{BOX[0]}" height="{BOX[1]}" rx="5" '
                     f'fill="{FILL[kind(layer)]}" stroke="{INK}"/>')
        short = what if len(what) <= 34 else what[:what.rfind(" ", 0, 33)].rstrip(",:") + " …"
        boxes.append(f'<text x="{x}" y="{y - 4}" font-weight="600" font-size="14">{escape(name)}</text>')
        boxes.append(f'<text x="{x}" y="{y + 13}" font-size="10">{escape(short)}</text>')
    legend = []
    for i, (name, said) in enumerate(SAID.items()):
        x = MARGIN + 330 * i
        legend.append(f'<rect x="{x}" y="{MARGIN - 6}" width="14" height="14" fill="{FILL[name]}" stroke="{INK}"/>')
        legend.append(f'<text x="{x + 22}" y="{MARGIN + 6}" font-size="12" text-anchor="start">{escape(said)}</text>')
    return "\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{height:g}" viewBox="0 0 {WIDTH} {height:g}" '
        f'font-family="Inter, DejaVu Sans, sans-serif" text-anchor="middle" fill="{INK}">',
        "<title>The modules of Perilymph: an arrow points to what a module may use</title>",
        f'<defs><marker id="tip" viewBox="0 0 8 8" refX="8" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
        f'<path d="M0 0 L8 4 L0 8 z" fill="{LINE}"/></marker></defs>',
        f'<rect width="{WIDTH}" height="{height:g}" fill="{PAPER}"/>',
        *legend,
        f'<g fill="none" stroke="{LINE}" stroke-width="1.2">', *lines, "</g>",
        *boxes,
        "</svg>", ""])


def check(root):
    root = Path(root)
    if not (root / PICTURE).is_file():
        return [f"{PICTURE} is missing: python3 test/architecture/checks/house.py . draws it."]
    if sources.read(root / PICTURE) != draw(root):
        return [f"{PICTURE} is not what modules/README.md says now: python3 test/architecture/checks/house.py . draws it."]
    return []


if __name__ == "__main__":
    place = Path(sys.argv[1] if len(sys.argv) > 1 else ".")
    (place / PICTURE).write_text(draw(place), encoding="utf-8")
