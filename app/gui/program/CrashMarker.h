#pragma once

// A mark that stands while the program runs. One whose program is gone tells of a crash.

#include <filesystem>
#include <optional>
#include <vector>

namespace perilymph::gui {

/// Names the recording that is being written, for as long as this object lives.
class CrashMarker {
public:
  /// Marks this process's run in a folder. What cannot be written is not marked: a crash is then
  /// not noticed, and nothing else is different.
  explicit CrashMarker(const std::filesystem::path& folder);
  ~CrashMarker();
  CrashMarker(const CrashMarker&) = delete;
  CrashMarker& operator=(const CrashMarker&) = delete;

  void setRecording(const std::optional<std::filesystem::path>& recording);

  /// The recordings of runs that ended without a word, those that are still there; their marks are
  /// removed. Marks of programs that still run stay.
  static std::vector<std::filesystem::path> takeCrashed(const std::filesystem::path& folder);

private:
  std::filesystem::path file_;
};

}  // namespace perilymph::gui
