# SPDX-License-Identifier: BSD-3-Clause
from collections.abc import Sequence
from os import PathLike
from typing import Union

def run_program(program: Union[str, PathLike[str]], words: Sequence[str]) -> str: ...
def word(name: str, value: object) -> str: ...
