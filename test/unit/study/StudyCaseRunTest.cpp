// SPDX-License-Identifier: BSD-3-Clause

// One insertion of a finished study, run again from its file, seed and number.

#include "perilymph/study/StudyCaseRun.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <stop_token>

#include "perilymph/session/RecordedInsertion.h"
#include "perilymph/session/Replay.h"
#include "perilymph/study/StudyRun.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class AnInsertionOfAStudy : public testing::Test {
protected:
  /// A study in the mean cochlea, a virtual one and a patient's, of short coarse insertions.
  AnInsertionOfAStudy()
  {
    std::ofstream(folder_ / "P-017.toml") << "label = \"P-017\"\na_mm = 8.84\nb_mm = 6.98\n";
    const auto study = parseStudy(R"(
title = "Short"
scenario = "mean-flex28"
depth = "scenario"
[cochleae]
mean = true
virtual = 1
patients = ["P-017.toml"]
[vary]
nodes = [30]
dt_ms = [5.0]
stop_travel_mm = [3.0]
[ranges]
speed_mm_s = [3.0, 5.0]
)",
                                  folder_ / "study.toml");
    if (!study) throw std::runtime_error(study.error().message);
    const auto ran = runShard(*study, shardOf(study->size(), 1, 1), folder_ / "out", 1, {});
    if (!ran) throw std::runtime_error(ran.error().message);
    if (const auto merged = mergeShards(folder_ / "out"); !merged)
      throw std::runtime_error(merged.error().message);
    // files that the study names lie beside its result
    fs::copy(folder_ / "P-017.toml", folder_ / "out" / "P-017.toml");
  }

  fs::path file() const { return folder_ / "out" / mergedFile; }
  std::vector<StudyResult> results() const
  {
    std::vector<StudyResult> all;
    const auto opened = StudyFile::open(file());
    EXPECT_TRUE(opened);
    EXPECT_TRUE(opened->read([&all](const StudyResult& result) -> Result<void> {
      all.push_back(result);
      return {};
    }));
    return all;
  }

  const test::TemporaryFolder folder_;
};

TEST_F(AnInsertionOfAStudy, GivesTheSameNumbersWhenItIsRunAgain)
{
  const auto opened = StudyFile::open(file());
  ASSERT_TRUE(opened);
  const auto study = studyIn(opened->facts(), file());
  ASSERT_TRUE(study) << study.error().message;
  for (const StudyResult& before : results()) {
    const fs::path recording = folder_ / ("again-" + std::to_string(before.number) + ".insertion");
    const auto again = recordCase(*study, before.number, recording, {});
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->insertion.end, before.insertion.end) << before.cochlea;
    EXPECT_EQ(again->insertion.ticks, before.insertion.ticks) << before.cochlea;
    // a virtual cochlea's A and B may differ by rounding to a decimal number
    const double peak = before.insertion.peak.force.si();
    EXPECT_NEAR(again->insertion.peak.force.si(), peak, 1e-9 * peak) << before.cochlea;
    EXPECT_NEAR(inDegrees(again->insertion.apical), inDegrees(before.insertion.apical), 1e-6);
  }
}

TEST_F(AnInsertionOfAStudy, IsRecordedSoThatItsReplayHasTheSameBits)
{
  const auto opened = StudyFile::open(file());
  ASSERT_TRUE(opened);
  const auto study = studyIn(opened->facts(), file());
  ASSERT_TRUE(study);
  const fs::path recording = folder_ / "again.insertion";
  const auto scenario = study->scenarioOf(study->caseAt(1));
  ASSERT_TRUE(scenario);
  EXPECT_EQ(scenario->patient().label, "Simulated cochlea 1");
  const auto again = recordCase(*study, 1, recording, {});  // in the virtual cochlea
  ASSERT_TRUE(again) << again.error().message;
  const auto verified = session::verify(recording);
  ASSERT_TRUE(verified) << verified.error().message;
  EXPECT_TRUE(verified->isIdentical);
}

TEST_F(AnInsertionOfAStudy, IsRefusedIfAFileThatTheStudyNamesWasChanged)
{
  const auto opened = StudyFile::open(file());
  ASSERT_TRUE(opened);
  std::ofstream(folder_ / "out" / "P-017.toml") << "label = \"P-017\"\na_mm = 9.0\nb_mm = 6.98\n";
  const auto changed = studyIn(opened->facts(), file());
  ASSERT_FALSE(changed);
  EXPECT_THAT(changed.error().message, HasSubstr("differ"));
  fs::remove(folder_ / "out" / "P-017.toml");
  const auto missing = studyIn(opened->facts(), file());
  ASSERT_FALSE(missing);
  EXPECT_THAT(missing.error().message, HasSubstr("beside it"));
}

TEST_F(AnInsertionOfAStudy, ThatTheStudyDoesNotHaveIsRefused)
{
  const auto opened = StudyFile::open(file());
  ASSERT_TRUE(opened);
  const auto study = studyIn(opened->facts(), file());
  ASSERT_TRUE(study);
  const auto again = recordCase(*study, 3, folder_ / "no.insertion", {});
  ASSERT_FALSE(again);
  EXPECT_THAT(again.error().message, HasSubstr("Insertion 3 is not in the study"));
  EXPECT_FALSE(fs::exists(folder_ / "no.insertion"));
}

}  // namespace
}  // namespace perilymph::study
