# SPDX-License-Identifier: BSD-3-Clause
"""Electrode arrays: what their files say."""

import tomllib

import numpy as np
import pytest
from conftest import ROOT

import perilymph

FILES = {file.stem: file for file in (ROOT / "plugins/electrodes").glob("*/*.toml")}


def test_the_shipped_arrays_are_listed():
    assert perilymph.arrays() == sorted(FILES)


@pytest.mark.parametrize("name", sorted(FILES))
def test_an_array_is_what_its_file_says(name):
    said = tomllib.loads(FILES[name].read_text())
    array = perilymph.read_array(name)
    assert (array.name, array.maker) == (said["name"], said["maker"])
    assert array.length_mm == pytest.approx(said["length"]["value_mm"], rel=1e-15)
    assert array.insertable_mm == pytest.approx(said["insertable"]["value_mm"], rel=1e-15)
    assert array.contacts_from_tip_mm == pytest.approx(said["contacts"]["from_tip_mm"], rel=1e-15)
    assert array.has_stylet == ("stylet" in said)
    bending = said["bending"]
    place = np.linspace(0.0, array.length_mm, 101)
    expected = np.interp(place, bending["from_tip_mm"], bending["bending_N_m2"])
    assert array.bending_stiffness_Nm2(place) == pytest.approx(expected, rel=1e-12)


def test_the_taper_ends_at_the_diameters_of_the_file():
    array = perilymph.read_array("flex28")
    assert array.width_mm(array.length_mm) == pytest.approx(0.8)
    assert array.width_mm([1.0, 14.0, 28.0]) == pytest.approx([0.5 + 0.3 / 28, 0.65, 0.8])
    assert array.thickness_mm(14.0) == pytest.approx(0.6)
    assert array.width_mm(np.full((3, 2), 5.0)).shape == (3, 2)


def test_an_incompressible_round_rod_resists_torsion_as_two_thirds_of_bending():
    # G = E / 3 and J = 2 I, so GJ = 2 EI / 3.
    array = perilymph.read_array("flex28")
    place = 30.0
    assert array.bending_stiffness_across_Nm2(place) == pytest.approx(array.bending_stiffness_Nm2(place))
    assert array.torsional_stiffness_Nm2(place) == pytest.approx(2.0 / 3.0 * array.bending_stiffness_Nm2(place))


def test_a_straight_array_is_straight_and_a_precurved_one_is_not():
    assert perilymph.read_array("flex28").rest_curvature_per_mm(5.0) == 0.0
    assert perilymph.read_array("contour").rest_curvature_per_mm(5.0) > 0.1


def test_every_table_states_its_source():
    for table, source, confidence in perilymph.read_array("flex28").sources:
        assert table and source
        assert confidence in ("high", "medium", "low")
