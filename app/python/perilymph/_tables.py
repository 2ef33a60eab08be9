# SPDX-License-Identifier: BSD-3-Clause
"""Columns of arrays as a tidy table."""

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
