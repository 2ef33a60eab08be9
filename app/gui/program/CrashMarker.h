// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A marker file that exists while the program runs. A marker without its process indicates a crash.

#include <filesystem>
#include <optional>
#include <vector>

namespace perilymph::gui {

/// Stores the name of the current recording during the lifetime of this object.
class CrashMarker {
public:
  /// Marks this process in a folder. If writing fails, a crash is not detected later; there is no
  /// other effect.
  explicit CrashMarker(const std::filesystem::path& folder);
  ~CrashMarker();
  CrashMarker(const CrashMarker&) = delete;
  CrashMarker& operator=(const CrashMarker&) = delete;

  void setRecording(const std::optional<std::filesystem::path>& recording);

  /// Returns the existing recordings of runs that crashed and removes their markers. Markers of
  /// running programs are kept.
  static std::vector<std::filesystem::path> takeCrashed(const std::filesystem::path& folder);

private:
  std::filesystem::path file_;
};

}  // namespace perilymph::gui
