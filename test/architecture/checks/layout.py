# SPDX-License-Identifier: BSD-3-Clause
"""Location of files, structure of modules, and absence of copies."""

from pathlib import Path

from checks import sources

TOP = {"CITATION.cff", "CMakeLists.txt", "CMakePresets.json", "LICENSE", "README.md", "app", "modules", "resources",
       "plugins", "test", "packaging"}
MUST = {"CMakeLists.txt", "README.md", "app", "modules", "test", "packaging"}
MIN_COPY_LINES = 10
SETTINGS = {"CMakePresets.json", ".clang-format", ".clang-tidy", ".gitignore"}


def check_top(root, errors):
    names = {each.name for each in root.iterdir()}
    visible = {name for name in names if not name.startswith(".") and name not in sources.SKIPPED}
    errors += [f"{name} may not stand at the top level." for name in sorted(visible - TOP)]
    errors += [f"{name} is missing at the top level." for name in sorted(MUST - visible)]


def check_module(root, folder, errors):
    name = folder.name
    for must in ("README.md", "CMakeLists.txt", f"include/perilymph/{name}"):
        if not (folder / must).exists():
            errors.append(f"modules/{name}/{must} is missing.")
    for each in sorted(folder.iterdir()):
        if each.name not in ("README.md", "CMakeLists.txt", "include", "src"):
            errors.append(f"modules/{name}/{each.name} may not stand there: a module is README.md, "
                         f"CMakeLists.txt, include and src.")
    public = folder / "include/perilymph"
    if public.is_dir():
        errors += [f"{each.relative_to(root)} does not belong to modules/{name}."
                  for each in sorted(public.iterdir()) if each.name != name]


def check_files(root, errors):
    for file in sources.files(root, "modules", "app", "plugins", "test",
                              suffixes=sources.CODE | {".py"}):
        text = sources.read(file)
        if file.suffix in (".h", ".hpp") and "#pragma once" not in text:
            errors.append(f"{file.relative_to(root)} lacks #pragma once.")


def check_strays(root, errors):
    """Settings files below the top level, and files that are copies of others."""
    seen = {}
    for file in sources.files(root, "app", "modules", "plugins", "resources", "test", "packaging",
                              suffixes=sources.TEXT | {".clang-format"}):
        place = file.relative_to(root)
        if file.name in SETTINGS:
            errors.append(f"{place} may not stand there: settings are the whole project's.")
        text = sources.read(file)
        if len(text.splitlines()) < MIN_COPY_LINES:
            continue
        if text in seen:
            errors.append(f"{place} is a copy of {seen[text]}.")
        seen.setdefault(text, place)


def check(root):
    root = Path(root)
    errors = []
    check_top(root, errors)
    if (root / "modules").is_dir():
        for folder in sorted((root / "modules").iterdir()):
            if folder.is_dir() and folder.name not in sources.SKIPPED:
                check_module(root, folder, errors)
    check_files(root, errors)
    check_strays(root, errors)
    return errors
