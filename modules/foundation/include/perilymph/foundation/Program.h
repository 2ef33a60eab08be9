// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Starts other programs. Arguments are a list; no shell reads them.

#include <sys/types.h>

#include <chrono>
#include <string>
#include <utility>
#include <vector>

#include "perilymph/foundation/Result.h"

namespace perilymph {

/// How a program is started.
struct ProgramCall {
  std::string program;                 ///< A path, or a name that is searched for in PATH.
  std::vector<std::string> arguments;  ///< Without the program's own name.
  /// Descriptors here and there. A descriptor that is not listed stays closed to the program if it
  /// is marked close-on-exec, as all of this project are, and is inherited otherwise.
  std::vector<std::pair<int, int>> files;
  /// A session of its own does not receive the signals of a terminal's process group.
  bool hasOwnSession = false;
};

/// What a program that ended has written.
struct ProgramAnswer {
  int status = -1;  ///< Exit status; -1 if a signal ended it.
  std::string output, errors;
};

/// Starts a program. The caller waits for its end. An error is the system's reason.
Result<pid_t> startProgram(const ProgramCall& call);

/// Runs a program without input to its end and returns what it wrote to standard output and, apart,
/// to standard error: at most 1 MiB of each. One that takes longer than `longest` is ended.
Result<ProgramAnswer> runProgram(const std::string& program,
                                 const std::vector<std::string>& arguments,
                                 std::chrono::milliseconds longest);

/// Lines that a program wrote, as one: without blank ones and control characters, joined by "; ".
std::string linesTogether(const std::string& text);

}  // namespace perilymph
