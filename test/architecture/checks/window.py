# SPDX-License-Identifier: BSD-3-Clause
"""The window: the dependencies of its folders, listed in app/gui/README.md, and the use of markup."""

import re
from pathlib import Path

from checks import sources

GUI = "app/gui"
PAGE = f"{GUI}/README.md"

# Labels and tooltips show plain text (Application.cpp). Only these files make markup, with all
# external text escaped.
MARKUP = re.compile(r"\b(?:RichText|AutoText|setHtml|insertHtml|setMarkdown|QStaticText|QMessageBox|"
                    r"QTextEdit|QTextBrowser|QTextDocument)\b")
MARKUP_PLACES = {"Application.cpp", "GuideOverlay.cpp", "ReportPages.cpp"}

# They work without a display, and so without widgets.
WITHOUT_WIDGETS = ("run", "text")
WIDGETS = re.compile(r"Qt(?:Widgets|Gui)/|Q\w*(?:Widget|Window|Pixmap|Painter|Dialog)$")


MAX_FRAME_MEMBERS = 15

def drawn(root):
    """Folder -> folders it may use directly, from the table; and errors in it."""
    page = root / PAGE
    rows = sources.table(sources.read(page), "gui-arrows") if page.is_file() else None
    if not rows:
        return {}, [f"{PAGE} has no table of arrows between <!-- gui-arrows --> marks."]
    arrows, wrong = {}, []
    for row in rows:
        name, uses = sources.quoted(row[0])[0], sources.quoted(row[1])
        wrong += [f"{PAGE}: {name} may use {used}, which has no row above it: arrows go up in the table."
                  for used in uses if used not in arrows]
        arrows[name] = uses
    return arrows, wrong


def reachable(arrows, name):
    """What a folder may include: itself and its transitive dependencies."""
    seen, waiting = {name}, [name]
    while waiting:
        for used in arrows.get(waiting.pop(), []):
            if used not in seen:
                seen.add(used)
                waiting.append(used)
    return seen


def folder_of(path):
    return Path(path).parent.as_posix()


def code(root):
    """Pairs of a file of the window and its folder below app/gui; main.cpp has the folder '.'."""
    return [(file, folder_of(file.relative_to(root / GUI)))
            for file in sources.files(root, GUI, suffixes=sources.CODE)]


def check_includes(root, arrows, wrong):
    for file, folder in code(root):
        place = file.relative_to(root)
        allowed = reachable(arrows, folder) if folder != "." else set(arrows)
        for line, name in sources.includes(file):
            if name.startswith("gui/"):
                used = folder_of(name[len("gui/"):])
                if used not in allowed:
                    wrong.append(f"{place}:{line}: includes {name}, but {PAGE} draws no arrow to {used}.")
            elif "/" not in name and name.endswith(".h") and (root / GUI / folder / name).exists():
                wrong.append(f"{place}:{line}: includes {name} bare; write \"gui/{folder}/{name}\".")
            elif folder in WITHOUT_WIDGETS and WIDGETS.search(name):
                wrong.append(f"{place}:{line}: includes {name}; {GUI}/{folder} works without widgets.")


def check_folders(root, arrows, wrong):
    folders = {folder for _, folder in code(root)} - {"."}
    wrong += [f"{GUI}/{folder} has no row in {PAGE}." for folder in sorted(folders - set(arrows))]
    wrong += [f"{PAGE} has a row {folder}, which does not exist." for folder in sorted(set(arrows) - folders)]


def check_cmake(root, arrows, wrong):
    for folder in arrows:
        file = root / GUI / folder / "CMakeLists.txt"
        text = re.sub(r"#[^\n]*", "", sources.read(file)) if file.is_file() else ""
        call = re.search(rf"perilymph_gui_part\(\s*{re.escape(folder)}\b([^)]*)\)", text)
        if not call:
            wrong.append(f"{GUI}/{folder}/CMakeLists.txt does not call perilymph_gui_part({folder} ...).")
            continue
        uses = re.search(r"\bUSES\b(.*?)(?=\b(?:LINKS|PRIVATE_LINKS|SOURCES)\b|$)", call.group(1), re.S)
        listed = set(uses.group(1).split()) if uses else set()
        for used in sorted(listed ^ set(arrows[folder])):
            wrong.append(f"{GUI}/{folder}/CMakeLists.txt: USES and the row in {PAGE} differ in {used}.")


def check_names(root, wrong):
    """Sources have the names of their headers, and header names are unique."""
    others = {file.name: file.relative_to(root)
              for file in sources.files(root, "modules", "app/cli", "plugins", "test", suffixes={".h"})}
    for file, folder in code(root):
        place = file.relative_to(root)
        if file.suffix == ".cpp" and folder != "." and not file.with_suffix(".h").exists():
            wrong.append(f"{place} has no header of its name.")
        if file.suffix == ".h":
            if file.name in others:
                wrong.append(f"{place} has the name of {others[file.name]}.")
            others[file.name] = place


def check_markup(root, wrong):
    for file, _ in code(root):
        if file.name in MARKUP_PLACES:
            continue
        text = sources.without_comments(sources.read(file))
        for match in MARKUP.finditer(text):
            line = text.count("\n", 0, match.start()) + 1
            wrong.append(f"{file.relative_to(root)}:{line}: '{match.group(0)}' may draw text as markup, "
                         f"which belongs to {', '.join(sorted(MARKUP_PLACES))}.")


def check_frame(root, wrong):
    """The main window stays a frame around its pages."""
    place = root / GUI / "shell/MainWindow.h"
    if not place.is_file():
        return
    header = sources.read(place)
    members = len(re.findall(r"^  [\w:<>*& ]+[ *]\w+_(?: =[^;]*)?;$", header, re.M))
    if members > MAX_FRAME_MEMBERS:
        wrong.append(f"MainWindow has {members} members; at most {MAX_FRAME_MEMBERS}: what it does belongs to a page or "
                     "a class beside it.")


def check(root):
    root = Path(root)
    arrows, wrong = drawn(root)
    if arrows:
        check_includes(root, arrows, wrong)
        check_folders(root, arrows, wrong)
        check_cmake(root, arrows, wrong)
    check_frame(root, wrong)
    check_names(root, wrong)
    check_markup(root, wrong)
    return wrong
