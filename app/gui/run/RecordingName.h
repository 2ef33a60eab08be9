// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Names of recordings that no file has yet.

#include <filesystem>
#include <string>

namespace perilymph::gui {

/// A file of the folder of recordings, named by the time of day and a scenario.
std::filesystem::path newRecording(const std::string& scenario);
/// A file beside a recording, with its name and a number from 2 on.
std::filesystem::path besides(const std::filesystem::path& recording);

}  // namespace perilymph::gui
