#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Every place that states the release states the same, and the same date."""

import re
import unittest
import xml.etree.ElementTree as ElementTree
from datetime import date
from email.utils import parsedate_to_datetime
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PACKAGING = ROOT / "packaging"


def text(path):
    return (ROOT / path).read_text(encoding="utf-8")


def found(pattern, path):
    return re.findall(pattern, text(path), re.MULTILINE)


VERSION = found(r"^project\(perilymph VERSION ([0-9.]+)", "CMakeLists.txt")[0]
IS_DEV = found(r'^set\(PERILYMPH_VERSION_SUFFIX "(.*)"\)$', "CMakeLists.txt") == ["-dev"]
RELEASES = found(r"^## ([0-9.]+), (\d{4}-\d\d-\d\d)$", "packaging/CHANGELOG.md")


class TheRelease(unittest.TestCase):
    def test_the_changelog_lists_the_built_version_first_and_every_release_with_a_date(self):
        headings = found(r"^## (.*)$", "packaging/CHANGELOG.md")
        if IS_DEV:
            self.assertEqual(headings.pop(0), "Unreleased")
            self.assertGreater(*([int(part) for part in version.split(".")] for version in (VERSION, RELEASES[0][0])))
        else:
            self.assertEqual(RELEASES[0][0], VERSION)
        self.assertEqual(headings, [f"{version}, {day}" for version, day in RELEASES])
        days = [date.fromisoformat(day) for _, day in RELEASES]
        self.assertEqual(days, sorted(days, reverse=True))

    def test_the_description_for_software_centers_lists_the_releases_of_the_changelog(self):
        tree = ElementTree.parse(PACKAGING / "desktop/org.perilymph.perilymph.metainfo.xml")
        releases = [(each.get("version"), each.get("date")) for each in tree.iter("release")]
        self.assertEqual(releases, RELEASES)
        self.assertTrue(all(each.find("description/p") is not None for each in tree.iter("release")))

    def test_the_description_shows_no_picture_that_nobody_can_fetch(self):
        self.assertNotIn("<screenshot", text("packaging/desktop/org.perilymph.perilymph.metainfo.xml"))

    def test_the_debian_changelog_lists_the_releases_of_the_changelog(self):
        entries = found(r"^perilymph \((\S+)-1\) (\S+);", "packaging/debian/changelog")
        days = [parsedate_to_datetime(stamp).date().isoformat()
                for stamp in found(r"^ -- .*>  (.*)$", "packaging/debian/changelog")]
        if IS_DEV:  # dpkg takes 0.3.0~dev for older than 0.3.0
            self.assertEqual(entries.pop(0), (f"{VERSION}~dev", "UNRELEASED"))
            days.pop(0)
        self.assertEqual([(version, day) for (version, _), day in zip(entries, days, strict=True)], RELEASES)
        self.assertEqual({to for _, to in entries}, {"unstable"})

    def test_manual_pages_and_citation_state_it_with_its_date(self):
        for page in ("perilymph.1", "perilymph-cli.1"):
            self.assertEqual(found(r'^\.TH \S+ 1 "(\S+)" "perilymph (\S+)"', f"packaging/man/{page}"), [RELEASES[0][::-1]])
        self.assertEqual(found(r"^version: (\S+)$", "CITATION.cff"), [RELEASES[0][0]])
        self.assertEqual(found(r"^date-released: (\S+)$", "CITATION.cff"), [RELEASES[0][1]])


if __name__ == "__main__":
    unittest.main()
