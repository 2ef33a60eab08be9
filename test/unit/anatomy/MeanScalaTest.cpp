// SPDX-License-Identifier: BSD-3-Clause

// The mean scala tympani against the numbers measured on the published solid (Froehlich et al.
// 2024), and against the solid itself where it is available.

#include "perilymph/anatomy/MeanScala.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "ReferenceSolid.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/test/TemporaryFolder.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::anatomy {
namespace {

std::shared_ptr<const ScalaTympani> mean()
{
  static const auto built = buildMean(millimeters(1));
  if (!built) throw std::runtime_error(built.error().message);
  return *built;
}

/// The angles of the published solid's sections [rad].
std::vector<double> measuredAngles()
{
  const auto sections = loadMeasuredSections();
  if (!sections) throw std::runtime_error(sections.error().message);
  std::vector<double> angles;
  for (const MeasuredSection& section : *sections) angles.push_back(section.angle);
  return angles;
}

/// Length along the outermost points of the measured sections, with radius and height linear in the
/// angle between sections, as the numbers below were computed [m].
double outerWallLength(const ScalaTympani& scala, double last)
{
  const auto outermost = [&](double angle) {
    Eigen::Vector2d best(0.0, 0.0);
    for (int k = 0; k < 720; ++k) {
      const Eigen::Vector3d wall = scala.wall_W(angle, 2.0 * pi * k / 720);
      const double r = std::hypot(wall.x(), wall.y());
      if (r > best.x()) best = {r, wall.z()};
    }
    return best;
  };
  const std::vector<double> angles = measuredAngles();
  double length = 0.0;
  for (std::size_t i = 1; i < angles.size() && angles[i] < last + 1e-6; ++i) {
    const Eigen::Vector2d a = outermost(angles[i - 1]);
    const Eigen::Vector2d b = outermost(angles[i]);
    constexpr int pieces = 50;
    for (int k = 0; k < pieces; ++k) {
      const double r = a.x() + (b.x() - a.x()) * (k + 0.5) / pieces;
      const double around = r * (angles[i] - angles[i - 1]) / pieces;
      length += std::hypot(around, (b - a).norm() / pieces);
    }
  }
  return length;
}

TEST(MeanScala, HasTheMeasuredOuterWall)
{
  EXPECT_NEAR(outerWallLength(*mean(), degrees(360).si()), 22.82e-3, 0.05e-3);
  EXPECT_NEAR(outerWallLength(*mean(), degrees(675).si()), 33.04e-3, 0.05e-3);
}

TEST(MeanScala, HasTheMeasuredAAndB)
{
  const auto outer = [](double angle_deg) {
    return mean()->section(degrees(angle_deg).si()).outerRadius;
  };
  EXPECT_NEAR(outer(0) + outer(180), 9.53e-3, 0.01e-3);
  EXPECT_NEAR(outer(90) + outer(270), 6.82e-3, 0.01e-3);
}

TEST(MeanScala, HasTheMeasuredVolume)
{
  // Pappus: the volume swept by a section is the integral of r over its area
  const auto swept = [](double angle) {
    double sum = 0.0;
    Eigen::Vector2d before;
    for (int k = 0; k <= 360; ++k) {
      const Eigen::Vector3d wall = mean()->wall_W(angle, 2.0 * pi * k / 360);
      const Eigen::Vector2d now(std::hypot(wall.x(), wall.y()), wall.z());
      if (k > 0)
        sum += (now.y() - before.y()) *
               (before.x() * before.x() + before.x() * now.x() + now.x() * now.x()) / 6.0;
      before = now;
    }
    return sum;
  };
  double volume = 0.0;
  const double step = degrees(0.5).si();
  for (double angle = 0.5 * step; angle < degrees(675).si(); angle += step)
    volume += swept(angle) * step;
  EXPECT_NEAR(volume, 33.4e-9, 0.7e-9);
}

TEST(MeanScala, HasTheMeasuresOfEverySection)
{
  // Fourier series of four harmonics: 6 um from the outlines on average, 24 um at most
  const double series = test::tolerance(0.015e-3, "four harmonics and rounding");
  const auto sections = loadMeasuredSections();
  ASSERT_TRUE(sections);
  ASSERT_EQ(sections->size(), 31u);
  for (const MeasuredSection& measured : *sections) {
    const Section section = mean()->section(measured.angle);
    const double angle_deg = inDegrees(radians(measured.angle));
    EXPECT_NEAR(section.innerRadius, measured.innerRadius, series) << angle_deg;
    EXPECT_NEAR(section.outerRadius, measured.outerRadius, series) << angle_deg;
    EXPECT_NEAR(section.roofHeight - section.floorHeight, measured.height, series) << angle_deg;
    EXPECT_NEAR(section.area, measured.area, 0.01 * measured.area) << angle_deg;
  }
}

TEST(MeanScala, LiesOnTheSolidBetweenItsSections)
{
  struct Row {
    double angle_deg, inner_mm, outer_mm, floor_mm, roof_mm;
  };
  // the published solid cut halfway between the fitted sections
  for (const Row& row :
       {Row{11.5, 3.459, 5.769, -0.623, 0.955}, Row{34, 2.705, 5.011, -0.668, 0.605},
        Row{56.5, 2.266, 4.474, -0.812, 0.463}}) {
    const Section section = mean()->section(degrees(row.angle_deg).si());
    const double series = test::tolerance(0.025, "four harmonics, splines between sections");
    EXPECT_NEAR(section.innerRadius * 1e3, row.inner_mm, series) << row.angle_deg;
    EXPECT_NEAR(section.outerRadius * 1e3, row.outer_mm, series) << row.angle_deg;
    EXPECT_NEAR(section.floorHeight * 1e3, row.floor_mm, series) << row.angle_deg;
    EXPECT_NEAR(section.roofHeight * 1e3, row.roof_mm, series) << row.angle_deg;
  }
  for (const auto& [angle_deg, outer_mm] :
       {std::pair{101.5, 3.913}, {191.5, 3.232}, {304.0, 2.749}})
    EXPECT_NEAR(mean()->section(degrees(angle_deg).si()).outerRadius * 1e3, outer_mm, 0.01)
        << angle_deg;
}

TEST(MeanScala, RisesAgainInHeightUntil450Degrees)
{
  const auto height = [](double angle_deg) {
    const Section section = mean()->section(degrees(angle_deg).si());
    return section.roofHeight - section.floorHeight;
  };
  EXPECT_LT(height(203), height(360));
  EXPECT_LT(height(360), height(450));
  EXPECT_LT(height(560), height(450));
  EXPECT_NEAR(height(203), 0.93e-3, 0.02e-3);
  EXPECT_NEAR(height(450), 1.08e-3, 0.02e-3);
}

TEST(MeanScala, DipsBeforeItClimbs)
{
  const auto height = [](double angle_deg) {
    return mean()->center_W(degrees(angle_deg).si()).z();
  };
  EXPECT_NEAR(height(23), 0.10e-3, 0.02e-3);
  EXPECT_NEAR(height(68), -0.23e-3, 0.02e-3);
  EXPECT_GT(height(135), height(68));
}

TEST(MeanScala, HasAnOrganOfCortiPathOf31Millimeters)
{
  // Schurzig et al. 2021, up to 675 degrees; interpolated like the outer wall above
  const SectionTables& tables = mean()->tables();
  std::vector<double> angles = measuredAngles();
  double length = 0.0;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    const auto at = [&](double angle) {
      const auto k = static_cast<std::size_t>(angle / tables.step);
      const double fraction = angle / tables.step - static_cast<double>(k);
      const double radius =
          tables.planRadius[k] + fraction * (tables.planRadius[k + 1] - tables.planRadius[k]);
      return Eigen::Vector2d(radius, mean()->wall_W(angle, 0.0).z());
    };
    const Eigen::Vector2d a = at(angles[i - 1]);
    const Eigen::Vector2d b = at(angles[i]);
    length += std::hypot(0.5 * (a.x() + b.x()) * (angles[i] - angles[i - 1]), (b - a).norm());
  }
  EXPECT_NEAR(length, 31.0e-3, 0.15e-3);
}

TEST(MeanScala, GoesOnTo900DegreesAndNarrows)
{
  EXPECT_NEAR(mean()->lastAngle().si(), degrees(900).si(), 1e-9);
  double outer = mean()->section(degrees(675).si()).outerRadius;
  double center = mean()->center_W(degrees(675).si()).z();
  for (double angle_deg = 690; angle_deg <= 900; angle_deg += 15) {
    const Section section = mean()->section(degrees(angle_deg).si());
    EXPECT_LT(section.outerRadius, outer) << angle_deg;
    EXPECT_GT(section.centerHeight, center) << angle_deg;
    EXPECT_GT(section.innerRadius, 0.0) << angle_deg;
    outer = section.outerRadius;
    center = section.centerHeight;
  }
}

TEST(MeanScala, EndsInARoundedCap)
{
  const auto area = [](double angle_deg) { return mean()->section(degrees(angle_deg).si()).area; };
  // truncated where the ellipsoid has shrunk to 31 %, a tenth of the area
  EXPECT_LT(area(900), 0.12 * area(850));
  EXPECT_GT(area(875), 0.6 * area(850));
}

/// Uses another folder of resources until it is destroyed.
class OtherResources {
public:
  explicit OtherResources(const std::string& sections)
  {
    std::filesystem::create_directories(folder_ / "resources" / "anatomy");
    std::ofstream(folder_ / "resources" / "anatomy" / "mean-scala-tympani.toml") << sections;
    if (const char* given = std::getenv(variable)) before_ = given;
    ::setenv(variable, folder_.path().c_str(), 1);
  }
  ~OtherResources()
  {
    if (before_)
      ::setenv(variable, before_->c_str(), 1);
    else
      ::unsetenv(variable);
  }

private:
  static constexpr const char* variable = "PERILYMPH_RESOURCES";
  const test::TemporaryFolder folder_;
  std::optional<std::string> before_;
};

TEST(MeasuredSections, ThatAreSpoiledAreRefusedWithASentence)
{
  const std::string head = "label = 'x'\nsource = 'y'\n";
  const std::string measures =
      "[[section]]\nangle_deg = 0.0\ninner_mm = 4\nouter_mm = 6\nheight_mm = 1\narea_mm2 = 2\n"
      "inscribed_mm = 1\n";
  const auto error = [](const std::string& text) {
    const OtherResources other(text);
    const auto built = buildMean(millimeters(1));
    return built ? "built" : built.error().message;
  };
  EXPECT_NE(error(head).find("at least 8"), std::string::npos);
  EXPECT_NE(error(head + measures + "real_mm = [1, 2]\n").find("real_mm"), std::string::npos);
  EXPECT_NE(error(head + measures +
                  "real_mm = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10]\nimaginary_mm = "
                  "[1, 2, 3, 4, 5, 6, 7, 8, 9]\n")
                .find("it must have 9"),
            std::string::npos);
  EXPECT_NE(error("[[section").find("TOML"), std::string::npos);
}

class PublishedSolid : public testing::Test {
protected:
  void SetUp() override
  {
    if (!test::ReferenceSolid::isThere()) GTEST_SKIP() << test::ReferenceSolid::whyNot();
  }

  static void expectNear(std::vector<double> distances)
  {
    ASSERT_GT(distances.size(), 1000u);
    std::sort(distances.begin(), distances.end());
    const double sum = std::accumulate(distances.begin(), distances.end(), 0.0);
    const double average = sum / static_cast<double>(distances.size());
    const double high = distances[distances.size() * 95 / 100];
    RecordProperty("mean_um", std::to_string(average * 1e6));
    RecordProperty("p95_um", std::to_string(high * 1e6));
    EXPECT_LE(average, 30e-6);
    EXPECT_LE(high, 80e-6);
  }
};

TEST_F(PublishedSolid, IsNearTheModelEverywhere)
{
  const test::ReferenceSolid solid;
  std::vector<double> distances;
  for (const Eigen::Vector3d& point : solid.points()) {
    const double polar = std::atan2(point.y(), point.x());
    double nearest = 1e9;
    bool isEnd = false;  // the flat faces at 0 and 675 degrees are no wall
    for (int turn = 0; turn < 3; ++turn) {
      const double angle = polar + 2.0 * pi * turn;
      isEnd = isEnd || std::fabs(angle) < 0.005 || std::fabs(angle - degrees(675).si()) < 0.005;
      if (angle < 0.0 || angle > degrees(675).si()) continue;
      // the distance to the outline in the same half-plane, an upper bound of the true one
      for (int k = 0; k < 360; ++k)
        nearest = std::min(nearest, (mean()->wall_W(angle, 2.0 * pi * k / 360) - point).norm());
    }
    if (!isEnd) distances.push_back(nearest);
  }
  expectNear(std::move(distances));
}

TEST_F(PublishedSolid, IsReachedByTheModelEverywhere)
{
  const test::ReferenceSolid solid;
  std::vector<double> distances;
  for (double angle_deg = 0.5; angle_deg < 675; angle_deg += 2.5)
    for (int k = 0; k < 60; ++k)
      distances.push_back(
          solid.distance(mean()->wall_W(degrees(angle_deg).si(), 2.0 * pi * k / 60)));
  expectNear(std::move(distances));
}

/// A folder of resources whose mean scala tympani is another text, while it exists.
class OtherSections {
public:
  explicit OtherSections(const std::string& text)
  {
    std::filesystem::create_directories(folder_ / "resources/anatomy");
    std::ofstream(folder_ / "resources/anatomy/mean-scala-tympani.toml") << text;
    ::setenv("PERILYMPH_RESOURCES", folder_.path().c_str(), 1);
  }
  ~OtherSections() { ::unsetenv("PERILYMPH_RESOURCES"); }

private:
  test::TemporaryFolder folder_;
};

/// The shipped text with one coefficient of a section, harmonics -4 to 4, multiplied by a factor.
std::string withCoefficient(int section, const std::string& key, int harmonic, double factor)
{
  std::string text = *readWhole(resource("resources/anatomy/mean-scala-tympani.toml"));
  std::size_t at = 0;
  for (int i = 0; i <= section; ++i) at = text.find(key + " = [", at) + key.size() + 4;
  for (int k = -4; k < harmonic; ++k) at = text.find(',', at) + 1;
  const std::size_t length = text.find_first_of(",]", at) - at;
  const double value = std::stod(text.substr(at, length));
  return text.replace(at, length, " " + std::to_string(factor * value));
}

TEST(MeasuredSections, WithADamagedCoefficientAreRefused)
{
  // Those that a search over all found to matter: size, place, tilt and shape of a section.
  const std::tuple<int, const char*, int> coefficients[] = {
      {0, "real_mm", 0},  {3, "real_mm", 1},       {7, "imaginary_mm", 1}, {12, "real_mm", -1},
      {20, "real_mm", 0}, {25, "imaginary_mm", 0}, {30, "real_mm", 1},     {3, "real_mm", -1}};
  for (const auto& [section, key, harmonic] : coefficients)
    for (const double factor : {-1.0, 0.0, 10.0}) {
      const OtherSections damaged(withCoefficient(section, key, harmonic, factor));
      const auto sections = loadMeasuredSections();
      ASSERT_FALSE(sections) << section << " " << key << " " << harmonic << " x " << factor;
      // a size of 53 mm is already out of range
      EXPECT_THAT(sections.error().message,
                  testing::AnyOf(testing::HasSubstr("damaged"), testing::HasSubstr("between -20")));
      EXPECT_THAT(sections.error().message, testing::HasSubstr("mean-scala-tympani.toml"));
      EXPECT_FALSE(buildMean(millimeters(1)));
    }
}

}  // namespace
}  // namespace perilymph::anatomy
