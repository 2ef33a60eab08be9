# SPDX-License-Identifier: BSD-3-Clause
"""The result of 'perilymph-cli ct measure --json'."""

import numpy as np

from perilymph._engine import Error, Patient
from perilymph._json import Page, number_of, read_json, text_of

_MEASURES = ("A_mm", "B_mm", "H_mm", "cdl_oc_mm")


class CtMeasures(Page):
    """A cochlea measured in a CT: 'A_mm', 'B_mm', 'H_mm' and 'cdl_oc_mm', the cochlear duct length along the organ of
    Corti, with their errors. Where the turns that the length's formula assumes were not seen, its value, error and
    interval are None and 'duct_length_reason' says why. Points are in the patient's frame (LPS);
    'second_cochlea_lps_mm' is None unless the volume shows another one."""

    _COMMAND = "perilymph-cli ct measure --json"

    def _read(self, page):
        self.duct_length_reason = text_of(page["cdl_oc_reason"]) if page["cdl_oc_mm"] is None else None
        given = [key for key in _MEASURES if key != "cdl_oc_mm" or self.duct_length_reason is None]
        absent = dict.fromkeys(_MEASURES)
        self.values_mm = absent | {key: number_of(page[key]["value"]) for key in given}
        self.sds_mm = absent | {key: number_of(page[key]["sd"]) for key in given}
        self.intervals95_mm = absent | {key: (number_of(page[key]["ci95"][0]), number_of(page[key]["ci95"][1]))
                                        for key in given}
        self.side = text_of(page["side"])
        self.flags = [text_of(each) for each in page["flags"]]
        self.warnings = [text_of(each) for each in page["warnings"]]
        self.round_window_lps_mm = _vector(page["round_window_lps_mm"])
        self.center_lps_mm = _vector(page["center_lps_mm"])
        self.axis_lps = _vector(page["axis_lps"])
        second = page.get("second_cochlea_lps_mm")
        self.second_cochlea_lps_mm = None if second is None else _vector(second)
        self.provenance = dict(page["provenance"])

    def __repr__(self):
        shown = [f"{key[:-3]} {self.values_mm[key]:.2f} mm (SD {self.sds_mm[key]:.2f})" for key in ("A_mm", "B_mm", "H_mm")]
        return f"<perilymph.CtMeasures, {self.side} ear, {', '.join([*shown, *self.flags])}>"

    def patient(self, label="measured"):
        """The patient with these measures and their standard deviations. Refused where the turns that the scala tympani is
        built with were not seen."""
        if self.duct_length_reason is not None:
            raise Error("The scala tympani is built with 2.5 turns, which were not seen in this cochlea. No patient is made "
                        "of its measures.")
        return Patient(a_mm=self.values_mm["A_mm"], b_mm=self.values_mm["B_mm"], h_mm=self.values_mm["H_mm"],
                       a_sd_mm=self.sds_mm["A_mm"], b_sd_mm=self.sds_mm["B_mm"], h_sd_mm=self.sds_mm["H_mm"],
                       side=self.side, label=label)


def _vector(values):
    if len(values) != 3:
        raise ValueError(f"{values!r} is no point")
    return np.array([number_of(value) for value in values])


def read_measures(file):
    """Reads the result of 'perilymph-cli ct measure --json' for one ear."""
    page, name = _page(file)
    if isinstance(page, dict) and "ears" in page:
        raise Error(f"{name} holds both ears. Read it with read_both_measures.")
    return CtMeasures(page, name)


def read_both_measures(file):
    """Reads the result of 'perilymph-cli ct measure --side both --json': a list, the right ear first."""
    page, name = _page(file)
    ears = page.get("ears") if isinstance(page, dict) else None
    if not isinstance(ears, list) or len(ears) != 2:
        raise Error(f"{name} does not hold both ears. Read it with read_measures, or measure with '--side both'.")
    return [CtMeasures(ear, name) for ear in ears]


def _page(file):
    return read_json(file, 1, "Give the file of 'ct measure --json'.")
