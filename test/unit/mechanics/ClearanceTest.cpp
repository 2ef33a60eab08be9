// SPDX-License-Identifier: BSD-3-Clause
#include "contact/Clearance.h"

#include <gtest/gtest.h>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::mechanics {
namespace {

/// A Contour in the published cochlea, with one node that is moved to and from the wall.
class Clearance : public testing::Test {
protected:
  Clearance()
      : model_(InsertionModel::build(parts())),
        state_(*model_),
        start_(state_.position_W.size()),
        contacts_(state_.position_W.size()),
        node_(state_.position_W.size() - 2)
  {
    contacts_.reach = model_->radius;
    // from 0.1 mm away from the wall along its gradient to where it is pressed in by 5 um
    away_W_ = atDistance(state_.position_W[node_], model_->radius[node_] + 100e-6);
    pressed_W_ = atDistance(away_W_, model_->radius[node_] - 5e-6);
    start_.position_W = state_.position_W;
    start_.position_W[node_] = away_W_;
    state_.clearance[node_] = 80e-6;
  }

  static ModelParts parts()
  {
    ModelParts parts;
    parts.lumen = anatomy::buildPublished({}, millimeters(1));
    parts.array = *electrode::loadArray(resource("plugins/electrodes/cochlear/contour.toml"));
    parts.nodes = 40;
    parts.startInside = millimeters(3);
    return parts;
  }

  /// The point on the gradient through another one that is this far from the wall.
  Eigen::Vector3d atDistance(Eigen::Vector3d at_W, double distance) const
  {
    for (int i = 0; i < 20; ++i) {
      anatomy::LumenTrack track = state_.track[node_];
      anatomy::WallPoint wall;
      const double reach = 1e-3;
      model_->parts.lumen->nearestWall({&at_W, 1}, {&reach, 1}, {&track, 1}, {&wall, 1});
      at_W += (distance - wall.distance) / wall.normal_W.squaredNorm() * wall.normal_W;
    }
    return at_W;
  }

  anatomy::WallPoint wallAt(const Eigen::Vector3d& at_W)
  {
    state_.position_W[node_] = at_W;
    findWall(*model_, start_, state_, contacts_);
    return mechanics::wallAt(contacts_, node_);
  }

  std::shared_ptr<const InsertionModel> model_;
  InsertionState state_;
  StepStart start_;
  ContactSet contacts_;
  std::size_t node_;
  Eigen::Vector3d away_W_, pressed_W_;
};

TEST_F(Clearance, SeesTheWallAgainWhereATrialOfTheSameStepHadLeftIt)
{
  const anatomy::WallPoint pressed = wallAt(pressed_W_);
  ASSERT_TRUE(pressed.isNear);
  EXPECT_NEAR(pressed.distance, model_->radius[node_] - 5e-6, 1e-9);
  ASSERT_GT(contacts_.seen.trustRadius[node_], 1e-6);
  EXPECT_FALSE(wallAt(away_W_).isNear);

  const anatomy::WallPoint again = wallAt(pressed_W_ + 0.1e-9 * Eigen::Vector3d::UnitX());
  EXPECT_EQ(contacts_.seen.from_W[node_], pressed_W_);  // from what was found before
  EXPECT_TRUE(again.isNear);
  EXPECT_NEAR(again.distance, model_->radius[node_] - 5e-6, 1e-9);
  keepClearance(contacts_, state_);
  EXPECT_EQ(state_.clearance[node_], 0.0);
}

}  // namespace
}  // namespace perilymph::mechanics
