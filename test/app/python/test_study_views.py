# SPDX-License-Identifier: BSD-3-Clause
"""A study in SQL: numbers are numbers, every view says what NumPy finds in the rows, and files of earlier versions are read."""

import json
import re
import sqlite3

import numpy as np
import pytest
from conftest import ROOT

import perilymph

# As files of earlier versions have them.
FORMER = [
    "CREATE VIEW setting AS SELECT insertion.number AS number, json_each.key AS key, json_each.value AS value FROM insertion, "
    "json_each(insertion.settings)",
    "CREATE VIEW outcome_by_size AS SELECT 0.5 * CAST(A_mm / 0.5 AS INTEGER) AS A_from_mm, count(*) AS insertions, "
    "sum(ending = 'finished') AS finished, avg(CASE WHEN ending = 'finished' THEN angle_deg END) AS mean_angle_deg, "
    "avg(CASE WHEN ending = 'finished' THEN coverage_percent END) AS mean_coverage_percent, "
    "avg(CASE WHEN ending = 'finished' THEN peak_mN END) AS mean_peak_mN FROM insertion GROUP BY A_from_mm",
]


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    folder = tmp_path_factory.mktemp("study")
    scenario = perilymph.read_scenario("surgery-flex28", {"nodes": 30, "dt_ms": 10})
    study = perilymph.study(scenario, folder, vary={"array": ["flex24", "medel-standard"], "stop_force_N": [0.02, 0.5]},
                            ranges={"speed_mm_s": (0.3, 1.0)}, samples=2, cochleae=6, mean=True, seed=2, contacts=True,
                            profile_spacing_mm=2.0)
    assert len(study) == 56
    return folder


@pytest.fixture(scope="module")
def database(folder):
    with sqlite3.connect(folder / "study.sqlite") as database:
        database.row_factory = sqlite3.Row
        yield database


@pytest.fixture(scope="module")
def rows(database):
    """The insertions as columns, with their settings, numbers as numbers."""
    rows = [dict(row) | json.loads(row["settings"]) for row in database.execute("SELECT * FROM insertion")]
    for row in rows:
        row["array_name"] = perilymph.read_array(row["array"]).name
    columns = {name: np.array([row[name] for row in rows]) for name in rows[0]}
    return columns | {key: columns[key].astype(float) for key in ("stop_force_N", "speed_mm_s")}


def query(database, sql):
    return [tuple(row) for row in database.execute(sql)]


def mean(values):
    return None if len(values) == 0 else pytest.approx(float(np.mean(values)))


STOPPED = ("stopped_by_resistance", "buckled", "out_of_opening", "folded_tip", "jammed")


def test_the_study_has_stopped_and_finished_insertions(rows):
    assert (rows["ending"] == "finished").sum() >= 3 and np.isin(rows["ending"], STOPPED).sum() >= 3


def test_settings_are_numbers_where_they_are(database, rows):
    for key, kind in (("array", "text"), ("stop_force_N", "real"), ("speed_mm_s", "real")):
        assert query(database, f"SELECT DISTINCT typeof(value) FROM setting WHERE key = '{key}'") == [(kind,)]
        found = dict(query(database, f"SELECT number, value FROM setting WHERE key = '{key}'"))
        assert [found[number] for number in rows["number"]] == list(rows[key])
    assert query(database, "SELECT count(*) FROM setting WHERE key = 'speed_mm_s' AND value > 5") == [(0,)]
    fast = query(database, "SELECT count(*) FROM setting WHERE key = 'speed_mm_s' AND value > 0.65")
    assert fast == [(int((rows["speed_mm_s"] > 0.65).sum()),)]


def test_outcomes_by_setting_are_those_of_the_rows(database, rows):
    names = [each[1] for each in query(database, "PRAGMA table_info(outcome_by_setting)")]
    found = {(row["key"], row["value"]): dict(row) for row in database.execute("SELECT * FROM outcome_by_setting")}
    expected = {(key, value) for key in ("array", "array_name", "stop_force_N") for value in np.unique(rows[key])}
    assert set(found) == expected  # none for each of the 14 drawn speeds
    for (key, value), row in found.items():
        here = rows[key] == value
        finished, stopped = here & (rows["ending"] == "finished"), here & np.isin(rows["ending"], STOPPED)
        assert (row["insertions"], row["finished"], row["stopped"]) == (here.sum(), finished.sum(), stopped.sum())
        for name in ("angle_deg", "coverage_percent", "peak_mN", "partition_mN"):
            assert row[f"mean_{name}"] == mean(rows[name][finished]), name
        for name in ("angle_deg", "peak_mN"):
            assert row[f"mean_stopped_{name}"] == mean(rows[name][stopped]), name
        if finished.any():
            assert row["min_angle_deg"] == rows["angle_deg"][finished].min()
            for name in ("angle_deg", "peak_mN", "partition_mN"):
                assert row[f"max_{name}"] == rows[name][finished].max()
    assert len(names) == 15


def test_outcomes_by_size_are_those_of_the_rows(database, rows):
    size = 0.5 * np.floor(rows["A_mm"] / 0.5)
    found = {row["A_from_mm"]: dict(row) for row in database.execute("SELECT * FROM outcome_by_size")}
    assert sorted(found) == sorted(np.unique(size)) and len(found) >= 2
    for low, row in found.items():
        here = size == low
        finished, stopped = here & (rows["ending"] == "finished"), here & np.isin(rows["ending"], STOPPED)
        assert (row["insertions"], row["finished"], row["stopped"]) == (here.sum(), finished.sum(), stopped.sum())
        for name in ("angle_deg", "coverage_percent", "peak_mN"):
            assert row[f"mean_{name}"] == mean(rows[name][finished]), name
        for name in ("angle_deg", "peak_mN"):
            assert row[f"mean_stopped_{name}"] == mean(rows[name][stopped]), name


def test_endings_by_setting_are_those_of_the_rows(database, rows):
    found = {(row["key"], row["value"]): dict(row) for row in database.execute("SELECT * FROM ending_by_setting")}
    for key in ("array", "stop_force_N"):
        for value in np.unique(rows[key]):
            here, row = rows[key] == value, found[key, value]
            assert row["insertions"] == here.sum()
            for ending in ("finished", "out_of_opening", "buckled", "fault", "refused"):
                assert row[ending] == (here & (rows["ending"] == ending)).sum(), ending
            assert row["finished_percent"] == pytest.approx(100.0 * (rows["ending"][here] == "finished").mean())


def test_the_extreme_insertions_are_those_of_the_rows(database, rows):
    found = {row["number"]: dict(row) for row in database.execute("SELECT * FROM extreme")}
    finished = rows["ending"] == "finished"
    extremes = {
        "has_max_peak": rows["peak_mN"] == rows["peak_mN"].max(),
        "has_max_partition": rows["partition_mN"] == rows["partition_mN"].max(),
        "has_max_angle": rows["angle_deg"] == rows["angle_deg"].max(),
        "has_min_finished_angle": finished & (rows["angle_deg"] == rows["angle_deg"][finished].min()),
    }
    assert set(found) == set(rows["number"][np.any(list(extremes.values()), axis=0)])
    for number, row in found.items():
        for name, which in extremes.items():
            assert row[name] == which[rows["number"] == number][0], name


def test_the_dictionary_explains_every_column_of_every_table_and_view(database):
    tables = [name for name, in query(database, "SELECT name FROM sqlite_master WHERE type IN ('table', 'view')")]
    columns = {(table, each[1]) for table in tables for each in query(database, f"PRAGMA table_info({table})")}
    dictionary = query(database, "SELECT table_name, column_name, unit, meaning FROM dictionary")
    assert {row[:2] for row in dictionary} == columns and len(dictionary) == len(columns)
    for table, column, unit, meaning in dictionary:
        stated = {"mm": "_mm", "mN": "_mN", "deg": "_deg", "Hz": "_Hz", "%": "_percent", "": ""}[unit]
        assert column.endswith(stated) and (unit or column.rpartition("_")[2] not in ("mm", "mN", "deg", "Hz", "percent")), (table, column)
        assert meaning


KEYS = ["array", "array_name", "stop_force_N", "speed_mm_s"]
FEW = ["array", "array_name", "stop_force_N"]  # but not each of the drawn speeds
QUANTITIES = ["angle_deg", "coverage_percent", "depth_mm", "peak_mN", "partition_mN"]


def by_setting(frame):
    """The insertions once for each setting of few values: with its key and value."""
    import pandas

    return pandas.concat([frame.assign(key=key, value=frame[key].astype(object)) for key in FEW])


def of_outcomes(groups, quantities):
    """The columns of a view of outcomes, from groups of insertions."""
    import pandas

    def summary(group):
        finished, stopped = group[group.ending == "finished"], group[group.ending.isin(STOPPED)]
        row = {"insertions": len(group), "finished": len(finished), "stopped": len(stopped)}
        row |= {f"{name}_{quantity}": getattr(finished[quantity], name)() for name, quantity in quantities}
        return pandas.Series(row | {f"mean_stopped_{each}": stopped[each].mean() for each in ("angle_deg", "peak_mN")})

    return groups.apply(summary).reset_index()


def expected_distribution(frame):
    import pandas

    ran = frame[frame.ending != "refused"]
    rows = pandas.concat([ran.assign(selection="all that ran"), frame[frame.ending == "finished"].assign(selection="complete")])
    rows = by_setting(rows).melt(["selection", "key", "value"], QUANTITIES, "quantity", "x")
    groups = rows.groupby(["selection", "key", "value", "quantity"]).x
    return groups.agg(n="size", mean="mean", median="median", quartile25=lambda x: x.quantile(0.25),
                      quartile75=lambda x: x.quantile(0.75)).reset_index()


def expected_endings(frame):
    import pandas

    rows = by_setting(frame)
    counts = pandas.crosstab([rows.key, rows.value], rows.ending)
    total = counts.sum(axis=1)
    return counts.assign(insertions=total, finished_percent=100.0 * counts.get("finished", 0) / total).reset_index()


def expected_extremes(frame):
    finished = frame.ending == "finished"
    flags = {"has_max_peak": frame.peak_mN == frame.peak_mN.max(), "has_max_partition": frame.partition_mN == frame.partition_mN.max(),
             "has_max_angle": frame.angle_deg == frame.angle_deg.max(),
             "has_min_finished_angle": finished & (frame.angle_deg == frame.angle_deg[finished].min())}
    rows = frame[["number", "ending", "peak_mN", "partition_mN", "angle_deg"]].assign(**{name: which.astype(int) for name, which in flags.items()})
    return rows[sum(flags.values()) > 0]


OUTCOMES = [(name, quantity) for quantity in ("angle_deg", "peak_mN", "partition_mN") for name in ("mean", "max")]


def expected_files(frame):
    """Of each array that a setting names, the name that its file states."""
    rows = frame[["array", "array_name"]].drop_duplicates()
    return rows.assign(key="array", value=rows.array, name="array_name", content=rows.array_name)[["key", "value", "name", "content"]]


# What pandas makes of the insertions for each view, and the columns that name a row.
VIEWS = {
    "file_value": (expected_files, ["key", "value", "name"]),
    "setting": (lambda frame: frame.assign(**{key: frame[key].astype(object) for key in KEYS}).melt("number", KEYS, "key", "value"), ["number", "key"]),
    "ending_by_setting": (expected_endings, ["key", "value"]),
    "distribution_by_setting": (expected_distribution, ["selection", "key", "value", "quantity"]),
    "outcome_by_setting": (lambda frame: of_outcomes(by_setting(frame).groupby(["key", "value"]),
                                                     [*OUTCOMES, ("min", "angle_deg"), ("mean", "coverage_percent")]), ["key", "value"]),
    "outcome_by_size": (lambda frame: of_outcomes(frame.assign(A_from_mm=frame.A_mm // 0.5 * 0.5).groupby("A_from_mm"),
                                                  [("mean", each) for each in ("angle_deg", "coverage_percent", "peak_mN")]), ["A_from_mm"]),
    "extreme": (expected_extremes, ["number"]),
}


def test_every_view_has_a_counterpart_in_pandas(database):
    views = {name for name, in query(database, "SELECT name FROM sqlite_master WHERE type = 'view'")}
    assert views == set(VIEWS) | {"dictionary"}  # which explains the others


@pytest.mark.parametrize("view", VIEWS)
def test_a_view_is_what_pandas_makes_of_the_insertions(folder, view):
    pandas = pytest.importorskip("pandas")
    with sqlite3.connect(folder / "study.sqlite") as database:
        frame = pandas.read_sql("SELECT * FROM insertion", database)
        found = pandas.read_sql(f"SELECT * FROM {view}", database)
    settings = pandas.DataFrame(list(frame.settings.map(json.loads)))
    for key in ("stop_force_N", "speed_mm_s"):
        settings[key] = settings[key].astype(float)
    settings["array_name"] = settings["array"].map(lambda name: perilymph.read_array(name).name)
    make, names = VIEWS[view]
    expected = make(frame.join(settings))
    for table in (found, expected):  # numbers and texts stand in one column
        table.sort_values(names, key=lambda column: column.map(str), inplace=True, ignore_index=True)
    assert set(expected) <= set(found)
    # Endings that no insertion has are columns of zeros.
    assert all((found[name] == 0).all() for name in set(found) - set(expected))
    pandas.testing.assert_frame_equal(found[list(expected)], expected, check_dtype=False, check_names=False, rtol=1e-9)


def test_the_queries_of_the_guide_give_what_pandas_gives(folder, database, rows):
    pandas = pytest.importorskip("pandas")
    page = (ROOT / "resources/guide/studies.md").read_text()
    by_array, by_two, lengths = re.findall(r'sqlite3 results/study.sqlite "([^"]*)"', page)
    found = dict(query(database, by_array))
    for array in ("flex24", "medel-standard"):
        assert found[array] == pytest.approx(100 * (rows["ending"][rows["array"] == array] == "finished").mean())
    frame = pandas.DataFrame({key: rows[key] for key in ("array_name", "stop_force_N", "peak_mN")})
    medians = frame.groupby(["array_name", "stop_force_N"]).peak_mN.median()
    found = {row[:2]: row[2] for row in query(database, by_two)}
    assert set(found) == set(medians.index) and len(found) == 4
    assert all(found[key] == pytest.approx(value) for key, value in medians.items())
    columns = perilymph.read_study(folder).to_pandas()
    assert dict(query(database, lengths)) == pytest.approx(dict(zip(columns.number, columns.cdl_oc_mm)))


def test_the_columns_of_python_are_those_of_the_rows(folder, rows):
    columns = perilymph.read_study(folder).columns()
    assert columns["stop_force_N"].dtype == columns["speed_mm_s"].dtype == float
    for name in ("number", "array", "ending", "reason", "ticks", "stop_force_N", "speed_mm_s", "A_mm", "cochlea"):
        assert list(columns[name]) == list(rows[name]), name
    assert columns["peak_mN"] == pytest.approx(rows["peak_mN"])


@pytest.mark.parametrize("drop", [[], ["dictionary", "setting", "outcome_by_size"]])
def test_a_study_of_an_earlier_version_is_read(folder, tmp_path, drop):
    file = tmp_path / "study.sqlite"
    file.write_bytes((folder / "study.sqlite").read_bytes())
    with sqlite3.connect(file) as database:
        for view in drop:
            database.execute(f"DROP VIEW {view}")
        for statement in FORMER if drop else []:
            database.execute(statement)
    study = perilymph.read_study(file)
    assert (len(study), study.seal) == (56, "intact")


def test_a_view_of_another_program_is_refused(folder, tmp_path):
    file = tmp_path / "study.sqlite"
    file.write_bytes((folder / "study.sqlite").read_bytes())
    with sqlite3.connect(file) as database:
        database.execute("CREATE VIEW mine AS SELECT 1")
    with pytest.raises(perilymph.Error, match="content"):
        perilymph.read_study(file)
