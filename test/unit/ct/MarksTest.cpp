// SPDX-License-Identifier: BSD-3-Clause

// Landmarks that a person places, and those of a measured cochlea.

#include "perilymph/ct/Marks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "MeasuredPhantom.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/ct/Measures.h"

namespace perilymph::ct {
namespace {

using Eigen::Vector3d;

TEST(MarkedMeasures, AreTakenAcrossTheAxisAndAlongIt)
{
  Marks marks;
  marks[Mark::roundWindow] = Vector3d(0, 0, 0);
  marks[Mark::farWall] = Vector3d(3, 4, 12);  // 5 mm across z
  marks[Mark::nearB] = Vector3d(-3, 0, 1);
  marks[Mark::farB] = Vector3d(3, 0, 1);
  marks[Mark::floor] = Vector3d(0, 0, -1);
  marks[Mark::apex] = Vector3d(1, 0, 2.5);
  const MarkedMeasures measures = measuresBetween(marks, Vector3d::UnitZ());
  EXPECT_NEAR(measures.a.value(), 5.0, 1e-12);
  EXPECT_NEAR(measures.b.value(), 6.0, 1e-12);
  EXPECT_NEAR(measures.h.value(), 3.5, 1e-12);
}

TEST(MarkedMeasures, UseTheLineFromModiolusToApexWithoutAKnownAxis)
{
  Marks marks;
  marks[Mark::roundWindow] = Vector3d(0, 0, 0);
  marks[Mark::farWall] = Vector3d(8, 0, 6);
  EXPECT_NEAR(measuresBetween(marks, std::nullopt).a.value(), 10.0, 1e-12);
  marks[Mark::modiolus] = Vector3d(4, 0, 0);
  marks[Mark::apex] = Vector3d(4, 0, 3);
  EXPECT_NEAR(measuresBetween(marks, std::nullopt).a.value(), 8.0, 1e-12);
}

TEST(MarkedMeasures, AreMissingWithoutBothEnds)
{
  Marks marks;
  marks[Mark::roundWindow] = Vector3d(0, 0, 0);
  const MarkedMeasures measures = measuresBetween(marks, Vector3d::UnitZ());
  EXPECT_FALSE(measures.a || measures.b || measures.h);
}

TEST(Marks, HaveNamesThatAreFoundAgain)
{
  for (std::size_t k = 0; k < markCount; ++k) {
    const auto mark = static_cast<Mark>(k);
    EXPECT_EQ(markNamed(nameOf(mark)), mark);
  }
  // the window's names, too
  EXPECT_EQ(markNamed("LW"), Mark::farWall);
  EXPECT_EQ(markNamed("base"), Mark::floor);
  EXPECT_EQ(markNamed("apex"), Mark::apex);
  EXPECT_EQ(markNamed("M"), Mark::modiolus);
  EXPECT_FALSE(markNamed("rw"));
}

TEST(MeasureCochlea, ProposesLandmarksThatGiveItsMeasures)
{
  const MarkedMeasures marked = measuresBetween(marksOf(measures()), measures().axis_P);
  // The wall's points are 4 degrees apart, which costs up to cos(2 deg) of a half-diameter, and the
  // round window's center lies beside the outermost point.
  EXPECT_NEAR(marked.a.value(), measures().a.value, 0.05);
  EXPECT_NEAR(marked.b.value(), measures().b.value, 0.05);
  EXPECT_NEAR(marked.h.value(), measures().h.value, 0.001);
}

TEST(MeasureCochlea, GivesAScalaThatLiesInTheMeasuredWall)
{
  // The scala tympani of the measured A, B and H, placed in the CT, touches the fitted outer wall in
  // the basal turn and crosses it nowhere by more than the fit's own errors.
  const auto scala =
      anatomy::buildMean("measured",
                         {millimeters(measures().a.value), millimeters(measures().b.value),
                          millimeters(measures().h.value)},
                         millimeters(1));
  ASSERT_TRUE(scala) << scala.error().message;
  double sum = 0.0;
  int count = 0;
  for (int angle_deg = 30; angle_deg <= 330; angle_deg += 15, ++count) {
    const double angle = degrees(angle_deg).si();
    const anatomy::Section section = (*scala)->section(angle);
    const Eigen::Vector3d outer_W(section.outerRadius * std::cos(angle),
                                  section.outerRadius * std::sin(angle), section.centerHeight);
    const Eigen::Vector3d outer_P = measures().fromAnatomy(outer_W);
    double nearest = 1e9;
    for (const Eigen::Vector3d& wall_P : measures().wall_P)
      nearest = std::min(nearest, (wall_P - outer_P).norm());
    EXPECT_LT(nearest, 0.6) << angle_deg;
    sum += nearest;
  }
  EXPECT_LT(sum / count, 0.35);
}

TEST(LandmarkContradictions, AreNamedForWhatAPersonPlacedOutsideTheInterval)
{
  CochleaMeasures measured = measures();
  EXPECT_TRUE(landmarkContradictions(measured).empty());
  const Marks proposed = marksOf(measured);
  const Vector3d out = (*proposed[Mark::farWall] - *proposed[Mark::roundWindow]).normalized();
  // what is between the proposed ends is not the fitted A to a micrometer
  const double between = measuresBetween(proposed, measured.axis_P).a.value();
  for (const double outside : {-0.6, -0.1, 0.1, 0.6})
    for (const int edge : {0, 1}) {
      const double aimed = measured.a.interval95()[std::size_t(edge)] + outside;
      const bool isOutside =
          aimed < measured.a.interval95()[0] || aimed > measured.a.interval95()[1];
      measured.marksByHand = {};
      measured.marksByHand[Mark::farWall] = *proposed[Mark::farWall] + (aimed - between) * out;
      const auto sentences = landmarkContradictions(measured);
      ASSERT_EQ(sentences.size(), isOutside ? 1U : 0U) << aimed;
      for (const auto& each : sentences)
        EXPECT_EQ(each.find("A between the landmarks is " + std::to_string(int(aimed)) + "."), 0U)
            << each;
    }
}

}  // namespace
}  // namespace perilymph::ct
