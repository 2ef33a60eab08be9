#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Boots the virtual machine once and keeps what it said: machine.py --programs FOLDER --cache FOLDER
--results FILE [--all]. --all plays the scenes that take longest, too. Ends with 77 where the machine cannot be had, and says why, there and in the file."""

import argparse
import resource
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import initramfs
import kernel

SKIPPED = 77
PROGRAMS = ("test/bin/virtual_handle", "test/bin/pid_stick", "test/bin/hid_insertion",
            "test/bin/hid_measures", "bin/perilymph-device-guard")
# Only where the window is built.
WINDOW_PROGRAMS = ("test/bin/hid_stops",)
PROFILES = ("test/hidstack/virtual_handle.toml", "test/hidstack/virtual_handle_answering.toml",
            "plugins/devices/generic/pid.toml")
# What a scenario is built from.
TREES = ("resources/anatomy", "resources/calibration", "resources/friction", "resources/patients",
         "resources/scenarios", "plugins/electrodes")
# All scenes take 70 s of a processor, those of every day a third. Only a hang takes this much; an idle machine in virtual time hangs
# busily. By the clock a run takes as long as others let it, so that bound is wide.
MAX_PROCESSOR_SECONDS = 200
MAX_SECONDS = 500
# Software emulation in virtual time: an instruction takes 2 ns, waiting takes none of ours. What the
# programs measure is then the same on an idle machine and on a busy one.
CLOCK = ["-accel", "tcg,thread=single", "-icount", "shift=1,sleep=off", "-cpu", "max", "-smp", "1"]
# No search for hardware that is not there: half of the kernel's start.
APPEND = ("console=ttyS0 quiet panic=-1 reboot=t preempt=full mitigations=off nokaslr tsc=reliable "
          "lpj=4000000 acpi=off pci=off nosmp cryptomgr.notests")


def needed(name, package):
    found = shutil.which(name)
    if not found:
        raise kernel.Missing(f"{name} is not there: install {package}")
    return found


def boot(emulator, image, archive, scenes):
    """Runs the machine to its end. @return what it wrote to its serial line."""
    line = [emulator, "-machine", "q35", *CLOCK, "-m", "256", "-nodefaults", "-no-user-config",
            "-display", "none", "-no-reboot", "-serial", "stdio", "-kernel", str(image),
            "-initrd", str(archive), "-append", f"{APPEND} scenes={scenes}"]
    limit = (MAX_PROCESSOR_SECONDS, MAX_PROCESSOR_SECONDS)
    try:
        done = subprocess.run(line, stdin=subprocess.DEVNULL, capture_output=True, check=False,
                              timeout=MAX_SECONDS,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, limit))
    except subprocess.TimeoutExpired as error:
        said = (error.stdout or b"").decode(errors="replace")
        raise RuntimeError(f"The virtual machine was stopped after {MAX_SECONDS} s; it had said:\n"
                           f"{said}") from error
    said = done.stdout.decode(errors="replace").replace("\r", "")
    if done.returncode < 0:
        raise RuntimeError(f"The virtual machine was stopped by signal {-done.returncode}, perhaps "
                           f"after {MAX_PROCESSOR_SECONDS} s of a processor; it had said:\n{said}")
    if "measures end" not in said:
        raise RuntimeError("The virtual machine ended early; it had said:\n"
                           f"{said}{done.stderr.decode(errors='replace')}")
    return said


def processor_seconds():
    """What programs that were run so far used of a processor."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(programs, cache, scenes):
    """@return what the machine said. @raise kernel.Missing, RuntimeError"""
    emulator = needed("qemu-system-x86_64", "qemu-system-x86")
    busybox = needed("busybox", "busybox-static")
    linux = kernel.find(cache)
    began, used = time.monotonic(), processor_seconds()
    here = Path(__file__).parent
    root = here.parents[2]
    built = [programs / name for name in PROGRAMS]
    built += [programs / name for name in WINDOW_PROGRAMS if (programs / name).exists()]
    content = initramfs.build(here / "init", busybox, built, [root / name for name in PROFILES],
                              linux.modules, trees=[(root, name) for name in TREES])
    with tempfile.NamedTemporaryFile(prefix="perilymph-", suffix=".cpio") as archive:
        archive.write(content)
        archive.flush()
        said = boot(emulator, linux.image, archive.name, scenes)
    return (f"{said}note: {len(content)} bytes of initramfs; {time.monotonic() - began:.1f} s, "
            f"{processor_seconds() - used:.1f} s of a processor\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", type=Path, required=True)
    parser.add_argument("--cache", type=Path, required=True)
    parser.add_argument("--results", type=Path, required=True)
    parser.add_argument("--all", action="store_true")
    words = parser.parse_args()
    words.results.parent.mkdir(parents=True, exist_ok=True)
    words.results.unlink(missing_ok=True)
    try:
        said = run(words.programs, words.cache, "all" if words.all else "daily")
    except kernel.Missing as error:
        reason = f"skipped: no virtual machine, because {error}."
        words.results.write_text(reason + "\n", encoding="utf-8")
        print(reason)
        return SKIPPED
    except RuntimeError as error:
        print(error, file=sys.stderr)
        return 1
    words.results.write_text(said, encoding="utf-8")
    print(said)
    return 0


if __name__ == "__main__":
    sys.exit(main())
