# SPDX-License-Identifier: BSD-3-Clause
from os import PathLike
from typing import Optional, Union

from perilymph import CtMeasures

__all__ = ["measure", "measure_both"]

_Place = Union[str, PathLike[str]]

def measure(
    series: _Place,
    *,
    side: str = "auto",
    structured_report: Optional[_Place] = None,
    segmentation: Optional[_Place] = None,
    key_image: Optional[_Place] = None,
    program: _Place = "perilymph-cli",
) -> CtMeasures: ...
def measure_both(series: _Place, *, program: _Place = "perilymph-cli") -> list[CtMeasures]: ...
