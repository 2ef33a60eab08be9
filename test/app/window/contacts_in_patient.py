#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The contacts of the array in the patient's RAS [mm], one a line, as a client of OpenIGTLink finds them: contacts_in_patient.py PORT.

Decodes the bytes from the public description of the protocol (http://openigtlink.org/protocols/v2_header.html), without
its library: POINT PerilymphContacts, moved by TRANSFORM PerilymphToPatient. The force comes last, from STRING
PerilymphReadout [N]."""

import socket
import struct
import sys

HEADER = struct.Struct(">H12s20sQQQ")
POINT = struct.Struct(">64s32s4B3ff20s")
NAMES = {b"PerilymphToPatient": b"TRANSFORM", b"PerilymphContacts": b"POINT", b"PerilymphReadout": b"STRING"}


def main():
    found = {}
    with socket.create_connection(("127.0.0.1", int(sys.argv[1])), timeout=60) as link, link.makefile("rb") as stream:
        while len(found) < len(NAMES):
            _, kind, device, _, size, _ = HEADER.unpack(stream.read(HEADER.size))
            body = stream.read(size)
            name = device.rstrip(b"\0")
            if NAMES.get(name) == kind.rstrip(b"\0"):
                found[name] = body
    numbers = struct.unpack(">12f", found[b"PerilymphToPatient"])
    x, y, z, origin = (numbers[i:i + 3] for i in (0, 3, 6, 9))
    for *_, a, b, c, _, _ in POINT.iter_unpack(found[b"PerilymphContacts"]):
        print(*(a * x[i] + b * y[i] + c * z[i] + origin[i] for i in range(3)))
    lines = dict(line.split("=") for line in found[b"PerilymphReadout"][4:].decode("ascii").splitlines())
    print(lines["force_axial_N"])


if __name__ == "__main__":
    main()
