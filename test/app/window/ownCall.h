// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The program as a process of its own.

#include <string>
#include <utility>
#include <vector>

#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

/// A call of the program that keeps its data, settings and state in `folder`, each in a folder below it
/// that is named as the variable of its environment.
inline ProgramCall ownCall(const TemporaryFolder& folder, std::vector<std::string> arguments)
{
  ProgramCall call;
  call.program = programFolder() / "perilymph";
  call.arguments = std::move(arguments);
  for (const char* name : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_STATE_HOME"})
    call.environment.emplace_back(name, (folder / name).string());
  return call;
}

}  // namespace perilymph::test
