#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Friction and approach, every combination, on all processors: parameter_sweep.py [FILE.png [STEPS]]"""

import csv
import multiprocessing
import sys

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt
import numpy as np

import perilymph

COARSE = {"nodes": 50, "dt_ms": 10, "stop_force_N": 0.1, "start_inside_mm": 1, "stop_travel_mm": 27}


def insertion(values):
    """One row of the table. Scenarios, arrays, patients and results pickle, so that a process may make it."""
    friction, tilt_deg = values
    run = perilymph.simulate("surgery-flex28", {**COARSE, "friction": perilymph.Friction(friction), "approach_tilt_deg": tilt_deg},
                             every_ms=1000)
    return {"friction": friction, "tilt_deg": tilt_deg, "end": run.end, "angle_deg": run.summary["angular_insertion_depth_deg"],
            "peak_mN": 1e3 * run.summary["peak_force_N"]}


def main(file="parameter-sweep.png", steps=4):
    frictions, tilts = np.linspace(0.08, 0.24, int(steps)), np.linspace(-10.0, 10.0, int(steps))
    with multiprocessing.Pool() as pool:
        rows = pool.map(insertion, [(friction, tilt) for friction in frictions for tilt in tilts])
    # pandas.DataFrame(rows) is the same table
    table = csv.DictWriter(sys.stdout, rows[0], lineterminator="\n")
    table.writeheader()
    table.writerows({name: round(value, 3) if isinstance(value, float) else value for name, value in row.items()} for row in rows)

    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    angle_deg = np.array([row["angle_deg"] for row in rows]).reshape(len(frictions), len(tilts))
    shown = axes.pcolormesh(tilts, frictions, angle_deg, shading="nearest")
    for row in rows:
        if row["end"] != "finished":
            axes.plot(row["tilt_deg"], row["friction"], "x", color="white")
    figure.colorbar(shown, label="angular insertion depth, deg")
    axes.set(xlabel="tilt of the approach, deg", ylabel="friction coefficient", title="x: not inserted completely")
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
