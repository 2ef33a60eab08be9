# SPDX-License-Identifier: BSD-3-Clause
"""The harness of the virtual machine: archive, kernel search, and error messages."""

import lzma
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import initramfs
import kernel
import machine

HERE = Path(__file__).parent
BUSYBOX = "/usr/bin/busybox"


class InFolder(unittest.TestCase):
    def setUp(self):
        room = tempfile.TemporaryDirectory()
        self.addCleanup(room.cleanup)
        self.folder = Path(room.name)

    def program(self, name, text):
        """A program that stands in for the system's own."""
        folder = self.folder / "programs"
        folder.mkdir(exist_ok=True)
        file = folder / name
        file.write_text("#!/bin/sh\n" + text)
        file.chmod(0o755)
        return folder

    def package(self, *files):
        """A Debian package with these files."""
        tree = self.folder / "tree"
        (tree / "DEBIAN").mkdir(parents=True)
        (tree / "DEBIAN/control").write_text(
            "Package: linux-image-7-cloud-amd64\nVersion: 7\nArchitecture: amd64\n"
            "Maintainer: The Perilymph authors\nDescription: for a test\n")
        for name in files:
            (tree / name).parent.mkdir(parents=True, exist_ok=True)
            (tree / name).write_text(name)
        package = self.folder / "linux.deb"
        subprocess.run(["dpkg-deb", "--build", str(tree), str(package)], check=True,
                       capture_output=True)
        return package


KERNEL_FILES = ("boot/vmlinuz-7-cloud-amd64", "boot/config-7-cloud-amd64",
                *(f"lib/modules/7-cloud-amd64/kernel/drivers/hid/{name}.ko" for name in kernel.MODULES))


class Archive(InFolder):
    @unittest.skipUnless(os.path.exists(BUSYBOX), "busybox-static is not installed")
    def test_is_what_cpio_unpacks(self):
        archive = initramfs.Cpio()
        archive.folder("log")
        archive.file("bin/tool", b"odd")
        archive.file("lib/x86/deep.so", b"\0" * 4097, 0o644)
        archive.link("bin/sh", "tool")
        # A reference implementation independent of this code.
        subprocess.run([BUSYBOX, "cpio", "-idm"], input=archive.bytes(), check=True,
                       capture_output=True, cwd=self.folder)
        self.assertTrue((self.folder / "log").is_dir())
        self.assertEqual((self.folder / "bin/tool").read_bytes(), b"odd")
        self.assertEqual((self.folder / "lib/x86/deep.so").stat().st_size, 4097)
        self.assertEqual(os.readlink(self.folder / "bin/sh"), "tool")
        self.assertTrue(os.access(self.folder / "bin/tool", os.X_OK))

    def test_holds_a_compressed_module_unpacked(self):
        for name, content in (("hid.ko.xz", lzma.compress(b"module")), ("uhid.ko", b"module")):
            (self.folder / name).write_bytes(content)
        self.assertEqual(initramfs.module_file(self.folder / "hid.ko.xz"), ("modules/hid.ko", b"module"))
        self.assertEqual(initramfs.module_file(self.folder / "uhid.ko"), ("modules/uhid.ko", b"module"))

    def test_brings_the_loader_and_the_c_library_of_a_program(self):
        names = "\n".join(initramfs.libraries_of([sys.executable]))
        self.assertIn("ld-linux", names)
        self.assertIn("libc.so", names)


class Search(InFolder):
    def test_takes_kernel_and_modules_out_of_a_package_and_nothing_else(self):
        place = self.folder / "place"
        place.mkdir()
        kernel.unpack(self.package(*KERNEL_FILES), place)
        self.assertEqual({file.name for file in place.iterdir()},
                         {"vmlinuz", "hid.ko", "hid-generic.ko", "uhid.ko"})
        self.assertIsNotNone(kernel.in_folder(place))

    def test_takes_compressed_modules_too(self):
        place = self.folder / "place"
        place.mkdir()
        packed = [f"usr/{name}.xz" if name.endswith(".ko") else name for name in KERNEL_FILES]
        kernel.unpack(self.package(*packed), place)
        self.assertEqual([file.name for file in kernel.in_folder(place).modules],
                         ["hid.ko.xz", "hid-generic.ko.xz", "uhid.ko.xz"])

    def test_fetches_the_package_that_the_meta_package_names(self):
        package = self.package(*KERNEL_FILES)
        self.program("apt-cache", f"echo {kernel.PACKAGE}; echo '  Depends: linux-image-7-cloud-amd64'")
        programs = self.program("apt-get", f"for last; do :; done; cp {package} ./$last.deb")
        with mock.patch.dict(os.environ, {"PATH": f"{programs}:{os.environ['PATH']}"}):
            found = kernel.fetched(self.folder / "cache")
        self.assertEqual(found.image.read_text(), KERNEL_FILES[0])
        self.assertEqual([file.name for file in found.modules],
                         ["hid.ko", "hid-generic.ko", "uhid.ko"])
        # The package is not kept, and the next search finds what was kept.
        self.assertEqual(len(list((self.folder / "cache").iterdir())), 4)
        self.assertIsNotNone(kernel.in_folder(self.folder / "cache"))

    def test_says_what_apt_said_when_nothing_can_be_fetched(self):
        self.program("apt-cache", f"echo {kernel.PACKAGE}; echo '  Depends: linux-image-7-cloud-amd64'")
        programs = self.program("apt-get", "echo 'E: Temporary failure resolving' >&2; exit 100")
        with mock.patch.dict(os.environ, {"PATH": f"{programs}:{os.environ['PATH']}"}):
            with self.assertRaisesRegex(kernel.Missing, "Temporary failure resolving"):
                kernel.fetched(self.folder / "cache")
        self.assertEqual(list((self.folder / "cache").iterdir()), [])

    def test_says_that_package_lists_are_empty(self):
        programs = self.program("apt-cache", "echo nothing")
        with mock.patch.dict(os.environ, {"PATH": f"{programs}:{os.environ['PATH']}"}):
            with self.assertRaisesRegex(kernel.Missing, "apt-get update"):
                kernel.fetched(self.folder / "cache")

    def test_takes_an_installed_kernel_only_with_its_modules(self):
        for name in KERNEL_FILES:
            if not name.endswith("uhid.ko"):
                (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
                (self.folder / name).write_text(name)
        roots = (self.folder / "boot", self.folder / "lib/modules")
        self.assertIsNone(kernel.of_system(*roots))
        (self.folder / KERNEL_FILES[-1]).write_text("uhid")
        self.assertEqual(kernel.of_system(*roots).image.name, "vmlinuz-7-cloud-amd64")


class Machine(InFolder):
    def run_machine(self, path, *words):
        return subprocess.run([sys.executable, "-B", str(HERE / "machine.py"), "--programs", str(self.folder),
                               "--cache", str(self.folder / "cache"),
                               "--results", str(self.folder / "results"), *words],
                              env={"PATH": str(path)}, capture_output=True, text=True, check=False)

    def test_is_skipped_with_its_reason_where_there_is_no_emulator(self):
        done = self.run_machine(self.folder)
        self.assertEqual(done.returncode, 77)
        text = (self.folder / "results").read_text()
        self.assertTrue(text.startswith("skipped: "))
        self.assertIn("install qemu-system-x86", text)

    def pretend(self, emulator):
        """A run with this script for the emulator and files that are no kernel."""
        self.program("qemu-system-x86_64", emulator)
        programs = self.program("busybox", "exit 0")
        place = self.folder / "cache"
        place.mkdir()
        for name in ("vmlinuz", *(f"{module}.ko" for module in kernel.MODULES)):
            (place / name).write_text(name)
        for name in machine.PROGRAMS:
            (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
            (self.folder / name).write_bytes(Path(sys.executable).resolve().read_bytes())
        return self.run_machine(f"{programs}:{os.environ['PATH']}")

    def test_that_ends_early_is_a_failure_with_all_that_it_said(self):
        done = self.pretend("echo 'measure stream.lost 0'; echo 'Kernel panic'")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("Kernel panic", done.stderr)
        self.assertFalse((self.folder / "results").exists())

    def test_that_is_stopped_for_its_hunger_is_a_failure_that_says_so(self):
        done = self.pretend("echo 'measures end'; kill -XCPU $$")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("s of a processor", done.stderr)

    def test_keeps_what_a_whole_run_said(self):
        done = self.pretend("echo 'measure stream.lost 0'; echo 'measures end'")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("measure stream.lost 0\n", (self.folder / "results").read_text())


if __name__ == "__main__":
    unittest.main()
