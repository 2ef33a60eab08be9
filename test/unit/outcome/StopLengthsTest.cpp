// SPDX-License-Identifier: BSD-3-Clause
#include "StopLengths.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "perilymph/database/Database.h"
#include "perilymph/foundation/FileLock.h"
#include "perilymph/foundation/Seal.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/planning/Plan.h"
#include "perilymph/planning/ResistanceGrid.h"
#include "perilymph/session/InsertionTable.h"
#include "perilymph/test/SyntheticPlan.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

planning::PlanRequest smallRequest()
{
  planning::PlanRequest request;
  request.patient = measuredPatient();
  request.arrays = {"flex28", "flex24"};
  request.resolution = planning::Resolution{30, milliseconds(10)};
  request.draws = 3;
  return request;
}

TEST(StopLengths, AreThoseOfThePlansSimulationsAndKeptBesideIt)
{
  const TemporaryFolder folder;
  const planning::PlanRequest request = smallRequest();
  const auto plan = planning::makePlan(request, {}, {});
  ASSERT_TRUE(plan) << plan.error().message;
  std::size_t computed = 0;
  const auto count = [&](std::size_t, std::size_t) { ++computed; };
  const auto lengths = outcome::stopLengths(request, 0, folder.path(), count);
  ASSERT_TRUE(lengths) << lengths.error().message;
  ASSERT_EQ(lengths->draws.size(), 3u);
  EXPECT_GT(computed, 0u);
  for (const planning::UnstoppedDraw& each : lengths->draws) {
    const auto& planned = plan->insertions[2 * (each.draw - 1)];
    ASSERT_EQ(planned.draw, each.draw);
    ASSERT_EQ(planned.array, 0u);
    EXPECT_DOUBLE_EQ(each.friction, planned.friction);
    EXPECT_DOUBLE_EQ(inMillinewtons(each.stop), planned.stop_mN);
    EXPECT_DOUBLE_EQ(inMillimeters(each.intended), planned.intended_mm);
    if (planned.insertion.end != haptics::InsertionEnd::stoppedByResistance) continue;
    // the same push: where it was stopped, but for the rest, in which the tip goes on by some 0.1 mm
    const auto length = each.curve.lengthAt(each.stop);
    ASSERT_TRUE(length) << each.draw;
    EXPECT_NEAR(inMillimeters(*length), inMillimeters(planned.insertion.depth), 0.4) << each.draw;
  }
  // a second call computes nothing and gives the same bits
  computed = 0;
  const auto again = outcome::stopLengths(request, 0, folder.path(), count);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(computed, 0u);
  for (std::size_t i = 0; i < lengths->draws.size(); ++i) {
    ASSERT_EQ(again->draws[i].curve.rises.size(), (lengths->draws)[i].curve.rises.size());
    EXPECT_EQ(again->draws[i].curve.rises.back().force,
              (lengths->draws)[i].curve.rises.back().force);
    EXPECT_EQ(again->draws[i].curve.depth, (lengths->draws)[i].curve.depth);
    EXPECT_EQ(again->draws[i].curve.end, (lengths->draws)[i].curve.end);
  }
  // one more simulation is added to those that are there
  planning::PlanRequest longer = request;
  longer.draws = 4;
  const auto more = outcome::stopLengths(longer, 0, folder.path());
  ASSERT_TRUE(more) << more.error().message;
  EXPECT_EQ(more->draws.size(), 4u);
  EXPECT_FALSE(more->isRenewed);
}

/// SQLite keeps the application's number from byte 68 on; a file manager tells studies by it ("PeSt").
TEST(StopLengths, AreInAFileThatIsNoStudyAndReadFromFormerOnes)
{
  const TemporaryFolder folder;
  planning::PlanRequest request = smallRequest();
  request.draws = 1;
  const auto first = outcome::stopLengths(request, 0, folder.path());
  ASSERT_TRUE(first) << first.error().message;
  const fs::path file = folder.path() / outcome::stopLengthsFile(0);
  std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
  std::string number(4, '\0');
  bytes.seekg(68).read(number.data(), 4);
  EXPECT_EQ(number, "PeSL");
  bytes.seekp(68).write("PeSt", 4);
  bytes.close();
  std::size_t computed = 0;
  const auto former = outcome::stopLengths(request, 0, folder.path(),
                                           [&](std::size_t, std::size_t) { ++computed; });
  ASSERT_TRUE(former) << former.error().message;
  EXPECT_EQ(computed, 0u);
  EXPECT_EQ(former->draws.front().curve.depth, first->draws.front().curve.depth);
}

/// Whatever is in the file, the stop lengths are those of this plan and build.
TEST(StopLengths, AreComputedAgainIfTheirFileCannotBeContinued)
{
  const TemporaryFolder folder;
  planning::PlanRequest request = smallRequest();
  request.draws = 1;
  const fs::path file = folder.path() / outcome::stopLengthsFile(0);
  const auto first = outcome::stopLengths(request, 0, folder.path());
  ASSERT_TRUE(first) << first.error().message;
  const fs::path kept = folder.path() / "kept";
  fs::copy(file, kept);
  const auto inFile = [&](const std::string& sql) {
    auto database = database::Database::openNew(file);
    ASSERT_TRUE(database);
    const auto done = database->run(sql);
    ASSERT_TRUE(done) << done.error().message;
  };
  const std::vector<std::pair<const char*, std::function<void()>>> faults{
      {"another build",
       [&] {
         auto database = database::Database::openNew(file);
         ASSERT_TRUE(database);
         auto plan = database->prepare("SELECT value FROM meta WHERE key = 'fingerprint'");
         ASSERT_TRUE(plan);
         ASSERT_EQ(plan->step(), database::Statement::Step::row);
         const SealedFacts facts{{session::fingerprintFact, plan->text(0)},
                                 {session::programFact, "0.1.0+another"}};
         plan->reset();
         const auto done = database->run(
             "DELETE FROM insertion; UPDATE meta SET value = '0.1.0+another' WHERE key = "
             "'program'; "
             "UPDATE meta SET value = '" +
             sealOver(facts, Sha256()) + "' WHERE key = '" + sealKey + "'");
         ASSERT_TRUE(done) << done.error().message;
       }},
      {"another plan",
       [&] {
         planning::PlanRequest other = request;
         other.seed = 2;
         fs::remove(file);
         ASSERT_TRUE(outcome::stopLengths(other, 0, folder.path()));
       }},
      {"changed", [&] { inFile("UPDATE insertion SET content = replace(content, '1', '2')"); }},
      {"a missing table", [&] { inFile("DROP TABLE insertion"); }},
      {"truncated", [&] { fs::resize_file(file, fs::file_size(file) / 2); }},
      {"empty", [&] { fs::resize_file(file, 0); }},
      {"no database", [&] { std::ofstream(file, std::ios::trunc) << "no table"; }},
  };
  for (const auto& [what, make] : faults) {
    SCOPED_TRACE(what);
    fs::copy_file(kept, file, fs::copy_options::overwrite_existing);
    make();
    const auto again = outcome::stopLengths(request, 0, folder.path());
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_TRUE(again->isRenewed);
    ASSERT_EQ(again->draws.size(), first->draws.size());
    for (std::size_t i = 0; i < again->draws.size(); ++i) {
      EXPECT_EQ(again->draws[i].curve.depth, first->draws[i].curve.depth);
      EXPECT_EQ(again->draws[i].curve.rises.size(), first->draws[i].curve.rises.size());
    }
    std::size_t computed = 0;
    const auto third = outcome::stopLengths(request, 0, folder.path(),
                                            [&](std::size_t, std::size_t) { ++computed; });
    ASSERT_TRUE(third) << third.error().message;
    EXPECT_FALSE(third->isRenewed);
    EXPECT_EQ(computed, 0u);
  }
  // nothing but the file is left
  for (const fs::directory_entry& each : fs::directory_iterator(folder.path()))
    EXPECT_TRUE(each.path() == file || each.path() == kept) << each.path();
}

TEST(StopLengths, AreComputedOnceByTwoAtOnce)
{
  const TemporaryFolder folder;
  const planning::PlanRequest request = smallRequest();
  std::array<std::atomic<bool>, 2> computes{};
  std::array<std::optional<Result<outcome::KnownStops>>, 2> found;
  {
    std::array<std::jthread, 2> both;
    for (std::size_t i = 0; i < both.size(); ++i)
      both[i] = std::jthread([&, i] {
        found[i] =
            outcome::stopLengths(request, 0, folder.path(), [&](std::size_t done, std::size_t) {
              if (done > 0) computes[i] = true;
            });
      });
  }
  for (const auto& each : found) {
    ASSERT_TRUE(each && *each) << (*each).error().message;
    EXPECT_FALSE((**each).isRenewed);
    EXPECT_EQ((**each).draws.size(), request.draws);
  }
  EXPECT_EQ((**found[0]).draws[2].curve.depth, (**found[1]).draws[2].curve.depth);
  EXPECT_NE(computes[0], computes[1]);
}

TEST(StopLengths, EndTheirWaitingForAnotherProgramWhenTheyAreStopped)
{
  const TemporaryFolder folder;
  const auto held = FileLock::take(folder.path() / ".stops-1.lock", "it");
  ASSERT_TRUE(held);
  std::stop_source stop;
  stop.request_stop();
  const auto refused = outcome::stopLengths(smallRequest(), 0, folder.path(), {}, stop.get_token());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("in use"), std::string::npos);
}

TEST(StopLengths, AreNotBegunAgainWhileAnOlderProgramWorksOnThem)
{
  const TemporaryFolder folder;
  planning::PlanRequest request = smallRequest();
  request.draws = 1;
  ASSERT_TRUE(outcome::stopLengths(request, 0, folder.path()));
  const fs::path file = folder.path() / outcome::stopLengthsFile(0);
  auto held = database::Database::openNew(file);
  ASSERT_TRUE(held);
  ASSERT_TRUE(
      held->run("UPDATE meta SET value = 'another' WHERE key = 'program'; BEGIN IMMEDIATE"));
  const auto refused = outcome::stopLengths(request, 0, folder.path());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().message.find("in use"), std::string::npos);
  EXPECT_TRUE(fs::exists(file));
}

TEST(StopLengths, RefuseAnArrayThatThePlanHasNotALinkAndAFolder)
{
  const TemporaryFolder folder;
  const auto none = outcome::stopLengths(smallRequest(), 2, folder.path());
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "The plan has no array 3; it has 2. Choose one of them.");
  const fs::path file = folder.path() / outcome::stopLengthsFile(0),
                 other = folder.path() / "other";
  std::ofstream(other) << "kept";
  fs::create_symlink(other, file);
  EXPECT_FALSE(outcome::stopLengths(smallRequest(), 0, folder.path()));
  EXPECT_EQ(fs::file_size(other), 4u);
  EXPECT_TRUE(fs::is_symlink(file));
  fs::remove(file);
  fs::create_directory(file);
  EXPECT_FALSE(outcome::stopLengths(smallRequest(), 0, folder.path()));
  EXPECT_TRUE(fs::is_directory(file));
}

TEST(StopDraw, HasTheDepthAtTheShiftedLimit)
{
  planning::UnstoppedDraw draw;
  draw.friction = std::exp(0.25);
  draw.stop = millinewtons(50);
  draw.intended = millimeters(25);
  draw.curve.end = haptics::InsertionEnd::buckled;
  draw.curve.depth = millimeters(22);
  // one millimeter for each 4 mN
  for (int i = 0; i <= 22; ++i) draw.curve.rises.push_back({millimeters(i), millinewtons(4.0 * i)});
  const planning::StopDraw found = planning::stopDrawOf(draw);
  EXPECT_NEAR(found.logFriction, 0.25, 1e-12);
  constexpr std::size_t middle = (planning::stopShifts - 1) / 2;
  EXPECT_DOUBLE_EQ(found.stop_mm[middle], 13.0);  // 50 mN is reached at the point of 52
  EXPECT_DOUBLE_EQ(found.depth_mm(middle), 13.0);
  // e^0.75 50 mN = 105.9 mN is not reached before it buckles at 22 mm
  EXPECT_TRUE(std::isinf(found.stop_mm[planning::stopShifts - 1]));
  EXPECT_FALSE(found.isFull);
  EXPECT_DOUBLE_EQ(found.depth_mm(planning::stopShifts - 1), 22.0);
}

}  // namespace
}  // namespace perilymph::test
