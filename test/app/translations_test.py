#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Translations of the window: complete, and up to date with the sources."""

import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
FILES = sorted((ROOT / "resources/translations").glob("*.ts"))
LUPDATE = next(filter(None, map(shutil.which, ("lupdate", "lupdate-qt5", "lupdate6"))), None)


def messages(file):
    for context in ElementTree.parse(file).getroot().iter("context"):
        for message in context.iter("message"):
            translation = message.find("translation")
            yield context.find("name").text, message.find("source").text, translation.get("type"), [
                form.text or "" for form in translation.iter("numerusform")] or [translation.text or ""]


def places(text):
    return sorted(set(re.findall(r"%(?:L?\d+|n)", text)))


class Translations(unittest.TestCase):
    def test_german_is_there(self):
        self.assertIn("perilymph_de.ts", [file.name for file in FILES])

    def test_nothing_is_unfinished(self):
        for file in FILES:
            unfinished = [f"{context}: {source}" for context, source, kind, forms in messages(file)
                          if kind == "unfinished" or not all(form.strip() for form in forms)]
            self.assertEqual(unfinished, [], f"{len(unfinished)} unfinished in {file.name}")

    def test_values_stand_in_every_translation(self):
        for file in FILES:
            for context, source, _, forms in messages(file):
                for form in forms:
                    # "one" may be a word
                    self.assertLessEqual(set(places(form)), set(places(source)), f"{file.name}, {context}")
                    self.assertLessEqual(set(places(source)) - {"%n"}, set(places(form)), f"{file.name}, {context}")

    @unittest.skipUnless(LUPDATE, "lupdate is not installed (Debian: qttools5-dev-tools or qt6-l10n-tools).")
    def test_every_word_of_the_sources_is_in_the_files(self):
        for file in FILES:
            with tempfile.TemporaryDirectory() as folder:
                copy, phrases = Path(folder) / file.name, Path(folder) / "phrases.cpp"
                shutil.copy(file, copy)
                subprocess.run([sys.executable, ROOT / "resources/translations/phrases.py", phrases], check=True,
                               timeout=120)
                subprocess.run([LUPDATE, "-silent", "-no-obsolete", "-locations", "none", "-I", ROOT / "app",
                                ROOT / "app/gui", phrases, "-ts", copy], check=True, timeout=120, capture_output=True)
                fresh = {(context, source) for context, source, *_ in messages(copy)}
            known = {(context, source) for context, source, *_ in messages(file)}
            self.assertEqual(sorted(fresh - known), [], f"not in {file.name}: ninja translations brings it up to date")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
