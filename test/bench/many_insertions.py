#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Copies the insertions of a study until there are as many as given, for measuring the window.

The copies lie beside the originals by up to 2 %, so that their points do.
"""

import sqlite3
import sys


def main(file, wanted):
    study = sqlite3.connect(file)
    rows = study.execute("SELECT * FROM insertion ORDER BY number").fetchall()
    for number in range(len(rows), wanted):
        row = list(rows[number % len(rows)])
        row[0] = number
        for column, value in enumerate(row):
            if isinstance(value, float):
                row[column] = value * (1.0 + 0.02 * ((number * (column + 7919)) % 1000 / 500.0 - 1.0))
        study.execute(f"INSERT INTO insertion VALUES({','.join('?' * len(row))})", row)
    study.execute("UPDATE meta SET value = ? WHERE key IN ('cases', 'end')", (str(wanted),))
    study.commit()
    study.close()


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
