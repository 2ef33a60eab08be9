// SPDX-License-Identifier: BSD-3-Clause

// Positions and orientations: valid ones as scanners write them, and invalid ones.

#include "perilymph/ct/SliceStack.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace perilymph::ct {
namespace {

using testing::HasSubstr;

/// Slices of one orientation in random order, like files in a folder.
std::vector<SlicePose> slices(const Eigen::Matrix3d& axes_P, const Eigen::Vector3d& step_P,
                              int count)
{
  std::vector<SlicePose> made;
  for (int i = 0; i < count; ++i) {
    const int k = i * 7 % count;
    made.push_back({Eigen::Vector3d(-20.0, 31.5, -400.0) + k * step_P, axes_P.leftCols<2>()});
  }
  return made;
}

std::vector<SlicePose> axial(int count, double step_mm = 0.6)
{
  return slices(Eigen::Matrix3d::Identity(), {0.0, 0.0, step_mm}, count);
}

/// The slice at a position of axial(), counted from the lowest.
SlicePose& at(std::vector<SlicePose>& stack, int k)
{
  std::sort(stack.begin(), stack.end(), [](const SlicePose& a, const SlicePose& b) {
    return a.position_P->z() < b.position_P->z();
  });
  return stack[static_cast<std::size_t>(k)];
}

void expectRefusal(const std::vector<SlicePose>& stack, const std::string& says)
{
  const auto found = stackSlices(stack);
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message, HasSubstr(says));
}

TEST(SliceStack, OrdersShuffledSlicesAlongTheirNormalInEveryOrientation)
{
  Eigen::Matrix3d sagittal;
  sagittal << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  const Eigen::Matrix3d oblique =
      Eigen::AngleAxisd(0.4, Eigen::Vector3d(0.3, -0.8, 0.5).normalized()).toRotationMatrix();
  Eigen::Matrix3d feetFirst = Eigen::Matrix3d::Identity();
  feetFirst.diagonal() << -1, 1, -1;
  for (const Eigen::Matrix3d& axes : {Eigen::Matrix3d(Eigen::Matrix3d::Identity()), sagittal,
                                      Eigen::Matrix3d(oblique), feetFirst}) {
    const auto given = slices(axes, 0.6 * axes.col(2), 12);
    const auto found = stackSlices(given);
    ASSERT_TRUE(found) << found.error().message;
    ASSERT_EQ(found->places.size(), 12u);
    EXPECT_LT((found->step_P - 0.6 * axes.col(2)).norm(), 1e-9);
    EXPECT_LT((found->origin_P - Eigen::Vector3d(-20.0, 31.5, -400.0)).norm(), 1e-9);
    EXPECT_NEAR(found->planeDistance_mm(), 0.6, 1e-9);
    EXPECT_NEAR(found->tilt_deg, 0.0, 1e-6);
    for (std::size_t k = 0; k < 12; ++k) {
      const Eigen::Vector3d expected_P = found->origin_P + static_cast<double>(k) * found->step_P;
      EXPECT_LT((*given[found->places[k].front()].position_P - expected_P).norm(), 1e-9);
    }
  }
}

TEST(SliceStack, TurnsRoundSlicesThatAreNumberedAgainstTheirNormal)
{
  const auto found = stackSlices(slices(Eigen::Matrix3d::Identity(), {0, 0, -0.6}, 12));
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->step_P.z(), 0.6, 1e-9);
  EXPECT_NEAR(found->origin_P.z(), -400.0 - 11 * 0.6, 1e-9);
}

TEST(SliceStack, FindsTheGantrysTiltAndTheDistanceOfThePlanes)
{
  const double tilt = 15.0 * 3.14159265358979323846 / 180.0;
  const Eigen::Matrix3d axes = Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitX()).toRotationMatrix();
  const auto found = stackSlices(slices(axes, {0, 0, 0.6}, 20));
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_NEAR(found->tilt_deg, 15.0, 1e-6);
  EXPECT_NEAR(found->planeDistance_mm(), 0.6 * std::cos(tilt), 1e-9);
}

TEST(SliceStack, NamesMissingSlicesAndWhereTheyAre)
{
  auto oneGone = axial(57);
  at(oneGone, 0);  // in order
  oneGone.erase(oneGone.begin() + 20);
  expectRefusal(oneGone, "1 slice is missing behind slice 20 of 56 (at -388.60 mm");
  auto twoGone = axial(12);
  at(twoGone, 0);
  twoGone.erase(twoGone.begin() + 4, twoGone.begin() + 6);
  expectRefusal(twoGone, "2 slices are missing, the first behind slice 4 of 10");
  expectRefusal(twoGone, "the gap is 1.80 mm and the step elsewhere 0.60 mm");
}

TEST(SliceStack, RefusesAPositionFarBeyondEveryScan)
{
  auto far = axial(10);
  at(far, 9).position_P->z() = 1e30;
  expectRefusal(far, "1 of 10 slices have a position more than 1 km from the origin");
}

TEST(SliceStack, KeepsSlicesOfOnePlaceTogether)
{
  auto stack = axial(12);
  stack.push_back(at(stack, 5));
  const auto found = stackSlices(stack);
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->places.size(), 12u);
  EXPECT_EQ(found->places[5].size(), 2u);
  EXPECT_EQ(found->places[4].size(), 1u);
}

TEST(SliceStack, TakesNumericalNoiseAndRefusesOneHundredthOfAStep)
{
  auto rounded = axial(40);
  for (SlicePose& slice : rounded)
    slice.position_P->z() = std::round(1e3 * slice.position_P->z()) / 1e3;
  EXPECT_TRUE(stackSlices(rounded));

  auto jittered = axial(40);
  at(jittered, 17).position_P->z() += 0.007;
  expectRefusal(jittered, "slice 18 of 40");
  expectRefusal(jittered, "at most 0.006 mm is allowed");
}

TEST(SliceStack, TakesThinSlicesWhosePositionsHaveTwoDecimals)
{
  auto rounded = axial(40, 0.125);
  for (SlicePose& slice : rounded)
    slice.position_P->z() = std::round(1e2 * slice.position_P->z()) / 1e2;
  const auto stack = stackSlices(rounded);
  ASSERT_TRUE(stack) << stack.error().message;
  EXPECT_NEAR(stack->planeDistance_mm(), 0.125, 1e-4);

  at(rounded, 17).position_P->z() += 0.02;
  expectRefusal(rounded, "slice 18 of 40");
}

TEST(SliceStack, RefusesTwoHundredthsOfAMillimeterInThickSlices)
{
  auto thick = axial(40, 3.0);
  at(thick, 8).position_P->x() += 0.025;  // 0.8 % of the step, sideways
  expectRefusal(thick, "slice 9 of 40");
  auto within = axial(40, 3.0);
  at(within, 8).position_P->x() += 0.015;
  EXPECT_TRUE(stackSlices(within));
}

TEST(SliceStack, RefusesStepsThatGrow)
{
  auto stack = axial(30);
  for (SlicePose& slice : stack) {
    const double along = slice.position_P->z() + 400.0;
    slice.position_P->z() += 0.002 * along * along;
  }
  expectRefusal(stack, "not equally spaced");
}

TEST(SliceStack, RefusesSlicesWithoutPositionOrOrientation)
{
  auto stack = axial(12);
  stack[3].position_P.reset();
  stack[4].axes_P.reset();
  stack[5].position_P->y() = std::numeric_limits<double>::quiet_NaN();
  expectRefusal(stack, "3 of 12 slices have no position or orientation");
}

TEST(SliceStack, RefusesOrientationsThatAreNoneOrSeveral)
{
  auto skewed = axial(12);
  skewed[2].axes_P->col(1) = Eigen::Vector3d(0.1, 0.99, 0.0);
  expectRefusal(skewed, "1 of 12 slices have an orientation that is not");
  auto mixed = axial(12);
  mixed[7].axes_P->col(1) = Eigen::Vector3d::UnitZ();
  expectRefusal(mixed, "1 of 12 slices have another orientation");
}

TEST(SliceStack, RefusesFewerThanTwoPlaces)
{
  expectRefusal({}, "no slice");
  expectRefusal(axial(1), "a single slice");
  auto same = axial(5);
  for (SlicePose& slice : same) slice = same.front();
  expectRefusal(same, "All 5 slices lie at one position");
}

}  // namespace
}  // namespace perilymph::ct
