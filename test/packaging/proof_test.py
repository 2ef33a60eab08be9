#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""test/proof prints what the log says, and nothing else."""

import shutil
import subprocess
import sys
import unittest

from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from pretended import SOURCE, PretendedSystem  # noqa: E402

ONE = "1" * 40
LINE = f"asan\t{ONE}\t2026-03-04T05:00:00Z\t2026-03-04T05:41:07Z\tpassed\t100% tests passed, 0 tests failed out of 12\tA processor, 2 cores"


class Proof(PretendedSystem):
    def setUp(self):
        super().setUp()
        shutil.copy(SOURCE / "test/proof", self.root / "test/proof")
        self.guide = self.root / "resources/guide"
        self.guide.mkdir(parents=True)
        self.proof = self.root / "build/proof"
        self.proof.mkdir(parents=True)

    def page(self, *lines, status=0):
        (self.proof / "stages.tsv").write_text("".join(f"{line}\n" for line in lines))
        result = subprocess.run([sys.executable, self.root / "test/proof"],
                                capture_output=True, text=True, check=False, timeout=60)
        self.assertEqual(result.returncode, status, result.stderr)
        return (self.guide / "proof.md").read_text() if status == 0 else result.stderr

    def test_a_row_names_claim_command_commit_time_duration_and_the_line_that_counts(self):
        row = next(line for line in self.page(LINE).splitlines() if "sanitizers" in line)
        self.assertEqual([cell.strip() for cell in row.strip("|").split("|")[1:]],
                         ["`test/run --long asan`", "`111111111111`", "2026-03-04 05:00:00", "41 min 07 s",
                          "**passed**: 100% tests passed, 0 tests failed out of 12"])

    def test_the_last_run_of_a_stage_counts_even_if_it_failed(self):
        page = self.page(LINE, LINE.replace("passed\t100%", "failed\t99%").replace("05:00", "06:00").replace("05:41", "06:01"))
        self.assertNotIn("**passed**", page)
        self.assertIn("**failed**: 99% tests passed", page)

    def test_commits_that_differ_are_said(self):
        self.assertIn("All of it ran on commit `111111111111`", self.page(LINE))
        self.assertIn("Not all of it ran on one commit",
                      self.page(LINE, LINE.replace("asan", "tsan").replace(ONE, "2" * 40)))
        self.assertIn("`111111111111-dirty`", self.page(LINE.replace(ONE, ONE + "-dirty")))

    def test_what_was_not_run_is_said(self):
        page = self.page(LINE)
        self.assertIn("Not run: ", page)
        self.assertIn("`packaging/try-release trixie bits`", page.split("Not run: ")[1])
        self.assertIn("`PERILYMPH_FUZZ_SECONDS=30 test/run --long fuzz`", page.split("Not run: ")[1])

    def test_the_machine_and_the_seconds_of_each_reader_are_said(self):
        page = self.page(LINE, LINE.replace("asan", "fuzz-30").replace("A processor", "Another"))
        self.assertIn("(1) A processor, 2 cores; (2) Another, 2 cores.", page)
        self.assertIn("| 41 min 07 s (1) |", page)
        self.assertIn("| 41 min 07 s (2) |", page)
        self.assertIn("in 30 s for each target", page)

    def test_a_fuzz_target_has_its_longest_search_unless_a_later_one_found_something(self):
        searched = LINE.replace("asan", "fuzz-600-scenario")
        shorter = searched.replace("600", "30").replace("T05:", "T06:")
        page = self.page(LINE, searched, shorter)
        row = next(line for line in page.split("## Each fuzz target")[1].splitlines() if "fuzz_scenario" in line)
        self.assertIn("breaks `fuzz_scenario`, in 600 s | `PERILYMPH_FUZZ_SECONDS=600 test/fuzz/campaign fuzz_scenario`", row)
        self.assertNotIn("in 30 s", page)
        self.assertIn("in 30 s", self.page(shorter.replace("passed\t", "failed\t").replace("T06:", "T07:")))

    def test_a_stage_that_counts_nothing_has_its_result_alone(self):
        self.assertIn("| **passed** |", self.page(LINE.replace("100% tests passed, 0 tests failed out of 12", "")))

    def test_what_was_run_before_is_kept_unless_it_was_run_again(self):
        self.page(LINE, LINE.replace("asan", "tsan"))
        page = self.page(LINE.replace("asan", "soak"), LINE.replace("2026-03-04T05", "2026-03-04T06").replace("12", "13"))
        self.assertEqual(page.count("**passed**"), 3)
        self.assertIn("out of 13", page)
        kept = (self.guide / "proof.tsv").read_text().splitlines()
        self.assertEqual([line.split("\t")[0] for line in kept], ["stage", "asan", "tsan", "soak"])

    def test_a_log_that_is_not_understood_is_refused_in_one_sentence(self):
        for line, words in ((LINE.replace("asan", "moon"), "'moon'"), ("asan\tpassed", "2 fields")):
            self.assertIn(words, self.page(line, status=1))


if __name__ == "__main__":
    unittest.main()
