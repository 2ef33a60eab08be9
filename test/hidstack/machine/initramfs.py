# SPDX-License-Identifier: BSD-3-Clause
"""The initramfs of the virtual machine: programs, their libraries, kernel modules."""

import lzma
import re
import stat
import subprocess
import tempfile
from pathlib import Path


class Cpio:
    """An archive in the format the kernel unpacks: cpio, "newc" (the kernel's
    Documentation/driver-api/early-userspace/buffer-format.rst)."""

    def __init__(self):
        self._parts = []
        self._folders = set()

    def _entry(self, name, mode, content=b"", device=(0, 0)):
        raw = name.encode() + b"\0"
        number = len(self._parts) + 1
        fields = (number, mode, 0, 0, 1, 0, len(content), 0, 0, *device, len(raw), 0)
        head = b"070701" + b"".join(b"%08X" % field for field in fields)
        self._parts.append(_padded(head + raw) + _padded(content))

    def folder(self, name):
        """A folder and those above it."""
        path = Path(name)
        for each in [*reversed(path.parents), path]:
            text = each.as_posix()
            if text != "." and text not in self._folders:
                self._folders.add(text)
                self._entry(text, stat.S_IFDIR | 0o755)

    def file(self, name, content, mode=0o755):
        self.folder(Path(name).parent)
        self._entry(name, stat.S_IFREG | mode, content)

    def link(self, name, target):
        self.folder(Path(name).parent)
        self._entry(name, stat.S_IFLNK | 0o777, target.encode())

    def character_device(self, name, major, minor):
        self.folder(Path(name).parent)
        self._entry(name, stat.S_IFCHR | 0o600, device=(major, minor))

    def bytes(self):
        end = Cpio()
        end._entry("TRAILER!!!", 0)
        return b"".join(self._parts + end._parts)


def _padded(data):
    return data + b"\0" * (-len(data) % 4)


def libraries_of(programs):
    """Every shared library the programs load, the loader included: name in the machine to file."""
    found = {}
    for program in programs:
        listing = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
        if "not found" in listing:
            raise RuntimeError(f"{program} misses a library: {listing}")
        for match in re.finditer(r"(?:=> )?(/\S+) \(0x", listing):
            path = match.group(1)
            found[path] = Path(path)
    return found


def stripped(file):
    """The file without debug symbols, to reduce its size."""
    with tempfile.NamedTemporaryFile() as thin:
        done = subprocess.run(["strip", "--strip-unneeded", "-o", thin.name, str(file)],
                              capture_output=True, check=False)
        return Path(thin.name if done.returncode == 0 else file).read_bytes()


def module_file(module):
    """Where a kernel module goes, and what it holds: busybox loads no compressed one."""
    module = Path(module)
    if module.suffix == ".xz":
        return f"modules/{module.stem}", lzma.decompress(module.read_bytes())
    return f"modules/{module.name}", module.read_bytes()


def build(init, busybox, programs, data, modules, trees=()):
    """@param trees  Folders as (root, relative path); their TOML files keep their relative paths.
    @return the bytes of the archive."""
    archive = Cpio()
    for folder in ("bin", "dev", "log", "modules", "proc", "sys", "tmp"):
        archive.folder(folder)
    # The kernel's first messages need a console before anything is mounted.
    archive.character_device("dev/console", 5, 1)
    archive.file("init", Path(init).read_bytes())
    archive.file("bin/busybox", Path(busybox).read_bytes())
    for name in ("sh", "mount", "insmod", "reboot"):
        archive.link(f"bin/{name}", "busybox")
    for program in programs:
        archive.file(f"bin/{Path(program).name}", stripped(program))
    for name, file in sorted(libraries_of(programs).items()):
        archive.file(name.lstrip("/"), file.read_bytes())
    for file in data:
        archive.file(f"data/{Path(file).name}", Path(file).read_bytes(), 0o644)
    for root, folder in trees:
        for file in sorted((Path(root) / folder).rglob("*.toml")):
            archive.file(f"data/{file.relative_to(root)}", file.read_bytes(), 0o644)
    for module in modules:
        archive.file(*module_file(module), 0o644)
    return archive.bytes()
