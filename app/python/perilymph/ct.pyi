# SPDX-License-Identifier: BSD-3-Clause
from os import PathLike
from typing import Union

from perilymph import CtMeasures

__all__ = ["measure", "measure_both"]

def measure(series: Union[str, PathLike[str]], *, side: str = "auto", program: Union[str, PathLike[str]] = "perilymph-cli") -> CtMeasures: ...
def measure_both(series: Union[str, PathLike[str]], *, program: Union[str, PathLike[str]] = "perilymph-cli") -> list[CtMeasures]: ...
