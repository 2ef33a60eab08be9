// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// vtk-dicom's parser ends the process on some damaged files: it asserts that a fragment of an element
// of undefined length is shorter than 4 GiB, where it should refuse one that is longer than the file.

#include <chrono>
#include <filesystem>
#include <optional>
#include <set>
#include <stop_token>
#include <vector>

namespace perilymph::imaging {

/// The files that end the parser, take it longer than seconds, or make it allocate more than 512 MiB, for any use of
/// it here. Each is parsed in a child process; this one never parses what took the child too long. What was not tried
/// when it is canceled is not among them. None where all of them together take longer than `longest`.
std::optional<std::set<std::filesystem::path>> filesThatEndTheParser(
    const std::vector<std::filesystem::path>& files, const std::stop_token& stop,
    std::chrono::milliseconds longest = std::chrono::minutes(5));

}  // namespace perilymph::imaging
