# SPDX-License-Identifier: BSD-3-Clause
"""The implanted array in a CT after surgery, and a clinic's outcomes beside its plans, by perilymph-cli.

Points are in the patient's frame of the CT after surgery (LPS) [mm], angles in degrees from the round window. A CT does not
show the basilar membrane: what is said of the scala is a probability, never a diagnosis. An operation that fails raises
perilymph.Error with the program's sentence."""

import math
import os
import tempfile
from typing import NamedTuple, Optional

import numpy as np

from perilymph._engine import Patient, _array_name
from perilymph._json import Page, number_of, read_json, text_of
from perilymph._programs import run_program, word
from perilymph._tables import data_frame

__all__ = ["ArrayOutcomes", "Estimate", "FoundArray", "Hits", "Outcomes", "Resistance", "find", "outcomes", "read", "read_outcomes"]


class Estimate(NamedTuple):
    """A value with its standard deviation and its 95 % interval, all in the unit of the name that has it."""

    value: float
    sd: float
    low95: float
    high95: float


class Hits(NamedTuple):
    """How many of 'ears' lie inside a band of their plans, the share of them, 0 to 1, and its 95 % interval (Wilson)."""

    inside: int
    ears: int
    value: float
    low95: float
    high95: float


class ArrayOutcomes(NamedTuple):
    """The ears with one array; 'array' is empty for all of them. Hits are of the plans' bands of 50 and 90 %. Percentiles are the
    numbers of ears by tenth of the place of what was measured in its plan. 'depth_difference_mm' is the mean of measured depth
    minus the plan's median with its 95 % interval (mean, low, high), None for fewer than two ears."""

    array: str
    depth_in_50: Hits
    depth_in_90: Hits
    angle_in_50: Hits
    angle_in_90: Hits
    depth_percentiles: tuple
    angle_percentiles: tuple
    depth_difference_mm: Optional[tuple]


class Resistance(NamedTuple):
    """What the outcomes tell about a clinic's resistance: a sentence, the ears that ended by resistance, before it, or tell nothing,
    the gain in ln p over the shipped resistance, whether it is offered, and the means of its two shifts. 'file' is where it was
    written, for perilymph.plan(clinic_resistance=...); None if it was not asked for."""

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
    """A result with columns."""

    def to_pandas(self):
        """columns() as a pandas DataFrame, a row each."""
        return data_frame(self.columns())


class FoundArray(_Table):
    """The implanted array as it was found in a CT after surgery.

    array: shipped name or file. side: 'right' or 'left'. angular_insertion_depth_deg: Estimate of the angle of the most apical contact
    inside. inserted_length_mm: Estimate of the length of the tip past the opening. tip_angle_deg, contacts_inside, outside_mm (length
    from the opening to the most basal contact), blur_fwhm_mm. has_fold: the angle turns back. translocation_probability: the largest over
    the contacts inside, 0 to 1, and translocation_angle_deg, where it first exceeds 0.8, else None. is_registered: the cochlea was
    carried over from a CT before surgery; registration_residual is the root mean square difference of both CTs over their gradient, else
    None. flags: names of what is doubtful ('perilymph-cli ct contacts --help' explains them). course_lps_mm: the array's course from
    its tip, shape (n, 3). surgery: what the surgeon stated. seconds: the time that the search took."""

    _COMMAND = "perilymph-cli ct contacts --json"

    def _read(self, page):
        if _whole(page["format"]) != 1:
            raise ValueError(f"its format is {page['format']!r}, not 1")
        self.array = text_of(page["array"])
        self.side = text_of(page["side"])
        self.angular_insertion_depth_deg = _estimate(page["angular_insertion_depth_deg"])
        self.inserted_length_mm = _estimate(page["inserted_length_mm"])
        self.tip_angle_deg = number_of(page["tip_angle_deg"])
        self.contacts_inside = _whole(page["contacts_inside"])
        self.outside_mm = number_of(page["outside_mm"])
        self.blur_fwhm_mm = number_of(page["blur_fwhm_mm"])
        self.has_fold = _flag(page["fold"])
        self.translocation_probability = number_of(page["translocation"]["probability"])
        angle = number_of(page["translocation"]["angle_deg"])
        self.translocation_angle_deg = angle if angle != 0.0 else None
        self.is_registered = text_of(page["registration"]["from"]) == "CT before surgery"
        self.registration_residual = number_of(page["registration"]["residual_mm"]) if self.is_registered else None
        self.flags = tuple(text_of(each) for each in page["flags"])
        self.course_lps_mm = _frozen([[number_of(value) for value in point] for point in page["course_lps_mm"]]).reshape(-1, 3)
        self.course_lps_mm.setflags(write=False)
        self.surgery = dict(page["surgery"])
        self.seconds = number_of(page["seconds"])
        self._columns = _contact_columns(page)

    def columns(self):
        """The contacts, the most apical first: a dict of arrays of shape (n,), as in the CSV file of the command. 'contact' is the
        number, 1 at the tip; 'maker_electrode' that in the maker's fitting software, NaN if not known. For a contact outside these are
        NaN: 'angle_deg', 'greenwood_Hz' and 'spiral_ganglion_Hz' (estimated place frequencies), 'filter_Hz' (center of its default
        filter; NaN without one), 'mismatch_semitones', 'in_scala_tympani' (probability, 0 to 1), 'modiolus_mm' and 'outer_wall_mm'
        (distances, negative beyond the wall). 'error_mm' is the standard deviation of the position along each direction;
        'seen_singly', 'by_hand' and 'inside' are bool; 'x_lps_mm', 'y_lps_mm', 'z_lps_mm' the position. 'array', 'side' and 'flags'
        (joined by spaces) are the same in each row. '_low95' and '_high95' are the ends of 95 % intervals."""
        return {name: values.copy() for name, values in self._columns.items()}

    @property
    def positions_lps_mm(self):
        """Positions of the contacts, the most apical first, shape (n, 3), in the CT after surgery (LPS)."""
        return np.column_stack([self._columns[name] for name in ("x_lps_mm", "y_lps_mm", "z_lps_mm")])

    def __len__(self):
        """Number of contacts."""
        return len(self._columns["contact"])

    def __repr__(self):
        depth = self.angular_insertion_depth_deg
        return (f"<perilymph.outcome.FoundArray '{self.array}', {self.side} ear, {depth.value:.0f} deg "
                f"({depth.low95:.0f} to {depth.high95:.0f}), {self.contacts_inside} of {len(self)} contacts inside"
                f"{''.join(', ' + flag for flag in self.flags)}>")


class Outcomes(_Table):
    """The outcomes of a clinic beside the plans as they were made before surgery. It names neither patients nor days.

    arrays: ArrayOutcomes of all ears, then by array. left_out: number of ears that are not compared by reason, 'ears' their sum.
    resistance: Resistance. angle_offset_deg: (mean, standard deviation) of the shift of measured angles at the same depth. notes: why
    ears were left out, a sentence each, which name patients' codes; empty for outcomes that were read from a file."""

    _COMMAND = "perilymph-cli outcomes"

    def __init__(self, page, name, notes=(), file=None):
        self.notes = tuple(notes)
        self._file = file
        super().__init__(page, name)

    def _read(self, page):
        if _whole(page["format"]) != 1:
            raise ValueError(f"its format is {page['format']!r}, not 1")
        self.arrays = tuple(_array_outcomes(each) for each in page["arrays"])
        self.left_out = {key: _whole(value) for key, value in page["left_out"].items()}
        found = page["resistance"]
        self.resistance = Resistance(text_of(found["summary"]), _whole(found["resisted"]), _whole(found["censored"]),
                                     _whole(found["not_informative"]), number_of(found["gain"]), _flag(found["is_offered"]),
                                     number_of(found["log_friction_shift"]), number_of(found["log_stop_force_shift"]), self._file)
        self.angle_offset_deg = (number_of(page["angle_offset_deg"]["mean"]), number_of(page["angle_offset_deg"]["sd"]))
        self._columns = _ear_columns(page["ears"])

    def columns(self):
        """The ears in the order of surgery: a dict of arrays of shape (n,), bands (n, 5): 'number', 'year', 'array', 'stop_reason',
        'evidence' ('resisted', 'censored', 'none'), 'depth_mm' and 'angle_deg' as measured with 'depth_sd_mm' and 'angle_sd_deg',
        'planned_depth_mm' and 'planned_angle_deg' (quantiles 5, 25, 50, 75, 95 % of the plan), 'depth_percentile' and
        'angle_percentile' (places in the plan, 0 to 1), 'clinic_depth_percentile', 'log_p_clinic' and 'log_p_shipped' (by the
        resistance known from earlier ears). What is not known is NaN."""
        return {name: values.copy() for name, values in self._columns.items()}

    def __len__(self):
        """Number of ears."""
        return len(self._columns["number"])

    def __repr__(self):
        return f"<perilymph.outcome.Outcomes: {len(self)} ears, {self.left_out['ears']} left out>"


def find(series, array, *, side=None, preop=None, patient=None, at_mm=None, csv=None, markups=None, picture=None, program="perilymph-cli"):
    """Finds the contacts of an implanted array in a CT after surgery: a FoundArray. Takes seconds.

    series: folder of slices or a file that 'perilymph-cli ct contacts' reads. array: an Array, or the shipped name or file of one. side: 'right' or
    'left'; None for the ear that is seen best. preop: the CT before surgery, in which the cochlea is measured without metal; None:
    in this CT, with wider errors. patient: a Patient, or the name or file of one, whose side, A and B are compared with this ear's. at_mm: any
    point in the cochlea (x, y, z), LPS, of the CT in which it is measured. csv, markups, picture: files to be written.
    Raises perilymph.Error where no array is found; what is doubtful is in 'flags'."""
    with tempfile.TemporaryDirectory(prefix="perilymph-") as folder:
        file = os.path.join(folder, "contacts.json")
        if isinstance(patient, Patient):
            own = os.path.join(folder, "patient.toml")
            with open(own, "w", encoding="utf-8") as stream:
                stream.write(patient.text)
            patient = own
        options = []
        for option, name, value in (("--array", "array", _array_name(array)), ("--side", "side", side), ("--preop", "preop", preop),
                                    ("--patient", "patient", patient), ("--csv", "csv", csv), ("--markups", "markups", markups),
                                    ("--picture", "picture", picture)):
            if value is not None:
                options.append(f"{option}={word(name, value)}")
        if at_mm is not None:
            options.append("--at=" + ",".join(repr(float(value)) for value in at_mm))
        run_program(program, ["ct", "contacts", "--json", file, *options, "--", word("series", series)])
        return read(file)


def read(file):
    """Reads the result of 'perilymph-cli ct contacts --json': a FoundArray."""
    return FoundArray(*_content(file))


def outcomes(library=None, *, folder=None, resistance=None, program="perilymph-cli"):
    """Compares the outcomes of the saved patients with their plans: Outcomes.

    library: folder with 'patients' and 'plans'; None for the user's own. folder: keeps the files that 'perilymph-cli outcomes' writes
    there: JSON, table with its dictionary, sentences, figures. resistance: file for the clinic's resistance; refused with a sentence
    where it is not offered. The first call takes as long as the plans, where outcomes tell something about resistance."""
    words = [] if library is None else [f"--library={word('library', library)}"]
    words += [] if resistance is None else [f"--resistance={word('resistance', resistance)}"]
    with tempfile.TemporaryDirectory(prefix="perilymph-") as own:
        place = os.path.join(own, "outcomes") if folder is None else word("folder", folder)
        said = run_program(program, ["outcomes", *words, f"--out={place}"])
        page, name = _content(os.path.join(place, "outcomes.json"))
    return Outcomes(page, name, [line for line in said.splitlines() if line], None if resistance is None else os.fspath(resistance))


def read_outcomes(file):
    """Reads the outcomes.json of 'perilymph-cli outcomes': Outcomes."""
    return Outcomes(*_content(file))


def _content(file):
    return read_json(file, 4, "Give a file that perilymph-cli wrote.")


def _whole(value):
    if isinstance(value, bool) or not isinstance(value, int):
        raise ValueError(f"{value!r} is no whole number")
    return value


def _flag(value):
    if not isinstance(value, bool):
        raise ValueError(f"{value!r} is neither true nor false")
    return value


def _estimate(value):
    low, high = value["ci95"]
    return Estimate(number_of(value["value"]), number_of(value["sd"]), number_of(low), number_of(high))


def _frozen(values):
    values = np.array(values)
    values.setflags(write=False)
    return values


def _contact_columns(page):
    """The columns of the command's CSV, from its JSON."""
    absent = math.nan
    contacts = page["contacts"]

    def column(value_of):
        return _frozen([value_of(each) for each in contacts])

    def inside(value_of):
        return column(lambda each: number_of(value_of(each)) if each["inside"] else absent)

    def maybe(name):
        return column(lambda each: number_of(each[name]) if name in each else absent)

    found = {"contact": column(lambda each: _whole(each["number"])), "maker_electrode": maybe("maker_electrode")}

    def estimated(key):
        stem, unit = key.rsplit("_", 1)
        found[key] = inside(lambda each: each[key]["value"])
        for place, ending in enumerate(("low95", "high95")):
            found[f"{stem}_{ending}_{unit}"] = inside(lambda each, place=place: each[key]["ci95"][place])

    for key in ("angle_deg", "greenwood_Hz", "spiral_ganglion_Hz"):
        estimated(key)
    for name in ("filter_Hz", "mismatch_semitones"):
        found[name] = maybe(name)
    for ending in ("low95", "high95"):
        found[f"mismatch_{ending}_semitones"] = 12.0 * np.log2(found[f"spiral_ganglion_{ending}_Hz"] / found["filter_Hz"])
    found["in_scala_tympani"] = inside(lambda each: each["in_scala_tympani"])
    found["error_mm"] = column(lambda each: number_of(each["error_mm"]))
    for name in ("modiolus_mm", "outer_wall_mm"):
        found[name] = inside(lambda each, name=name: each[name])
    for name in ("seen_singly", "by_hand", "inside"):
        found[name] = column(lambda each, name=name: _flag(each[name]))
    for place, name in enumerate(("x_lps_mm", "y_lps_mm", "z_lps_mm")):
        found[name] = column(lambda each, place=place: number_of(each["position_lps_mm"][place]))
    for name, text in (("array", page["array"]), ("side", page["side"]), ("flags", " ".join(page["flags"]))):
        found[name] = column(lambda each, text=text: text_of(text))
    return found


_BAND = ("p5", "p25", "median", "p75", "p95")


def _ear_columns(ears):
    found = {}
    for name in ("number", "year"):
        found[name] = _frozen(np.array([_whole(each[name]) for each in ears], dtype=int))
    for name in ("array", "stop_reason", "evidence"):
        found[name] = _frozen(np.array([text_of(each[name]) for each in ears], dtype=str))
    for name in ("depth_mm", "depth_sd_mm", "planned_depth_mm", "depth_percentile", "angle_deg", "angle_sd_deg", "planned_angle_deg",
                 "angle_percentile", "clinic_depth_percentile", "log_p_clinic", "log_p_shipped"):
        if name.startswith("planned_"):
            rows = [[number_of(each[name][part]) for part in _BAND] if name in each else [math.nan] * 5 for each in ears]
            found[name] = _frozen(np.array(rows, dtype=float).reshape(-1, 5))
        else:
            found[name] = _frozen(np.array([number_of(each[name]) if name in each else math.nan for each in ears], dtype=float))
    return found


def _hits(found, band):
    low, high = found[band]["ci95"]
    return Hits(_whole(found[band]["inside"]), _whole(found["ears"]), number_of(found[band]["value"]), number_of(low), number_of(high))


def _array_outcomes(page):
    difference = page.get("depth_difference_mm")
    return ArrayOutcomes(text_of(page["array"]), _hits(page["depth"], "band50"), _hits(page["depth"], "band90"), _hits(page["angle"], "band50"),
                         _hits(page["angle"], "band90"), tuple(_whole(each) for each in page["depth_percentiles"]),
                         tuple(_whole(each) for each in page["angle_percentiles"]),
                         None if difference is None else (number_of(difference["mean"]), *(number_of(each) for each in difference["ci95"])))
