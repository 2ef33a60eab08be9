# SPDX-License-Identifier: BSD-3-Clause
"""Habits of the tests: names of files, an expectation in each, no wait without a limit."""

import re
from pathlib import Path

from checks import sources

CASE = re.compile(r"^(?:TYPED_)?TEST(?:_F|_P)?\((\w+),\s*(\w+)\)\s*\{", re.M)
# A function that expects says so in its name.
EXPECTATION = re.compile(r"\b(?:EXPECT|ASSERT)_\w+|\bFAIL\(|\b(?:expect|check)\w*\(")
# A loop that yields, or looks again, until another thread has done something may wait for ever.
WAIT = re.compile(r"\bthis_thread::yield\b|\bsched_yield\b"
                  r"|\bwhile \([^;{}]*\)\s*\{?\s*if \(![^;{}]*\)\s*continue;"
                  r"|\bwhile \([^;{}]*\)\s*\{?\s*\w+(?:->|\.)refresh\(\);")
WAITING = "test/support/include/perilymph/test/waitUntil.h"


def body(text, start):
    """What stands between the braces, the first of which is at `start`."""
    depth = 0
    for at in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0:
            return text[start + 1:at]
    return text[start + 1:]


def check(root):
    root = Path(root)
    errors = []
    for file in sources.files(root, "test", suffixes=sources.CODE):
        name = file.relative_to(root).as_posix()
        text = sources.without_comments(sources.read(file))
        cases = list(CASE.finditer(text))
        if cases and not re.fullmatch(r"(?:[A-Z]\w*)?Test\.cpp", file.name):
            errors.append(f"{name} has tests; its name must end in Test.cpp and begin with a capital letter.")
        for case in cases:
            if not EXPECTATION.search(body(text, case.end() - 1)):
                errors.append(f"{name}: {case.group(1)}.{case.group(2)} expects nothing.")
        if name != WAITING:
            for match in WAIT.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                errors.append(f"{name}:{line}: a wait without a limit: use waitUntil() of test/support.")
    return errors
