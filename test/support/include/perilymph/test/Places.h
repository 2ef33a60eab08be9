// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where this clone and its build folder are.

#include <filesystem>
#include <string>

namespace perilymph::test {

/// The folder that holds README.md.
std::filesystem::path projectFolder();
/// The build folder of the running test.
std::filesystem::path buildFolder();
/// The folder of the programs perilymph and perilymph-cli.
std::filesystem::path programFolder();
/// A program, or a device plug-in, that is built for tests only.
std::filesystem::path testProgram(const std::string& name);
std::filesystem::path testPlugin(const std::string& name);
/// The device plug-in that the package perilymph-dev shows as an example.
std::filesystem::path examplePlugin();
/// Files that tests read: stored recordings, accepted pictures.
std::filesystem::path testData();
/// The script that runs a program on a private screen.
std::filesystem::path withDisplay();

}  // namespace perilymph::test
