# SPDX-License-Identifier: BSD-3-Clause
"""Bad input is refused with the engine's sentence; nothing but Python's own exceptions leaves the module."""

import os
import signal
import subprocess
import sys
import warnings

import numpy as np
import pytest
from conftest import SHORT

import perilymph

NAN, INF = float("nan"), float("inf")


def test_an_error_is_a_value_error_with_a_sentence():
    assert issubclass(perilymph.Error, ValueError)
    with pytest.raises(perilymph.Error) as caught:
        perilymph.read_scenario("no-such-scenario")
    sentence = str(caught.value)
    assert "no-such-scenario" in sentence and "contour-published" in sentence and sentence.endswith(".")
    assert type(caught.value).__module__ == "perilymph"


@pytest.mark.parametrize("values", [
    {"a_mm": NAN, "b_mm": 6.8}, {"a_mm": 9.0, "b_mm": INF}, {"a_mm": 30.0, "b_mm": 6.8}, {"a_mm": 9.0, "b_mm": -6.8},
    {"a_mm": 9.0, "b_mm": 6.8, "h_mm": NAN}, {"a_mm": 9.0, "b_mm": 6.8, "a_sd_mm": 0.1},
    {"a_mm": 9.0, "b_mm": 6.8, "a_sd_mm": NAN, "b_sd_mm": 0.1}, {"a_mm": 9.0, "b_mm": 6.8, "a_sd_mm": 0.1, "b_sd_mm": -1},
    {"a_mm": 9.0, "b_mm": 6.8, "a_sd_mm": 0.1, "b_sd_mm": 0.1, "h_sd_mm": 0.1}, {"a_mm": 9.0, "b_mm": 6.8, "side": "top"}])
def test_measures_that_no_patient_has_are_refused(values):
    with pytest.raises(perilymph.Error):
        perilymph.Patient(**values)


@pytest.mark.parametrize("values", [{"a_mm": "9", "b_mm": 6.8}, {"a_mm": 9.0}, {"a_mm": None, "b_mm": 6.8},
                                    {"a_mm": 9.0, "b_mm": 6.8, "label": 3}, {"A": 9.0, "b_mm": 6.8}])
def test_wrong_types_are_type_errors(values):
    with pytest.raises(TypeError):
        perilymph.Patient(**values)


@pytest.mark.parametrize("angles", [NAN, INF, -1.0, 5000.0, [0.0, NAN]])
def test_angles_beyond_the_cochlea_are_refused(mean, angles):
    for call in (mean.axis, mean.membrane, lambda one: mean.wall(one, 0.0)):
        with pytest.raises(perilymph.Error, match="angle_deg"):
            call(angles)


@pytest.mark.parametrize("points", ["text", [["a", "b", "c"]], [1j, 2j, 3j], [None, None, None], object(), {}, True])
def test_points_that_are_no_real_numbers_are_type_errors(mean, points):
    with pytest.raises(TypeError, match="points_mm"):
        mean.distance(points)


@pytest.mark.parametrize("points", [0.0, [], [1.0, 2.0], np.zeros((3, 4)), [NAN, 0.0, 0.0], [INF, 0.0, 0.0], [1e300, 0.0, 0.0]])
def test_points_of_another_shape_and_without_a_place_are_refused(mean, points):
    with pytest.raises(perilymph.Error, match="points_mm"):
        mean.distance(points)


def test_a_view_of_any_size_is_refused_before_it_is_copied(mean):
    huge = np.broadcast_to(np.zeros(3), (10**12, 3))
    with pytest.raises(perilymph.Error, match="one call takes"):
        mean.distance(huge)
    with pytest.raises(perilymph.Error, match="one call takes"):
        mean.axis(np.broadcast_to(1.0, (10**6, 10**6)))
    with pytest.raises(perilymph.Error, match="Divide"):
        mean.wall(np.zeros(10**5), np.zeros(10**5))
    with pytest.raises(perilymph.Error):
        perilymph.simulate("contour-published", SHORT, depths_mm=np.broadcast_to(1.0, (10**12,)))


def test_no_points_are_no_error(mean):
    assert mean.distance(np.zeros((0, 3)))["normal"].shape == (0, 3)


def test_text_cannot_be_a_point_in_an_array_of_arrays(mean):
    with pytest.raises((TypeError, ValueError)):
        mean.distance([[1.0, 2.0, 3.0], [1.0, 2.0]])


@pytest.mark.parametrize("read", [perilymph.read_array, perilymph.read_patient, perilymph.read_scenario])
def test_files_that_cannot_be_read_are_refused(read, tmp_path):
    (tmp_path / "empty.toml").write_bytes(b"")
    (tmp_path / "noise.toml").write_bytes(bytes(range(256)) * 10)
    (tmp_path / "folder.toml").mkdir()
    for name in ("empty.toml", "noise.toml", "folder.toml", "missing.toml", "missing/none.toml"):
        if (read, name) == (perilymph.read_scenario, "empty.toml"):
            continue  # every key of a scenario has a default
        with pytest.raises(perilymph.Error, match="."):
            read(tmp_path / name)
    for given in (3, None, 1.5, ["a"], b"bytes\0zero", "zero\0inside"):
        with pytest.raises((TypeError, perilymph.Error)):
            read(given)


def test_a_name_with_bytes_that_are_no_text_is_told_as_escapes(tmp_path):
    with pytest.raises(perilymph.Error, match=r"\\xff"):
        perilymph.read_array(os.fsdecode(os.fsencode(tmp_path) + b"/\xff.toml"))


@pytest.mark.parametrize("overrides", [{"nodes": NAN}, {"nodes": 10**30}, {"nodes": "many"}, {"speed_mm_s": INF},
                                       {"speed_mm_s": -1.0}, {"no_such_key": 1}, {"array": "no-such-array"}, {"nodes": True},
                                       {"": 1}, {"array": ""}, {"nodes\n": 3}, {"nodes": [30]}, {"relaxation_fraction": [2.0]}])
def test_values_that_a_scenario_cannot_have_are_refused(overrides):
    with pytest.raises(perilymph.Error):
        perilymph.read_scenario("contour-published", overrides)
    with pytest.raises(perilymph.Error):
        perilymph.read_scenario("contour-published").with_values(overrides)


@pytest.mark.parametrize("overrides", [[("nodes", 30)], "nodes=30", {3: 1}, {"nodes": None}])
def test_overrides_are_a_dict_of_plain_values(overrides):
    with pytest.raises(TypeError):
        perilymph.read_scenario("contour-published", overrides)


def test_a_key_that_a_scenario_lacks_is_a_key_error():
    with pytest.raises(KeyError):
        perilymph.read_scenario("contour-published")["no_such_key"]


@pytest.mark.parametrize("keywords", [{"every_ms": NAN}, {"every_ms": -1.0}, {"every_ms": INF}, {"depths_mm": [NAN]},
                                      {"depths_mm": [-1.0]}, {"record": "/nonexistent/a.insertion"}, {"record": "."}])
def test_options_of_a_simulation_are_checked(keywords):
    with pytest.raises(perilymph.Error):
        perilymph.simulate("contour-published", SHORT, **keywords)


def test_a_tip_that_never_enters_is_an_error_with_the_remedy():
    with pytest.raises(perilymph.Error, match="did not enter the opening.*start_inside_mm"):
        perilymph.simulate("contour-published", {"nodes": 50, "start_inside_mm": 0, "residual_curvature_fraction": 1})


def test_an_old_name_of_a_key_is_a_warning_of_python(tmp_path):
    text = perilymph.read_scenario("contour-published").text
    assert "residual_curvature_fraction" in text
    (tmp_path / "old.toml").write_text(text.replace("residual_curvature_fraction", "residual_curvature_share"))
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        perilymph.read_scenario(tmp_path / "old.toml")
    assert any("residual_curvature_fraction" in str(each.message) for each in caught)


INTERRUPTED = """
import os, signal, sys, threading
import perilymph

def interrupt():
    sys.stdin.readline()                      # the insertion runs when the recording has rows
    os.kill(os.getpid(), signal.SIGINT)

threading.Thread(target=interrupt, daemon=True).start()
print("begins", flush=True)
try:
    perilymph.simulate("contour-published", {"speed_mm_s": 0.01}, record=sys.argv[1])
except KeyboardInterrupt:
    print("interrupted", flush=True)
"""


def test_ctrl_c_ends_an_insertion_and_closes_its_recording(tmp_path, cli):
    file = tmp_path / "a.insertion"
    # 1,650 s of virtual time: without the interruption it would go on for many minutes.
    with subprocess.Popen([sys.executable, "-c", INTERRUPTED, str(file)], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                          text=True) as process:
        assert process.stdout.readline() == "begins\n"
        while not file.exists():
            assert process.poll() is None
        process.stdin.write("\n")
        process.stdin.flush()
        assert process.stdout.readline() == "interrupted\n"
        assert process.wait(timeout=60) == 0
    assert "closed properly" in cli("replay", file)


def test_signals_without_a_handler_of_python_stay_as_they_were():
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler
    assert signal.getsignal(signal.SIGTERM) is signal.SIG_DFL
