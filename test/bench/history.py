# SPDX-License-Identifier: BSD-3-Clause
"""The performance of releases: history.csv, with a row for each version and commit, the former release's too.

The first columns state what was measured, when, on what machine and how busy it was otherwise; `compared_with` is the
former release that was measured in turns with this one. Then come figures, with the unit at the end of the name: median
and 99th percentile of a tick by scenario and nodes, the loop on the clock, a query of the wall, insertions, a plan and the
window; and, as `_ratio`, the same of this release over that of the former one (below 1 is faster). A figure that was not
measured is empty. Figures of different machines cannot be compared; ratios can.
"""

import csv
import io
import statistics

from bench_report import OWN_WALL, Trouble

FACTS = ("version", "commit", "date", "processor", "cores", "is_virtual", "memory_gb", "load", "others_percent", "stolen_percent",
         "runs", "compared_with")
TICKS = tuple((f"{name}_{nodes}", f"tick/{name}/nodes:{nodes}")
              for name, sizes in (("rod", (100, 200, 1000)), ("tissue_flex28", (100, 1000)), ("stiff_wall", (100, 1000)),
                                  ("withdrawal", (100, 1000)), ("random_hand", (100, 1000)), ("rim_fold", (100, 1000)), ("points", (12,)))
              for nodes in sizes)
LOOPS = (("1kHz", "loop/period_us:1000/seconds:10/iterations:1/real_time"),
         ("10kHz", "loop/period_us:100/seconds:60/iterations:1/real_time"))
# Column, row, figure.
FIGURES = (*(each for name, row in TICKS for each in ((f"{name}_us", row, "p50_us"), (f"{name}_p99_us", row, "p99_us"))),
           *((f"loop_{name}_{figure}", row, figure) for name, row in LOOPS for figure in ("ticks_per_s", "late_percent")),
           ("wall_query_ns", OWN_WALL, "cpu_time"),
           ("study_insertions_per_s", "study/insertions/jobs:1/real_time", "insertions_per_s"),
           ("simulate_s", "simulate", "seconds"), ("validate_s", "validate", "seconds"), ("plan_s", "plan", "seconds"),
           ("first_frame_s", "window", "first_frame_s"), ("frame_median_ms", "window", "frame_median_ms"))
RATIOS = (*((f"{name}_ratio", row) for name, row in TICKS), ("wall_query_ratio", OWN_WALL),
          ("simulate_ratio", "simulate"), ("validate_ratio", "validate"))
COLUMNS = (*FACTS, *(name for name, *_ in FIGURES), *(name for name, _ in RATIOS))


def row_of(found):
    """The columns of what test/bench/page measured; those that were not are left out."""
    former = found.get("former") or {}
    row = {name: {**found["machine"], **found}.get(name) for name in FACTS}
    row["compared_with"] = former.get("version")
    for column, name, figure in FIGURES:
        row[column] = found["rows"].get(name, {}).get(figure)
    for column, name in RATIOS:
        each = former.get("ratios", {}).get(name)
        row[column] = statistics.median(each) if each else None
    return {name: written(value) for name, value in row.items() if value is not None}


def rows_of(found):
    """Those of the former release, if its figures were kept, and of this one."""
    former = found.get("former") or {}
    if "rows" not in former:
        return [row_of(found)]
    return [row_of({**found, "version": former["version"], "commit": former["commit"], "rows": former["rows"], "former": None}), row_of(found)]


def written(value):
    """A cell: four significant digits of a measured number."""
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def read(text, file):
    """Rows of a history, as dictionaries; none of an empty text. Columns that were added since are missing."""
    rows = list(csv.reader(io.StringIO(text)))
    if not rows:
        return []
    header = rows[0]
    unknown = [name for name in header if name not in COLUMNS]
    if unknown or len(set(header)) != len(header) or "version" not in header or "commit" not in header:
        raise Trouble(f"{file}, line 1: {', '.join(unknown) or 'it'} is no column of a history; repair the file or take it from the last commit.")
    for number, row in enumerate(rows[1:], 2):
        if len(row) != len(header):
            raise Trouble(f"{file}, line {number} has {len(row)} cells; it must have {len(header)}. Repair it or take the file from the last commit.")
    return [dict(zip(header, row)) for row in rows[1:]]


def with_rows(rows, added):
    """The text of a history with rows added; one of the same version and commit is replaced."""
    new = {(each["version"], each["commit"]) for each in added}
    kept = [each for each in rows if (each["version"], each["commit"]) not in new]
    out = io.StringIO()
    table = csv.DictWriter(out, COLUMNS, lineterminator="\n", restval="")
    table.writeheader()
    table.writerows([*kept, *added])
    return out.getvalue()
