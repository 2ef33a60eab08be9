#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The contacts of an implanted array in a CT after surgery: array_in_ct.py CT-AFTER ARRAY [CT-BEFORE] [FILE.png]

CT-AFTER and CT-BEFORE are folders of slices, ARRAY is a name of perilymph.arrays(). With the CT before surgery the cochlea is
measured where no metal hides it. Angles have 95 % intervals; for research and training, no diagnosis.
"""

import sys

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt
import numpy as np

import perilymph


def main(after, array, before=None, file="array-in-ct.png"):
    found = perilymph.outcome.find(after, array, preop=before)
    depth = found.angular_insertion_depth_deg
    print(f"{found.side} ear, {found.contacts_inside} of {len(found)} contacts inside, depth {depth.value:.0f} deg "
          f"({depth.low95:.0f} to {depth.high95:.0f})")
    if found.flags:
        print("doubtful: " + ", ".join(found.flags))
    contacts = found.columns()
    for row, number in enumerate(contacts["contact"]):
        print(f"{number:3} {contacts['angle_deg'][row]:6.0f} deg {contacts['modiolus_mm'][row]:6.2f} mm to the modiolus, "
              f"error {contacts['error_mm'][row]:.2f} mm")
    inside = contacts["inside"]
    errors = np.array([contacts["angle_deg"] - contacts["angle_low95_deg"], contacts["angle_high95_deg"] - contacts["angle_deg"]])[:, inside]
    figure, axes = plt.subplots(figsize=(6.4, 3.4), layout="constrained")
    axes.errorbar(contacts["contact"][inside], contacts["angle_deg"][inside], errors, fmt="o", color="#3366bb", label="found, 95 % interval")
    axes.axhline(found.tip_angle_deg, color="#cc5500", linewidth=1, label="tip")
    axes.set(xlabel="contact, from the tip", ylabel="angle from the round window, deg", title=f"{array} in the {found.side} ear")
    axes.legend(frameon=False)
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    words = sys.argv[1:]
    picture = [words.pop()] if words and words[-1].endswith(".png") else []
    if not 2 <= len(words) <= 3:
        sys.exit(__doc__)
    main(*words[:2], words[2] if len(words) > 2 else None, *picture)
