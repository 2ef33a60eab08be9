#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The array in the cochlea with the force of the wall on each node: own_figure.py [FILE.png]"""

import sys

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt
import numpy as np

import perilymph


def main(file="own-figure.png"):
    patient = perilymph.Patient(a_mm=9.2, b_mm=6.9, h_mm=4.0)
    cochlea = perilymph.Cochlea(patient)
    insertion = perilymph.Insertion("surgery-flex28", {"cochlea": cochlea, "nodes": 100, "dt_ms": 5, "stop_travel_mm": 24})
    insertion.advance(ticks=6500)
    now, nodes_mm = insertion.reading, insertion.nodes_mm
    force_mN = 1e3 * np.linalg.norm(insertion.node_forces_N, axis=1)
    contacts = insertion.contacts()
    print(f"{now.depth_mm:.1f} mm, most apical contact at {contacts['angle_deg'][0]:.0f} deg, axial force {1e3 * now.force_axial_N:.1f} mN")
    print(f"{now.contacts} nodes touch the wall, the most loaded with {force_mN.max():.1f} mN")

    # Seen along the modiolus, as in the cochlear view of a CT.
    figure, axes = plt.subplots(figsize=(6.4, 4.8), layout="constrained")
    angle_deg = np.linspace(0.0, cochlea.last_angle_deg, 600)
    for direction, name in ((0.0, "lateral wall"), (180.0, "modiolus")):
        x_mm, y_mm, _ = cochlea.wall(angle_deg, direction).T
        axes.plot(x_mm, y_mm, color="0.6", linewidth=1.0 if direction else 2.0, label=name)
    for k, name in ((0, "tip"), (int(contacts["is_inserted"].sum()) - 1, "round window")):
        print(f"contact {contacts['number'][k]:2} toward the {name}: {contacts['to_modiolus_mm'][k]:.2f} mm from the modiolus")
    shown = axes.scatter(nodes_mm[:, 0], nodes_mm[:, 1], c=force_mN, s=18, cmap="plasma_r", zorder=3)
    figure.colorbar(shown, label="force of the wall on a node, mN")
    axes.set(xlim=(-6.5, 8.5), ylim=(-7.0, 5.5), xlabel="x, mm (round window at x > 0)", ylabel="y, mm", aspect="equal")
    axes.legend(frameon=False, loc="lower left")
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
