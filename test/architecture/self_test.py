#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Tests of the checks: each one is applied to a small project with one error."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import check_case  # noqa: E402
from checks import arrows, documents, formatting, house, layout, licenses, sources, tests, vocabulary, window, words  # noqa: E402
from good_project import GUI_TABLE, TABLES, good_project  # noqa: E402


class CheckCase(unittest.TestCase):
    def complaints(self, check, changes=()):
        """Messages of a check for the good project with some files replaced (None: removed)."""
        return check_case.complaints(check, good_project(), changes)

    def assert_found(self, check, expected, changes):
        found = self.complaints(check, changes)
        self.assertEqual(len(found), 1, found)
        self.assertIn(expected, found[0])


class GoodProject(CheckCase):
    def test_no_check_complains_of_it(self):
        for check in (arrows.check, documents.check, layout.check, tests.check, window.check, words.check):
            self.assertEqual(self.complaints(check), [], check.__module__)


class Arrows(CheckCase):
    def test_an_include_upward_is_found_with_file_and_line(self):
        self.assert_found(arrows.check, "modules/ground/src/g.cpp:2: includes perilymph/top/t.h",
                          {"modules/ground/src/g.cpp": '\n#include "perilymph/top/t.h"\n'})

    def test_an_include_sideways_is_found(self):
        self.assert_found(arrows.check, "no arrow to beside", {
            "modules/upper/include/perilymph/upper/u.h": '#include "perilymph/beside/b.h"\n'})

    def test_what_a_used_module_uses_comes_along(self):
        self.assertEqual(self.complaints(arrows.check, {
            "modules/top/src/t.cpp": '#include "perilymph/ground/g.h"\n'}), [])

    def test_an_include_in_a_comment_is_none(self):
        self.assertEqual(self.complaints(arrows.check, {
            "modules/ground/src/g.cpp": '/*\n#include "perilymph/top/t.h"\n*/\n'
                                        '// #include "perilymph/top/t.h"\n'}), [])

    def test_uses_without_an_arrow_is_found(self):
        self.assert_found(arrows.check, "uses beside", {
            "modules/upper/CMakeLists.txt":
                'perilymph_module(upper LAYER engine SUMMARY "x" USES ground beside SOURCES u.cpp)'})

    def test_the_wrong_layer_is_found(self):
        self.assert_found(arrows.check, "LAYER must be engine", {
            "modules/upper/CMakeLists.txt":
                'perilymph_module(upper LAYER toolkit SUMMARY "x" USES ground)'})

    def test_qt_in_the_engine_is_found(self):
        self.assert_found(arrows.check, "Qt belongs to", {
            "modules/upper/src/u.cpp": "#include <QString>\n"})

    def test_vtk_in_the_engine_is_found(self):
        self.assert_found(arrows.check, "VTK belongs to", {
            "modules/upper/src/u.cpp": "#  include <vtkActor.h>\n"})

    def test_a_module_without_a_row_is_found(self):
        self.assert_found(arrows.check, "modules/extra has no row", {
            "modules/extra/CMakeLists.txt": "perilymph_module(extra LAYER engine)"})

    def test_a_drawn_arrow_upward_is_found(self):
        self.assert_found(arrows.check, "an arrow goes down", {
            "modules/README.md": TABLES.replace("`ground` | - |", "`ground` | `top` |")})

    def test_a_page_without_its_table_is_found(self):
        self.assert_found(arrows.check, "no table of arrows", {"modules/README.md": "# Modules\n"})


class Documents(CheckCase):
    def test_a_dead_link_is_found(self):
        self.assert_found(documents.check, "README.md:3: links to gone.md", {
            "modules/top/README.md": "# top\n\n[see](gone.md)\n"})

    def test_a_dead_picture_is_found(self):
        self.assert_found(documents.check, "links to gone.png", {
            "modules/top/README.md": "![window](gone.png)\n"})

    def test_a_path_that_does_not_exist_is_found(self):
        self.assert_found(documents.check, "names modules/gone/gone.h", {
            "modules/top/README.md": "Read `modules/gone/gone.h`.\n"})

    def test_a_file_name_that_nobody_bears_is_found(self):
        self.assert_found(documents.check, "names gone.cpp", {
            "modules/top/README.md": "Read `gone.cpp`.\n"})

    def test_units_and_names_with_slashes_are_no_paths(self):
        self.assertEqual(self.complaints(documents.check, {
            "modules/top/README.md": "`mm/s`, `N/m`, `tick/rod/nodes:100`, `build/dev/bin/x`, "
                                     "`perilymph/top/t.h`, [net](https://example.org/a.md)\n"}), [])

    def test_a_folder_missing_on_the_map_is_found(self):
        self.assert_found(documents.check, "does not show modules/extra", {"modules/extra/x": ""})

    def test_a_folder_only_on_the_map_is_found(self):
        page = good_project()["README.md"].replace("  upper ", "  attic  dust\n  upper ")
        self.assert_found(documents.check, "shows modules/attic, which does not exist",
                          {"README.md": page})


class Layout(CheckCase):
    def test_a_stray_file_at_the_top_is_found(self):
        self.assert_found(layout.check, "notes.txt may not stand", {"notes.txt": ""})

    def test_a_module_without_its_page_is_found(self):
        self.assert_found(layout.check, "modules/top/README.md is missing",
                          {"modules/top/README.md": None})

    def test_a_stray_file_in_a_module_is_found(self):
        self.assert_found(layout.check, "modules/top/notes.txt may not stand",
                          {"modules/top/notes.txt": ""})

    def test_headers_of_another_name_are_found(self):
        self.assert_found(layout.check, "does not belong to modules/top",
                          {"modules/top/include/perilymph/other/o.h": "#pragma once\n"})

    def test_a_header_without_its_guard_is_found(self):
        self.assert_found(layout.check, "lacks #pragma once",
                          {"modules/top/include/perilymph/top/t.h": "\n"})

    def test_settings_below_the_top_are_found(self):
        self.assert_found(layout.check, "app/gui/.clang-format may not stand",
                          {"app/gui/.clang-format": "BasedOnStyle: Google\n"})

    def test_a_copy_of_a_file_is_found(self):
        text = "".join(f"int number{i} = {i};\n" for i in range(12))
        self.assert_found(layout.check, "modules/top/src/t.cpp is a copy of app/gui/main.cpp",
                          {"app/gui/main.cpp": text, "modules/top/src/t.cpp": text})



class Licenses(CheckCase):
    LINE = "SPDX-License-Identifier: BSD-3-Clause\n"

    def stated(self, changes=()):
        signs = {".h": "// ", ".cpp": "// ", ".txt": "# "}
        project = {name: signs.get(Path(name).suffix, "") and signs[Path(name).suffix] + self.LINE + text
                   for name, text in good_project().items()}
        return self.complaints(licenses.check, {**project, "LICENSE": "BSD 3-Clause License\n", **dict(changes)})

    def test_sources_with_the_line_are_accepted_also_below_a_shebang(self):
        self.assertEqual(self.stated({"packaging/run": f"#!/bin/bash\n# {self.LINE}set -e\n"}), [])

    def test_a_source_without_the_line_is_found(self):
        for name, text in (("modules/top/src/t.cpp", "int x;\n"), ("test/CMakeLists.txt", ""),
                           ("test/tool.py", f"\n# {self.LINE}"), ("packaging/run", "#!/bin/sh\nset -e\n")):
            found = self.stated({name: text})
            self.assertEqual([each.split(":")[0] for each in found], [name])


@unittest.skipUnless(formatting.formatter() == formatting.FORMATTED_BY, "clang-format of the version used is not installed")
class Formatting(CheckCase):
    def test_a_line_that_would_be_written_otherwise_is_found_with_its_place(self):
        self.assert_found(formatting.check, "modules/top/src/t.cpp:2 is not formatted", {
            ".clang-format": "BasedOnStyle: Google\nSortIncludes: Never\n",
            "modules/top/src/t.cpp": "int one();\nint  two();\n"})


class Window(CheckCase):
    def test_a_page_that_includes_another_is_found(self):
        self.assert_found(window.check, 'app/gui/pages/one/one.cpp:2: includes gui/pages/two/two.h, but', {
            "app/gui/pages/one/one.cpp": '#include "gui/pages/one/one.h"\n#include "gui/pages/two/two.h"\n'})

    def test_an_include_upward_is_found(self):
        self.assert_found(window.check, "draws no arrow to frame", {
            "app/gui/run/run.h": '#pragma once\n#include "gui/frame/frame.h"\n'})

    def test_what_a_used_folder_uses_comes_along(self):
        self.assertEqual(self.complaints(window.check, {
            "app/gui/frame/frame.h": '#pragma once\n#include "gui/run/run.h"\n'}), [])

    def test_a_bare_include_is_found(self):
        self.assert_found(window.check, 'write "gui/run/run.h"', {
            "app/gui/run/run.cpp": '#include "run.h"\n'})

    def test_a_widget_in_what_works_without_is_found(self):
        for header in ("QWidget", "QtWidgets/QLabel", "QTableWidget", "QPixmap"):
            self.assert_found(window.check, "works without widgets", {
                "app/gui/run/run.h": f"#pragma once\n#include <{header}>\n"})

    def test_uses_that_differ_from_the_table_are_found(self):
        self.assert_found(window.check, "USES and the row in app/gui/README.md differ in run", {
            "app/gui/pages/one/CMakeLists.txt": "perilymph_gui_part(pages/one SOURCES one.cpp)\n"})

    def test_a_folder_without_its_call_is_found(self):
        self.assert_found(window.check, "does not call perilymph_gui_part(run ...)", {
            "app/gui/run/CMakeLists.txt": "add_library(run run.cpp)\n"})

    def test_a_folder_without_a_row_is_found(self):
        self.assert_found(window.check, "app/gui/extra has no row", {"app/gui/extra/extra.h": "#pragma once\n"})

    def test_a_row_without_a_folder_is_found(self):
        found = self.complaints(window.check, {
            "app/gui/README.md": GUI_TABLE.replace("| `frame`", "| `attic` | - | dust |\n| `frame`")})
        self.assertTrue(any("has a row attic, which does not exist" in each for each in found), found)

    def test_an_arrow_to_a_row_below_is_found(self):
        found = self.complaints(window.check, {
            "app/gui/README.md": GUI_TABLE.replace("| `run` | - |", "| `run` | `frame` |")})
        self.assertTrue(any("run may use frame, which has no row above it" in each for each in found), found)

    def test_a_page_without_its_table_is_found(self):
        self.assert_found(window.check, "no table of arrows", {"app/gui/README.md": "# The window\n"})

    def test_a_source_without_its_header_is_found(self):
        self.assert_found(window.check, "app/gui/run/more.cpp has no header of its name", {
            "app/gui/run/more.cpp": "\n"})

    def test_two_headers_of_one_name_are_found(self):
        self.assert_found(window.check, "app/gui/run/t.h has the name of modules/top", {
            "app/gui/run/t.h": "#pragma once\n"})

    def test_markup_outside_its_places_is_found(self):
        self.assert_found(window.check, "app/gui/main.cpp:2: 'RichText' may draw text as markup", {
            "app/gui/main.cpp": "\nlabel.setTextFormat(Qt::RichText);\n"})

    def test_markup_in_its_places_is_welcome(self):
        self.assertEqual(self.complaints(window.check, {
            "app/gui/run/ReportPages.cpp": "document.setHtml(text);\n", "app/gui/run/ReportPages.h": "#pragma once\n"}), [])


    def test_a_main_window_that_does_everything_is_found(self):
        complaints = self.complaints(window.check, {
            "app/gui/shell/MainWindow.h": "".join(f"  Page* page{i}_;\n" for i in range(16)),
            "app/gui/shell/MainWindow.cpp": "\n"})
        self.assertEqual(sum("a class beside it" in each for each in complaints), 1, complaints)


class House(CheckCase):
    def test_a_picture_drawn_now_is_current_until_the_table_changes(self):
        with tempfile.TemporaryDirectory() as place:
            root = Path(place)
            (root / "modules").mkdir()
            (root / "modules/README.md").write_text(TABLES)
            (root / house.PICTURE).parent.mkdir(parents=True)
            (root / house.PICTURE).write_text(house.draw(root))
            self.assertEqual(house.check(root), [])
            (root / "modules/README.md").write_text(TABLES.replace("`upper` `beside`", "`upper`").replace("stories", "tales"))
            self.assertEqual(len(house.check(root)), 1)

    def test_a_missing_picture_is_noticed(self):
        self.assert_found(house.check, "house.svg is missing", {})


class Vocabulary(CheckCase):
    def test_an_identifier_that_was_given_up_is_found(self):
        self.assert_found(vocabulary.check, "'mostForce'", {"modules/top/src/t.cpp": "double mostForce = 1.0;\n"})
        self.assert_found(vocabulary.check, "'FullInsertion'", {"modules/top/src/t.cpp": "FullInsertion fit;\n"})

    def test_a_retired_phrase_of_a_comment_is_found_in_a_header(self):
        self.assert_found(vocabulary.check, "t.h:2: 'goes on' is a retired phrase", {
            "modules/top/include/perilymph/top/t.h": "#pragma once\n/// The loop goes on.\nint t();\n"})

    def test_a_retired_text_is_found_where_users_read_it(self):
        self.assert_found(vocabulary.check, "t.cpp:2: 'Sessions' is a retired word", {
            "modules/top/src/t.cpp": '\nauto page = tr("Sessions");  // Sessions\n'})
        self.assert_found(vocabulary.check, "surgeon.md:1: 'Sessions' is a retired word", {
            "resources/guide/surgeon.md": "Open **Sessions**.\n"})

    def test_a_signal_that_asks_is_found(self):
        self.assert_found(vocabulary.check, "call it closeRequested", {"modules/top/src/t.cpp": "void closeAsked();\n"})

    def test_least_squares_and_the_standard_library_keep_their_names(self):
        self.assertEqual(self.complaints(vocabulary.check, {
            "modules/top/src/t.cpp": "auto fit = leastSquares(promise.get_future().share());\n"}), [])

    def test_a_doc_comment_that_is_no_sentence_is_found(self):
        self.assert_found(vocabulary.check, "", {"modules/top/src/t.cpp": "int n;  ///< Of Newton's method.\n"})


class Words(CheckCase):
    def test_machine_paths_are_found(self):
        for path in ("/wo" "rk/shared", "/ro" "ot/file"):
            self.assert_found(words.check, "a path of one machine",
                              {"modules/top/src/t.cpp": f'\nopen("{path}");\n'})

    def test_temporary_paths_in_documents_are_found(self):
        for path in ("/t" "mp/x", "/ho" "me/ann/file"):
            self.assert_found(words.check, "a path of one machine",
                              {"modules/top/README.md": f"see {path}\n"})

    def test_unsafe_math_flags_are_found(self):
        self.assert_found(words.check, "a flag that changes results",
                          {"CMakeLists.txt": "add_compile_options(-ffast-" "math)\n"})

    def test_unfinished_work_is_found(self):
        self.assert_found(words.check, "unfinished work",
                          {"modules/top/src/t.cpp": "// TO" "DO: think\n"})

    def test_memory_orders_outside_realtime_are_found(self):
        self.assert_found(words.check, "t.cpp:2: 'memory_order_relaxed'",
                          {"modules/top/src/t.cpp": "\nx.load(std::memory_order_relaxed);\n"})

    def test_memory_orders_inside_realtime_are_none_of_this(self):
        self.assertEqual(self.complaints(words.check, {
            "modules/realtime/src/r.cpp": "x.load(std::memory_order_relaxed);\n"}), [])

    def test_sines_of_the_c_library_in_the_engine_are_found(self):
        for call in ("std::sin(x)", "std::atan2(y, x)", "Eigen::AngleAxisd(a, z)"):
            self.assert_found(words.check, "not the same bits",
                              {"modules/mechanics/src/m.cpp": f"y = {call};\n"})

    def test_exact_functions_in_the_engine_are_welcome(self):
        self.assertEqual(self.complaints(words.check, {
            "modules/mechanics/src/m.cpp": "y = std::sqrt(x) + std::abs(x); // not std::sin(x)\n"}),
            [])

    def test_null_pointers_of_c_are_found(self):
        self.assert_found(words.check, "write nullptr", {
            "modules/top/src/t.cpp": "int* p = NULL;\n"})

    def test_sleeping_tests_are_found(self):
        self.assert_found(words.check, "waiting by the clock", {
            "test/unit/t.cpp": "std::this_thread::sleep_for(1s);\n"})

    def test_printing_past_the_terminal_is_found(self):
        self.assert_found(words.check, "printing past Terminal.h", {
            "app/cli/main.cpp": 'int main() { std::printf("%s", name); }\n'})


class Tests(CheckCase):
    def test_bad_habits_are_found(self):
        for sentence, file, text in (
                ("a wait without a limit", "t.cpp", "while (!isOver()) std::this_thread::yield();\n"),
                ("a wait without a limit", "t.cpp", "while (last < values) {\n  if (!buffer.refresh()) continue;\n}\n"),
                ("a wait without a limit", "t.cpp", "while (now() < end) insertion->refresh();\n"),
                ("Rod.Bends expects nothing", "RodTest.cpp", "TEST(Rod, Bends)\n{\n  rod().bend();\n}\n"),
                ("name must end in Test.cpp", "rod.cpp", "TEST(Rod, Bends)\n{\n  EXPECT_TRUE(is());\n}\n")):
            self.assert_found(tests.check, sentence, {f"test/unit/{file}": text})


class Sources(unittest.TestCase):
    def test_comments_and_texts_are_blanked_and_lines_kept(self):
        text = 'a /* b\n */ "c // d" // e\nf R"x(g\n// h)x" i'
        self.assertEqual(sources.without_comments(text).split(), ["a", "f", "i"])
        self.assertEqual(sources.without_comments(text).count("\n"), text.count("\n"))


if __name__ == "__main__":
    unittest.main()
