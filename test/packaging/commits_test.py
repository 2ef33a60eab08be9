#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Which subjects of commits are accepted."""

import importlib.machinery
import importlib.util
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
SCRIPT = Path(__file__).resolve().parents[1] / "check-commits"
loader = importlib.machinery.SourceFileLoader("check_commits", str(SCRIPT))
check_commits = importlib.util.module_from_spec(importlib.util.spec_from_loader("check_commits", loader))
loader.exec_module(check_commits)


class Subjects(unittest.TestCase):
    def test_of_an_area_and_an_imperative_are_accepted(self):
        for subject in ("ct: check the anatomy found", "test/run: fuzz for 30 s", "app/gui, test: process wires", "guide: read " + "x" * 60):
            with self.subTest(subject=subject):
                self.assertEqual(check_commits.faults(subject), [])

    def test_of_another_form_are_refused_with_the_reason(self):
        for subject, reason in (("Check the anatomy", "form"), ("ct: checks the anatomy", "'checks'"), ("ct: checked it", "'checked'"),
                                ("ct: checking it", "'checking'"), ("ct: Check it", "capital"), ("ct: check it.", "period"),
                                ("guide: read " + "x" * 61, "73 columns")):
            with self.subTest(subject=subject):
                self.assertIn(reason, " ".join(check_commits.faults(subject)))


if __name__ == "__main__":
    unittest.main()
