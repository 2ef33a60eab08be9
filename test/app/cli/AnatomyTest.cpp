// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>

#include "perilymph/foundation/Resources.h"
#include "perilymph/test/Cli.h"

namespace perilymph::test {
namespace {

namespace fs = std::filesystem;

TEST(Anatomy, MeasuresThePublishedCochlea)
{
  const TemporaryFolder folder;
  const auto outcome = cli({"anatomy", "--preset", "published", "--json", folder / "a.json",
                            "--sections", folder / "a.csv"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(contentOf(folder / "a.json"));
  for (const char* key :
       {"A_mm", "B_mm", "H_mm", "turns", "st_length_mm", "cdl_oc_mm", "outer_wall_length_360_mm",
        "outer_wall_length_mm", "volume_mm3", "axial_height_mm", "rw_width_mm", "rw_height_mm"}) {
    ASSERT_TRUE(json.contains(key)) << key;
    EXPECT_TRUE(json[key].is_number()) << key;
    EXPECT_FALSE(json["derived"][key]["formula"].get<std::string>().empty()) << key;
    EXPECT_FALSE(json["derived"][key]["source"].get<std::string>().empty()) << key;
  }
  // 35.58 mm and 2.56 mm are printed in the paper; A and B are those of the measured mean scala
  // tympani whose sections this anatomy takes (9.53 and 6.82 mm).
  EXPECT_NEAR(json["st_length_mm"].get<double>(), 35.58, 0.01);
  EXPECT_NEAR(json["axial_height_mm"].get<double>(), 2.56, 0.01);
  EXPECT_NEAR(json["A_mm"].get<double>(), 9.53, 0.05);
  EXPECT_NEAR(json["B_mm"].get<double>(), 6.82, 0.05);
  EXPECT_GT(linesOf(folder / "a.csv").size(), 100u);
}

TEST(Anatomy, TakesThreeLengths)
{
  const TemporaryFolder folder;
  const auto outcome = cli({"anatomy", "--st-length-mm", "33.1", "--rw-width-mm", "2.0",
                            "--rw-height-mm", "1.7", "--json", folder / "a.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(contentOf(folder / "a.json"));
  EXPECT_NEAR(json["st_length_mm"].get<double>(), 33.1, 0.01);
  EXPECT_EQ(json["given"]["rw_width_mm"], 2.0);
}

TEST(Anatomy, MeasuresTheMeanCochlea)
{
  const TemporaryFolder folder;
  const auto outcome = cli({"anatomy", "--preset", "mean", "--json", folder / "a.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("CC BY 4.0"), std::string::npos);
  const auto json = nlohmann::json::parse(contentOf(folder / "a.json"));
  // measured on the published solid (Froehlich et al. 2024)
  EXPECT_EQ(json["anatomy"], "mean");
  EXPECT_NEAR(json["A_mm"].get<double>(), 9.53, 0.01);
  EXPECT_NEAR(json["B_mm"].get<double>(), 6.82, 0.01);
  EXPECT_NE(json["credit"].get<std::string>().find("10.1371/journal.pone.0295121"),
            std::string::npos);
}

TEST(Anatomy, MeasuresClarksCochlea)
{
  const TemporaryFolder folder;
  const auto outcome = cli({"anatomy", "--preset", "clark", "--json", folder / "a.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(contentOf(folder / "a.json"));
  EXPECT_NEAR(json["turns"].get<double>(), 2.5, 1e-6);  // 10.3 to 910.3 degrees
}

TEST(Anatomy, BuildsAPatientFromTheBasalTurn)
{
  const TemporaryFolder folder;
  const auto outcome = cli(
      {"anatomy", "--a-mm", "8.2", "--b-mm", "6.4", "--h-mm", "3.7", "--json", folder / "a.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(contentOf(folder / "a.json"));
  EXPECT_EQ(json["anatomy"], "mean");
  EXPECT_EQ(json["given"]["a_mm"], 8.2);
  EXPECT_NEAR(json["A_mm"].get<double>(), 8.2, 0.02);
  EXPECT_NEAR(json["B_mm"].get<double>(), 6.4, 0.02);
  EXPECT_NEAR(json["H_mm"].get<double>(), 3.7, 0.02);
  // (8.2 - 9.23) / 0.428 = -2.4 standard deviations
  EXPECT_NE(outcome.out.find("2.4 standard deviations below"), std::string::npos) << outcome.out;
}

TEST(Anatomy, DrawsTheSamePatientWithTheSameSeed)
{
  const TemporaryFolder folder;
  for (const char* file : {"a.json", "b.json"})
    ASSERT_EQ(cli({"anatomy", "--sample", "7", "--json", folder / file}).status, 0);
  EXPECT_EQ(contentOf(folder / "a.json"), contentOf(folder / "b.json"));
  const auto json = nlohmann::json::parse(contentOf(folder / "a.json"));
  EXPECT_EQ(json["label"], "sample 7");
  EXPECT_NEAR(json["A_mm"].get<double>(), json["given"]["a_mm"].get<double>(), 0.02);
  expectUsageError(cli({"anatomy", "--sample", "many"}), "--sample");
}

TEST(Anatomy, RefusesADiameterThatNoCochleaHas)
{
  expectRefusal(cli({"anatomy", "--a-mm", "12", "--b-mm", "6.8"}), "6.5 standard deviations above");
  expectUsageError(cli({"anatomy", "--a-mm", "9"}), "--b-mm");
}

/// How often a text occurs.
std::size_t countOf(const std::string& text, const std::string& word)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
    ++count;
  return count;
}

/// The number of triangles that a file states or lists.
std::size_t trianglesIn(const std::string& content, const std::string& ending)
{
  const auto after = [&](const std::string& word) {
    const std::size_t at = content.find(word);
    return at == std::string::npos ? 0ul : std::stoul(content.substr(at + word.size(), 12));
  };
  if (ending == "stl") return (content.size() - 84) / 50;  // binary: 84 bytes and 50 per triangle
  if (ending == "ply") return after("element face ");
  if (ending == "vtp") return after("NumberOfPolys=\"");
  if (ending == "obj") return countOf(content, "\nf ");
  return countOf(content, ", -1");  // VRML: the end of a face
}

TEST(Anatomy, WritesTheSameTrianglesInEveryFormat)
{
  const TemporaryFolder folder;
  std::size_t triangles = 0;
  for (const char* ending : {"stl", "ply", "obj", "wrl", "vtp"}) {
    const auto file = folder / (std::string("scala.") + ending);
    const auto outcome = cli({"anatomy", "--patient", "small", "--surface", file});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const std::size_t found = trianglesIn(contentOf(file), ending);
    if (triangles == 0) triangles = found;
    EXPECT_GT(found, 1000u) << file;
    EXPECT_EQ(found, triangles) << file;
  }
}

TEST(Anatomy, WritesEachPart)
{
  const TemporaryFolder folder;
  std::set<std::size_t> sizes;
  for (const char* part : {"scala", "membrane", "vestibuli"}) {
    const auto file = folder / (std::string(part) + ".stl");
    const auto outcome = cli({"anatomy", "--patient", "small", "--surface", file, "--part", part});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_GT(trianglesIn(contentOf(file), "stl"), 100u) << part;
    sizes.insert(trianglesIn(contentOf(file), "stl"));
  }
  EXPECT_GE(sizes.size(), 2u);  // the membrane is no tube
}

TEST(Anatomy, WritesTheHapticSurfaceAndSaysHowFarItIsOff)
{
  const TemporaryFolder folder;
  const auto outcome =
      cli({"anatomy", "--preset", "published", "--surface", folder / "fine.stl", "--haptic-surface",
           folder / "coarse.stl", "--json", folder / "a.json"});
  if (isRefusedWithoutVtk(outcome)) GTEST_SKIP() << "this build has no VTK";
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(contentOf(folder / "a.json"));
  // a binary STL has 84 bytes and 50 per triangle
  const auto triangles = [&](const char* name) {
    return (contentOf(folder / name).size() - 84) / 50;
  };
  EXPECT_EQ(json["haptic_surface_triangles"], triangles("coarse.stl"));
  EXPECT_NEAR(static_cast<double>(triangles("coarse.stl")),
              0.05 * static_cast<double>(triangles("fine.stl")), 4.0);
  const double mean = json["haptic_surface_deviation_mean_mm"];
  const double p95 = json["haptic_surface_deviation_p95_mm"];
  const double maximum = json["haptic_surface_deviation_max_mm"];
  EXPECT_GT(mean, 0.0);
  EXPECT_LT(mean, p95);
  EXPECT_LT(p95, maximum);
  EXPECT_LT(maximum, 0.5);
}

TEST(Anatomy, ReadsItsOwnShapesAgain)
{
  const TemporaryFolder folder;
  ASSERT_EQ(cli({"anatomy", "--preset", "published", "--json", folder / "built.json"}).status, 0);
  const auto built = nlohmann::json::parse(contentOf(folder / "built.json"));
  for (const char* ending : {"stl", "ply", "vtp"}) {
    const auto file = folder / (std::string("scala.") + ending);
    ASSERT_EQ(cli({"anatomy", "--preset", "published", "--surface", file}).status, 0);
    const auto outcome = cli({"anatomy", "--import", file, "--json", folder / "read.json",
                              "--surface", folder / "again.stl"});
    if (isRefusedWithoutVtk(outcome)) GTEST_SKIP() << "this build has no VTK";
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto read = nlohmann::json::parse(contentOf(folder / "read.json"));
    for (const char* key : {"A_mm", "B_mm", "H_mm"})
      EXPECT_NEAR(read[key].get<double>(), built[key].get<double>(), 0.03) << key << ", " << ending;
    EXPECT_NEAR(read["turns"].get<double>(), built["turns"].get<double>(), 0.01);
    EXPECT_EQ(read["side"], "right");
    EXPECT_EQ(read["anatomy"], "imported");
    EXPECT_GT(contentOf(folder / "again.stl").size(), 100'000u);
  }
}

/// A copy of a binary STL file, stretched along the modiolar axis.
void stretchAlongAxis(const std::filesystem::path& from, const std::filesystem::path& to,
                      float factor)
{
  std::string bytes = contentOf(from);
  constexpr std::size_t header = 84, triangle = 50;
  for (std::size_t begin = header; begin + triangle <= bytes.size(); begin += triangle)
    for (std::size_t corner = 1; corner <= 3; ++corner) {
      const std::size_t place = begin + 12 * corner + 8;
      float z = 0.0f;
      std::memcpy(&z, &bytes[place], sizeof z);
      z *= factor;
      std::memcpy(&bytes[place], &z, sizeof z);
    }
  std::ofstream(to, std::ios::binary) << bytes;
}

TEST(Anatomy, WarnsOfAnImportedShapeThatNoCochleaHas)
{
  if (!PERILYMPH_HAS_VTK) GTEST_SKIP() << "this build has no VTK";
  const TemporaryFolder folder;
  const auto file = folder / "scala.stl";
  ASSERT_EQ(cli({"anatomy", "--preset", "mean", "--surface", file}).status, 0);
  for (const auto& [factor, isUnusual] : {std::pair{1.0f, false}, {0.5f, true}, {2.2f, true}}) {
    stretchAlongAxis(file, folder / "stretched.stl", factor);
    const auto outcome =
        cli({"anatomy", "--import", folder / "stretched.stl", "--json", folder / "read.json"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto json = nlohmann::json::parse(contentOf(folder / "read.json"));
    const auto& warnings = json["warnings"];
    EXPECT_EQ(json["flags"],
              isUnusual ? nlohmann::json{"unusual_proportions"} : nlohmann::json::array());
    EXPECT_EQ(outcome.out.find("B does not fit A, or H is beyond") != std::string::npos, isUnusual);
    bool isWarned = false;
    for (const auto& warning : warnings)
      isWarned = isWarned || warning.get<std::string>().find("H is ") == 0;
    EXPECT_EQ(isWarned, isUnusual) << factor << ": " << warnings;
    EXPECT_EQ(outcome.out.find("H is ") != std::string::npos, isUnusual) << outcome.out;
  }
}

TEST(Anatomy, RefusesSurfacesThatAreNoScala)
{
  if (!PERILYMPH_HAS_VTK) GTEST_SKIP() << "this build has no VTK";
  const TemporaryFolder folder;
  expectRefusal(cli({"anatomy", "--import", folder / "none.stl"}), "there is no such file");
  for (const char* ending : {"stl", "ply", "vtp"}) {
    const auto file = folder / (std::string("text.") + ending);
    std::ofstream(file) << "ply\nno surface\n";
    expectRefusal(cli({"anatomy", "--import", file}), "not a whole");
  }
  std::ofstream(folder / "a.docx") << "x";
  expectRefusal(cli({"anatomy", "--import", folder / "a.docx"}), ".stl, .ply or .vtp");

  // truncated shapes
  for (const char* ending : {"stl", "ply", "vtp"}) {
    const std::string file = folder / (std::string("whole.") + ending);
    ASSERT_EQ(cli({"anatomy", "--preset", "published", "--surface", file}).status, 0);
    const std::string whole = contentOf(file);
    const std::string half = folder / (std::string("half.") + ending);
    std::ofstream(half, std::ios::binary) << whole.substr(0, whole.size() / 2);
    expectRefusal(cli({"anatomy", "--import", half}), "not a whole");
  }

  // a membrane is no scala tympani
  ASSERT_EQ(cli({"anatomy", "--preset", "published", "--part", "membrane", "--surface",
                 folder / "membrane.ply"})
                .status,
            0);
  expectRefusal(cli({"anatomy", "--import", folder / "membrane.ply"}), "scala tympani");
  expectRefusal(cli({"anatomy", "--import", folder / "whole.stl", "--sections", folder / "s.csv"}),
                "--sections");
}

TEST(Anatomy, MirrorsAnImportedLeftEar)
{
  const TemporaryFolder folder;
  std::ofstream(folder / "right.toml")
      << "label = \"r\"\nside = \"right\"\nst_length_mm = 33.0\nrw_width_mm = 1.9\n"
         "rw_height_mm = 1.8\n";
  std::ofstream(folder / "left.toml")
      << "label = \"l\"\nside = \"left\"\nst_length_mm = 33.0\nrw_width_mm = 1.9\n"
         "rw_height_mm = 1.8\n";
  for (const char* side : {"right", "left"})
    ASSERT_EQ(cli({"anatomy", "--patient", folder / (std::string(side) + ".toml"), "--surface",
                   folder / (std::string(side) + ".obj")})
                  .status,
              0);
  const auto corners = [](const std::filesystem::path& file) {
    std::vector<std::array<double, 3>> points;
    for (const std::string& line : linesOf(file)) {
      std::array<double, 3> p{};
      if (std::sscanf(line.c_str(), "v %lf %lf %lf", &p[0], &p[1], &p[2]) == 3) points.push_back(p);
    }
    return points;
  };
  const auto right = corners(folder / "right.obj");
  const auto left = corners(folder / "left.obj");
  ASSERT_EQ(right.size(), left.size());
  ASSERT_GT(right.size(), 100u);
  for (std::size_t i = 0; i < right.size(); ++i) {
    EXPECT_EQ(left[i][0], right[i][0]);
    EXPECT_EQ(left[i][1], -right[i][1]);
    EXPECT_EQ(left[i][2], right[i][2]);
  }
}

TEST(Anatomy, LeavesNothingWhereOneFileIsRefused)
{
  const TemporaryFolder folder;
  const std::string json = folder / "a.json";
  expectRefusal(
      cli({"anatomy", "--preset", "published", "--surface", folder / "a.docx", "--json", json}),
      ".stl");
  EXPECT_EQ(namesIn(folder.path()), std::vector<std::string>{});
}

TEST(Anatomy, RefusesImpossiblePatients)
{
  expectRefusal(
      cli({"anatomy", "--st-length-mm", "60", "--rw-width-mm", "2", "--rw-height-mm", "2"}),
      "between 25 and 45");
  expectRefusal(cli({"anatomy", "--patient", "nobody"}), "small");
  const TemporaryFolder folder;
  std::ofstream(folder / "p.toml") << "st_length_mm = 33.0\nrw_width_mm = \"wide\"\n";
  expectRefusal(cli({"anatomy", "--patient", folder / "p.toml"}), "p.toml:2");
}

TEST(AnatomyCommand, NamesResourcesThatAreNotItsOwn)
{
  const TemporaryFolder folder;
  fs::create_directory_symlink(fs::canonical(resource("resources")), folder / "resources");
  fs::create_directory_symlink(fs::canonical(resource("plugins")), folder / "plugins");
  ProgramCall call = cliCall({"anatomy", "--preset", "published", "--json", folder / "a.json"});
  const auto own = run(call);
  ASSERT_EQ(own.status, 0) << own.err;
  EXPECT_EQ(own.err, "");
  EXPECT_THAT(contentOf(folder / "a.json"), testing::Not(testing::HasSubstr("PERILYMPH")));
  call.environment = {{"PERILYMPH_RESOURCES", folder.path().string()}};
  const auto other = run(call);
  ASSERT_EQ(other.status, 0) << other.err;
  EXPECT_THAT(other.err, testing::HasSubstr("PERILYMPH_RESOURCES is set"));
  EXPECT_THAT(other.err, testing::HasSubstr(folder.path().string()));
  EXPECT_THAT(contentOf(folder / "a.json"), testing::HasSubstr("with PERILYMPH_RESOURCES\""));
}

}  // namespace
}  // namespace perilymph::test
