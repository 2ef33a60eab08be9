# SPDX-License-Identifier: BSD-3-Clause
"""Calls of perilymph-cli for what the package does not compute itself."""

import os
import shutil
import subprocess

from perilymph._engine import Error


def run_program(program, words):
    """Runs perilymph-cli with words; returns what it wrote to standard error, and raises Error with its sentence if it fails."""
    found = shutil.which(os.fspath(program))
    if found is None:
        raise Error(f"The program {program} was not found. Install perilymph, or give its path as 'program'.")
    if any("\0" in os.fsdecode(word) for word in words):
        raise Error("A text for perilymph-cli has a zero character. Leave it out.")
    done = subprocess.run([found, *words], capture_output=True, text=True, errors="replace", check=False)
    if done.returncode != 0:
        raise Error(done.stderr.strip() or f"{found} ended with {done.returncode}.")
    return done.stderr


def word(name, value):
    """A text or path of an argument for perilymph-cli. Raises TypeError for anything else, and Error if it is empty."""
    text = os.fspath(value) if isinstance(value, os.PathLike) else value
    if not isinstance(text, str):
        raise TypeError(f"{name} must be text or a path")
    if not text:
        raise Error(f"{name} is empty. Give a text, or leave it out.")
    return text
