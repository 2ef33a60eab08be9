// SPDX-License-Identifier: BSD-3-Clause

// The stages of a measurement that run on several threads give the bits of one, and the wall between
// them lies where the distance is 0.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "CoarseSearch.h"
#include "ImageFit.h"
#include "LumenWall.h"
#include "Region.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/test/CtPhantom.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph::ct {
namespace {

/// A phantom, and poses of its cochlea.
struct Searched {
  explicit Searched(Threads threads)
  {
    const Region region(phantom.volume, phantom.inside_P, 11.5);
    levels = findLevels(region, phantom.inside_P, 6.5);
    found = searchPoses(region, levels.bone, levels.candidates.front(), meanTemplate(family),
                        phantom.inside_P, 3.0, 3, threads, {});
  }

  test::CtPhantom phantom = test::makeCtPhantom(307, test::clinicalScan());
  MeanLumen mean = *MeanLumen::make();
  LumenShape family{mean};
  Levels levels;
  std::vector<Candidate> found;
};

TEST(TheSearchOfPoses, GivesTheSameWithOneThreadAndAll)
{
  const Searched one(Threads::one), all(Threads::all);
  ASSERT_EQ(one.found.size(), 3u);
  ASSERT_EQ(all.found.size(), 3u);
  EXPECT_GT(one.found.front().score, 0.3);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(one.found[i].score, all.found[i].score) << i;
    EXPECT_EQ(one.found[i].pose.origin_P, all.found[i].pose.origin_P) << i;
    EXPECT_EQ(one.found[i].pose.axes_PW, all.found[i].pose.axes_PW) << i;
  }
}

TEST(TheFitToVoxels, GivesTheSameWithOneThreadAndAll)
{
  const Searched searched(Threads::all);
  FitState start;
  start.pose = searched.found.front().pose;
  start.bone = searched.levels.bone;
  start.lumen = searched.levels.candidates.front();
  const ImageFit fit(searched.family, Eigen::Vector3d::UnitZ(), {0.3, 0.4});
  const auto fitted = [&](Threads threads) {
    const Observations voxels =
        observe(searched.phantom.volume, searched.family, start, 1.3, 3000, threads);
    return fit.run(start, voxels, {Freedom::everything, 8, 0.3, 1.0}, threads);
  };
  const FitResult one = fitted(Threads::one), all = fitted(Threads::all);
  EXPECT_GT(one.voxels, 1000u);
  EXPECT_EQ(one.iterations, all.iterations);
  EXPECT_EQ(one.cost, all.cost);
  EXPECT_EQ(one.misfit, all.misfit);
  EXPECT_EQ(one.state.shape, all.state.shape);
  EXPECT_EQ(one.state.pose.axes_PW, all.state.pose.axes_PW);
  EXPECT_EQ(one.state.pose.origin_P, all.state.pose.origin_P);
  EXPECT_EQ(one.covariance, all.covariance);
}

TEST(TheWallOfAShape, LiesWhereTheDistanceIsZero)
{
  const MeanLumen mean = *MeanLumen::make();
  const LumenShape family(mean);
  ShapeVector shape = LumenShape::priorMean();
  shape[shape::tilt] = 0.2;
  shape[shape::width] = -0.1;
  const ShapedLumen lumen(family, shape);
  const double first = degrees(20).si();
  const LumenWall wall = wallOf(lumen, first);
  int looked = 0;
  for (int ring = 0; ring < wall.rings(); ++ring)
    for (int k = 0; k < LumenWall::around; ++k) {
      const NearTurns near = lumen.distances(wall.at(ring, k), 1.0);
      for (int i = 0; i < near.count; ++i) {
        const TurnDistance& turn = near.turn[static_cast<std::size_t>(i)];
        if (std::fabs(turn.angle - (first + ring * LumenWall::step)) > 0.1) continue;
        ++looked;
        EXPECT_NEAR(turn.inside, 0.0,
                    test::tolerance(2e-6, "24 halvings of 3 mm, a slope of up to 1/0.3"))
            << ring << " " << k;
      }
    }
  EXPECT_EQ(looked, wall.rings() * LumenWall::around);
}

}  // namespace
}  // namespace perilymph::ct
