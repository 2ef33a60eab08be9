# SPDX-License-Identifier: BSD-3-Clause
from collections.abc import Callable, Iterable, Mapping, Sequence
from os import PathLike
from typing import Any, Optional, Union

from perilymph import Cochlea, Patient, Scenario, Study

_Name = Union[str, PathLike[str]]

def study(
    scenario: Union[Scenario, _Name],
    folder: _Name,
    *,
    vary: Optional[Mapping[str, Iterable[Any]]] = None,
    ranges: Optional[Mapping[str, Iterable[float]]] = None,
    cochleae: int = 0,
    mean: bool = False,
    patients: Sequence[Union[Patient, Cochlea, _Name]] = (),
    samples: int = 1,
    seed: int = 1,
    title: str = "Study",
    depth: str = "full",
    contacts: bool = False,
    profile_spacing_mm: float = 0.0,
    jobs: int = 0,
    progress: Optional[Callable[[int, int], object]] = None,
) -> Study: ...
