# SPDX-License-Identifier: BSD-3-Clause
"""The guide's programs and the examples run, and each example draws what it computed."""

import json
import os
import re
import subprocess
import sys
import textwrap

import matplotlib.image
import numpy as np
import pytest
from conftest import ROOT

EXAMPLES = ROOT / "resources/examples/python"
# Fewer draws and cochleae than in the guide's pictures: the calls are tested.
FEWER = {"force_over_depth": [], "plan_bands": ["2"], "depth_over_size": ["2"], "force_controller": [], "environment": [],
         "parameter_sweep": ["2"], "array_design": ["1"], "friction_fit": [], "recording_analysis": [], "own_figure": []}


def run(tmp_path, *words):
    done = subprocess.run([sys.executable, *map(str, words)], cwd=tmp_path, env={**os.environ, "MPLBACKEND": "Agg", "XDG_DATA_HOME": str(tmp_path / "data")},
                          capture_output=True, text=True, timeout=240, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    return done.stdout


# These need a server, which test/app/archive starts.
WITH_SERVERS = {"from_the_archive"}
# And these a CT, which these tests make.
WITH_CT = {"array_in_ct": "test_outcome.py", "ct_measures": "test_recordings.py"}


def test_every_example_is_run():
    assert {file.stem for file in EXAMPLES.glob("*.py")} == set(FEWER) | WITH_SERVERS | set(WITH_CT)
    assert all(f"{name}.py" in (ROOT / "test/app/python" / test).read_text() for name, test in WITH_CT.items())
    assert all(f"{name}.py" in (ROOT / "test/app/archive/ArchiveTest.cpp").read_text() for name in WITH_SERVERS)


@pytest.mark.parametrize("name", sorted(FEWER))
def test_an_example_prints_its_numbers_and_draws_a_picture(tmp_path, name):
    said = run(tmp_path, EXAMPLES / f"{name}.py", "out.png", *FEWER[name])
    assert len(said.splitlines()) >= 2 and any(unit in said for unit in (" deg", "_deg", " mm"))
    picture = matplotlib.image.imread(tmp_path / "out.png")[:, :, :3]
    assert picture.shape[1] == 640
    # Axes and text are gray; curves and bands are colored.
    assert (np.ptp(picture, axis=2) > 0.3).mean() > 0.002


def test_the_notebook_runs_from_its_first_cell_to_its_last(tmp_path):
    pytest.importorskip("pandas")
    page = json.loads((EXAMPLES / "first_study.ipynb").read_text())
    assert (page["nbformat"], page["metadata"]["kernelspec"]["language"]) == (4, "python")
    cells = [cell for cell in page["cells"] if cell["cell_type"] == "code"]
    # Kept without results, which would be of another version.
    assert all((cell["outputs"], cell["execution_count"]) == ([], None) for cell in cells)
    # As a notebook does: what a cell ends with is shown, as HTML where it can be.
    program = ["import ast, matplotlib.pyplot", "names = {}", "matplotlib.pyplot.show = lambda: matplotlib.pyplot.savefig(f'{len(names)}.png')"]
    for cell in cells:
        program.append(textwrap.dedent(f"""\
            body = ast.parse({''.join(cell['source'])!r})
            last = ast.Expression(body.body.pop().value) if isinstance(body.body[-1], ast.Expr) else None
            exec(compile(body, 'cell', 'exec'), names)
            shown = eval(compile(last, 'cell', 'eval'), names) if last else None
            print(shown._repr_html_() if hasattr(shown, '_repr_html_') else shown)
            """))
    said = run(tmp_path, "-c", "\n".join(program))
    assert said.count("<table") >= 5 and "Softer" in said and "9.20" in said
    assert len(list(tmp_path.glob("*.png"))) == 2 and (tmp_path / "softer/study.sqlite").exists()


def test_the_guide_s_program_runs_as_written(tmp_path):
    programs = re.findall(r"^```python\n(.*?)^```", (ROOT / "resources/guide/python.md").read_text(), re.MULTILINE | re.DOTALL)
    assert programs
    for program in programs:
        (tmp_path / "guide.py").write_text(program)
        assert run(tmp_path, "guide.py")
