# SPDX-License-Identifier: BSD-3-Clause
"""Results of perilymph-cli: JSON files, and values of which a result may rely on the type."""

import json
import math
import os

from perilymph._engine import Error


def read_json(file, megabytes, advice):
    """Reads a file of at most so many megabytes: its content and its name. 'advice' ends the sentence of a refusal."""
    name = os.fspath(file)
    largest = megabytes << 20
    try:
        with open(name, "rb") as stream:
            text = stream.read(largest + 1)
    except OSError as error:
        raise Error(f"{name} cannot be read: {error.strerror}. {advice}") from None
    if len(text) > largest:
        raise Error(f"{name} is larger than {megabytes} MB. {advice}")
    try:
        return json.loads(text), name
    except (ValueError, RecursionError):
        raise Error(f"{name} is no JSON. {advice}") from None


def number_of(value):
    """A finite number as a float; ValueError for anything else."""
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not math.isfinite(value):
        raise ValueError(f"{value!r} is no finite number")
    return float(value)


def text_of(value):
    """A text; ValueError for anything else."""
    if not isinstance(value, str):
        raise ValueError(f"{value!r} is no text")
    return value
