# SPDX-License-Identifier: BSD-3-Clause
"""Types of the values that replace a scenario's, for editors and mypy."""

import collections.abc
import os
from typing import TYPE_CHECKING, Any, Literal, TypedDict, Union

import numpy as np
from numpy.typing import NDArray

from perilymph._friction import Friction

if TYPE_CHECKING:
    from perilymph import Array, Cochlea, Patient
else:
    from perilymph._engine import Array, Cochlea, Patient

__all__ = ["Numbers", "ScenarioValues"]

Numbers = Union[collections.abc.Sequence[float], NDArray[np.floating[Any]]]


class ScenarioValues(TypedDict, total=False):
    """Values that replace a scenario's, by its keys, with their types. A dict that is annotated with it is completed by editors, and mypy finds
    misspelled keys and wrong types in it. Units are in the names; ranges are in the reference of the guide."""

    title: str
    patient: Union[str, os.PathLike[str], Patient]
    side: Literal["right", "left"]
    anatomy: Literal["published", "mean", "clark"]
    lead_in_mm: float
    array: Union[str, os.PathLike[str], Array]
    array_fingerprint: str
    calibration: Union[str, os.PathLike[str]]
    stiffness_scale: float
    residual_curvature_fraction: float
    wire_packing: float
    taper_fraction: float
    wire_yield_MPa: float
    stylet_yield_MPa: float
    relaxation_fraction: Numbers
    relaxation_time_s: Numbers
    technique: Literal["standard", "aos"]
    speed_mm_s: float
    start_inside_mm: float
    stop_travel_mm: float
    withdraw: bool
    stylet_pull_mm_s: float
    approach_tilt_deg: float
    approach_turn_deg: float
    free_length_mm: float
    friction: Union[str, os.PathLike[str], Friction]
    friction_static: float
    friction_dynamic: float
    friction_stopping: float
    friction_stribeck_mm_s: float
    friction_speed_mm_s: Numbers
    friction_coefficient: Numbers
    friction_shared_sd_log: float
    friction_ear_sd_log: float
    film_relaxation_fraction: float
    film_relaxation_time_s: float
    opening: Literal["none", "round-window", "cochleostomy"]
    cochleostomy_diameter_mm: float
    opening_outward_mm: float
    opening_vertical_mm: float
    passage_mm: float
    passage_modulus_MPa: float
    passage_friction: float
    rib_exit_loss: float
    rim_stiffness_N_m: float
    wall_stiffness_N_m: float
    wall_lining_mm: float
    wall_tangential_stiffness_N_m: float
    wall_section_delay_ms: float
    wall_edge_mm: float
    membrane: Literal["rigid", "soft"]
    membrane_stiffness_N_m: float
    partition_strength_N: float
    coupling: Literal["rigid", "spring"]
    coupling_stiffness_N_m: float
    coupling_damping_N_s_m: float
    force_scale: float
    stop_force_N: float
    model: Literal["rod", "points"]
    nodes: int
    dt_ms: float
    seed: int
    cochlea: Cochlea
