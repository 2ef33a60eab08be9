// SPDX-License-Identifier: BSD-3-Clause

// What a person marked in a CT, kept in the patient's record.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "PatientRecordRig.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::session {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;
using testing::Not;
using Json = nlohmann::ordered_json;

const std::string firstCt = std::string(64, 'a'), secondCt = std::string(64, 'b');

/// One of each kind; the second CT is oblique and left-handed.
std::vector<ct::CtMarkups> someMarkups()
{
  Eigen::Matrix3d oblique;
  oblique << 0.1, 0, 0.3, 0.2, 0.1, 0, 0, -0.2, 0.4;
  return {
      {firstCt,
       0.3 * Eigen::Matrix3d::Identity(),
       {{ct::MarkupKind::distance, {Vector3d(1, 2, 3), Vector3d(4, 6, 15)}, "recess"},
        {ct::MarkupKind::angle, {Vector3d(5, 0, 0), Vector3d(0, 0, 0), Vector3d(0, 2, 0)}},
        {ct::MarkupKind::note, {Vector3d(1 / 3.0, 1e-3, -700)}, "hoher Bulbus „links“ \\ \"x\""}}},
      {secondCt,
       oblique,
       {{ct::MarkupKind::facialNerve, {Vector3d(1, 2, 3), Vector3d(4, 6, 15)}},
        {ct::MarkupKind::chordaTympani, {Vector3d(1, 2, 3)}},
        {ct::MarkupKind::canalWall, std::vector<Vector3d>(7, Vector3d(9, 9, 9))}}}};
}

class PatientMarkups : public PatientRecords {
protected:
  void SetUp() override
  {
    PatientRecords::SetUp();
    record_.markups = someMarkups();
    ASSERT_TRUE(savePatientRecord(record_, file_));
  }

  Json json() { return Json::parse(*readWhole(recordFileOf(file_))); }
};

TEST_F(PatientMarkups, AreReadBitForBitAsTheyWereWritten)
{
  const auto read = loadPatientRecord(file_);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->markups, someMarkups());
  EXPECT_EQ(read->seal, Seal::intact);
}

TEST_F(PatientMarkups, HaveTheirValuesInLpsForOtherPrograms)
{
  const Json first = json().at("markups")[0];
  EXPECT_EQ(first.at("series_sha256"), firstCt);
  EXPECT_EQ(first.at("coordinate_system"), "LPS");
  const Json &distance = first.at("items")[0], &angle = first.at("items")[1];
  EXPECT_EQ(distance.at("kind"), "distance");
  EXPECT_EQ(distance.at("lps_mm")[1], (Json{4.0, 6.0, 15.0}));
  EXPECT_NEAR(distance.at("value").get<double>(), 13.0, 1e-12);
  EXPECT_NEAR(distance.at("sd").get<double>(), 0.3 / std::sqrt(6.0), 1e-12);
  EXPECT_EQ(distance.at("unit"), "mm");
  EXPECT_NEAR(angle.at("value").get<double>(), 90.0, 1e-12);
  EXPECT_EQ(angle.at("unit"), "deg");
  EXPECT_FALSE(first.at("items")[2].contains("value"));
}

TEST_F(PatientMarkups, AreFoundByTheSeriesOfTheirCtAndByNoOther)
{
  const auto read = loadPatientRecord(file_);
  ASSERT_NE(markupsOf(*read, secondCt), nullptr);
  EXPECT_EQ(*markupsOf(*read, secondCt), someMarkups()[1]);
  EXPECT_EQ(markupsOf(*read, std::string(64, 'c')), nullptr);
  EXPECT_EQ(markupsOf(*read, ""), nullptr);
}

TEST_F(PatientMarkups, AreReplacedAndRemovedByTheirSeries)
{
  ct::CtMarkups changed = someMarkups()[0];
  changed.markups.pop_back();
  ASSERT_TRUE(changePatientRecord(file_, [&](PatientRecord& each) { setMarkups(each, changed); }));
  auto read = loadPatientRecord(file_);
  EXPECT_EQ(*markupsOf(*read, firstCt), changed);
  EXPECT_EQ(*markupsOf(*read, secondCt), someMarkups()[1]);
  changed.markups.clear();
  ASSERT_TRUE(changePatientRecord(file_, [&](PatientRecord& each) { setMarkups(each, changed); }));
  read = loadPatientRecord(file_);
  EXPECT_EQ(markupsOf(*read, firstCt), nullptr);
  EXPECT_EQ(read->markups.size(), 1u);
}

TEST_F(PatientMarkups, KeepTheRecordsOfOlderProgramsReadable)
{
  EXPECT_EQ(json().at("format"), 3);
  record_.markups.clear();
  record_.base = loadPatientRecord(file_)->base;
  ASSERT_TRUE(savePatientRecord(record_, file_));
  EXPECT_EQ(json().at("format"), 2);
  EXPECT_FALSE(json().contains("markups"));
  EXPECT_TRUE(loadPatientRecord(file_)->markups.empty());
}

TEST_F(PatientMarkups, TravelWithThePatient)
{
  ASSERT_TRUE(exportPatient(file_, {}, folder_ / "P-017"));
  const auto imported = importPatient(folder_ / "P-017", folder_ / "other", folder_ / "others");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(loadPatientRecord(*imported)->markups, someMarkups());
}

TEST_F(PatientMarkups, OfHostileFilesAreRefusedInASentenceWithoutTheirText)
{
  const Json whole = json();
  const auto refused = [&](const char* pointer, const Json& value) {
    Json bad = whole;
    bad[Json::json_pointer(pointer)] = value;
    EXPECT_TRUE(writeWhole(recordFileOf(file_), bad.dump()));
    const auto read = loadPatientRecord(file_);
    EXPECT_FALSE(read) << pointer << " " << value.dump().substr(0, 60);
    if (read) return;
    EXPECT_THAT(read.error().message, HasSubstr("P-017-left.json")) << pointer;
    EXPECT_THAT(read.error().message, Not(HasSubstr("Bulbus"))) << pointer;
  };
  refused("/markups", 7);
  refused("/markups/0", "text");
  refused("/markups/0/series_sha256", "Doe, Jane");
  refused("/markups/0/series_sha256", secondCt);  // twice
  refused("/markups/0/coordinate_system", "RAS");
  refused("/markups/0/voxel_edges_mm", Json::array());
  refused("/markups/0/voxel_edges_mm/0", Json{0.0, 0.0, 0.0});
  refused("/markups/0/voxel_edges_mm/0", Json{"a", 0.0, 0.0});
  refused("/markups/0/items", nullptr);
  refused("/markups/0/items/0/kind", "volume");
  refused("/markups/0/items/0/kind", 3);
  refused("/markups/0/items/0/lps_mm", Json::array());
  refused("/markups/0/items/0/lps_mm/1", Json{1.0, 2.0});
  refused("/markups/0/items/0/lps_mm/1", Json{1.0, 2.0, 1e300});
  refused("/markups/0/items/0/lps_mm/1", Json{1.0, 2.0, 3.0});  // both ends at one place
  refused("/markups/0/items/2/text", "");
  refused("/markups/0/items/2/text", "Bulbus\n");
  refused("/markups/0/items/2/text", std::string(ct::maxMarkupText + 1, 'x'));
  refused("/markups/0/items",
          Json(std::vector<Json>(ct::maxMarkups + 1, whole["markups"][0]["items"][0])));
}

TEST_F(PatientMarkups, ThatWereChangedByHandAreReadAndSaySo)
{
  Json changed = json();
  changed["markups"][0]["items"][0]["value"] = 99.0;  // the points are what counts
  ASSERT_TRUE(writeWhole(recordFileOf(file_), changed.dump(2) + "\n"));
  const auto read = loadPatientRecord(file_);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->markups, someMarkups());
  EXPECT_TRUE(read->isChangedByHand);
}

}  // namespace
}  // namespace perilymph::session
