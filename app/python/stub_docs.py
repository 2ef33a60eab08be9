#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the stub of the package with the texts of the built module, for editors: stub_docs.py MODULE.so IN.pyi OUT.pyi

A module that this interpreter cannot load, such as one with a sanitizer, gives the stub as it is.
"""

import ast
import importlib.machinery
import importlib.util
import inspect
import sys
from pathlib import Path


def loaded(file):
    loader = importlib.machinery.ExtensionFileLoader("perilymph._engine", file)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("perilymph._engine", loader))
    loader.exec_module(module)
    return module


def add_texts(body, owner):
    """Gives each definition in a body the documentation of the object of its name."""
    for node in body:
        found = vars(owner).get(getattr(node, "name", None))
        found = getattr(found, "__func__", found)  # of a static method
        text = inspect.cleandoc(found.__doc__) if found is not None and found.__doc__ else None
        if not isinstance(node, (ast.ClassDef, ast.FunctionDef)) or text is None:
            continue
        if isinstance(node, ast.ClassDef):
            add_texts(node.body, found)
        node.body.insert(0, ast.Expr(ast.Constant(text)))


def main(module, source, made):
    text = Path(source).read_text(encoding="utf-8")
    try:
        engine = loaded(module)
    except ImportError as error:
        print(f"The stub is without texts: {error}")
    else:
        stub = ast.parse(text)
        add_texts(stub.body, engine)
        text = text.splitlines()[0] + "\n" + ast.unparse(ast.fix_missing_locations(stub)) + "\n"
    Path(made).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
