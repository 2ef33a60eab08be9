#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""test/bench/compare pairs the runs of two commits, and ignores rows that only one of them has."""

import importlib.machinery
import importlib.util
import subprocess
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
SCRIPT = Path(__file__).resolve().parent / "compare"
sys.path.insert(0, str(SCRIPT.parent))
loader = importlib.machinery.SourceFileLoader("compare", str(SCRIPT))
compare = importlib.util.module_from_spec(importlib.util.spec_from_loader("compare", loader))
loader.exec_module(compare)


class Compare(unittest.TestCase):
    def test_a_machine_that_slows_down_strikes_both_of_a_pair_alike(self):
        before = [{"tick": 10.0}, {"tick": 20.0}, {"tick": 40.0}]
        after = [{"tick": 5.0}, {"tick": 10.0}, {"tick": 20.0}]
        self.assertEqual(compare.ratios(before, after), {"tick": [0.5, 0.5, 0.5]})

    def test_rows_of_one_commit_alone_are_left_out(self):
        self.assertEqual(compare.ratios([{"old": 1.0, "tick": 1.0}], [{"new": 1.0, "tick": 3.0}]), {"tick": [3.0]})

    def test_the_table_shows_median_least_and_greatest(self):
        self.assertIn("| tick | 0.900 | 0.800 | 1.300 |", list(compare.lines({"tick": [0.8, 1.3, 0.9]})))

    def test_a_commit_that_is_none_is_named(self):
        done = subprocess.run([SCRIPT, "no-such-commit"], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("no-such-commit", done.stderr)


if __name__ == "__main__":
    unittest.main()
