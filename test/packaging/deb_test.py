#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The Debian packages: their content, lintian, and the unpacked programs.

The rules of packaging/debian pack the build under test; building it again from source is `packaging/deb`.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BUILD = Path(sys.argv.pop(1)).resolve()


def run(*words, **keys):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300, **keys)


class DebianPackages(unittest.TestCase):
    """Packages made from the build under test."""

    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name)
        tree = cls.folder / "source"
        shutil.copytree(ROOT / "packaging/debian", tree / "debian")
        # The guide as HTML is a minute of Sphinx: test/app/site_test.py.
        env = {**os.environ, "PERILYMPH_BUILD": str(BUILD), "DEB_BUILD_PROFILES": "nocheck nodoc",
               "DEB_BUILD_OPTIONS": "nocheck nodoc noautodbgsym"}
        made = run("dpkg-buildpackage", "--build=binary", "--no-check-builddeps", "--no-pre-clean", "--no-sign", cwd=tree, env=env)
        if made.returncode != 0:
            raise AssertionError(made.stdout + made.stderr)
        cls.program = next(cls.folder.glob("perilymph_*.deb"))
        cls.sdk = next(cls.folder.glob("perilymph-dev_*.deb"))
        cls.python = next(cls.folder.glob("python3-perilymph_*.deb"))
        cls.unpacked = cls.folder / "unpacked"
        for package in (cls.program, cls.sdk, cls.python):
            run("dpkg-deb", "-x", package, cls.unpacked, check=True)

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def field(self, package, name):
        return run("dpkg-deb", "-f", package, name, check=True).stdout.strip()

    def test_lintian_accepts_them(self):
        checked = run(ROOT / "packaging/check-packages", self.program, self.sdk, self.python)
        self.assertEqual((checked.returncode, checked.stdout), (0, ""), checked.stderr)

    def test_what_the_programs_link_is_what_the_package_depends_on(self):
        depends = self.field(self.program, "Depends")
        # Debian 12 has VTK 9.1, Debian 13 has 9.3 and "t64" after the names of some libraries.
        for name in ("libc6", r"libvtk9\.\d", "libqt5widgets5", "libhidapi-hidraw0", "libsqlite3-0", "fonts-inter"):
            self.assertRegex(depends, rf"(^|, ){name}\w*( |,|$)")
        self.assertNotIn("-dev", depends)

    def test_the_python_package_runs_from_the_data_of_the_programs_and_needs_neither_vtk_nor_qt(self):
        depends = self.field(self.python, "Depends")
        for name in ("perilymph (=", "python3-numpy", "python3 (<<", "libc6"):
            self.assertIn(name, depends)
        self.assertNotRegex(depends, "vtk|qt")
        env = {**os.environ, "PYTHONPATH": str(self.unpacked / "usr/lib/python3/dist-packages"), "PYTHONDONTWRITEBYTECODE": "1",
               "PERILYMPH_RESOURCES": str(self.unpacked / "usr/share/perilymph")}
        said = run("/usr/bin/python3", "-c", "import perilymph; print(perilymph.read_array('flex28').name, perilymph.__file__)",
                   env=env, cwd="/")
        self.assertEqual((said.returncode, said.stderr), (0, ""))
        self.assertEqual(said.stdout.split(), ["FLEX28", str(self.unpacked / "usr/lib/python3/dist-packages/perilymph/__init__.py")])
        examples = self.unpacked / "usr/share/doc/python3-perilymph/examples"
        self.assertEqual(sorted(file.name for file in examples.iterdir()),
                         sorted(file.name for file in (ROOT / "resources/examples/python").iterdir()
                                if file.suffix in (".py", ".ipynb")))

    def test_the_desktop_entry_and_its_description_are_accepted(self):
        share = self.unpacked / "usr/share"
        entry = run("desktop-file-validate", share / "applications/org.perilymph.perilymph.desktop")
        self.assertEqual((entry.returncode, entry.stdout), (0, ""))
        description = share / "metainfo/org.perilymph.perilymph.metainfo.xml"
        # AppStream 1.0 warns that there is no homepage; the former versions do not know this warning.
        known = ["--override=url-homepage-missing=info"] if "version: 1." in run("appstreamcli", "--version").stdout else []
        described = run("appstreamcli", "validate", "--no-net", *known, description)
        self.assertEqual(described.returncode, 0, described.stdout)
        rules = (self.unpacked / "usr/lib/udev/rules.d/70-perilymph.rules").read_text()
        devices = {f"usb:v{maker}p{product}d*" for maker, product in re.findall(r'KERNELS=="\*:(\w{4}):(\w{4}|\*)', rules)}
        self.assertEqual({each.text for each in ElementTree.parse(description).iter("modalias")}, devices)
        self.assertGreater(len(devices), 3)

    def test_a_file_manager_knows_what_the_program_opens_and_draws_a_recording(self):
        share = self.unpacked / "usr/share"
        known = self.folder / "share"
        (known / "mime/packages").mkdir(parents=True)
        for file in (Path("/usr/share/mime/packages/freedesktop.org.xml"), share / "mime/packages/org.perilymph.perilymph.xml"):
            (known / "mime/packages" / file.name).write_bytes(file.read_bytes())
        self.assertEqual(run("update-mime-database", known / "mime").returncode, 0)
        study = self.folder / "study.toml"
        study.write_text('title = "One"\nscenario = "mean-flex28"\n[cochleae]\nmean = true\n[vary]\nnodes = [30]\ndt_ms = [10.0]\n')
        cli = self.unpacked / "usr/bin/perilymph-cli"
        recording = self.folder / "a.insertion"
        for words in (("study", "run", study, "--out", self.folder / "results"),
                      ("simulate", "--scenario", "mean-flex28", "--nodes", "50", "--record", recording),
                      ("plan", "--patient", "measured", "--arrays", "hybrid-l24", "--samples", "16", "--out", self.folder / "plan")):
            done = run(cli, *words, cwd="/")
            self.assertEqual(done.returncode, 0, done.stderr)
        env = {**os.environ, "XDG_DATA_HOME": str(known), "XDG_DATA_DIRS": str(known)}
        handled = (share / "applications/org.perilymph.perilymph.desktop").read_text()
        patients = share / "perilymph/resources/patients"
        others = {name: self.folder / "others" / name for name in ("plan.json", "settings.toml")}
        (self.folder / "others").mkdir()
        others["plan.json"].write_text('{"program": "another", "plan": "of it"}')
        others["settings.toml"].write_text('label = "another"\nside = "left"\n')
        own = [(recording, "insertion"), (self.folder / "results/study.sqlite", "study"), (self.folder / "plan/plan.json", "plan"),
               *((file, "patient") for file in patients.glob("*.toml"))]
        self.assertGreater(len(own), 5)
        foreign = [(others["plan.json"], "application/json"), (others["settings.toml"], "application/toml"),
                   (share / "perilymph/resources/scenarios/mean-flex28.toml", "application/toml"),
                   (share / "perilymph/plugins/electrodes/med-el/flex28.toml", "application/toml")]
        for file, kind in [(file, f"application/x-perilymph-{kind}") for file, kind in own] + foreign:
            said = run("gio", "info", "-a", "standard::content-type", file, env=env).stdout
            self.assertTrue(said.rstrip().endswith(f": {kind}"), f"{file}: {said}")
        # Each of these is offered to the program, which takes one file.
        self.assertEqual(set(re.search("^MimeType=(.*);$", handled, re.MULTILINE).group(1).split(";")),
                         {f"application/x-perilymph-{kind}" for _, kind in own})
        self.assertIn("\nExec=perilymph %f\n", handled)
        entry = (share / "thumbnailers/perilymph.thumbnailer").read_text()
        words = re.search(r"^Exec=perilymph-cli (.*)$", entry, re.MULTILINE).group(1).split()
        places = {"%i": recording, "%o": self.folder / "thumb", "%s": "128"}
        self.assertEqual(run(cli, *(places.get(each, each) for each in words), cwd="/").returncode, 0)
        self.assertEqual((self.folder / "thumb").read_bytes()[:4], b"\x89PNG")

    def test_unpacked_anywhere_it_runs_from_its_own_data(self):
        env = {key: value for key, value in os.environ.items() if key != "PERILYMPH_RESOURCES"}
        cli = self.unpacked / "usr/bin/perilymph-cli"
        out = self.folder / "out.json"
        done = run(cli, "simulate", "--scenario", "mean-flex28", "--nodes", "50", "--json", out, env=env, cwd="/")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        # A scenario that exists only in the package proves which folder is used.
        own = self.unpacked / "usr/share/perilymph/resources/scenarios"
        (own / "only-here.toml").write_text((own / "mean-flex28.toml").read_text())
        named = run(cli, "simulate", "--scenario", "only-here", "--nodes", "50", "--json", out, env=env, cwd="/")
        self.assertEqual((named.returncode, named.stderr), (0, ""))
        (own / "only-here.toml").unlink()

    def test_every_data_file_of_the_tree_is_in_it(self):
        share = self.unpacked / "usr/share/perilymph"
        for folder in ("plugins/electrodes", "plugins/devices", "resources"):
            for file in (ROOT / folder).rglob("*.toml"):
                self.assertTrue((share / file.relative_to(ROOT)).is_file(), file)

    def test_links_between_the_installed_documents_lead_somewhere(self):
        documents = self.unpacked / "usr/share/doc/perilymph"
        for file in documents.rglob("*.md"):
            for target in re.findall(r"\]\(([^)\s#]+)[^)]*\)", file.read_text()):
                if not re.match(r"[a-z]+:", target):
                    self.assertTrue((file.parent / target).exists(), f"{file.name} links to {target}")

    def test_the_udev_rule_gives_the_device_to_who_sits_there_and_to_nobody_else(self):
        rule = (self.unpacked / "usr/lib/udev/rules.d/70-perilymph.rules").read_text()
        self.assertIn('TAG+="uaccess"', rule)
        self.assertNotIn("MODE", rule)

    def test_the_example_plug_in_builds_outside_the_tree(self):
        example = self.unpacked / "usr/share/doc/perilymph-dev/examples/example"
        build = self.folder / "example"
        made = run("cmake", "-S", example, "-B", build, f"-DCMAKE_PREFIX_PATH={self.unpacked}/usr")
        self.assertEqual(made.returncode, 0, made.stderr)
        built = run("cmake", "--build", build)
        self.assertEqual(built.returncode, 0, built.stdout + built.stderr)
        symbols = run("nm", "-D", "--defined-only", build / "example.so", check=True).stdout
        self.assertIn(" perilymph_device_v1", symbols)


if __name__ == "__main__":
    unittest.main()
