#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of the groups of a study, calculated again from its points with NumPy and SciPy."""

import csv
import math
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
        cls.groups = {row["group"]: row for row in table(root / "out" / "groups.csv")}
        cls.differences = table(root / "out" / "differences.csv")
        cls.trends = {row["group"]: row for row in table(root / "out" / "trends.csv")}

    @staticmethod
    def call(*arguments):
        done = subprocess.run([str(CLI), *arguments], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def close(self, found, expected, scale):
        self.assertAlmostEqual(float(found), expected, delta=1e-8 * scale)

    def values(self, array, key):
        return np.array([float(row[key]) for row in self.own[array]])

    def test_points_are_those_of_the_study(self):
        self.assertEqual(self.all_points, self.insertions)

    def test_groups(self):
        stopped = 0
        for array, own in self.own.items():
            row = self.groups[array]
            complete = sum(each["ending"] == "finished" for each in own)
            stopped += 9 - complete
            self.assertEqual((row["n"], row["complete"], row["stopped"]),
                             ("9", str(complete), str(9 - complete)))
            interval = stats.binomtest(complete, 9).proportion_ci(method="wilson")
            # the program takes 1.96, SciPy 1.959964
            self.assertAlmostEqual(float(row["complete_low95_percent"]), 100 * interval.low, delta=2e-3)
            self.assertAlmostEqual(float(row["complete_high95_percent"]), 100 * interval.high, delta=2e-3)
            for name, unit, key in QUANTITIES:
                for what, share in (("median", 0.5), ("quartile25", 0.25), ("quartile75", 0.75)):
                    self.close(row[f"{name}_{what}_{unit}"], np.quantile(self.values(array, key), share), 100)
        self.assertIn(stopped, range(1, 18), "some stop, some do not")

    def test_differences_are_those_of_pairs(self):
        self.assertEqual(len(self.differences), 1)
        row = self.differences[0]
        self.assertEqual((row["method"], row["n"], row["n_other"], row["cochleae"]), ("paired", "9", "9", "9"))
        one, other = ({each["cochlea"]: each for each in self.own[row[key]]} for key in ("group", "other"))
        for name, unit, key in QUANTITIES:
            pairs = [float(each[key]) - float(other[cochlea][key]) for cochlea, each in one.items()]
            interval = stats.t.interval(0.95, 8, np.mean(pairs), stats.sem(pairs))
            self.close(row[f"{name}_difference_{unit}"], np.mean(pairs), 100)
            self.close(row[f"{name}_low95_{unit}"], interval[0], 1000)
            self.close(row[f"{name}_high95_{unit}"], interval[1], 1000)

    def test_trends(self):
        for array in self.own:
            row = self.trends[array]
            self.assertEqual((row["x"], row["y"], row["n"]), ("A_mm", "angle_deg", "9"))
            x, y = self.values(array, "A_mm"), self.values(array, "angle_deg")
            line = stats.linregress(x, y)
            half = stats.t.ppf(0.975, 7) * line.stderr
            self.close(row["slope"], line.slope, 100)
            self.close(row["slope_low95"], line.slope - half, 1000)
            self.close(row["slope_high95"], line.slope + half, 1000)
            self.close(row["intercept"], line.intercept, 1000)
            residual = y - line.intercept - line.slope * x
            self.close(row["residual_sd"], math.sqrt(np.sum(residual**2) / 7), 100)

    def test_a_group_that_is_none_is_refused(self):
        out = Path(self.folder.name) / "out"
        done = subprocess.run([str(CLI), "study", "report", str(out), "--group", "nodes"],
                              capture_output=True, text=True, check=False)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("nodes", done.stderr)
        self.assertIn("array", done.stderr)


if __name__ == "__main__":
    unittest.main()
