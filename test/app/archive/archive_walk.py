# SPDX-License-Identifier: BSD-3-Clause
"""The functions of perilymph.archive with a server: archive_walk.py SERVER FOLDER IMAGES. Run by ArchiveTest.cpp, which starts it."""

import json
import os
import sys
from pathlib import Path

import perilymph
from perilymph import archive

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "python"))
from json_schema import SCHEMAS, faults  # noqa: E402  after the path

server, folder, images = sys.argv[1], sys.argv[2], int(sys.argv[3])

# Every answer of the command is as its schema says, and as the part of it that is of this command.
SCHEMA = json.loads((SCHEMAS / "archive.schema.json").read_text())
PARTS = {"servers": ["servers"], "echo": ["echo"], "find": ["studies", "series"], "fetch": ["fetched"], "send": ["sent"]}
answered = set()
read = archive._read


def read_by_schema(program, words, places, value_of):
    def checked(page):
        assert faults(page, SCHEMA, SCHEMA) == [], words
        fitting = [part for part in PARTS[words[0]] if not faults(page, SCHEMA["$defs"][part], SCHEMA)]
        assert len(fitting) == 1, (words, fitting)
        answered.update(fitting)
        return value_of(page)
    return read(program, words, places, checked)


archive._read = read_by_schema


def refused(call, text):
    try:
        call()
    except perilymph.Error as error:
        assert text in str(error), error
        return
    raise AssertionError(f"not refused: {text}")


assert archive.servers() == [server]
archive.test(server)
refused(lambda: archive.find(server), "condition")
refused(lambda: archive.find(server, birth_date="19701301"), "is no date of the calendar")
assert archive.find(server, patient_id="NOBODY") == []

study, = archive.find(server, patient_id="SECRET*", modality="CT")
assert study.uid == "1.2.3" and study.patient_id is None and study.patient_name is None
named, = archive.find(server, patient_id="SECRET*", show_patients=True)
assert named.patient_id == "SECRETID" and named.birth_date == "19010203"

series, = archive.find_series(server, study)
assert series == archive.find_series(server, "1.2.3")[0]
assert series.modality == "CT" and series.images in (images, None)

ct = archive.retrieve(server, series, folder)
assert (ct.images, ct.resumed, ct.obstacle) == (images, 0, ""), ct
assert len(os.listdir(folder)) == images and os.stat(folder).st_mode & 0o777 == 0o700
refused(lambda: archive.retrieve(server, series, folder), "it is a folder")
refused(lambda: archive.retrieve(server, archive.Series("1.2.3", "9.9.9"), folder + "-other"), "9.9.9")
assert not os.path.exists(folder + "-other")
refused(lambda: archive.send(server, os.path.join(folder, os.listdir(folder)[0])), "is no result of this program")

report = folder + ".dcm"
perilymph.ct.measure(folder, structured_report=report)
sent = archive.send(server, report)
assert sent.study_uid == "1.2.3" and sent.series_uid != series.uid
assert answered == set(SCHEMA["$defs"])
