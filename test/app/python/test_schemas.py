# SPDX-License-Identifier: BSD-3-Clause
"""What the programs write as JSON is as its schema says, every key of it, and a file that is not is refused by the schema."""

import copy
import json
import os
import re
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT, clinic_file, clinic_page
from json_schema import SCHEMAS, WORDS, faults


def check(name, value, parts=()):
    """Checks a value against a schema. parts: its definitions of which the value is one; a schema of several kinds of results has them."""
    schema = json.loads((SCHEMAS / f"{name}.schema.json").read_text())
    assert faults(value, schema, schema) == []
    for part in parts:
        schema = {**schema["$defs"][part], "$defs": schema["$defs"]}
        assert faults(value, schema, schema) == []
    # Each key that is required is missed, and one that is unknown is found.
    for key in list(value):
        less = copy.deepcopy(value)
        del less[key]
        assert bool(faults(less, schema, schema)) == (key in schema.get("required", [key])), key
    assert faults({**value, "unknown": 1}, schema, schema) != []


@pytest.mark.parametrize("file", sorted(SCHEMAS.glob("*.json")), ids=lambda file: file.stem)
def test_schemas_use_what_is_checked_and_name_the_command(file):
    schema = json.loads(file.read_text())
    assert schema["$schema"] == "https://json-schema.org/draft/2020-12/schema" and "perilymph-cli" in schema["title"]

    def look(node):
        assert set(node) <= WORDS, set(node) - WORDS
        for key in ("properties", "$defs"):
            for each in node.get(key, {}).values():
                look(each)
        for each in [*node.get("anyOf", []), *[node[key] for key in ("items", "additionalProperties") if isinstance(node.get(key), dict)]]:
            look(each)

    look(schema)


def test_every_command_that_writes_json_has_a_schema_in_the_guide():
    manual = (ROOT / "packaging/man/perilymph-cli.1").read_text().replace("\\-", "-")
    titles = " ".join(json.loads(file.read_text())["title"] for file in SCHEMAS.glob("*.json"))
    sections = re.split(r'^\.SS "(perilymph-cli [^"]+)"\n', manual.partition("\n.SH EXAMPLES")[0], flags=re.MULTILINE)[1:]
    writing = [name for name, text in zip(sections[::2], sections[1::2]) if re.search(r"--json|JSON|(?<!mrk)\.json", text)]
    assert len(writing) >= 12
    for name in writing:
        command = "perilymph-cli archive" if name.startswith("perilymph-cli archive") else name
        assert command in titles, name
    # Each file of JSON that an output folder has is named in a title, too.
    for file in set(re.findall(r"[\w-]+\.json", manual)) - {"measures.json", "mrk.json"}:
        assert file in titles, file
    page = (ROOT / "resources/guide/python.md").read_text()
    assert all(f"schemas/{file.name}" in page for file in SCHEMAS.glob("*.json"))


@pytest.mark.parametrize("words", [
    ["contour-published", "--nodes", 30, "--set", "stop_travel_mm=0.5"],
    ["surgery-flex28", "--nodes", 50, "--set", "dt_ms=5", "--set", "stop_force_N=0.05", "--set", "partition_strength_N=0.05"],
    ["contour-published", "--nodes", 50, "--set", "dt_ms=5", "--set", "friction=soap-90"]])
def test_simulations_are_as_their_schema_says(cli, tmp_path, words):
    cli("simulate", "--scenario", *words, "--json", tmp_path / "a.json")
    check("simulate", json.loads((tmp_path / "a.json").read_text()))


@pytest.mark.parametrize("words", [["--preset", "published"], ["--preset", "clark"], ["--a-mm", 9.0, "--b-mm", 6.8], ["--patient", "measured"],
                                   ["--a-mm", 10.6, "--b-mm", 6.6, "--h-mm", 4.0], ["--sample", 3]])
def test_measures_of_anatomies_are_as_their_schema_says(cli, tmp_path, words):
    cli("anatomy", *words, "--json", tmp_path / "a.json")
    value = json.loads((tmp_path / "a.json").read_text())
    schema = json.loads((SCHEMAS / "anatomy.schema.json").read_text())
    assert faults(value, schema, schema) == []


def test_an_imported_surface_is_as_its_schema_says(cli, tmp_path):
    cli("anatomy", "--preset", "mean", "--surface", tmp_path / "mean.stl")
    cli("anatomy", "--import", tmp_path / "mean.stl", "--json", tmp_path / "a.json")
    check("anatomy-import", json.loads((tmp_path / "a.json").read_text()))


def test_devices_are_as_their_schema_says(cli, tmp_path):
    cli("devices", "--json", tmp_path / "list.json")
    check("devices", json.loads((tmp_path / "list.json").read_text()), parts=("list",))
    plugin = Path(os.environ["PERILYMPH_PROGRAMS"]).parent / "plugins/devices/example/example.so"
    if plugin.exists():
        cli("devices", "--plugin", plugin, "--json", tmp_path / "plugin.json")
        check("devices", json.loads((tmp_path / "plugin.json").read_text()), parts=("plugin",))


def test_servers_of_archives_are_as_their_schema_says(cli, tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    cli("archive", "servers", "--add", "pacs", "--ae-title", "PACS", "--host", "pacs.invalid", "--port", 104, "--own-ae-title", "ME", "--json",
        tmp_path / "a.json")
    check("archive", json.loads((tmp_path / "a.json").read_text()), parts=("servers",))


@pytest.mark.parametrize("patients", [0, 1])
def test_predictions_are_as_their_schema_says(cli, tmp_path, patients):
    cli("predict", "--array", "flex24", "--patients", patients, "--out", tmp_path / "p")
    check("prediction", json.loads((tmp_path / "p/prediction.json").read_text()))


def test_the_clinical_table_is_as_its_schema_says(cli, tmp_path):
    cli("predict", "--all", "--patients", 0, "--out", tmp_path / "p")
    check("clinical-table", json.loads((tmp_path / "p/clinical-table.json").read_text()))


def test_validations_are_as_their_schemas_say(cli, tmp_path):
    cli("validate", "--runs", 2, "--set", "nodes=30", "--out", tmp_path / "v")
    check("validation", json.loads((tmp_path / "v/summary.json").read_text()))
    cli("validate", "--prior-predictive", "--draws", 20, "--out", tmp_path / "p")
    check("prior-predictive", json.loads((tmp_path / "p/prior-predictive.json").read_text()))


def test_the_resistance_of_a_clinic_that_a_plan_reads_is_as_its_schema_says(cli, tmp_path):
    page = clinic_page()
    check("clinic-resistance", page)
    cli("plan", "--patient", "measured", "--arrays", "flex24", "--samples", 2, "--all-samples", "--clinic-resistance",
        clinic_file(tmp_path / "clinic.json"), "--out", tmp_path / "plan")
    schema = json.loads((SCHEMAS / "clinic-resistance.schema.json").read_text())
    for wrong in ({"kind": "another"}, {"probability": page["probability"][:40]}, {"probability": [row[:20] for row in page["probability"]]}):
        assert faults({**page, **wrong}, schema, schema) != []


def test_plans_are_as_their_schema_says(cli, tmp_path):
    cli("plan", "--patient", "measured", "--arrays", "flex24", "--arrays", "contour-advance", "--samples", 2, "--all-samples", "--out",
        tmp_path / "plan")
    check("plan", json.loads((tmp_path / "plan/plan.json").read_text()))


def test_outcomes_are_as_their_schema_says(cli, tmp_path):
    (tmp_path / "library/patients").mkdir(parents=True)
    cli("outcomes", "--library", tmp_path / "library", "--out", tmp_path / "outcomes")
    check("outcomes", json.loads((tmp_path / "outcomes/outcomes.json").read_text()))


PHANTOM = Path(os.environ["PERILYMPH_PROGRAMS"]) / "perilymph-ct-phantom"


@pytest.mark.skipif(not PHANTOM.exists(), reason="this build has no VTK and cannot read a CT")
def test_measures_of_a_ct_are_as_their_schema_says(cli, tmp_path):
    subprocess.run([PHANTOM, "1", tmp_path / "ct", "clinical"], check=True, capture_output=True)
    cli("ct", "info", tmp_path / "ct", "--json", tmp_path / "info.json")
    check("ct-info", json.loads((tmp_path / "info.json").read_text()))
    cli("ct", "measure", tmp_path / "ct", "--json", tmp_path / "m.json")
    value = json.loads((tmp_path / "m.json").read_text())
    schema = json.loads((SCHEMAS / "ct-measure.schema.json").read_text())
    assert faults(value, schema, schema) == [] == faults({"ears": [value, value]}, schema, schema)
    for key in ("A_mm", "side", "provenance"):
        assert faults({each: value[each] for each in value if each != key}, schema, schema) != []
    assert faults({"ears": [value]}, schema, schema) != []


@pytest.mark.skipif(not PHANTOM.exists(), reason="this build has no VTK and cannot write markups")
def test_markups_of_a_patient_are_as_their_schema_says(cli, tmp_path):
    (tmp_path / "P-017-left.toml").write_text('label = "P-017"\nside = "left"\na_mm = 9.1\nb_mm = 6.7\n')
    key = "a" * 64
    items = [{"kind": "distance", "lps_mm": [[1, 2, 3], [4, 6, 15]], "text": ""},
             {"kind": "angle", "lps_mm": [[5, 0, 0], [0, 0, 0], [0, 2, 0]], "text": ""},
             {"kind": "note", "lps_mm": [[-1.5, 2, 3]], "text": "hoher Bulbus"},
             {"kind": "facial_nerve", "lps_mm": [[1, 2, 3], [1, 2, 4]], "text": ""}]
    record = {"format": 3, "tags": [], "notes": "", "archived": False, "changed_by_hand": False, "scans": [], "versions": [],
              "plans": [], "insertions": [], "outcomes": [],
              "markups": [{"series_sha256": key, "coordinate_system": "LPS", "voxel_edges_mm": [[0.3, 0, 0], [0, 0.3, 0], [0, 0, 0.3]],
                           "items": items}]}
    (tmp_path / "P-017-left.json").write_text(json.dumps(record))
    cli("ct", "markups", tmp_path / "P-017-left.toml", "--json", tmp_path / "m.json", "--csv", tmp_path / "m.csv",
        "--markups", tmp_path / "m.mrk.json")
    found = json.loads((tmp_path / "m.json").read_text())
    check("ct-markups", found)
    assert [{each: item[each] for each in ("kind", "lps_mm", "text")} for item in found["markups"]] == items
    assert abs(found["markups"][0]["value"] - 13) < 1e-12 and abs(found["markups"][1]["value"] - 90) < 1e-12
    low, high = found["markups"][0]["ci95"]
    assert abs(high - low - 2 * 1.96 * 0.3 / 6**0.5) < 1e-12
    assert len((tmp_path / "m.csv").read_text().splitlines()) == 1 + 2 + 3 + 1 + 2
    lists = json.loads((tmp_path / "m.mrk.json").read_text())["markups"]
    assert [each["type"] for each in lists] == ["Line", "Angle", "Fiducial", "Curve"]
    cli("ct", "markups", tmp_path / "P-017-left.toml", "--series", "aaaa")


@pytest.mark.skipif(not PHANTOM.exists(), reason="this build has no VTK and cannot read a CT")
def test_contacts_in_a_ct_are_as_their_schema_says_and_where_the_phantom_has_them(cli, tmp_path):
    subprocess.run([PHANTOM, "implanted", "203", "flex24", tmp_path / "ear", "clinical"], check=True, capture_output=True)
    truth = json.loads((tmp_path / "ear/truth.json").read_text())
    cli("ct", "contacts", tmp_path / "ear/after", "--preop", tmp_path / "ear/before", "--array", "flex24", "--json", tmp_path / "c.json",
        "--csv", tmp_path / "c.csv", "--markups", tmp_path / "c.mrk.json", "--picture", tmp_path / "c.png")
    found = json.loads((tmp_path / "c.json").read_text())
    check("ct-contacts", found)
    assert [each["number"] for each in found["contacts"]] == list(range(1, 13))
    for here, there in zip(found["contacts"], truth["contacts"]):
        off = sum((a - b)**2 for a, b in zip(here["position_lps_mm"], there["position_lps_mm"]))**0.5
        assert off < 4 * here["error_mm"] < 1.0, here["number"]
    low, high = found["angular_insertion_depth_deg"]["ci95"]
    assert low < truth["angular_insertion_depth_deg"] < high
    # The table and the markups say the same.
    rows = [line.split(",") for line in (tmp_path / "c.csv").read_text().splitlines()]
    names = [line.split(",")[0] for line in (tmp_path / "c-dictionary.csv").read_text().splitlines()[1:]]
    assert rows[0] == names and len(rows) == 13
    assert abs(float(rows[1][names.index("angle_deg")]) - found["contacts"][0]["angle_deg"]["value"]) < 1e-2
    markups = json.loads((tmp_path / "c.mrk.json").read_text())["markups"]
    assert markups[0]["coordinateSystem"] == "LPS" and markups[0]["controlPoints"][4]["position"] == found["contacts"][4]["position_lps_mm"]
    # Another array's name is contradicted by the spacing, and a CT without an array is refused.
    cli("ct", "contacts", tmp_path / "ear/after", "--preop", tmp_path / "ear/before", "--array", "flexsoft", "--json", tmp_path / "d.json")
    assert json.loads((tmp_path / "d.json").read_text())["flags"]
    with pytest.raises(AssertionError, match="are the same series"):
        cli("ct", "contacts", tmp_path / "ear/before", "--preop", tmp_path / "ear/before", "--array", "flex24", "--json", tmp_path / "e.json")
    assert not (tmp_path / "e.json").exists()
