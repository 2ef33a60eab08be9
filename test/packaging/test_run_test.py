#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""test/run ends with the count of cases, and fails if any step failed."""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from pretended import PretendedSystem  # noqa: E402

SCRIPT = "test/run"
COUNT = "100% tests passed, 0 tests failed out of 3"
CASES = "30 passed, 0 failed, 2 skipped"
HOURS = ["robust", "soak", "ends", "anatomy", "ct", "ears", "headers", "hidstack", "cases", "results"]


class TestRun(PretendedSystem):
    def setUp(self):
        super().setUp()
        self.pretend_packages()
        self.pretend("git", "echo some-commit")
        self.pretend("cmake", 'if [[ $1 == --preset ]]; then touch "build/$2/build.ninja"; fi')
        self.pretend("ctest", f'echo "{COUNT}"')
        self.pretend("suites", f'echo "{CASES}"', self.root / "test")

    def presets(self):
        return [call.split()[1] for call in self.calls("ctest")]

    def test_the_last_line_is_the_count_of_cases(self):
        result = self.call(SCRIPT)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout.strip().splitlines()[-2:], [COUNT, CASES])
        self.assertEqual(self.presets(), ["dev"])
        self.assertEqual(self.calls("suites"), ["--preset dev summary"])

    def test_no_tests_at_all_are_no_success(self):
        self.call(SCRIPT)
        self.assertIn("--no-tests=error", self.calls("ctest")[0])

    def test_a_failed_test_fails_the_run(self):
        self.pretend("ctest", "exit 8")
        self.assert_one_sentence(self.call(SCRIPT), "Tests failed in: dev")

    def test_a_sanitizer_that_found_something_fails_the_run_but_lets_the_rest_go_on(self):
        self.pretend("ctest", "[[ $2 != asan ]]")
        self.assert_one_sentence(self.call(SCRIPT, "--long"), "Tests failed in: asan.")
        self.assertEqual(sorted(self.presets()), ["asan", "dev", *["long"] * len(HOURS), "tsan"])

    def stages(self):
        lines = (self.root / "build/proof/stages.tsv").read_text().splitlines()
        return [(fields[0], fields[4]) for fields in (line.split("\t") for line in lines)]

    def test_a_stage_that_passed_is_not_repeated_on_the_same_commit(self):
        self.pretend("ctest", f'echo "{COUNT}"; [[ $2 != tsan ]]')
        self.assert_one_sentence(self.call(SCRIPT, "--long"), "Tests failed in: tsan.")
        self.assertEqual(self.stages(), [("asan", "passed"), ("tsan", "failed"), ("fuzz-30", "passed"),
                                         *[(name, "passed") for name in HOURS], ("dev", "passed")])
        self.assertIn(COUNT, (self.root / "build/proof/stages.tsv").read_text().splitlines()[0])
        self.pretend("ctest", f'echo "{COUNT}"')
        result = self.call(SCRIPT, "--long")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("Testing asan: passed before on some-commit", result.stdout)
        self.assertEqual(sorted(self.presets()), ["asan", "dev", "dev", *["long"] * len(HOURS), "tsan", "tsan"])
        self.pretend("git", "echo another-commit")
        self.call(SCRIPT, "--long")
        self.assertEqual(self.presets().count("asan"), 2)

    def test_a_stage_on_changed_files_is_always_repeated(self):
        self.pretend("git", "echo some-commit-dirty")
        self.call(SCRIPT, "--long")
        self.call(SCRIPT, "--long")
        self.assertEqual(self.presets().count("asan"), 2)

    def test_an_unknown_word_is_refused(self):
        for words in (["--short"], ["long"], ["--long", "asan", "short"]):
            result = self.call(SCRIPT, *words)
            self.assertEqual(result.returncode, 2, words)
            self.assertIn(f"'{words[-1]}' was given", result.stderr)
            self.assertEqual(self.calls("cmake"), [])


if __name__ == "__main__":
    unittest.main()
