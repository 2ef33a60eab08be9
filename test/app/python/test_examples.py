# SPDX-License-Identifier: BSD-3-Clause
"""The guide's programs and the examples run, and each example draws what it computed."""

import os
import re
import subprocess
import sys

import matplotlib.image
import numpy as np
import pytest
from conftest import ROOT

EXAMPLES = ROOT / "resources/examples/python"
# Fewer draws and cochleae than in the guide's pictures: the calls are tested.
FEWER = {"force_over_depth": [], "plan_bands": ["2"], "depth_over_size": ["2"], "force_controller": [], "environment": [],
         "parameter_sweep": ["2"], "array_design": ["1"], "friction_fit": [], "recording_analysis": [], "own_figure": []}


def run(tmp_path, *words):
    done = subprocess.run([sys.executable, *map(str, words)], cwd=tmp_path, env={**os.environ, "XDG_DATA_HOME": str(tmp_path / "data")},
                          capture_output=True, text=True, timeout=240, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


# These need a server, which test/app/archive starts.
WITH_SERVERS = {"from_the_archive"}
# And these a CT, which test_outcome.py makes.
WITH_CT = {"array_in_ct"}


def test_every_example_is_run():
    assert {file.stem for file in EXAMPLES.glob("*.py")} == set(FEWER) | WITH_SERVERS | WITH_CT
    assert all(f"{name}.py" in (ROOT / "test/app/python/test_outcome.py").read_text() for name in WITH_CT)
    assert all(f"{name}.py" in (ROOT / "test/app/archive/ArchiveTest.cpp").read_text() for name in WITH_SERVERS)


@pytest.mark.parametrize("name", sorted(FEWER))
def test_an_example_prints_its_numbers_and_draws_a_picture(tmp_path, name):
    said = run(tmp_path, EXAMPLES / f"{name}.py", "out.png", *FEWER[name])
    assert len(said.splitlines()) >= 2 and any(unit in said for unit in (" deg", "_deg", " mm"))
    picture = matplotlib.image.imread(tmp_path / "out.png")[:, :, :3]
    assert picture.shape[1] == 640
    # Axes and text are gray; curves and bands are colored.
    assert (np.ptp(picture, axis=2) > 0.3).mean() > 0.002


def test_the_guide_s_program_runs_as_written(tmp_path):
    programs = re.findall(r"^```python\n(.*?)^```", (ROOT / "resources/guide/python.md").read_text(), re.MULTILINE | re.DOTALL)
    assert programs
    for program in programs:
        (tmp_path / "guide.py").write_text(program)
        assert run(tmp_path, "guide.py")
