# SPDX-License-Identifier: BSD-3-Clause
"""The machine that something is measured on: its parts, and how busy it is with other work."""

import os
import platform
from pathlib import Path

TICKS_PER_S = os.sysconf("SC_CLK_TCK")


def processor(cpuinfo):
    """The name in the text of /proc/cpuinfo."""
    for entry in cpuinfo.splitlines():
        key, _, value = entry.partition(":")
        if key.strip() == "model name":
            return " ".join(value.split())
    return "an unnamed processor"


def is_virtual(cpuinfo):
    """A hypervisor shares the processor with other machines."""
    return any(entry.startswith("flags") and " hypervisor" in entry for entry in cpuinfo.splitlines())


def memory_gb(meminfo):
    """All memory in the text of /proc/meminfo [GB, 1e9 bytes]; None if it is not stated."""
    for entry in meminfo.splitlines():
        if entry.startswith("MemTotal:"):
            return int(entry.split()[1]) * 1024 / 1e9
    return None


def occupied(before, after, own_s):
    """Parts of the processors' time between two texts of /proc/stat [%]: (other programs' than the measured ones, whose
    processor time is given, and what the host of a virtual machine withheld)."""
    def fields(text):
        return [int(word) for word in text.splitlines()[0].split()[1:9]]  # user to steal; guest is in user
    user, nice, system, idle, waiting, hard, soft, stolen = (b - a for a, b in zip(fields(before), fields(after)))
    busy = user + nice + system + hard + soft
    spent = max(busy + idle + waiting + stolen, 1)
    return 100.0 * max(busy - own_s * TICKS_PER_S, 0.0) / spent, 100.0 * stolen / spent


def read(path):
    return Path(path).read_text(encoding="utf-8")


def facts():
    """What a page and a history state of this machine."""
    cpuinfo = read("/proc/cpuinfo")
    return {"processor": processor(cpuinfo), "is_virtual": is_virtual(cpuinfo), "cores": os.cpu_count(),
            "memory_gb": memory_gb(read("/proc/meminfo")), "system": f"{platform.system()} {platform.release()}",
            "load": os.getloadavg()[0]}


class Watch:
    """How busy this machine is from now on with other work than this process and the programs it waited for."""

    def __init__(self):
        self.before, self.own_before = read("/proc/stat"), self.own_s()

    @staticmethod
    def own_s():
        spent = os.times()
        return spent.user + spent.system + spent.children_user + spent.children_system

    def result(self):
        others, stolen = occupied(self.before, read("/proc/stat"), self.own_s() - self.own_before)
        return {"others_percent": others, "stolen_percent": stolen}
