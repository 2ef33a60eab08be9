# SPDX-License-Identifier: BSD-3-Clause
"""A Debian kernel to boot: from the cache, from this system, or fetched and unpacked. Never installed."""

import re
import shutil
import subprocess
import tarfile
import tempfile
from dataclasses import dataclass
from pathlib import Path

PACKAGE = "linux-image-cloud-amd64"
MODULES = ("hid", "hid-generic", "uhid")
SUFFIXES = (".ko", ".ko.xz")  # Debian 12's modules; those of 13 are compressed
FETCH_SECONDS = 60


class Missing(Exception):
    """Something that the virtual machine needs is missing; the text says what and why."""


@dataclass
class Kernel:
    image: Path
    modules: list  # in the order in which they are loaded


def _wanted(name):
    """Where a file of the package goes in the cache; None for what is not needed."""
    plain = name.removeprefix("./")
    if re.fullmatch(r"boot/vmlinuz-\S+", plain):
        return "vmlinuz"
    for module in MODULES:
        for suffix in SUFFIXES:
            if plain.endswith(f"/drivers/hid/{module}{suffix}"):
                return f"{module}{suffix}"
    return None


def _modules_in(folder):
    """The files of the modules, or fewer than there are modules."""
    files = (folder / f"{module}{suffix}" for module in MODULES for suffix in SUFFIXES)
    return [file for file in files if file.is_file()]


def in_folder(folder):
    """The kernel of a cache folder, or None if it is incomplete."""
    folder = Path(folder)
    kernel = Kernel(folder / "vmlinuz", _modules_in(folder))
    return kernel if kernel.image.is_file() and len(kernel.modules) == len(MODULES) else None


def of_system(boot=Path("/boot"), modules=Path("/lib/modules")):
    """The newest installed cloud kernel that can be read, or None."""
    for image in sorted(boot.glob("vmlinuz-*-cloud-amd64"), reverse=True):
        version = image.name.removeprefix("vmlinuz-")
        files = _modules_in(modules / version / "kernel/drivers/hid")
        try:
            with image.open("rb"):
                pass
        except OSError:
            continue  # on many systems users cannot read kernels
        if len(files) == len(MODULES):
            return Kernel(image, files)
    return None


def _apt(*words, cwd=None):
    try:
        done = subprocess.run(words, capture_output=True, text=True, check=False, cwd=cwd,
                              timeout=FETCH_SECONDS)
    except FileNotFoundError as error:
        raise Missing(f"this system has no {words[0]} to fetch {PACKAGE} with") from error
    except subprocess.TimeoutExpired as error:
        raise Missing(f"'{' '.join(words)}' took more than {FETCH_SECONDS} s") from error
    if done.returncode != 0:
        reason = (done.stderr or done.stdout).strip().splitlines()
        raise Missing(f"'{' '.join(words)}' failed ({reason[-1] if reason else 'no reason given'})")
    return done.stdout


def image_package():
    """The package that holds the kernel: the meta package names it."""
    listing = _apt("apt-cache", "depends", "--no-recommends", "--no-suggests", PACKAGE)
    match = re.search(r"Depends: (linux-image-\S+-cloud-amd64)", listing)
    if not match:
        raise Missing(f"apt knows no kernel behind {PACKAGE}: its package lists may be empty; "
                      "run 'apt-get update'")
    return match.group(1)


def unpack(package, folder):
    """Takes the kernel and its HID modules out of a .deb."""
    with tempfile.TemporaryFile() as archive:
        subprocess.run(["dpkg-deb", "--fsys-tarfile", str(package)], check=True, stdout=archive)
        archive.seek(0)
        with tarfile.open(fileobj=archive) as content:
            for member in content:
                place = _wanted(member.name)
                if place and member.isfile():
                    with content.extractfile(member) as source, \
                            (folder / place).open("wb") as target:
                        shutil.copyfileobj(source, target)


def fetched(cache):
    """Fetches the kernel's package into the cache and keeps what is needed of it."""
    cache = Path(cache)
    cache.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=cache) as room:
        _apt("apt-get", "-o", "APT::Sandbox::User=root", "-o", "Acquire::Retries=2", "-o", "Acquire::http::Timeout=15",
             "download", image_package(), cwd=room)
        packages = list(Path(room).glob("*.deb"))
        if len(packages) != 1:
            raise Missing(f"apt fetched {len(packages)} packages for {PACKAGE}; 1 was expected")
        parts = Path(room) / "parts"
        parts.mkdir()
        unpack(packages[0], parts)
        if not in_folder(parts):
            raise Missing(f"{packages[0].name} does not hold a kernel with {', '.join(MODULES)}")
        for file in parts.iterdir():
            file.replace(cache / file.name)
    return in_folder(cache)


def find(cache):
    """The kernel to boot. @raise Missing if there is none."""
    return in_folder(cache) or of_system() or fetched(cache)
