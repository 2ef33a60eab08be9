# SPDX-License-Identifier: BSD-3-Clause
"""Vocabulary: retired identifiers, doc comments that are no sentences, headers with equal names."""

import re
from collections import defaultdict
from pathlib import Path

from checks import sources

FOLDERS = ("modules", "app", "plugins", "test")

# Retired identifiers (whole words) and the names that replace them.
RETIRED = {
    "AboutSheet": "AboutOverlay", "Beat": "TickClock", "BoardView": "LeaderboardView", "CallFiles": "CommandFiles",
    "CallMark": "CallGuard", "CallWatch": "CallTimeout", "CompanionCall": "ChildCommand",
    "Complaints": "ErrorCollector", "CtOnward": "CtNextSteps", "Done": "Result<void>",
    "EndingQuestion": "EndConfirmation",
    "Farewell": "ShutdownReports", "forget": "cancel, clear or invalidate", "FirstImpression": "OpeningMeasurement", "FullInsertion": "InsertionRun",
    "GivenNumbers": "NumberArray", "GivenPoints": "PointArray", "GuideSheet": "GuideOverlay",
    "HandSection": "InputSection", "HeldArray": "GraspControl", "HistoryOfAPatient": "PatientHistoryPage",
    "Impossible": "InvalidRow", "Intactness": "IntactFraction", "Kept": "RunResult", "KioskBoard": "Leaderboard",
    "KioskTurn": "VisitorSession", "Lean": "MeanTilt", "Likeness": "TemplateScore", "ListOfPatients": "PatientList",
    "ListenFirst": "OpeningMeasurement", "NamesOfMarkup": "MarkupNames", "PlanHead": "PlanHeader",
    "PushPad": "SpeedPad", "QualityPilot": "AdaptiveQuality", "ReportHead": "ReportHeader",
    "RibMeeting": "RibEntry", "RimPush": "RimContactForce", "ScenarioHead": "ScenarioHeader",
    "SettingsSheet": "SettingsOverlay", "Sheets": "OverlayStack", "Taken": "EliminatedRows",
    "TakenRight": "EliminatedRhs", "VtkComplaints": "VtkErrorCollector", "Wish": "PendingRequest",
    "WordsOfVtk": "VtkMessages", "addToFoot": "addFooterControl", "areStanding": "haveConverged",
    "bandsStand": "hasConverged", "farewell": "shutdownReports", "handChosen": "inputChosen",
    "handName": "inputName", "insertFully": "runInsertion", "isAsked": "isRequested",
    "keepNothing": "disableRecording", "leaveSight": "onPageHidden", "listenFirst": "measureOnOpening",
    "liveForTicks": "runForTicks", "pursue": "applyPendingRequest", "showFoot": "showFooter",
    "stepSlowly": "updateReadouts",
}
# Retired in some folders only, because elsewhere the word means what it says.
RETIRED_IN = {
    "app/gui": {"moveHand": "moveScripted", "setHand": "setInput", "showHand": "showInUse", "say": "showMessage", "hear": "setTone", "Hand": "InputSource"},
    "test": {"comes": "waitUntil"},
    "modules/mechanics": {"press": "normalContact", "rub": "friction", "settle": "solveNewton"},
}
# Retired words of what users read: in texts of the program, in the guide and the manual pages.
RETIRED_TEXTS = {
    re.compile(r"\bSessions\b|\bSitzung(?:en)?\b"): "Recordings (Aufzeichnungen)",
    re.compile(r"\b(?:session folder|folder of sessions|[Ss]how sessions|[Aa]ll sessions)\b"): "recordings",
}
# Retired sentences of comments in headers: objects do not say, want, or go on.
RETIRED_SENTENCES = {
    re.compile(r"\b[Rr]efuses,? with one sentence\b"): "returns an error for",
    re.compile(r"\btold apart\b"): "distinguished",
    re.compile(r"\b(?:goes|go) on\b"): "continues, resumes",
    re.compile(r"\bsays? so\b"): "states it",
    re.compile(r"\basks? first\b"): "after a confirmation",
    re.compile(r"\buser wants\b"): "the user requests",
    re.compile(r"\bwas told to\b"): "has a command to",
}
COMMENT = re.compile(r"//[^\n]*")
PAGES = ("resources/guide", "packaging/man", "packaging/completions")
LITERAL = re.compile(r'"(?:\\.|[^"\\\n])*"')
# Signals and requests: closeRequested, not closeAsked.
ASKED = re.compile(r"[a-z]\w*Asked")
# Names of the standard library.
OTHERS_NAMES = re.compile(r"\bget_future\(\)\.share\(\)")
EXTREME = re.compile(r"\b(most|least)([A-Z]\w*)")
LEAST_SQUARES = re.compile(r"leastSquares")
SENTENCE = re.compile(r"//[/!]<? Of \S")


def words_of(code):
    """Pairs of line number and identifier."""
    for number, line in enumerate(code.splitlines(), 1):
        for match in re.finditer(r"\b[A-Za-z]\w*", line):
            yield number, match.group(0)


def check_words(root, file, errors):
    place = file.relative_to(root).as_posix()
    retired = dict(RETIRED)
    for folder, words in RETIRED_IN.items():
        if place.startswith(folder + "/"):
            retired.update(words)
    text = sources.read(file)
    for number, word in words_of(OTHERS_NAMES.sub("", sources.without_comments(text))):
        extreme = EXTREME.fullmatch(word)
        if extreme and not LEAST_SQUARES.match(word):
            better = ("max" if extreme[1] == "most" else "min") + extreme[2]
            errors.append(f"{place}:{number}: '{word}' is not the field's word; call it {better}.")
        elif ASKED.fullmatch(word.rstrip("_")):
            errors.append(f"{place}:{number}: '{word}' is not the field's word; call it "
                         f"{word.rstrip('_').removesuffix('Asked')}Requested.")
        elif word.rstrip("_") in retired:
            errors.append(f"{place}:{number}: '{word}' is not the field's word; call it "
                         f"{retired[word.rstrip('_')]}.")
    for match in SENTENCE.finditer(text):
        number = text.count("\n", 0, match.start()) + 1
        errors.append(f"{place}:{number}: a doc comment is a sentence about what it stands at; it "
                     f"does not begin with 'Of'.")


def check_texts(root, place, texts, errors):
    """Texts are pairs of a position in the file and what users read there."""
    file = sources.read(root / place)
    for start, text in texts:
        for pattern, better in RETIRED_TEXTS.items():
            for match in pattern.finditer(text):
                number = file.count("\n", 0, start + match.start()) + 1
                errors.append(f"{place}:{number}: '{match.group(0)}' is a retired word of what users read; write {better}.")


def check_sentences(place, text, errors):
    for number, line in enumerate(text.splitlines(), 1):
        comment = COMMENT.search(line)
        for pattern, better in RETIRED_SENTENCES.items():
            for match in pattern.finditer(comment.group(0) if comment else ""):
                errors.append(f"{place}:{number}: '{match.group(0)}' is a retired phrase of comments; write {better}.")


def literals(file):
    text = sources.without_comments(sources.read(file), keep_texts=True)
    return [(match.start(), match.group(0)) for match in LITERAL.finditer(text) if not match.group(0).endswith('.h"')]


def check_headers(root, files, errors):
    places = defaultdict(list)
    for file in files:
        if file.suffix in (".h", ".hpp"):
            places[file.name].append(file.relative_to(root).as_posix())
    errors += [f"{' and '.join(sorted(same))} have the same name; give one of them a name of its own."
              for _, same in sorted(places.items()) if len(same) > 1]


def check(root):
    root = Path(root)
    errors = []
    files = sources.files(root, *FOLDERS, suffixes=sources.CODE)
    for file in files:
        check_words(root, file, errors)
        place = file.relative_to(root).as_posix()
        check_texts(root, place, literals(file), errors)
        if file.suffix == ".h" and not place.startswith("test/"):
            check_sentences(place, sources.read(file), errors)
    for file in sources.files(root, *PAGES, suffixes={".md", ".1", ""}):
        check_texts(root, file.relative_to(root).as_posix(), [(0, sources.read(file))], errors)
    check_headers(root, files, errors)
    return errors
