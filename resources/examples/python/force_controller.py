#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A closed loop beside a constant speed: force_controller.py [FILE.png]

The controller slows down as the force rises, and stops when it has waited at the limit for some seconds. Lining and array relax,
so that waiting lowers the force.
"""

import sys

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt
import numpy as np

import perilymph

LIMIT_N = 0.06
FASTEST_MM_S = 0.66  # by hand
SCENARIO = {"array": "flex28", "nodes": 50, "dt_ms": 5, "start_inside_mm": 1, "stop_travel_mm": 27,
            "film_relaxation_fraction": 0.5, "film_relaxation_time_s": 2}


def constant(force_N):
    return FASTEST_MM_S if force_N < LIMIT_N else None


class Proportional:
    """Full speed below half of the limit, less above it; after 5 s at the limit the insertion ends."""

    def __init__(self, time_step_s):
        self.time_step_s, self.waited_s = time_step_s, 0.0

    def __call__(self, force_N):
        speed_mm_s = FASTEST_MM_S * np.clip(2.0 - 2.0 * force_N / LIMIT_N, 0.0, 1.0)
        self.waited_s = self.waited_s + self.time_step_s if speed_mm_s < 0.005 else 0.0
        return speed_mm_s if self.waited_s < 5.0 else None


def run(insertion, controller):
    """Time, depth and force of every time step."""
    rows = []
    reading = insertion.reading
    while not insertion.has_ended and reading.time_s < 90.0:
        speed_mm_s = controller(reading.force_axial_N)
        if speed_mm_s is None:
            break
        reading = insertion.advance(speed_mm_s)
        rows.append((reading.time_s, reading.depth_mm, reading.force_axial_N))
    return np.array(rows)


def main(file="force-controller.png"):
    insertion = perilymph.Insertion("surgery-flex28", SCENARIO)
    figure, (over_time, over_depth) = plt.subplots(1, 2, figsize=(6.4, 3.4), layout="constrained")
    for name, controller in (("constant 0.66 mm/s", constant), ("closed loop", Proportional(insertion.time_step_s))):
        insertion.reset()
        time_s, depth_mm, force_N = run(insertion, controller).T
        angle_deg = insertion.contacts()["angle_deg"][0]
        print(f"{name:20} {time_s[-1]:6.1f} s  {depth_mm[-1]:5.2f} mm  {angle_deg:4.0f} deg  peak {1e3 * force_N.max():5.1f} mN")
        over_time.plot(time_s, depth_mm, label=name)
        over_depth.plot(depth_mm, 1e3 * force_N)
    over_depth.axhline(1e3 * LIMIT_N, color="0.5", linewidth=0.8)
    over_time.set(xlabel="time, s", ylabel="insertion depth, mm")
    over_depth.set(xlabel="insertion depth, mm", ylabel="axial insertion force, mN", ylim=(0, None))
    over_time.legend(frameon=False)
    for axes in (over_time, over_depth):
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
