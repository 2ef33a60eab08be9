#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A plan's bands for one patient, from the errors of A, B and H: plan_bands.py [FILE.png [SAMPLES]]"""

import sys

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt

import perilymph

ARRAYS = ["flex24", "flex28"]


def main(file="plan-bands.png", samples="32"):
    patient = perilymph.Patient(a_mm=9.2, b_mm=6.9, h_mm=4.0, a_sd_mm=0.15, b_sd_mm=0.15, h_sd_mm=0.20)
    plan = perilymph.plan(patient, ARRAYS, samples=int(samples))
    figure, both = plt.subplots(1, len(plan.arrays), figsize=(6.4, 3.6), sharex=True, sharey=True, layout="constrained")
    for axes, array in zip(both, plan.arrays):
        force = array.force()
        low, quarter, median, three_quarters, high = force["force_mN"].T
        axes.fill_between(force["depth_mm"], low, high, color="tab:blue", alpha=0.2, lw=0, label=plan.bands_hold)
        axes.fill_between(force["depth_mm"], quarter, three_quarters, color="tab:blue", alpha=0.35, lw=0, label="25 to 75 %")
        axes.plot(force["depth_mm"], median, color="tab:blue", label="median")
        angle = array.bands()["angle_deg"]
        full = array.probabilities()["intended_depth_reached"][0] * array.draws
        axes.set(xlabel="insertion depth, mm", xlim=(0, None), ylim=(0, None))
        axes.set_title(f"{array.name}, {array.draws} draws\nangle {angle[2]:.0f} ({angle[0]:.0f} to {angle[4]:.0f}) deg", fontsize=10)
        axes.spines[["top", "right"]].set_visible(False)
        print(f"{array.name}: {angle[2]:.0f} deg ({angle[0]:.0f} to {angle[4]:.0f}), full insertion {full:.0f} of {array.draws}")
    both[0].set_ylabel("axial insertion force, mN")
    both[0].legend(frameon=False, fontsize=9, loc="upper left")
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
