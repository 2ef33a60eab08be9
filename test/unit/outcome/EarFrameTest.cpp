// SPDX-License-Identifier: BSD-3-Clause

// Places in the ear: the turn of a point, for both ears.

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "EarFrame.h"
#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::outcome {
namespace {

Ear earOf(bool isLeft)
{
  Ear ear;
  const auto scala = anatomy::buildMean("mean", {millimeters(9.2), millimeters(6.9), std::nullopt},
                                        millimeters(1));
  if (!scala) throw std::runtime_error(scala.error().message);
  ear.scala = *scala;
  ear.measures.anatomyAxes_PW =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 3).normalized()).toRotationMatrix();
  if (isLeft) ear.measures.anatomyAxes_PW.col(1) *= -1.0;
  ear.measures.anatomyOrigin_P = {-40, 12, 80};
  return ear;
}

TEST(EarFrame, FindsTheTurnOfEveryPlaceOfTheDuctInBothEars)
{
  for (const bool isLeft : {false, true}) {
    const Ear ear = earOf(isLeft);
    const EarFrame frame(ear);
    double former = 0.0;
    for (double angle = 0.3; angle < frame.lastAngle() - 0.2; angle += 0.05) {
      const Eigen::Vector3d center_P = frame.toP(ear.scala->center_W(angle));
      const EarPlace place = frame.placeOf(center_P);
      EXPECT_NEAR(place.angle, angle, 1e-9);
      EXPECT_TRUE(place.isInside);
      EXPECT_TRUE(place.isNearDuct);
      EXPECT_GT(place.depth_mm, former);
      former = place.depth_mm;
      EXPECT_LT((frame.toP(frame.toW(center_P)) - center_P).norm(), 1e-12);
    }
  }
}

TEST(EarFrame, MeasuresTheDepthFromTheOpeningOnBothSidesOfIt)
{
  const Ear ear = earOf(false);
  const EarFrame frame(ear);
  const anatomy::Entry entry = ear.scala->entry();
  for (const double depth_mm : {-6.0, -2.0, -0.1, 0.1, 0.8}) {
    const EarPlace place = frame.placeOf(frame.toP(entry.origin_W - 1e-3 * depth_mm * entry.out_W));
    EXPECT_NEAR(place.depth_mm, depth_mm, 1e-9);
    EXPECT_EQ(place.isInside, depth_mm > 0.0);
    EXPECT_TRUE(place.isNearDuct);
  }
}

TEST(EarFrame, LeavesOutWhatIsFarFromTheDuct)
{
  const EarFrame frame(earOf(true));
  EXPECT_FALSE(frame.placeOf(frame.toP(Eigen::Vector3d(0.0, 0.0, -5e-3))).isNearDuct);
  EXPECT_FALSE(frame.placeOf(frame.toP(Eigen::Vector3d(-9e-3, 0.0, 0.0))).isNearDuct);
}

}  // namespace
}  // namespace perilymph::outcome
