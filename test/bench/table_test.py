#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""test/bench/table fills the table from the benchmark's output, and reports errors."""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parent / "table"


def run(name, cpu_time=1.0, **figures):
    return {"name": name, "run_type": "iteration", "iterations": 8250, "cpu_time": float(cpu_time),
            **figures}


def tick(name, median, p99):
    return run(name, p50_us=float(median), p99_us=float(p99))


TICKS = [tick("tick/rod/nodes:100", 22.61, 60.4), tick("tick/rod/nodes:200", 44.0, 120.0),
         tick("tick/rod/nodes:1000", 239.4, 626.0), tick("tick/points/nodes:12", 1.58, 2.5)]
WALLS = [run("lumen/own/cloud:1000", 165.2), run("lumen/embree/triangles:2000", 1430.25),
         run("lumen/fcl/triangles:200000", 29554.1)]


class Table(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def pretend(self, runs, status=0, words=None):
        """A benchmark that notes its arguments and prints a report."""
        report = {"context": {"date": "2026-11-20T16:46:57+00:00", "num_cpus": 2,
                              "load_avg": [0.31, 1.0, 2.0]}, "benchmarks": runs}
        (self.folder / "report").write_text(words or json.dumps(report), encoding="utf-8")
        bench = self.folder / "bench"
        bench.write_text(f'#!/bin/sh\necho "$@" > "{self.folder}/arguments"\n'
                         f'cat "{self.folder}/report"\nexit {status}\n', encoding="utf-8")
        bench.chmod(0o755)
        return bench

    def call(self, *words):
        return subprocess.run([sys.executable, str(SCRIPT), *map(str, words)], check=False,
                              capture_output=True, text=True, timeout=60)

    def rows(self, *words):
        result = self.call(*words)
        self.assertEqual(result.returncode, 0, result.stderr)
        rows = [[cell.strip() for cell in each[1:-1].split("|")]
                for each in result.stdout.splitlines() if each.startswith("|")]
        self.assertEqual({len(row) for row in rows}, {7})  # one table
        return rows

    def test_ticks_stand_under_their_nodes_and_beside_their_threads(self):
        two = [tick("tick/rod/nodes:200/threads:2", 51.0, 99.0)]
        rows = self.rows(self.pretend(TICKS + two))
        self.assertEqual(rows[0][1:], ["rod, 100 nodes", "200 nodes", "1000 nodes", "12 points", "", ""])
        self.assertEqual(rows[2], ["one thread", "22.6 (60.4)", "44.0 (120)", "239 (626)",
                                   "1.58 (2.50)", "", ""])
        self.assertEqual(rows[3][1:], ["-", "51.0 (99.0)", "-", "-", "", ""])

    def test_libraries_that_are_not_here_leave_a_dash(self):
        rows = self.rows(self.pretend(TICKS + WALLS))
        self.assertEqual([title.strip("*") for title in rows[4]],
                         ["nearest wall, ns a query", "our lumen", "Embree", "CGAL", "VTK", "FCL", "Bullet"])
        self.assertEqual(rows[5], ["2,000 triangles", "165", "1,430", "-", "-", "-", "-"])
        self.assertEqual(rows[7], ["200,000 triangles", "165", "-", "-", "-", "29,600", "-"])

    def test_each_figure_is_the_least_of_all_runs_and_no_mean(self):
        runs = [tick("tick/rod/nodes:100", 30.0, 50.0), tick("tick/rod/nodes:100", 20.0, 70.0),
                {"name": "tick/rod/nodes:100_mean", "run_type": "aggregate", "p50_us": 1.0,
                 "p99_us": 1.0}]
        self.assertEqual(self.rows(self.pretend(runs))[2][1], "20.0 (50.0)")

    def test_the_first_line_says_when_how_and_on_what(self):
        result = self.call("--runs", "3", self.pretend(TICKS))
        first = result.stdout.splitlines()[0]
        for said in ("2026-11-20", "`test/bench/table --runs 3`", "2 cores", "load 0.3", "3 runs"):
            self.assertIn(said, first)
        self.assertIn("--benchmark_repetitions=3", (self.folder / "arguments").read_text())

    def test_a_library_that_answers_something_else_ends_it(self):
        wrong = {"name": "lumen/vtk/triangles:2000", "run_type": "iteration", "error_occurred": True,
                 "error_message": "The answers lie up to 400 um from our own."}
        result = self.call(self.pretend(TICKS + [wrong]))
        self.assertEqual((result.returncode, result.stdout), (1, ""))
        self.assertIn("lumen/vtk/triangles:2000: The answers lie up to 400 um", result.stderr)

    def test_what_cannot_be_run_is_said_in_a_sentence(self):
        def complaint(bench):
            result = self.call(bench)
            self.assertEqual((result.returncode, result.stdout), (1, ""))
            return result.stderr

        self.assertIn("Build it: cmake --preset release", complaint(self.folder / "gone"))
        self.assertIn("ended with 3", complaint(self.pretend(TICKS, status=3)))
        self.assertIn("has no row of a tick", complaint(self.pretend([])))
        self.assertIn("printed no JSON", complaint(self.pretend([], words="nothing")))
        self.assertEqual(self.call("--runs", "0").returncode, 2)


if __name__ == "__main__":
    unittest.main()
