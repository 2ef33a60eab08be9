#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""packaging/try-release logs what it tried, repeats nothing that passed, and leaves the bare system as it is."""

import re
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from pretended import SOURCE, PretendedSystem  # noqa: E402

SCRIPT = "packaging/try-release"


class TryRelease(PretendedSystem):
    def setUp(self):
        super().setUp()
        self.pretend_packages()
        self.pretend("git", "echo some-commit")
        self.pretend("cp", "")
        self.pretend("cmake", 'if [[ $1 == --preset ]]; then touch "build/$2/build.ninja"; fi')
        self.pretend("bits", "", self.root / "test/replay")
        # A bare system is a folder, and its commands are logged.
        (self.root / "packaging/bare.sh").write_text(f"""
releases=(bookworm trixie)
prepare_bare() {{ :; }}
make_bare() {{ mkdir -p "$2"; }}
enter_bare() {{ :; }}
leave_bare() {{ :; }}
in_bare() {{ echo "in_bare $*" >>"{self.log}"; echo "The first picture was drawn after 200 s."; }}
""")

    def stages(self):
        lines = (self.root / "build/proof/stages.tsv").read_text().splitlines()
        return [tuple(line.split("\t")[i] for i in (0, 1, 4, 5)) for line in lines]

    def test_a_stage_that_passed_is_not_repeated_on_the_same_commit(self):
        for _ in range(2):
            result = self.call(SCRIPT, "trixie", "first")
            self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertIn("Running packaging/run on trixie: passed before on some-commit", result.stdout)
        self.assertEqual(len(self.calls("in_bare")), 1)
        self.pretend("git", "echo another-commit")
        self.call(SCRIPT, "trixie", "first")
        drawn = "The first picture was drawn after 200 s."
        self.assertEqual(self.stages(), [("trixie-first", "some-commit", "passed", drawn),
                                         ("trixie-first", "another-commit", "passed", drawn)])

    def test_bits_are_recorded_by_the_release_build_of_this_system(self):
        result = self.call(SCRIPT, "trixie", "bits")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assertTrue((self.root / "build/release/configured-for").exists())
        self.assertEqual([path.name for path in (self.root / "build/try-release/trixie").iterdir()], [".made"])

    def test_a_release_without_a_name_is_refused(self):
        self.assert_one_sentence(self.call(SCRIPT), "the releases: bookworm trixie.")


class SharedSteps(unittest.TestCase):
    """Bash refuses a local variable of the name of a read-only one; the function then works on the caller's."""

    def test_no_script_makes_a_name_read_only_that_a_shared_function_has_as_a_local_one(self):
        shared = [SOURCE / "packaging/steps.sh", SOURCE / "packaging/bare.sh"]
        local = set()
        for path in shared:
            local |= declared("local", path.read_text())
        self.assertIn("stages_log", local)
        scripts = [path for folder in ("packaging", "test", "resources") for path in (SOURCE / folder).rglob("*")
                   if path.is_file() and path not in shared and sources_steps(path)]
        self.assertIn(SOURCE / SCRIPT, scripts)
        for path in scripts:
            self.assertEqual(declared("readonly", path.read_text()) & local, set(), path)


def sources_steps(path):
    return re.search(rb"^source .*steps\.sh", path.read_bytes(), re.MULTILINE) is not None


def declared(word, text):
    """Names that this word of bash declares in a script."""
    names = set()
    for line in re.findall(rf"^\s*{word} (.*)", text, re.MULTILINE):
        line = re.sub(r'"[^"]*"|\$\([^)]*\)|\$\{[^}]*\}|\([^)]*\)', "", line)
        names |= {each.split("=")[0] for each in line.split() if re.match(r"[A-Za-z_]\w*(=|$)", each)}
    return names


if __name__ == "__main__":
    unittest.main()
