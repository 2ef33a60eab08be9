// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Input for code that reads a file: a file in a temporary folder.

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <system_error>

#include "FuzzTarget.h"

namespace perilymph::fuzz {

class InputFile {
public:
  /// @param name  File name with the extension that the tested code expects.
  explicit InputFile(const std::string& name)
  {
    // In memory where possible: the disk is not tested.
    std::error_code none;
    const std::filesystem::path memory = "/dev/shm";
    const bool hasMemory =
        std::filesystem::is_directory(memory, none) && ::access(memory.c_str(), W_OK) == 0;
    const auto parent = hasMemory ? memory : std::filesystem::temp_directory_path();
    std::string pattern = (parent / "perilymph-fuzz-XXXXXX").string();
    if (::mkdtemp(pattern.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(), pattern);
    folder_ = pattern;
    file_ = folder_ / name;
  }
  ~InputFile()
  {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  /// Writes the file with this content and removes all others.
  const std::filesystem::path& holding(std::span<const std::uint8_t> content)
  {
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      if (entry.path() != file_) std::filesystem::remove_all(entry.path());
    std::ofstream stream(file_, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char*>(content.data()),
                 static_cast<std::streamsize>(content.size()));
    return file_;
  }

  /// Other files in the folder, left by the tested code.
  int strangers() const
  {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder_))
      count += entry.path() != file_ ? 1 : 0;
    return count;
  }

  const std::filesystem::path& folder() const { return folder_; }

private:
  std::filesystem::path folder_, file_;
};

}  // namespace perilymph::fuzz
