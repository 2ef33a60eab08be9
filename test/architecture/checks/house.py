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
WIDTH, MARGIN, BOX, STEP, SPACE, LANE, SWEEPS = 1180, 20, (190, 44), 92, 216, 22, 40
INK, LINE, PAPER = "#1c2733", "#8a97a5", "#ffffff"
FILL = {"engine": "#dcebf7", "toolkit": "#e3f0dd", "app": "#f6e7cf"}
SAID = {"engine": "engine: C++ and Eigen, no VTK, no Qt", "toolkit": "toolkit: may use VTK", "app": "programs"}


def kind(layer):
    return "engine" if layer <= 7 else "toolkit" if layer <= 8 else "app"


def between(layers, above, below):
    return [layer for layer in layers if below < layer < above]


def spread(order, wish, width):
    """x of each, in that order, as near to its wish as widths and margins allow."""
    def pushed(order, wish):
        """As near as those before it in the order allow, and with place for those behind it."""
        x, edge, rest = {}, MARGIN, sum(map(width, order))
        for name in order:
            rest -= width(name)
            x[name] = min(max(wish[name], edge + width(name) / 2), WIDTH - MARGIN - rest - width(name) / 2)
            edge = x[name] + width(name) / 2
        return x

    right = pushed(order, wish)
    left = pushed(order[::-1], {name: WIDTH - wish[name] for name in order})
    return {name: (right[name] + WIDTH - left[name]) / 2 for name in order}


def places(rows):
    """Name -> (x, y) of the center of its box: layer 0 at the bottom, each near its neighbors in the graph. An arrow
    crosses a layer in a lane, (name of its end, layer), which has a place there, too."""
    layers = sorted({layer for layer, _, _ in rows.values()})
    y = {layer: MARGIN + 60 + STEP * (len(layers) - 1 - i) for i, layer in enumerate(layers)}
    floors = {layer: [name for name, (each, _, _) in rows.items() if each == layer] for layer in layers}
    near = {name: [] for name in rows}
    for name, (layer, uses, _) in rows.items():
        for used in uses:
            chain = [name, *((used, each) for each in reversed(between(layers, layer, rows[used][0]))), used]
            for upper, lower in zip(chain, chain[1:]):
                for each in (upper, lower):
                    if each not in near:
                        near[each] = []
                        floors[each[1]].append(each)
                near[upper].append(lower)
                near[lower].append(upper)

    def width(item):
        return LANE if isinstance(item, tuple) else SPACE

    x = {name: WIDTH * (i + 1) / (len(names) + 1) for names in floors.values() for i, name in enumerate(names)}
    for sweep in range(SWEEPS):
        for layer in layers if sweep % 2 else reversed(layers):
            names = floors[layer]
            wish = {name: sum(x[other] for other in near[name]) / len(near[name]) if near[name] else x[name]
                    for name in names}
            names.sort(key=lambda name: (round(wish[name], 3), str(name)))
            x.update(spread(names, wish, width))
    return {name: (round(x[name]), y[layer]) for layer, names in floors.items() for name in names}


def draw(root):
    """The diagram as SVG text; the same bytes each time."""
    table = sources.table(sources.read(Path(root) / "modules/README.md"), "arrows")
    drawn, _ = arrows.drawn(root)
    knows = {sources.quoted(row[1])[0]: row[4] for row in table}
    every = {sources.quoted(row[1])[0] for row in table if row[2] == "every module"}
    rows = {name: (layer, uses, knows[name]) for name, (layer, uses) in drawn.items()}
    middle = places(rows)
    height = max(y for _, y in middle.values()) + BOX[1] + MARGIN
    layers = sorted({layer for layer, _, _ in rows.values()})
    lines, boxes = {}, []
    for name, (layer, uses, what) in rows.items():
        for used in [] if name in every else uses:
            (x, y), down = middle[name], middle[name][1] + BOX[1] / 2
            path = f"M{x} {down:g}"
            for stop in [*((used, each) for each in reversed(between(layers, layer, rows[used][0]))), used]:
                to_x, to_y = middle[stop]
                bend = (down + to_y - BOX[1] / 2) / 2
                path += f" C{x} {bend:g} {to_x} {bend:g} {to_x} {to_y - BOX[1] / 2:g}"
                lines[path + '"' + (' marker-end="url(#tip)"' if stop == used else "")] = None
                x, down = to_x, to_y + BOX[1] / 2
                path = f"M{x} {to_y - BOX[1] / 2:g} V{down:g}"
        x, y = middle[name]
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
        f'<g fill="none" stroke="{LINE}" stroke-width="1.2">',
        *(f'<path d="{line}/>' for line in lines), "</g>",
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
