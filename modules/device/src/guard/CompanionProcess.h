// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// A second process of this program, started with files of its own: the guard of a device, the host
// of a plug-in.

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace perilymph::device {

/// A file descriptor with ownership.
class OwnedFile {
public:
  explicit OwnedFile(int file = -1) noexcept : file_(file) {}
  OwnedFile(OwnedFile&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  OwnedFile& operator=(OwnedFile&& other) noexcept
  {
    std::swap(file_, other.file_);
    return *this;
  }
  ~OwnedFile();

  int get() const noexcept { return file_; }

private:
  int file_;
};

/// Where the output of a companion goes.
enum class CompanionOutput {
  nowhere,        ///< To /dev/null.
  standardError,  ///< To the standard error of this program.
};

/// How a companion is started.
struct ChildCommand {
  std::filesystem::path program;
  std::vector<std::string> arguments;
  /// Descriptors here and there.
  std::vector<std::pair<int, int>> files;
  CompanionOutput output = CompanionOutput::nowhere;
};

/// Path of a companion program: beside this program, where packages install it, or in the build
/// tree. Empty if it is in none of these places.
std::filesystem::path companionProgram(const char* name);

/// Starts a companion in a session of its own, so that it does not receive the signals of a
/// terminal's process group. 0 if that fails.
pid_t startCompanion(const ChildCommand& call);

/// Writes one letter into a pipe to a companion; false, and no SIGPIPE, if it is gone.
bool say(const OwnedFile& pipe, std::uint8_t letter) noexcept;

/// Waits until a process has ended, at most `patience_ms`, then kills it.
void endCompanion(pid_t id, int patience_ms) noexcept;

}  // namespace perilymph::device
