#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The coverage table fails for an untaken branch of the safety code without a reason."""

import io
import sys
import unittest
from contextlib import redirect_stdout
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from coverage_table import REASONS, check_branches, print_table, read_reasons  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
CODE = "if (force > most) force = most;"


def a_file(name, *branches, count=1):
    return {"file": name, "lines": [{"line_number": 7, "count": count, "branches": [{"count": n} for n in branches]}]}


def sentences(files, reasons):
    with redirect_stdout(io.StringIO()):
        return check_branches(files, reasons, lambda name, number: CODE)


class Branches(unittest.TestCase):
    SAFETY = "modules/haptics/src/Safety.cpp"

    def test_taken_both_ways_are_well(self):
        self.assertEqual(sentences([a_file(self.SAFETY, 3, 1)], {}), [])

    def test_missed_without_a_reason_are_named_with_their_place(self):
        found = sentences([a_file(self.SAFETY, 3, 0)], {})
        self.assertEqual(len(found), 1)
        self.assertIn("modules/haptics/src/Safety.cpp:7", found[0])

    def test_missed_with_a_reason_are_well(self):
        self.assertEqual(sentences([a_file(self.SAFETY, 3, 0)], {("Safety.cpp", CODE): "never"}), [])

    def test_with_a_reason_that_is_no_longer_needed_are_named(self):
        self.assertEqual(len(sentences([a_file(self.SAFETY, 3, 1)], {("Safety.cpp", CODE): "never"})), 1)

    def test_of_a_race_may_be_taken_or_not(self):
        reasons = {("Safety.cpp", CODE): "By chance: one thread or the other."}
        for count in (0, 1):
            self.assertEqual(sentences([a_file(self.SAFETY, 3, count)], reasons), [])

    def test_elsewhere_may_be_missed(self):
        self.assertEqual(sentences([a_file("modules/anatomy/src/Mesh.cpp", 3, 0)], {}), [])


class Lines(unittest.TestCase):
    def test_count_where_they_were_run(self):
        files = [a_file("modules/device/src/A.cpp", count=2), a_file("modules/haptics/src/B.cpp", count=0),
                 a_file("modules/charts/src/C.cpp", count=0)]  # not part of the engine
        with redirect_stdout(io.StringIO()):
            self.assertEqual(print_table(files), 0.5)


class Reasons(unittest.TestCase):
    def test_are_of_code_that_stands_in_the_named_file(self):
        reasons = read_reasons(REASONS.read_text())
        self.assertGreater(len(reasons), 5)
        for (name, code), reason in reasons.items():
            places = list((ROOT / "modules").rglob(name))
            self.assertEqual(len(places), 1, name)
            self.assertIn(code, [line.strip() for line in places[0].read_text().splitlines()], name)
            self.assertTrue(reason.endswith("."), code)


if __name__ == "__main__":
    unittest.main()
