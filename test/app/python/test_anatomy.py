# SPDX-License-Identifier: BSD-3-Clause
"""The cochlea: what was measured comes back, geometry is consistent, and the command line says the same."""

import json

import numpy as np
import pytest
from conftest import same_bits, table

import perilymph


def test_a_cochlea_built_from_diameters_has_them():
    cochlea = perilymph.Cochlea(perilymph.Patient(a_mm=9.0, b_mm=6.8, h_mm=4.1))
    measures = cochlea.measures()
    assert measures["A_mm"] == pytest.approx(9.0, abs=0.01)
    assert measures["B_mm"] == pytest.approx(6.8, abs=0.01)
    assert measures["H_mm"] == pytest.approx(4.1, abs=0.01)


def test_measures_errors_and_sections_are_those_of_the_command_line(cli, tmp_path):
    cli("anatomy", "--a-mm", 9.0, "--b-mm", 6.8, "--json", tmp_path / "a.json", "--sections", tmp_path / "s.csv")
    said = json.loads((tmp_path / "a.json").read_text())
    cochlea = perilymph.Cochlea(perilymph.Patient(a_mm=9.0, b_mm=6.8))
    measures, errors = cochlea.measures(), cochlea.measure_errors()
    assert len(measures) > 8
    for key, value in measures.items():
        assert value == said[key], key
        assert errors[key] == said["derived"][key]["band"], key
    columns = table(tmp_path / "s.csv")
    sections = cochlea.sections(max_step_deg=columns["angle_deg"][1])
    assert list(sections) == list(columns)
    for name, column in columns.items():
        assert same_bits(sections[name], column), name


def test_larger_errors_of_measurement_give_wider_errors_of_measures():
    def with_errors(sd_mm):
        patient = perilymph.Patient(a_mm=9.0, b_mm=6.8, a_sd_mm=sd_mm, b_sd_mm=sd_mm)
        return perilymph.Cochlea(patient).measure_errors()["A_mm"]

    # A is what was measured, so its 95 % interval is that of the measurement.
    assert with_errors(0.1) == pytest.approx(0.196, rel=0.05)
    assert with_errors(0.3) == pytest.approx(0.588, rel=0.05)


def test_points_have_the_shape_of_the_angles(mean):
    assert mean.axis(90.0).shape == (3,)
    assert mean.axis([0.0, 90.0]).shape == (2, 3)
    assert mean.axis(np.zeros((2, 4, 0))).shape == (2, 4, 0, 3)
    assert mean.wall(np.zeros((2, 4)), [0.0, 90.0, 180.0]).shape == (2, 4, 3, 3)
    assert mean.distance(np.zeros((5, 2, 3)))["distance_mm"].shape == (5, 2)


def test_angles_of_points_on_the_axis_are_those_asked_for(mean):
    angle_deg = np.linspace(5.0, 800.0, 60)
    points = mean.axis(angle_deg)
    turned = np.rad2deg(np.arctan2(points[:, 1], points[:, 0]))
    assert (turned - angle_deg) % 360.0 == pytest.approx(0.0, abs=1e-9) or np.allclose(
        np.cos(np.deg2rad(turned - angle_deg)), 1.0)
    assert mean.distance(points)["angle_deg"] == pytest.approx(angle_deg, abs=1e-6)


def test_the_wall_is_at_distance_zero_and_the_center_inside(mean):
    angle_deg = np.linspace(20.0, 500.0, 25)
    wall = mean.wall(angle_deg, np.arange(0.0, 360.0, 45.0))
    # The field rounds the wall: within 39 um everywhere (README of the module anatomy).
    assert np.abs(mean.distance(wall)["distance_mm"]).max() < 0.039
    assert mean.distance(mean.axis(angle_deg))["distance_mm"].min() > 0.2


def test_the_normal_leads_from_the_wall_into_the_lumen_at_unit_rate(mean):
    points = mean.axis(np.linspace(30.0, 300.0, 10)) + [0.0, 0.0, -0.1]
    here = mean.distance(points)
    step_mm = 1e-3
    there = mean.distance(points + step_mm * here["normal"])
    rate = (there["distance_mm"] - here["distance_mm"]) / step_mm
    assert rate == pytest.approx(np.linalg.norm(here["normal"], axis=-1) ** 2, abs=0.02)


def test_outside_of_the_opening_and_on_the_modiolar_axis_there_is_no_wall(mean):
    opening = mean.opening()
    found = mean.distance([opening["origin_mm"] + opening["out"], [0.0, 0.0, 1.0]])
    assert np.isnan(found["distance_mm"]).all()
    assert np.isnan(found["normal"]).all()


def test_the_opening_is_a_right_handed_frame_before_the_round_window(mean):
    opening = mean.opening()
    frame = np.array([opening["outward"], opening["vertical"], opening["out"]])
    assert frame @ frame.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(frame) == pytest.approx(1.0)
    window = mean.axis(0.0)
    assert opening["origin_mm"] - window == pytest.approx(mean.lead_in_mm * opening["out"], abs=1e-9)


def test_lengths_along_the_center_are_those_of_the_points(mean):
    sections = mean.sections(max_step_deg=1.0)
    points = mean.axis(sections["angle_deg"])
    length = np.linalg.norm(np.diff(points, axis=0), axis=1).sum()
    assert sections["center_length_mm"][-1] == pytest.approx(length, rel=1e-3)


def test_the_basilar_membrane_is_between_floor_and_roof(mean):
    sections = mean.sections(max_step_deg=15.0)
    inside = sections["angle_deg"] < mean.measured_angle_deg
    height = mean.membrane(sections["angle_deg"][inside])[:, 2]
    assert (height > sections["floor_z_mm"][inside]).all()
    assert (height < sections["roof_z_mm"][inside] + 0.05).all()


def test_a_left_ear_is_mirrored():
    def of(side):
        return perilymph.Cochlea(perilymph.Patient(a_mm=9.0, b_mm=6.8, side=side))

    assert of("left").patient.side == "left"
    assert same_bits(of("left").axis([100.0]), of("right").axis([100.0]))


def test_shipped_patients_and_lengths_give_cochleae():
    assert {"average", "small", "large"} <= set(perilymph.patients())
    small, large = (perilymph.Cochlea(perilymph.read_patient(name)) for name in ("small", "large"))
    assert small.measures()["A_mm"] < large.measures()["A_mm"]
    lengths = perilymph.Patient.from_lengths(st_length_mm=35.58, rw_width_mm=1.94, rw_height_mm=1.85)
    published = perilymph.Cochlea(lengths)
    assert published.anatomy == "published"
    assert published.measures() == perilymph.Cochlea.named("published").measures()


def test_a_patient_s_text_reads_back_as_the_patient(tmp_path):
    patient = perilymph.Patient(a_mm=9.1, b_mm=6.9, h_mm=4.0, a_sd_mm=0.1, b_sd_mm=0.2, h_sd_mm=0.3, side="left",
                                label="P-017")
    (tmp_path / "p.toml").write_text(patient.text)
    read = perilymph.read_patient(tmp_path / "p.toml")
    for name in ("label", "side", "a_mm", "b_mm", "h_mm", "a_sd_mm", "b_sd_mm", "h_sd_mm"):
        assert getattr(read, name) == getattr(patient, name), name


def test_a_rare_measure_is_told():
    assert perilymph.Patient(a_mm=9.2, b_mm=6.9).unusual() == []
    assert any("A is 10.3 mm" in sentence for sentence in perilymph.Patient(a_mm=10.3, b_mm=6.9).unusual())


def values(patient):
    return (patient.label, patient.side, patient.a_mm, patient.b_mm, patient.h_mm,
            patient.a_sd_mm, patient.b_sd_mm, patient.h_sd_mm)


def test_a_patient_s_seal_breaks_with_any_byte_that_changes_a_value(tmp_path):
    patient = perilymph.Patient(a_mm=9.2, b_mm=6.9, h_mm=4.0, a_sd_mm=0.15, b_sd_mm=0.15, side="left", label="P-017")
    assert patient.seal == "intact"
    file = tmp_path / "p.toml"
    file.write_text(patient.text)
    read = perilymph.read_patient(file)
    assert read.seal == "intact" and values(read) == values(patient)
    changed = 0
    for place in range(len(patient.text)):
        for byte in b"18#":
            content = bytearray(patient.text, "ascii")
            content[place] = byte
            file.write_bytes(content)
            try:
                other = perilymph.read_patient(file)
            except perilymph.Error:
                continue
            assert other.seal == "changed" or values(other) == values(patient), bytes(content)
            changed += other.seal == "changed"
    assert changed > 150  # most of the seal's 64 digits, and those of the values


def test_a_changed_patient_stays_changed_in_text_plan_and_cochlea(tmp_path):
    file = tmp_path / "p.toml"
    file.write_text(perilymph.Patient(a_mm=9.2, b_mm=6.9).text.replace("9.2", "9.3"))
    changed = perilymph.read_patient(file)
    assert (changed.seal, changed.a_mm) == ("changed", pytest.approx(9.3))
    file.write_text(changed.text)
    assert perilymph.read_patient(file).seal == "changed"
    assert perilymph.Cochlea(changed).patient.seal == "changed"
    assert perilymph.plan(changed, ["flex24"], samples=1).patient.seal == "changed"


def test_a_patient_of_an_earlier_version_has_no_seal(tmp_path):
    file = tmp_path / "p.toml"
    for program, seal in (("perilymph 0.2.0", "absent"), ("Other 7.1", "absent"), ("perilymph 0.3.0", "changed")):
        file.write_text(f'a_mm = 9.2\nb_mm = 6.9\nmeasured_with = "{program}"\n')
        assert perilymph.read_patient(file).seal == seal, program
    file.write_text("a_mm = 9.2\nb_mm = 6.9\n")  # by a person
    assert perilymph.read_patient(file).seal == "absent"
