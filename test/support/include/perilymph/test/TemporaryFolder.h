// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

namespace perilymph::test {

/// An empty folder, removed with its content at the end of the test.
class TemporaryFolder {
public:
  /// @throws std::system_error if no folder can be created.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const noexcept { return path_; }
  /// The path of a file or folder in it.
  std::filesystem::path operator/(const std::filesystem::path& name) const { return path_ / name; }

private:
  std::filesystem::path path_;
};

}  // namespace perilymph::test
