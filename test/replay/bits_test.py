#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""test/replay/bits records insertions that replay to the same bits, and finds one that was changed."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BITS = Path(__file__).resolve().parent / "bits"
PROGRAM = Path(sys.argv.pop(1)).resolve()
ONES = ("points", "partition", "array-flex28")


def bits(*words):
    return subprocess.run([BITS, *map(str, words)], capture_output=True, text=True, check=False, timeout=250)


class Bits(unittest.TestCase):
    def setUp(self):
        place = tempfile.TemporaryDirectory()
        self.addCleanup(place.cleanup)
        self.folder = Path(place.name)

    def test_what_was_recorded_replays_and_what_was_changed_is_found(self):
        recorded = bits("record", PROGRAM, self.folder, *ONES)
        self.assertEqual(recorded.returncode, 0, recorded.stderr)
        self.assertEqual(sorted(file.stem for file in self.folder.glob("*.insertion")), sorted(ONES))
        verified = bits("verify", PROGRAM, self.folder)
        self.assertEqual((verified.returncode, verified.stdout), (0, "3 recordings replay to the same bits.\n"), verified.stderr)
        changed = self.folder / "partition.insertion"
        content = changed.read_bytes()  # a quarter of it: pages at the end may be free ones
        begin, end = len(content) // 2, 3 * len(content) // 4
        changed.write_bytes(content[:begin] + bytes(end - begin) + content[end:])
        refused = bits("verify", PROGRAM, self.folder)
        self.assertEqual(refused.returncode, 1)
        self.assertIn("partition.insertion: ", refused.stderr)

    def test_wrong_words_are_refused(self):
        for words, said in ((("verify", PROGRAM, self.folder), "no recording"), (("record", "nothing", self.folder), "no program 'nothing'"),
                            (("destroy", PROGRAM, self.folder), "'destroy'"), (("record", PROGRAM, self.folder, "moon"), "no insertion 'moon'")):
            result = bits(*words)
            self.assertEqual(result.returncode, 1)
            self.assertIn(said, result.stderr)


if __name__ == "__main__":
    unittest.main()
