# SPDX-License-Identifier: BSD-3-Clause
"""Measuring a cochlea in a CT, by perilymph-cli, which reads the images."""

import os
import tempfile

from perilymph._ct import read_both_measures, read_measures
from perilymph._programs import run_program

__all__ = ["measure", "measure_both"]


def measure(series, *, side="auto", structured_report=None, segmentation=None, key_image=None, program="perilymph-cli"):
    """Measures one ear in a CT: a folder of slices or a file that 'perilymph-cli ct measure' reads.

    side: 'right', 'left', or 'auto' for the ear that the volume shows. structured_report, segmentation, key_image: DICOM files to be
    written, for archive.send; they name the patient, as the CT does. program: name or path of perilymph-cli.
    Raises perilymph.Error with the program's sentence."""
    files = (("--structured-report", structured_report), ("--segmentation", segmentation), ("--key-image", key_image))
    options = [f"{option}={os.fspath(file)}" for option, file in files if file is not None]
    return _measure(series, side, options, program, read_measures)


def measure_both(series, *, program="perilymph-cli"):
    """Measures both ears of one volume: a list, the right one first."""
    return _measure(series, "both", [], program, read_both_measures)


def _measure(series, side, options, program, read):
    if not isinstance(side, str):
        raise TypeError("side must be text")
    with tempfile.TemporaryDirectory(prefix="perilymph-") as folder:
        file = os.path.join(folder, "measures.json")
        words = ["ct", "measure", os.fspath(series), "--json", file, *options]
        words += [] if side == "auto" else ["--side", side]
        run_program(program, words)
        return read(file)
