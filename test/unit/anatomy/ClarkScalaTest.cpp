// SPDX-License-Identifier: BSD-3-Clause

// Clark's scala tympani against the length and height of its source, and the numbers of the
// template spiral.

#include "sources/ClarkScala.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::anatomy {
namespace {

std::shared_ptr<const ScalaTympani> clark()
{
  static const auto built = buildClark(millimeters(1));
  if (!built) throw std::runtime_error(built.error().message);
  return *built;
}

double lengthBetween(double from_deg, double to_deg)
{
  const auto at = [](double angle_deg) {
    const SpiralPoint point = clarkSpiral(degrees(angle_deg));
    const double angle = degrees(angle_deg).si();
    return Eigen::Vector3d(point.radius * std::cos(angle), point.radius * std::sin(angle),
                           point.height);
  };
  constexpr int pieces = 100000;
  double length = 0.0;
  Eigen::Vector3d before = at(from_deg);
  for (int i = 1; i <= pieces; ++i) {
    const Eigen::Vector3d now = at(from_deg + (to_deg - from_deg) * i / pieces);
    length += (now - before).norm();
    before = now;
  }
  return length;
}

TEST(ClarkSpiral, HasItsPublishedLengthAndHeight)
{
  EXPECT_NEAR(lengthBetween(6.8, 910.3), 36.02e-3, 0.01e-3);
  EXPECT_NEAR(clarkSpiral(degrees(910.3)).height - clarkSpiral(degrees(10.3)).height, 2.750e-3,
              1e-6);
}

TEST(ClarkSpiral, HasAnAWithinThePopulation)
{
  const double a = clarkSpiral(degrees(10.3)).radius + clarkSpiral(degrees(190.3)).radius;
  EXPECT_NEAR(a, 9.23e-3, 0.43e-3);  // mean and standard deviation of 138 (Pietsch et al. 2017)
}

TEST(ClarkSpiral, HasTheTemplatesLengthsAndRadii)
{
  struct Row {
    double angle_deg, length_mm, radius_mm, height_mm;
  };
  for (const Row& row : {Row{30, 3.63, 4.667, 0.060}, Row{180, 12.92, 2.957, 0.519},
                         Row{360, 21.16, 2.285, 1.069}, Row{540, 27.49, 1.735, 1.619},
                         Row{720, 32.28, 1.296, 2.169}, Row{900, 35.85, 0.951, 2.719}}) {
    const SpiralPoint point = clarkSpiral(degrees(row.angle_deg));
    EXPECT_NEAR(point.radius * 1e3, row.radius_mm, 0.0006) << row.angle_deg;
    EXPECT_NEAR(point.height * 1e3, row.height_mm, 0.0006) << row.angle_deg;
    EXPECT_NEAR(lengthBetween(6.8, row.angle_deg) * 1e3, row.length_mm, 0.01) << row.angle_deg;
  }
}

TEST(MedialShift, IsThatOfItsTable)
{
  // Leon et al. 2014: zero near the round window, 0.40 mm at 201.5 degrees, 0.68 mm at 435.1
  EXPECT_NEAR(medialShift(degrees(10)).radius, 0.0, 1e-9);
  const double rounding = test::tolerance(0.01e-3, "rounded corners of the table");
  EXPECT_NEAR(medialShift(degrees(201.5)).radius, -0.40e-3 * std::cos(0.12), rounding);
  EXPECT_NEAR(medialShift(degrees(201.5)).height, -0.40e-3 * std::sin(0.12), rounding);
  EXPECT_NEAR(medialShift(degrees(435.1)).radius, -0.68e-3 * std::cos(0.22), rounding);
}

TEST(ClarkScala, HasItsCentersOnTheShiftedSpiral)
{
  EXPECT_NEAR(clark()->lastAngle().si(), degrees(900).si(), 1e-9);
  for (const double angle_deg : {20.0, 90.0, 200.0, 400.0, 700.0}) {
    const SpiralPoint path = clarkSpiral(degrees(angle_deg + 10.3));
    const SpiralPoint shift = medialShift(degrees(angle_deg + 10.3));
    const Section section = clark()->section(degrees(angle_deg).si());
    EXPECT_NEAR(section.centerRadius, path.radius + shift.radius, 1e-6) << angle_deg;
    EXPECT_NEAR(section.centerHeight, path.height + shift.height, 1e-6) << angle_deg;
  }
}

TEST(ClarkScala, HasTheSectionsOfTheMeanScala)
{
  const auto sections = loadMeasuredSections();
  ASSERT_TRUE(sections);
  const double series = test::tolerance(0.02e-3, "four harmonics, rounding");
  for (const MeasuredSection& measured : *sections) {
    const Section section = clark()->section(measured.angle);
    EXPECT_NEAR(section.outerRadius - section.innerRadius,
                measured.outerRadius - measured.innerRadius, series);
    EXPECT_NEAR(section.roofHeight - section.floorHeight, measured.height, series);
    EXPECT_GT(section.innerRadius, 0.0);
  }
}

}  // namespace
}  // namespace perilymph::anatomy
