# SPDX-License-Identifier: BSD-3-Clause
"""Perilymph: insertion of cochlear-implant electrode arrays, computed.

Every name of a value states its unit: mm, deg, N, mN, s, Hz. Points are in the cochlea's frame (see Cochlea).
An operation that fails raises perilymph.Error, a ValueError, whose text says what to do.

For research and training; not a medical device.
"""

from perilymph import archive, ct, outcome
from perilymph._ct import CtMeasures, read_both_measures, read_measures
from perilymph._engine import (
    Array,
    Cochlea,
    Error,
    Insertion,
    InsertionSnapshot,
    Patient,
    Plan,
    PlannedArray,
    Reading,
    Recording,
    Scenario,
    Simulation,
    Study,
    __version__,
    anatomies,
    arrays,
    build_id,
    frictions,
    patients,
    plan,
    read_array,
    read_patient,
    read_plan,
    read_recording,
    read_scenario,
    read_study,
    scenarios,
    simulate,
)
from perilymph._friction import Friction
from perilymph._study import study
from perilymph._values import ScenarioValues

__all__ = [
    "Array",
    "Cochlea",
    "CtMeasures",
    "Error",
    "Friction",
    "Insertion",
    "InsertionSnapshot",
    "Patient",
    "Plan",
    "PlannedArray",
    "Reading",
    "Recording",
    "Scenario",
    "ScenarioValues",
    "Simulation",
    "Study",
    "__version__",
    "anatomies",
    "archive",
    "arrays",
    "build_id",
    "ct",
    "frictions",
    "outcome",
    "patients",
    "plan",
    "read_array",
    "read_both_measures",
    "read_measures",
    "read_patient",
    "read_plan",
    "read_recording",
    "read_scenario",
    "read_study",
    "scenarios",
    "simulate",
    "study",
]
