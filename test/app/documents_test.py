#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every command shown in a document works as written: documents_test.py PROGRAMS DOCUMENT; without DOCUMENT: what
documents point to is there."""

import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(sys.argv.pop(1)).resolve()
DOCUMENT = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else None
WITH_DISPLAY = ROOT / "test/support/with-display"
# Statistics of 200 insertions take a minute; three insertions suffice to test the call, the average cochlea
# without virtual patients, and the smallest number of repetitions.
FEWER = [(re.compile(r"--runs \d+"), "--runs 3"),
         (re.compile(r"--prior-predictive"), "--prior-predictive --draws 20"),
         (re.compile(r"--all --seed 1 2 3"), "--all --patients 0 --seed 1"),
         (re.compile(r"^(perilymph-cli plan .*?) --samples \d+"), r"\1"),
         (re.compile(r"^(perilymph-cli plan .*)$"), r"\1 --samples 2")]


def documents():
    """README and guide; a manual page's examples are its indented lines."""
    for file in (ROOT / "README.md", *sorted((ROOT / "resources/guide").glob("*.md"))):
        yield file, file.read_text()
    page = ROOT / "packaging/man/perilymph-cli.1"
    examples = page.read_text().replace("\\-", "-").split(".nf\n")[1].split(".fi\n")[0]
    yield page, "".join(f"    {line}\n" for line in examples.splitlines())


# Paths in the package, and in the tree.
PLACES = [("/usr/share/doc/perilymph-dev/examples/template", ROOT / "packaging/sdk/template"),
          ("/usr/share/doc/perilymph-dev/examples", ROOT / "plugins/devices"), ("/usr/share/perilymph", ROOT)]
# Commands of a tutorial, run as written.
RUN = ("perilymph-cli ", "perilymph ", "cp ", "rm ", "sed ", "cmake -S ", "cmake --build build", "cmake --install build",
       "build/my-handle ", "export ")
# Commands that take long or change the machine: only checked for existing files.
CHECKED = ("cmake --preset ", "cmake --build --preset ", "ctest --preset ", "test/", "packaging/", "sudo apt install ")


def commands(text):
    return [match.strip() for match in re.findall(r"^    ((?:%s)[^\n]*)$" % "|".join(RUN + CHECKED), text, re.MULTILINE)]


def presets():
    return {preset["name"] for kind in ("configurePresets", "testPresets")
            for preset in json.loads((ROOT / "CMakePresets.json").read_text())[kind]}


def run_line(case, line, folder, sdk, exported):
    if line.startswith("export "):
        name, value = line.removeprefix("export ").split("=")
        exported[name] = value.replace("$PWD", folder)
        return
    line = line.replace("~/", f"{folder}/")
    for pattern, fewer in FEWER:
        line = pattern.sub(fewer, line)
    for installed, place in PLACES:
        line = line.replace(installed, str(place))
    words = shlex.split(line)
    if words[0] == "perilymph":  # until its first picture
        words += ["--screenshot", "window.png", "--after", "1"]
    if words[0] == "perilymph" or " render " in line:
        words.insert(0, str(WITH_DISPLAY))
    env = {**os.environ, "PATH": f"{PROGRAMS}:{os.environ['PATH']}", "CMAKE_PREFIX_PATH": sdk,
           "PERILYMPH_FEW_DRAWS": "1", "HOME": folder, **exported}
    for variable in ("XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"):
        env.pop(variable, None)
    done = subprocess.run(words, cwd=folder, env=env, capture_output=True, text=True, timeout=240)
    case.assertEqual(done.returncode, 0, f"{line}\n{done.stdout[-500:]}{done.stderr[-500:]}")


GUIDE = ROOT / "resources/guide"


class PicturesOfTheGuide(unittest.TestCase):
    def test_every_link_leads_to_a_file_and_every_picture_is_shown(self):
        shown = set()
        for page in (*sorted(GUIDE.glob("*.md")), *sorted((GUIDE / "de").glob("*.md"))):
            for target in re.findall(r"\]\(([^)#]+)\)", page.read_text()):
                if "://" in target:
                    continue
                there = page.parent / target
                self.assertTrue(there.exists(), f"{page} points to {target}, which is not there.")
                shown.add(there.resolve())
        pictures = {file.resolve() for file in (GUIDE / "pictures").glob("*.png")}
        self.assertTrue(pictures)
        self.assertEqual(pictures - shown, set(), "No page shows these pictures.")

    def test_they_are_small_enough_to_be_carried_along(self):
        files = sorted((GUIDE / "pictures").glob("*.png"))
        self.assertLess(sum(file.stat().st_size for file in files), 4_000_000)
        for file in files:
            width, height = (int.from_bytes(file.read_bytes()[at:at + 4], "big") for at in (16, 20))
            self.assertLessEqual((width, height), (1280, 800), file.name)

    def test_every_step_of_a_walk_has_its_picture(self):
        for walk in ("surgeon", "clinician", "visitor", "studies", "outcome"):
            text = (GUIDE / f"{walk}.md").read_text()
            steps = re.findall(r"^## (\d+)\. ", text, re.MULTILINE)
            self.assertEqual(steps, [str(i + 1) for i in range(len(steps))])
            for step in steps:
                self.assertIn(f"(pictures/{walk}-{step}.png)", text)

    def test_the_german_guide_has_the_pages_steps_tables_and_commands_of_the_english_one(self):
        for name in ("README", "surgeon", "ct", "clinician", "outcome", "visitor", "booth", "questions",
                     "glossary"):
            english, german = ((folder / f"{name}.md").read_text() for folder in (GUIDE, GUIDE / "de"))
            for pattern in (r"^## \d+\.", r"^\|", r"!\[[^]]*\]\((?:\.\./)?(pictures/[^)]*)\)", r"^\*\*\d+\."):
                with self.subTest(page=name, pattern=pattern):
                    self.assertEqual(re.findall(pattern, german, re.MULTILINE), re.findall(pattern, english, re.MULTILINE))


class WalksOfTheContributor(unittest.TestCase):
    """Each says what to read, create and edit, with files and names that exist."""

    def walks(self):
        text = (GUIDE / "contributing.md").read_text()
        part = re.search(r"^## Five additions.*?(?=^## )", text, re.MULTILINE | re.DOTALL).group(0)
        return {walk.splitlines()[0]: re.findall(r"^- (Read|Create|Edit) (.*)$", walk, re.MULTILINE)
                for walk in part.split("\n### ")[1:]}

    def test_there_are_five(self):
        self.assertEqual(list(self.walks()), ["A friction law", "An anatomy source", "A chart", "A command",
                                              "A page of the window"])

    def test_none_takes_more_than_four_files_to_read_and_seven_to_edit(self):
        for walk, steps in self.walks().items():
            with self.subTest(walk=walk):
                verbs = [verb for verb, _ in steps]
                self.assertTrue(1 <= verbs.count("Read") <= 4, verbs)
                self.assertTrue(1 <= verbs.count("Edit") <= 7, verbs)

    def test_their_files_and_the_names_in_them_exist(self):
        for walk, steps in self.walks().items():
            for verb, step in steps:
                with self.subTest(walk=walk, step=step):
                    names = re.findall(r"`([^`]+)`", step)
                    if verb == "Create":
                        for folder in names:
                            self.assertTrue((ROOT / folder).is_dir(), folder)
                        continue
                    self.assertTrue((ROOT / names[0]).is_file(), names[0])
                    content = (ROOT / names[0]).read_text()
                    for name in names[1:]:
                        self.assertIn(name, content)


@unittest.skipIf(DOCUMENT is None, "No document is named.")
class CommandsOfADocument(unittest.TestCase):
    def test_work_in_their_order(self):
        text = dict(documents())[DOCUMENT]
        # One folder, because the commands depend on each other.
        with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as sdk:
            if "cmake -S" in text:  # the package perilymph-dev, as this build would install it
                subprocess.run(["cmake", "--install", PROGRAMS.parent, "--component", "sdk", "--prefix", sdk],
                               check=True, capture_output=True)
            if "--ct ct" in text:  # a patient's CT, as the reader has one
                subprocess.run([PROGRAMS / "perilymph-ct-phantom", "1", Path(folder) / "ct", "clinical"], check=True)
            exported = {}
            if DOCUMENT.suffix == ".1":
                run_line(self, "perilymph-cli simulate --scenario contour-published --record session.insertion", folder, sdk,
                         exported)
            for line in commands(text):
                if not line.startswith(CHECKED):
                    with self.subTest(command=line):
                        run_line(self, line, folder, sdk, exported)


class CommandsOfTheDocuments(unittest.TestCase):
    def test_that_are_not_run_name_what_is_there(self):
        lines = [line for _, text in documents() for line in commands(text)]
        self.assertGreater(len(lines), 20)
        for line in lines:
            if line.startswith(CHECKED):
                with self.subTest(command=line):
                    self.check_line(line)

    def test_the_map_lists_the_commands_that_the_program_has(self):
        listed = re.search(r"^  cli +the command line: ([\w, ]+); no Qt$", (ROOT / "README.md").read_text(), re.MULTILINE)
        help_text = subprocess.run([PROGRAMS / "perilymph-cli", "--help"], capture_output=True, text=True, check=True).stdout
        has = re.findall(r"^  ([a-z]+) {2,}", re.split("subcommands:", help_text, flags=re.IGNORECASE)[1], re.MULTILINE)
        self.assertGreater(len(has), 8)
        self.assertEqual(listed.group(1).split(", "), has)

    def test_every_indented_command_of_a_guide_is_known_here(self):
        for file in sorted((ROOT / "resources/guide").glob("*.md")):
            text = file.read_text()
            indented = [line.strip() for line in re.findall(r"^    (?! )([a-z./-]+ [^\n]*)$", text, re.MULTILINE)]
            commandlike = [line for line in indented if re.match(r"(perilymph|cmake|ctest|ninja|cp|rm|sed|export|sudo|build/|test/|packaging/)", line)]
            self.assertEqual(sorted(commandlike), sorted(commands(text)), file.name)

    def test_scripts_that_tables_and_sentences_name_are_there(self):
        for file, text in documents():
            for script in re.findall(r"`((?:test|packaging)/[^\s`]+)[^`]*`", text):
                with self.subTest(document=file.name, script=script):
                    self.assertTrue((ROOT / script).exists())

    def check_line(self, line):
        words = line.split()
        if "--preset" in words:
            self.assertIn(words[words.index("--preset") + 1], presets())
        elif words[0] != "sudo":
            self.assertTrue(os.access(ROOT / words[0], os.X_OK), words[0])
        if words[0] == "ctest" and "-L" in words:
            self.assertTrue((ROOT / "test" / words[words.index("-L") + 1]).is_dir(), line)

if __name__ == "__main__":
    unittest.main(defaultTest="CommandsOfADocument" if DOCUMENT else None)
