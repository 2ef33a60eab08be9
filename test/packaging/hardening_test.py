#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Programs built with the flags of the presets that people get have the protections of Debian's packages."""

import json
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
# Copies text of unknown length: what a stack protector and fortified functions guard.
PROGRAM = """
#include <cstdio>
#include <cstring>
int main(int count, char** texts)
{
  char copy[16];
  std::strcpy(copy, texts[count - 1]);
  std::printf("%s\\n", copy);
}
"""


def variables(name):
    """The cache variables of a preset with those that it inherits."""
    presets = {each["name"]: each
               for each in json.loads((ROOT / "CMakePresets.json").read_text())["configurePresets"]}
    preset = presets[name]
    inherited = variables(preset["inherits"]) if "inherits" in preset else {}
    return {**inherited, **preset.get("cacheVariables", {})}


def elf_of(name, folder):
    """What readelf says of a program and of a shared library that are built as the preset states."""
    flags = variables(name)
    compiler = ["c++", *flags.get("CMAKE_CXX_FLAGS", "").replace("${sourceDir}", str(folder)).split(),
                *flags["CMAKE_CXX_FLAGS_RELEASE"].split()]
    source = folder / "program.cpp"
    source.write_text(PROGRAM)
    said = {}
    for kind, more in (("EXE", []), ("MODULE", ["-shared", "-fPIC"]), ("SHARED", ["-shared", "-fPIC"])):
        program = folder / kind.lower()
        link = flags.get(f"CMAKE_{kind}_LINKER_FLAGS", "").split()
        subprocess.run([*compiler, *more, str(source), *link, "-o", str(program)], check=True)
        said[kind] = subprocess.run(["readelf", "-W", "-d", "-l", "-h", "--dyn-syms", str(program)], check=True,
                                    capture_output=True, text=True).stdout
    return said


class Hardening(unittest.TestCase):
    def test_presets_that_people_get(self):
        for name in ("release", "wheel"):
            with self.subTest(preset=name), tempfile.TemporaryDirectory() as folder:
                for kind, text in elf_of(name, Path(folder)).items():
                    for expected in ("GNU_RELRO", "BIND_NOW", "__stack_chk_fail", "__strcpy_chk", "DYN ("):
                        self.assertIn(expected, text, f"{name} {kind}")
                    stack = next(line for line in text.splitlines() if "GNU_STACK" in line)
                    self.assertNotIn("RWE", stack, f"{name} {kind}")
                    self.assertNotRegex(text, r"\((RPATH|RUNPATH)\)")


if __name__ == "__main__":
    unittest.main()
