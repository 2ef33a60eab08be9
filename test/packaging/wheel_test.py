#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The wheel of the Python package: installed in a virtual environment without a network, complete by itself, and removed."""

import os
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

BUILD = Path(sys.argv.pop(1)).resolve()
ROOT = Path(__file__).resolve().parents[2]
PROGRAM = """
import importlib.metadata, pathlib, sys
import perilymph

own = pathlib.Path(sys.prefix)
assert own in pathlib.Path(perilymph.__file__).parents, perilymph.__file__
assert importlib.metadata.version("perilymph").replace(".dev0", "-dev") == perilymph.__version__
scenario = perilymph.read_scenario("surgery-flex28", {"nodes": 30, "dt_ms": 10, "stop_travel_mm": 3})
for file in scenario.files:
    assert own in pathlib.Path(file).parents, file
for name in perilymph.arrays():
    perilymph.read_array(name)
for name in perilymph.scenarios():
    perilymph.read_scenario(name)
for name in perilymph.patients():
    perilymph.read_patient(name)
print(perilymph.simulate(scenario).end)
patient = perilymph.Patient(a_mm=9.2, b_mm=6.9)
print(len(perilymph.plan(patient, ["flex24"], samples=1, all_samples=True).insertions()["draw"]))
print(len(perilymph.study(scenario, "study", cochleae=1)))
try:
    perilymph.ct.measure("ct")
except perilymph.Error as error:
    print(error)
"""


class Wheel(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.place = Path(place.name)
        # As a user who has neither the package nor the programs.
        self.words = {"HOME": str(self.place), "PATH": "/nowhere", "PERILYMPH_FEW_DRAWS": "1", "PIP_CONFIG_FILE": os.devnull,
                      "PIP_DISABLE_PIP_VERSION_CHECK": "1"}

    def run_in(self, *words):
        done = subprocess.run([str(word) for word in words], cwd=self.place, env=self.words, capture_output=True, text=True, timeout=240)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def pack(self, name):
        self.run_in(sys.executable, ROOT / "packaging/pack_wheel.py", BUILD, self.place / name)
        wheel, = (self.place / name).glob("*.whl")
        return wheel

    def test_it_works_by_itself_and_is_removed_without_a_trace(self):
        wheel = self.pack("one")
        self.run_in("/usr/bin/python3", "-m", "venv", "--system-site-packages", "env")
        python = self.place / "env/bin/python"
        before = {file for file in (self.place / "env").rglob("*") if "__pycache__" not in file.parts}
        self.run_in(python, "-m", "pip", "install", "--no-index", wheel)
        self.assertIn("perilymph/py.typed", self.run_in(python, "-m", "pip", "show", "--files", "perilymph"))
        said = self.run_in(python, "-I", "-c", PROGRAM).splitlines()
        self.assertEqual(said[:3], ["finished", "1", "1"])
        self.assertIn("perilymph-cli was not found", said[3])
        self.run_in(python, "-m", "pip", "uninstall", "--yes", "perilymph")
        after = {file for file in (self.place / "env").rglob("*") if "__pycache__" not in file.parts}
        self.assertEqual(after, before)

    def test_it_has_the_same_bytes_every_time_and_what_editors_need(self):
        one, two = self.pack("one"), self.pack("two")
        self.assertEqual(one.read_bytes(), two.read_bytes())
        with zipfile.ZipFile(one) as archive:
            names = set(archive.namelist())
        for name in ("py.typed", "__init__.pyi", "outcome.py", "data/resources/scenarios/surgery-flex28.toml"):
            self.assertIn(f"perilymph/{name}", names)
        self.assertFalse([name for name in names if name.endswith((".png", ".md", ".ts", ".pyc"))])


if __name__ == "__main__":
    unittest.main()
