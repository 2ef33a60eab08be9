#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "Cli.h"

namespace perilymph::test {
namespace {

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

TEST(Anatomy, WritesShapesInEveryFormat)
{
  const TemporaryFolder folder;
  for (const char* ending : {"stl", "ply", "obj", "wrl", "vtp"})
    for (const char* part : {"scala", "membrane", "vestibuli"}) {
      const auto file = folder / (std::string(part) + "." + ending);
      const auto outcome =
          cli({"anatomy", "--patient", "small", "--surface", file, "--part", part});
      EXPECT_EQ(outcome.status, 0) << outcome.err;
      EXPECT_GT(contentOf(file).size(), 1000u) << file;
    }
}

TEST(Anatomy, WritesTheHapticSurfaceAndSaysHowFarItIsOff)
{
  const TemporaryFolder folder;
  const auto outcome =
      cli({"anatomy", "--preset", "published", "--surface", folder / "fine.stl", "--haptic-surface",
           folder / "coarse.stl", "--json", folder / "a.json"});
  if (outcome.err.find("has no VTK") != std::string::npos) {
    EXPECT_EQ(outcome.status, 1);
    GTEST_SKIP() << "this build has no VTK";
  }
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const auto json = nlohmann::json::parse(contentOf(folder / "a.json"));
  // a binary STL has 84 bytes and 50 a triangle
  const auto triangles = [&](const char* name) {
    return (contentOf(folder / name).size() - 84) / 50;
  };
  EXPECT_EQ(json["haptic_surface_triangles"], triangles("coarse.stl"));
  EXPECT_NEAR(static_cast<double>(triangles("coarse.stl")),
              0.05 * static_cast<double>(triangles("fine.stl")), 4.0);
  const double mean = json["haptic_surface_deviation_mean_mm"];
  const double p95 = json["haptic_surface_deviation_p95_mm"];
  const double most = json["haptic_surface_deviation_max_mm"];
  EXPECT_GT(mean, 0.0);
  EXPECT_LT(mean, p95);
  EXPECT_LT(p95, most);
  EXPECT_LT(most, 0.5);
}

TEST(Anatomy, MirrorsALeftEarAtTheDoor)
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

TEST(Anatomy, RefusesWhatIsNotThereYetAndLeavesNothing)
{
  const TemporaryFolder folder;
  const std::string json = folder / "a.json";
  expectRefusal(cli({"anatomy", "--preset", "mean", "--json", json}), "not in this version");
  expectRefusal(cli({"anatomy", "--preset", "clark", "--json", json}), "not in this version");
  expectRefusal(cli({"anatomy", "--sample", "3", "--json", json}), "--sample");
  expectRefusal(cli({"anatomy", "--import", "a.stl", "--json", json}), "--import");
  expectRefusal(cli({"anatomy", "--a-mm", "9", "--b-mm", "7", "--json", json}), "not in this");
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

}  // namespace
}  // namespace perilymph::test
