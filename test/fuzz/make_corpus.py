#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the seed corpus: small inputs that cover everything a reader supports.

    test/fuzz/make_corpus.py PERILYMPH-CLI      such as build/engine/bin/perilymph-cli

Shipped files are seeds by themselves and are not copied. Inputs that once broke something stand
beside these under names of their own, and stay.
"""

import base64
import os
import sqlite3
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

CORPUS = Path(__file__).parent / "corpus"

PATIENT = """label = "measured on the left"
side = "left"
a_mm = 9.2
b_mm = 6.8
h_mm = 4.0
"""

SOURCE = 'source = "none: an input for tests"\nconfidence = "low"\n'

ARRAY = f"""name = "Every table"
maker = "nobody"
note = "Oval, tapered, curled, with ribs and a stylet."

[length]
value_mm = 20.0
{SOURCE}
[insertable]
value_mm = 18.0
{SOURCE}
[tip]
radius_mm = 0.15
taper_mm = 1.0
{SOURCE}
[diameter]
from_tip_mm = [0.0, 19.0]
diameter_mm = [0.5, 0.9]
thickness_mm = [0.4, 0.6]
{SOURCE}
[bending]
from_tip_mm = [0.0, 10.0, 19.0]
bending_N_m2 = [3e-7, 5e-7, 1e-6]
bending_across_N_m2 = [6e-7, 1e-6, 2e-6]
twisting_N_m2 = [1e-7, 2e-7, 3e-7]
{SOURCE}
[rest_curvature]
from_tip_mm = [0.0, 10.0, 15.0]
curvature_per_mm = [0.4, 0.3, 0.0]
{SOURCE}
[contacts]
from_tip_mm = [1.0, 3.0, 5.0]
contact_length_mm = 0.5
plates = "pair"
single_plates = 1
maker_numbering = "from_base"
{SOURCE}
[ribs]
from_tip_mm = [16.0, 17.0]
height_mm = 0.1
length_mm = 0.3
{SOURCE}
[stylet]
from_tip_mm = 2.0
bending_N_m2 = 1e-6
residual_curvature_fraction = 0.1
hold_depth_mm = 8.5
{SOURCE}"""

CALIBRATION = """label = "small"
array = "contour"
source = "none"

[stiffness_scale]
value = 1.5
sd = 0.1
low = 0.5
high = 2.0

[residual_curvature_fraction]
value = 0.0
sd = 0.0
low = 0.0
high = 0.1

[[force]]
travel_mm = 16.5
wanted_N = 0.1
found_N = 0.11
"""

STUDY = """title = "Every key"
scenario = "mean-flex28"
seed = 3
depth = "scenario"
samples = 2

[cochleae]
mean = true
virtual = 2

[vary]
array = ["flex24", "flex28"]
nodes = [30, 40]

[[case]]
friction = "tissue"

[[case]]
friction = "paper"
speed_mm_s = 1.0

[ranges]
approach_tilt_deg = [-5, 5]

[results]
contacts = true
profile_spacing_mm = 1.0
"""

SMALL_STUDY = """title = "Small"
scenario = "mean-flex28"
seed = 1
depth = "scenario"

[cochleae]
mean = true
virtual = 1

[vary]
array = ["flex24", "flex28"]
stop_travel_mm = [0.5]
nodes = [16]
dt_ms = [10.0]

[results]
contacts = true
profile_spacing_mm = 0.25
"""

POINTS = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)]


def stl_text():
    facets = "".join(
        "facet normal 0 0 1\nouter loop\n"
        + "".join("vertex {} {} {}\n".format(*POINTS[corner]) for corner in face)
        + "endloop\nendfacet\n"
        for face in FACES)
    return f"solid a\n{facets}endsolid a\n".encode()


def stl_binary():
    content = b"a tetrahedron".ljust(80, b" ") + struct.pack("<I", len(FACES))
    for face in FACES:
        content += struct.pack("<3f", 0, 0, 1)
        content += b"".join(struct.pack("<3f", *POINTS[corner]) for corner in face)
        content += struct.pack("<H", 0)
    return content


def ply(kind):
    header = (f"ply\nformat {kind} 1.0\nelement vertex {len(POINTS)}\nproperty float x\n"
              f"property float y\nproperty float z\nelement face {len(FACES)}\n"
              "property list uchar int vertex_indices\nend_header\n").encode()
    if kind == "ascii":
        lines = ["{} {} {}".format(*point) for point in POINTS]
        lines += ["3 {} {} {}".format(*face) for face in FACES]
        return header + "\n".join(lines).encode() + b"\n"
    order = "<" if kind == "binary_little_endian" else ">"
    return (header + b"".join(struct.pack(order + "3f", *point) for point in POINTS)
            + b"".join(struct.pack(order + "B3i", 3, *face) for face in FACES))


def vtp(kind):
    """VTK's XML: numbers as text, in base64, or appended behind everything."""
    arrays = [("Points", "Float32", "NumberOfComponents=\"3\"", "f",
               [value for point in POINTS for value in point]),
              ("connectivity", "Int32", "", "i", [corner for face in FACES for corner in face]),
              ("offsets", "Int32", "", "i", [3 * (i + 1) for i in range(len(FACES))])]
    tags, appended = [], b""
    for name, type_name, more, letter, values in arrays:
        numbers = struct.pack(f"<{len(values)}{letter}", *values)
        block = struct.pack("<I", len(numbers)) + numbers
        head = f'<DataArray type="{type_name}" Name="{name}" {more} format="{kind}"'
        if kind == "appended":
            tags.append(f'{head} offset="{len(appended)}"/>')
            appended += block
        elif kind == "binary":
            tags.append(f"{head}>{base64.b64encode(block).decode()}</DataArray>")
        else:
            tags.append(f"{head}>{' '.join(map(str, values))}</DataArray>")
    head = ('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1" '
            'byte_order="LittleEndian"><PolyData>'
            f'<Piece NumberOfPoints="{len(POINTS)}" NumberOfPolys="{len(FACES)}">'
            f"<Points>{tags[0]}</Points><Polys>{tags[1]}{tags[2]}</Polys></Piece></PolyData>")
    content = head.encode()
    if kind == "appended":
        content += b'<AppendedData encoding="raw">_' + appended + b"</AppendedData>"
    return content + b"</VTKFile>\n"


def sessions(cli):
    """A recording of a few ticks in pages of 512 bytes, closed and as if it were being written."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "some.insertion"
        subprocess.run([cli, "simulate", "--scenario", "mean-flex28", "--set", "stop_travel_mm=0.1",
                        "--set", "dt_ms=10", "--set", "nodes=16", "--record", str(file)],
                       check=True, stdout=subprocess.DEVNULL)
        database = sqlite3.connect(file)
        text = database.execute("SELECT value FROM meta WHERE key = 'scenario'").fetchone()[0]
        database.execute("UPDATE meta SET value = '2010-05-17T09:30:00Z' WHERE key = 'started_utc'")
        database.commit()
        database.execute("PRAGMA page_size = 512")
        database.execute("VACUUM")
        database.close()
        closed = file.read_bytes()
    # Bytes 18 and 19 of SQLite's header: 2 where a write-ahead log is kept.
    return text, closed, closed[:18] + b"\2\2" + closed[20:]


def tables(cli, command, name):
    """A file of results in pages of 512 bytes, as the command writes it into a folder."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([cli, *command, "--out", folder], check=True, stdout=subprocess.DEVNULL,
                       env={**os.environ, "PERILYMPH_FEW_DRAWS": "1"})
        database = sqlite3.connect(Path(folder) / name)
        database.execute("UPDATE meta SET value = 'Perilymph' WHERE key = 'program'")
        database.commit()
        database.execute("PRAGMA page_size = 512")
        database.execute("VACUUM")
        database.close()
        return (Path(folder) / name).read_bytes()


def keep(target, name, content):
    file = CORPUS / target / name
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_bytes(content if isinstance(content, bytes) else content.encode())


def main(cli):
    keep("patient", "left-with-height.toml", PATIENT)
    keep("array", "every-table.toml", ARRAY)
    keep("calibration", "small.toml", CALIBRATION)
    keep("study", "every-key.toml", STUDY)
    keep("surface_file", "text.stl", b"S" + stl_text())
    keep("surface_file", "binary.stl", b"S" + stl_binary())
    for kind in ("ascii", "binary_little_endian", "binary_big_endian"):
        keep("surface_file", f"{kind}.ply", b"P" + ply(kind))
    for kind in ("ascii", "binary", "appended"):
        keep("surface_file", f"{kind}.vtp", b"V" + vtp(kind))
    text, closed, open_log = sessions(cli)
    keep("scenario", "as-run.toml", text)
    # closed.insertion and open.insertion are of release 0.2, in format 2
    keep("session_file", "closed-blocks.insertion", closed)
    keep("session_file", "open-blocks.insertion", open_log)
    with tempfile.TemporaryDirectory() as folder:
        study, patient = Path(folder) / "small.toml", Path(folder) / "patient.toml"
        study.write_text(SMALL_STUDY)
        patient.write_text(PATIENT)
        keep("study_file", "small.sqlite", tables(cli, ["study", "run", str(study)], "study.sqlite"))
        plan = ["plan", "--patient", str(patient), "--arrays", "flex24", "flex28", "--samples", "1"]
        keep("plan_file", "one-draw.sqlite", tables(cli, plan, "draws.sqlite"))


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    main(sys.argv[1])
