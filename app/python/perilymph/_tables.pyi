# SPDX-License-Identifier: BSD-3-Clause
from collections.abc import Mapping
from typing import Any

from numpy.typing import ArrayLike, NDArray

def flat(columns: Mapping[str, ArrayLike]) -> dict[str, NDArray[Any]]: ...
def data_frame(columns: Mapping[str, ArrayLike]) -> Any: ...

class Renamed(dict[str, Any]):
    def __missing__(self, key: str) -> Any: ...
