# SPDX-License-Identifier: BSD-3-Clause
"""Words that are not allowed in the project, or only in some places."""

import re
from pathlib import Path

from checks import sources

# Split, so that the check does not find itself.
EVERYWHERE = {
    r"/wo" r"rk/|/ro" r"ot/": "a path of one machine",
    r"-ffast-" r"math|-Of" r"ast\b": "a flag that changes results from machine to machine",
    r"-march=nat" r"ive": "a flag that makes results depend on the building machine",
    r"\bTO" r"DO\b|\bFIX" r"ME\b|\bXX" r"X\b": "unfinished work: finish it or write it down for its users",
}
DOCUMENTS = {r"(?<![\w.])/t" r"mp/|/ho" r"me/\w+/": "a path of one machine"}

MEMORY_ORDER = re.compile(r"\bmemory_order\w*")

NULL_WORD = re.compile(r"\bNULL\b")

# The C library's transcendental functions give different bits on different machines, and Eigen's
# rotations call them.
ENGINE = ("anatomy", "ct", "electrode", "device", "mechanics", "haptics")
INEXACT = re.compile(
    r"\bstd::(?:a?(?:sin|cos|tan)h?|atan2|exp2?|expm1|log(?:2|10|1p)?|pow|hypot|cbrt|erfc?|"
    r"[lt]gamma|fma)\s*\(|\bAngleAxis|\bEulerAngles|\bslerp\b|\.eulerAngles\b")

# A test that sleeps to let something happen fails on a busy machine.
SLEEP = re.compile(r"\bsleep_(?:for|until)\b|\bu?sleep\s*\(|\bnanosleep\b|\bqWait\b|\bqSleep\b")


# All output of the command line is printed in one place.
PRINTING = re.compile(r"\bstd::(?:v?f?printf|f?puts|f?putc|putchar|fwrite|cout|cerr|clog)\b")
TERMINAL = ("app/cli/Terminal.cpp",)


def search(root, found, pattern, reason, errors):
    for file, text in found:
        for match in re.finditer(pattern, text):
            line = text.count("\n", 0, match.start()) + 1
            errors.append(f"{file.relative_to(root)}:{line}: '{match.group(0)}' is {reason}.")


def code(root, *folders):
    return [(file, sources.without_comments(sources.read(file)))
            for file in sources.files(root, *folders, suffixes=sources.CODE)]


def check(root):
    root = Path(root)
    errors = []
    everything = [(file, sources.read(file)) for file in sources.files(root)]
    for pattern, reason in EVERYWHERE.items():
        search(root, everything, pattern, reason, errors)
    pages = [(file, text) for file, text in everything if file.suffix == ".md"]
    for pattern, reason in DOCUMENTS.items():
        search(root, pages, pattern, reason, errors)

    others = [(file, text) for file, text in code(root, "modules", "app", "plugins")
              if not file.relative_to(root).as_posix().startswith("modules/realtime/")]
    search(root, others, MEMORY_ORDER,
           "named outside modules/realtime: use its channels", errors)
    search(root, code(root, "modules", "app", "plugins", "test"), NULL_WORD, "C: write nullptr", errors)
    # benchmarks measure by the clock
    tests = [(file, text) for file, text in code(root, "test")
             if not file.relative_to(root).as_posix().startswith("test/bench/")]
    search(root, tests, SLEEP, "waiting by the clock: wait for what should happen",
           errors)

    printing = [(file, text) for file, text in code(root, "app/cli")
                if file.relative_to(root).as_posix() not in TERMINAL]
    search(root, printing, PRINTING,
           "printing past Terminal.h, which writes out what would steer a terminal", errors)

    for module in ENGINE:
        search(root, code(root, f"modules/{module}"), INEXACT,
               "not the same bits on every machine: use perilymph/foundation/Math.h", errors)
    return errors
