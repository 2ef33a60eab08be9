# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the Python package share: the command line to compare with, and a fast scenario."""

import csv
import hashlib
import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

# Plans of fewer simulations than users are offered: the calls are tested. The build's name states it.
os.environ["PERILYMPH_FEW_DRAWS"] = "1"

import perilymph  # noqa: E402  after the environment

ROOT = Path(__file__).resolve().parents[3]
# Half a millimeter of the published insertion with a coarse rod: some hundred steps.
SHORT = {"nodes": 30, "stop_travel_mm": 0.5}


@pytest.fixture(scope="session")
def cli():
    """Runs perilymph-cli; returns its standard output."""
    program = Path(os.environ["PERILYMPH_PROGRAMS"]) / "perilymph-cli"

    def run(*words):
        done = subprocess.run([program, *map(str, words)], capture_output=True, text=True, timeout=240, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    return run


@pytest.fixture(scope="session")
def mean():
    return perilymph.Cochlea.named("mean")


def table(file):
    """Columns of a CSV file; text reads back as the bits that wrote it, because it is the shortest decimal. NaN: empty."""
    with open(file, encoding="utf-8", newline="") as stream:
        rows = list(csv.reader(stream))
    return {name: np.array([float(row[i] or "nan") for row in rows[1:]]) for i, name in enumerate(rows[0])}


def same_bits(a, b):
    """Whether two columns of numbers agree in every bit, but for the sign of zero."""
    return a.shape == b.shape and a.dtype == b.dtype and np.array_equal(a, b, equal_nan=True)


def clinic_page():
    """A clinic's resistance that is certain of the shipped one, with the place of its seal."""
    rows = [[float(f == 20 and g == 10) for g in range(21)] for f in range(41)]
    return {"format": 1, "kind": "resistance in a clinic", "program": "Perilymph " + perilymph.__version__, "friction": 0.165,
            "stopped_by_resistance": 9, "censored": 1, "not_informative": 0, "log_score": 3.5, "first_year": 2025, "last_year": 2026,
            "probability": rows, "content_sha256": "0" * 64}


def clinic_file(file):
    """Its file, sealed as the program seals files: by the hash of the text with zeros for the hash."""
    text = json.dumps(clinic_page(), indent=1) + "\n"
    file.write_text(text.replace("0" * 64, hashlib.sha256(text.encode()).hexdigest()))
    return file
