// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Where the CT series of saved patients were read, so that their history opens them again.

#include <filesystem>
#include <string>

namespace perilymph::gui {

/// Remembers where a CT series was read, for the user of this computer alone: such folders often bear
/// patients' names, so neither settings nor a patient's files, exports, reports or logs have them.
///
/// @param series  SHA-256 of the series.
void rememberScan(const std::string& series, const std::filesystem::path& place);

/// Where a series was read last; empty if nothing is known of it. Nothing may be there any more.
std::filesystem::path placeOfScan(const std::string& series);

}  // namespace perilymph::gui
