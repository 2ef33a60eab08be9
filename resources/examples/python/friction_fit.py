#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A friction fitted to a force curve: friction_fit.py [FILE.png [CURVE.csv]]

The curve has the columns depth_mm and force_mN; without one, a curve of a friction of 0.14 with noise is fitted.
"""

import sys

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt
import numpy as np

import perilymph

COARSE = {"nodes": 50, "dt_ms": 10, "start_inside_mm": 1, "stop_travel_mm": 20}


def force_mN(friction, depth_mm):
    run = perilymph.simulate("surgery-flex28", {**COARSE, "friction": perilymph.Friction(friction)}, every_ms=100)
    deepest = np.maximum.accumulate(run["depth_mm"])
    return np.interp(depth_mm, deepest, 1e3 * run["force_axial_N"])


def measured(file):
    if file is not None:
        return np.loadtxt(file, delimiter=",", skiprows=1, unpack=True)
    depth_mm = np.arange(5.0, 20.0, 0.25)
    return depth_mm, force_mN(0.14, depth_mm) + np.random.default_rng(1).normal(0.0, 0.5, depth_mm.size)


def main(file="friction-fit.png", curve=None):
    depth_mm, observed_mN = measured(curve)
    # Gauss-Newton for one coefficient, with its slope by a difference.
    friction, small = 0.2, 1e-3
    for _ in range(5):
        predicted_mN = force_mN(friction, depth_mm)
        slope = (force_mN(friction + small, depth_mm) - predicted_mN) / small
        rest_mN = observed_mN - predicted_mN
        friction = float(np.clip(friction + (slope @ rest_mN) / (slope @ slope), 0.02, 0.5))
    rest_mN = observed_mN - force_mN(friction, depth_mm)
    error = np.sqrt(rest_mN @ rest_mN / (rest_mN.size - 1) / (slope @ slope))
    print(f"friction {friction:.4f} (95 % interval {friction - 1.96 * error:.4f} to {friction + 1.96 * error:.4f})")
    print(f"rest {rest_mN.std():.2f} mN over {rest_mN.size} depths to {depth_mm[-1]:.1f} mm")
    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    axes.plot(depth_mm, observed_mN, ".", color="0.4", label="measured")
    for value, label in ((friction, f"fitted, {friction:.3f}"), (0.2, "where the fit begins, 0.2")):
        axes.plot(depth_mm, force_mN(value, depth_mm), label=label)
    axes.set(xlabel="insertion depth, mm", ylabel="axial insertion force, mN")
    axes.legend(frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
