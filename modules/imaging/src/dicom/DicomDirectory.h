// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A DICOMDIR: the table of contents of a medium.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace perilymph::imaging {

struct DicomDirectory {
  std::vector<std::filesystem::path> files;  ///< Those that are there, each within its folder.
  std::size_t missing = 0;                   ///< Named, and not there.
};

/// The files that a DICOMDIR names; none where the file is no DICOMDIR. A file is also found under its name in
/// lower case, with an ending (.dcm, .ima), or with a version (;1), as media are copied.
std::optional<DicomDirectory> readDicomDirectory(const std::filesystem::path& file);

}  // namespace perilymph::imaging
