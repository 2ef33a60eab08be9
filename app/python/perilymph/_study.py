# SPDX-License-Identifier: BSD-3-Clause
"""A study from Python objects, run in this process."""

import copy
import fcntl
import hashlib
import json
import math
import numbers
import os

from perilymph._engine import (
    Array,
    Cochlea,
    Error,
    Patient,
    Scenario,
    _array_file,
    _run_study,
    arrays,
    frictions,
    read_patient,
    read_scenario,
    scenarios,
)
from perilymph._friction import Friction


def _value(key, value):
    """A value of a list as it stands in the file."""
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
    return values


def _table(name, rows):
    # Numbers, texts and lists of them are the same in JSON and in TOML.
    return f"\n[{name}]\n" + "".join(f"{key} = {json.dumps(value, ensure_ascii=False)}\n" for key, value in rows.items())


def study(scenario, folder, *, vary=None, ranges=None, cochleae=0, mean=False, patients=(), samples=1, seed=1, title="Study", depth="full",
          contacts=False, profile_spacing_mm=0.0, jobs=0, progress=None):
    """Runs every combination of lists in every cochlea and returns the Study. The folder has the results, study.toml and all that it names
    (scenario, arrays, frictions, patients), so that it can be moved.

    scenario: what is not varied: a Scenario, or the name or path of one.
    folder: made if it is not there; a study of the same file goes on in it.
    vary: lists of values by the scenario's keys; Array and Friction objects too.
    ranges: (low, high) by key, drawn `samples` times for each cochlea.
    cochleae: number of virtual ones of the population. mean: with the mean cochlea. patients: Patient or Cochlea objects, names or files.
    depth: "full", each array to its own depth, or "scenario".
    contacts: keeps the position of each contact. profile_spacing_mm: keeps force over depth at this spacing [mm]; 0: does not.
    jobs: threads, 0: one per processor. progress: called with the numbers of done and of all insertions; an exception ends the study.

    The interpreter's lock is released while it computes; Ctrl+C ends it, and the same call goes on."""
    head = {"title": title, "seed": seed, "depth": depth}
    if samples != 1:
        head["samples"] = samples
    for key, value in head.items():
        if isinstance(value, bool) or not isinstance(value, (str, numbers.Integral)):
            raise TypeError(f"{key} must be {'a whole number' if key in ('seed', 'samples') else 'text'}")
        head[key] = value if isinstance(value, str) else int(value)
    if isinstance(patients, (str, Patient, Cochlea)):
        raise TypeError("patients must be a list")
    place = os.fspath(folder)
    try:
        os.makedirs(place, exist_ok=True)
        lock = os.open(place, os.O_RDONLY | os.O_DIRECTORY)
    except OSError as error:
        raise Error(f"{error.filename} cannot be written: {error.strerror}. Name a folder that is writable.") from None
    try:  # before a file of another study that runs there would be written over
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        return _run(place, scenario, head, vary, ranges, cochleae, mean, patients, contacts, profile_spacing_mm, jobs, progress)
    except BlockingIOError:
        raise Error(f"{place} is in use by another study. Wait until it ends, or name another folder.") from None
    finally:
        os.close(lock)


def _run(place, scenario, head, vary, ranges, cochleae, mean, patients, contacts, profile_spacing_mm, jobs, progress):
    """study() in a folder that no other one uses."""
    former = _Former(place)
    try:
        kept = _Kept(former)
        head["scenario"] = kept.scenario(scenario)
        varied = {key: [kept.value(key, each) for each in _list(key, values)] for key, values in dict(vary or {}).items()}
        files = []
        texts = {}
        lead_in_mm = (scenario if isinstance(scenario, Scenario) else read_scenario(scenario))["lead_in_mm"]
        for number, given in enumerate(patients, 1):
            patient = given.patient if isinstance(given, Cochlea) else given if isinstance(given, Patient) else read_patient(given)
            if isinstance(given, Cochlea) and given._scenario_lead_in_mm not in (None, lead_in_mm):
                raise Error(f"The cochlea of {patient.label} has a lead-in of {given._scenario_lead_in_mm:g} mm, that of its scenario; the study's scenario "
                            f"has {lead_in_mm:g} mm. Give its patient, or a study with that lead_in_mm.")
            if (before := texts.setdefault(patient.text, number)) != number:
                raise Error(f"The patients {before} and {number} are the same. Leave one out.")
            files.append(f"patients/{number}.toml")
            former.write(files[-1], patient.text)
        text = "".join(f"{key} = {json.dumps(value, ensure_ascii=False)}\n" for key, value in head.items())
        text += _table("cochleae", {"mean": bool(mean), "virtual": _value("cochleae", cochleae)} | ({"patients": files} if files else {}))
        text += _table("vary", varied)
        text += _table("ranges", {key: [_value(key, end) for end in _list(key, ends)] for key, ends in dict(ranges or {}).items()})
        text += _table("results", {"contacts": bool(contacts), "profile_spacing_mm": _value("profile_spacing_mm", profile_spacing_mm)})
        former.write("study.toml", text)
    except OSError as error:
        raise Error(f"{error.filename} cannot be written: {error.strerror}. Name a folder that is writable.") from None
    try:
        return _run_study(os.path.join(place, "study.toml"), place, jobs, progress)
    except Error:
        former.restore()
        raise


class _Kept:
    """The files that a study names, copied into its folder, so that it runs from there on any machine."""

    _SHIPPED = {"array": arrays, "friction": frictions, "calibration": lambda: ()}

    def __init__(self, former):
        self._former = former
        self._texts = {}

    def value(self, key, value):
        """A value as it stands in study.toml."""
        if isinstance(value, Friction):
            return self._keep(key, f"friction-{value.static:g}", value.text)
        if isinstance(value, Array):
            file = _array_file(value)
            if not file:
                return self._keep(key, "".join(each for each in value.name.lower() if each.isalnum()) or "array", value.text)
            value = file
        value = _value(key, value)
        if key not in self._SHIPPED or not isinstance(value, str) or value in self._SHIPPED[key]() or not os.path.isfile(value):
            return value
        with open(value, encoding="utf-8") as stream:
            return self._keep(key, os.path.splitext(os.path.basename(value))[0], stream.read())

    def scenario(self, given):
        """The name of a shipped scenario, or a file of the study's."""
        if not isinstance(given, Scenario):
            name = os.fspath(given)
            if name in scenarios():
                return name
            given = read_scenario(given)
        text = copy.copy(given).text  # refused if the file of its array was changed
        for key in self._SHIPPED:
            if key in given:
                text = text.replace(f"{key} = {json.dumps(given[key], ensure_ascii=False)}\n",
                                    f"{key} = {json.dumps(self.value(key, given[key]), ensure_ascii=False)}\n")
        self._former.write("scenario.toml", text)
        return "scenario.toml"

    def _keep(self, key, name, text):
        file = f"{key}s/{name}.toml"
        if self._texts.setdefault(file, text) != text:  # of another content under the same name
            file = f"{key}s/{name}-{hashlib.sha256(text.encode()).hexdigest()[:8]}.toml"
        self._texts[file] = text
        self._former.write(file, text)
        return file


class _Former:
    """The files of a study's folder as they were: where it has results, they belong to these, and a study that is refused changes none."""

    def __init__(self, folder):
        self._folder = folder
        self._has_results = any(each.endswith(".sqlite") for each in os.listdir(folder)) if os.path.isdir(folder) else False
        self._texts = {}

    def write(self, name, text):
        """Writes a file unless it has this text, so that a study that goes on finds what it was made of."""
        file = os.path.join(self._folder, name)
        os.makedirs(os.path.dirname(file), exist_ok=True)
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
