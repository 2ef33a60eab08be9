# SPDX-License-Identifier: BSD-3-Clause
"""Results of perilymph-cli: JSON files, and values of which a result may rely on the type."""

import copy
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


class Page:
    """A result that is what a file of JSON states. It is not changed, and equals another one with the same content, whenever
    and by whichever build both were computed."""

    _RUN = ("seconds", "version", "program", "content_sha256")

    def __init__(self, page, name):
        try:
            self._read(page)
            self._page = copy.deepcopy(page)
        except (AttributeError, KeyError, IndexError, TypeError, ValueError, OverflowError) as error:
            raise Error(f"{name} is not what '{self._COMMAND}' writes ({type(error).__name__}: {error}). Make it again.") from None

    def page(self):
        """The content of the file: a dict of what JSON has, the caller's own."""
        return copy.deepcopy(self._page)

    def _key(self):
        return json.dumps({key: value for key, value in self._page.items() if key not in self._RUN}, sort_keys=True)

    def __eq__(self, other):
        return self._key() == other._key() if type(other) is type(self) else NotImplemented

    def __hash__(self):
        return hash(self._key())
