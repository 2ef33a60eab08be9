# SPDX-License-Identifier: BSD-3-Clause
from os import PathLike
from typing import Any, Optional, Union

import numpy as np
from numpy.typing import NDArray

from perilymph import Patient
from perilymph._json import Page

class CtMeasures(Page):
    duct_length_reason: Optional[str]
    values_mm: dict[str, Optional[float]]
    sds_mm: dict[str, Optional[float]]
    intervals95_mm: dict[str, Optional[tuple[float, float]]]
    side: str
    flags: list[str]
    warnings: list[str]
    round_window_lps_mm: NDArray[np.float64]
    center_lps_mm: NDArray[np.float64]
    axis_lps: NDArray[np.float64]
    second_cochlea_lps_mm: Optional[NDArray[np.float64]]
    provenance: dict[str, Any]
    def patient(self, label: str = "measured") -> Patient: ...

def read_measures(file: Union[str, PathLike[str]]) -> CtMeasures: ...
def read_both_measures(file: Union[str, PathLike[str]]) -> list[CtMeasures]: ...
