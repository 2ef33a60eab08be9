# SPDX-License-Identifier: BSD-3-Clause
"""The functions for DICOM archives without a server; with Orthanc and dcmqrscp they are called by test/app/archive."""

import json
import os
import pickle
import sys
from pathlib import Path

import pytest

import perilymph
from perilymph import archive

CLI = Path(os.environ["PERILYMPH_PROGRAMS"]) / "perilymph-cli"


@pytest.fixture
def own_settings(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))


def stand_in(folder, answer):
    """A program that writes its words to words.json and an answer to the file of --json."""
    program = folder / "stand-in"
    program.write_text(f"""#!{sys.executable}
import json, sys
json.dump(sys.argv[1:], open({str(folder / 'words.json')!r}, "w"))
open(sys.argv[sys.argv.index("--json") + 1], "w").write({answer!r})
""")
    program.chmod(0o700)
    return program, lambda: json.loads((folder / "words.json").read_text())


def test_an_unknown_server_is_named(own_settings):
    assert archive.servers(program=CLI) == []
    for call in (lambda: archive.test("pacs", program=CLI), lambda: archive.find("pacs", patient_id="1", program=CLI),
                 lambda: archive.find_series("pacs", "1.2.3", program=CLI), lambda: archive.send("pacs", __file__, program=CLI)):
        with pytest.raises(perilymph.Error, match="no server 'pacs'"):
            call()


def test_what_is_typed_is_one_word_and_no_option(tmp_path):
    program, words = stand_in(tmp_path, '{"studies": []}')
    assert archive.find("--help", patient_name="--json x", since="20260101", program=program) == []
    given = words()
    assert given[:4] == ["archive", "find", "--patient-name=--json x", "--from=20260101"]
    assert given[-2:] == ["--", "--help"] and "--show-patients" not in given


def test_patients_are_named_only_where_they_are_asked_for(tmp_path):
    row = {"study_uid": "1.2", "date": "20260101", "modalities": "CT", "description": "", "patient_id": "4711", "patient_name": "Doe^Jane",
           "birth_date": "19010203"}
    program, words = stand_in(tmp_path, json.dumps({"studies": [row]}))
    plain, = archive.find("pacs", patient_id="4711", program=program)
    assert (plain.uid, plain.patient_id, plain.patient_name, plain.birth_date) == ("1.2", None, None, None)
    shown, = archive.find("pacs", patient_id="4711", show_patients=True, program=program)
    assert shown.patient_name == "Doe^Jane" and "--show-patients" in words()
    assert shown == pickle.loads(pickle.dumps(shown)) and hash(shown) != hash(plain)


def test_wrong_types_empty_texts_and_foreign_answers_are_refused(tmp_path):
    program, _ = stand_in(tmp_path, '{"studies": [{"study_uid": 3}]}')
    with pytest.raises(TypeError, match="patient_id must be text"):
        archive.find("pacs", patient_id=4711, program=program)
    with pytest.raises(TypeError, match="must be a Series"):
        archive.retrieve("pacs", "1.2.3", tmp_path / "ct", program=program)
    with pytest.raises(perilymph.Error, match="modality is empty"):
        archive.find("pacs", modality="", program=program)
    with pytest.raises(perilymph.Error, match="zero character"):
        archive.find("pacs", modality="C\0T", program=program)
    with pytest.raises(perilymph.Error, match="answer of 'perilymph-cli archive find' cannot be read"):
        archive.find("pacs", modality="CT", program=program)
    with pytest.raises(perilymph.Error, match="was not found"):
        archive.servers(program=tmp_path / "absent")
