#pragma once

// A mark that stands while the program runs. One whose program is gone tells of a crash.

#include <filesystem>
#include <optional>
#include <vector>

namespace perilymph::gui {

/// Names the recording that is being written, for as long as this object lives.
class RunMark {
public:
  /// Marks this process's run in a folder. What cannot be written is not marked: a crash is then
  /// not noticed, and nothing else is different.
  explicit RunMark(const std::filesystem::path& folder);
  ~RunMark();
  RunMark(const RunMark&) = delete;
  RunMark& operator=(const RunMark&) = delete;

  void setRecording(const std::optional<std::filesystem::path>& recording);

  /// The recordings of runs that ended without a word, those that are still there; their marks are
  /// removed. Marks of programs that still run stay.
  static std::vector<std::filesystem::path> takeInterrupted(const std::filesystem::path& folder);

private:
  std::filesystem::path file_;
};

}  // namespace perilymph::gui
