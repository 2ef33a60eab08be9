# SPDX-License-Identifier: BSD-3-Clause
"""Friction of an array on the lining, built in Python."""

import json
import math
from dataclasses import dataclass
from typing import Optional

_TITLE = "Friction built in Python"


@dataclass(frozen=True)
class Friction:
    """Coefficients of friction: static, dynamic (by default the static one), and stopping (by default half of the dynamic one, about
    as in the shipped files). With `speed_mm_s` and `coefficient` the dynamic one follows a table by speed. The standard deviations
    of the logarithm, common to all ears and between ears, are drawn in plans. A simulation takes it as {"friction": Friction(0.12)},
    a plan as friction=Friction(0.12, ear_sd_log=0.2)."""

    static: float
    dynamic: Optional[float] = None
    stopping: Optional[float] = None
    stribeck_mm_s: float = 0.1
    shared_sd_log: float = 0.0
    ear_sd_log: float = 0.0
    speed_mm_s: tuple[float, ...] = ()
    coefficient: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        def keep(name: str, value: object) -> None:
            object.__setattr__(self, name, value)

        if isinstance(self.static, str):
            raise TypeError("static must be a number; a friction of a file is named as a text: {'friction': 'tissue'}")
        keep("speed_mm_s", tuple(map(float, self.speed_mm_s)))
        keep("coefficient", tuple(map(float, self.coefficient)))
        keep("static", float(self.static))
        dynamic = min(self.coefficient, default=self.static) if self.dynamic is None else float(self.dynamic)
        keep("dynamic", dynamic)
        keep("stopping", dynamic / 2.0 if self.stopping is None else float(self.stopping))
        for name in ("stribeck_mm_s", "shared_sd_log", "ear_sd_log"):
            keep(name, float(getattr(self, name)))
        for name in ("static", "dynamic", "stopping", "stribeck_mm_s", "shared_sd_log", "ear_sd_log", "speed_mm_s", "coefficient"):
            value = getattr(self, name)
            for each in value if isinstance(value, tuple) else (value,):
                if not (math.isfinite(each) and each >= 0.0):
                    from perilymph import Error  # the engine loads this module while it is loaded itself

                    raise Error(f"{name} of a friction is {each}; it must be a finite number of at least 0. Correct it.")

    def scenario_values(self) -> dict[str, object]:
        """Its values by the keys of a scenario."""
        values = {"friction": _TITLE, "friction_static": self.static, "friction_dynamic": self.dynamic,
                  "friction_stopping": self.stopping, "friction_stribeck_mm_s": self.stribeck_mm_s,
                  "friction_shared_sd_log": self.shared_sd_log, "friction_ear_sd_log": self.ear_sd_log}
        if self.coefficient:
            values |= {"friction_speed_mm_s": self.speed_mm_s, "friction_coefficient": self.coefficient}
        return values

    @property
    def text(self) -> str:
        """Its file (TOML), as the programs read it."""
        def table(name: str, **values: object) -> str:
            rows = "".join(f"{key} = {json.dumps(value)}\n" for key, value in values.items())
            return f"\n[{name}]\n{rows}source = \"built in Python\"\nconfidence = \"low\"\n"

        by_speed = bool(self.coefficient)
        text = f"title = {json.dumps(_TITLE)}\n"
        text += table("coefficients", static=self.static, **({} if by_speed else {"dynamic": self.dynamic}))
        text += table("by_speed", speed_mm_s=self.speed_mm_s, coefficient=self.coefficient) if by_speed else ""
        text += table("stopping", coefficient=self.stopping)
        text += table("stribeck", speed_mm_s=self.stribeck_mm_s)
        if self.shared_sd_log or self.ear_sd_log:
            text += table("spread", shared_sd_log=self.shared_sd_log, ear_sd_log=self.ear_sd_log)
        return text
