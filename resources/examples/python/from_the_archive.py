#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The cochlea in a CT of a DICOM archive, and its measures back in the study: from_the_archive.py SERVER PATIENT-ID [FILE.png]

SERVER is a name in servers.toml; the guide's page archive.md tells how it gets there. The CT is removed at the end.
"""

import sys
import tempfile
from pathlib import Path

import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt

import perilymph
from perilymph import archive


def main(server, patient_id, file="from-the-archive.png"):
    archive.test(server)
    with tempfile.TemporaryDirectory() as folder:
        studies = archive.find(server, patient_id=patient_id, modality="CT")
        series = [each for study in studies for each in archive.find_series(server, study) if each.modality == "CT"]
        if not series:
            sys.exit("The archive has no CT of this number.")
        print(f"{len(studies)} studies, {len(series)} series of CT")
        # The one with the most slices has the thinnest; an archive that does not count them gets the first.
        chosen = max(series, key=lambda each: each.images or 0)
        ct = archive.retrieve(server, chosen, Path(folder) / "ct")
        if ct.obstacle:
            sys.exit(ct.obstacle)
        report = Path(folder) / "measures.dcm"
        measures = perilymph.ct.measure(ct.folder, structured_report=report)
        sent = archive.send(server, report)
    names = [name for name, value in measures.values_mm.items() if value is not None]
    for name in names:
        low, high = measures.intervals95_mm[name]
        print(f"{name[:-3]:7} {measures.values_mm[name]:6.2f} ({low:.2f} to {high:.2f}) mm")
    print(f"stored beside the CT as series {sent.series_number}")
    figure, axes = plt.subplots(figsize=(6.4, 3.0), layout="constrained")
    for row, name in enumerate(names):
        low, high = measures.intervals95_mm[name]
        axes.plot([low, high], [row, row], color="#3366bb")
        axes.plot(measures.values_mm[name], row, "o", color="#3366bb")
    axes.set(xlabel=f"{measures.side} ear: measure and 95 % interval, mm", yticks=range(len(names)), yticklabels=[name[:-3] for name in names])
    axes.invert_yaxis()
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(file, dpi=100)


if __name__ == "__main__":
    main(*sys.argv[1:])
