// SPDX-License-Identifier: BSD-3-Clause

// A plan.json read again.

#include "perilymph/planning/PlanReading.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "perilymph/foundation/Version.h"
#include "perilymph/planning/PlanReport.h"
#include "perilymph/planning/PlanWords.h"
#include "perilymph/test/SyntheticPlan.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::test {
namespace {

using testing::HasSubstr;

std::string writtenPlan()
{
  const auto json = planning::planJson(syntheticPlan(20));
  return json ? *json : std::string();
}

std::string with(std::string text, const std::string& part, const std::string& other)
{
  const auto found = text.find(part);
  EXPECT_NE(found, std::string::npos) << part;
  return text.replace(found, part.size(), other);
}

TEST(StoredPlan, GivesTheSameTextWhenItIsWrittenAgain)
{
  const std::string text = writtenPlan();
  const auto stored = planning::planIn(text, "plan.json");
  ASSERT_TRUE(stored) << stored.error().message;
  const auto again = planning::planJson(stored->plan);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(*again, text);
  EXPECT_EQ(stored->limits, planning::limitsOfPlans());
  EXPECT_FALSE(stored->sources.empty());
  EXPECT_THAT(stored->program, HasSubstr("Perilymph "));
}

TEST(StoredPlan, KeepsTheCorrelationsOfTheMeasures)
{
  planning::Plan plan = syntheticPlan(20);
  plan.request.patient.errors->ah = -0.375;
  const auto json = planning::planJson(plan);
  ASSERT_TRUE(json) << json.error().message;
  const auto stored = planning::planIn(*json, "plan.json");
  ASSERT_TRUE(stored) << stored.error().message;
  EXPECT_EQ(stored->plan.request.patient.errors->ah, -0.375);
  EXPECT_EQ(stored->plan.request.patient.errors->ab, 0.0);
}

TEST(StoredPlan, KeepsItsFriction)
{
  planning::Plan plan = syntheticPlan(20);
  for (const std::optional<std::string>& friction : {std::optional<std::string>(), {"tissue"}}) {
    plan.request.friction = friction;
    const auto json = planning::planJson(plan);
    ASSERT_TRUE(json) << json.error().message;
    const auto stored = planning::planIn(*json, "plan.json");
    ASSERT_TRUE(stored) << stored.error().message;
    EXPECT_EQ(stored->plan.request.friction, friction);
  }
}

TEST(StoredPlan, KeepsItsApproach)
{
  planning::Plan plan = syntheticPlan(20);
  plan.request.approach = anatomy::Approach{degrees(2.41), degrees(-7.3)};
  const auto json = planning::planJson(plan);
  ASSERT_TRUE(json) << json.error().message;
  const auto stored = planning::planIn(*json, "plan.json");
  ASSERT_TRUE(stored) << stored.error().message;
  ASSERT_TRUE(stored->plan.request.approach);
  EXPECT_NEAR(inDegrees(stored->plan.request.approach->tilt), 2.41, 1e-6);
  EXPECT_NEAR(inDegrees(stored->plan.request.approach->turn), -7.3, 1e-6);
}

TEST(StoredPlan, KeepsWhatItsBandsHoldFixed)
{
  planning::Plan plan = syntheticPlan(20);
  plan.friction = {0.24, 0.59};
  const auto json = planning::planJson(plan);
  ASSERT_TRUE(json) << json.error().message;
  const auto stored = planning::planIn(*json, "plan.json");
  ASSERT_TRUE(stored) << stored.error().message;
  EXPECT_EQ(planning::bandsHold(stored->plan),
            "5 to 95 % of 20 simulations at friction 0.24 to 0.59");
  EXPECT_FALSE(planning::planIn(with(*json, "0.59\n", "59\n"), "plan.json"));
  EXPECT_FALSE(planning::planIn(with(*json, "0.59\n", "\"0.59\"\n"), "plan.json"));
}

TEST(StoredPlan, KeepsTheSpreadOfItsFriction)
{
  planning::Plan plan = syntheticPlan(20);
  plan.friction = {0.165, 0.165};
  plan.frictionSpread = 0.3465;
  const auto json = planning::planJson(plan);
  ASSERT_TRUE(json) << json.error().message;
  const auto stored = planning::planIn(*json, "plan.json");
  ASSERT_TRUE(stored) << stored.error().message;
  EXPECT_EQ(planning::bandsHold(stored->plan),
            "5 to 95 % of 20 simulations over friction 0.08 to 0.33");
  EXPECT_FALSE(planning::planIn(with(*json, "0.3465", "34.65"), "plan.json"));
}

TEST(StoredPlan, OfAFormerVersionKeepsItsFrictionAndItsSentence)
{
  // as plans stated it whose default was 0.12
  const std::string former =
      "No friction in a living ear is known. The default, 0.12, is the low end of what is reported "
      "for arrays on endosteum, chosen with the depths in view that clinics report: four of five "
      "straight arrays come within 20 degrees of them, FLEXSOFT stops 80 short. With the friction "
      "of a tissue simulant straight arrays stop at 240 to 350.";
  const auto json = planning::planJson(syntheticPlan(20));
  ASSERT_TRUE(json) << json.error().message;
  const Sentence& now = planning::limitsOfPlans()[3];
  const auto stored = planning::planIn(with(*json, now, former), "plan.json");
  ASSERT_TRUE(stored) << stored.error().message;
  EXPECT_EQ(planning::bandsHold(stored->plan), "5 to 95 % of 20 simulations at friction 0.12");
  EXPECT_EQ(stored->limits[3], former);
  EXPECT_EQ(stored->limits[3].values().size(), 5u);  // recognized, so that it can be translated
}

TEST(StoredPlan, OfFormat2IsReadByTheFormerNameOfAProbability)
{
  std::string former = with(writtenPlan(), "\"format\": 3", "\"format\": 2");
  const std::string now = "\"intended_depth_reached\"";
  for (auto at = former.find(now); at != std::string::npos; at = former.find(now))
    former.replace(at, now.size(), "\"full_insertion\"");
  const auto stored = planning::planIn(former, "plan.json");
  ASSERT_TRUE(stored) << stored.error().message;
  const auto current = planning::planIn(writtenPlan(), "plan.json");
  ASSERT_TRUE(current) << current.error().message;
  EXPECT_GT(current->plan.arrays[0].full.high, 0.0);
  EXPECT_EQ(stored->plan.arrays[0].full.value, current->plan.arrays[0].full.value);
  EXPECT_EQ(stored->plan.arrays[0].full.high, current->plan.arrays[0].full.high);
  // its own seal does not hold for the text that was changed here
  EXPECT_EQ(stored->plan.seal, Seal::changed);
}

TEST(StoredPlan, OfAVersionWithoutForcesAtRestIsReadWithoutThem)
{
  std::string former = writtenPlan();
  for (const char* key : {"\"friction_range\"", "\"force_after_1s_mN\"", "\"force_after_10s_mN\""})
    for (auto at = former.find(key); at != std::string::npos; at = former.find(key))
      former.replace(at + 1, 1, "F");
  const auto stored = planning::planIn(former, "plan.json");
  ASSERT_TRUE(stored) << stored.error().message;
  EXPECT_EQ(stored->plan.arrays[0].after1s_mN.high, 0.0);
  EXPECT_GT(stored->plan.arrays[0].end_mN.high, 0.0);
  EXPECT_EQ(planning::bandsHold(stored->plan), "5 to 95 % of 20 simulations at one friction");
}

TEST(StoredPlan, IsFoundInItsFolderAndBesideItsDraws)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "plan.json") << writtenPlan();
  for (const auto& place : {folder.path(), folder / "plan.json", folder / "draws.sqlite"})
    EXPECT_TRUE(planning::readPlan(place)) << place;
}

TEST(StoredPlan, IsNotFoundWhereAPlanWasInterrupted)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "draws.sqlite") << "draws";
  const auto stored = planning::readPlan(folder.path());
  ASSERT_FALSE(stored);
  EXPECT_THAT(stored.error().message, HasSubstr("was not finished"));
}

TEST(StoredPlan, RefusesTextsThatAreNoPlanInOneSentence)
{
  const std::string good = writtenPlan();
  const std::pair<std::string, const char*> texts[] = {
      {"", "not JSON"},
      {"[1, 2]", "is missing"},
      {good.substr(0, good.size() / 2), "not JSON"},
      {with(good, "\"A_mm\": 9.2", "\"A_mm\": \"9.2\""), "A_mm is not a number"},
      {with(good, "\"A_mm\": 9.2", "\"A_mm\": 92"), "A_mm is 92; 5 to 13 is possible"},
      {with(good, "\"A_mm\": 9.2", "\"A_mm\": 12.9"), "not possible"},
      {with(good, "\"A_mm\": 9.2", "\"A_mm\": 1e300"), "A_mm is 1e+300"},
      {with(good, "\"format\": 3", "\"format\": 4"), "newer program"},
      {with(good, "\"p5\": 3", "\"p5\": 9"), "quantiles that decrease"},
      {with(good, "\"value\": 0", "\"value\": 7"), "0 to 1 is possible"},
      {with(good, "\"value\": 0.", "\"value\": 0.0"), "not a probability"},
      {with(good, "\"draws\": 20", "\"draws\": -20"), "draws is not a whole number"}};
  for (const auto& [text, reason] : texts) {
    const auto stored = planning::planIn(text, "plan.json");
    ASSERT_FALSE(stored) << reason;
    EXPECT_THAT(stored.error().message, HasSubstr(reason));
    EXPECT_THAT(stored.error().message, HasSubstr("plan.json is"));
  }
}

TEST(StoredPlan, WithASideThatIsNoneIsRefused)
{
  const std::string good = writtenPlan();
  for (const char* side : {"lefs", "Left", "both", "", " left", "RIGHT", "ri\\nght", "links"}) {
    const auto stored = planning::planIn(
        with(good, "\"side\": \"right\"", "\"side\": \"" + std::string(side) + "\""), "plan.json");
    ASSERT_FALSE(stored) << side;
    EXPECT_THAT(stored.error().message, HasSubstr("it must be right or left"));
  }
  EXPECT_FALSE(planning::planIn(with(good, "\"as measured\"", "\"as measures\""), "plan.json"));
  // of a source of the plan; what clinics report is read from its own file
  const std::size_t sources = good.find("\"sources\"");
  ASSERT_NE(sources, std::string::npos);
  EXPECT_FALSE(
      planning::planIn(good.substr(0, sources) +
                           with(good.substr(sources), "\"confidence\": \"", "\"confidence\": \"x"),
                       "plan.json"));
}

TEST(StoredPlan, ThatWasChangedHasNoNumber)
{
  const std::string good = writtenPlan();
  EXPECT_EQ(planning::planIn(good, "plan.json")->plan.seal, Seal::intact);
  EXPECT_EQ(planning::planIn(good, "plan.json")->plan.fingerprint, "0123");
  for (const auto& [part, other] : {std::pair{"\"A_mm\": 9.2", "\"A_mm\": 9.9"},
                                    {"\"side\": \"right\"", "\"side\": \"left\""},
                                    {"\"plan\": \"0123\"", "\"plan\": \"0124\""},
                                    {"\"content_sha256\"", "\"content_sha257\""},
                                    {"\"format\": 3", "\"format\": 1"},
                                    {"\"format\"", "\"formas\""},
                                    {"\n", "\n "}}) {
    const auto stored = planning::planIn(with(good, part, other), "plan.json");
    ASSERT_TRUE(stored) << other << ": " << stored.error().message;
    EXPECT_EQ(stored->plan.seal, Seal::changed) << other;
    EXPECT_EQ(stored->plan.fingerprint, "") << other;
    EXPECT_FALSE(planning::planJson(stored->plan)) << "it must not get a new seal";
  }
}

/// A plan without its seal and the line of its format.
std::string unsealedPlan()
{
  std::string former = with(writtenPlan(), "  \"format\": 3,\n", "");
  const auto seal = former.find(",\n  \"content_sha256\"");
  return former.replace(seal, former.size() - seal, "\n}\n");
}

TEST(StoredPlan, OfAProgramThatSealsIsChangedWithoutASeal)
{
  const auto stored = planning::planIn(unsealedPlan(), "plan.json");
  ASSERT_TRUE(stored) << stored.error().message;
  EXPECT_EQ(stored->plan.seal, Seal::changed);
  EXPECT_EQ(stored->plan.fingerprint, "");
}

TEST(StoredPlan, OfAnEarlierVersionCarriesNoSealAndKeepsItsNumber)
{
  const std::string former =
      with(unsealedPlan(), "\"Perilymph " + version() + '"', "\"Perilymph 0.2.0\"");
  const auto stored = planning::planIn(former, "plan.json");
  ASSERT_TRUE(stored) << stored.error().message;
  EXPECT_EQ(stored->plan.seal, Seal::absent);
  EXPECT_EQ(stored->plan.fingerprint, "0123");
  // its force on the partition is another one, and so it says
  const auto now = planning::planIn(writtenPlan(), "plan.json");
  ASSERT_TRUE(now) << now.error().message;
  ASSERT_EQ(stored->limits.size(), now->limits.size() + 1);
  EXPECT_THAT(stored->limits.back(), HasSubstr("not the force that ruptures"));
}

TEST(StoredPlan, AbsentHasTheSentenceOfTheFile)
{
  const auto stored = planning::readPlan("/no/such/plan.json");
  ASSERT_FALSE(stored);
  EXPECT_THAT(stored.error().message, HasSubstr("/no/such/plan.json"));
}

}  // namespace
}  // namespace perilymph::test
