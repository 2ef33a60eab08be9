#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Packs the Python package of a build folder as a wheel (PEP 427), the same bytes every time: pack_wheel.py BUILD FOLDER

The data that the engine reads are in the wheel as perilymph/data, without pictures, fonts and documents.
"""

import base64
import hashlib
import sys
import sysconfig
import zipfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
# Folders of resources/ that programs alone read, or that are documents.
LEFT_OUT = {"bench", "examples", "fonts", "guide", "icons", "pictures", "schemas", "start", "translations"}
DATA = {".toml", ".csv", ".tsv", ".json"}
FIRST_DAY = (1980, 1, 1, 0, 0, 0)  # the first that a zip file can state


def tag_of(module):
    """"cp311-cp311-linux_x86_64" of "_engine.cpython-311-x86_64-linux-gnu.so"."""
    python = module.name.split(".")[1].split("-")[1]
    return f"cp{python}-cp{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def contents(build):
    """(name in the wheel, bytes) of each file but those of dist-info, and the module."""
    package = build / "python/perilymph"
    module, = package.glob("_engine.*.so")
    rows = [(f"perilymph/{file.name}", file.read_bytes()) for file in sorted(package.iterdir()) if file.is_file()]
    for top in ("resources", "plugins/electrodes"):
        for file in sorted((ROOT / top).rglob("*")):
            place = file.relative_to(ROOT)
            if file.suffix in DATA and place.parts[1] not in LEFT_OUT:
                rows.append((f"perilymph/data/{place.as_posix()}", file.read_bytes()))
    return rows, module


def main(build, folder):
    rows, module = contents(build)
    information, = (build / "python").glob("perilymph-*.dist-info")
    tag = tag_of(module)
    rows += [(f"{information.name}/{name}", (information / name).read_bytes()) for name in ("METADATA", "top_level.txt")]
    rows.append((f"{information.name}/LICENSE", (ROOT / "LICENSE").read_bytes()))
    rows.append((f"{information.name}/WHEEL", f"Wheel-Version: 1.0\nGenerator: perilymph\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()))
    record = f"{information.name}/RECORD"
    listed = "".join(f"{name},sha256={base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b'=').decode()},{len(data)}\n"
                     for name, data in rows)
    rows.append((record, f"{listed}{record},,\n".encode()))
    folder.mkdir(parents=True, exist_ok=True)
    for former in folder.glob("perilymph-*.whl"):
        former.unlink()
    wheel = folder / f"{information.name.removesuffix('.dist-info')}-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in rows:
            entry = zipfile.ZipInfo(name, FIRST_DAY)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, data)
    print(wheel)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*map(Path, sys.argv[1:]))
