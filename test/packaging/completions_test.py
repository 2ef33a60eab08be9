#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Bash completion and manual pages match the options of the programs."""

import os
import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAMS = Path(sys.argv.pop(1)).resolve()


def run(*words):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=60, check=True).stdout


def options_of(*words):
    return set(re.findall(r"^ {1,12}(?:-h, *)?(--[a-z][a-z-]*)", run(*words, "--help"), re.MULTILINE))


def commands_below(*command):
    listed = re.split("subcommands:", run(PROGRAMS / "perilymph-cli", *command, "--help"), flags=re.IGNORECASE)
    return re.findall(r"^  ([a-z]+) ", listed[1], re.MULTILINE) if len(listed) > 1 else []


def commands():
    """Every command that does something, such as ("anatomy",) and ("ct", "measure")."""
    return [(first, second) if second else (first,)
            for first in commands_below() for second in commands_below(first) or [None]]


def manual(page):
    return (ROOT / "packaging/man" / page).read_text().replace("\\-", "-")


class ManualPages(unittest.TestCase):
    def check_section(self, text, options, name):
        written = set(re.findall(r"^\.(?:BI?|BR)\s.*?(--[a-z][a-z-]*)", text, re.MULTILINE))
        self.assertEqual(written - {"--help", "--version"}, options - {"--help", "--version"}, name)

    def test_every_option_of_every_command_is_described_and_no_other(self):
        sections = re.split(r'^\.SS "perilymph-cli (\w+(?: \w+)?)"$', manual("perilymph-cli.1"), flags=re.MULTILINE)
        described = dict(zip(sections[1::2], sections[2::2]))
        self.assertEqual(sorted(described), sorted(" ".join(command) for command in commands()))
        for command, text in described.items():
            text = text.split(".SH ")[0]
            self.check_section(text, options_of(PROGRAMS / "perilymph-cli", *command.split()), command)

    @unittest.skipUnless((PROGRAMS / "perilymph").exists(), "this build has no window")
    def test_every_option_of_the_window_is_described_and_no_other(self):
        text = manual("perilymph.1").split(".SH OPTIONS")[1].split(".SH ")[0]
        self.check_section(text, options_of(PROGRAMS / "perilymph"), "perilymph")

    def test_man_reads_them_without_a_warning(self):
        for page in ("perilymph.1", "perilymph-cli.1"):
            read = subprocess.run(["man", "--warnings", "-l", str(ROOT / "packaging/man" / page)], capture_output=True,
                                  text=True, timeout=60, env={**os.environ, "LC_ALL": "C.UTF-8", "MANPAGER": "cat"})
            self.assertEqual((read.returncode, read.stderr), (0, ""))


class Completions(unittest.TestCase):
    def complete(self, line):
        """Completions of the last word of the line."""
        words = line.split(" ")
        script = f"""
            compopt() {{ :; }}
            source {ROOT}/packaging/completions/perilymph-cli
            COMP_WORDS=({" ".join(f"'{word}'" for word in words)}); COMP_CWORD={len(words) - 1}
            _perilymph "$(command -v {words[0]})" '{words[-1]}' '{words[-2]}'
            printf '%s\\n' "${{COMPREPLY[@]}}" """
        env = {**os.environ, "PATH": f"{PROGRAMS}:{os.environ['PATH']}", "PERILYMPH_RESOURCES": str(ROOT)}
        done = subprocess.run(["bash", "-c", script], capture_output=True, text=True, timeout=60, cwd="/", env=env)
        self.assertEqual(done.stderr, "")
        return set(done.stdout.split())

    def test_commands_come_first(self):
        self.assertEqual(self.complete("perilymph-cli "), set(commands_below()))
        self.assertEqual(self.complete("perilymph-cli ct "), {"contacts", "export", "info", "markups", "measure"})
        self.assertEqual(self.complete("perilymph-cli ct me"), {"measure"})

    def test_options_are_those_of_the_command(self):
        for command in commands():
            self.assertEqual(self.complete(f"perilymph-cli {' '.join(command)} --"),
                             options_of(PROGRAMS / "perilymph-cli", *command))

    def test_shipped_names_stand_beside_files(self):
        self.assertIn("contour-published", self.complete("perilymph-cli simulate --scenario con"))
        self.assertIn("flex28", self.complete("perilymph-cli simulate --array fle"))
        self.assertIn("etc", self.complete("perilymph-cli simulate --patient et"))
        self.assertIn("etc", self.complete("perilymph-cli ct measure et"))
        self.assertEqual(self.complete("perilymph-cli ct measure etc --side "), {"left", "right", "both"})


if __name__ == "__main__":
    unittest.main()
