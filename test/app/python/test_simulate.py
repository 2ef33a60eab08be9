# SPDX-License-Identifier: BSD-3-Clause
"""A simulated insertion is the command line's, bit for bit."""

import json
import sys
import threading
import time

import numpy as np
import pytest
from conftest import SHORT, same_bits, table

import perilymph


@pytest.fixture(scope="module")
def short():
    return perilymph.simulate("contour-published", SHORT, depths_mm=[2.2, 2.4, 9.0])


def test_columns_and_summary_are_those_of_the_command_line(cli, tmp_path, short):
    cli("simulate", "--scenario", "contour-published", "--nodes", 30, "--set", "stop_travel_mm=0.5",
        "--csv", tmp_path / "a.csv", "--json", tmp_path / "a.json")
    columns = table(tmp_path / "a.csv")
    assert list(short.columns) == list(columns)
    for name, column in columns.items():
        assert same_bits(short[name], column), name
    assert short.summary == json.loads((tmp_path / "a.json").read_text())


def test_a_whole_insertion_at_intervals_is_that_of_the_command_line(cli, tmp_path):
    cli("simulate", "--scenario", "mean-flex28", "--nodes", 50, "--set", "dt_ms=5", "--every-ms", 50,
        "--csv", tmp_path / "a.csv")
    simulation = perilymph.simulate("mean-flex28", {"nodes": 50, "dt_ms": 5}, every_ms=50)
    for name, column in table(tmp_path / "a.csv").items():
        assert same_bits(simulation[name], column), name
    assert simulation.end in ("finished", "stopped_by_resistance", "jammed")


def test_the_shape_at_the_end_has_the_tip_and_the_nodes_of_the_columns(short):
    tip = [short[f"tip_{axis}_mm"][-1] for axis in "xyz"]
    assert short.nodes_mm.shape == (SHORT["nodes"], 3)
    assert short.nodes_mm[-1] == pytest.approx(tip, abs=1e-5)  # shapes are stored as 32-bit numbers
    assert short.end == "finished"
    assert short["depth_mm"][-1] == pytest.approx(2.5, abs=0.01)


def test_shapes_are_taken_where_the_tip_first_passes_a_depth(short):
    assert short.shapes_mm.shape == (3, SHORT["nodes"], 3)
    for i, asked in enumerate((2.2, 2.4)):
        row = np.argmax(short["depth_mm"] >= asked)
        assert short.shape_depths_mm[i] == short["depth_mm"][row]
        tip = [short[f"tip_{axis}_mm"][row] for axis in "xyz"]
        assert short.shapes_mm[i, -1] == pytest.approx(tip, abs=1e-5)
    assert np.isnan(short.shape_depths_mm[2]) and np.isnan(short.shapes_mm[2]).all()


def test_the_array_keeps_its_length(short):
    length = np.linalg.norm(np.diff(short.nodes_mm, axis=0), axis=1).sum()
    assert length == pytest.approx(short.scenario.array.length_mm, rel=0.01)


def test_contacts_from_the_tip_are_inserted_up_to_the_depth(short):
    contacts = short.contacts
    assert list(contacts["number"]) == list(range(1, 1 + len(short.scenario.array.contacts_from_tip_mm)))
    assert list(contacts["is_inserted"]) == list(contacts["depth_mm"] >= 0.0)
    assert np.isnan(contacts["angle_deg"][~contacts["is_inserted"]]).all()


def test_an_early_end_is_named():
    simulation = perilymph.simulate("contour-published", {
        "nodes": 50, "start_inside_mm": 1, "approach_turn_deg": -5, "residual_curvature_fraction": 0.1})
    assert (simulation.end, simulation.summary["end"]) == ("out_of_opening", "out_of_opening")
    assert simulation.end_clause == "bowed in front of the opening and slipped out of it"


def test_a_recording_replays_to_the_same_bits(cli, tmp_path):
    file = tmp_path / "a.insertion"
    perilymph.simulate("contour-published", SHORT, record=file)
    assert "identical" in cli("replay", file, "--verify")
    with pytest.raises(perilymph.Error, match="a.insertion"):  # a recording is never replaced
        perilymph.simulate("contour-published", SHORT, record=file)


def test_a_scenario_states_its_values_and_takes_others(tmp_path):
    assert "contour-published" in perilymph.scenarios()
    scenario = perilymph.read_scenario("surgery-flex28")
    assert scenario["speed_mm_s"] == 0.66
    assert scenario["withdraw"] is False
    assert scenario["array"] == "flex28"
    assert scenario.keys() == list(dict(scenario))
    other = scenario.with_values({"array": "flex24", "stop_travel_mm": 10, "withdraw": True, "speed_mm_s": 1.5})
    assert (other["array"], other["stop_travel_mm"], other["withdraw"], other["speed_mm_s"]) == ("flex24", 10.0, True, 1.5)
    assert scenario["array"] == "flex28"
    (tmp_path / "own.toml").write_text(other.text)
    assert dict(perilymph.read_scenario(tmp_path / "own.toml")) == dict(other)


def test_a_scenario_is_run_as_it_stands(short):
    again = perilymph.simulate(perilymph.read_scenario("contour-published", SHORT))
    assert all(same_bits(again[name], short[name]) for name in short.columns)
    assert short.scenario.values() == again.scenario.values()


def test_several_insertions_at_once_are_the_same_as_one_after_the_other(short):
    found = [None] * 3

    def run(i):
        found[i] = perilymph.simulate("contour-published", SHORT)

    threads = [threading.Thread(target=run, args=(i,)) for i in range(len(found))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for other in found:
        assert all(same_bits(other[name], short[name]) for name in short.columns)


class Counter:
    """Counts in another thread, which gives the interpreter's lock away after each number."""

    def __enter__(self):
        self.count, self.started, self.ended = 0, threading.Event(), threading.Event()
        # No thread is interrupted while it has the lock: only who gives it away lets others run.
        self.interval = sys.getswitchinterval()
        sys.setswitchinterval(1000.0)
        self.thread = threading.Thread(target=self.run)
        self.thread.start()
        self.started.wait()
        return self

    def run(self):
        self.started.set()
        while not self.ended.is_set():
            self.count += 1
            time.sleep(0)

    def __exit__(self, *exception):
        self.ended.set()
        sys.setswitchinterval(self.interval)
        self.thread.join()


def test_a_second_thread_counts_while_an_insertion_is_computed():
    with Counter() as counter:
        before = counter.count
        perilymph.simulate("contour-published", SHORT)
        during = counter.count - before
    assert during > 0


def test_the_counter_does_not_count_while_python_has_the_lock():
    with Counter() as counter:
        before = counter.count
        sum(range(2_000_000))
        during = counter.count - before
    assert during == 0
