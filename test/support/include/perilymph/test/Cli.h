// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Runs perilymph-cli as a child process.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "perilymph/foundation/Version.h"
#include "perilymph/test/ChildProcess.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {

inline ProgramCall cliCall(std::vector<std::string> arguments)
{
  return {programFolder() / "perilymph-cli", std::move(arguments), {}, {}};
}

inline ProgramOutcome cli(std::vector<std::string> arguments)
{
  return run(cliCall(std::move(arguments)));
}

/// A call that may make a plan of fewer simulations than users are offered: tests are cheap.
inline ProgramCall fewDrawsCall(std::vector<std::string> arguments)
{
  ProgramCall call = cliCall(std::move(arguments));
  call.environment.emplace_back(fewDraws, "1");
  return call;
}

/// The arguments of a short simulation.
inline std::vector<std::string> shortSimulation(std::vector<std::string> more = {})
{
  std::vector<std::string> arguments = {"simulate", "--scenario", "contour-published", "--nodes",
                                        "30",       "--set",      "stop_travel_mm=0.5"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

inline std::string contentOf(const std::filesystem::path& file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

inline std::vector<std::string> linesOf(const std::filesystem::path& file)
{
  std::ifstream stream(file);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Names in a folder, hidden ones included.
inline std::vector<std::string> namesIn(const std::filesystem::path& folder)
{
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

/// Failure: status 1, nothing on standard output, one line on standard error.
inline void expectRefusal(const ProgramOutcome& outcome, const std::string& says)
{
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err, testing::HasSubstr(says));
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
}

/// Whether the command draws or reads a surface, which this build refuses for want of VTK.
inline bool lacksVtkFor(const std::vector<std::string>& arguments)
{
  return !PERILYMPH_HAS_VTK &&
         (arguments[0] == "render" ||
          std::find(arguments.begin(), arguments.end(), "--import") != arguments.end());
}

/// Whether the command was refused because this build has no VTK.
inline bool isRefusedWithoutVtk(const ProgramOutcome& outcome)
{
  if (PERILYMPH_HAS_VTK) return false;
  expectRefusal(outcome, "has no VTK");
  return true;
}

/// Usage error: status 2.
inline void expectUsageError(const ProgramOutcome& outcome, const std::string& says)
{
  EXPECT_EQ(outcome.status, 2) << outcome.err;
  EXPECT_THAT(outcome.err, testing::HasSubstr(says));
}

}  // namespace perilymph::test
