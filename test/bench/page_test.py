#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""test/bench/page says what was measured, what misses its target and what is missing; the history keeps every release."""

import importlib.machinery
import importlib.util
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
SCRIPT = Path(__file__).resolve().parent / "page"
sys.path.insert(0, str(SCRIPT.parent))
import history  # noqa: E402
import machine  # noqa: E402
from bench_report import Trouble  # noqa: E402
from page_text import page  # noqa: E402

loader = importlib.machinery.SourceFileLoader("page_command", str(SCRIPT))
command = importlib.util.module_from_spec(importlib.util.spec_from_loader("page_command", loader))
loader.exec_module(command)

LOOP = "loop/period_us:100/seconds:60/iterations:1/real_time"


def measurement(**other):
    """Made up."""
    return {"version": "0.2.0", "commit": "123456789abc", "date": "2026-11-24", "runs": 3,
            "machine": {"processor": "Some CPU", "cores": 2, "is_virtual": True, "memory_gb": 8.36, "system": "Linux 6.1", "load": 0.04,
                        "others_percent": 0.31, "stolen_percent": 0.22},
            "rows": {"tick/rod/nodes:1000": {"p50_us": 270.0, "p99_us": 551.4, "max_us": 2000.0},
                     "tick/rod/nodes:100": {"p50_us": 20.0, "p99_us": 66.0, "max_us": 900.0, "evaluations": 2.4, "max_evaluations": 31.0},
                     "lumen/own/cloud:1000": {"cpu_time": 156.3}, "lumen/vtk/triangles:2000": {"cpu_time": 5990.0},
                     LOOP: {"ticks_per_s": 9910.0, "late_percent": 2.1, "max_us": 300.0, "real_time_priority": 1.0},
                     "simulate": {"seconds": 0.51}, "window": {"first_frame_s": 1.2}},
            "former": {"version": "0.1.0", "commit": "b8cf1418446e", "ratios": {"tick/rod/nodes:100": [0.9, 0.7, 1.1], "simulate": [1.2]}},
            **other}


class PageCase(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def row(self, beginning, found):
        return next([cell.strip() for cell in each[1:-1].split("|")] for each in page(found) if each.startswith(f"| {beginning}"))


class Page(PageCase):
    def test_it_names_release_machine_and_other_work(self):
        text = "\n".join(page(measurement()))
        for said in ("Version 0.2.0, commit `123456789abc`, 2026-11-24. Some CPU, 2 cores, virtual, 8 GB, Linux 6.1.", "Load 0.0 before",
                     "took 0.3 %", "withheld 0.2 %", "least of 3 runs"):
            self.assertIn(said, text)
        self.assertNotIn("busy", text)
        busy = measurement()
        busy["machine"]["others_percent"] = 30.0
        self.assertIn("**The machine was busy with other work", "\n".join(page(busy)))

    def test_a_machine_of_its_own_has_no_host(self):
        own = measurement()
        own["machine"]["is_virtual"] = False
        self.assertNotIn("withheld", "\n".join(page(own)))

    def test_ticks_stand_in_the_order_of_their_nodes_with_what_they_miss(self):
        ticks = [each for each in page(measurement()) if each.startswith("| the published insertion")]
        self.assertIn("insertion, 100 |", ticks[0])
        self.assertTrue(ticks[0].endswith("| 20.0 | 66.0 | 900 | 2.40 (31) | median 25: met; **p99 60: missed by 10 %**; max 1,000: met |"))
        self.assertTrue(ticks[1].endswith("| 270 | 551 | 2,000 | - | **median 250: missed by 8 %** |"))
        self.assertIn("Budget of a tick: 32 evaluations, kept.", list(page(measurement())))

    def test_a_spent_budget_is_said(self):
        found = measurement()
        found["rows"]["tick/rod/nodes:100"]["max_evaluations"] = 40.0
        self.assertIn("Budget of a tick: 32 evaluations, **exceeded: 40**.", list(page(found)))

    def test_a_loop_that_lacks_ticks_says_how_many(self):
        self.assertEqual(self.row("10 kHz", measurement()), ["10 kHz", "9,910", "2.10", "300", "real-time", "**10,000: missed by 0.9 %**"])
        self.assertEqual(self.row("1 kHz", measurement())[1:], ["-"] * 5)

    def test_what_was_not_measured_is_a_dash(self):
        self.assertEqual(self.row("2,000 triangles", measurement()), ["2,000 triangles", "156", "-", "-", "5,990", "-", "-"])
        self.assertEqual(self.row("a plan", measurement())[1], "-")
        self.assertEqual(self.row("start-up", measurement())[1], "1.20 s")
        self.assertIn("No tick was measured.", list(page(measurement(rows={}))))

    def test_the_former_release_is_compared_pair_by_pair_or_said_to_be_missing(self):
        self.assertEqual(self.row("`tick/rod/nodes:100`", measurement())[1:], ["0.90", "0.70", "1.10", "3"])
        self.assertIn("No former release was given (`--former FOLDER`), so nothing is compared.", list(page(measurement(former=None))))

    def test_every_table_has_as_many_cells_in_each_row(self):
        wide = 0
        for each in page(measurement()):
            wide = (wide or each.count("|")) if each.startswith("|") else 0
            self.assertEqual(each.count("|") if wide else 0, wide, each)


class History(PageCase):
    def test_a_release_is_added_and_one_of_the_same_commit_replaced(self):
        text = history.with_rows([], history.rows_of(measurement(version="0.1.0", commit="old", former=None)))
        text = history.with_rows(history.read(text, "h"), history.rows_of(measurement()))
        text = history.with_rows(history.read(text, "h"), history.rows_of(measurement(date="2026-12-01")))
        rows = history.read(text, "h")
        self.assertEqual([(each["version"], each["date"]) for each in rows], [("0.1.0", "2026-11-24"), ("0.2.0", "2026-12-01")])
        self.assertEqual(rows[1]["rod_100_us"], "20")
        self.assertEqual((rows[1]["rod_100_ratio"], rows[1]["simulate_ratio"], rows[1]["compared_with"]), ("0.9", "1.2", "0.1.0"))
        self.assertEqual((rows[1]["plan_s"], rows[0]["rod_100_ratio"]), ("", ""))

    def test_the_former_release_has_a_row_of_its_own_figures(self):
        found = measurement()
        found["former"]["rows"] = {"tick/rod/nodes:100": {"p50_us": 25.0, "p99_us": 80.0}}
        rows = history.read(history.with_rows([], history.rows_of(found)), "h")
        self.assertEqual([(each["version"], each["commit"], each["rod_100_us"]) for each in rows],
                         [("0.1.0", "b8cf1418446e", "25"), ("0.2.0", "123456789abc", "20")])
        self.assertEqual((rows[0]["processor"], rows[0]["compared_with"], rows[0]["rod_100_ratio"]), ("Some CPU", "", ""))

    def test_one_that_lacks_a_column_added_since_is_read(self):
        rows = history.read("version,commit,rod_100_us\n0.1.0,old,23\n", "h")
        self.assertIn("\n0.1.0,old,", history.with_rows(rows, history.rows_of(measurement())))

    def test_a_damaged_one_is_refused_with_its_line(self):
        for text, said in (("version,commit,speed\n", "line 1: speed is no column"), ("\x00PNG\n", "line 1"), ("commit\nabc\n", "line 1"),
                           ("version,commit\n0.1.0,old\n0.2.0\n", "line 3 has 1 cells; it must have 2")):
            with self.subTest(text=text), self.assertRaisesRegex(Trouble, said):
                history.read(text, "h.csv")

    def test_the_stored_one_can_be_read(self):
        stored = SCRIPT.parent / "history.csv"
        if stored.exists():
            self.assertTrue(history.read(stored.read_text(encoding="utf-8"), stored))


class Measuring(PageCase):
    def test_pairs_give_ratios_of_rows_that_both_have(self):
        before = [{"tick": {"p50_us": 10.0, "cpu_time": 1.0}, "gone": {"cpu_time": 1.0}}, {"tick": {"p50_us": 20.0}}]
        after = [{"tick": {"p50_us": 5.0, "cpu_time": 9.0}, "new": {"seconds": 1.0}}, {"tick": {"p50_us": 30.0}}]
        self.assertEqual(command.ratios(before, after), {"tick": [0.5, 1.5]})
        self.assertEqual(command.least_of(after)["tick"]["p50_us"], 5.0)

    def test_a_program_that_is_none_is_named(self):
        with self.assertRaisesRegex(Trouble, "perilymph-cli does not run"):
            command.version_of(self.folder)
        program = self.folder / "perilymph-cli"
        program.write_text("#!/bin/sh\necho 0.1.0+abc\n", encoding="utf-8")
        program.chmod(0o755)
        with self.assertRaisesRegex(Trouble, "has no perilymph-bench"):
            command.version_of(self.folder)
        (self.folder / "perilymph-bench").touch()
        self.assertEqual(command.version_of(self.folder), {"version": "0.1.0", "commit": "abc"})
        program.write_text("#!/bin/sh\necho hello\n", encoding="utf-8")
        with self.assertRaisesRegex(Trouble, "says 'hello', which is no version"):
            command.version_of(self.folder)

    def call(self, *words):
        return subprocess.run([sys.executable, str(SCRIPT), "--out", self.folder / "page.md", "--history", self.folder / "history.csv",
                               *map(str, words)], capture_output=True, text=True, check=False, timeout=60)

    def test_a_kept_measurement_makes_page_and_history_again(self):
        kept = self.folder / "kept.json"
        kept.write_text(json.dumps(measurement()), encoding="utf-8")
        done = self.call("--measured", kept)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("# Performance", (self.folder / "page.md").read_text(encoding="utf-8"))
        self.assertEqual(len((self.folder / "history.csv").read_text(encoding="utf-8").splitlines()), 2)

    def test_a_damaged_measurement_or_history_leaves_both_files_as_they_are(self):
        kept = self.folder / "kept.json"
        for words, said in (("{", "cannot be read"), ("[]", "has no version"), (json.dumps(measurement(machine={})), "has no processor")):
            kept.write_text(words, encoding="utf-8")
            done = self.call("--measured", kept)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
            self.assertIn(said, done.stderr)
        kept.write_text(json.dumps(measurement()), encoding="utf-8")
        (self.folder / "history.csv").write_text("no,history\n", encoding="utf-8")
        self.assertIn("line 1: no, history is no column", self.call("--measured", kept).stderr)
        self.assertFalse((self.folder / "page.md").exists())
        self.assertEqual(self.call("--runs", "0").returncode, 2)


class Machine(unittest.TestCase):
    def test_its_parts_are_read(self):
        cpuinfo = "processor\t: 0\nmodel name\t: Some  CPU\nflags\t\t: fpu hypervisor avx2\n"
        self.assertEqual(machine.processor(cpuinfo), "Some CPU")
        self.assertTrue(machine.is_virtual(cpuinfo))
        self.assertFalse(machine.is_virtual("flags\t: fpu\n"))
        self.assertEqual(machine.memory_gb("MemTotal:  1000000 kB\n"), 1.024)
        self.assertIsNone(machine.memory_gb(""))

    def test_work_of_others_and_of_the_host_is_told_from_its_own(self):
        before, after = "cpu 100 0 100 1000 0 0 0 0 0 0\n", "cpu 400 0 200 1500 0 0 0 100 0 0\n"
        own_s = 200.0 / machine.TICKS_PER_S
        self.assertEqual(machine.occupied(before, after, own_s), (20.0, 10.0))
        self.assertEqual(machine.occupied(before, before, 1.0), (0.0, 0.0))


if __name__ == "__main__":
    unittest.main()
