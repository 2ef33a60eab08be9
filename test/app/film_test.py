#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""resources/pictures/make-film makes an animated PNG of pictures; README's pictures keep their bounds."""

import struct
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    from PIL import Image
except ImportError:
    Image = None

PICTURES = Path(__file__).resolve().parents[2] / "resources/pictures"


def chunks(file):
    """(name, content) of every chunk of a PNG."""
    content, at = file.read_bytes(), 8
    while at < len(content):
        length, name = struct.unpack(">I4s", content[at:at + 8])
        yield name.decode(), content[at + 8:at + 8 + length]
        at += 12 + length


def size(file):
    return struct.unpack(">II", dict(chunks(file))["IHDR"][:8])


def durations(file):
    """Of the frames [s]."""
    return [numerator / (denominator or 100) for numerator, denominator in
            (struct.unpack(">HH", content[20:24]) for name, content in chunks(file) if name == "fcTL")]


class Bounds(unittest.TestCase):
    def test_the_picture_of_the_window_is_whole_and_small(self):
        window = PICTURES / "window.png"
        self.assertEqual(size(window), (1280, 800))
        self.assertLessEqual(window.stat().st_size, 400_000)

    def test_the_film_is_small_plays_for_ever_and_lasts_two_minutes_at_most(self):
        film = PICTURES / "film.png"
        self.assertLessEqual(film.stat().st_size, 3_000_000)
        self.assertLessEqual(size(film), (1280, 848))
        frames, plays = struct.unpack(">II", dict(chunks(film))["acTL"])
        self.assertGreaterEqual(frames, 12)
        self.assertEqual((len(durations(film)), plays), (frames, 0))
        self.assertLessEqual(sum(durations(film)), 120.0)
        self.assertGreaterEqual(min(durations(film)), 0.2)


@unittest.skipIf(Image is None, "python3-pil is not installed")
class Making(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def picture(self, name, seconds, color, extent=(64, 40)):
        Image.new("RGB", extent, color).save(self.folder / name)
        with (self.folder / "frames.tsv").open("a", encoding="utf-8") as rows:
            rows.write(f"{name}\t{seconds}\n")

    def make(self):
        return subprocess.run([sys.executable, PICTURES / "make-film", "--frames", self.folder, "--out", self.folder], capture_output=True,
                              text=True, check=False, timeout=60)

    def test_every_picture_is_a_frame_of_its_duration_and_colors(self):
        colors = ((20, 24, 28), (230, 160, 20), (80, 170, 230))
        for number, color in enumerate(colors):
            self.picture(f"{number}.png", 0.5 + number, color)
        done = self.make()
        self.assertEqual(done.returncode, 0, done.stderr)
        film = self.folder / "film.png"
        self.assertEqual(durations(film), [0.5, 1.5, 2.5])
        with Image.open(film) as shown:
            for number, color in enumerate((colors[1], *colors)):  # the cover first
                shown.seek(number)
                found = shown.convert("RGB").getpixel((5, 5))
                self.assertLessEqual(max(abs(a - b) for a, b in zip(found, color)), 4, color)

    def refused(self, said):
        done = self.make()
        self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1), done.stderr)
        self.assertIn(said, done.stderr)
        self.assertFalse((self.folder / "film.png").exists())

    def test_pictures_that_are_missing_or_damaged_are_named(self):
        self.refused("frames.tsv")
        (self.folder / "frames.tsv").write_text("gone.png\t1.0\n", encoding="utf-8")
        self.refused("gone.png")
        (self.folder / "frames.tsv").write_text("no table\n", encoding="utf-8")
        self.refused("cannot be read")

    def test_one_picture_and_pictures_of_two_sizes_are_no_film(self):
        self.picture("1.png", 1.0, "black")
        self.refused("has 1 pictures")
        self.picture("2.png", 1.0, "black", (32, 20))
        self.refused("differ in size")

    def test_a_film_that_lasts_too_long_is_refused(self):
        self.picture("1.png", 100.0, "black")
        self.picture("2.png", 30.0, "white")
        self.refused("last 130 s; a film may last 120 s")


if __name__ == "__main__":
    unittest.main()
