# SPDX-License-Identifier: BSD-3-Clause
"""Vocabulary: obsolete identifiers, doc comments that are no sentences, headers with equal names."""

import re
from collections import defaultdict
from pathlib import Path

from checks import sources

FOLDERS = ("modules", "app", "plugins", "test")

# Obsolete identifiers and their replacements.
GIVEN_UP = {
    "StepRoom": "StepWorkspace", "Balance": "Residual", "Settled": "SolveResult",
    "descend": "minimizeEnergy", "goDown": "lineSearch", "pullAlong": "directionalDerivative",
    "findStep": "solveLinearSystem", "tryStep": "attemptStep", "keepStep": "commitStep",
    "undoStep": "rollBackStep", "perRoot": "inverseRoot", "perSum": "inverseSum",
    "perTime": "inverseTimeStep", "turning_W": "shapeOperator_W", "roundness": "edgeRadius",
    "bendingMore": "bendingExcess", "HidHand": "HidDevice", "KnownHands": "DeviceRegistry",
    "ScriptedHand": "ScriptedDevice", "PointerHand": "PointerDevice", "ReplayHand": "ReplayDevice",
    "SampleWatch": "SampleValidator", "believed": "accepted", "doubted": "rejected",
    "obey": "applyCommand", "happen": "transition", "Wording": "Strings", "ChartWords": "ChartLabels",
    "ForceWords": "ForceInterpretation", "Words": "Labels", "trouble": "error", "mistake": "error",
    "wrong": "error", "Errands": "StartupActions", "Logbook": "Logging", "RunMark": "CrashMarker",
    "ProgramAge": "ProcessUptime", "Interrupted": "CrashRecovery", "Look": "ColorScheme",
    "SmallAlgebra": "DenseSolvers", "TwoFit": "GaussNewton2", "share": "fraction or weight",
    "shares": "fractions or weights", "room": "workspace, buffer or capacity", "most": "maximum",
    "least": "minimum",
}
# Identifiers that are obsolete only in some folders.
GIVEN_UP_IN = {
    "modules/mechanics": {
        "press": "normalContact", "rub": "friction", "Push": "ContactForce", "grip": "effectiveStiffness",
        "settle": "solveNewton", "Way": "SolveStrategy", "worst": "maxNorm", "starting": "staticCoefficient",
        "dynamic": "kineticCoefficient", "stopping": "stoppingCoefficient"},
    "modules/haptics": {"Hand": "HandState", "judge": "validate", "report": "updateOutput"},
    "app/gui": {"Hand": "InputSource", "Field": "SetupField", "Change": "SetupChange",
                "Origin": "SetupOrigin", "Then": "AfterLoading", "Provenance": "ValueSource"},
}
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
    given_up = dict(GIVEN_UP)
    for folder, words in GIVEN_UP_IN.items():
        if place.startswith(folder + "/"):
            given_up.update(words)
    text = sources.read(file)
    for number, word in words_of(OTHERS_NAMES.sub("", sources.without_comments(text))):
        extreme = EXTREME.fullmatch(word)
        if extreme and not LEAST_SQUARES.match(word):
            better = ("max" if extreme[1] == "most" else "min") + extreme[2]
            errors.append(f"{place}:{number}: '{word}' is not the field's word; call it {better}.")
        elif word.rstrip("_") in given_up:
            errors.append(f"{place}:{number}: '{word}' is not the field's word; call it "
                         f"{given_up[word.rstrip('_')]}.")
    for match in SENTENCE.finditer(text):
        number = text.count("\n", 0, match.start()) + 1
        errors.append(f"{place}:{number}: a doc comment is a sentence about what it stands at; it "
                     f"does not begin with 'Of'.")


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
    check_headers(root, files, errors)
    return errors
