// SPDX-License-Identifier: BSD-3-Clause

// Distances, angles, notes and structures in files, as other programs read and write them.

#include "perilymph/imaging/MarkupFiles.h"

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/imaging/PlanFiles.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

using ct::MarkupKind;
using Eigen::Vector3d;
using Json = nlohmann::json;
using testing::HasSubstr;
using testing::Not;

ct::CtMarkups oneOfEach()
{
  return {std::string(64, 'a'),
          0.3 * Eigen::Matrix3d::Identity(),
          {{MarkupKind::distance, {{1, 2, 3}, {4, 6, 15}}, "facial recess, \"width\""},
           {MarkupKind::distance, {{1 / 3.0, 2, 3}, {1, 2, 3}}},
           {MarkupKind::angle, {{5, 0, 0}, {0, 0, 0}, {0, 2, 0}}},
           {MarkupKind::note, {{-7, 8.25, 1e-3}}, "hoher Bulbus"},
           {MarkupKind::facialNerve, {{1, 1, 1}, {2, 2, 2}, {3, 3, 4}}, "vertical part"},
           {MarkupKind::chordaTympani, {{9, 9, 9}}},
           {MarkupKind::canalWall, {{1, 0, 0}, {0, 1, 0}}}}};
}

class MarkupFiles : public testing::Test {
protected:
  std::filesystem::path written(const std::string& text)
  {
    EXPECT_TRUE(writeWhole(folder_ / "x.mrk.json", text));
    return folder_ / "x.mrk.json";
  }

  test::TemporaryFolder folder_;
};

TEST_F(MarkupFiles, OfSlicerAreReadBitForBitAsTheyWereWritten)
{
  const ct::CtMarkups markups = oneOfEach();
  const auto read = readMarkups(written(slicerMarkups(markups)), markups.seriesKey);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, markups.markups);
}

TEST_F(MarkupFiles, OfSlicerHaveItsTypesInLpsWithMeasurements)
{
  const Json lists = Json::parse(slicerMarkups(oneOfEach())).at("markups");
  const std::vector<std::string> types{"Line",  "Line",     "Angle", "Fiducial",
                                       "Curve", "Fiducial", "Curve"};
  ASSERT_EQ(lists.size(), types.size());
  for (std::size_t k = 0; k < types.size(); ++k) {
    EXPECT_EQ(lists[k].at("type"), types[k]);
    EXPECT_EQ(lists[k].at("coordinateSystem"), "LPS");
    EXPECT_EQ(lists[k].at("coordinateUnits"), "mm");
  }
  EXPECT_EQ(lists[0].at("controlPoints")[1].at("position"), (Json{4.0, 6.0, 15.0}));
  EXPECT_NEAR(lists[0].at("measurements")[0].at("value").get<double>(), 13.0, 1e-12);
  EXPECT_EQ(lists[0].at("measurements")[0].at("units"), "mm");
  EXPECT_NEAR(lists[2].at("measurements")[0].at("value").get<double>(), 90.0, 1e-12);
  EXPECT_EQ(lists[3].at("controlPoints")[0].at("label"), "hoher Bulbus");
}

TEST_F(MarkupFiles, OfAnotherSeriesAreRefused)
{
  const auto file = written(slicerMarkups(oneOfEach()));
  const auto read = readMarkups(file, std::string(64, 'b'));
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("another CT series"));
}

/// A point with its label.
struct Labeled {
  std::string label;
  Json position;
};

/// A list as Slicer writes it, in RAS where it was told to.
Json listOf(const char* type, const char* name, const std::vector<Labeled>& points,
            const char* system = "LPS")
{
  Json controls = Json::array();
  for (const Labeled& point : points)
    controls.push_back({{"label", point.label}, {"position", point.position}});
  return {
      {"type", type}, {"name", name}, {"coordinateSystem", system}, {"controlPoints", controls}};
}

std::string fileOf(const std::vector<Json>& lists)
{
  return Json{{"@schema", "x"}, {"markups", lists}}.dump();
}

TEST_F(MarkupFiles, OfOtherProgramsAreReadInRasAndWithoutOurNames)
{
  const auto read = readMarkups(
      written(fileOf({listOf("Line", "L", {{"L-1", {1, 2, 3}}, {"L-2", {4, 6, 15}}}, "RAS"),
                      listOf("Fiducial", "F",
                             {{"RW", {0, 0, 0}},              // a landmark
                              {"facial_nerve 2", {7, 7, 7}},  // a structure
                              {"F-1", {8, 8, 8}},
                              {"", {9, 9, 9}}}),
                      listOf("ROI", "R", {{"R-1", {0, 0, 0}}})})),
      std::string(64, 'a'));
  ASSERT_TRUE(read) << read.error().message;
  const std::vector<ct::Markup> expected{{MarkupKind::distance, {{-1, -2, 3}, {-4, -6, 15}}, "L"},
                                         {MarkupKind::note, {{8, 8, 8}}, "F-1"},
                                         {MarkupKind::note, {{9, 9, 9}}, "note"},
                                         {MarkupKind::facialNerve, {{7, 7, 7}}, "F"}};
  EXPECT_EQ(*read, expected);
}

TEST_F(MarkupFiles, HaveTextsOfOtherProgramsInOneLineAndCutBetweenCharacters)
{
  std::string longText = "a\nb";
  for (std::size_t k = 0; k < ct::maxMarkupText; ++k) longText += "ä";
  const auto read =
      readMarkups(written(fileOf({listOf("Fiducial", "F", {{longText, {1, 2, 3}}})})), "");
  ASSERT_TRUE(read) << read.error().message;
  const std::string& text = read->at(0).text;
  EXPECT_EQ(text.substr(0, 5), "a bä");
  EXPECT_LE(text.size(), ct::maxMarkupText);
  EXPECT_GE(text.size(), ct::maxMarkupText - 1);
}

TEST_F(MarkupFiles, ThatAreHostileAreRefusedInASentence)
{
  const Labeled at{"a", {1, 2, 3}}, there{"b", {4, 5, 6}};
  const auto toPlace = [&](const Json& place) {
    return fileOf({listOf("Line", "L", {at, {"b", place}})});
  };
  for (const std::string& text :
       {std::string(), std::string("[]"), std::string(100'000, '['),
        std::string("{\"markups\": 7}"), fileOf({}), fileOf({Json(7)}),
        fileOf({listOf("ROI", "R", {at})}), fileOf({listOf("Line", "L", {at})}),
        fileOf({listOf("Line", "L", {at, at})}), fileOf({listOf("Line", "L", {at, there, at})}),
        fileOf({listOf("Angle", "A", {at, there})}), toPlace({1, 2}), toPlace({1, 2, "3"}),
        toPlace({1, 2, 1e300}), fileOf({listOf("Line", "L", {at, there}, "XYZ")}),
        fileOf({Json{{"type", "Line"}, {"coordinateUnits", "parsec"}}}),
        fileOf({listOf("Fiducial", "F", {{"RW", {1, 2, 3}}})}),
        std::string(R"({"markups": [{"type": "Line", "type": "Angle", "controlPoints": []}]})")}) {
    const auto read = readMarkups(written(text), std::string(64, 'a'));
    ASSERT_FALSE(read) << text.substr(0, 200);
    EXPECT_THAT(read.error().message, HasSubstr("x.mrk.json"));
    EXPECT_THAT(read.error().message, Not(HasSubstr("\n")));
  }
  const Json nerve =
      listOf("Curve", "facial_nerve",
             std::vector<Labeled>(ct::maxMarkupPoints + 1, {"facial_nerve", {1, 2, 3}}));
  EXPECT_FALSE(readMarkups(written(fileOf({nerve})), ""));
}

TEST_F(MarkupFiles, OfLandmarksAreReadAsNotesOfNone)
{
  PlanMarkups plan;
  plan.marks[ct::Mark::roundWindow] = Vector3d(1, 2, 3);
  EXPECT_FALSE(readMarkups(written(planText(plan)), ""));
}

TEST_F(MarkupFiles, AsATableHaveARowForEachPoint)
{
  std::istringstream table(markupsCsv(oneOfEach())), dictionary(markupsDictionaryCsv());
  std::string head, first, second, line;
  std::getline(table, head);
  std::getline(table, first);
  std::getline(table, second);
  EXPECT_EQ(first,
            "1,distance,\"facial recess, \"\"width\"\"\",13.0000,0.1225,mm,1,1.0000,2.0000,"
            "3.0000," +
                std::string(64, 'a'));
  EXPECT_THAT(second, HasSubstr(",mm,2,4.0000,6.0000,15.0000,"));
  std::size_t rows = 2;
  while (std::getline(table, line)) ++rows;
  EXPECT_EQ(rows, 2u + 2u + 3u + 1u + 3u + 1u + 2u);
  // the dictionary has the columns in their order
  std::string columns;
  std::getline(dictionary, line);
  while (std::getline(dictionary, line))
    columns += (columns.empty() ? "" : ",") + line.substr(0, line.find(','));
  EXPECT_EQ(columns, head);
}

TEST_F(MarkupFiles, AsJsonHaveTheir95PercentIntervals)
{
  const Json json = Json::parse(markupsJson(oneOfEach()));
  const Json& distance = json.at("markups")[0];
  const double sd = 0.3 / std::sqrt(6.0);
  EXPECT_NEAR(distance.at("ci95")[0].get<double>(), 13.0 - 1.96 * sd, 1e-12);
  EXPECT_NEAR(distance.at("ci95")[1].get<double>(), 13.0 + 1.96 * sd, 1e-12);
  EXPECT_EQ(json.at("series_sha256"), std::string(64, 'a'));
  EXPECT_EQ(json.at("voxel_edges_mm")[1], (Json{0.0, 0.3, 0.0}));
  EXPECT_FALSE(json.at("markups")[3].contains("value"));
}

}  // namespace
}  // namespace perilymph::imaging
