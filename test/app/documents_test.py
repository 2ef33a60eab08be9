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
