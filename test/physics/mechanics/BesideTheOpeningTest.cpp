// SPDX-License-Identifier: BSD-3-Clause

// An array that misses the opening is stopped by the bone beside it.

#include <gtest/gtest.h>

#include <cmath>

#include "TestRod.h"
#include "lumen/PlainLumens.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

using test::RodSpec;
using test::TestRod;

/// A short stout rod above a tube of 1 mm radius, its tip 0.5 mm outside.
RodSpec above()
{
  RodSpec spec;
  spec.length = 5e-3;
  spec.bending = 1e-5;
  spec.wallStiffness = 1e3;
  spec.startInside = -0.5e-3;
  return spec;
}

std::shared_ptr<const anatomy::Lumen> tube()
{
  return std::make_shared<anatomy::StraightTube>(1e-3);
}

TEST(ArrayBesideTheOpening, IsHeldUpByTheBoneAsBySprings)
{
  // 2 mm beside the axis there is only bone below; the rod itself hardly shortens.
  TestRod rod(tube(), above());
  const Eigen::Vector3d& out = rod.model().entry.out_W;
  rod.move(2e-3 * rod.model().entry.outward_W, 5e-3);
  rod.move(-0.6e-3 * out, 1e-3, 0.2);

  const double onset = rod.model().parts.wall.lining.si();
  const double expected = rod.model().wallStiffness.back() * (0.1e-3 - 0.5 * onset);
  EXPECT_NEAR(rod.readings().axialForce, expected,
              test::tolerance(0.02 * expected, "the rod yields, too"));
}

TEST(ArrayBesideTheOpening, GivesBackTheWorkOfPressingItOnTheBone)
{
  RodSpec spec = above();
  spec.friction = 0.0;
  TestRod rod(tube(), spec);
  const Eigen::Vector3d& out = rod.model().entry.out_W;
  rod.move(2e-3 * rod.model().entry.outward_W, 5e-3, 0.1);
  double work = 0.0, pressed = 0.0;
  for (const double way : {-0.7e-3, 0.7e-3})
    for (int i = 0; i < 700; ++i) {
      rod.drive().handPosition_W += way / 700 * out;
      rod.tick();
      work -= rod.readings().handForce_W.dot(way / 700 * out);
      pressed = std::max(pressed, work);
    }
  EXPECT_GT(pressed, 1e-6);
  EXPECT_GE(work, -1e-9) << "energy out of nothing";
  EXPECT_LE(work, test::tolerance(0.1 * pressed, "damping")) << "and none is kept";
}

TEST(ArrayBesideTheOpening, IsNotDrawnBackOnceItHasSlidOffTheEdge)
{
  // Pressed a little way in at the very edge, then drawn out over the bone: a plane without
  // friction has no force along it, however deep in bone the tube's wall would see the tip.
  TestRod rod(tube(), above());
  const Eigen::Vector3d& out = rod.model().entry.out_W;
  const Eigen::Vector3d& aside = rod.model().entry.outward_W;
  rod.move(1.1e-3 * aside, 5e-3);
  rod.move(-0.55e-3 * out, 1e-3);
  rod.move(0.9e-3 * aside, 5e-3, 0.2);
  EXPECT_NEAR(rod.readings().handForce_W.dot(aside), 0.0,
              test::tolerance(1e-5, "what is left of the motion"));
}

TEST(ArrayBesideTheOpening, FindsTheOpeningOnceItIsAboveIt)
{
  TestRod rod(tube(), above());
  const Eigen::Vector3d& out = rod.model().entry.out_W;
  const Eigen::Vector3d& aside = rod.model().entry.outward_W;
  rod.move(2e-3 * aside, 5e-3);
  rod.move(-0.6e-3 * out, 1e-3);
  rod.move(0.6e-3 * out, 1e-3);
  rod.move(-2e-3 * aside, 5e-3, 0.1);
  rod.move(-2.5e-3 * out, 5e-3, 0.1);
  EXPECT_NEAR(rod.readings().depth, 2e-3, test::tolerance(1e-6, "the hand's way, summed"));
  EXPECT_NEAR(rod.readings().handForce_W.norm(), 0.0,
              test::tolerance(1e-5, "what is left of the motion"));
}

}  // namespace
}  // namespace perilymph
