#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Insertion force over depth of three arrays in the mean cochlea: force_over_depth.py [FILE.png]"""

import sys

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt

import perilymph

ARRAYS = ("flex20", "flex28", "medel-standard")


def main(file="force-over-depth.png"):
    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    for name in ARRAYS:
        array = perilymph.read_array(name)
        simulation = perilymph.simulate("surgery-flex28", {
            "array": name,
            "stop_travel_mm": array.insertable_mm - 1.0,  # the tip starts 1 mm inside
            "friction": "soap-10",
            "stop_force_N": 0.1,  # the surgeon stops: highest peak in vivo (Rau et al. 2024)
            "nodes": 50,
            "dt_ms": 5.0,
        }, every_ms=50)
        depth_mm, force_mN = simulation["depth_mm"], 1e3 * simulation["force_axial_N"]
        line, = axes.plot(depth_mm, force_mN, label=f"{array.name}: {simulation.end.replace('_', ' ')}")
        axes.plot(depth_mm[-1], force_mN[-1], "o", color=line.get_color())
        angle = simulation.contacts["angle_deg"][0]
        print(f"{array.name:16} {simulation.end:22} {depth_mm[-1]:5.1f} mm  {angle:4.0f} deg  peak {force_mN.max():6.1f} mN")
    axes.set(xlabel="insertion depth, mm", ylabel="axial insertion force, mN", xlim=(0, None), ylim=(0, None),
             title="Three lengths in the mean cochlea, 10 % soap")
    axes.legend(frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
