# SPDX-License-Identifier: BSD-3-Clause
"""Measuring a cochlea in a CT, by perilymph-cli, which reads the images."""

import os
import shutil
import subprocess
import tempfile

from perilymph._ct import CtMeasures, read_both_measures, read_measures
from perilymph._engine import Error

__all__ = ["measure", "measure_both"]


def measure(series, *, side="auto", program="perilymph-cli"):
    """Measures one ear in a CT: a folder of slices or a file that 'perilymph-cli ct measure' reads.

    side: 'right', 'left', or 'auto' for the ear that the volume shows. program: name or path of perilymph-cli.
    Raises perilymph.Error with the program's sentence."""
    return _measure(series, side, program, read_measures)


def measure_both(series, *, program="perilymph-cli"):
    """Measures both ears of one volume: a list, the right one first."""
    return _measure(series, "both", program, read_both_measures)


def _measure(series, side, program, read):
    found = shutil.which(os.fspath(program))
    if found is None:
        raise Error(f"The program {program} was not found. Install perilymph, or give its path as 'program'.")
    if not isinstance(side, str):
        raise TypeError("side must be text")
    with tempfile.TemporaryDirectory(prefix="perilymph-") as folder:
        file = os.path.join(folder, "measures.json")
        words = [found, "ct", "measure", os.fspath(series), "--json", file]
        words += [] if side == "auto" else ["--side", side]
        done = subprocess.run(words, capture_output=True, text=True, errors="replace", check=False)
        if done.returncode != 0:
            raise Error(done.stderr.strip() or f"{found} ended with {done.returncode}.")
        return read(file)
