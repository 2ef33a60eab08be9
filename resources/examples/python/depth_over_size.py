#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Angular insertion depth against cochlear size, three arrays: depth_over_size.py [FILE.png [SIZES]]"""

import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt
import numpy as np

import perilymph

ARRAYS = ("flex20", "flex24", "flex28")


def main(file="depth-over-size.png", sizes="9"):
    # Two standard deviations around the mean of A (9.23 +- 0.43 mm); B as it usually goes with A
    # (Pietsch et al. 2017).
    a_mm = np.linspace(8.4, 10.1, int(sizes))
    b_mm = 6.80 + 0.1236 / 0.1829 * (a_mm - 9.23)
    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    with tempfile.TemporaryDirectory() as folder:
        for name in ARRAYS:
            array = perilymph.read_array(name)
            angle_deg, is_full = [], []
            for a, b in zip(a_mm, b_mm):
                patient = Path(folder) / "patient.toml"
                patient.write_text(perilymph.Patient(a_mm=a, b_mm=b).text)
                simulation = perilymph.simulate("surgery-flex28", {
                    "patient": patient,
                    "array": name,
                    "stop_travel_mm": array.insertable_mm - 1.0,  # the tip starts 1 mm inside
                    "friction": "soap-10",
                    "stop_force_N": 0.1,  # the surgeon stops: highest peak in vivo (Rau et al. 2024)
                    "nodes": 50,
                    "dt_ms": 5.0,
                }, every_ms=50)
                angle_deg.append(simulation.contacts["angle_deg"][0])
                is_full.append(simulation.end == "finished")
                print(f"{array.name}  A {a:.2f} mm  {angle_deg[-1]:4.0f} deg  {simulation.end}")
            angle_deg, is_full = np.array(angle_deg), np.array(is_full)
            line, = axes.plot(a_mm, angle_deg, lw=1, label=array.name)
            axes.plot(a_mm[is_full], angle_deg[is_full], "o", color=line.get_color())
            axes.plot(a_mm[~is_full], angle_deg[~is_full], "o", color=line.get_color(), mfc="white")
    axes.set(xlabel="diameter A of the basal turn, mm", ylabel="angle of the most apical contact, deg",
             title="An array reaches farther around a smaller cochlea\n(open circle: stopped before full depth)")
    axes.legend(frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
