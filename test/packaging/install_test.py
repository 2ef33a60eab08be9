#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""packaging/install-dependencies installs missing packages once, and reports remedies for errors."""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

from pretended import PretendedSystem  # noqa: E402

SCRIPT = "packaging/install-dependencies"


class InstallDependencies(PretendedSystem):
    def test_a_complete_system_is_left_alone(self):
        self.pretend_packages()
        result = self.call(SCRIPT, "run", "build", "test")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(self.calls("apt-get"), [])

    def test_only_what_is_missing_is_installed_without_questions_and_extras(self):
        self.pretend_packages("cmake", "xvfb")
        result = self.call(SCRIPT, "run", "build")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn(" update", self.calls("apt-get")[0])
        install = self.calls("apt-get")[1].split()
        self.assertEqual(install[-2:], ["cmake", "xvfb"])
        self.assertIn("--no-install-recommends", install)
        self.assertEqual(set(self.calls("frontend")), {"noninteractive"})

    def test_the_second_time_nothing_is_installed(self):
        self.pretend_packages("cmake")
        self.call(SCRIPT, "build")
        before = len(self.calls("apt-get"))
        self.assertEqual(self.call(SCRIPT, "build").returncode, 0)
        self.assertEqual(len(self.calls("apt-get")), before)

    def test_a_group_brings_its_own_packages_only(self):
        self.pretend_packages("libgtest-dev", "cmake")
        self.assertEqual(self.call(SCRIPT, "test").returncode, 0)
        self.assertEqual(self.calls("apt-get")[-1].split()[-1], "libgtest-dev")

    def test_the_build_brings_what_the_engine_needs(self):
        self.pretend_packages("libeigen3-dev", "libvtk9-dev")
        self.assertEqual(self.call(SCRIPT, "engine").returncode, 0)
        self.assertEqual(self.calls("apt-get")[-1].split()[-1], "libeigen3-dev")
        self.assertEqual(self.call(SCRIPT, "build").returncode, 0)
        self.assertEqual(self.calls("apt-get")[-1].split()[-1], "libvtk9-dev")

    def test_the_test_brings_what_makes_the_site(self):
        self.pretend_packages("furo", "libvtk9-dev")
        self.assertEqual(self.call(SCRIPT, "test").returncode, 0)
        self.assertEqual(self.calls("apt-get")[-1].split()[-1], "furo")

    def test_the_qt_is_the_one_that_the_release_builds_vtk_with(self):
        self.pretend_packages("qtbase5-dev", "qt6-base-dev", "libqt5multimedia5-plugins", "qt6-qpa-plugins")
        self.assertEqual(self.call(SCRIPT, "--missing", "run", "build").stdout, "libqt5multimedia5-plugins\nqtbase5-dev\n")
        self.pretend("apt-cache", 'echo "libvtk9-qt-dev"; echo "  Depends: qt6-base-dev"')
        self.assertEqual(self.call(SCRIPT, "--missing", "run", "build").stdout, "qt6-base-dev\nqt6-qpa-plugins\n")

    def test_missing_packages_are_named_and_not_installed(self):
        self.pretend_packages("libeigen3-dev", "libvtk9-dev")
        result = self.call(SCRIPT, "--missing", "build")
        self.assertEqual((result.returncode, result.stdout), (0, "libeigen3-dev\nlibvtk9-dev\n"))
        self.assertEqual(self.calls("apt-get"), [])
        self.pretend_packages()
        self.assertEqual(self.call(SCRIPT, "--missing", "build").stdout, "")

    def test_a_network_that_stumbles_is_tried_three_times(self):
        self.pretend_packages("cmake")
        self.pretend("apt-get", "exit 100")
        result = self.call(SCRIPT, "build")
        self.assert_one_sentence(result, "Check the network")
        installs = [call for call in self.calls("apt-get") if " install " in call]
        self.assertEqual(len(installs), 3)

    def test_a_package_list_that_cannot_be_read_does_not_stop_what_is_known(self):
        self.pretend_packages("cmake")
        works = (self.bin / "apt-get").read_text()
        (self.bin / "apt-get").write_text(
            works.replace("\necho", '\nif [[ "$*" == *" update" ]]; then exit 100; fi\necho', 1))
        self.assertEqual(self.call(SCRIPT, "build").returncode, 0)

    def test_a_package_held_back_is_named(self):
        self.pretend_packages("cmake")
        self.pretend("apt-get", "exit 0")
        self.assert_one_sentence(self.call(SCRIPT, "build"), "still missing: cmake")

    def test_an_unknown_group_is_refused(self):
        self.pretend_packages()
        self.assert_one_sentence(self.call(SCRIPT, "everything"), "no group 'everything'")

    def test_a_system_without_apt_is_told_the_list(self):
        self.assert_one_sentence(self.call(SCRIPT, "build"), "debian-packages.txt")


if __name__ == "__main__":
    unittest.main()
