#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs one check on the project: check.py <name of the check> <root of the project>."""

import importlib
import sys
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

CHECKS = ("arrows", "documents", "formatting", "house", "interfaces", "layout", "licenses", "tests", "threads",
          "vocabulary", "window", "words")


def main():
    if len(sys.argv) != 3 or sys.argv[1] not in CHECKS:
        print(__doc__, "Checks:", *CHECKS, file=sys.stderr)
        return 2
    errors = importlib.import_module(f"checks.{sys.argv[1]}").check(Path(sys.argv[2]).resolve())
    for sentence in errors:
        print(sentence)
    if errors:
        print(f"{len(errors)} to put right.")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())
