# SPDX-License-Identifier: BSD-3-Clause
"""The tables of threads, processes and channels in modules/README.md against the code that begins and uses them."""

import re
from pathlib import Path

from checks import sources

PAGE = "modules/README.md"
ROLES = "modules/foundation/include/perilymph/foundation/RealTime.h"
CHANNELS = "modules/realtime/include/perilymph/realtime"

DECLARED = re.compile(r"\bdeclareThread\(\s*(?:perilymph::)?ThreadRole::(\w+)\s*\)")
# A thread of the standard library is begun where it is constructed; Qt's where the class is named.
THREAD = re.compile(r"\bstd::(?:jthread|thread)\b(?!::)|\bstd::async\b|\bpthread_create\b|"
                    r"\b(?:QThread|QThreadPool|QtConcurrent)\b(?!::(?:started|finished))")
CONSTRUCTED = re.compile(r"\bstd::(?:jthread|thread)\s*[({]|\bstd::async\s*\(|\bpthread_create\s*\(")
PROCESS = re.compile(r"\b(?:start|run)Program\(|(?<![.>\w])(?:::)?v?fork\s*\(\)|\bQProcess\b")
# Only startProgram() asks the system for another program, so that no shell reads an argument.
PROGRAMS = "modules/foundation/src/Program.cpp"
OTHER_WAYS = re.compile(r"\bposix_spawnp?\s*\(|\bstd::system\s*\(|(?<![.>\w])::system\s*\(|\bpopen\s*\(|"
                        r"\b(?:f?exec(?:l|le|lp|v|ve|vp|vpe|veat))\s*\(|\bwordexp\s*\(")
# Declarations of what threads share, not references to it or locks of it.
SHARED = re.compile(r"(?<!make_shared<)(?<!lock<)(?<!lock_guard<)std::(?:(?:shared_|recursive_|timed_)?mutex|"
                    r"condition_variable(?:_any)?|once_flag|atomic(?:_flag\b|<[^<>]*>))(?!\s*&)(?!::)")
SHARED_PAGE = "modules/realtime/README.md"
USED = re.compile(r"\brealtime::(\w+)\s*<")


# A plug-in runs in a process of its own and sees one header: its threads have no role, and share nothing with the
# program's.
PROGRAM = ("modules", "app")


def code(root, *folders):
    """Pairs of file and its text without comments and string literals; in all folders with code if none is named."""
    for file in sources.files(root, *(folders or (*PROGRAM, "plugins")), suffixes=sources.CODE):
        text = sources.without_comments(sources.read(file))
        yield file, re.sub(r"^[ \t]*#[ \t]*include[^\n]*", "", text, flags=re.M)


def rows(root, name, wrong):
    """The first two cells of each row of a table: (what, file that starts it)."""
    table = sources.table(sources.read(root / PAGE), name) if (root / PAGE).is_file() else None
    if table is None:
        wrong.append(f"{PAGE} has no table between <!-- {name} --> and <!-- /{name} -->.")
        return []
    return [((sources.quoted(row[0]) or [row[0]])[0], sources.quoted(row[1])[0]) for row in table]


def roles(root):
    """The roles of the enum, without the one of threads that have none."""
    text = sources.without_comments(sources.read(root / ROLES))
    match = re.search(r"enum class ThreadRole\s*\{(.*?)\}", text, re.S)
    names = re.findall(r"\w+", match.group(1)) if match else []
    return [name for name in names if name != "none"]


def check_threads(root, wrong):
    table = rows(root, "threads", wrong)
    known = roles(root)
    told = [role for role, _ in table]
    for role in known:
        if told.count(role) != 1:
            wrong.append(f"{PAGE} tells the thread `{role}` of {ROLES} {told.count(role)} times; it must be once.")
    for role in told:
        if role not in known:
            wrong.append(f"{PAGE} tells a thread `{role}`, which is no role of {ROLES}.")
    declared = {}  # role -> places
    beginning = {}  # file without its ending -> places
    for file, text in code(root, *PROGRAM):
        place = file.relative_to(root).as_posix()
        here = DECLARED.findall(text)
        for role in here:
            declared.setdefault(role, []).append(place)
        if THREAD.search(text):
            beginning.setdefault(file.with_suffix(""), []).append(place)
        begun = len(CONSTRUCTED.findall(text))
        if begun > len(here):
            wrong.append(f"{place} begins {begun} threads and declares the role of {len(here)}; each declares its own.")
    for role, where in table:
        places = declared.get(role, [])
        if len(places) != 1 or Path(places[0]).name != where:
            wrong.append(f"{PAGE} says that the thread `{role}` begins in {where}; it is declared in "
                         f"{', '.join(places) or 'no file'}.")
    homes = {(root / place).with_suffix("") for places in declared.values() for place in places}
    for home, places in beginning.items():
        if home not in homes:
            wrong.append(f"{places[0]} begins a thread that declares no role (declareThread, {ROLES}).")


def check_processes(root, wrong):
    told = {where for _, where in rows(root, "processes", wrong)}
    begun = {}
    for file, text in code(root):
        place = file.relative_to(root).as_posix()
        if OTHER_WAYS.search(text) and place != PROGRAMS:
            wrong.append(f"{place} starts a program by itself; startProgram() of Program.h does, without a shell.")
        if PROCESS.search(text) and file.stem != "Program":
            begun.setdefault(file.name, place)
    for name in sorted(set(begun) - told):
        wrong.append(f"{begun[name]} begins a process that the table of {PAGE} does not tell.")
    for name in sorted(told - set(begun)):
        wrong.append(f"{PAGE} says that a process begins in {name}; none does.")


def check_channels(root, wrong):
    table = sources.table(sources.read(root / PAGE), "channels")
    told = {name for row in table or [] for name in sources.quoted(row[1])}
    templates = set()
    for file in sources.files(root, CHANNELS, suffixes={".h"}):
        templates |= set(re.findall(r"template <class \w+>\s*class (\w+)", sources.without_comments(sources.read(file))))
    used = {name for _, text in code(root) for name in USED.findall(text)}
    for name in sorted(templates - told):
        wrong.append(f"{PAGE} does not tell the channel `{name}` of {CHANNELS}.")
    for name in sorted(told - templates):
        wrong.append(f"{PAGE} tells a channel `{name}`, which {CHANNELS} does not have.")
    for name in sorted(told & templates - used):
        wrong.append(f"{PAGE} tells the channel `{name}`, which nobody uses.")


def check_shared(root, wrong):
    text = sources.read(root / SHARED_PAGE) if (root / SHARED_PAGE).is_file() else ""
    table = sources.table(text, "shared")
    if table is None:
        wrong.append(f"{SHARED_PAGE} has no table between <!-- shared --> and <!-- /shared -->.")
        return
    told = {sources.quoted(row[0])[0]: row[1] for row in table}
    found = {}  # name of the file -> what it declares
    for file, text in code(root, *PROGRAM):
        place = file.relative_to(root).as_posix()
        if not place.startswith("modules/realtime/"):
            kinds = {("atomic" if "atomic" in each else "once flag" if "once" in each else
                      "condition" if "condition" in each else "mutex") for each in SHARED.findall(text)}
            if kinds:
                found[file.name] = kinds
    for name in sorted(set(found) | set(told)):
        kinds = {kind for kind in ("atomic", "once flag", "condition", "mutex") if kind in told.get(name, "")}
        if kinds != found.get(name, set()):
            wrong.append(f"{SHARED_PAGE} tells of {name}: {', '.join(sorted(kinds)) or 'nothing'}; it declares "
                         f"{', '.join(sorted(found.get(name, []))) or 'nothing'} that threads share.")


def check(root):
    root = Path(root)
    wrong = []
    check_shared(root, wrong)
    check_threads(root, wrong)
    check_processes(root, wrong)
    check_channels(root, wrong)
    return wrong
