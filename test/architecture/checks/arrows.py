# SPDX-License-Identifier: BSD-3-Clause
"""The dependencies listed in modules/README.md compared with the real includes and USES in CMake."""

import fnmatch
import re
from pathlib import Path

from checks import sources


def drawn(root):
    """Module -> (layer, modules it may use directly), from the table; and errors in it."""
    rows = sources.table(sources.read(Path(root) / "modules/README.md"), "arrows")
    if not rows:
        return {}, ["modules/README.md has no table of arrows between <!-- arrows --> marks."]
    modules = [sources.quoted(row[1])[0] for row in rows]
    arrows, errors = {}, []
    for row in rows:
        layer, name = int(row[0]), sources.quoted(row[1])[0]
        uses = sources.quoted(row[2])
        if row[2] == "every module":
            uses = [module for module in modules if not module.startswith("app/")]
        arrows[name] = (layer, uses)
    for name, (layer, uses) in arrows.items():
        for used in uses:
            if used not in arrows:
                errors.append(f"modules/README.md: {name} may use {used}, which has no row.")
            elif arrows[used][0] >= layer:
                errors.append(f"modules/README.md: {name} (layer {layer}) may not use {used} "
                             f"(layer {arrows[used][0]}): an arrow goes down.")
    return arrows, errors


def reachable(arrows, name):
    """What a module may include: itself and its transitive dependencies."""
    seen, waiting = {name}, [name]
    while waiting:
        for used in arrows.get(waiting.pop(), (0, []))[1]:
            if used not in seen:
                seen.add(used)
                waiting.append(used)
    return seen


def homes(root, arrows):
    """Folder of each module and application that exists."""
    return {name: name if "/" in name else f"modules/{name}" for name in arrows
            if (Path(root) / (name if "/" in name else f"modules/{name}")).is_dir()}


PLUGIN_MAY = {"plugins/devices": "device", "plugins/electrodes": "electrode"}


def check_includes(root, arrows, errors):
    areas = [(home, reachable(arrows, name)) for name, home in homes(root, arrows).items()]
    areas += [(home, reachable(arrows, module)) for home, module in PLUGIN_MAY.items()]
    for home, allowed in areas:
        for file in sources.files(root, home, suffixes=sources.CODE):
            for line, name in sources.includes(file):
                match = re.match(r"perilymph/(\w+)/", name)
                if match and match.group(1) not in allowed:
                    errors.append(f"{file.relative_to(root)}:{line}: includes {name}, but "
                                 f"modules/README.md draws no arrow to {match.group(1)}.")


def check_libraries(root, arrows, errors):
    rows = sources.table(sources.read(Path(root) / "modules/README.md"), "libraries")
    if not rows:
        errors.append("modules/README.md has no table of libraries between <!-- libraries --> marks.")
        return
    for name, home in homes(root, arrows).items():
        for file in sources.files(root, home, suffixes=sources.CODE):
            for line, included in sources.includes(file):
                for library, patterns, places in rows:
                    if any(fnmatch.fnmatchcase(included, one) for one in sources.quoted(patterns)) \
                            and name not in sources.quoted(places):
                        errors.append(f"{file.relative_to(root)}:{line}: includes {included}; "
                                     f"{library} belongs to {places} only.")


KEYWORDS = "LAYER|SUMMARY|USES|LINKS|PRIVATE_LINKS|OPTIONS|SOURCES"


def check_cmake(root, arrows, errors):
    for folder in sorted((Path(root) / "modules").iterdir()):
        if not (folder / "CMakeLists.txt").is_file():
            continue
        name = folder.name
        if name not in arrows:
            errors.append(f"modules/{name} has no row in modules/README.md.")
            continue
        text = re.sub(r"#[^\n]*", "", sources.read(folder / "CMakeLists.txt"))
        text = re.sub(r'"[^"]*"', '""', text)
        call = re.search(rf"perilymph_module\(\s*{name}\b([^)]*)\)", text)
        if not call:
            errors.append(f"modules/{name}/CMakeLists.txt does not call perilymph_module({name} ...).")
            continue
        layer = re.search(r"\bLAYER\s+(\w+)", call.group(1))
        expected = "engine" if arrows[name][0] <= 7 else "toolkit"
        if not layer or layer.group(1) != expected:
            errors.append(f"modules/{name}/CMakeLists.txt: LAYER must be {expected}, "
                         f"as modules/README.md says.")
        uses = re.search(rf"\bUSES\b(.*?)(?=\b(?:{KEYWORDS})\b|$)", call.group(1), re.S)
        for used in uses.group(1).split() if uses else []:
            if used not in reachable(arrows, name) - {name}:
                errors.append(f"modules/{name}/CMakeLists.txt: uses {used}, but modules/README.md "
                             f"draws no arrow to it.")


def check(root):
    root = Path(root)
    arrows, errors = drawn(root)
    if arrows:
        check_includes(root, arrows, errors)
        check_libraries(root, arrows, errors)
        check_cmake(root, arrows, errors)
    return errors
