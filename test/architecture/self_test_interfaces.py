#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The check of public headers finds what it looks for."""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import check_case  # noqa: E402
from checks import interfaces  # noqa: E402

GOOD = {
    "modules/ground/include/perilymph/ground/g.h": "#pragma once\n",
    "modules/top/include/perilymph/top/t.h": "#pragma once\n",
    "modules/top/src/t.cpp": '#include "perilymph/top/t.h"\n#include "perilymph/ground/g.h"\n',
    "app/gui/main.cpp": '#include "perilymph/top/t.h"\n',
}


class Interfaces(unittest.TestCase):
    def complaints(self, changes=()):
        return check_case.complaints(interfaces.check, GOOD, changes)

    def assert_found(self, expected, changes):
        found = self.complaints(changes)
        self.assertEqual(len(found), 1, found)
        self.assertIn(expected, found[0])

    def test_a_good_project_passes(self):
        self.assertEqual(self.complaints(), [])

    def test_a_public_header_that_only_its_module_and_tests_use_is_found(self):
        self.assert_found("modules/top/include/perilymph/top/inner.h is used by nobody", {
            "modules/top/include/perilymph/top/inner.h": "#pragma once\n",
            "modules/top/src/inner.cpp": '#include "perilymph/top/inner.h"\n',
            "test/t.cpp": '#include "perilymph/top/inner.h"\n'})

    def test_a_header_that_a_used_header_includes_is_used(self):
        self.assertEqual(self.complaints({
            "modules/top/include/perilymph/top/inner.h": "#pragma once\n",
            "modules/top/include/perilymph/top/t.h": '#pragma once\n#include "perilymph/top/inner.h"\n'}), [])

    def test_internals_of_a_module_are_for_tests_only(self):
        linked = "target_link_libraries(perilymph PRIVATE perilymph_top_internal)\n"
        self.assert_found("app/gui/CMakeLists.txt:1: links perilymph_top_internal", {
            "app/gui/CMakeLists.txt": linked, "test/CMakeLists.txt": linked})


if __name__ == "__main__":
    unittest.main()
