# SPDX-License-Identifier: BSD-3-Clause
"""Sources are formatted by clang-format."""

import re
import shutil
import subprocess
import sys

from checks import sources

NOT_RUN = 77
FORMATTED_BY = "14"
OBJECTION = re.compile(r"^(?P<place>[^:\n]+:\d+):\d+: error: .*clang-format", re.M)


def formatter():
    """Major version of the installed clang-format; None without one."""
    if shutil.which("clang-format") is None:
        return None
    said = subprocess.run(["clang-format", "--version"], capture_output=True, text=True, check=True).stdout
    version = re.search(r"version (\d+)", said)
    return version[1] if version else ""


def check(root):
    """One message per location. Without clang-format of the version used the check is skipped with a message."""
    version = formatter()
    if version is None:
        print("Skipped: clang-format is not installed. Install the package clang-format to run this test.")
        sys.exit(NOT_RUN)
    if version != FORMATTED_BY:
        print(f"Skipped: sources are formatted by clang-format {FORMATTED_BY}, that of Debian 12; other versions break lines elsewhere.")
        sys.exit(NOT_RUN)
    written = [str(file) for file in sources.files(root, "modules", "app", "plugins", "test", suffixes={".h", ".cpp"})]
    if not written:
        return []
    said = subprocess.run(["clang-format", "--dry-run", "-Werror", *written], cwd=root,
                          capture_output=True, text=True, check=False).stderr
    return [f"{place.removeprefix(f'{root}/')} is not formatted; run 'clang-format -i' on the file."
            for place in dict.fromkeys(match["place"] for match in OBJECTION.finditer(said))]
