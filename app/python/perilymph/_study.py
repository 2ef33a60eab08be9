# SPDX-License-Identifier: BSD-3-Clause
"""A study from Python objects, run in this process."""

import json
import math
import numbers
import os

import numpy as np

from perilymph._engine import (
    Array,
    Cochlea,
    Error,
    Patient,
    _array_name,
    _friction_name,
    _run_study,
    _scenario_name,
    read_array,
    read_patient,
    read_scenario,
)
from perilymph._friction import Friction


def _value(key, value):
    """A value of a list as it stands in the file."""
    if isinstance(value, Array):
        return _array_name(value)
    if isinstance(value, Friction):
        return _friction_name(value)
    if isinstance(value, (bool, str)):
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, numbers.Integral):
        return int(value)
    if isinstance(value, numbers.Real):
        if not math.isfinite(value):
            raise Error(f"The value of '{key}' is {value}; it must be a finite number. Correct it.")
        return float(value)
    raise TypeError(f"the value of '{key}' must be a number, text, True or False, a path, an Array or a Friction")


def _list(key, values):
    if isinstance(values, (str, Array, Friction)) or not hasattr(values, "__iter__"):
        raise TypeError(f"the values of '{key}' must be a list")
    return [_value(key, value) for value in values]


def _table(name, rows):
    # Numbers, texts and lists of them are the same in JSON and in TOML.
    return f"\n[{name}]\n" + "".join(f"{key} = {json.dumps(value, ensure_ascii=False)}\n" for key, value in rows.items())


def study(scenario, folder, *, vary=None, ranges=None, cochleae=0, mean=False, patients=(), samples=1, seed=1, title="Study", depth="full",
          contacts=False, profile_spacing_mm=0.0, jobs=0, progress=None):
    """Runs every combination of lists in every cochlea and returns the Study; results, study.toml and patients are in the folder.

    scenario: what is not varied: a Scenario, or the name or path of one.
    folder: made if it is not there; a study of the same file goes on in it.
    vary: lists of values by the scenario's keys; Array and Friction objects too.
    ranges: (low, high) by key, drawn `samples` times for each cochlea.
    cochleae: number of virtual ones of the population. mean: with the mean cochlea. patients: Patient or Cochlea objects, names or files.
    depth: "full", each array to its own depth, or "scenario".
    contacts: keeps the position of each contact. profile_spacing_mm: keeps force over depth at this spacing [mm]; 0: does not.
    jobs: threads, 0: one per processor. progress: called with the numbers of done and of all insertions; an exception ends the study.

    The interpreter's lock is released while it computes; Ctrl+C ends it, and the same call goes on."""
    head = {"title": title, "scenario": _scenario_name(scenario), "seed": seed, "depth": depth}
    if samples != 1:
        head["samples"] = samples
    for key, value in head.items():
        if isinstance(value, bool) or not isinstance(value, (str, numbers.Integral)):
            raise TypeError(f"{key} must be {'a whole number' if key in ('seed', 'samples') else 'text'}")
        head[key] = value if isinstance(value, str) else int(value)
    if isinstance(patients, (str, Patient, Cochlea)):
        raise TypeError("patients must be a list")
    place = os.fspath(folder)
    former = _Former(place)
    try:
        os.makedirs(os.path.join(place, "patients") if len(patients) else place, exist_ok=True)
        files = []
        for number, given in enumerate(patients, 1):
            patient = given.patient if isinstance(given, Cochlea) else given if isinstance(given, Patient) else read_patient(given)
            files.append(f"patients/{number}.toml")
            former.write(files[-1], patient.text())
        text = "".join(f"{key} = {json.dumps(value, ensure_ascii=False)}\n" for key, value in head.items())
        text += _table("cochleae", {"mean": bool(mean), "virtual": _value("cochleae", cochleae)} | ({"patients": files} if files else {}))
        text += _table("vary", {key: _list(key, values) for key, values in dict(vary or {}).items()})
        text += _table("ranges", {key: _list(key, ends) for key, ends in dict(ranges or {}).items()})
        text += _table("results", {"contacts": bool(contacts), "profile_spacing_mm": _value("profile_spacing_mm", profile_spacing_mm)})
        former.write("study.toml", text)
    except OSError as error:
        raise Error(f"{error.filename} cannot be written: {error.strerror}. Name a folder that is writable.") from None
    try:
        return _run_study(os.path.join(place, "study.toml"), place, jobs, progress)
    except Error:
        former.restore()
        raise


def with_names(columns):
    """The columns of a study and what the files that its settings name say, so that figures and tables need not show paths: 'array_name',
    and 'friction_static' and 'friction_dynamic' unless they are settings. A file that cannot be read gives its own name, or NaN."""
    def add(name, key, of_file, otherwise):
        if key not in columns or name in columns:
            return
        found = {}
        for value in np.unique(columns[key]):
            try:
                found[value] = of_file(str(value))
            except Error:
                found[value] = otherwise(str(value))
        columns[name] = np.array([found[value] for value in columns[key]])

    add("array_name", "array", lambda value: read_array(value).name, lambda value: os.path.splitext(os.path.basename(value))[0])
    for name in ("friction_static", "friction_dynamic"):
        add(name, "friction", lambda value, name=name: float(read_scenario("surgery-flex28", {"friction": value})[name]), lambda value: math.nan)
    return columns


class _Former:
    """The files of a study's folder as they were: where it has results, they belong to these, and a study that is refused changes none."""

    def __init__(self, folder):
        self._folder = folder
        self._has_results = any(each.endswith(".sqlite") for each in os.listdir(folder)) if os.path.isdir(folder) else False
        self._texts = {}

    def write(self, name, text):
        """Writes a file unless it has this text, so that a study that goes on finds what it was made of."""
        file = os.path.join(self._folder, name)
        try:
            with open(file, "rb") as stream:
                before = stream.read()
        except OSError:
            before = None
        if before == text.encode():
            return
        self._texts[name] = before
        with open(file, "wb") as stream:
            stream.write(text.encode())

    def restore(self):
        for name, before in self._texts.items() if self._has_results else ():
            file = os.path.join(self._folder, name)
            if before is None:
                os.remove(file)
            else:
                with open(file, "wb") as stream:
                    stream.write(before)
