#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What --igtl sends, decoded from the public description of the protocol (OpenIGTLink version 2,
http://openigtlink.org/protocols/v2_header.html and the pages of the message types) without the library
that packed it, and compared with the table of the same insertion."""

import csv
import importlib.util
import math
import socket
import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True  # nothing beside what is installed
CLI = Path(sys.argv.pop(1)) / "perilymph-cli" if len(sys.argv) > 1 else None
MODULE = Path(__file__).resolve().parents[3] / "resources/slicer/PerilymphInsertion.py"
HEADER = struct.Struct(">H12s20sQQQ")  # version, type, device, time, size of the body, CRC-64
POINT = struct.Struct(">64s32s4B3ff20s")
NEWTON = 0x0B << 54 | 1 << 50  # v2_unit: derived unit 0x0B to the power of 1
FLOAT = 2.0**-22  # relative: a position is rounded to a float in meters, and again in millimeters


def crc64(data):
    """ECMA-182: polynomial 0x42F0E1EBA9EA3693, highest bit first, from 0."""
    crc = 0
    for byte in data:
        crc = TABLE[(crc >> 56) ^ byte] ^ (crc << 8 & 0xFFFFFFFFFFFFFFFF)
    return crc


def table_entry(byte):
    crc = byte << 56
    for _ in range(8):
        crc = (crc << 1 ^ (0x42F0E1EBA9EA3693 if crc >> 63 else 0)) & 0xFFFFFFFFFFFFFFFF
    return crc


TABLE = [table_entry(byte) for byte in range(256)]


def text(field):
    return field.rstrip(b"\0").decode("ascii")


class Client:
    def __init__(self, port):
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=60)
        self.stream = self.socket.makefile("rb")

    def ask(self, kind, device):
        self.socket.sendall(HEADER.pack(1, kind.encode(), device.encode(), 0, 0, 0))

    def messages(self):
        """(type, device, time, body) until the server ends; each check sum is right."""
        while header := self.stream.read(HEADER.size):
            version, kind, device, time, size, crc = HEADER.unpack(header)
            body = self.stream.read(size)
            if len(body) < size:
                return  # the program ended within a message
            assert version == 1, version
            assert crc64(body) == crc, f"check sum of {text(device)}"
            yield text(kind), text(device), time, body

    def close(self):
        self.stream.close()
        self.socket.close()


def transform(body):
    """The columns x, y, z and the place."""
    numbers = struct.unpack(">12f", body)
    return [numbers[i:i + 3] for i in (0, 3, 6, 9)]


def points(body):
    return [(text(name), text(group), (x, y, z))
            for name, group, *_, x, y, z, _, _ in POINT.iter_unpack(body)]


def sensor(body):
    count, status, unit = struct.unpack(">BBQ", body[:10])
    return status, unit, struct.unpack(f">{count}d", body[10:])


def polydata(body):
    """Points and triangles."""
    counts = struct.unpack(">10I", body[:40])
    place = 40 + 12 * counts[0]
    corners = list(struct.iter_unpack(">3f", body[40:place]))
    place += counts[2] + counts[4]
    cells = list(struct.iter_unpack(">4I", body[place:place + counts[6]]))
    assert len(cells) == counts[5] and all(cell[0] == 3 for cell in cells)
    assert len(body) == place + counts[6] + counts[8] and counts[9] == 0
    return corners, [cell[1:] for cell in cells]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def distance(a, b):
    return math.dist(a, b)


class Navigation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """An insertion of 3 mm in 3 s, received to its end."""
        cls.folder = tempfile.TemporaryDirectory()
        table = Path(cls.folder.name) / "run.csv"
        while not cls.receive(table):
            pass  # another program took the port that was free
        with table.open() as lines:
            cls.rows = [{key: float(value) for key, value in row.items()} for row in csv.DictReader(lines)]
        # Frames: six messages with the same time.
        cls.frames = {}
        for kind, device, time, body in cls.received:
            if kind not in ("POLYDATA", "STATUS"):
                cls.frames.setdefault(time, {})[device] = (kind, body)
        cls.frames = [frame for frame in cls.frames.values() if len(frame) == 6]

    @classmethod
    def receive(cls, table):
        """False if the port was taken."""
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        call = [CLI, "simulate", "--scenario", "contour-published", "--set", "stop_travel_mm=3", "--set",
                "speed_mm_s=1", "--csv", table, "--igtl", str(port)]
        with subprocess.Popen(call, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as program:
            if not any("Sending to OpenIGTLink clients" in line for line in program.stdout):
                sentence = program.stderr.read()
                assert "is taken by another program" in sentence, sentence
                return False
            client = Client(port)
            client.ask("GET_POLYDATA", "PerilymphArray")
            client.ask("GET_IMAGE", "Liver")
            cls.received = []
            try:
                for message in client.messages():
                    cls.received.append(message)
            except ConnectionResetError:
                pass  # the program ended
            client.close()
            program.communicate()
        assert program.returncode == 0, program.returncode
        return True

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def row_of(self, frame):
        """The row of the table with the force that was sent: both have all digits. Where the array slides without contact,
        forces recur; of their rows it is the one with the tip that was sent."""
        force = sensor(frame["PerilymphForce"][1])[2]
        names = ("force_x_N", "force_y_N", "force_z_N", "force_axial_N")
        found = [i for i, row in enumerate(self.rows) if tuple(row[name] for name in names) == force]
        self.assertTrue(found, force)
        tip = transform(frame["PerilymphTip"][1])[3]
        return min(found, key=lambda i: distance(tip, [self.rows[i][f"tip_{axis}_mm"] for axis in "xyz"]))

    def assert_place(self, sent, row, name):
        for axis, value in zip("xyz", sent):
            expected = row[f"{name}_{axis}_mm"]
            self.assertLessEqual(abs(value - expected), FLOAT * abs(expected) + 1e-9)

    def test_the_check_sum_is_that_of_the_standard(self):
        # CRC-64/ECMA-182 of "123456789", in the catalogue of parametrised CRC algorithms
        self.assertEqual(crc64(b"123456789"), 0x6C40DF5F0B497347)

    def test_frames_come_in_the_order_of_the_insertion(self):
        rows = [self.row_of(frame) for frame in self.frames]
        self.assertGreater(len(rows), 15)  # of 150, on a machine that does much else
        for before, after in zip(rows, rows[1:]):
            self.assertGreaterEqual(after - before, 20)  # 50 Hz: 20 rows of 1 ms, or more

    def test_tip_and_tweezers_are_those_of_the_table(self):
        for frame in self.frames:
            row = self.rows[self.row_of(frame)]
            for device, name in (("PerilymphTip", "tip"), ("PerilymphTweezers", "proxy")):
                kind, body = frame[device]
                self.assertEqual(kind, "TRANSFORM")
                x, y, z, place = transform(body)
                self.assert_place(place, row, name)
                for a, b, expected in ((x, x, 1), (y, y, 1), (z, z, 1), (x, y, 0), (y, z, 0), (z, x, 0)):
                    self.assertAlmostEqual(dot(a, b), expected, places=6)
                turned = (x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0])
                self.assertAlmostEqual(dot(turned, z), 1.0, places=6)

    def test_contacts_follow_each_other_from_the_tip(self):
        for frame in self.frames:
            kind, body = frame["PerilymphContacts"]
            self.assertEqual(kind, "POINT")
            contacts = points(body)
            self.assertEqual([name for name, _, _ in contacts], [f"E{i + 1}" for i in range(22)])
            self.assertEqual({group for _, group, _ in contacts}, {"Contact"})
            *_, axis, tip = transform(frame["PerilymphTip"][1])
            # behind the tip, against the axis that points out of it
            first = contacts[0][2]
            self.assertLess(dot([a - b for a, b in zip(first, tip)], axis), 0.0)
            for (_, _, one), (_, _, next_one) in zip(contacts, contacts[1:]):
                self.assertLess(distance(one, next_one), 1.0)
                self.assertGreater(distance(one, next_one), 0.1)

    def test_the_force_is_in_newtons(self):
        for frame in self.frames:
            kind, body = frame["PerilymphForce"]
            status, unit, values = sensor(body)
            self.assertEqual((kind, status, unit, len(values)), ("SENSOR", 0, NEWTON, 4))

    def test_the_force_is_a_transform_and_a_text_too(self):
        for frame in self.frames:
            row = self.rows[self.row_of(frame)]
            kind, body = frame["PerilymphForceXYZ"]
            self.assertEqual(kind, "TRANSFORM")
            x, y, z, force = transform(body)
            self.assertEqual((x, y, z), ((1, 0, 0), (0, 1, 0), (0, 0, 1)))
            for axis, value in zip("xyz", force):
                self.assertLessEqual(abs(value - row[f"force_{axis}_N"]), FLOAT * abs(value))
            kind, body = frame["PerilymphReadout"]
            self.assertEqual(kind, "STRING")
            encoding, length = struct.unpack(">HH", body[:4])
            self.assertEqual((encoding, length), (3, len(body) - 4))  # US-ASCII
            lines = dict(line.split("=") for line in body[4:].decode("ascii").splitlines())
            self.assertEqual(lines.pop("coordinates"), "cochlea")
            self.assertEqual(lines.pop("patient"), "unknown")
            for name, value in lines.items():
                self.assertEqual(float(value), row[name], name)

    def test_the_module_of_slicer_reads_the_same(self):
        spec = importlib.util.spec_from_file_location("PerilymphInsertion", MODULE)
        module = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(module)
        curve = module.ForceCurve()
        for frame in self.frames:
            row = self.rows[self.row_of(frame)]
            values = module.readout(frame[module.READOUT][1][4:].decode("ascii"))
            self.assertEqual(values["force_axial_N"], row["force_axial_N"])
            columns = transform(frame[module.FORCE][1])
            force = module.force_of([[column[i] for column in columns] for i in range(3)])
            self.assertAlmostEqual(force[2], row["force_z_N"], delta=FLOAT * abs(force[2]))
            curve.add(values)
        self.assertEqual(curve.peak_N, max(max(self.rows[self.row_of(f)]["force_axial_N"] for f in self.frames), 0.0))
        names = {device for _, device, _, _ in self.received}
        for name, *_ in module.PLACED:
            if name != module.CT:
                self.assertIn(name, names)

    def test_the_points_name_the_frame_of_their_coordinates(self):
        for frame in self.frames:
            owners = {text(entry[-1]) for entry in POINT.iter_unpack(frame["PerilymphContacts"][1])}
            self.assertEqual(owners, {"cochlea"})

    def test_a_name_that_is_not_sent_is_answered_by_a_status(self):
        kind, body = next((kind, body) for kind, device, _, body in self.received if device == "Liver")
        code, _, _, sentence = struct.unpack(f">Hq20s{len(body) - 30}s", body)
        self.assertEqual((kind, code), ("STATUS", 4))  # not found
        self.assertIn("sends no IMAGE of this name", text(sentence))

    def test_both_scalae_come_on_connection(self):
        bodies = [body for kind, device, _, body in self.received if device == "PerilymphVestibuli"]
        self.assertEqual(len(bodies), 1)
        corners, _ = polydata(bodies[0])
        # It lies above the scala tympani.
        tympani, _ = polydata(next(body for _, device, _, body in self.received if device == "PerilymphScala"))
        self.assertGreater(max(z for _, _, z in corners), max(z for _, _, z in tympani))
        corners, triangles = polydata(next(body for _, device, _, body in self.received if device == "PerilymphScala"))
        self.assertGreater(len(triangles), 1000)
        self.assertEqual(max(max(triangle) for triangle in triangles), len(corners) - 1)
        # a human scala tympani lies within 10 mm of the modiolar axis's foot
        self.assertLess(max(math.hypot(x, y) for x, y, _ in corners), 10.0)

    def test_the_array_is_where_its_frame_says(self):
        names = [device for _, device, _, _ in self.received]
        # at most ten times a second, in three, and one for the request
        self.assertLessEqual(names.count("PerilymphArray"), 31)
        # The first answers the request; the second follows the messages of its own frame.
        place = names.index("PerilymphArray", names.index("PerilymphArray") + 1)
        frame = {device: body for _, device, _, body in self.received[:place]}
        *_, tip = transform(frame["PerilymphTip"])
        corners, triangles = polydata(self.received[place][3])
        # closed: each edge is used once in each direction
        edges = [edge for a, b, c in triangles for edge in ((a, b), (b, c), (c, a))]
        self.assertEqual(len(edges), len(set(edges)))
        self.assertEqual(set(edges), {(b, a) for a, b in edges})
        # the tip is its end
        self.assertLess(min(distance(tip, corner) for corner in corners), 0.2)
        # every contact is on the carrier's center line, 0.2 to 0.4 mm below its surface
        contacts = points(frame["PerilymphContacts"])
        for name, _, contact in contacts:
            self.assertLess(min(distance(contact, corner) for corner in corners), 0.6, name)


if __name__ == "__main__":
    unittest.main()
