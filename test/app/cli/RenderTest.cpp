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

TEST(RenderCommand, RefusesAnArrayAndATravelWithoutAScenario)
{
  expectWrongWords(cli({"render", "--preset", "published", "--at-mm", "3", "--out", "x.png"}),
                   "--scenario");
}

}  // namespace
}  // namespace perilymph::test
