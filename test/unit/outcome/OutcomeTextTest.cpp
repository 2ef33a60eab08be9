// SPDX-License-Identifier: BSD-3-Clause

// Outcomes as files: what is written is read again, and what does not hold is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "perilymph/outcome/OutcomeText.h"

namespace perilymph::outcome {
namespace {

using Json = nlohmann::ordered_json;

OutcomeContent example()
{
  OutcomeContent content;
  FoundArray& found = content.found;
  found.array = "flex28";
  found.side = anatomy::Side::left;
  for (int number = 1; number <= 3; ++number) {
    FoundContact contact;
    contact.number = number;
    contact.position_P = {10.25 * number, -3.5, 0.125};
    contact.covariance_P = 0.01 * Eigen::Matrix3d::Identity();
    contact.makerElectrode = 23 - number;
    contact.isInside = number < 3;
    contact.isByHand = number == 2;
    contact.isSeenSingly = number != 2;
    if (contact.isInside) {
      contact.angle_deg = {400.0 - 90.0 * number, 3.0};
      contact.modiolus_mm = 0.5;
      contact.outerWall_mm = 0.75;
      contact.inScalaTympani = 0.875;
      contact.greenwood_Hz = {800.0, 700.0, 900.0};
      contact.spiralGanglion_Hz = {600.0, 500.0, 720.0};
      contact.filter_Hz = 240.0;
      contact.mismatch_semitones = 15.9;
    }
    found.contacts.push_back(contact);
  }
  found.course_P = {{1, 2, 3}, {4, 5, 6}};
  found.angularInsertionDepth_deg = {310.0, 3.0};
  found.tipAngle_deg = 318.0;
  found.contactsInside = 2;
  found.insertedLength_mm = 22.5;
  found.insertedLengthSd_mm = 0.5;
  found.outside_mm = 1.6;
  found.isFolded = false;
  found.translocationProbability = 0.125;
  found.isRegistered = true;
  found.residual_mm = 0.07;
  found.fwhm_mm = 0.45;
  found.flags = {Flag::missingContacts, Flag::contactsOutside};
  content.surgery.array = "flex28";
  content.surgery.stopReason = StopReason::resistance;
  content.surgery.opening = Opening::roundWindow;
  content.surgery.intendedDepth = millimeters(24);
  content.surgery.contactAtResistance = 11;
  content.surgery.isMarkReached = false;
  content.plan = std::string(64, 'a');
  content.series = std::string(64, 'b');
  content.ctAge_days = 12;
  return content;
}

TEST(OutcomeText, IsReadAgainAsItWasWritten)
{
  const OutcomeContent written = example();
  const auto read = outcomeIn(outcomeJson(written), "outcome");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->surgery, written.surgery);
  EXPECT_EQ(read->ctAge_days, 12);
  EXPECT_EQ(read->plan, written.plan);
  EXPECT_EQ(read->series, written.series);
  EXPECT_EQ(read->found.flags, written.found.flags);
  EXPECT_EQ(read->found.course_P, written.found.course_P);
  ASSERT_EQ(read->found.contacts.size(), 3u);
  EXPECT_EQ(read->found.contacts[1].position_P, written.found.contacts[1].position_P);
  EXPECT_NEAR(read->found.contacts[1].error_mm(), 0.1, 1e-12);
  EXPECT_EQ(read->found.contacts[0].spiralGanglion_Hz, written.found.contacts[0].spiralGanglion_Hz);
  EXPECT_EQ(outcomeJson(*read), outcomeJson(written));
}

TEST(OutcomeText, HasTheKeysThatOtherProgramsReadByName)
{
  const Json json = Json::parse(outcomeJson(example()));
  for (const char* key :
       {"format", "array", "side", "contacts", "angular_insertion_depth_deg", "tip_angle_deg",
        "contacts_inside", "fold", "translocation", "registration", "flags", "seconds"})
    EXPECT_TRUE(json.contains(key)) << key;
  for (const char* key : {"number", "position_lps_mm", "error_mm", "angle_deg", "modiolus_mm",
                          "outer_wall_mm", "in_scala_tympani", "seen_singly", "inside"})
    EXPECT_TRUE(json["contacts"][0].contains(key)) << key;
  EXPECT_EQ(json["contacts"][0]["number"], 1);
  EXPECT_EQ(json["format"], 1);
  EXPECT_NEAR(json["angular_insertion_depth_deg"]["ci95"][1].get<double>(), 310.0 + 1.96 * 3.0,
              1e-9);
  EXPECT_FALSE(json["contacts"][2].contains("angle_deg"));
}

/// Every key is removed, and replaced by values of other types and beyond any range, one at a time.
TEST(OutcomeText, IsRefusedInASentenceWhateverIsWrongWithAKey)
{
  const Json whole = Json::parse(outcomeJson(example()));
  const std::vector<std::string> optional{"/plan", "/series_sha256", "/seconds", "/version"};
  int refused = 0;
  const Json flat = whole.flatten();
  for (const auto& [path, value] : flat.items()) {
    if (std::find(optional.begin(), optional.end(), path) != optional.end() ||
        path.starts_with("/surgery") || path.ends_with("/ci95/0") || path.ends_with("/ci95/1"))
      continue;
    for (const Json& wrong :
         {Json("text"), Json(1e300), Json(nullptr), Json(Json::array()), Json(-1e9)}) {
      if (value.is_string() && wrong.is_string()) continue;
      Json changed = whole;
      changed[Json::json_pointer(path)] = wrong;
      const auto read = outcomeIn(changed.dump(), "outcome");
      if (path.ends_with("filter_Hz") || path.ends_with("mismatch_semitones") ||
          path.ends_with("maker_electrode") || path.ends_with("ct_age_days"))
        if (wrong.is_null()) continue;  // may be missing
      EXPECT_FALSE(read) << path << " = " << wrong;
      if (!read) {
        EXPECT_NE(read.error().message.find("outcome"), std::string::npos);
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 200);
}

TEST(OutcomeText, OfAnEarlierProgramStatesNoAgeOfItsCt)
{
  Json json = Json::parse(outcomeJson(example()));
  json.erase("ct_age_days");
  const auto earlier = outcomeIn(json.dump(), "outcome");
  ASSERT_TRUE(earlier) << earlier.error().message;
  EXPECT_FALSE(earlier->ctAge_days);
  for (const int bad : {-2, 36'501}) {
    json["ct_age_days"] = bad;
    const auto read = outcomeIn(json.dump(), "outcome");
    ASSERT_FALSE(read) << bad;
    EXPECT_NE(read.error().message.find("ct_age_days is " + std::to_string(bad)), std::string::npos)
        << read.error().message;
  }
}

TEST(OutcomeText, IsRefusedIfContactsContradictTheirCount)
{
  Json json = Json::parse(outcomeJson(example()));
  json["contacts_inside"] = 3;
  const auto read = outcomeIn(json.dump(), "outcome");
  ASSERT_FALSE(read);
  EXPECT_NE(read.error().message.find("contacts_inside"), std::string::npos);
  json["contacts_inside"] = 2;
  json["contacts"][1]["number"] = 1;
  EXPECT_FALSE(outcomeIn(json.dump(), "outcome"));
}

TEST(OutcomeText, OfANewerFormatOrNoJsonSaysSo)
{
  Json json = Json::parse(outcomeJson(example()));
  json["format"] = 2;
  const auto newer = outcomeIn(json.dump(), "outcome");
  ASSERT_FALSE(newer);
  EXPECT_NE(newer.error().message.find("newer program"), std::string::npos);
  EXPECT_FALSE(outcomeIn("{", "outcome"));
  EXPECT_FALSE(outcomeIn("[]", "outcome"));
}

TEST(OutcomeText, TheTableHasAColumnForEveryRowOfItsDictionary)
{
  const auto fieldsIn = [](const std::string& line) {
    return std::count(line.begin(), line.end(), ',') + 1;
  };
  std::istringstream csv(outcomeCsv(example().found));
  std::string head, line;
  std::getline(csv, head);
  int rows = 0;
  while (std::getline(csv, line)) {
    EXPECT_EQ(fieldsIn(line), fieldsIn(head)) << line;
    ++rows;
  }
  EXPECT_EQ(rows, 3);
  EXPECT_THAT(head, testing::StartsWith("contact,maker_electrode,angle_deg,"));
  const std::string dictionary = outcomeDictionaryCsv();
  EXPECT_EQ(std::count(dictionary.begin(), dictionary.end(), '\n') - 1, fieldsIn(head));
}

TEST(OutcomeText, EachRowOfTheTableStatesWhatIsDoubtfulAndFrequenciesToThreeDigits)
{
  FoundArray found = example().found;
  found.contacts[0].greenwood_Hz = {802.46, 700.0, 12'345.6};
  found.contacts[2].makerElectrode.reset();
  std::istringstream csv(outcomeCsv(found));
  std::string head, first, second, third;
  for (std::string* line : {&head, &first, &second, &third}) std::getline(csv, *line);
  EXPECT_THAT(first, testing::StartsWith("1,22,310,"));
  EXPECT_THAT(first,
              testing::HasSubstr(",802,700,12300,600,500,720,240,15.9,12.7067,19.0196,0.875,0.1,"));
  EXPECT_THAT(second, testing::StartsWith("2,21,"));
  EXPECT_THAT(third, testing::StartsWith("3,,,"));
  for (const std::string& line : {first, second, third})
    EXPECT_THAT(line, testing::EndsWith(",flex28,left,missing_contacts contacts_outside")) << line;
}

TEST(OutcomeText, TheMakersNumbersAreReadAgainAndStayUnknownWhereNoneIsStated)
{
  OutcomeContent content = example();
  content.found.contacts[1].makerElectrode.reset();
  const auto read = outcomeIn(outcomeJson(content), "outcome");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->found.contacts[0].makerElectrode, 22);
  EXPECT_EQ(read->found.contacts[1].makerElectrode, std::nullopt);
  Json json = Json::parse(outcomeJson(content));
  json["contacts"][0]["maker_electrode"] = 65;
  const auto refused = outcomeIn(json.dump(), "outcome");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, testing::HasSubstr("maker_electrode"));
}

}  // namespace
}  // namespace perilymph::outcome
