# SPDX-License-Identifier: BSD-3-Clause
"""The array found in a phantom against its truth, a clinic's outcomes against what was measured and planned, as objects."""

import copy
import hashlib
import json
import os
import pickle
import subprocess
import sys
from math import erf, sqrt
from pathlib import Path

import numpy as np
import pytest
from conftest import ROOT, clinic_file

import perilymph
from perilymph import outcome

PROGRAMS = Path(os.environ["PERILYMPH_PROGRAMS"])
CLI, PHANTOM = PROGRAMS / "perilymph-cli", PROGRAMS / "perilymph-ct-phantom"
needs_phantom = pytest.mark.skipif(not PHANTOM.exists(), reason="this build has no VTK and cannot read a CT")


@pytest.fixture(scope="session")
def ear(tmp_path_factory):
    """A phantom whose array is found rightly."""
    place = tmp_path_factory.mktemp("phantom") / "ear"
    subprocess.run([PHANTOM, "implanted", "203", "flex24", place, "clinical"], check=True, capture_output=True)
    return place


@pytest.fixture(scope="session")
def found(ear):
    return outcome.find(ear / "after", "flex24", preop=ear / "before", csv=ear / "c.csv", program=CLI)


@needs_phantom
def test_contacts_are_where_the_phantom_has_them(ear, found):
    truth = json.loads((ear / "truth.json").read_text())
    there = np.array([each["position_lps_mm"] for each in truth["contacts"]])
    off = np.linalg.norm(found.positions_lps_mm - there, axis=1)
    columns = found.columns()
    assert len(found) == 12 and np.array_equal(columns["contact"], np.arange(1, 13))
    assert np.all(off < 4 * columns["error_mm"]) and np.all(columns["error_mm"] < 0.25)
    depth = found.angular_insertion_depth_deg
    assert depth.low95 < truth["angular_insertion_depth_deg"] < depth.high95
    length = found.inserted_length_mm
    assert length.low95 < truth["inserted_length_from_opening_mm"] < length.high95
    assert truth["inserted_length_from_opening_mm"] == truth["inserted_length_mm"] + 1.0
    assert (found.array, found.is_registered, found.has_fold) == ("flex24", True, False)
    assert found.side == truth.get("side", found.side) and found.registration_residual > 0
    # The course begins at the tip, beyond the most apical contact, and passes the contacts.
    along = np.linalg.norm(found.course_lps_mm[:, None] - found.positions_lps_mm, axis=2)
    assert found.course_lps_mm.shape[1] == 3 and np.all(along.min(axis=0) < 0.5)


@needs_phantom
def test_columns_are_the_table_of_the_command(ear, found):
    names = [line.split(",")[0] for line in (ear / "c-dictionary.csv").read_text().splitlines()[1:]]
    rows = [line.split(",") for line in (ear / "c.csv").read_text().splitlines()[1:]]
    columns = found.columns()
    assert list(columns) == names
    assert np.array_equal(columns["maker_electrode"], columns["contact"])  # MED-EL numbers from the tip, too
    for place, name in enumerate(names):
        if name in ("array", "side", "flags"):
            assert list(columns[name]) == [row[place] for row in rows], name
            continue
        stated = np.array([float(row[place] or "nan") for row in rows])
        assert np.allclose(columns[name].astype(float), stated, rtol=5e-3 if name.endswith("_Hz") else 1e-5, equal_nan=True), name
    frame = found.to_pandas()
    assert list(frame.columns) == names and len(frame) == 12 and frame["inside"].sum() == found.contacts_inside


@needs_phantom
def test_a_found_array_is_a_value(ear, found, tmp_path):
    again = outcome.find(ear / "after", "flex24", preop=ear / "before", program=CLI)
    assert again == found and hash(again) == hash(found)  # though it took another time
    other = outcome.find(ear / "after", "flexsoft", preop=ear / "before", program=CLI)
    assert other != found and other.flags and all(flag in repr(other) for flag in other.flags)
    for same in (pickle.loads(pickle.dumps(found)), copy.deepcopy(found)):
        assert same == found and np.array_equal(same.positions_lps_mm, found.positions_lps_mm)
    assert "'flex24'" in repr(found) and "contacts inside" in repr(found)
    found.columns()["angle_deg"][0] = 0
    found.page()["side"] = "neither"
    assert found.columns()["angle_deg"][0] > 100 and found.page()["side"] == found.side
    with pytest.raises(ValueError, match="read-only"):
        found.course_lps_mm[0, 0] = 0
    file = tmp_path / "c.json"
    file.write_text(json.dumps(found.page()))
    assert outcome.read(file) == found


@needs_phantom
def test_another_ear_and_one_series_given_twice_are_refused_with_the_command_s_sentence(ear):
    other = {"right": "left", "left": "right"}[json.loads((ear / "truth.json").read_text())["side"]]
    with pytest.raises(perilymph.Error, match=f"and --side is {other}"):
        outcome.find(ear / "after", "flex24", preop=ear / "before", side=other, program=CLI)
    with pytest.raises(perilymph.Error, match="are the same series"):
        outcome.find(ear / "before", "flex24", preop=ear / "before", program=CLI)
    with pytest.raises(perilymph.Error, match="no-such-array"):
        outcome.find(ear / "after", "no-such-array", program=CLI)


@needs_phantom
def test_the_example_draws_what_was_found(ear, tmp_path):
    environment = {**os.environ, "PATH": f"{PROGRAMS}:{os.environ['PATH']}"}
    done = subprocess.run([sys.executable, ROOT / "resources/examples/python/array_in_ct.py", ear / "after", "flex24", ear / "before", "out.png"],
                          cwd=tmp_path, env=environment, capture_output=True, text=True, timeout=60, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert "deg" in done.stdout and len(done.stdout.splitlines()) >= 13
    import matplotlib.image

    picture = matplotlib.image.imread(tmp_path / "out.png")[:, :, :3]
    assert picture.shape[1] == 640 and (np.ptp(picture, axis=2) > 0.3).mean() > 0.002


# A clinic of three ears without a CT: outcomes as the window saves them, beside plans of two simulations.
ANGLE, DEPTH = 400.0, 21.0


def contact(number, angle):
    estimate = {"value": angle, "sd": 4.0, "ci95": [angle - 7.84, angle + 7.84]}
    place = {"value": 1000.0, "ci95": [900.0, 1100.0]}
    return {"number": number, "position_lps_mm": [1.0 * number, 0.0, 0.0], "error_mm": 0.1, "seen_singly": True, "by_hand": False, "inside": True,
            "angle_deg": estimate, "modiolus_mm": 0.8, "outer_wall_mm": 0.2, "in_scala_tympani": 0.9, "greenwood_Hz": place,
            "spiral_ganglion_Hz": place}


def content(**changes):
    angle = {"value": ANGLE, "sd": 4.0, "ci95": [ANGLE - 7.84, ANGLE + 7.84]}
    page = {"format": 1, "array": "flex24", "side": "right", "angular_insertion_depth_deg": angle, "tip_angle_deg": ANGLE + 10,
            "inserted_length_mm": {"value": DEPTH, "sd": 0.3, "ci95": [DEPTH - 0.588, DEPTH + 0.588]}, "contacts_inside": 2, "outside_mm": 0.0,
            "fold": False, "translocation": {"probability": 0.1, "angle_deg": 0.0}, "registration": {"from": "this CT", "residual_mm": 0.0},
            "blur_fwhm_mm": 0.4, "flags": ["contacts_outside"], "contacts": [contact(1, ANGLE), contact(2, ANGLE - 40)],
            "course_lps_mm": [[0.0, 0.0, 0.0]], "surgery": {"array": "flex24", "opening": "round-window", "tool": "forceps", "stop_reason": "unknown"},
            "ct_age_days": 12, "seconds": 1.0, "version": "0"}
    return json.dumps({**page, **changes})


@pytest.fixture(scope="session")
def choices():
    """Names of openings and tools that an outcome may have, from the schema."""
    surgery = json.loads((ROOT / "resources/schemas/ct-contacts.schema.json").read_text())["properties"]["surgery"]["properties"]
    return {key: surgery[key]["enum"][0] for key in ("opening", "tool")}


@pytest.fixture(scope="session")
def library(tmp_path_factory, choices):
    place = tmp_path_factory.mktemp("clinic") / "library"
    (place / "patients").mkdir(parents=True)
    surgery = {"array": "flex24", **choices, "stop_reason": "unknown", "days_to_ct": 3}
    for code, outcomes in (("P-1", [content(surgery=surgery)]), ("P-2", [content(surgery=surgery, side="left")]), ("P-3", [content(surgery=surgery)])):
        patient = perilymph.Patient(a_mm=9.2, b_mm=6.8, h_mm=4.0, a_sd_mm=0.1, b_sd_mm=0.2, h_sd_mm=0.3, label=code)
        (place / f"patients/{code}-right.toml").write_text(patient.text)
        rows = [{"utc": "2026-02-20T10:00:00Z", "series_sha256": hashlib.sha256(code.encode()).hexdigest(), "content": each} for each in outcomes]
        (place / f"patients/{code}-right.json").write_text(json.dumps(
            {"format": 2, "tags": [], "notes": "", "archived": False, "changed_by_hand": False, "scans": [], "versions": [], "plans": [],
             "insertions": [], "outcomes": rows}))
        if code == "P-3":
            continue
        folder = place / "plans" / code
        folder.mkdir(parents=True)
        perilymph.plan(patient, ["flex24"], samples=2, all_samples=True, draws_file=folder / "draws.sqlite")
        (folder / "patient.toml").write_text(patient.text)
        (folder / "plan.toml").write_text('made = "2026-01-03T10:00:00Z"\narrays = ["flex24"]\nscenario = "surgery-flex28"\ndraws = 2\nseed = 1\n'
                                          "shown_draws = 2\nis_complete = true\n")
    return place


def test_outcomes_are_what_was_measured_beside_what_was_planned(library, tmp_path):
    clinic = outcome.outcomes(library, folder=tmp_path / "out", program=CLI)
    assert len(clinic) == 1 and clinic.left_out == {"ears": 2, "unreadable": 0, "impossible": 1, "without_plan": 1, "twice": 0, "without_day": 0}
    assert any("P-2" in note and "left" in note for note in clinic.notes) and any("P-3" in note and "no plan" in note for note in clinic.notes)
    columns = clinic.columns()
    assert (columns["depth_mm"][0], columns["angle_deg"][0], columns["year"][0]) == (DEPTH, ANGLE, 2026)
    # The place of a value among two simulations, each widened by its error, of a further value.
    plan = perilymph.plan(perilymph.read_patient(str(library / "patients/P-1-right.toml")), ["flex24"], samples=2, all_samples=True)
    assert np.allclose(columns["planned_depth_mm"][0], plan.arrays[0].bands()["depth_mm"], atol=1e-3)
    drawn = plan.insertions()["depth_mm"]
    below = sum(0.5 * (1 + erf((DEPTH - each) / 0.3 / sqrt(2))) for each in drawn)
    assert abs(columns["depth_percentile"][0] - (below + 0.5) / 3) < 1e-4
    everything, flex24 = clinic.arrays
    assert everything.array == "" and flex24.array == "flex24" and everything.depth_in_90.ears == 1
    assert sum(everything.depth_percentiles) == 1 and everything.depth_percentiles[min(9, int(10 * columns["depth_percentile"][0]))] == 1
    assert everything.depth_in_90.inside == (0.05 <= columns["depth_percentile"][0] <= 0.95)
    assert everything.depth_difference_mm is None
    assert np.isnan(columns["log_p_clinic"][0]) and columns["evidence"][0] == "none" and clinic.resistance.not_informative == 1
    frame = clinic.to_pandas()
    assert len(frame) == 1 and frame["planned_depth_mm_p50"][0] == columns["planned_depth_mm"][0, 2]
    assert (tmp_path / "out/outcomes.csv").exists()


def test_outcomes_are_a_value_and_name_no_patient(library, tmp_path):
    clinic = outcome.outcomes(library, folder=tmp_path / "out", program=CLI)
    read = outcome.read_outcomes(tmp_path / "out/outcomes.json")
    assert read == clinic and hash(read) == hash(clinic) and read.notes == () and pickle.loads(pickle.dumps(clinic)) == clinic
    assert repr(clinic) == "<perilymph.outcome.Outcomes: 1 ears, 2 left out>" and "P-1" not in json.dumps(clinic.page())
    (tmp_path / "none/patients").mkdir(parents=True)
    empty = outcome.outcomes(tmp_path / "none", program=CLI)
    assert len(empty) == 0 != len(clinic) and empty != clinic and len(empty.to_pandas()) == 0
    with pytest.raises(perilymph.Error, match="resistance is not offered"):
        outcome.outcomes(library, resistance=tmp_path / "clinic.json", program=CLI)
    with pytest.raises(perilymph.Error, match="no folder 'patients'"):
        outcome.outcomes(tmp_path, program=CLI)


def test_a_plan_states_the_depth_with_a_clinic_s_resistance(cli, tmp_path):
    patient = perilymph.Patient(a_mm=9.2, b_mm=6.8, h_mm=4.0)
    file = clinic_file(tmp_path / "clinic.json")
    plan = perilymph.plan(patient, ["flex24"], samples=2, all_samples=True, clinic_resistance=file)
    assert plan.clinic_resistance == hashlib.sha256(file.read_bytes()).hexdigest()
    # Two simulations amount to fewer than 100: no depth is stated.
    with pytest.raises(perilymph.Error, match="the 2 simulations of FLEX24 amount to fewer than 100.*Plan with more 'samples', 4096 at most"):
        plan.arrays[0].in_clinic()
    # Where no number is named, as many are run as weights need, and 64 without.
    asked = []

    def stop_at_once(done, of):
        asked.append(of)
        raise RuntimeError("enough")

    for resistance, usual in ((file, 512), (None, 64)):
        with pytest.raises(RuntimeError, match="enough"):
            perilymph.plan(patient, ["flex24"], clinic_resistance=resistance, progress=stop_at_once)
        assert asked[-1] == usual
    shipped = perilymph.plan(patient, ["flex24"], samples=2, all_samples=True)
    assert shipped.clinic_resistance == "" and shipped.arrays[0].in_clinic() == {}
    assert np.array_equal(shipped.arrays[0].bands()["peak_mN"], plan.arrays[0].bands()["peak_mN"])
    # Of a plan with enough simulations, as its plan.json states it.
    cli("plan", "--patient", "measured", "--arrays", "flex24", "--samples", 2, "--all-samples", "--clinic-resistance", file, "--out", tmp_path / "plan")
    page = json.loads((tmp_path / "plan/plan.json").read_text())
    band = dict(zip(("p5", "p25", "median", "p75", "p95"), (18.0, 19.0, 20.0, 21.0, 22.0)))
    page["arrays"][0]["in_clinic"] = {"depth_mm": band, "effective_simulations": 151.0}
    (tmp_path / "plan/plan.json").write_text(json.dumps(page))
    stored = perilymph.read_plan(tmp_path / "plan/plan.json")
    assert stored.clinic_resistance == plan.clinic_resistance
    in_clinic = stored.arrays[0].in_clinic()
    assert np.array_equal(in_clinic["depth_mm"], [18, 19, 20, 21, 22]) and in_clinic["effective_simulations"] == 151
    file.write_text(file.read_text().replace("0.165", "0.2"))
    with pytest.raises(perilymph.Error, match="was changed after the program wrote it"):
        perilymph.plan(patient, ["flex24"], samples=2, clinic_resistance=file)
    with pytest.raises(TypeError, match="clinic_resistance"):
        perilymph.plan(patient, ["flex24"], samples=2, clinic_resistance=3)


@pytest.mark.parametrize("wrong", ["", "[]", "{}", '{"format": 2}', "[" * 100000, content(format=2), content(side=3), content(contacts=3),
                                   content(contacts=[{}]), content(fold=1), content(angular_insertion_depth_deg={"value": 1}),
                                   content(course_lps_mm=[[1, 2]]), content(tip_angle_deg="NaN")])
def test_a_file_that_is_no_outcome_is_named(tmp_path, wrong):
    (tmp_path / "wrong.json").write_text(wrong)
    for read in (outcome.read, outcome.read_outcomes):
        with pytest.raises(perilymph.Error, match="wrong.json"):
            read(tmp_path / "wrong.json")
    with pytest.raises(perilymph.Error, match="absent.json"):
        outcome.read(tmp_path / "absent.json")
