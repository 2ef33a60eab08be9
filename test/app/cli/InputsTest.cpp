// SPDX-License-Identifier: BSD-3-Clause

// Inputs that would block a reader or are endless.

#include <sys/stat.h>

#include <chrono>

#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

/// Every call that reads a file, with `file` as the file.
std::vector<std::vector<std::string>> callsThatRead(const std::string& file)
{
  return {{"simulate", "--scenario", file},
          shortSimulation({"--patient", file}),
          shortSimulation({"--array", file}),
          shortSimulation({"--set", "patient=" + file}),
          shortSimulation({"--set", "friction=" + file}),
          shortSimulation({"--set", "calibration=" + file}),
          {"anatomy", "--patient", file},
          {"anatomy", "--import", file},
          {"render", "--scenario", file, "--out", "x.png"},
          {"render", "--patient", file, "--out", "x.png"},
          {"validate", "--variability", file, "--out", "x"},
          {"calibrate", "--variability", file, "--out", "x"},
          {"predict", "--array", file, "--out", "x"},
          {"predict", "--all", "--friction", file, "--out", "x"},
          {"replay", file},
          {"replay", file, "--verify"},
          {"compare", file, "--out", "x"},
          {"devices", "--replay", file},
          {"devices", "--plugin", file}};
}

void expectSentences(const std::string& file)
{
  const TemporaryFolder folder;
  for (const auto& arguments : callsThatRead(file)) {
    SCOPED_TRACE(testing::PrintToString(arguments));
    ProgramCall call = cliCall(arguments);
    call.folder = folder.path();
    const ProgramOutcome outcome = run(call, std::chrono::seconds(30));
    EXPECT_FALSE(outcome.timedOut);
    expectRefusal(outcome, lacksVtkFor(arguments) ? "has no VTK" : file);
  }
  EXPECT_THAT(namesIn(folder.path()), testing::IsEmpty());
}

TEST(AnInput, ThatIsAPipeWithoutAWriterIsAnsweredAtOnce)
{
  const TemporaryFolder folder;
  const std::string pipe = folder / "pipe.stl";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  expectSentences(pipe);
}

TEST(AnInput, ThatIsADeviceOrAFolderIsAnsweredAtOnce)
{
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "folder.stl");
  expectSentences(folder / "folder.stl");
  std::filesystem::create_symlink("/dev/zero", folder / "zero.stl");
  expectSentences(folder / "zero.stl");
}

TEST(AnInput, ThatIsFarTooLargeIsRefusedUnread)
{
  const TemporaryFolder folder;
  const std::string file = folder / "large.stl";
  std::ofstream(file).flush();
  std::filesystem::resize_file(file, std::uintmax_t{1} << 40);  // sparse: it needs no disk space
  expectSentences(file);
}

}  // namespace
}  // namespace perilymph::test
