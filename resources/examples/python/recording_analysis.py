#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Where the work of an insertion goes, from its recording: recording_analysis.py [FILE.png [RECORDING.insertion]]

Without a recording one is made beside the picture, and read like any other.
"""

import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt
import numpy as np

import perilymph


def main(file="recording-analysis.png", recording=None):
    with tempfile.TemporaryDirectory() as folder:
        if recording is None:
            recording = Path(folder) / "example.insertion"
            perilymph.simulate("surgery-flex28", {"array": "flex24", "nodes": 50, "dt_ms": 5, "stop_travel_mm": 22}, record=recording)
        read = perilymph.read_recording(recording, check=True)
    facts, marks = read.facts, read.highlights
    print(f"{facts['scenario_name']} with {facts['device']}, {len(read['time_s'])} time steps, {read.end}")
    print(f"deepest {marks['deepest_mm']:.1f} mm, {marks['deepest_angle_deg']:.0f} deg; peak {1e3 * marks['peak_force_N']:.1f} mN "
          f"at {marks['peak_depth_mm']:.1f} mm")
    # Work of the hand: force on the array times the way of the base, by the trapezoidal rule.
    base_mm = np.column_stack([read[f"proxy_{axis}_mm"] for axis in "xyz"])
    force_N = np.column_stack([read[f"force_{axis}_N"] for axis in "xyz"])
    work_uJ = -1e3 * np.concatenate([[0.0], np.cumsum(np.sum(0.5 * (force_N[1:] + force_N[:-1]) * np.diff(base_mm, axis=0), axis=1))])
    depth_mm = read["depth_mm"]
    edges = np.arange(np.floor(depth_mm.min()), np.ceil(depth_mm.max()) + 1.0)
    at_edge = np.interp(edges, np.maximum.accumulate(depth_mm), work_uJ)
    for low, high, spent in zip(edges[:-1], edges[1:], np.diff(at_edge)):
        print(f"{low:5.0f} to {high:3.0f} mm  {spent:8.2f} uJ")
    figure, axes = plt.subplots(figsize=(6.4, 4.0), layout="constrained")
    axes.bar(edges[:-1] + 0.5, np.diff(at_edge), width=0.9)
    axes.set(xlabel="insertion depth, mm", ylabel="work of the hand in a millimeter, µJ")
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
