#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of the groups of a study, calculated again from its points with NumPy and SciPy."""

import csv
import math
import sqlite3
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np
from scipy import stats

CLI = Path(sys.argv.pop(1)) / "perilymph-cli" if len(sys.argv) > 1 else None
STUDY = """
title = "Two lengths"
scenario = "surgery-flex28"
[cochleae]
virtual = 9
[vary]
array = ["flex24", "medel-standard"]
nodes = [30]
dt_ms = [10.0]
stop_force_N = [0.1]
friction = ["soap-10"]
[ranges]
speed_mm_s = [1.0, 3.0]
"""
QUANTITIES = (("angle", "deg", "angle_deg"), ("depth", "mm", "depth_mm"), ("peak", "mN", "peak_mN"))


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Groups(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        root = Path(cls.folder.name)
        (root / "study.toml").write_text(STUDY, encoding="utf-8")
        cls.call("study", "run", str(root / "study.toml"), "--out", str(root / "out"))
        cls.call("study", "report", str(root / "out"), "--group", "array")
        points = table(root / "out" / "points.csv")
        cls.insertions = (root / "out" / "insertions.csv").read_bytes()
        cls.all_points = (root / "out" / "points.csv").read_bytes()
        cls.own = {array: [row for row in points if row["array"] == array]
                   for array in ("flex24", "medel-standard")}
        cls.groups = {(row["group"], row["selection"]): row for row in table(root / "out" / "groups.csv")}
        cls.differences = {row["selection"]: row for row in table(root / "out" / "differences.csv")}
        cls.trends = {(row["group"], row["selection"]): row for row in table(root / "out" / "trends.csv")}
        cls.report = (root / "out" / "report.md").read_text(encoding="utf-8")
        with sqlite3.connect(root / "out" / "study.sqlite") as database:
            database.row_factory = sqlite3.Row
            cls.views = {(row["value"], row["selection"], row["quantity"]): row for row in database.execute(
                "SELECT * FROM distribution_by_setting WHERE key = 'array'")}
            cls.endings = {row["value"]: row for row in database.execute(
                "SELECT * FROM ending_by_setting WHERE key = 'array'")}

    @staticmethod
    def call(*arguments):
        done = subprocess.run([str(CLI), *arguments], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def close(self, found, expected, scale):
        self.assertAlmostEqual(float(found), expected, delta=1e-8 * scale)

    def values(self, array, key, selection="all that ran"):
        return np.array([float(row[key]) for row in self.own[array]
                         if selection != "complete" or row["ending"] == "finished"])

    def test_points_are_those_of_the_study(self):
        self.assertEqual(self.all_points, self.insertions)

    def test_groups(self):
        stopped = 0
        for array, own in self.own.items():
            complete = sum(each["ending"] == "finished" for each in own)
            stopped += 9 - complete
            self.assertEqual((self.endings[array]["insertions"], self.endings[array]["finished"]), (9, complete))
            for selection, count in (("all that ran", 9), ("complete", complete)):
                row = self.groups[array, selection]
                self.assertEqual((row["n"], row["complete"], row["stopped"], row["not_prepared"], row["n_selected"]),
                                 ("9", str(complete), str(9 - complete), "0", str(count)))
                interval = stats.binomtest(complete, 9).proportion_ci(method="wilson")
                # the program takes 1.96, SciPy 1.959964
                self.assertAlmostEqual(float(row["complete_low95_percent"]), 100 * interval.low, delta=2e-3)
                self.assertAlmostEqual(float(row["complete_high95_percent"]), 100 * interval.high, delta=2e-3)
                for name, unit, key in QUANTITIES:
                    values = self.values(array, key, selection)
                    if len(values) == 0:
                        self.assertEqual(row[f"{name}_median_{unit}"], "")
                        self.assertNotIn((array, selection, key), self.views)
                        continue
                    view = self.views[array, selection, key]
                    self.assertEqual(view["n"], count)
                    for what, share in (("median", 0.5), ("quartile25", 0.25), ("quartile75", 0.75)):
                        expected = np.quantile(values, share)
                        self.close(row[f"{name}_{what}_{unit}"], expected, 100)
                        self.close(view[what], expected, 100)
                    self.close(row[f"{name}_mean_{unit}"], np.mean(values), 100)
                    self.close(view["mean"], np.mean(values), 100)
                    # the report has the same numbers
                    text = "%.1f (%.1f to %.1f); %.1f |" % (
                        *(float(row[f"{name}_{what}_{unit}"]) for what in ("median", "quartile25", "quartile75")),
                        float(row[f"{name}_mean_{unit}"]))
                    self.assertIn(text, self.report)
        self.assertIn(stopped, range(1, 18), "some stop, some do not")

    def test_differences_are_those_of_pairs(self):
        self.assertEqual(set(self.differences), {"all that ran", "complete"})
        for selection, row in self.differences.items():
            one, other = ({each["cochlea"]: each for each in self.own[row[key]]
                           if selection != "complete" or each["ending"] == "finished"} for key in ("group", "other"))
            shared = [cochlea for cochlea in one if cochlea in other]
            if len(shared) < 2:
                self.assertEqual(row["method"], "Welch")
                continue
            count = str(len(shared))
            self.assertEqual((row["method"], row["n"], row["n_other"], row["cochleae"]),
                             ("paired", count, count, count))
            for name, unit, key in QUANTITIES:
                pairs = [float(one[cochlea][key]) - float(other[cochlea][key]) for cochlea in shared]
                interval = stats.t.interval(0.95, len(pairs) - 1, np.mean(pairs), stats.sem(pairs))
                self.close(row[f"{name}_mean_difference_{unit}"], np.mean(pairs), 100)
                if np.ptp(pairs) > 0.0:
                    self.close(row[f"{name}_low95_{unit}"], interval[0], 1000)
                    self.close(row[f"{name}_high95_{unit}"], interval[1], 1000)

    def test_trends(self):
        for (array, selection), row in self.trends.items():
            x, y = (self.values(array, key, selection) for key in ("A_mm", "angle_deg"))
            self.assertEqual((row["x"], row["y"], row["n"]), ("A_mm", "angle_deg", str(len(x))))
            line = stats.linregress(x, y)
            half = stats.t.ppf(0.975, len(x) - 2) * line.stderr
            self.close(row["slope"], line.slope, 100)
            self.close(row["slope_low95"], line.slope - half, 1000)
            self.close(row["slope_high95"], line.slope + half, 1000)
            self.close(row["intercept"], line.intercept, 1000)
            residual = y - line.intercept - line.slope * x
            self.close(row["residual_sd"], math.sqrt(np.sum(residual**2) / (len(x) - 2)), 100)
        self.assertIn(("flex24", "all that ran"), self.trends)

    def test_a_group_that_is_none_is_refused(self):
        out = Path(self.folder.name) / "out"
        done = subprocess.run([str(CLI), "study", "report", str(out), "--group", "nodes"],
                              capture_output=True, text=True, check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("nodes", done.stderr)
        self.assertIn("array", done.stderr)


if __name__ == "__main__":
    unittest.main()
