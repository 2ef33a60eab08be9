#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The template of a device plug-in: built against an installed prefix, then run with a device at a serial line."""

import ctypes
import os
import pty
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD = Path(sys.argv.pop(1)).resolve()
PROGRAMS = Path(sys.argv.pop(1)).resolve()


def run(*words, **keys):
    return subprocess.run([str(word) for word in words], capture_output=True, text=True, timeout=300, **keys)


class Sample(ctypes.Structure):
    """PerilymphDeviceSampleV1 of PluginApi.h."""

    _fields_ = [("size", ctypes.c_uint32), ("buttons", ctypes.c_uint32), ("sequence", ctypes.c_uint64),
                ("position", ctypes.c_double * 3), ("rotation", ctypes.c_double * 4),
                ("is_valid", ctypes.c_uint32), ("reserved", ctypes.c_uint32)]


class Wrench(ctypes.Structure):
    """PerilymphDeviceWrenchV1."""

    _fields_ = [("size", ctypes.c_uint32), ("reserved", ctypes.c_uint32), ("force", ctypes.c_double * 3),
                ("torque", ctypes.c_double * 3)]


class Functions(ctypes.Structure):
    """PerilymphDeviceV1."""

    _fields_ = [("size", ctypes.c_uint32), ("version", ctypes.c_uint32),
                ("create", ctypes.CFUNCTYPE(ctypes.c_void_p)),
                ("destroy", ctypes.CFUNCTYPE(None, ctypes.c_void_p)),
                ("traits", ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_void_p)),
                ("open", ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.c_char_p, ctypes.c_uint32)),
                ("close", ctypes.CFUNCTYPE(None, ctypes.c_void_p)),
                ("read", ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(Sample))),
                ("write", ctypes.CFUNCTYPE(ctypes.c_int32, ctypes.c_void_p, ctypes.POINTER(Wrench)))]


class Template(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scratch = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.scratch.name)
        cls.prefix = cls.folder / "prefix"
        installed = run("cmake", "--install", BUILD, "--component", "sdk", "--prefix", cls.prefix)
        if installed.returncode != 0:
            raise AssertionError(installed.stdout + installed.stderr)
        # In a copy, as the guide says, with its two commands.
        cls.copy = cls.folder / "my-device"
        run("cp", "-r", cls.prefix / "share/doc/perilymph-dev/examples/template", cls.copy, check=True)
        for words in (["-S", ".", "-B", "build", f"-DCMAKE_PREFIX_PATH={cls.prefix}"], ["--build", "build"]):
            made = run("cmake", *words, cwd=cls.copy)
            if made.returncode != 0:
                raise AssertionError(made.stdout + made.stderr)
        cls.plugin = cls.copy / "build/my-device.so"

    @classmethod
    def tearDownClass(cls):
        cls.scratch.cleanup()

    def test_it_exports_only_its_entry(self):
        symbols = run("nm", "-D", "--defined-only", self.plugin, check=True).stdout.split("\n")
        self.assertEqual([line.split()[-1] for line in symbols if line], ["perilymph_device_v1"])

    def test_it_reads_and_pushes_a_device_at_a_serial_line(self):
        end, port = pty.openpty()
        os.environ["MY_DEVICE_PORT"] = os.ttyname(port)
        library = ctypes.CDLL(str(self.plugin))
        library.perilymph_device_v1.restype = ctypes.POINTER(Functions)
        plugin = library.perilymph_device_v1().contents
        self.assertEqual(plugin.size, ctypes.sizeof(Functions))
        device = plugin.create()
        self.assertEqual(plugin.open(device, ctypes.create_string_buffer(512), 511), 0)

        def sample():
            read = Sample(size=ctypes.sizeof(Sample))
            self.assertEqual(plugin.read(device, ctypes.byref(read)), 0)
            return read

        self.assertEqual(sample().is_valid, 0)  # nothing came yet
        os.write(end, b"1000 -2000 500 1\nnonsense\n1500 -20")
        first = sample()
        self.assertEqual((first.is_valid, first.sequence, first.buttons, first.size),
                         (1, 1, 1, ctypes.sizeof(Sample)))
        for got, wanted in zip(first.position, (1e-3, -2e-3, 0.5e-3)):
            self.assertAlmostEqual(got, wanted, 12)
        self.assertEqual(first.rotation[0], 1.0)
        os.write(end, b"00 0 0\n")
        second = sample()
        self.assertEqual((second.sequence, second.buttons), (2, 0))
        self.assertAlmostEqual(second.position[0], 1.5e-3, 12)

        force = Wrench(size=ctypes.sizeof(Wrench), force=(0.25, -0.1, 0.0))
        self.assertEqual(plugin.write(device, ctypes.byref(force)), 0)
        self.assertEqual(os.read(end, 100), b"250 -100 0\n")

        os.close(end)  # the cable
        os.close(port)
        self.assertEqual(sample().is_valid, 0)
        plugin.close(device)
        plugin.destroy(device)

    def test_without_its_device_it_says_which_port_was_tried(self):
        done = run(PROGRAMS / "perilymph-cli", "devices", "--plugin", self.plugin,
                   env=dict(os.environ, MY_DEVICE_PORT="/dev/nothing-here"))
        self.assertEqual(done.returncode, 1)
        self.assertIn("My device at /dev/nothing-here cannot be opened", done.stderr)


if __name__ == "__main__":
    unittest.main()
