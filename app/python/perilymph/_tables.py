# SPDX-License-Identifier: BSD-3-Clause
"""Columns of arrays as a tidy table."""

import hashlib
import warnings

import numpy as np

# What a column of several numbers a row holds, by their count.
_PARTS = {3: ("", "_low95", "_high95"), 5: ("_p5", "_p25", "_p50", "_p75", "_p95")}


def flat(columns):
    """The columns, each of one number a row: a band becomes five with the percentiles in their names, a probability three."""
    found = {}
    for name, values in columns.items():
        values = np.asarray(values)
        if values.ndim < 2:
            found[name] = np.atleast_1d(values)
            continue
        for part, ending in enumerate(_PARTS[values.shape[1]]):
            found[name + ending] = values[:, part]
    return found


def data_frame(columns):
    """The same as a pandas DataFrame, which is imported only here."""
    import pandas

    return pandas.DataFrame(flat(columns))


# Keys that were renamed, and what they are called now.
_RENAMED = {"angular_depth_deg": "tip_angle_deg", "full_insertion": "intended_depth_reached"}


class Renamed(dict):
    """A dict in which renamed keys are found by their former name, too, with a warning, until version 1.0."""

    def __missing__(self, key):
        now = _RENAMED.get(key)
        if now not in self:
            raise KeyError(key)
        warnings.warn(f"the key '{key}' is now called '{now}'; the old name is read until version 1.0.", FutureWarning, stacklevel=2)
        return self[now]


class Values(list):
    """The values of a mapping, which an earlier version gave as a dict: found by key, too, with a warning, until version 1.0."""

    def __init__(self, items):
        super().__init__(items.values())
        self._items = items

    def __getitem__(self, place):
        if not isinstance(place, str):
            return super().__getitem__(place)
        warnings.warn("values() is a list now; use dict(...) or [...] of the object, values() by key is read until version 1.0.",
                      FutureWarning, stacklevel=2)
        return self._items[place]

    def __reduce__(self):
        return list, (list(self),)


def bytes_of(values):
    """What values say, as bytes: by their hash where they are many: the same for equal dicts, sequences, arrays, texts and numbers only."""
    if isinstance(values, dict):
        parts = [bytes_of(each) for item in values.items() for each in item]
    elif isinstance(values, (list, tuple)):
        parts = [bytes_of(each) for each in values]
    elif isinstance(values, np.ndarray):
        parts = [repr((values.dtype.str, values.shape)).encode(), hashlib.sha256(np.ascontiguousarray(values)).digest()]
    else:
        state = values.__getstate__() if type(values).__module__.startswith("perilymph") else repr(values)
        parts = [state.encode("utf-8", "surrogatepass") if isinstance(state, str) else bytes_of(state)]
    return b"".join(str(len(each)).encode() + b":" + each for each in [type(values).__name__.encode(), *parts])
