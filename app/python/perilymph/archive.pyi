# SPDX-License-Identifier: BSD-3-Clause
from os import PathLike
from typing import NamedTuple, Optional, Union

__all__ = ["Retrieved", "Sent", "Series", "Study", "find", "find_series", "retrieve", "send", "servers", "test"]

_Place = Union[str, PathLike[str]]

class Study(NamedTuple):
    uid: str
    date: str = ""
    modalities: str = ""
    description: str = ""
    patient_id: Optional[str] = None
    patient_name: Optional[str] = None
    birth_date: Optional[str] = None

class Series(NamedTuple):
    study_uid: str
    uid: str
    number: str = ""
    modality: str = ""
    description: str = ""
    images: Optional[int] = None

class Retrieved(NamedTuple):
    folder: str
    images: int
    resumed: int
    obstacle: str

class Sent(NamedTuple):
    study_uid: str
    series_uid: str
    instance_uid: str
    series_number: str
    warning: str

def servers(*, program: _Place = "perilymph-cli") -> list[str]: ...
def test(server: str, *, program: _Place = "perilymph-cli") -> None: ...
def find(
    server: str,
    *,
    patient_id: Optional[str] = None,
    patient_name: Optional[str] = None,
    birth_date: Optional[str] = None,
    since: Optional[str] = None,
    until: Optional[str] = None,
    modality: Optional[str] = None,
    show_patients: bool = False,
    program: _Place = "perilymph-cli",
) -> list[Study]: ...
def find_series(server: str, study: Union[Study, str], *, program: _Place = "perilymph-cli") -> list[Series]: ...
def retrieve(server: str, series: Series, folder: _Place, *, program: _Place = "perilymph-cli") -> Retrieved: ...
def send(server: str, file: _Place, *, program: _Place = "perilymph-cli") -> Sent: ...
