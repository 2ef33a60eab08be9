# SPDX-License-Identifier: BSD-3-Clause
"""Hundreds of calls that nobody should make: each gives a result or an exception with a sentence, and none ends the process."""

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time

import numpy as np
import pytest
from conftest import SHORT, same_bits

import perilymph

NAN, INF = float("nan"), float("inf")


class Odd:
    """Answers every question of Python's protocols with nonsense."""

    def __fspath__(self):
        return 3

    def __float__(self):
        raise ZeroDivisionError("odd")

    def __index__(self):
        return "one"

    def __len__(self):
        return -1

    def __getitem__(self, key):
        raise LookupError("odd")

    def __array__(self, *arguments, **keywords):
        return "no array"


VALUES = [None, True, -1, 0, 10**400, -(10**400), 1e308, NAN, -INF, 1j, "", "x", "\0", "ü" * 5000, b"\xff", [], (), {}, {"a": 1}, [None], [[]],
          [1, "x"], [NAN], np.array([]), np.array(["a"]), np.array([None]), np.zeros((2, 3, 0)), np.array(1.0), np.ma.masked_all(3),
          np.array([1 + 1j]), np.datetime64("2020"), object(), Odd(), lambda: 1, range(3), np.array([b"x"]), int, perilymph]


@pytest.fixture(scope="module")
def objects():
    mean = perilymph.Cochlea.named("mean")
    insertion = perilymph.Insertion("contour-published", SHORT)
    insertion.advance(ticks=3)
    return {"mean": mean, "array": perilymph.read_array("flex28"), "scenario": perilymph.read_scenario("contour-published", SHORT),
            "insertion": insertion, "simulation": perilymph.simulate("contour-published", SHORT)}


CALLS = {
    "axis": lambda o, x: o["mean"].axis(x),
    "wall": lambda o, x: o["mean"].wall(x, 0.0),
    "around": lambda o, x: o["mean"].wall(10.0, x, paired=True),
    "membrane": lambda o, x: o["mean"].membrane(10.0, x),
    "distance": lambda o, x: o["mean"].distance(x),
    "sections": lambda o, x: o["mean"].sections(x),
    "surface": lambda o, x: o["mean"].surface(x),
    "vertices": lambda o, x: perilymph.Cochlea.from_surface(x, [[0, 1, 2]]),
    "faces": lambda o, x: perilymph.Cochlea.from_surface(np.eye(3), x),
    "named": lambda o, x: perilymph.Cochlea.named(x),
    "cochlea": lambda o, x: perilymph.Cochlea(x),
    "patient": lambda o, x: perilymph.Patient(a_mm=x, b_mm=6.9),
    "label": lambda o, x: perilymph.Patient(a_mm=9.2, b_mm=6.9, label=x),
    "width": lambda o, x: o["array"].width_mm(x),
    "replace width": lambda o, x: o["array"].replace(width_mm=x),
    "replace contacts": lambda o, x: o["array"].replace(contacts_from_tip_mm=x),
    "replace name": lambda o, x: o["array"].replace(name=x),
    "without": lambda o, x: o["array"].replace(without=x),
    "read_array": lambda o, x: perilymph.read_array(x),
    "read_plan": lambda o, x: perilymph.read_plan(x),
    "read_study": lambda o, x: perilymph.read_study(x),
    "read_recording": lambda o, x: perilymph.read_recording(x),
    "read_measures": lambda o, x: perilymph.read_measures(x),
    "scenario": lambda o, x: perilymph.read_scenario(x),
    "nodes": lambda o, x: o["scenario"].with_values({"nodes": x}),
    "array": lambda o, x: o["scenario"].with_values({"array": x}),
    "friction": lambda o, x: o["scenario"].with_values({"friction": x}),
    "overrides": lambda o, x: o["scenario"].with_values(x),
    "key": lambda o, x: o["scenario"][x],
    "contains": lambda o, x: x in o["scenario"],
    "column": lambda o, x: o["simulation"][x],
    "get": lambda o, x: o["simulation"].get(x),
    "found array": lambda o, x: perilymph.outcome.find("nowhere", x),
    "Friction": lambda o, x: perilymph.Friction(x),
    "advance": lambda o, x: o["insertion"].advance(x),
    "ticks": lambda o, x: o["insertion"].advance(ticks=x) if not isinstance(x, int) or x < 10 else None,
    "step": lambda o, x: o["insertion"].step(x),
    "rotation": lambda o, x: o["insertion"].step([0, 0, 0], x),
    "stylet": lambda o, x: o["insertion"].pull_stylet(x),
    "restore": lambda o, x: o["insertion"].restore(x),
    "record": lambda o, x: perilymph.simulate(o["scenario"], depths_mm=x),
    "every": lambda o, x: perilymph.simulate(o["scenario"], every_ms=x),
    "plan": lambda o, x: perilymph.plan(x, ["flex28"], samples=16),
    "samples": lambda o, x: perilymph.plan("average", [], samples=x),
    "equal": lambda o, x: (o["array"] == x, o["mean"] != x) if not isinstance(x, np.ndarray) else None,
    "server": lambda o, x: perilymph.archive.find(x, patient_id="1"),
    "patient id": lambda o, x: perilymph.archive.find("absent", patient_id=x),
    "series": lambda o, x: perilymph.archive.retrieve("absent", x, "nowhere"),
    "report": lambda o, x: perilymph.archive.send("absent", x),
    "program": lambda o, x: perilymph.ct.measure("nowhere", program=x),
}
# What wrong arguments may raise in Python; an exception of the argument's own methods is passed on.
EXPECTED = (perilymph.Error, TypeError, ValueError, KeyError, OverflowError, ZeroDivisionError, LookupError)


@pytest.mark.parametrize("name", CALLS)
def test_any_value_gives_a_result_or_a_sentence(objects, name, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for value in VALUES:
        try:
            CALLS[name](objects, value)
        except perilymph.Error as error:
            text = str(error)
            assert text and text.endswith((".", "?")), (name, value, text)
            assert text.count("\n") <= 1, (name, text)
        except EXPECTED as error:
            assert str(error)
    assert os.listdir(tmp_path) == []


def test_as_many_calls_as_stated():
    assert len(CALLS) * len(VALUES) > 1700


@pytest.mark.parametrize("change", [
    lambda x: np.repeat(x, 2)[::2], lambda x: x[::-1].copy()[::-1], lambda x: x.astype(">f8"), lambda x: x.astype("<f8").view(np.ndarray),
    lambda x: list(x), lambda x: tuple(x), lambda x: np.asfortranarray(x), lambda x: np.require(x, requirements=["O"]), lambda x: memoryview(x.copy())])
def test_strided_swapped_and_listed_numbers_are_the_same(objects, change):
    angles = np.array([10.0, 50.0, 90.0, 400.0])
    assert same_bits(objects["mean"].axis(change(angles)), objects["mean"].axis(angles))


def test_read_only_and_transposed_points_are_the_same(objects):
    points = np.ascontiguousarray(objects["mean"].axis(np.arange(12.0)).T)
    frozen = points.T
    frozen.flags.writeable = False
    found = objects["mean"].distance(frozen)["distance_mm"]
    assert same_bits(found, objects["mean"].distance(frozen.copy())["distance_mm"])
    with pytest.raises(perilymph.Error):
        objects["mean"].distance(points)


def test_results_are_the_caller_s_own(objects):
    points = objects["mean"].axis([10.0, 20.0])
    kept = points.copy()
    points[:] = 0.0
    assert same_bits(objects["mean"].axis([10.0, 20.0]), kept)


def test_threads_that_do_everything_at_once_agree():
    errors, results = [], []

    def work(number):
        try:
            mean = perilymph.Cochlea.named("mean")
            simulation = perilymph.simulate("contour-published", SHORT)
            insertion = perilymph.Insertion("contour-published", SHORT)
            insertion.advance(ticks=10_000)
            with pytest.raises(perilymph.Error):
                perilymph.read_array(f"nothing-{number}")
            results.append((simulation.summary["work_J"], insertion.reading.work_J, mean.measures()["A_mm"]))
        except BaseException as error:
            errors.append(error)

    threads = [threading.Thread(target=work, args=(k,)) for k in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert errors == [] and len(set(results)) == 1 and results[0][0] == results[0][1]


def test_a_child_that_was_forked_while_a_thread_computes_computes_too():
    done = threading.Event()

    def work():
        while not done.is_set():
            perilymph.simulate("contour-published", SHORT)

    thread = threading.Thread(target=work)
    thread.start()
    try:
        for _ in range(3):
            child = os.fork()
            if child == 0:
                try:
                    insertion = perilymph.Insertion("contour-published", SHORT)
                    os._exit(7 if insertion.advance(ticks=10_000).end == "finished" else 1)
                except BaseException:
                    os._exit(2)
            for _ in range(600):
                ended, status = os.waitpid(child, os.WNOHANG)
                if ended:
                    break
                time.sleep(0.1)
            else:
                os.kill(child, signal.SIGKILL)
            assert ended and os.waitstatus_to_exitcode(status) == 7
    finally:
        done.set()
        thread.join()


@pytest.mark.parametrize("long", [
    'perilymph.Insertion("surgery-flex28", {"dt_ms": 0.1, "nodes": 1000}).advance(0.1, ticks=10_000_000)',
    'perilymph.simulate("surgery-flex28", {"dt_ms": 0.1, "nodes": 1000, "speed_mm_s": 0.01})',
    'perilymph.plan(perilymph.Patient(a_mm=9.2, b_mm=6.9), samples=4096, all_samples=True)',
    'perilymph.study("surgery-flex28", "study", cochleae=100_000, vary={"nodes": [1000]})'])
def test_ctrl_c_ends_what_takes_long(tmp_path, long):
    program = textwrap.dedent(f"""\
        import sys
        import time
        import perilymph
        perilymph.simulate("contour-published", {SHORT})
        print("begins", flush=True)
        try:
            {long}
        except KeyboardInterrupt:
            print("ended", flush=True)
        print(perilymph.simulate("contour-published", {SHORT}).end)
        """)
    child = subprocess.Popen([sys.executable, "-c", program], cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                             env={**os.environ, "XDG_DATA_HOME": str(tmp_path / "data")})
    assert child.stdout.readline() == "begins\n"
    time.sleep(2.0)
    child.send_signal(signal.SIGINT)
    said, wrong = child.communicate(timeout=60)
    assert (said, wrong, child.returncode) == ("ended\nfinished\n", "", 0)
