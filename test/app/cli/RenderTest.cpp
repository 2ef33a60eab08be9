// SPDX-License-Identifier: BSD-3-Clause
#include <signal.h>
#include <unistd.h>

#include <cctype>

#include "perilymph/test/Cli.h"
#include "perilymph/test/waitUntil.h"

namespace perilymph::test {
namespace {

TEST(RenderCommand, DrawsAPictureOrSaysWhyNotAndLeavesNothingHalfWritten)
{
  const TemporaryFolder folder;
  const auto outcome = cli(
      {"render", "--scenario", "contour-published", "--at-mm", "0.5", "--out", folder / "a.png"});
  if (outcome.status == 0) {
    EXPECT_EQ(contentOf(folder / "a.png").substr(1, 3), "PNG");
  } else {
    expectRefusal(outcome, "");
    EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{});
  }
}

/// Width and height of a PNG file, from its first chunk.
std::pair<unsigned, unsigned> sizeOf(const std::string& png)
{
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i)
      value = 256 * value + static_cast<unsigned char>(png.at(i));
    return value;
  };
  return {number(16), number(20)};
}

TEST(RenderCommand, UnrollsTheScalaWithoutADisplay)
{
  const TemporaryFolder folder;
  const auto alone =
      cli({"render", "--preset", "published", "--view", "unrolled", "--out", folder / "alone.png"});
  if (isRefusedWithoutVtk(alone)) GTEST_SKIP() << "this build has no VTK";
  ASSERT_EQ(alone.status, 0) << alone.err;
  const auto inserted = cli({"render", "--scenario", "contour-published", "--at-mm", "3.0",
                             "--view", "unrolled", "--out", folder / "inserted.png"});
  ASSERT_EQ(inserted.status, 0) << inserted.err;
  EXPECT_EQ(sizeOf(contentOf(folder / "alone.png")), std::pair(1440u, 960u));
  EXPECT_NE(contentOf(folder / "alone.png"), contentOf(folder / "inserted.png"));
}

/// The process of a program whose parent is given; 0 if there is none.
int childOf(int parent, const std::string& program)
{
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    if (std::isdigit(entry.path().filename().string().front()) == 0) continue;
    // "1234 (Xvfb) S 1200 ..."
    const std::string state = contentOf(entry.path() / "stat");
    const std::size_t name = state.find("(" + program + ") ");
    if (name == std::string::npos) continue;
    if (std::stoi(state.substr(name + program.size() + 5)) == parent)
      return std::stoi(entry.path().filename().string());
  }
  return 0;
}

/// Whether a process runs; one that ended and that nobody waited for does not.
bool isRunning(int process)
{
  const std::string state = contentOf("/proc/" + std::to_string(process) + "/stat");
  return !state.empty() && state.find(") Z ") == std::string::npos;
}

/// Whether a process has connected to another.
bool hasSocket(int process)
{
  std::error_code ended;
  for (const auto& file :
       std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/fd", ended))
    if (std::filesystem::read_symlink(file, ended).string().starts_with("socket:")) return true;
  return false;
}

TEST(RenderCommand, LeavesNoDisplayBehindWhenItIsKilled)
{
  if (!PERILYMPH_HAS_VTK) GTEST_SKIP() << "this build has no VTK";
  const TemporaryFolder folder;
  ProgramCall call = cliCall({"render", "--preset", "published", "--out", folder / "a.png"});
  call.environment = {{"DISPLAY", std::nullopt}};
  ChildProcess program(call);
  int server = 0;
  ASSERT_TRUE(waitUntil([&] {
    server = childOf(program.id(), "Xvfb");
    return server != 0 && hasSocket(program.id());
  }));
  ::kill(program.id(), SIGKILL);
  EXPECT_TRUE(waitUntil([&] { return !isRunning(server); })) << "Xvfb " << server;
}

TEST(RenderCommand, NamesTheViewsThereAre)
{
  expectUsageError(cli({"render", "--preset", "published", "--view", "sideways", "--out", "x.png"}),
                   "unrolled");
}

TEST(RenderCommand, RefusesAnArrayAndATravelWithoutAScenario)
{
  expectUsageError(cli({"render", "--preset", "published", "--at-mm", "3", "--out", "x.png"}),
                   "--scenario");
}

}  // namespace
}  // namespace perilymph::test
