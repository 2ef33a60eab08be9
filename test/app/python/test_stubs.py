# SPDX-License-Identifier: BSD-3-Clause
"""The typed stubs say what the module has: the same names, arguments and defaults; every name is documented."""

import ast
import importlib.metadata
import inspect
import os
import pydoc
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

import perilymph

PACKAGE = Path(perilymph.__file__).parent
STUB = ast.parse((PACKAGE / "__init__.pyi").read_text())
# What Python gives every class; a mapping's methods are listed where they are defined.
OWN = re.compile(r"__(getitem|len|init|copy|deepcopy|iter|contains|eq|hash)__|_repr_html_|[^_].*")


def stubbed(body):
    """Public name -> its definition in the stub."""
    found = {}
    for node in body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            found[node.name] = node
        elif isinstance(node, ast.AnnAssign):
            found[node.target.id] = node
        elif isinstance(node, ast.ImportFrom):
            found.update({each.asname: node for each in node.names if each.asname})
    return found


def arguments_of_stub(function):
    """(name, default or None, is by keyword only) of each argument but self."""
    given = function.args
    plain = given.posonlyargs + given.args
    defaults = [None] * (len(plain) - len(given.defaults)) + given.defaults
    rows = [(each.arg, default, False) for each, default in zip(plain, defaults)]
    rows += [(each.arg, default, True) for each, default in zip(given.kwonlyargs, given.kw_defaults)]
    return [(name, None if default is None else ast.literal_eval(default), only) for name, default, only in rows if name != "self"]


def arguments_of_module(function):
    """The same, from the signature that help() and inspect show."""
    return [(each.name, None if each.default is each.empty else each.default, each.kind is each.KEYWORD_ONLY)
            for each in inspect.signature(function).parameters.values() if each.name != "self"]


def test_the_stub_has_the_names_of_the_module():
    names = {name for name in stubbed(STUB.body) if not name.startswith("_") or name == "__version__"}
    assert names == set(perilymph.__all__)
    assert sorted(perilymph.__all__) == sorted(set(perilymph.__all__))
    for name in perilymph.__all__:
        assert hasattr(perilymph, name)


CLASSES = [name for name, node in stubbed(STUB.body).items() if isinstance(node, ast.ClassDef) and name != "Error"]
FUNCTIONS = [name for name, node in stubbed(STUB.body).items() if isinstance(node, ast.FunctionDef)]


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_have_the_arguments_of_the_stub(name):
    assert arguments_of_module(getattr(perilymph, name)) == arguments_of_stub(stubbed(STUB.body)[name])
    assert getattr(perilymph, name).__doc__.strip()


def members(kind):
    return {name: value for name, value in vars(kind).items() if OWN.fullmatch(name)}


@pytest.mark.parametrize("name", CLASSES)
def test_classes_have_the_members_of_the_stub(name):
    kind = getattr(perilymph, name)
    assert kind.__doc__.strip() and kind.__module__.startswith("perilymph")
    # Attributes of instances are tested where instances are made.
    told = {member: node for member, node in stubbed(stubbed(STUB.body)[name].body).items()
            if not isinstance(node, ast.AnnAssign) and OWN.fullmatch(member)}
    has = members(kind)
    if "__init__" not in told:  # made by functions of the module only
        has.pop("__init__", None)
    assert set(told) == set(has)
    for member, node in told.items():
        decorators = [each.id for each in node.decorator_list] if isinstance(node, ast.FunctionDef) else []
        value = has[member]
        if isinstance(value, property):
            assert decorators == ["property"], member
            assert value.__doc__ and value.__doc__.strip(), f"{name}.{member} is not documented"
        else:
            assert ("staticmethod" in decorators) == isinstance(value, staticmethod), member
            assert arguments_of_module(getattr(kind, member)) == arguments_of_stub(node), f"{name}.{member}"


@pytest.mark.skipif(shutil.which("mypy") is None, reason="the package mypy is not installed")
def test_mypy_accepts_the_stub_and_a_program_that_uses_it(tmp_path):
    (tmp_path / "use.py").write_text(
        "import numpy as np\nimport perilymph\n\n"
        "patient = perilymph.Patient(a_mm=9.0, b_mm=6.8)\n"
        "cochlea = perilymph.Cochlea(patient)\n"
        "deep: float = float(np.max(cochlea.axis([0.0, 90.0])))\n"
        "force = perilymph.simulate('contour-published', {'nodes': 30})['force_axial_N'].max()\n")
    (tmp_path / "misuse.py").write_text("import perilymph\n\nperilymph.Cochlea(3)\nperilymph.simulate(array='flex28')\n")

    def mypy(*files):
        return subprocess.run(
            [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache"), *map(str, files)],
            env={"MYPYPATH": str(PACKAGE.parent), "PATH": "/usr/bin:/bin"}, capture_output=True, text=True, check=False)

    (tmp_path / "typed.py").write_text(
        "import perilymph\n\n"
        "values: perilymph.ScenarioValues = {'array': perilymph.read_array('flex28'), 'nodes': 30, 'opening': 'round-window'}\n"
        "perilymph.simulate('surgery-flex28', values)\n"
        "insertion = perilymph.Insertion('surgery-flex28', {'speed_mm_s': 1.0})\n")
    (tmp_path / "mistyped.py").write_text(
        "import perilymph\n\none: perilymph.ScenarioValues = {'node': 30}\n"
        "two: perilymph.ScenarioValues = {'opening': 'window'}\nthree: perilymph.ScenarioValues = {'dt_ms': '5'}\n")
    accepted = mypy(tmp_path / "typed.py")
    assert accepted.returncode == 0, accepted.stdout + accepted.stderr
    refused = mypy(tmp_path / "mistyped.py")
    assert refused.returncode == 1 and re.findall(r"mistyped.py:(\d+): error", refused.stdout) == ["3", "4", "5"], refused.stdout
    accepted = mypy(PACKAGE / "__init__.pyi", tmp_path / "use.py")
    assert accepted.returncode == 0, accepted.stdout + accepted.stderr
    refused = mypy(tmp_path / "misuse.py")
    assert refused.returncode == 1 and refused.stdout.count("error:") >= 2, refused.stdout + refused.stderr


# Classes of the engine have pybind11's own metaclass, as a TypedDict has its own, and those that functions make have no constructor.
ALLOWED = r"""
perilymph\.(_values\.)?[A-Z]\w+
perilymph\.(_values\.)?[A-Z]\w+\.__init__
"""


@pytest.mark.skipif(shutil.which("mypy") is None, reason="the package mypy is not installed")
def test_stubtest_finds_the_stubs_as_the_package_is(tmp_path):
    (tmp_path / "allowed").write_text(ALLOWED)
    def stubtest(path):
        return subprocess.run(
            [sys.executable, "-m", "mypy.stubtest", "perilymph", "--allowlist", "allowed", "--ignore-unused-allowlist"],
            env={**os.environ, "MYPYPATH": str(path)}, cwd=tmp_path, capture_output=True, text=True, check=False)

    done = stubtest(PACKAGE.parent)
    assert done.returncode == 0, done.stdout + done.stderr
    (tmp_path / "wrong").mkdir()
    shutil.copytree(PACKAGE, tmp_path / "wrong/perilymph", ignore=shutil.ignore_patterns("__pycache__", "*.so"))
    stub = tmp_path / "wrong/perilymph/__init__.pyi"
    stub.write_text(stub.read_text().replace("every_ms: float=0.0,", "every: float=0.0,"))
    done = stubtest(tmp_path / "wrong")
    assert done.returncode == 1 and "perilymph.simulate" in done.stdout, done.stdout + done.stderr


def test_the_stub_has_the_texts_of_the_module_for_editors():
    for name in ("simulate", "Insertion", "Patient"):
        node = stubbed(STUB.body)[name]
        assert ast.get_docstring(node) == inspect.getdoc(getattr(perilymph, name))
    methods = stubbed(stubbed(STUB.body)["Patient"].body)
    assert ast.get_docstring(methods["from_lengths"]) == inspect.getdoc(perilymph.Patient.from_lengths)
    assert ast.get_docstring(methods["a_mm"]) == "Diameter A of the basal turn [mm], or None."


def test_the_types_of_values_have_the_keys_of_the_reference():
    rows = (ROOT / "resources/guide/reference.md").read_text().partition("## Keys of a scenario\n")[2].partition("\n## ")[0]
    keys = set(re.findall(r"^\| `(\w+)` \|", rows, re.MULTILINE))
    assert set(perilymph.ScenarioValues.__annotations__) == keys - {"patient_numbers"} | {"cochlea"} and len(keys) > 50


def test_help_shows_signatures_and_texts():
    said = pydoc.plain(pydoc.render_doc(perilymph.Insertion))
    assert "advance(self, speed_mm_s=None, *, ticks=1)" in said and "negative out of it" in said
    assert "overrides=None, *, record=None" in pydoc.plain(pydoc.render_doc(perilymph.simulate))


def test_the_package_is_known_by_its_version():
    numbers = importlib.metadata.version("perilymph").replace(".dev0", "-dev")
    assert numbers == perilymph.__version__
    assert importlib.metadata.requires("perilymph") == ["numpy"]
