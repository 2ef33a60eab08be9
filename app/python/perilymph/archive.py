# SPDX-License-Identifier: BSD-3-Clause
"""A CT from a DICOM archive, and results back into its study, by perilymph-cli.

A server is a name in servers.toml ('perilymph-cli archive servers' lists and changes them). What is searched for stands on a
command line while it runs, visible to other users of the machine: prefer a number to a name. An operation that fails raises
perilymph.Error with the program's sentence, which names no patient."""

import json
import os
import tempfile
from typing import NamedTuple, Optional

from perilymph._engine import Error
from perilymph._json import text_of
from perilymph._programs import run_program, word

__all__ = ["Retrieved", "Sent", "Series", "Study", "find", "find_series", "retrieve", "send", "servers", "test"]


class Study(NamedTuple):
    """A study as the archive describes it; texts are empty where it states nothing. Number, name and birth date of the patient
    are None unless they were asked for."""

    uid: str
    date: str = ""  # YYYYMMDD
    modalities: str = ""  # joined by "/"
    description: str = ""
    patient_id: Optional[str] = None
    patient_name: Optional[str] = None
    birth_date: Optional[str] = None


class Series(NamedTuple):
    """A series of a study; 'images' is None where the archive does not count them."""

    study_uid: str
    uid: str
    number: str = ""
    modality: str = ""
    description: str = ""
    images: Optional[int] = None


class Retrieved(NamedTuple):
    """A series that was retrieved into 'folder': its number of images and how many of them an earlier call had retrieved.
    'obstacle' says why it cannot be measured; it is empty if it can."""

    folder: str
    images: int
    resumed: int
    obstacle: str


class Sent(NamedTuple):
    """Where the archive stored an object; 'warning' is empty unless the archive changed it."""

    study_uid: str
    series_uid: str
    instance_uid: str
    series_number: str
    warning: str


def servers(*, program="perilymph-cli"):
    """The names of the servers in servers.toml."""
    return _read(program, ["servers"], [], lambda page: [text_of(each["name"]) for each in page["servers"]])


def test(server, *, program="perilymph-cli"):
    """Tests whether a server answers (C-ECHO). The error states what failed: host, connection, TLS, AE title or time."""
    _read(program, ["echo"], [word("server", server)], lambda page: page["answers"])


def find(server, *, patient_id=None, patient_name=None, birth_date=None, since=None, until=None, modality=None, show_patients=False,
         program="perilymph-cli"):
    """Finds studies: a list of Study, of at most 500. At least one condition is needed.

    patient_id, patient_name: * and ? match any; a name is FAMILY^GIVEN. birth_date, since, until: YYYYMMDD; the last two are the
    first and the last day of the study. modality: one of its series has it; an archive may ignore it.
    show_patients: number, name and birth date of the patients are in the result."""
    words = ["find"]
    for option, name, value in (("--patient-id", "patient_id", patient_id), ("--patient-name", "patient_name", patient_name),
                                ("--birth-date", "birth_date", birth_date), ("--from", "since", since), ("--until", "until", until),
                                ("--modality", "modality", modality)):
        if value is not None:
            words.append(f"{option}={word(name, value)}")
    words += ["--show-patients"] if show_patients else []
    return _read(program, words, [word("server", server)], lambda page: [_study(each, show_patients) for each in page["studies"]])


def find_series(server, study, *, program="perilymph-cli"):
    """The series of a study, a Study or its UID: a list of Series."""
    uid = word("study", study.uid if isinstance(study, Study) else study)
    return _read(program, ["find", f"--study={uid}"], [word("server", server)],
                 lambda page: [Series(uid, text_of(each["series_uid"]), text_of(each["number"]), text_of(each["modality"]), text_of(each["description"]),
                                      None if each["images"] is None else int(each["images"])) for each in page["series"]])


def retrieve(server, series, folder, *, program="perilymph-cli"):
    """Retrieves a series into a new folder, which only its owner can open, and returns what was retrieved.

    Until every image is there the folder's name ends in '.partial'; the same call resumes what was interrupted. The files hold what
    the scanner wrote, the patient's name too: remove the folder when it is no longer needed."""
    if not isinstance(series, Series):
        raise TypeError("series must be a Series, as find_series returns it")
    place = word("folder", folder)
    words = ["fetch", f"--study={word('study', series.study_uid)}", f"--series={word('series', series.uid)}", f"--out={place}"]
    return _read(program, words, [word("server", server)],
                 lambda page: Retrieved(place, int(page["images"]), int(page["resumed"]), text_of(page["obstacle"])))


def send(server, file, *, program="perilymph-cli"):
    """Sends a DICOM file that this program wrote into the study of the CT that it was made from, and into no other: a report,
    measures, a segmentation or a key image. The archive must have the study under the same patient number and birth date."""
    return _read(program, ["send"], [word("server", server), word("file", file)],
                 lambda page: Sent(text_of(page["study_uid"]), text_of(page["series_uid"]), text_of(page["instance_uid"]),
                                   text_of(page["series_number"]), text_of(page["warning"])))


def _study(row, shows_patients):
    shown = [text_of(row[key]) for key in ("patient_id", "patient_name", "birth_date")] if shows_patients else []
    return Study(text_of(row["study_uid"]), text_of(row["date"]), text_of(row["modalities"]), text_of(row["description"]), *shown)


def _read(program, words, places, value_of):
    """Runs 'perilymph-cli archive' and returns the value that a function reads from its answer."""
    with tempfile.TemporaryDirectory(prefix="perilymph-") as folder:
        file = os.path.join(folder, "answer.json")
        run_program(program, ["archive", *words, "--json", file, *(["--", *places] if places else [])])
        try:
            with open(file, encoding="utf-8") as stream:
                return value_of(json.load(stream))
        except (OSError, KeyError, IndexError, TypeError, ValueError) as error:
            raise Error(f"The answer of 'perilymph-cli archive {words[0]}' cannot be read ({type(error).__name__}). "
                        "Use the program of the same version as this package.") from None
