#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""The check of threads, processes and channels finds what it looks for."""

import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import check_case  # noqa: E402
from checks import threads  # noqa: E402

PAGE = """
<!-- threads -->
| Thread | Begins in | May | May not |
|---|---|---|---|
| `window` | `main.cpp` | draw | compute |
| `sound` | `Voice.cpp` | play | draw |
<!-- /threads -->
<!-- processes -->
| Process | Begins in | Why |
|---|---|---|
| `guard` | `Guard.cpp` | outlives |
<!-- /processes -->
<!-- channels -->
| Question | Channel | When full or empty |
|---|---|---|
| newest? | `Newest` | overwritten |
<!-- /channels -->
"""
SHARED_PAGE = """
<!-- shared -->
| Declared in | How | Value | Shared by |
|---|---|---|---|
| `Guard.cpp` | mutex, condition; atomic | the last call | sound, window |
<!-- /shared -->
"""
VOICE = "void f() { std::thread([] { declareThread(ThreadRole::sound); }).join(); }\n"
GOOD = {
    "modules/README.md": PAGE,
    threads.SHARED_PAGE: SHARED_PAGE,
    threads.ROLES: "enum class ThreadRole { none, window, ///< Draws.\n sound };\n",
    f"{threads.CHANNELS}/Newest.h": "template <class Value>\nclass Newest {};\n",
    "app/gui/main.cpp": "int main() { declareThread(ThreadRole::window); realtime::Newest<int> now; }\n",
    "modules/tone/src/Voice.cpp": VOICE,
    "modules/device/src/Guard.cpp": "int f() { return startProgram(call); }\n"
                                    "std::mutex a; std::condition_variable b; std::atomic<bool> c;\n",
}


class Threads(unittest.TestCase):
    def complaints(self, changes=()):
        return check_case.complaints(threads.check, GOOD, changes)

    def assert_found(self, expected, changes):
        found = self.complaints(changes)
        self.assertTrue(any(expected in sentence for sentence in found), found)

    def test_a_good_project_passes(self):
        self.assertEqual(self.complaints(), [])

    def test_a_role_that_the_table_does_not_tell_is_found(self):
        self.assert_found("tells the thread `idle`", {
            threads.ROLES: "enum class ThreadRole { none, window, sound, idle };\n"})

    def test_a_thread_of_the_table_without_a_role_is_found(self):
        self.assert_found("`sound`, which is no role", {threads.ROLES: "enum class ThreadRole { none, window };\n"})

    def test_a_role_that_begins_elsewhere_is_found(self):
        self.assert_found("begins in Voice.cpp; it is declared in modules/tone/src/Tone.cpp", {
            "modules/tone/src/Voice.cpp": "\n", "modules/tone/src/Tone.cpp": VOICE})

    def test_a_role_that_is_declared_twice_is_found(self):
        self.assert_found("it is declared in", {"modules/tone/src/Tone.cpp": VOICE})

    def test_a_thread_that_declares_no_role_is_found(self):
        for begin in ("std::jthread t(work);", "std::vector<std::jthread> all;", "std::thread t{work};",
                      "auto t = std::async(work);", "QThread thread;", "QThreadPool pool;"):
            self.assert_found("modules/tone/src/Silent.cpp begins", {"modules/tone/src/Silent.cpp": f"{begin}\n"})

    def test_a_second_thread_in_a_file_declares_its_own_role(self):
        self.assert_found("begins 2 threads and declares the role of 1", {
            "modules/tone/src/Voice.cpp": VOICE + "void g() { std::thread(work).detach(); }\n"})

    def test_the_number_of_processors_is_no_thread(self):
        self.assertEqual(self.complaints({
            "modules/tone/src/Count.cpp": "// std::thread(work)\nint n = std::thread::hardware_concurrency();\n"}), [])

    def test_a_member_in_the_header_belongs_to_its_source(self):
        self.assertEqual(self.complaints({"modules/tone/src/Voice.h": "std::jthread thread_;\n"}), [])

    def test_what_threads_share_stands_in_the_table_of_its_file(self):
        for value in ("std::mutex m;", "std::once_flag once;", "std::array<std::atomic<double>, 3> angles{};"):
            self.assert_found("tells of Voice.h: nothing; it declares", {"modules/tone/src/Voice.h": f"{value}\n"})
        self.assert_found("tells of Guard.cpp: atomic, condition, mutex; it declares atomic that threads share", {
            "modules/device/src/Guard.cpp": "int f() { return startProgram(call); }\nstd::atomic<bool> c;\n"})

    def test_references_and_locks_are_no_shared_values(self):
        self.assertEqual(self.complaints({"modules/tone/src/Voice.h": (
            "void f(const std::atomic<bool>& isEnding, std::mutex& m);\nstd::unique_lock<std::mutex> lock(m);\n"
            "auto p = std::make_shared<std::atomic<int>>(0);\n")}), [])

    def test_a_process_that_the_table_does_not_tell_is_found(self):
        for begin in ("fork();", "::fork();", "startProgram(call);", "runProgram(name);", "QProcess other;"):
            self.assert_found("app/gui/Other.cpp begins a process", {"app/gui/Other.cpp": f"{begin}\n"})

    def test_a_program_that_is_started_another_way_is_found(self):
        for begin in ("posix_spawnp(&id);", "popen(text, mode);", "std::system(text);", "::execvp(name, list);"):
            self.assert_found("app/gui/Other.cpp starts a program by itself", {"app/gui/Other.cpp": f"{begin}\n"})

    def test_a_process_that_nobody_begins_is_found(self):
        self.assert_found("a process begins in Guard.cpp; none does", {"modules/device/src/Guard.cpp": "\n"})

    def test_a_channel_that_the_table_does_not_tell_is_found(self):
        self.assert_found("does not tell the channel `Every`", {
            f"{threads.CHANNELS}/Every.h": "template <class Value>\nclass Every {};\n"})

    def test_a_channel_that_is_not_there_or_that_nobody_uses_is_found(self):
        self.assert_found("which modules/realtime", {f"{threads.CHANNELS}/Newest.h": "\n"})
        self.assert_found("which nobody uses", {"app/gui/main.cpp": "declareThread(ThreadRole::window);\n"})


if __name__ == "__main__":
    unittest.main()
