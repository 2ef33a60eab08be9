#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Phrases that the window translates although no source of it holds them, as C++ that lupdate reads: those of the
engine, written as Phrase{"..."}, Sentence{"..."} or Error{"..."}, and titles and sources of values in
shipped files.

    phrases.py <file to write>
"""

import re
import sys
import tomllib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LITERAL = r'(?:"(?:[^"\\\n]|\\.)*"\s*)+'
MARKED = re.compile(r"\b(?:Phrase|Sentence|Error)(?:\s+\w+)?[{(]\s*(" + LITERAL + r")(?=[,})])")
# where the sources of values are sentences; others are names of publications
SOURCED = ("plugins/electrodes/", "resources/planning/", "resources/clinical/hand.toml", "resources/clinical/wires.toml",
           "resources/reference/in-vitro.toml", "resources/reference/in-vivo.toml")
LABELED = ("resources/reference/",)  # elsewhere a label is a name
PAIR = re.compile(r"\bStatedTwice\s+\w+[^;]*;")  # what a file states twice: its words, without names of fields
NAME = re.compile(r"\w*[A-Z_]\w*( \([0-9A-F]{4},[0-9A-F]{4}\))?")


def joined(literals):
    """One string of adjacent literals."""
    return re.sub(r'\\(["\\])', r"\1", "".join(re.findall(r'"((?:[^"\\\n]|\\.)*)"', literals)))


def of_sources():
    gui = (ROOT / "app/gui").rglob("*.[ch]*")
    # what the program says before there is a window stays English
    files = [*(ROOT / "modules").rglob("*.[ch]*"), *(file for file in gui if file.parent.name != "program")]
    for file in sorted(files):
        text = file.read_text(encoding="utf-8")
        for found in MARKED.finditer(text):
            yield joined(found.group(1))
        for pair in PAIR.finditer(text):
            words = map(joined, re.findall(LITERAL, pair.group()))
            yield from (word for word in words if not NAME.fullmatch(word))


def texts(value, keys, key=""):
    if isinstance(value, dict):
        for name, part in value.items():
            yield from texts(part, keys, name)
    elif isinstance(value, list):
        for part in value:
            yield from texts(part, keys, key)
    elif key in keys and isinstance(value, str):
        yield value


def of_shipped_files():
    for folder in ("resources", "plugins"):
        for file in sorted((ROOT / folder).rglob("*.toml")):
            path = file.relative_to(ROOT).as_posix()
            keys = ["title", *(["source"] * path.startswith(SOURCED)), *(["label"] * path.startswith(LABELED))]
            yield from texts(tomllib.loads(file.read_text(encoding="utf-8")), keys)


def phrases():
    """All of them, each once; without those that hold nothing but places and signs."""
    every = dict.fromkeys([*of_sources(), *of_shipped_files()])
    return [each for each in every if re.search("[A-Za-z]", re.sub(r"%\d", "", each))]


def main():
    lines = [f'QT_TRANSLATE_NOOP("Data", "{each.translate(str.maketrans({chr(92): chr(92) * 2, chr(34): chr(92) + chr(34)}))}")'
             for each in phrases()]
    Path(sys.argv[1]).write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
