# SPDX-License-Identifier: BSD-3-Clause
"""Common functions of the checks: the project's files, and C++ without comments and string literals."""

import os
import re
from pathlib import Path

CODE = {".h", ".hpp", ".cpp", ".cc", ".c"}
TEXT = CODE | {".py", ".md", ".txt", ".cmake", ".toml", ".json", ".csv", ".qss", ".sh", ""}
SKIPPED = {".git", "build", "__pycache__", ".cache", ".vscode", ".idea"}


def files(root, *folders, suffixes=TEXT):
    """All files with one of the suffixes below the folders of the project (default: everywhere)."""
    found = []
    for folder in folders or ("",):
        for place, names, leaves in os.walk(Path(root) / folder):
            names[:] = sorted(name for name in names if name not in SKIPPED)
            found += [Path(place) / leaf for leaf in sorted(leaves) if leaf not in SKIPPED]
    return [file for file in found if file.suffix in suffixes]


def read(file):
    return Path(file).read_text(encoding="utf-8", errors="replace")


TOKENS = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<mark>[^()\\ ]{0,16})\(.*?\)(?P=mark)"|"(?:\\.|[^"\\\n])*"', re.S)


def without_comments(text, keep_texts=False):
    """C++ with comments and (unless kept) string literals blanked; lines keep their numbers."""
    def blank(match):
        word = match.group(0)
        if keep_texts and not word.startswith("/"):
            return word
        return re.sub(r"[^\n]", " ", word)
    return TOKENS.sub(blank, text)


INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*[<"]([^>"]+)[>"]', re.M)


def includes(file):
    """Pairs of line number and included name."""
    text = without_comments(read(file), keep_texts=True)
    return [(text.count("\n", 0, match.start()) + 1, match.group(1))
            for match in INCLUDE.finditer(text)]


def table(text, name):
    """Rows, as lists of cells, of the Markdown table between <!-- name --> and <!-- /name -->."""
    match = re.search(rf"<!-- {name} -->(.*?)<!-- /{name} -->", text, re.S)
    if not match:
        return None
    rows = [[cell.strip() for cell in line.strip().strip("|").split("|")]
            for line in match.group(1).splitlines() if line.strip().startswith("|")]
    return rows[2:]


def quoted(cell):
    """The words in backticks of a table cell."""
    return re.findall(r"`([^`]+)`", cell)
