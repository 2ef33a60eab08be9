#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""test/fuzz/campaign searches each target once on a commit, and in pieces if it was interrupted."""

import shutil
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from pretended import SOURCE, PretendedSystem  # noqa: E402

SCRIPT = "test/fuzz/campaign"
FINDS_NOTHING = "echo stat::number_of_executed_units: 7"


class FuzzCampaign(PretendedSystem):
    def setUp(self):
        super().setUp()
        shutil.copy(SOURCE / SCRIPT, self.root / SCRIPT)
        (self.bin / "xargs").symlink_to(shutil.which("xargs", path="/usr/bin:/bin"))
        self.targets = self.root / "build/fuzz/test/bin"
        self.targets.mkdir(parents=True)
        (self.targets.parent / "fuzz-targets").write_text("fuzz_hid 64 60\nfuzz_scenario 4096 60\n\n")
        for target in ("fuzz_hid", "fuzz_scenario"):
            self.pretend(target, FINDS_NOTHING, self.targets)
        self.pretend("cmake", 'if [[ $1 == --preset ]]; then touch "build/$2/build.ninja"; fi')
        self.on_commit("some-commit")

    def on_commit(self, commit):
        self.pretend("git", f"echo {commit}")

    def search(self, *targets):
        result = self.call(SCRIPT, *targets, PERILYMPH_FUZZ_SECONDS="600")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        return result.stdout

    def searches(self):
        return [len(self.calls(target)) for target in ("fuzz_hid", "fuzz_scenario")]

    def test_each_target_is_a_stage_of_the_log(self):
        self.assertIn("2 targets, 14 inputs, nothing found", self.search())
        lines = [line.split("\t") for line in (self.root / "build/proof/stages.tsv").read_text().splitlines()]
        self.assertEqual(sorted((fields[0], fields[1], fields[4]) for fields in lines),
                         [(f"fuzz-600-{target}", "some-commit", "passed") for target in ("hid", "scenario")])
        self.assertEqual({" ".join(fields[5].split()[1:]) for fields in lines}, {"7 inputs in 600 s, nothing found"})

    def test_a_campaign_is_run_in_pieces_and_counts_them_all(self):
        self.assertIn("1 targets, 7 inputs, nothing found", self.search("fuzz_scenario"))
        self.assertIn("2 targets, 14 inputs, nothing found", self.search())
        self.assertEqual(self.searches(), [1, 1])

    def test_another_commit_is_searched_again(self):
        self.search()
        self.on_commit("another-commit")
        self.assertIn("2 targets, 14 inputs, nothing found", self.search())
        self.assertEqual(self.searches(), [2, 2])

    def test_a_finding_fails_the_campaign_after_the_other_targets_and_is_searched_again(self):
        self.pretend("fuzz_hid", "echo a crash; exit 77", self.targets)
        result = self.call(SCRIPT, PERILYMPH_FUZZ_SECONDS="600")
        self.assert_one_sentence(result, "Something was found")
        self.assertIn("fuzz_hid found something; the input is in", result.stdout)
        self.assertNotIn("targets, ", result.stdout)
        self.pretend("fuzz_hid", FINDS_NOTHING, self.targets)
        self.assertIn("2 targets, 14 inputs, nothing found", self.search())
        self.assertEqual(self.searches(), [2, 1])

    def test_a_target_that_does_not_exist_is_refused(self):
        self.assert_one_sentence(self.call(SCRIPT, "fuzz_moon"), "There is no target 'fuzz_moon'. The targets: fuzz_hid fuzz_scenario")

    def test_seconds_that_are_no_number_are_refused(self):
        self.assert_one_sentence(self.call(SCRIPT, PERILYMPH_FUZZ_SECONDS="long"), "PERILYMPH_FUZZ_SECONDS is 'long'")


if __name__ == "__main__":
    unittest.main()
