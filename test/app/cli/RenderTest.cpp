// SPDX-License-Identifier: BSD-3-Clause
#include "Cli.h"

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
