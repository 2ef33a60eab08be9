# SPDX-License-Identifier: BSD-3-Clause
"""A copy of the project's scripts in a separate folder, with fake system commands."""

import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
REAL = ("awk bash basename cat cksum comm dirname env grep head mkdir nproc rm sed sort tail tee touch "
        "tr true uname").split()


class PretendedSystem(unittest.TestCase):
    """Each test has `self.root` (the project), `self.bin` (all available commands) and a log."""

    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.root = Path(place.name).resolve() / "the project"
        self.bin = Path(place.name).resolve() / "bin"
        self.log = Path(place.name).resolve() / "log"
        self.log.touch()
        self.bin.mkdir()
        (self.root / "test").mkdir(parents=True)
        shutil.copytree(SOURCE / "packaging", self.root / "packaging")
        shutil.copy(SOURCE / "test/run", self.root / "test/run")
        shutil.copy(SOURCE / "CMakePresets.json", self.root)
        self.pretend("campaign", "", self.root / "test/fuzz")
        for name in REAL:
            found = shutil.which(name, path="/usr/bin:/bin")
            if found:
                (self.bin / name).symlink_to(found)
        # Tests do not wait.
        self.pretend("sleep", "")

    def pretend(self, name, body, folder=None):
        """A fake command that logs its name and arguments, then runs `body`."""
        file = (folder or self.bin) / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.unlink(missing_ok=True)
        file.write_text(f'#!/bin/bash\necho "{name} $*" >>"{self.log}"\n{body}\n')
        file.chmod(0o755)

    def pretend_packages(self, *missing):
        """A fake dpkg-query to which all packages except these are installed; a fake apt-get installs them."""
        state = self.bin.parent / "installed"
        state.touch()
        lines = " ".join(missing)
        self.pretend("dpkg-query", f"""
status=0
for package in "${{@:3}}"; do
  if [[ " {lines} " == *" $package "* ]] && ! grep -qxF "$package" "{state}"; then status=1
  else echo "installed $package"; fi
done
exit $status""")
        self.pretend("dpkg", "")
        self.pretend("apt-get", f"""
echo "frontend $DEBIAN_FRONTEND" >>"{self.log}"
if [[ "$*" == *" install "* ]]; then printf '%s\\n' "$@" >>"{state}"; fi""")
        self.pretend("sudo", 'exec "$@"')

    def call(self, script, *words, **environment):
        """Runs a script of the project without the caller's environment."""
        return subprocess.run(
            [self.bin / "bash", self.root / script, *words], cwd=self.root, text=True,
            capture_output=True, check=False, timeout=60,
            env={"PATH": str(self.bin), "HOME": os.devnull, "LC_ALL": "C.UTF-8", **environment})

    def calls(self, name):
        """The arguments of each call of a fake command, in order."""
        return [line[len(name) + 1:] for line in self.log.read_text().splitlines()
                if line.startswith(name + " ")]

    def assert_one_sentence(self, result, expected):
        """It failed with status 1, and its last message on standard error states the remedy."""
        self.assertEqual(result.returncode, 1, result.stdout + result.stderr)
        self.assertIn(expected, result.stderr.strip().splitlines()[-1])
