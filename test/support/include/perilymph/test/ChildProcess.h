// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Runs programs under test as child processes.

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace perilymph::test {

/// Program, arguments and environment of a call.
struct ProgramCall {
  std::string program;  ///< A path, or a name searched in PATH.
  std::vector<std::string> arguments;
  /// Variables to set or to unset (nullopt), in addition to this process's own.
  std::vector<std::pair<std::string, std::optional<std::string>>> environment;
  std::optional<std::filesystem::path> folder;  ///< Working folder; by default this process's own.
};

/// Result of a call.
struct ProgramOutcome {
  int status = -1;        ///< Exit status; -1 if it did not exit normally.
  int signal = 0;         ///< Signal that ended it; 0 if none.
  bool timedOut = false;  ///< It was killed after the timeout.
  std::string out;        ///< Standard output.
  std::string err;        ///< Standard error.
};

/// A running program and all its child processes. Its standard input is empty.
class ChildProcess {
public:
  /// @throws std::system_error if it cannot be started.
  explicit ChildProcess(const ProgramCall& call);
  ~ChildProcess();  ///< Kills it with all its child processes if still running.
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Waits until it has written `text` to standard output. False if it ended or timed out before.
  bool waitForOutput(const std::string& text, std::chrono::milliseconds timeout);
  /// Waits for its end; kills it with all its child processes after the timeout.
  ProgramOutcome wait(std::chrono::milliseconds timeout);
  /// Sends a signal, such as SIGKILL to simulate a power failure.
  void send(int signal);
  int id() const noexcept;

private:
  struct Content;
  std::unique_ptr<Content> content_;
};

/// Runs a program to its end.
ProgramOutcome run(const ProgramCall& call,
                   std::chrono::milliseconds timeout = std::chrono::minutes(2));

}  // namespace perilymph::test
