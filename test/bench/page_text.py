# SPDX-License-Identifier: BSD-3-Clause
"""The page of performance, of what test/bench/page measured. A figure with a target says whether it meets it."""

import re
import statistics

from bench_report import NONE, PEERS, TRIANGLES, cell, digits, line, wall_cells
from history import LOOPS

TICKS = (("rod", "the published insertion"), ("tissue_flex28", "FLEX28 on the friction of tissue, slowly"),
         ("stiff_wall", "Contour against bone"), ("withdrawal", "out of the published cochlea"),
         ("random_hand", "random hand, rough bone on a spring"), ("rim_fold", "random hand, through the round window"),
         ("points", "the model of points"))
# Maximum of a figure [us]: those of the published insertion, and a tick of 100 nodes in any that ends before the next begins.
TARGETS = {"tick/rod/nodes:100": {"p50_us": 25.0, "p99_us": 60.0}, "tick/rod/nodes:200": {"p50_us": 50.0},
           "tick/rod/nodes:1000": {"p50_us": 250.0}}
PERIOD_US = 1000.0
# Work that the solver allows itself in a tick.
BUDGET = {"max_evaluations": 32, "max_factorizations": 10}
# Ticks that a loop may lack at its start and end [%].
MISSED_PERCENT = 0.05
# Other work than this [% of the processors' time] makes figures too large to be believed.
QUIET_PERCENT = 2.0


def verdict(name, value, target):
    """A maximum and whether a figure is at most that."""
    if value <= target:
        return f"{name} {target:,.0f}: met"
    by = f"by {100.0 * (value / target - 1.0):.0f} %" if value < 2.0 * target else f"{value / target:,.0f} times"
    return f"**{name} {target:,.0f}: missed {by}**"


def targets_of(row):
    goals = dict(TARGETS.get(row, {}))
    if row.endswith("/nodes:100"):
        goals["max_us"] = PERIOD_US
    return goals


def table(*titles):
    yield line(titles)
    yield line(["---"] * len(titles))


def machine_lines(found):
    here = found["machine"]
    memory = f", {here['memory_gb']:.0f} GB" if here.get("memory_gb") else ""
    yield (f"Version {found['version']}, commit `{found['commit']}`, {found['date']}. {here['processor']}, {here['cores']} cores"
           f"{', virtual' if here['is_virtual'] else ''}{memory}, {here['system']}.")
    yield (f"Load {here['load']:.1f} before; during it, other programs took {here['others_percent']:.1f} % of the processors' time"
           f"{', and the host withheld ' + format(here['stolen_percent'], '.1f') + ' %' if here['is_virtual'] else ''}.")
    if here["others_percent"] + here["stolen_percent"] > QUIET_PERCENT:
        yield "**The machine was busy with other work: the figures are too large, most of all the maxima.**"
    runs = f"{found['runs']} runs" if found["runs"] > 1 else "1 run"
    yield (f"Each figure is the least of {runs}, because other work only adds to it; those of the loop, the study,\nthe library, the "
           "validation, the plan and the window are of one run.")


def tick_order(row):
    """By scenario, nodes, threads."""
    names = [name for name, _ in TICKS]
    name, nodes = row.split("/")[1], re.search(r"nodes:(\d+)", row)
    return names.index(name) if name in names else len(names), name, "threads" in row, int(nodes[1]) if nodes else 0


def tick_lines(found):
    rows = found["rows"]
    ticks = sorted((row for row in rows if row.startswith("tick/")), key=tick_order)
    if not ticks:
        yield "No tick was measured."
        return
    yield from table("a tick, µs", "median", "p99", "max", "evaluations, mean (max)", "target")
    titles = dict(TICKS)
    for row in ticks:
        name, *sizes = row.split("/")[1:]
        about = ", ".join(each.replace("nodes:", "").replace("threads:2", "two at once") for each in sizes)
        work = cell(rows, row, "evaluations")
        work += f" ({rows[row]['max_evaluations']:.0f})" if "max_evaluations" in rows[row] else ""
        goals = [verdict({"p50_us": "median", "p99_us": "p99", "max_us": "max"}[figure], rows[row][figure], target)
                 for figure, target in targets_of(row).items() if figure in rows[row]]
        yield line([f"{titles.get(name, name)}, {about}", *(cell(rows, row, each) for each in ("p50_us", "p99_us", "max_us")), work, "; ".join(goals)])
    yield ""
    for figure, limit in BUDGET.items():
        counts = [rows[row][figure] for row in ticks if figure in rows[row]]
        if counts:
            kept = "kept" if max(counts) <= limit else f"**exceeded: {max(counts):.0f}**"
            yield f"Budget of a tick: {limit} {figure.removeprefix('max_')}, {kept}."


def loop_lines(found):
    rows = found["rows"]
    yield from table("loop on the clock, 100 nodes", "ticks a second", "late, %", "longest tick, µs", "priority", "target")
    for name, row in LOOPS:
        here, title = rows.get(row), name.replace("kHz", " kHz")
        if not here:
            yield line([title, *[NONE] * 5])
            continue
        wanted = 1e6 / float(re.search(r"period_us:(\d+)", row)[1])
        missing = 100.0 * (1.0 - here["ticks_per_s"] / wanted)
        met = f"{wanted:,.0f}: met" if missing < MISSED_PERCENT else f"**{wanted:,.0f}: missed by {missing:.1f} %**"
        yield line([title, f"{here['ticks_per_s']:,.0f}", f"{here['late_percent']:.2f}", cell(rows, row, "max_us"),
                    "real-time" if here.get("real_time_priority") else "ordinary", met])


def wall_lines(found):
    yield from table("nearest wall, ns a query", "our lumen", *(title for title, _ in PEERS))
    for triangles in TRIANGLES:
        yield line(wall_cells(found["rows"], triangles))


# Row, figure, text before the value, unit.
WORK = (("simulate", "seconds", "one insertion, 8,250 ticks, with the building of cochlea and model (`simulate`)", "s"),
        ("validate", "seconds", "the published experiment, 200 times, with the shares of its variability (`validate`)", "s"),
        ("plan", "seconds", "a plan of one array with 16 simulations (`plan`)", "s"),
        ("study/insertions/jobs:1/real_time", "insertions_per_s", "a study's insertions in steps of 5 ms, one thread", "a second"),
        ("study/insertions/jobs:2/real_time", "insertions_per_s", "the same, two threads", "a second"),
        ("library/first/sessions:10000/iterations:1", "real_time", "a library of 10,000 recordings, opened for the first time", "ms"),
        ("library/known/sessions:10000/iterations:3", "real_time", "the same, known", "ms"),
        ("window", "first_frame_s", "start-up of the window, until its first picture", "s"),
        ("window", "frame_median_ms", "a frame during an insertion, median", "ms"),
        ("window", "frame_p95_ms", "95th percentile", "ms"),
        ("study_window", "frame_median_ms", "a frame of a study with 10,000 insertions while it is filtered, median", "ms"),
        ("study_window", "frame_p95_ms", "95th percentile", "ms"))


def work_lines(found):
    yield from table("what", "value")
    for row, figure, title, unit in WORK:
        value = cell(found["rows"], row, figure)
        yield line([title, value if value == NONE else f"{value} {unit}"])


def former_lines(found):
    former = found.get("former")
    if not former:
        yield "No former release was given (`--former FOLDER`), so nothing is compared."
        return
    yield (f"Version {former['version']}, commit `{former['commit']}`, was run in turns with this one, so that other work strikes both alike. "
           "Below 1 is faster.")
    yield ""
    yield from table(f"this / {former['version']}", "median", "least", "greatest", "pairs")
    for row, each in former["ratios"].items():
        yield line([f"`{row}`", f"{statistics.median(each):.2f}", f"{min(each):.2f}", f"{max(each):.2f}", str(len(each))])
    yield ""
    yield "Rows that the former release does not have are not compared."


def page(found):
    """The lines of the page."""
    yield from ("# Performance", "", "`test/bench/page` measured this and wrote this page; it can be repeated on any machine. "
                "`test/bench/history.csv` lists the releases.", "", *machine_lines(found))
    yield from ("", "## Ticks", "", "The engine computes a tick every 1,000 µs; the number is that of nodes.", "", *tick_lines(found))
    yield from ("", *loop_lines(found))
    yield from ("", "## Queries of the wall, and libraries", "",
                "Each library answers the same query on the same wall, and its answers are compared with ours;\nBullet can only list all "
                "contacts within 0.6 mm. A dash is a library that is not installed.", "", *wall_lines(found))
    yield from ("", "## Insertions, plans, window", "", "All processors; the window has 1280 × 800 and is drawn by software on a screen in memory.",
                "", *work_lines(found))
    yield from ("", "## Beside the former release", "", *former_lines(found))
