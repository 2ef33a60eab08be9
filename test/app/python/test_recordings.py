# SPDX-License-Identifier: BSD-3-Clause
"""Recordings, studies and measured CTs read back as what was written."""

import json
import os
import pickle
import re
import shutil
import sqlite3
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, SHORT, same_bits, table

import perilymph


@pytest.fixture(scope="module")
def recorded(tmp_path_factory):
    """A recording and the simulation that made it."""
    file = tmp_path_factory.mktemp("recorded") / "a.insertion"
    return file, perilymph.simulate("contour-published", SHORT, record=file)


def test_a_recording_has_the_columns_of_its_simulation(recorded):
    file, simulation = recorded
    recording = perilymph.read_recording(file)
    assert all(same_bits(recording[name], column) for name, column in simulation.columns.items())
    assert (recording.end, recording.was_closed, recording.lost_ticks, recording.note) == ("finished", True, 0, "")
    assert recording.facts["scenario_name"] == "contour-published"
    assert recording.facts["scenario_text"] == simulation.scenario.text
    assert (recording.facts["time_step_s"], recording.facts["build_id"]) == (0.001, perilymph.build_id)
    assert recording.highlights["ticks"] == simulation.summary["ticks"]
    assert recording.highlights["peak_force_N"] == simulation.summary["peak_force_N"]


@pytest.mark.parametrize("name", sorted(file.name for file in (ROOT / "test/data/recordings").glob("*.insertion")))
def test_stored_recordings_are_read_as_the_command_line_reads_them(cli, tmp_path, name):
    file = tmp_path / name
    shutil.copy(ROOT / "test/data/recordings" / name, file)
    cli("replay", file, "--csv", tmp_path / "a.csv")
    recording = perilymph.read_recording(file)
    for column, values in table(tmp_path / "a.csv").items():
        assert same_bits(recording[column], values), column
    fewer = perilymph.read_recording(file, every_ms=100)
    assert 0 < len(fewer["time_s"]) < len(recording["time_s"])
    assert np.isin(fewer["time_s"], recording["time_s"]).all()


def test_a_renamed_column_is_read_by_its_former_name_with_a_warning(recorded):
    file, simulation = recorded
    for columns in (simulation, perilymph.read_recording(file)):
        assert "angular_depth_deg" not in list(columns)
        with pytest.warns(FutureWarning, match="'angular_depth_deg' is now called 'tip_angle_deg'"):
            former = columns["angular_depth_deg"]
        assert same_bits(former, columns["tip_angle_deg"])
    with pytest.raises(KeyError, match="angular_deg"):
        simulation["angular_deg"]


def test_a_recording_s_scenario_runs_to_the_same_bits_again(recorded, tmp_path):
    file, _ = recorded
    recording = perilymph.read_recording(file)
    (tmp_path / "again.toml").write_text(recording.facts["scenario_text"])
    again = perilymph.simulate(tmp_path / "again.toml")
    assert all(same_bits(again[name], column) for name, column in recording.columns.items())


@pytest.mark.parametrize("change", ["UPDATE meta SET value = 'another' WHERE key = 'scenario_name'",
                                    "UPDATE meta SET value = '0.5' WHERE key = 'peak_force_N'",
                                    "UPDATE meta SET value = value + 1 WHERE key = 'ticks'",
                                    "UPDATE event SET time_s = time_s + 1 WHERE rowid = 1"])
def test_a_recording_that_was_changed_is_only_read_on_request(recorded, tmp_path, change):
    file = tmp_path / "changed.insertion"
    shutil.copy(recorded[0], file)
    with sqlite3.connect(file) as database:
        database.execute(change)
    database.close()
    with pytest.raises(perilymph.Error, match="changed.insertion does not contain what was recorded.*check=False"):
        perilymph.read_recording(file)
    as_it_is = perilymph.read_recording(file, check=False)
    assert len(as_it_is["time_s"]) == len(recorded[1]["time_s"])


def test_recordings_that_cannot_be_read_are_refused(recorded, tmp_path):
    whole = recorded[0].read_bytes()
    changed = bytearray(whole)
    changed[len(changed) // 2] ^= 1
    contents = {"empty": b"", "short": whole[:50], "header": whole[:4096], "half": whole[:len(whole) // 2],
                "text": b"time_s,travel_mm\n" * 1000, "changed": bytes(changed)}
    for name, content in contents.items():
        (tmp_path / name).write_bytes(content)
        with pytest.raises(perilymph.Error, match=name):
            perilymph.read_recording(tmp_path / name)
    (tmp_path / "folder").mkdir()
    for place in (tmp_path / "folder", tmp_path / "missing", "/dev/null", ""):
        with pytest.raises(perilymph.Error):
            perilymph.read_recording(place)
    with pytest.raises(perilymph.Error, match="every_ms"):
        perilymph.read_recording(recorded[0], every_ms=float("nan"))
    with pytest.raises(TypeError):
        perilymph.read_recording(3)


STUDY = """
title = "Two arrays"
scenario = "mean-flex28"
seed = 3
samples = 2
depth = "scenario"

[cochleae]
mean = true
virtual = 1

[vary]
array = ["flex24", "flex28"]
stop_travel_mm = [3.0]
nodes = [40]
dt_ms = [5.0]

[ranges]
speed_mm_s = [0.5, 2.0]
"""


@pytest.fixture(scope="module")
def study_folder(cli, tmp_path_factory):
    folder = tmp_path_factory.mktemp("study")
    (folder / "study.toml").write_text(STUDY)
    cli("study", "run", folder / "study.toml", "--jobs", 2, "--out", folder / "out")
    return folder / "out"


def test_a_study_has_a_row_for_every_insertion(study_folder):
    study = perilymph.read_study(study_folder)
    columns = study.columns()
    assert (study.title, len(study)) == ("Two arrays", 8)
    assert all(column.shape == (8,) for column in columns.values())
    assert list(columns["number"]) == list(range(8))
    assert set(columns["array"]) == {"flex24", "flex28"}
    assert set(columns["cochlea"]) == {"mean", "virtual 1"}
    assert set(columns["stop_travel_mm"]) == {3.0}  # a setting with one value is a number, too
    assert (columns["speed_mm_s"] >= 0.5).all() and (columns["speed_mm_s"] <= 2.0).all()
    assert len(study.fingerprint) == 64 and study.notes == []
    assert STUDY.strip().splitlines()[0] in study.text


def test_a_study_s_columns_are_those_of_its_table(study_folder):
    columns = perilymph.read_study(study_folder / "study.sqlite").columns()
    lines = (study_folder / "insertions.csv").read_text().splitlines()
    rows = [dict(zip(lines[0].split(","), line.split(","))) for line in lines[1:]]
    for name in ("angle_deg", "depth_mm", "peak_mN"):
        assert columns[name] == pytest.approx([float(row[name]) for row in rows], rel=1e-5), name
    assert list(columns["ending"]) == [row["ending"] for row in rows]


def test_a_study_of_measures_that_were_changed_by_hand_says_so(cli, tmp_path):
    text = perilymph.Patient(a_mm=9.2, b_mm=6.9, label="P-017").text
    (tmp_path / "p.toml").write_text(text.replace("9.2", "9.3"))
    (tmp_path / "study.toml").write_text(
        'title = "One"\nscenario = "mean-flex28"\ndepth = "scenario"\n[cochleae]\npatients = ["p.toml"]\n'
        "[vary]\nnodes = [20]\ndt_ms = [10.0]\nstop_travel_mm = [0.5]\n")
    cli("study", "run", tmp_path / "study.toml", "--out", tmp_path / "out")
    study = perilymph.read_study(tmp_path / "out")
    assert len(study.notes) == 1 and study.notes[0].startswith("The measures of P-017 were changed by hand")
    assert list(study.columns()["cochlea"]) == ["p.toml (measures changed by hand)"]
    assert study.seal == "intact"  # of the results


def test_studies_that_cannot_be_read_are_refused(recorded, tmp_path):
    (tmp_path / "empty.sqlite").write_bytes(b"")
    for place in (tmp_path, tmp_path / "missing", tmp_path / "empty.sqlite", recorded[0], "/dev/null"):
        with pytest.raises(perilymph.Error):
            perilymph.read_study(place)


MEASURED = {**{key: {"value": value, "sd": 0.1, "ci95": [value - 0.25, value + 0.25]}
               for key, value in (("A_mm", 9.2), ("B_mm", 6.9), ("H_mm", 4.0), ("cdl_oc_mm", 34.0))},
            "axis_lps": [0.0, 0.6, 0.8], "center_lps_mm": [1.0, 2.0, 3.0], "round_window_lps_mm": [4.0, 5.0, 6.0],
            "side": "left", "flags": [], "warnings": ["A sentence."], "provenance": {"version": "0.1.0"}}


def test_measures_of_a_ct_become_a_patient(tmp_path):
    (tmp_path / "m.json").write_text(json.dumps(MEASURED))
    measures = perilymph.read_measures(tmp_path / "m.json")
    assert measures.values_mm["cdl_oc_mm"] == 34.0
    assert measures.intervals95_mm["A_mm"] == (8.95, 9.45)
    assert measures.axis_lps == pytest.approx([0.0, 0.6, 0.8])
    patient = measures.patient("P-1")
    assert (patient.label, patient.side, patient.a_mm, patient.b_mm, patient.h_mm) == ("P-1", "left", 9.2, 6.9, 4.0)
    assert (patient.a_sd_mm, patient.b_sd_mm, patient.h_sd_mm) == (0.1, 0.1, 0.1)


def test_a_cochlea_with_few_turns_has_no_duct_length(tmp_path):
    (tmp_path / "m.json").write_text(json.dumps({**MEASURED, "cdl_oc_mm": None, "cdl_oc_reason": "Few turns."}))
    measures = perilymph.read_measures(tmp_path / "m.json")
    assert measures.values_mm["cdl_oc_mm"] is None and measures.sds_mm["cdl_oc_mm"] is None
    assert (measures.values_mm["A_mm"], measures.duct_length_reason) == (9.2, "Few turns.")
    with pytest.raises(perilymph.Error, match="turns"):
        measures.patient()


def test_both_ears_are_read_by_a_function_of_their_own(tmp_path):
    (tmp_path / "both.json").write_text(json.dumps({"ears": [{**MEASURED, "side": "right"}, MEASURED]}))
    ears = perilymph.read_both_measures(tmp_path / "both.json")
    assert [ear.side for ear in ears] == ["right", "left"]
    assert [ear.warnings for ear in ears] == [["A sentence."], ["A sentence."]]
    with pytest.raises(perilymph.Error, match="both ears"):
        perilymph.read_measures(tmp_path / "both.json")
    (tmp_path / "m.json").write_text(json.dumps(MEASURED))
    one = perilymph.read_measures(tmp_path / "m.json")
    assert pickle.loads(pickle.dumps(one)) == one == ears[1] != ears[0] and len({one, *ears}) == 2
    assert f"A {MEASURED['A_mm']['value']:.2f} mm" in repr(one) and one.page() == MEASURED
    with pytest.raises(perilymph.Error, match="read_measures"):
        perilymph.read_both_measures(tmp_path / "m.json")


@pytest.mark.skipif(not (Path(os.environ["PERILYMPH_PROGRAMS"]) / "perilymph-ct-phantom").exists(),
                    reason="this build has no VTK and cannot read a CT")
def test_the_command_s_measures_of_a_scan_are_read(cli, tmp_path):
    phantom = Path(os.environ["PERILYMPH_PROGRAMS"]) / "perilymph-ct-phantom"
    subprocess.run([phantom, "1", tmp_path / "ct", "clinical"], check=True, capture_output=True)
    cli("ct", "measure", tmp_path / "ct", "--json", tmp_path / "m.json")
    said = json.loads((tmp_path / "m.json").read_text())
    measures = perilymph.read_measures(tmp_path / "m.json")
    for key in ("A_mm", "B_mm", "H_mm", "cdl_oc_mm"):
        assert (measures.values_mm[key], measures.sds_mm[key]) == (said[key]["value"], said[key]["sd"])
    assert list(measures.round_window_lps_mm) == said["round_window_lps_mm"]
    assert (measures.warnings, measures.flags) == (said["warnings"], said["flags"])
    assert measures.patient().a_mm == pytest.approx(said["A_mm"]["value"])
    done = subprocess.run([sys.executable, ROOT / "resources/examples/python/ct_measures.py", tmp_path / "ct", tmp_path / "a.png"], check=True,
                          env={**os.environ, "PATH": os.environ["PERILYMPH_PROGRAMS"]}, capture_output=True, text=True)
    assert re.search(rf"right A_mm +{said['A_mm']['value']:.2f} ", done.stdout) and (tmp_path / "a.png").exists()


@pytest.mark.parametrize("change", [{"A_mm": None}, {"A_mm": {"value": "9"}}, {"side": 3}, {"axis_lps": [1.0]}, {"flags": 5},
                                    {"B_mm": {"value": float("nan"), "sd": 0.1, "ci95": [1, 2]}}])
def test_measures_that_are_none_are_refused(tmp_path, change):
    (tmp_path / "m.json").write_text(json.dumps({**MEASURED, **change}))
    with pytest.raises(perilymph.Error, match="m.json"):
        perilymph.read_measures(tmp_path / "m.json")


@pytest.mark.parametrize("content", [b"", b"[]", b"3", b"{}", b"null", b"\xff\xfe", b"[" * 100_000, b" " * 2_000_000])
def test_files_that_are_no_measures_are_refused(tmp_path, content):
    (tmp_path / "m.json").write_bytes(content)
    with pytest.raises(perilymph.Error, match="m.json"):
        perilymph.read_measures(tmp_path / "m.json")
    with pytest.raises(perilymph.Error):
        perilymph.read_measures(tmp_path)
    with pytest.raises(perilymph.Error):
        perilymph.read_measures(tmp_path / "missing.json")
