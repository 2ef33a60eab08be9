// SPDX-License-Identifier: BSD-3-Clause

// Recordings by an earlier build, one per shipped scenario and model, replay to the same bits.

#include <gmock/gmock.h>

#include <array>
#include <filesystem>
#include <vector>

#include "ShortRun.h"
#include "lanes/Lanes.h"
#include "perilymph/session/Replay.h"
#include "perilymph/test/Places.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::session {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> storedRecordings()
{
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(test::testData() / "recordings"))
    if (entry.path().extension() == ".insertion") files.push_back(entry.path());
  return files;
}

TEST(StoredRecordings, CoverEveryShippedScenarioWithBothModels)
{
  std::vector<std::string> names;
  for (const fs::path& file : storedRecordings()) names.push_back(file.stem().string());
  EXPECT_THAT(names, testing::UnorderedElementsAre(
                         "contour-published-rod", "contour-published-points", "mean-contour-rod",
                         "mean-contour-points", "mean-flex28-rod", "mean-flex28-points",
                         // since the published experiment has a passage
                         "contour-published-rod-passage",
                         // before the mean cochlea had bone
                         "mean-contour-rod-published-wall", "mean-flex28-rod-published-wall"));
}

/// With the instructions that the kernels of the tick are compiled for.
class StoredRecordingsOnMachines : public testing::TestWithParam<mechanics::Instructions> {
protected:
  StoredRecordingsOnMachines() : before_(mechanics::kernelInstructions)
  {
    mechanics::kernelInstructions = GetParam();
  }
  ~StoredRecordingsOnMachines() override { mechanics::kernelInstructions = before_; }

private:
  mechanics::Instructions before_;
};

TEST_P(StoredRecordingsOnMachines, ReplayToTheSameBits)
{
  if (GetParam() > mechanics::machineInstructions())
    GTEST_SKIP() << "This machine does not have these instructions.";
  for (const fs::path& file : storedRecordings()) {
    const auto verification = verify(file);
    ASSERT_TRUE(verification) << verification.error().message;
    EXPECT_TRUE(verification->isIdentical) << file;
    EXPECT_GE(verification->ticksCompared, 201u) << file;  // 10 mm at 10 mm/s in steps of 5 ms
  }
}

// The stored ones are of arrays that neither relax nor yield.
TEST_P(StoredRecordingsOnMachines, AndAnInsertionThatRelaxesAndYieldsHaveTheSameBits)
{
  if (GetParam() > mechanics::machineInstructions())
    GTEST_SKIP() << "This machine does not have these instructions.";
  const test::TemporaryFolder folder;
  const fs::path file = folder / "run.insertion";
  const mechanics::Instructions ofTheTest = mechanics::kernelInstructions;
  mechanics::kernelInstructions = mechanics::machineInstructions();
  Overrides overrides = test::yieldingArray;
  overrides.insert(overrides.end(), {{"relaxation_fraction", "[0.13, 0.28]"},
                                     {"relaxation_time_s", "[0.03, 0.6]"},
                                     {"film_relaxation_fraction", "0.4"},
                                     {"film_relaxation_time_s", "0.1"},
                                     {"nodes", "61"},
                                     {"speed_mm_s", "5"},
                                     {"stop_travel_mm", "8"}});
  double work = 0.0;
  ASSERT_TRUE(test::shortRun(file, overrides)->runToEnd([&](const haptics::TickRecord& record) {
    work = record.output.plasticWork;
    return true;
  }));
  EXPECT_GT(work, 0.0);
  mechanics::kernelInstructions = ofTheTest;
  const auto verification = verify(file);
  ASSERT_TRUE(verification) << verification.error().message;
  EXPECT_TRUE(verification->isIdentical);
}

constexpr std::array names{"WithSse2", "WithAvx2", "WithAvx512"};
INSTANTIATE_TEST_SUITE_P(, StoredRecordingsOnMachines,
                         testing::Values(mechanics::Instructions::everywhere,
                                         mechanics::Instructions::avx2,
                                         mechanics::Instructions::avx512),
                         [](const auto& one) {
                           return names.at(static_cast<std::size_t>(one.param));
                         });

TEST(StoredRecordings, AreOfTheModelThatIsBuiltTodayUnlessTheFileOfTheirArrayWasChanged)
{
  int unchanged = 0;
  for (const fs::path& file : storedRecordings()) {
    const auto verification = verify(file);
    ASSERT_TRUE(verification) << verification.error().message;
    const auto says = [&](const char* part) {
      return testing::Value(verification->notes, testing::Contains(testing::HasSubstr(part)));
    };
    const bool isOfAnotherArray = says("has changed since the recording");
    if (isOfAnotherArray) continue;
    EXPECT_FALSE(says("differs from the recorded model")) << file;
    ++unchanged;
  }
  EXPECT_GT(unchanged, 0);
}

}  // namespace
}  // namespace perilymph::session
