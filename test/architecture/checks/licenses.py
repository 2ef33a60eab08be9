# SPDX-License-Identifier: BSD-3-Clause
"""Every C, C++, CMake, Python and shell source states the license of LICENSE in its first line."""

import re
from pathlib import Path

from checks import sources

# First line of LICENSE, and the license's SPDX identifier.
IDENTIFIERS = {"BSD 3-Clause License": "BSD-3-Clause"}
SHEBANG = re.compile(r"#!.*\b(python3?|bash|sh)\b")
SHELL = re.compile(r"^# shellcheck shell=", re.M)
SUFFIXES = sources.CODE | {".py", ".cmake", ".sh", ".txt", ".in", ""}


def comment_sign(file, text):
    """Comment sign of a source; None for files that are no source."""
    if file.suffix in sources.CODE:
        return "//"
    if file.name == "CMakeLists.txt" or file.name.endswith((".cmake", ".cmake.in", ".py", ".sh")):
        return "#"
    if SHEBANG.match(text) or SHELL.search(text[:300]):
        return "#"
    return None


def check(root):
    root = Path(root)
    if not (root / "LICENSE").is_file():
        return ["LICENSE is missing."]
    name = sources.read(root / "LICENSE").split("\n", 1)[0].strip()
    if name not in IDENTIFIERS:
        return [f"LICENSE begins with '{name}', whose SPDX identifier is unknown; add it to "
                f"test/architecture/checks/licenses.py."]
    errors = []
    for file in sources.files(root, suffixes=SUFFIXES):
        text = sources.read(file)
        sign = comment_sign(file, text)
        if sign is None:
            continue
        lines = text.splitlines()
        first = 1 if text.startswith("#!") else 0
        wanted = f"{sign} SPDX-License-Identifier: {IDENTIFIERS[name]}"
        if len(lines) <= first or lines[first] != wanted:
            errors.append(f"{file.relative_to(root).as_posix()}:{first + 1}: must be the line '{wanted}'.")
    return errors
