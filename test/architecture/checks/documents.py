# SPDX-License-Identifier: BSD-3-Clause
"""Links and paths in documents exist; the map in README.md matches the folders."""

import re
from pathlib import Path

from checks import sources

TOP = ("app", "modules", "plugins", "resources", "test", "packaging", ".ci")
ENDINGS = (".h", ".cpp", ".toml", ".md", ".txt", ".cmake", ".py", ".png", ".csv")


def documents(root):
    return [file for file in sources.files(root, suffixes={".md"})]


def without_blocks(text):
    """The text with fenced blocks blanked; line numbers are kept."""
    return re.sub(r"^```.*?^```", lambda match: re.sub(r"[^\n]", " ", match.group(0)), text,
                  flags=re.S | re.M)


def line_of(text, match):
    return text.count("\n", 0, match.start()) + 1


def check_links(root, file, text, errors):
    for match in re.finditer(r"!?\[[^\]]*\]\(([^)\s]+)\)", text):
        target = match.group(1).split("#")[0]
        if not target or re.match(r"[a-z]+:", target):
            continue
        if not (file.parent / target).exists():
            errors.append(f"{file.relative_to(root)}:{line_of(text, match)}: links to {target}, "
                         f"which does not exist.")


def is_path(word):
    if not re.fullmatch(r"[\w.+\-/]+", word) or word.startswith(("/", "-", "build/")):
        return False
    return word.split("/")[0] in TOP and "/" in word or word.endswith(ENDINGS)


def exists(root, file, word):
    places = [root, file.parent, *root.glob("modules/*/include"), *root.glob("modules/*/src")]
    if any((place / word).exists() for place in places):
        return True
    # A bare file name, as in "read TripleBuffer.h first", may be in any folder.
    return "/" not in word and any(
        each.name == word for each in sources.files(root, suffixes={Path(word).suffix}))


def check_paths(root, file, text, errors):
    for match in re.finditer(r"`([^`\n]+)`", text):
        word = match.group(1)
        if is_path(word) and not exists(root, file, word):
            errors.append(f"{file.relative_to(root)}:{line_of(text, match)}: names {word}, "
                         f"which does not exist.")


def read_map(text):
    """Folder -> names indented below it, of the first fenced block under "## The map"."""
    block = re.search(r"^## The map$.*?^```[^\n]*\n(.*?)^```", text, re.S | re.M)
    if not block:
        return None
    drawn, current = {}, None
    for line in block.group(1).splitlines():
        top = re.match(r"([\w.]+)/\s", line)
        below = re.match(r"  (\w+)/?\s", line)
        if top:
            current = drawn.setdefault(top.group(1), [])
        elif below and current is not None:
            current.append(below.group(1))
    return drawn


def folders(place):
    return {each.name for each in place.iterdir()
            if each.is_dir() and not each.name.startswith(".") and each.name not in sources.SKIPPED}


def check_map(root, errors):
    drawn = read_map(sources.read(root / "README.md"))
    if not drawn:
        errors.append("README.md has no fenced map under the heading '## The map'.")
        return
    places = [("", set(drawn), folders(root))]
    places += [(name + "/", set(below), folders(root / name))
               for name, below in drawn.items() if below and (root / name).is_dir()]
    for prefix, told, real in places:
        errors += [f"README.md's map shows {prefix}{name}, which does not exist."
                  for name in sorted(told - real)]
        errors += [f"README.md's map does not show {prefix}{name}." for name in sorted(real - told)]


def check(root):
    root = Path(root)
    if not (root / "README.md").is_file():
        return ["README.md is missing."]
    errors = []
    for file in documents(root):
        text = without_blocks(sources.read(file))
        check_links(root, file, text, errors)
        check_paths(root, file, text, errors)
    check_map(root, errors)
    return errors
