// SPDX-License-Identifier: BSD-3-Clause

// The published scala tympani against the paper's numbers and the sections it is built from.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::anatomy {
namespace {

std::shared_ptr<const ScalaTympani> published() { return buildPublished({}, millimeters(1)); }

/// Length of a polyline through points of a curve over the angle [m].
template <class Curve>
double lengthOf(const Curve& curve, double from, double to)
{
  constexpr int steps = 20000;
  double length = 0.0;
  Eigen::Vector3d last = curve(from);
  for (int i = 1; i <= steps; ++i) {
    const Eigen::Vector3d next = curve(from + (to - from) * i / steps);
    length += (next - last).norm();
    last = next;
  }
  return length;
}

TEST(PublishedScala, RisesByThePublishedHeight)
{
  const auto scala = published();
  const double end = scala->lastAngle().si();
  EXPECT_NEAR(scala->center_W(end).z() - scala->center_W(0).z(), 2.56e-3, 1e-6);
}

TEST(PublishedScala, HasThePublishedLengthAlongItsPlanCurve)
{
  const auto scala = published();
  const auto& tables = scala->tables();
  double length = 0.0;
  for (std::size_t i = 1; i < tables.planRadius.size(); ++i) {
    const double angle = tables.step * static_cast<double>(i);
    const Eigen::Vector2d a(tables.planRadius[i - 1] * std::cos(angle - tables.step),
                            tables.planRadius[i - 1] * std::sin(angle - tables.step));
    const Eigen::Vector2d b(tables.planRadius[i] * std::cos(angle),
                            tables.planRadius[i] * std::sin(angle));
    length += (b - a).norm();
  }
  EXPECT_NEAR(length, 35.58e-3, test::tolerance(0.02e-3, "chords of 1.5 degrees"));
}

TEST(PublishedScala, HasTheMeasuredSectionsAtQuarterTurns)
{
  const auto scala = published();
  struct Row {
    double angle_deg, width_mm, height_mm, inner_mm;
  };
  // Froehlich et al. 2024, mean of 15: radial width, axial height, inner wall from the axis
  for (const Row& row :
       {Row{0, 1.94, 1.85, 4.30}, Row{90, 2.00, 1.18, 2.00}, Row{180, 1.94, 0.94, 1.36},
        Row{270, 1.95, 0.94, 0.88}, Row{360, 1.63, 0.98, 0.71}, Row{450, 1.57, 1.08, 0.49},
        Row{630, 1.42, 0.90, 0.10}}) {
    const Section section = scala->section(degrees(row.angle_deg).si());
    const double rounding = test::tolerance(0.01e-3, "rounded corners");
    EXPECT_NEAR(section.outerRadius - section.innerRadius, row.width_mm / 1e3, rounding)
        << row.angle_deg;
    EXPECT_NEAR(section.roofHeight - section.floorHeight, row.height_mm / 1e3, rounding)
        << row.angle_deg;
    EXPECT_NEAR(section.innerRadius, row.inner_mm / 1e3, rounding) << row.angle_deg;
  }
}

TEST(PublishedScala, HasParabolicSectionsUnderAFlatMembrane)
{
  // two parabolas and a flat roof: area = height (2 width + membrane) / 3
  const auto scala = published();
  for (const double angle_deg : {0.0, 90.0, 200.0, 400.0}) {
    const Section section = scala->section(degrees(angle_deg).si());
    const double width = section.outerRadius - section.innerRadius;
    const double height = section.roofHeight - section.floorHeight;
    const double membrane = 0.15e-3 + 0.37e-3 * degrees(angle_deg) / scala->lastAngle();
    EXPECT_NEAR(section.area, height * (2.0 * width + membrane) / 3.0,
                test::tolerance(0.01, "rounded corners") * section.area)
        << angle_deg;
  }
}

TEST(PublishedScala, WidensItsMembraneFromBaseToApex)
{
  const auto scala = published();
  const auto width = [&](double angle) {
    return (scala->membrane_W(angle, 1.0) - scala->membrane_W(angle, 0.0)).norm();
  };
  EXPECT_NEAR(width(0.0), 0.15e-3, 1e-9);
  EXPECT_NEAR(width(scala->lastAngle().si()), 0.52e-3, 1e-9);
}

TEST(PublishedScala, RisesTenDegreesAlongItsInnerWallInTheFirstTurn)
{
  const auto scala = published();
  const auto inner = [&](double angle) {
    Eigen::Vector3d wall = scala->wall_W(angle, pi);
    wall.z() = 0.0;
    return wall;
  };
  for (const double to_deg : {90.0, 180.0, 350.0}) {
    const double to = degrees(to_deg).si();
    const double rise = scala->center_W(to).z() - scala->center_W(0).z();
    EXPECT_NEAR(rise / lengthOf(inner, 0.0, to), std::tan(degrees(10).si()), 2e-3) << to_deg;
  }
}

TEST(PublishedScala, CurvesWithoutKinks)
{
  // Second differences of the center line change little from step to step, even where the blend of
  // the lead-in ends (12 degrees), where the branches of the plan curve meet (71.5 to 101.5) and
  // after one turn: there is no corner (1/step, several hundred times more) and no jump of
  // curvature. The largest change is that of the blend, where the curvature falls to zero within
  // 12 degrees.
  const auto scala = published();
  const double step = degrees(0.25).si();
  const auto second = [&](double angle) {
    return Eigen::Vector3d((scala->center_W(angle + step) - 2.0 * scala->center_W(angle) +
                            scala->center_W(angle - step)) /
                           (step * step));
  };
  const double joint = degrees(12).si();
  double last = second(degrees(1).si()).norm();
  const double greatest = 0.02;  // [m/rad^2]; the spiral itself has 20 mm at its base
  for (double angle = degrees(1.25).si(); angle < degrees(900).si(); angle += step) {
    const double now = second(angle).norm();
    ASSERT_NEAR(now, last, angle < 1.2 * joint ? 0.1 * greatest : 0.06 * last)
        << inDegrees(radians(angle));
    last = now;
  }
}

TEST(PublishedScala, ScalesWithThePatientsThreeNumbers)
{
  Patient patient;
  patient.scalaTympaniLength = millimeters(30);
  patient.roundWindowWidth = millimeters(2.1);
  patient.roundWindowHeight = millimeters(1.6);
  const auto mine = buildPublished(patient, millimeters(1));
  const auto theirs = published();
  EXPECT_NEAR(mine->lastAngle().si(), theirs->lastAngle().si(), 1e-12);
  for (const double angle_deg : {0.0, 100.0, 300.0, 600.0}) {
    const Section a = mine->section(degrees(angle_deg).si());
    const Section b = theirs->section(degrees(angle_deg).si());
    EXPECT_NEAR((a.outerRadius - a.innerRadius) / (b.outerRadius - b.innerRadius), 2.1 / 1.94,
                test::tolerance(4e-3, "tips rounded by 5 um of 2 mm"));
    EXPECT_NEAR((a.roofHeight - a.floorHeight) / (b.roofHeight - b.floorHeight), 1.6 / 1.85,
                test::tolerance(4e-3, "corners rounded by 5 um of 1 mm"));
    EXPECT_NEAR(a.innerRadius, b.innerRadius * 30.0 / 35.58, 8e-6);
  }
}

TEST(PublishedScala, OpensAtTheEndOfItsLeadIn)
{
  for (const double lead_mm : {0.0, 1.0, 3.0}) {
    const auto scala = buildPublished({}, millimeters(lead_mm));
    const Entry entry = scala->entry();
    EXPECT_NEAR((entry.origin_W - scala->center_W(0.0)).norm(), lead_mm / 1e3, 1e-9);
    // right-handed, unit, x toward the outer wall
    EXPECT_NEAR(entry.outward_W.cross(entry.vertical_W).dot(entry.out_W), 1.0, 1e-12);
    EXPECT_GT(entry.outward_W.x(), 0.0);
    // the lead-in extends the start of the center line
    const Eigen::Vector3d start = scala->center_W(1e-4) - scala->center_W(0.0);
    EXPECT_NEAR(start.normalized().dot(-entry.out_W), 1.0, 1e-6);
  }
}

}  // namespace
}  // namespace perilymph::anatomy
