# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx: the guide, the READMEs and the manual pages as HTML. packaging/site calls it, and gives the version."""

from pathlib import Path

project = "Perilymph"
author = "The Perilymph authors"
copyright = author  # pylint: disable=redefined-builtin
root_doc = "index"
source_suffix = {".md": "markdown"}
extensions = ["myst_parser"]
# Anchors of headings as in the repository, for all of its levels.
myst_heading_anchors = 6
# The text is shown as it is written: "--out" stays two hyphens.
smartquotes = False
# Indented blocks are commands, lines of files and equations.
highlight_language = "none"

html_theme = "furo"
html_static_path = ["style"]
html_css_files = ["site.css"]
html_logo = "resources/icons/perilymph.svg"
html_favicon = "resources/icons/perilymph-48.png"
html_copy_source = False
html_show_sourcelink = False
html_use_index = False
html_search_scorer = str(Path(__file__).with_name("scorer.js"))
# A browser may not read other pages of a folder for a summary, only of a server.
html_show_search_summary = False
# Fonts of the program's package, or those of the system; nothing is loaded.
fonts = {"font-stack": "Inter, 'Segoe UI', Roboto, 'Helvetica Neue', Arial, sans-serif",
         "font-stack--monospace": "'DejaVu Sans Mono', Menlo, Consolas, monospace"}
# The Furo of Debian 12 has its dark colors only behind a button, and not for a browser that asks for them: stated here, they hold
# for both.
dark = {"color-foreground-primary": "#ffffffcc", "color-foreground-secondary": "#9ca0a5", "color-foreground-muted": "#81868d",
        "color-foreground-border": "#666666", "color-background-primary": "#131416", "color-background-secondary": "#1a1c1e",
        "color-background-hover": "#1e2124ff", "color-background-hover--transparent": "#1e212400",
        "color-background-border": "#303335", "color-background-item": "#444444", "color-highlighted-background": "#083563",
        "color-highlight-on-target": "#333300", "color-card-border": "#1a1c1e", "color-card-background": "#18181a",
        "color-problematic": "#ee5151"}
html_theme_options = {
    "light_css_variables": {**fonts, "color-brand-primary": "#0b6b78", "color-brand-content": "#0b6b78"},
    "dark_css_variables": {**dark, "color-brand-primary": "#4cc3d1", "color-brand-content": "#4cc3d1"}}


def name_language(app, page, template, context, doctree):
    """German pages are pronounced and hyphenated as such."""
    if page.startswith("resources/guide/de/"):
        context["language"] = "de"


def setup(app):
    app.connect("html-page-context", name_language)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
