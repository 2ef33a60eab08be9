#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The statistics of two techniques, compared with an independent calculation from the exported table: means
and deviations of the module statistics, Student's quantile by integration of the density in another
variable and, where they are installed, by SciPy and pandas."""

import csv
import math
import statistics
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy as np

CLI = Path(sys.argv.pop(1)) / "perilymph-cli" if len(sys.argv) > 1 else None
SPEEDS = (0.8, 1.0, 1.3, 1.7, 2.0)  # mm/s
QUANTITIES = ("peak_N", "array_peak_N", "end_N", "work_mJ", "mean_speed_mm_s", "duration_s",
              "deepest_angle_deg", "score")


def table(path):
    with open(path, newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


def student_quantile(freedom):
    """t = sqrt(f) tan(x) has a density of cos(x) to the power of f - 1: sums at the middles of steps."""
    steps = 1_000_000
    width = math.pi / 2 / steps
    sums = np.cumsum(np.cos((np.arange(steps) + 0.5) * width) ** (freedom - 1))
    x = np.interp(0.95 * sums[-1], sums, (np.arange(steps) + 1) * width)
    return math.sqrt(freedom) * math.tan(x)


def welch(one, other):
    """Difference of means, bounds of its 95 % interval, degrees of freedom."""
    squares = [statistics.variance(sample) / len(sample) for sample in (one, other)]
    total = sum(squares)
    freedom = total**2 / sum(
        square**2 / (len(sample) - 1) for square, sample in zip(squares, (one, other)))
    difference = statistics.fmean(one) - statistics.fmean(other)
    half = student_quantile(freedom) * math.sqrt(total)
    return difference, difference - half, difference + half, freedom


class TwoTechniques(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        root = Path(cls.folder.name)
        files = []
        for technique in ("standard", "aos"):
            for number, speed in enumerate(SPEEDS):
                file = root / f"{technique}-{number}.insertion"
                cls.call("simulate", "--scenario", "contour-published", "--nodes", "30",
                         "--set", f"technique={technique}", "--set", f"speed_mm_s={speed}",
                         "--set", f"stop_travel_mm={11.0 + 0.2 * number}", "--record", str(file))
                files.append(str(file))
        cls.out = root / "out"
        cls.printed = cls.call("compare", *files, "--over", "angle", "--group", "technique",
                               "--out", str(cls.out))
        cls.insertions = table(cls.out / "comparison.csv")
        cls.differences = {row["quantity"]: row for row in table(cls.out / "differences.csv")}
        cls.groups = {(row["group"], row["quantity"]): row for row in table(cls.out / "groups.csv")}

    @staticmethod
    def call(*arguments):
        done = subprocess.run([str(CLI), *arguments], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return done.stdout

    def values(self, technique, quantity):
        return [float(row[quantity]) for row in self.insertions if row["technique"] == technique]

    def test_means_and_deviations(self):
        for technique in ("standard", "aos"):
            for quantity in QUANTITIES:
                values = self.values(technique, quantity)
                row = self.groups[technique, quantity]
                self.assertEqual(int(row["n"]), 5)
                self.assertAlmostEqual(float(row["mean"]), statistics.fmean(values), delta=1e-9)
                self.assertAlmostEqual(float(row["sd"]), statistics.stdev(values), delta=1e-9)
                half = student_quantile(4) * statistics.stdev(values) / math.sqrt(5)
                self.assertAlmostEqual(
                    float(row["high95"]), statistics.fmean(values) + half, delta=1e-6 * half + 1e-12)

    def test_differences(self):
        for quantity in QUANTITIES:
            row = self.differences[quantity]
            self.assertEqual((row["group"], row["other"]), ("aos", "standard"))
            expected = welch(self.values("aos", quantity), self.values("standard", quantity))
            scale = expected[2] - expected[1]
            self.assertGreater(scale, 0.0, quantity)
            found = [float(row[key]) for key in ("difference", "low95", "high95")]
            for value, truth in zip(found, expected):
                self.assertAlmostEqual(value, truth, delta=1e-6 * scale, msg=quantity)
            self.assertAlmostEqual(float(row["degrees_of_freedom"]), expected[3], delta=1e-6)

    def test_differences_of_scipy(self):
        try:
            from scipy import stats
        except ImportError:
            self.skipTest("SciPy is not installed.")
        for quantity in QUANTITIES:
            one, other = self.values("aos", quantity), self.values("standard", quantity)
            row = self.differences[quantity]
            half = 0.5 * (float(row["high95"]) - float(row["low95"]))
            error = math.sqrt(statistics.variance(one) / 5 + statistics.variance(other) / 5)
            quantile = stats.t.ppf(0.975, float(row["degrees_of_freedom"]))
            self.assertAlmostEqual(half, quantile * error, delta=1e-6 * half)
            # the interval holds 0 exactly if Welch's test has a p of 0.05 or more
            p = stats.ttest_ind(one, other, equal_var=False).pvalue
            self.assertEqual(float(row["low95"]) <= 0.0 <= float(row["high95"]), p >= 0.05, quantity)

    def test_tables_of_pandas(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("pandas is not installed.")
        insertions = pandas.read_csv(self.out / "comparison.csv")
        quantities = list(QUANTITIES)
        own = insertions.groupby("technique")[quantities].agg(["count", "mean", "std", "sem"]).stack(0)
        groups = pandas.read_csv(self.out / "groups.csv").set_index(["group", "quantity"]).loc[own.index]
        pandas.testing.assert_series_equal(groups["n"], own["count"], check_names=False, check_dtype=False)
        for column, expected in (("mean", "mean"), ("sd", "std")):
            pandas.testing.assert_series_equal(groups[column], own[expected], check_names=False, rtol=1e-9)
        # half of the interval by the standard error: t(4) = 2.776445 (table of Student's distribution)
        ratio = 0.5 * (groups["high95"] - groups["low95"]) / own["sem"]
        np.testing.assert_allclose(ratio, 2.7764451, rtol=1e-6)
        differences = pandas.read_csv(self.out / "differences.csv").set_index("quantity").loc[quantities]
        means = own["mean"].unstack(0)
        pandas.testing.assert_series_equal(
            differences["difference"], (means["aos"] - means["standard"]).loc[quantities],
            check_names=False, rtol=1e-9)
        # the score of every row is of one definition, between 0 and 100
        self.assertEqual(set(insertions["score_definition"]), {4})
        self.assertTrue(insertions["score"].between(0, 100).all())

    def test_mean_speed_is_that_of_the_scenario(self):
        for technique in ("standard", "aos"):
            for found, speed in zip(sorted(self.values(technique, "mean_speed_mm_s")), SPEEDS):
                self.assertAlmostEqual(found, speed, delta=0.02 * speed)

    def test_other_tables(self):
        curves = table(self.out / "curves.csv")
        self.assertEqual(list(curves[0])[0], "angle_deg")
        self.assertEqual(len(curves[0]), 11)
        events = table(self.out / "events.csv")
        peaks = {row["name"]: float(row["force_N"]) for row in events if row["event"] == "peak"}
        for row in self.insertions:
            self.assertAlmostEqual(peaks[row["name"]], float(row["peak_N"]), delta=1e-12)
        self.assertIn("advance off-stylet - standard, 95 % interval of each of 10 quantities", self.printed)
        self.assertIn("mixes insertions that differ in set speed, stop", self.printed)


if __name__ == "__main__":
    unittest.main()
