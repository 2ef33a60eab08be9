# SPDX-License-Identifier: BSD-3-Clause
"""Columns of arrays as a tidy table."""

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
