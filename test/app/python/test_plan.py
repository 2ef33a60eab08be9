# SPDX-License-Identifier: BSD-3-Clause
"""A plan is that of the command line, and its bands are what its insertions say."""

import json
import threading

import numpy as np
import pytest

import perilymph

ARRAYS = ["flex24", "flex20"]
REQUEST = {"arrays": ARRAYS, "samples": 3, "seed": 5, "jobs": 2}


@pytest.fixture(scope="module")
def made():
    return perilymph.plan(patient(), **REQUEST)


def patient():
    return perilymph.Patient(a_mm=9.2, b_mm=6.9, h_mm=4.0, a_sd_mm=0.15, b_sd_mm=0.15, h_sd_mm=0.2, label="P-017")


@pytest.fixture(scope="module")
def folder(cli, tmp_path_factory):
    """The folder of the same plan, made by the command line."""
    place = tmp_path_factory.mktemp("plan")
    (place / "p.toml").write_text(patient().text)
    cli("plan", "--patient", place / "p.toml", "--arrays", *ARRAYS, "--samples", 3, "--seed", 5, "--jobs", 2,
        "--out", place / "out")
    return place / "out"


def tables(plan):
    """Everything that a plan says in numbers."""
    return [each for array in plan.arrays
            for part in (array.bands(), array.probabilities(), array.force(), array.contacts(), array.influence())
            for each in part.items()]


def test_a_plan_is_that_of_the_command_line(made, folder):
    read = perilymph.read_plan(folder)
    assert [array.name for array in made.arrays] == [array.name for array in read.arrays] == ["FLEX24", "FLEX20"]
    for (name, ours), (other, theirs) in zip(tables(made), tables(read)):
        assert name == other and np.array_equal(ours, theirs), name
    assert (read.seed, made.seed) == (5, 5)
    assert made.limits == read.limits and made.sources == read.sources and made.program == read.program
    assert made.patient.a_sd_mm == read.patient.a_sd_mm == 0.15
    # (n - 1) / (n + 1) of what is to come lies between the extremes of n; 95 % of the plans' frictions are stated
    assert made.bands_hold == read.bands_hold == "lowest to highest of 3 simulations over friction 0.08 to 0.33"


def test_a_plan_that_was_changed_by_hand_has_no_number(folder, tmp_path):
    read = perilymph.read_plan(folder)
    assert read.seal == "intact" and read.number == json.loads((folder / "plan.json").read_text())["plan"]
    text = (folder / "plan.json").read_text()
    (tmp_path / "plan.json").write_text(text.replace('"A_mm": 9.2', '"A_mm": 9.3'))
    changed = perilymph.read_plan(tmp_path)
    assert (changed.seal, changed.number) == ("changed", "")
    (tmp_path / "plan.json").write_text(text.replace('"side": "right"', '"side": "lefs"'))
    with pytest.raises(perilymph.Error, match="it must be right or left"):
        perilymph.read_plan(tmp_path)


def test_bands_are_those_of_the_file(folder):
    said = json.loads((folder / "plan.json").read_text())
    array = perilymph.read_plan(folder / "plan.json").arrays[0]
    of_file = next(each for each in said["arrays"] if each["array"] == "flex24")
    for name, band in array.bands().items():
        assert list(band) == [of_file[name][key] for key in ("p5", "p25", "median", "p75", "p95")], name
    for name, (value, low, high) in array.probabilities().items():
        assert [value, [low, high]] == [of_file["probability"][name]["value"], of_file["probability"][name]["ci95"]], name
    with pytest.warns(FutureWarning, match="'full_insertion' is now called 'intended_depth_reached'"):
        assert (array.probabilities()["full_insertion"] == array.probabilities()["intended_depth_reached"]).all()
    assert list(array.force()["depth_mm"]) == [each["depth_mm"] for each in of_file["force"]]
    assert array.force()["force_mN"].shape == (len(of_file["force"]), 5)
    assert array.contacts()["angle_deg"].shape == (len(of_file["contacts"]), 5)
    assert list(array.influence()["input"]) == [each["input"] for each in of_file["influence"]]


def test_every_insertion_of_a_plan_is_a_row(made):
    rows = made.insertions()
    assert all(column.shape == (6,) for column in rows.values())
    assert list(rows["array"]) == ARRAYS * 3
    assert list(rows["draw"]) == [1, 1, 2, 2, 3, 3]
    for array in made.arrays:
        angle = rows["angle_deg"][rows["array"] == array.array]
        assert array.bands()["angle_deg"][2] == pytest.approx(np.median(angle), rel=1e-5)
        assert array.draws == 3
        for force in ("end_mN", "force_after_1s_mN", "force_after_10s_mN"):
            values = rows[force][rows["array"] == array.array]
            assert array.bands()[force][2] == pytest.approx(np.median(values), rel=1e-5), force
            assert array.force()["draws"][-1] >= 1  # as deep as any simulation went


def test_an_interrupted_plan_continues_to_the_same_bits(made, tmp_path):
    seen = []

    def stop(done, every):
        seen.append((done, every))
        if done >= 2:
            raise RuntimeError("enough")

    with pytest.raises(RuntimeError, match="enough"):
        perilymph.plan(patient(), **REQUEST, draws_file=tmp_path / "draws.sqlite", progress=stop)
    assert seen[-1][1] == 6
    again = perilymph.plan(patient(), **REQUEST, draws_file=tmp_path / "draws.sqlite")
    for (name, ours), (_, theirs) in zip(tables(made), tables(again)):
        assert np.array_equal(ours, theirs), name


def test_progress_is_told_in_the_thread_that_asked(made):
    threads = set()
    perilymph.plan("average" if perilymph.read_patient("average").a_mm else patient(), arrays=["flex20"], samples=1,
                   progress=lambda done, every: threads.add(threading.get_ident()))
    assert threads <= {threading.get_ident()}


@pytest.mark.parametrize("change", [{"samples": 0}, {"samples": -1}, {"samples": 10**6}, {"jobs": -1}, {"jobs": 1000},
                                    {"seed": -1}, {"arrays": []}, {"arrays": ["no-such-array"]}, {"arrays": ["flex20"] * 33},
                                    {"scenario": "no-such-scenario"}, {"draws_file": "/nonexistent/draws.sqlite"}])
def test_a_plan_that_cannot_be_made_is_refused(change):
    with pytest.raises(perilymph.Error):
        perilymph.plan(patient(), **{**REQUEST, **change})


@pytest.mark.parametrize("samples", [0, 1, 15, 4097])
def test_fewer_than_sixteen_simulations_are_refused_with_the_reason(monkeypatch, samples):
    monkeypatch.delenv("PERILYMPH_FEW_DRAWS")
    with pytest.raises(perilymph.Error, match=f"A plan of {samples} simulations is too .*Choose 16 to 4096"):
        perilymph.plan(patient(), **{**REQUEST, "samples": samples})


@pytest.mark.parametrize("change", [{"samples": 1.5}, {"samples": "4"}, {"arrays": "flex20"}, {"arrays": 3}, {"arrays": [3]},
                                    {"seed": 10**30}, {"jobs": None}])
def test_wrong_types_are_type_errors(change):
    with pytest.raises(TypeError):
        perilymph.plan(patient(), **{**REQUEST, **change})


def test_a_patient_without_diameters_is_refused():
    lengths = perilymph.Patient.from_lengths(st_length_mm=35.58, rw_width_mm=1.94, rw_height_mm=1.85)
    with pytest.raises(perilymph.Error, match="A and B"):
        perilymph.plan(lengths, arrays=["flex20"], samples=1)


@pytest.mark.parametrize("content", [b"", b"{}", b"[]", b"\xff", b"{\"arrays\": 3}"])
def test_files_that_are_no_plan_are_refused(tmp_path, content):
    (tmp_path / "plan.json").write_bytes(content)
    for place in (tmp_path, tmp_path / "plan.json", tmp_path / "missing"):
        with pytest.raises(perilymph.Error):
            perilymph.read_plan(place)


def test_a_plan_with_one_byte_changed_is_read_or_refused_and_nothing_else(folder, tmp_path):
    whole = (folder / "plan.json").read_bytes()
    file = tmp_path / "plan.json"
    for at in range(0, len(whole), max(1, len(whole) // 200)):
        file.write_bytes(whole[:at] + b"9" + whole[at + 1:])
        try:
            perilymph.read_plan(file)
        except perilymph.Error:
            pass
