#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The guide as HTML, as packaging/site writes it: every link and picture leads somewhere, nothing is loaded from a network, and
the search finds the page that a first-time user needs."""

import html.parser
import json
import os
import re
import shutil
import subprocess
import tempfile
import unicodedata
import unittest
from pathlib import Path
from urllib.parse import quote, unquote, urlsplit

ROOT = Path(__file__).resolve().parents[2]
PYTHON = "/usr/bin/python3"  # that of the Debian packages
NEEDED = [name for name in ("sphinx-build", "mandoc") if shutil.which(name) is None]
NEEDED += [name for name in ("myst_parser", "furo")
           if not shutil.which(PYTHON) or subprocess.run([PYTHON, "-c", f"import {name}"], capture_output=True).returncode != 0]
BROWSER = shutil.which("chromium")

# What a first-time user types, and the page that answers it. Written before the index was looked at.
WANTED = {"round window": "resources/guide/glossary", "friction": "resources/guide/friction", "kiosk": "resources/guide/booth",
          "Slicer": "resources/guide/navigation", "pickle": "resources/guide/python", "fold-over": "resources/guide/glossary",
          "Greenwood": "resources/guide/outcome", "wheel": "resources/guide/python", "SLURM": "resources/guide/studies",
          "stylet": "resources/guide/glossary", "Messestand": "resources/guide/de/booth",
          "Insertionstiefe": "resources/guide/de/glossary"}
# Prints the pages that have all of the words, by the index and the word stems of Sphinx.
PAGES_WITH_WORDS = """
import json, sys
from sphinx.search import js_index
from sphinx.search.en import SearchEnglish
with open(sys.argv[1], encoding="utf-8") as file:
    index = js_index.load(file)
language = SearchEnglish({})
found = {}
for words in json.load(sys.stdin):
    each = []
    for word in language.split(words.lower()):
        if word not in language.stopwords:
            places = [index[table].get(language.stem(word), []) for table in ("terms", "titleterms")]
            each.append(set().union(*[[place] if isinstance(place, int) else place for place in places]))
    found[words] = [index["docnames"][i] for i in set.intersection(*each)]
print(json.dumps(found))
"""
# Results that a reader looks at before typing other words.
LOOKED_AT = 5


def letters(anchor):
    """What Sphinx and GitHub keep of a heading in its anchor: without digits in front, signs and accents."""
    return re.sub(r"[^a-z]", "", unicodedata.normalize("NFKD", anchor.lower()))


class Page(html.parser.HTMLParser):
    """Anchors, links, and what a browser loads with the page."""

    def __init__(self, file):
        super().__init__()
        self.anchors, self.links, self.loaded, self.pictures = set(), [], [], 0
        self.language = None
        self.feed(file.read_text(encoding="utf-8"))

    def handle_starttag(self, tag, attrs):
        keys = dict(attrs)
        self.anchors.update(keys[name] for name in ("id", "name") if keys.get(name))
        if tag == "html":
            self.language = keys.get("lang")
        if tag == "img":
            self.pictures += 1
        if tag == "a" and "href" in keys:
            self.links.append(keys["href"])
        if tag == "link" and not {"search", "next", "prev", "index"} & set(keys.get("rel", "").split()):
            self.loaded.append(keys["href"])
        self.loaded += [keys[name] for name in ("src", "poster", "data") if keys.get(name)]
        self.loaded += [part.split()[0] for part in (keys.get("srcset") or "").split(",") if part.strip()]


@unittest.skipIf(NEEDED, f"missing: {', '.join(NEEDED)}; packaging/install-dependencies site installs it")
class Site(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        scratch = tempfile.TemporaryDirectory()
        cls.addClassCleanup(scratch.cleanup)
        cls.site = Path(scratch.name) / "site"
        made = subprocess.run([ROOT / "packaging/site", cls.site], capture_output=True, text=True, timeout=240)
        if made.returncode != 0:
            raise AssertionError(made.stdout + made.stderr)
        cls.pages = {file: Page(file) for file in sorted(cls.site.rglob("*.html"))}

    def page(self, name):
        return self.pages[self.site / f"{name}.html"]

    def target(self, file, address):
        """The file and the anchor that an address names in a page; None for one outside of the site."""
        parts = urlsplit(address)
        if parts.scheme or parts.netloc:
            return None
        self.assertFalse(parts.path.startswith("/"), f"{file.relative_to(self.site)}: {address} is no relative path.")
        there = file if not parts.path else Path(os.path.normpath(file.parent / unquote(parts.path)))
        self.assertTrue(there.is_relative_to(self.site), f"{file.relative_to(self.site)}: {address} leaves the site.")
        return there, unquote(parts.fragment)

    def test_every_page_of_the_guide_is_in_it_and_says_its_language(self):
        guide = ROOT / "resources/guide"
        for file in guide.rglob("*.md"):
            page = self.page(file.relative_to(ROOT).with_suffix(""))
            self.assertEqual(page.language, "de" if "de" in file.parts else "en", file)
        for file in (ROOT / "README.md", *(ROOT / "modules").glob("*/README.md")):
            self.page(file.relative_to(ROOT).with_suffix(""))

    def test_every_link_leads_to_a_page_and_to_its_heading(self):
        followed = 0
        for file, page in self.pages.items():
            for address in page.links:
                with self.subTest(page=str(file.relative_to(self.site)), link=address):
                    target = self.target(file, address)
                    if target is None:
                        continue
                    there, anchor = target
                    self.assertTrue(there.is_file())
                    if anchor and there.suffix == ".html":
                        self.assertIn(anchor, self.pages[there].anchors)
                    followed += 1
        self.assertGreater(followed, 5000)

    def test_the_links_of_the_sources_are_links_of_the_pages(self):
        # Markdown that is not understood would leave the text without its link.
        for file in (ROOT / "README.md", *sorted((ROOT / "resources/guide").rglob("*.md"))):
            text = re.sub(r"^(```|    ).*?$|`[^`\n]*`", "", file.read_text(), flags=re.MULTILINE)
            here = self.site / file.relative_to(ROOT).with_suffix(".html")
            targets = [target for target in (self.target(here, address) for address in self.pages[here].links) if target]
            reached = {(there, letters(anchor)) for there, anchor in targets}
            for address in re.findall(r"(?<!!)\[[^]]*\]\(([^)\s]+\.md(?:#[^)\s]+)?)\)", text):
                there, anchor = self.target(here, re.sub(r"\.md\b", ".html", address))
                with self.subTest(page=str(file.relative_to(ROOT)), link=address):
                    self.assertTrue((there, letters(anchor)) in reached, "The page lacks this link.")

    def test_pictures_styles_and_scripts_are_in_it(self):
        shown = set()
        for file, page in self.pages.items():
            for address in page.loaded:
                with self.subTest(page=str(file.relative_to(self.site)), loads=address):
                    target = self.target(file, address)
                    self.assertIsNotNone(target, "is loaded from elsewhere")
                    self.assertGreater(target[0].stat().st_size, 0)
                    shown.add(target[0].name)
        for picture in (ROOT / "resources/guide/pictures").glob("*.png"):
            self.assertIn(picture.name, shown)

    def test_nothing_is_loaded_from_a_network(self):
        for file in self.site.rglob("*.css"):
            for address in re.findall(r"""url\(\s*["']?([^"')]*)|@import\s+["']([^"']*)""", file.read_text()):
                address = "".join(address)
                if address.startswith(("data:", "#")):
                    continue
                with self.subTest(style=file.name, loads=address):
                    target = self.target(file, address)
                    self.assertIsNotNone(target, "is loaded from elsewhere")
                    # of the builder of a theme, which a newer Furo left in its style
                    if address != "~normalize.css":
                        self.assertTrue(target[0].is_file())
        for file in self.site.rglob("*.js"):
            with self.subTest(script=file.name):
                self.assertNotRegex(file.read_text(), r"""(?:fetch|import|importScripts|open)\(\s*["'`](?:https?:)?//""")
                self.assertNotRegex(file.read_text(), r"""(?:src|href)\s*=\s*["'`](?:https?:)?//""")

    def test_the_start_page_names_every_tutorial(self):
        start = self.site / "index.html"
        reached = {target[0] for target in (self.target(start, address) for address in self.pages[start].links) if target}
        for name in ("visitor", "surgeon", "ct", "planning", "clinician", "outcome", "de/README"):
            self.assertIn(self.site / f"resources/guide/{name}.html", reached)

    def test_the_index_has_the_page_for_each_word(self):
        done = subprocess.run([PYTHON, "-c", PAGES_WITH_WORDS, self.site / "searchindex.js"], input=json.dumps(list(WANTED)),
                              capture_output=True, text=True, timeout=60, check=True)
        for words, pages in json.loads(done.stdout).items():
            with self.subTest(words=words):
                self.assertIn(WANTED[words], pages)

    def browse(self, address):
        """The page as a browser without a network has it, and the words of its scripts."""
        with tempfile.TemporaryDirectory() as profile:
            shown = subprocess.run(
                [BROWSER, "--headless=new", "--no-sandbox", "--disable-gpu", "--host-resolver-rules=MAP * ~NOTFOUND",
                 "--enable-logging=stderr", f"--user-data-dir={profile}", "--virtual-time-budget=8000", "--dump-dom",
                 f"file://{self.site}/{address}"], capture_output=True, text=True, timeout=60, check=True)
        return shown.stdout, [line for line in shown.stderr.splitlines() if "CONSOLE" in line]

    @unittest.skipIf(BROWSER is None, "chromium is not installed")
    def test_a_browser_runs_the_scripts_without_an_error(self):
        for address in ("index.html", "resources/guide/surgeon.html", "search.html?q=friction"):
            page, words = self.browse(address)
            with self.subTest(page=address):
                self.assertEqual([line for line in words if re.search("Uncaught|Error|blocked|Failed", line)], [])
                # Furo's script removes the class that is for browsers without scripts.
                self.assertNotIn("no-js", re.search("<html[^>]*>", page).group(0))

    @unittest.skipIf(BROWSER is None, "chromium is not installed")
    def test_a_browser_shows_the_page_among_the_first_results(self):
        for words, wanted in WANTED.items():
            with self.subTest(words=words):
                page, _ = self.browse(f"search.html?q={quote(words)}")
                results = re.search(r'id="search-results".*?</ul>', page, re.DOTALL).group(0)
                pages = [re.sub(r"\.html.*", "", address) for address in re.findall(r'href="([^"]*)"', results)]
                self.assertIn(wanted, list(dict.fromkeys(pages))[:LOOKED_AT])


if __name__ == "__main__":
    unittest.main()
