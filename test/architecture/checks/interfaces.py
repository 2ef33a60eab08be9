# SPDX-License-Identifier: BSD-3-Clause
"""Public headers are a module's API: each is used outside of its module. What only tests use stands in src."""

import re
from pathlib import Path

from checks import sources

# Public without a user in this tree, and why.
ALLOWED = {
    "perilymph/ct/CtVolume.h": "what an import of CT hands over; no program has one yet",
    "perilymph/imaging/CtSeries.h": "reads what an import of CT is given; no program has one yet",
    "perilymph/ct/Measures.h": "what an import of CT asks for; no program has one yet",
}

PUBLIC = re.compile(r"modules/(\w+)/include/(perilymph/.+)")
INTERNAL = re.compile(r"perilymph_\w+_internal\b")


def public_headers(root):
    """Name as included -> module."""
    found = {}
    for file in sources.files(root, "modules", suffixes={".h", ".hpp"}):
        match = PUBLIC.fullmatch(file.relative_to(root).as_posix())
        if match:
            found[match.group(2)] = match.group(1)
    return found


def home_of(place):
    """The module a file belongs to; none for what is no module's."""
    match = re.match(r"modules/(\w+)/", place)
    return match.group(1) if match else None


def check_users(root, wrong):
    headers = public_headers(root)
    brings = {name: [] for name in headers}  # public header -> those of its module that it includes
    used = []
    for file in sources.files(root, "modules", "app", "plugins", suffixes=sources.CODE):
        place = file.relative_to(root).as_posix()
        own = PUBLIC.fullmatch(place)
        for _, name in sources.includes(file):
            if name not in headers:
                continue
            if home_of(place) != headers[name]:
                used.append(name)
            elif own:
                brings[own.group(2)].append(name)
    known = set()
    while used:
        name = used.pop()
        if name not in known:
            known.add(name)
            used += brings[name]
    for name in sorted(set(headers) - known - set(ALLOWED)):
        wrong.append(f"modules/{headers[name]}/include/{name} is used by nobody outside of modules/{headers[name]} "
                     f"but tests; it belongs into src, where they reach it through "
                     f"perilymph_{headers[name]}_internal.")


def check_internals(root, wrong):
    for file in sources.files(root, "modules", "app", "plugins", suffixes={".txt", ".cmake"}):
        if file.relative_to(root).as_posix() == "modules/module.cmake":
            continue
        for number, line in enumerate(sources.read(file).splitlines(), start=1):
            match = INTERNAL.search(line.split("#")[0])
            if match:
                wrong.append(f"{file.relative_to(root)}:{number}: links {match.group(0)}, which is for tests only.")


def check(root):
    root = Path(root)
    wrong = []
    check_users(root, wrong)
    check_internals(root, wrong)
    return wrong
