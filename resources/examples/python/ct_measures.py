#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""From a CT to a patient: measures with intervals, and what they leave open of the cochlea: ct_measures.py CT [FILE.png]

CT is a folder of slices or a file. Both ears are measured if both are in it. For research and training, no diagnosis.
"""

import sys

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt
import numpy as np

import perilymph


def main(ct, file="ct-measures.png"):
    ear = perilymph.ct.measure(ct)
    ears = [ear] if ear.second_cochlea_lps_mm is None else perilymph.ct.measure_both(ct)
    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    for ear in ears:
        for name, value in ear.values_mm.items():
            if value is None:
                print(f"{ear.side} {name}: {ear.duct_length_reason}")
                continue
            low, high = ear.intervals95_mm[name]
            print(f"{ear.side} {name:20} {value:6.2f} ({low:.2f} to {high:.2f})")
        for sentence in ear.warnings:
            print(f"{ear.side}: {sentence}")
        patient = ear.patient(label=f"{ear.side} ear")
        # The outer wall from above, and with A and B at the ends of their intervals.
        around = np.arange(0.0, 361.0, 5.0)
        wall_mm = perilymph.Cochlea(patient).wall(around, 0.0)
        line, = axes.plot(wall_mm[:, 0], wall_mm[:, 1], label=patient.label)
        for sign in (-1.96, 1.96):
            other = perilymph.Patient(a_mm=patient.a_mm + sign * patient.a_sd_mm, b_mm=patient.b_mm + sign * patient.b_sd_mm, h_mm=patient.h_mm)
            edge_mm = perilymph.Cochlea(other).wall(around, 0.0)
            axes.plot(edge_mm[:, 0], edge_mm[:, 1], linewidth=0.7, linestyle="--", color=line.get_color())
    axes.set(xlabel="toward the round window, mm", ylabel="mm", aspect="equal", title="Outer wall of the basal turn (dashed: A and B at their 95 %)")
    axes.legend(frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
