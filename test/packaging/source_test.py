#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Debian source package: the same bytes at any time, and dependencies that are stated once."""

import hashlib
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
DEBIAN = ROOT / "packaging/debian"


def run(*words, **keys):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300, **keys)


def groups():
    """Packages of each group of debian-packages.txt, with those for the Qt of Debian 12 and 13, which control names."""
    found = {}
    for line in (ROOT / "packaging/debian-packages.txt").read_text().splitlines():
        if line.startswith("["):
            names = found.setdefault(line.strip("[]").removesuffix("-qt5"), set())
        elif line and not line.startswith("#"):
            names.add(line)
    return found


def paragraphs():
    """Fields of each paragraph of control; the first is that of the source."""
    return [dict(re.findall(r"^([A-Za-z-]+):((?:.*)(?:\n .*)*)", each, re.MULTILINE))
            for each in (DEBIAN / "control").read_text().strip().split("\n\n")]


def names(field):
    """Names of packages in a field, without versions and profiles."""
    return {each.split()[0] for each in field.split(",")}


class Dependencies(unittest.TestCase):
    """debian-packages.txt, which install-dependencies reads, lists what control names."""

    def test_what_the_build_needs_is_what_install_dependencies_installs_for_it(self):
        source = paragraphs()[0]
        needed = names(source["Build-Depends"]) | names(source["Build-Depends-Indep"])
        # debhelper's extensions by the packages that have them.
        extensions = {"debhelper-compat": "debhelper", "dh-sequence-python3": "dh-python", "dh-sequence-sphinxdoc": "python3-sphinx"}
        listed = groups()
        installed = listed["engine"] | listed["build"] | listed["package"] | listed["site"]
        # Every build has build-essential and with it dpkg-dev; the others are a developer's.
        self.assertEqual({extensions.get(name, name) for name in needed},
                         installed - {"build-essential", "dpkg-dev", "ccache", "git", "lintian"})

    def test_what_the_programs_need_besides_what_they_link_is_what_install_dependencies_installs_to_run_them(self):
        program = next(each for each in paragraphs() if each.get("Package") == " perilymph")
        fixed = {name for name in names(program["Depends"]) if not name.startswith("$")}
        # A screen is on the desktop, and in a file's picture that is drawn without one.
        self.assertEqual(fixed, groups()["run"] - {"xvfb", "xauth"})


class Source(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        if run("git", "-C", ROOT, "rev-parse", "HEAD").returncode != 0:
            raise unittest.SkipTest("this is no repository")
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folders = [Path(cls.scratch.name) / name for name in ("one", "two")]
        for folder in cls.folders:
            made = run(ROOT / "packaging/source", folder)
            if made.returncode != 0:
                raise AssertionError(made.stdout + made.stderr)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_the_same_commit_gives_the_same_bytes_at_another_time(self):
        sums = [{file.name: hashlib.sha256(file.read_bytes()).hexdigest()
                 for ending in ("dsc", "tar.*") for file in folder.glob(f"perilymph_*.{ending}")} for folder in self.folders]
        self.assertEqual(sums[0], sums[1])
        self.assertEqual(len(sums[0]), 3)  # of upstream, of Debian, and what describes both

    def test_it_states_the_commit_and_lintian_finds_nothing(self):
        tree = self.folders[0] / "tree"
        run("dpkg-source", "--no-check", "--extract", next(self.folders[0].glob("*.dsc")), tree, check=True)
        commit = run("git", "-C", ROOT, "rev-parse", "HEAD", check=True).stdout
        self.assertEqual((tree / "packaging/commit").read_text(), commit)
        checked = run(ROOT / "packaging/check-packages", next(self.folders[0].glob("*.changes")))
        self.assertEqual((checked.returncode, checked.stdout), (0, ""), checked.stderr)

    def test_a_folder_with_something_else_is_not_emptied(self):
        with tempfile.TemporaryDirectory() as folder:
            (Path(folder) / "mine").write_text("")
            refused = run(ROOT / "packaging/source", folder)
            self.assertEqual((refused.returncode, refused.stdout), (1, ""))
            self.assertIn("holds something else", refused.stderr)
            self.assertTrue((Path(folder) / "mine").exists())


class Copyright(unittest.TestCase):
    def test_every_license_that_is_named_is_there_as_a_whole(self):
        text = (DEBIAN / "copyright").read_text()
        used = set(re.findall(r"^Copyright:.*\n(?: .*\n)*License: (\S+)$", text, re.MULTILINE))
        stated = dict(re.findall(r"(?<=\n\n)License: (\S+)\n((?: .*\n?)+)", text))
        self.assertEqual(used, set(stated))
        # First and last words of each text, but of CC0, which every Debian has.
        for name, first, last in (("BSD-3-Clause", "Redistribution and use", "POSSIBILITY OF SUCH DAMAGE."),
                                  ("OFL-1.1", "PREAMBLE", "DEALINGS IN THE FONT SOFTWARE."),
                                  ("CC-BY-4.0", "Attribution 4.0 International", "contacted at creativecommons.org.")):
            self.assertTrue(stated[name].strip().startswith(first), name)
            self.assertTrue(stated[name].strip().endswith(last), name)

    def test_every_file_that_it_names_is_in_the_tree(self):
        for field in re.findall(r"^Files: ((?:.*\n)(?: .*\n)*)", (DEBIAN / "copyright").read_text(), re.MULTILINE):
            for pattern in field.split():
                self.assertTrue(any(ROOT.glob(pattern)), pattern)


if __name__ == "__main__":
    unittest.main()
