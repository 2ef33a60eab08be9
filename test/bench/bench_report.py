# SPDX-License-Identifier: BSD-3-Clause
"""Runs perilymph-bench and other programs, and reads what they print; cells and rows of tables in Markdown."""

import json
import subprocess

PEERS = (("Embree", "embree"), ("CGAL", "cgal"), ("VTK", "vtk"), ("FCL", "fcl"), ("Bullet", "bullet"))
TRIANGLES = (2000, 20000, 200000)
OWN_WALL = "lumen/own/cloud:1000"
NONE = "-"


class Trouble(Exception):
    """An error with a message for the user."""


def output_of(*words, cwd=None, env=None):
    """Standard output of a command that has to succeed."""
    try:
        done = subprocess.run([str(word) for word in words], cwd=cwd, env=env, capture_output=True, text=True, check=False)
    except OSError as reason:
        raise Trouble(f"{words[0]} does not run ({reason.strerror}).") from reason
    if done.returncode != 0:
        raise Trouble(f"'{' '.join(map(str, words))}' ended with {done.returncode}: {(done.stderr or done.stdout)[-600:].strip()}")
    return done.stdout


def measured(bench, rows, runs=1):
    """Output of the benchmark for rows that match a regular expression, as JSON; no rows if none matches."""
    words = output_of(bench, f"--benchmark_filter={rows}", f"--benchmark_repetitions={runs}", "--benchmark_format=json")
    if not words.strip():
        return {"context": {}, "benchmarks": []}
    try:
        return json.loads(words)
    except json.JSONDecodeError as reason:
        raise Trouble(f"{bench} printed no JSON ({reason}).") from reason


def least(*reports):
    """Minimum over all runs of each row and figure: {row: {figure: value}}."""
    rows = {}
    for run in (run for report in reports for run in report["benchmarks"]):
        if run.get("error_occurred"):
            raise Trouble(f"{run['name']}: {run['error_message']}")
        if run.get("run_type") != "iteration":
            continue
        row = rows.setdefault(run["name"], {})
        for figure, value in run.items():
            if isinstance(value, float):
                row[figure] = min(value, row.get(figure, value))
    return rows


def digits(value):
    """Three significant digits, with thousands separators."""
    if value >= 100:
        return f"{round(value, 3 - len(str(int(value)))):,.0f}"
    return f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def cell(rows, row, figure):
    """A figure of a row; a dash if there is none."""
    value = rows.get(row, {}).get(figure)
    return NONE if value is None else digits(value)


def line(cells):
    return "| " + " | ".join(cells) + " |"


def wall_cells(rows, triangles):
    """A row of the table of wall queries: our lumen and the libraries that are installed [ns]."""
    peers = [cell(rows, f"lumen/{peer}/triangles:{triangles}", "cpu_time") for _, peer in PEERS]
    return [f"{triangles:,} triangles", cell(rows, OWN_WALL, "cpu_time"), *peers]
