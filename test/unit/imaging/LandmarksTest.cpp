// SPDX-License-Identifier: BSD-3-Clause

// Landmarks to and from 3D Slicer.

#include "perilymph/imaging/Landmarks.h"

#include <gmock/gmock.h>

#include <map>
#include <string>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/imaging/PlanFiles.h"
#include "perilymph/test/TemporaryFolder.h"

namespace perilymph::imaging {
namespace {

using Eigen::Vector3d;

TEST(Landmarks, ComeBackAsTheyWereWritten)
{
  ct::Marks marks;
  marks[ct::Mark::roundWindow] = Vector3d(1.25, -2.5, 3.0);
  marks[ct::Mark::apex] = Vector3d(0.1, 0.2, 0.3);
  marks[ct::Mark::farB] = Vector3d(-7.0, 8.0, 9.0);
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeWhole(folder / "ear.mrk.json", planText({.marks = marks})));
  const auto read = readLandmarks(folder / "ear.mrk.json", {});
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(*read == marks);
}

TEST(Landmarks, AreWrittenInTheFrameThatTheyName)
{
  ct::Marks marks;
  marks[ct::Mark::modiolus] = Vector3d(1.0, 2.0, 3.0);
  const std::string text = planText({.marks = marks});
  EXPECT_THAT(text, testing::HasSubstr("\"coordinateSystem\": \"LPS\""));
  EXPECT_THAT(text, testing::HasSubstr("\"label\": \"C\""));
}

TEST(Landmarks, OfAnotherSeriesAreRefused)
{
  const test::TemporaryFolder folder;
  ct::Marks marks;
  marks[ct::Mark::roundWindow] = Vector3d(1.0, 2.0, 3.0);
  const auto file = folder / "ear.mrk.json";
  ASSERT_TRUE(writeWhole(file, planText({.seriesKey = std::string(64, 'a'), .marks = marks})));
  EXPECT_TRUE(readLandmarks(file, std::string(64, 'a')));
  for (const std::string& other : {std::string(64, 'b'), std::string(), std::string(63, 'a')}) {
    const auto read = readLandmarks(file, other);
    ASSERT_FALSE(read) << other;
    EXPECT_THAT(read.error().message, testing::HasSubstr("landmarks of another CT series"));
  }
  // points that name none, as Slicer's own
  ASSERT_TRUE(writeWhole(file, planText({.marks = marks})));
  EXPECT_TRUE(readLandmarks(file, std::string(64, 'b')));
}

TEST(Landmarks, AreAtOnePlaceEach)
{
  const test::TemporaryFolder folder;
  const auto file = folder / "a.mrk.json";
  const std::string point = R"({"label": "RW", "position": [1, 2, 3]})";
  const std::string same = R"({"label": "RW", "position": [1, 2, 3.001]})";
  const std::string other = R"({"label": "RW", "position": [1, 2, 4]})";
  const auto lists = [](const std::string& first, const std::string& second) {
    return R"({"markups": [{"controlPoints": [)" + first + R"(]}, {"controlPoints": [)" + second +
           "]}]}";
  };
  ASSERT_TRUE(writeWhole(file, lists(point, same)));
  EXPECT_TRUE(readLandmarks(file, {}));
  for (const std::string& text : {lists(point, other), lists(point + ", " + other, same)}) {
    ASSERT_TRUE(writeWhole(file, text));
    const auto read = readLandmarks(file, {});
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().message, testing::HasSubstr("the landmark RW at two points"));
  }
}

TEST(Landmarks, AreRefusedWhereAnObjectHasTwoValuesOfOneName)
{
  const test::TemporaryFolder folder;
  const auto file = folder / "a.mrk.json";
  const std::string point = R"({"label": "RW", "position": [1, 2, 3]})";
  for (const auto& [text, name] : std::map<std::string, std::string>{
           {R"({"markups": [{"coordinateSystem": "LPS", "coordinateSystem": "RAS",
                "controlPoints": [)" +
                point + "]}]}",
            "coordinateSystem"},
           {R"({"markups": [{"controlPoints": [{"label": "RW", "position": [1, 2, 3],
                "position": [1, 2, 9]}]}]})",
            "position"},
           {R"({"markups": [], "markups": [{"controlPoints": [)" + point + "]}]}", "markups"}}) {
    ASSERT_TRUE(writeWhole(file, text));
    const auto read = readLandmarks(file, {});
    ASSERT_FALSE(read) << name;
    EXPECT_THAT(read.error().message, testing::HasSubstr("\"" + name + "\" twice"));
  }
}

TEST(Landmarks, OfRasFilesAreTurnedToLps)
{
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeWhole(folder / "ras.mrk.json",
                         R"({"markups": [{"coordinateSystem": "RAS", "controlPoints":
                             [{"label": "RW", "position": [1, 2, 3]}]}]})"));
  const auto read = readLandmarks(folder / "ras.mrk.json", {});
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ((*read)[ct::Mark::roundWindow].value(), Vector3d(-1, -2, 3));
}

/// Landmarks in a file whose list has more members than its points.
Result<ct::Marks> readWith(const std::string& members, const std::string& position)
{
  const test::TemporaryFolder folder;
  if (!writeWhole(folder / "a.mrk.json",
                  "{\"markups\": [{" + members +
                      "\"controlPoints\": [{\"label\": \"RW\", \"position\": " + position +
                      "}]}]}"))
    throw std::runtime_error("The file could not be written.");
  return readLandmarks(folder / "a.mrk.json", {});
}

TEST(Landmarks, WithoutACoordinateSystemAreInLps)
{
  const auto read = readWith("", "[1, 2, 3]");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ((*read)[ct::Mark::roundWindow].value(), Vector3d(1, 2, 3));
}

TEST(Landmarks, AreInTheUnitThatTheyName)
{
  const struct {
    const char* unit;
    const char* position;
  } files[] = {{R"("mm")", "[1, -2, 3]"},
               {R"("um")", "[1000, -2000, 3000]"},
               {R"("cm")", "[0.1, -0.2, 0.3]"},
               {R"("m")", "[0.001, -0.002, 0.003]"},
               {R"(["um", "UCUM", "micrometer"])", "[1000, -2000, 3000]"}};
  for (const auto& file : files) {
    const auto read =
        readWith(std::string("\"coordinateUnits\": ") + file.unit + ", ", file.position);
    ASSERT_TRUE(read) << file.unit;
    EXPECT_NEAR(((*read)[ct::Mark::roundWindow].value() - Vector3d(1, -2, 3)).norm(), 0.0, 1e-12)
        << file.unit;
  }
  for (const char* const unit :
       {R"("inch")", R"("")", "7", "null", "[]", R"(["[in_i]", "UCUM"])"}) {
    const auto read = readWith(std::string("\"coordinateUnits\": ") + unit + ", ", "[1, 2, 3]");
    ASSERT_FALSE(read) << unit;
    EXPECT_THAT(read.error().message, testing::HasSubstr("in another unit")) << unit;
  }
  for (const char* const system : {R"("XYZ")", R"("")", "3", "null"})
    EXPECT_FALSE(readWith(std::string("\"coordinateSystem\": ") + system + ", ", "[1, 2, 3]"))
        << system;
}

TEST(Landmarks, WithoutAPointInTheCochleaAreRefused)
{
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeWhole(folder / "b.mrk.json",
                         R"({"markups": [{"coordinateSystem": "LPS", "controlPoints":
                             [{"label": "B1", "position": [1, 2, 3]}]}]})"));
  const auto read = readLandmarks(folder / "b.mrk.json", {});
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, testing::HasSubstr("RW, C or A"));
}

}  // namespace
}  // namespace perilymph::imaging
