#!/usr/bin/env python3
"""Every command that a document shows is one that works, as it stands there."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(sys.argv.pop(1)).resolve()
WITH_DISPLAY = ROOT / "test/support/with-display"
# Statistics of 200 insertions take a minute; that the call works shows in three.
FEWER = [(re.compile(r"--runs \d+"), "--runs 3")]


def documents():
    """README and guide; a manual page's examples are its indented lines."""
    for file in (ROOT / "README.md", *sorted((ROOT / "resources/guide").glob("*.md"))):
        yield file, file.read_text()
    page = ROOT / "packaging/man/perilymph-cli.1"
    examples = page.read_text().replace("\\-", "-").split(".nf\n")[1].split(".fi\n")[0]
    yield page, "".join(f"    {line}\n" for line in examples.splitlines())


def commands(text):
    return [match.strip() for match in re.findall(r"^    (perilymph-cli [^\n]*)$", text, re.MULTILINE)]


GUIDE = ROOT / "resources/guide"


class PicturesOfTheGuide(unittest.TestCase):
    def test_every_link_leads_to_a_file_and_every_picture_is_shown(self):
        shown = set()
        for page in sorted(GUIDE.glob("*.md")):
            for target in re.findall(r"\]\(([^)#]+)\)", page.read_text()):
                if "://" in target:
                    continue
                self.assertTrue((GUIDE / target).exists(), f"{page.name} points to {target}, which is not there.")
                shown.add((GUIDE / target).resolve())
        pictures = {file.resolve() for file in (GUIDE / "pictures").glob("*.png")}
        self.assertTrue(pictures)
        self.assertEqual(pictures - shown, set(), "No page shows these pictures.")

    def test_they_are_small_enough_to_be_carried_along(self):
        files = sorted((GUIDE / "pictures").glob("*.png"))
        self.assertLess(sum(file.stat().st_size for file in files), 2_500_000)
        for file in files:
            width, height = (int.from_bytes(file.read_bytes()[at:at + 4], "big") for at in (16, 20))
            self.assertLessEqual((width, height), (1280, 800), file.name)

    def test_every_step_of_a_walk_has_its_picture(self):
        for walk in ("surgeon", "clinician", "visitor"):
            text = (GUIDE / f"{walk}.md").read_text()
            steps = re.findall(r"^## (\d+)\. ", text, re.MULTILINE)
            self.assertEqual(steps, [str(i + 1) for i in range(len(steps))])
            for step in steps:
                self.assertIn(f"(pictures/{walk}-{step}.png)", text)


class CommandsOfTheDocuments(unittest.TestCase):
    def test_each_works_in_its_document_s_order(self):
        seen = 0
        for file, text in documents():
            # One folder a document, for its commands build on each other.
            with tempfile.TemporaryDirectory() as folder:
                if file.suffix == ".1":
                    self.run_line("perilymph-cli simulate --scenario contour-published --record session.insertion", folder)
                for line in commands(text):
                    for pattern, fewer in FEWER:
                        line = pattern.sub(fewer, line)
                    with self.subTest(document=file.name, command=line):
                        self.run_line(line, folder)
                        seen += 1
        self.assertGreater(seen, 8)

    def run_line(self, line, folder):
        env = {**os.environ, "PATH": f"{PROGRAMS}:{os.environ['PATH']}"}
        words = [str(WITH_DISPLAY), *line.split()] if " render " in line else line.split()
        done = subprocess.run(words, cwd=folder, env=env, capture_output=True, text=True, timeout=240)
        self.assertEqual(done.returncode, 0, f"{line}\n{done.stdout[-500:]}{done.stderr[-500:]}")


if __name__ == "__main__":
    unittest.main()
