#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A taper of the stiffness, searched for the deepest insertion below a force: array_design.py [FILE.png [ROUNDS]]

The stiffness at the tip and that at the base are factors on the FLEX28's. A softer base needs less force and buckles sooner.
"""

import sys

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt
import numpy as np

import perilymph

LIMIT_N = 0.06
COARSE = {"nodes": 50, "dt_ms": 10, "stop_force_N": LIMIT_N, "start_inside_mm": 1, "stop_travel_mm": 27}
FLEX28 = perilymph.read_scenario("surgery-flex28").array  # as this scenario runs it
PLACE_MM = np.linspace(0.0, FLEX28.length_mm, 16)


def design(tip, base):
    factor = np.interp(PLACE_MM, [0.0, FLEX28.length_mm], [tip, base])
    return FLEX28.replace(name=f"{tip:.2f}, {base:.2f}",
                          bending_stiffness_Nm2=(PLACE_MM, factor * FLEX28.bending_stiffness_Nm2(PLACE_MM)))


def angle_deg(factors):
    run = perilymph.simulate("surgery-flex28", {**COARSE, "array": design(*factors)}, every_ms=1000)
    return run.summary["angular_insertion_depth_deg"], run.end


def main(file="array-design.png", rounds=3):
    # A pattern search: step to the best neighbor, halve the steps where none is better.
    best, step = np.array([1.0, 1.0]), 0.4
    tried = {tuple(best): angle_deg(best)}
    print(f"FLEX28: {tried[1.0, 1.0][0]:4.0f} deg at {1e3 * LIMIT_N:.0f} mN, {tried[1.0, 1.0][1]}")
    for _ in range(int(rounds)):
        neighbors = [np.maximum(best + step * np.array(way), 0.2) for way in ((1, 0), (-1, 0), (0, 1), (0, -1))]
        for each in neighbors:
            if tuple(each) not in tried:
                tried[tuple(each)] = angle_deg(each)
        found = max(tried, key=lambda factors: tried[factors][0])
        step = step if found != tuple(best) else step / 2.0
        best = np.array(found)
        print(f"tip x {best[0]:.2f}, base x {best[1]:.2f}: {tried[found][0]:4.0f} deg at {1e3 * LIMIT_N:.0f} mN, {tried[found][1]}")
    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    points, angles = np.array(list(tried)), [angle for angle, _ in tried.values()]
    shown = axes.scatter(*points.T, c=angles, s=120)
    axes.plot(*best, "o", markersize=16, markerfacecolor="none", color="tab:red")
    figure.colorbar(shown, label=f"angular insertion depth at {1e3 * LIMIT_N:.0f} mN, deg")
    axes.set(xlabel="stiffness of the tip, of FLEX28's", ylabel="stiffness of the base, of FLEX28's")
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
