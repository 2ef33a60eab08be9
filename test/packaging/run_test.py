#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""packaging/run builds, then opens the window, or without a display writes the insertion to files."""

import re
import shutil
import sys
import time
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from pretended import PretendedSystem  # noqa: E402

SCRIPT = "packaging/run"


class Run(PretendedSystem):
    def setUp(self):
        super().setUp()
        self.pretend_packages()
        self.pretend("git", "echo some-commit")
        self.pretend("cmake", 'if [[ $1 == --preset ]]; then touch "build/$2/build.ninja"; fi')
        self.programs = self.root / "build/release/bin"
        self.pretend("perilymph", "", self.programs)
        self.pretend("perilymph-cli", "", self.programs)

    def built(self):
        return [call.split()[-1] for call in self.calls("cmake") if call.startswith("--build")]

    def test_with_a_display_the_window_starts_its_demonstration(self):
        for display in ("DISPLAY", "WAYLAND_DISPLAY"):
            result = self.call(SCRIPT, **{display: ":7"})
            self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.calls("perilymph"), ["--demo", "--demo"])
        self.assertEqual(self.calls("perilymph-cli"), [])

    def test_without_a_display_the_same_insertion_is_kept_in_files(self):
        result = self.call(SCRIPT)
        self.assertEqual(result.returncode, 0, result.stderr)
        simulate = self.calls("perilymph-cli")[0]
        self.assertTrue(simulate.startswith("simulate --scenario contour-published "), simulate)
        for option, name in (("--csv", "csv"), ("--json", "json"), ("--record", "insertion")):
            file = f"{self.root}/build/demo/contour-published.{name}"
            self.assertIn(f"{option} {file}", simulate)
            self.assertIn(file, result.stdout)
        self.assertTrue(all(call.startswith("render ") for call in self.calls("perilymph-cli")[1:]))
        self.assertIn(f"{self.root}/build/demo/surgeon.png", result.stdout)
        self.assertEqual(self.calls("perilymph"), [])

    def test_the_command_line_is_built_first_and_draws_while_the_window_is_built(self):
        self.pretend("cmake", f"""if [[ $1 == --preset ]]; then touch "build/$2/build.ninja"; fi
            if [[ ${{!#}} == all ]]; then {shutil.which("mv")} '{self.programs}/later' '{self.programs}/perilymph'; fi""")
        (self.programs / "perilymph").rename(self.programs / "later")
        result = self.call(SCRIPT, DISPLAY=":7")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.built(), ["perilymph-cli", "all"])
        drawn = f"{self.root}/build/demo/surgeon.png"
        self.assertTrue(self.calls("perilymph-cli")[0].endswith(f"--out {drawn}"))
        self.assertRegex(result.stdout, rf"The first picture was drawn after \d+ s\.\nIt is {re.escape(drawn)};")
        self.assertEqual(self.calls("perilymph"), ["--demo"])

    def without_toolkit_and_programs(self, while_the_engine_is_built):
        """VTK is missing; the programs are built by cmake."""
        self.pretend_packages("libvtk9-dev")
        built, real = self.root / "build/built", shutil.which("mv")
        self.programs.rename(built)
        self.pretend("cmake", f"""if [[ $1 == --preset ]]; then touch "build/$2/build.ninja"; fi
            if [[ ${{!#}} == engine ]]; then {while_the_engine_is_built}; fi
            if [[ ${{!#}} == perilymph-cli ]]; then {real} '{built}' '{self.programs}'; fi""")
        self.pretend("renice", "")

    def test_the_engine_is_built_while_vtk_is_installed(self):
        self.without_toolkit_and_programs("true")
        result = self.call(SCRIPT)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.built(), ["engine", "perilymph-cli", "all"])
        configured = [call for call in self.calls("cmake") if call.startswith("--preset")]
        self.assertIn("PERILYMPH_TOOLKIT=OFF", configured[0])
        self.assertEqual(configured[1:], ["--preset release"])

    def test_a_folder_that_was_configured_with_vtk_is_so_again_after_the_engine(self):
        self.call(SCRIPT)
        self.without_toolkit_and_programs("true")
        self.call(SCRIPT)
        configured = [call for call in self.calls("cmake") if call.startswith("--preset")]
        self.assertEqual([("OFF" in call) for call in configured], [False, True, False])

    def test_an_engine_that_does_not_build_is_said_by_the_build_of_everything(self):
        self.without_toolkit_and_programs("exit 1")
        result = self.call(SCRIPT)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.built(), ["engine", "perilymph-cli", "all"])

    def test_packages_that_cannot_be_installed_end_the_build_of_the_engine(self):
        started = self.bin.parent / "started"
        self.without_toolkit_and_programs(f"echo $$ >'{started}'; exec {shutil.which('sleep')} 600")
        wait = f"until [[ -s '{started}' ]]; do {shutil.which('sleep')} 0.01; done"
        self.pretend("apt-get", f'if [[ " $* " == *" install "* ]]; then {wait}; exit 100; fi')
        self.assert_one_sentence(self.call(SCRIPT), "Packages are missing")
        self.assertTrue(self.ends(int(started.read_text())))

    @staticmethod
    def ends(process):
        """Waits for a process that was told to end; one that nobody waited for ended, too."""
        stat = Path(f"/proc/{process}/stat")
        for _ in range(3000):
            if not stat.exists() or stat.read_text().rsplit(")", 1)[1].split()[0] == "Z":
                return True
            time.sleep(0.01)
        return False

    def test_without_a_display_the_window_is_built_after_the_picture(self):
        lines = self.call(SCRIPT).stdout
        self.assertEqual(self.built(), ["perilymph-cli", "all"])
        self.assertLess(lines.index("surgeon.png"), lines.index("Building the window"))
        self.assertEqual(len(re.findall(r"^The first picture was drawn after \d+ s\.$", lines, re.MULTILINE)), 1)

    def test_the_recording_of_the_last_demonstration_makes_room(self):
        old = self.root / "build/demo/contour-published.insertion"
        old.parent.mkdir(parents=True)
        old.touch()
        self.call(SCRIPT)
        self.assertFalse(old.exists())

    def test_words_go_to_the_workstation_in_place_of_the_demonstration(self):
        self.call(SCRIPT, "--scenario", "my file.toml", DISPLAY=":7")
        self.assertEqual(self.calls("perilymph"), ["--scenario my file.toml"])

    def test_a_picture_that_cannot_be_drawn_leaves_the_curve_and_says_so(self):
        self.pretend("perilymph-cli", "[[ $1 != render ]]", self.programs)
        result = self.call(SCRIPT)
        self.assert_one_sentence(result, "picture")
        self.assertIn("contour-published.csv", result.stdout)

    def test_an_insertion_that_fails_is_said(self):
        self.pretend("perilymph-cli", "echo 'No such array.' >&2; exit 1", self.programs)
        self.assert_one_sentence(self.call(SCRIPT), "did not run")

    def test_a_second_start_does_not_configure_again(self):
        self.call(SCRIPT)
        self.call(SCRIPT)
        configured = [call for call in self.calls("cmake") if call.startswith("--preset")]
        self.assertEqual(configured, ["--preset release"])

    def test_another_commit_configures_again(self):
        self.call(SCRIPT)
        self.pretend("git", "echo another-commit")
        self.call(SCRIPT)
        configured = [call for call in self.calls("cmake") if call.startswith("--preset")]
        self.assertEqual(len(configured), 2)

    def test_a_build_folder_from_another_place_is_replaced(self):
        cache = self.root / "build/release/CMakeCache.txt"
        cache.write_text("CMAKE_HOME_DIRECTORY:INTERNAL=/another/place\n")
        self.call(SCRIPT, DISPLAY=":7")
        self.assertFalse(cache.exists())

    def test_a_build_that_fails_is_said(self):
        self.pretend("cmake", '[[ $1 != --build ]] || exit 1\ntouch "build/$2/build.ninja"')
        self.assert_one_sentence(self.call(SCRIPT), "does not build")

    def test_a_configuration_that_fails_shows_its_last_words_and_is_tried_again(self):
        self.pretend("cmake", "echo 'Could not find VTK'; exit 1")
        result = self.call(SCRIPT)
        self.assert_one_sentence(result, "could not configure preset release")
        self.assertIn("Could not find VTK", result.stderr)
        self.call(SCRIPT)
        self.assertEqual(len(self.calls("cmake")), 2)

    def test_each_step_is_printed_with_its_time(self):
        lines = self.call(SCRIPT).stdout
        for step in ("Looking for packages", "Configuring", "Building", "Inserting"):
            self.assertRegex(lines, rf"==> {step}.*: done, \d+\.\d s")


if __name__ == "__main__":
    unittest.main()
