# SPDX-License-Identifier: BSD-3-Clause
"""An insertion step by step: the bits of the command line, states that can be kept, and a caller that is never trusted."""

import copy
import threading

import numpy as np
import pytest
from conftest import SHORT, same_bits, table

import perilymph

COARSE = {"nodes": 50, "dt_ms": 5}


def rows_of(insertion, move):
    """The columns of an insertion that `move` moves to its end."""
    rows = []
    while not insertion.has_ended:
        rows.append(move(insertion).values())
    return {name: np.array([row[name] for row in rows]) for name in rows[0]}


@pytest.fixture
def insertion():
    return perilymph.Insertion("contour-published", SHORT)


def test_time_steps_are_those_of_the_command_line(cli, tmp_path, insertion):
    cli("simulate", "--scenario", "contour-published", "--nodes", 30, "--set", "stop_travel_mm=0.5", "--csv", tmp_path / "a.csv")
    steps = rows_of(insertion, perilymph.Insertion.advance)
    columns = table(tmp_path / "a.csv")
    assert list(steps) == list(columns)
    for name, column in columns.items():
        assert same_bits(steps[name], column), name


def test_a_whole_insertion_in_one_call_ends_as_simulate_does():
    simulation = perilymph.simulate("mean-flex28", COARSE)
    insertion = perilymph.Insertion("mean-flex28", COARSE)
    last = insertion.advance(ticks=1_000_000)
    assert (last.end, last.tick) == (simulation.end, simulation.summary["ticks"])
    assert all(value == simulation[name][-1] for name, value in last.values().items())
    assert last.work_J == simulation.summary["work_J"]
    assert insertion.contacts()["angle_deg"] == pytest.approx(simulation.contacts["angle_deg"], nan_ok=True)
    assert insertion.nodes_mm == pytest.approx(simulation.nodes_mm, abs=1e-5)  # those are 32-bit numbers


def test_a_pose_along_the_approach_moves_the_array_as_a_speed_does(insertion):
    by_speed = rows_of(insertion, perilymph.Insertion.advance)
    insertion.reset()
    step_m = insertion.scenario["speed_mm_s"] * 1e-3 * insertion.time_step_s
    hand = np.zeros(3)

    def move(one):
        if one.reading.tick > 0:  # a hand that grasps is at rest in that time step
            hand[2] -= step_m * 1e3
        return one.step(hand)

    by_pose = rows_of(insertion, move)
    # The pose is given in millimeters, so that its last bit differs.
    assert by_pose["depth_mm"] == pytest.approx(by_speed["depth_mm"], abs=1e-9)


def test_a_hand_to_the_side_moves_the_base_to_the_side(insertion):
    insertion.step([0.0, 0.0, 0.0])
    before = insertion.nodes_mm[0]
    for k in range(1, 11):
        insertion.step([0.01 * k, 0.0, 0.0])
    assert np.linalg.norm(insertion.nodes_mm[0] - before) == pytest.approx(0.1, rel=1e-6)
    insertion.step([0.1, 0.0, 0.0], grasp=False)
    assert insertion.reading.state == "paused"
    assert insertion.step([0.1, 0.0, 0.0]).state == "inserting"


def test_what_follows_a_restored_state_has_the_same_bits(insertion):
    insertion.advance(ticks=100)
    kept = insertion.snapshot()
    first = rows_of(insertion, perilymph.Insertion.advance)
    end = insertion.fingerprint
    insertion.restore(kept)
    assert insertion.fingerprint == kept.fingerprint != end
    assert insertion.reading.tick == kept.reading.tick == 100
    again = rows_of(insertion, perilymph.Insertion.advance)
    assert all(same_bits(again[name], first[name]) for name in first)
    assert insertion.fingerprint == end


def test_a_copy_goes_its_own_way(insertion):
    insertion.advance(ticks=50)
    other, third = copy.copy(insertion), copy.deepcopy(insertion)
    before = insertion.fingerprint
    other.advance(-1.0, ticks=20)
    assert insertion.fingerprint == third.fingerprint == before != other.fingerprint
    other.reset()
    insertion.reset()
    assert insertion.fingerprint == other.fingerprint


def test_a_state_of_another_scenario_is_refused(insertion):
    kept = perilymph.Insertion("contour-published", {**SHORT, "friction": "soap-90"}).snapshot()
    before = insertion.fingerprint
    with pytest.raises(perilymph.Error, match="snapshot"):
        insertion.restore(kept)
    assert insertion.fingerprint == before


def test_an_array_at_rest_is_in_equilibrium():
    insertion = perilymph.Insertion("surgery-flex28", COARSE)
    insertion.advance(ticks=2500)
    now = insertion.advance(0.0, ticks=100)
    # No weight and no motion: the hand carries what the wall pushes, within 2 uN of the solver for each node.
    assert np.linalg.norm(insertion.node_forces_N.sum(axis=0) - now.force_N) < 50 * 2e-6
    assert now.force_axial_N > 1e-3
    assert now.contacts == np.count_nonzero(insertion.normal_forces_N) > 0
    assert insertion.normal_forces_N.max() == now.wall_force_max_N
    assert np.abs(insertion.velocities_mm_s).max() < 0.01
    assert now.tip_mm == pytest.approx(insertion.nodes_mm[-1])


def test_an_array_is_withdrawn_after_its_end(insertion):
    insertion.advance(ticks=10_000)
    depth_mm = insertion.reading.depth_mm
    assert insertion.reading.end == "finished"
    # Held until it is to be withdrawn; it settles by a few nanometers.
    assert insertion.advance(-2.0, ticks=50).depth_mm == pytest.approx(depth_mm, abs=1e-3)
    insertion.withdraw()
    insertion.advance(-2.0, ticks=100)
    assert insertion.reading.depth_mm == pytest.approx(depth_mm - 0.2, abs=0.01)


def test_a_stylet_is_pulled_at_its_speed():
    insertion = perilymph.Insertion("contour-published", {**SHORT, "stylet_pull_mm_s": 5})
    insertion.advance(0.0, ticks=10)
    insertion.pull_stylet(1.0)
    assert insertion.advance(0.0, ticks=100).stylet_withdrawal_mm == pytest.approx(0.5, abs=0.01)
    assert insertion.advance(0.0, ticks=300).stylet_withdrawal_mm == pytest.approx(1.0, abs=1e-9)


def test_an_early_end_is_named_and_is_the_last_step():
    insertion = perilymph.Insertion("contour-published", {
        "nodes": 50, "start_inside_mm": 1, "approach_turn_deg": -5, "residual_curvature_fraction": 0.1})
    last = insertion.advance(ticks=1_000_000)
    assert (last.end, last.state) == ("out_of_opening", "finished")
    assert "endedOutOfOpening" in last.events
    assert insertion.advance().tick == last.tick + 1  # a finished insertion is held, and nothing is raised


def test_threads_advance_their_own_insertions_at_once(insertion):
    insertion.advance(ticks=20)
    others = [copy.copy(insertion) for _ in range(3)]
    threads = [threading.Thread(target=one.advance, kwargs={"ticks": 1000}) for one in others]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    insertion.advance(ticks=1000)
    assert {one.fingerprint for one in others} == {insertion.fingerprint}


def test_a_second_thread_that_touches_a_moving_insertion_is_refused_or_waits_its_turn():
    insertion = perilymph.Insertion("mean-flex28")
    refused, done = [], threading.Event()

    def look():
        while not done.is_set():
            try:
                insertion.nodes_mm, insertion.reading, insertion.fingerprint
            except perilymph.Error as error:
                refused.append(str(error))

    thread = threading.Thread(target=look)
    thread.start()
    reached = 0
    for _ in range(200):
        try:
            reached = insertion.advance(ticks=20).tick
        except perilymph.Error as error:  # the bits stay whole: it is asked for its number between two turns
            refused.append(str(error))
    done.set()
    thread.join()
    assert refused and all("Another thread" in each for each in refused)
    assert reached == insertion.reading.tick > 2000


@pytest.mark.parametrize("call, allowed", [
    (lambda one: one.advance(float("nan")), "speed_mm_s"),
    (lambda one: one.advance(1e9), "speed_mm_s"),
    (lambda one: one.advance(ticks=0), "ticks"),
    (lambda one: one.advance(ticks=-5), "ticks"),
    (lambda one: one.step([0.0, 0.0]), "hand_mm"),
    (lambda one: one.step([0.0, 0.0, float("inf")]), "hand_mm"),
    (lambda one: one.step([[0.0, 0.0, 0.0]]), "hand_mm"),
    (lambda one: one.step([0.0, 0.0, 0.0], [0.0, 0.0, 0.0, 0.0]), "rotation"),
    (lambda one: one.step([0.0, 0.0, 0.0], [1.0]), "rotation"),
    (lambda one: one.pull_stylet(-1.0), "to_mm"),
    (lambda one: [one.withdraw() for _ in range(20)], "next time step"),
])
def test_values_out_of_range_change_nothing(insertion, call, allowed):
    insertion.advance(ticks=3)
    before = insertion.fingerprint
    with pytest.raises(perilymph.Error, match=allowed):
        call(insertion)
    assert insertion.fingerprint == before


@pytest.mark.parametrize("call", [
    lambda one: one.advance("fast"), lambda one: one.advance(ticks=1.5), lambda one: one.advance([1.0, 2.0]),
    lambda one: one.step("here"), lambda one: one.step(None), lambda one: one.step([0, 0, 0], "turned"),
    lambda one: one.restore(None), lambda one: one.restore(one), lambda one: perilymph.Insertion(),
    lambda one: perilymph.Insertion(3), lambda one: perilymph.InsertionSnapshot(), lambda one: perilymph.Reading()])
def test_wrong_types_are_type_errors(insertion, call):
    with pytest.raises(TypeError):
        call(insertion)
