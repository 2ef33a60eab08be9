# SPDX-License-Identifier: BSD-3-Clause
from collections.abc import Iterable, Sequence
from os import PathLike
from typing import Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import NDArray

from perilymph import Array, Patient
from perilymph._json import Page

__all__ = ["ArrayOutcomes", "Estimate", "FoundArray", "Hits", "Outcomes", "Resistance", "find", "outcomes", "read", "read_outcomes"]

_Place = Union[str, PathLike[str]]

class Estimate(NamedTuple):
    value: float
    sd: float
    low95: float
    high95: float

class Hits(NamedTuple):
    inside: int
    ears: int
    value: float
    low95: float
    high95: float

class ArrayOutcomes(NamedTuple):
    array: str
    depth_in_50: Hits
    depth_in_90: Hits
    angle_in_50: Hits
    angle_in_90: Hits
    depth_percentiles: tuple[int, ...]
    angle_percentiles: tuple[int, ...]
    depth_difference_mm: Optional[tuple[float, float, float]]

class Resistance(NamedTuple):
    summary: str
    resisted: int
    censored: int
    not_informative: int
    gain: float
    is_offered: bool
    log_friction_shift: float
    log_stop_force_shift: float
    file: Optional[str]

class _Table(Page):
    def to_pandas(self) -> Any: ...

class FoundArray(_Table):
    array: str
    side: str
    angular_insertion_depth_deg: Estimate
    inserted_length_mm: Estimate
    tip_angle_deg: float
    contacts_inside: int
    outside_mm: float
    blur_fwhm_mm: float
    has_fold: bool
    translocation_probability: float
    translocation_angle_deg: Optional[float]
    is_registered: bool
    registration_residual: Optional[float]
    flags: tuple[str, ...]
    course_lps_mm: NDArray[np.float64]
    surgery: dict[str, Any]
    seconds: float
    def columns(self) -> dict[str, NDArray[Any]]: ...
    @property
    def positions_lps_mm(self) -> NDArray[np.float64]: ...
    def __len__(self) -> int: ...

class Outcomes(_Table):
    arrays: tuple[ArrayOutcomes, ...]
    left_out: dict[str, int]
    resistance: Resistance
    angle_offset_deg: tuple[float, float]
    notes: tuple[str, ...]
    def __init__(self, page: Any, name: str, notes: Iterable[str] = (), file: Optional[str] = None) -> None: ...
    def columns(self) -> dict[str, NDArray[Any]]: ...
    def __len__(self) -> int: ...

def find(
    series: _Place,
    array: Union[Array, _Place],
    *,
    side: Optional[str] = None,
    preop: Optional[_Place] = None,
    patient: Optional[Union[Patient, _Place]] = None,
    at_mm: Optional[Sequence[float]] = None,
    csv: Optional[_Place] = None,
    markups: Optional[_Place] = None,
    picture: Optional[_Place] = None,
    program: _Place = "perilymph-cli",
) -> FoundArray: ...
def read(file: _Place) -> FoundArray: ...
def outcomes(
    library: Optional[_Place] = None, *, folder: Optional[_Place] = None, resistance: Optional[_Place] = None, program: _Place = "perilymph-cli"
) -> Outcomes: ...
def read_outcomes(file: _Place) -> Outcomes: ...
