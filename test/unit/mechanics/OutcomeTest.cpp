// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/mechanics/Outcome.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::mechanics {
namespace {

/// A Contour along the middle of the mean scala tympani, 20 mm deep.
struct LaidArray {
  LaidArray()
  {
    ModelParts parts;
    parts.lumen = scala;
    parts.array = *electrode::loadArray(resource("plugins/electrodes/cochlear/contour.toml"));
    model = InsertionModel::build(parts);
    // the path: straight to the round window, then along the centers of the sections
    double angle = 0.0, gone = scala->leadIn().si();
    for (int i = 0; i < model->nodes; ++i) {
      const double depth = 20e-3 - model->fromTip[static_cast<std::size_t>(i)];
      if (depth <= gone && angle == 0.0) {
        nodes_W.push_back(model->entry.origin_W - depth * model->entry.out_W);
        angles.push_back(0.0);
        continue;
      }
      while (gone < depth) {
        constexpr double step = 1e-5;  // [rad]
        gone += (scala->center_W(angle + step) - scala->center_W(angle)).norm();
        angle += step;
      }
      nodes_W.push_back(scala->center_W(angle));
      angles.push_back(angle);
    }
  }
  double angleAt(double fromTip) const
  {
    const double index = (model->fromTip.front() - fromTip) / model->spacing;
    const auto i = static_cast<std::size_t>(index);
    const double fraction = index - static_cast<double>(i);
    return (1.0 - fraction) * angles[i] + fraction * angles[i + 1];
  }
  std::vector<ContactOutcome> outcome(const Eigen::Vector3d& baseCurl_W) const
  {
    return outcomeOf(*model, ArrayShape{nodes_W, {}, baseCurl_W});
  }
  std::shared_ptr<const anatomy::ScalaTympani> scala = *anatomy::buildMean(millimeters(1));
  std::shared_ptr<const InsertionModel> model;
  std::vector<Eigen::Vector3d> nodes_W;
  std::vector<double> angles;  ///< Angle of each node [rad].
};

TEST(Outcome, SaysWhereEveryContactLies)
{
  const LaidArray array;
  const auto outcome = array.outcome(-array.model->entry.outward_W);
  ASSERT_EQ(outcome.size(), 22u);
  for (const ContactOutcome& contact : outcome) {
    ASSERT_TRUE(contact.isInside);
    const double angle = array.angleAt(contact.fromTip);
    if (angle < 0.1) continue;
    EXPECT_NEAR(contact.angle, angle, 0.002) << contact.fromTip;
    const Eigen::Vector3d center = array.scala->center_W(angle);
    EXPECT_NEAR(contact.toModiolarAxis, std::hypot(center.x(), center.y()), 0.01e-3);
    // from the tables of the sections: from the center straight inward to the wall
    const double inward = (array.scala->wall_W(angle, pi) - center).norm();
    EXPECT_NEAR(contact.toInnerWall, inward, 0.03e-3) << contact.fromTip;
  }
}

TEST(Outcome, GivesTheRollOfTheContactsAwayFromTheModiolus)
{
  const LaidArray array;
  const Eigen::Vector3d inward_W = -array.model->entry.outward_W;
  for (const double roll : {0.0, 0.5, 1.5, 3.0}) {
    const Eigen::Vector3d curl_W =
        Eigen::AngleAxisd(roll, array.model->entry.out_W).toRotationMatrix() * inward_W;
    // The basal turn is nearly plane: the side that faces inward at the tweezers still does, with
    // the same roll, within the slope of the duct.
    for (const ContactOutcome& contact : array.outcome(curl_W)) {
      if (contact.angle < 0.1 || contact.angle > 2.0 * pi) continue;
      EXPECT_NEAR(contact.offModiolus, roll, 0.5) << contact.fromTip;
    }
  }
}

TEST(Outcome, KnowsContactsThatAreStillOutside)
{
  LaidArray array;
  for (Eigen::Vector3d& node : array.nodes_W) node += 10e-3 * array.model->entry.out_W;
  const auto outcome = array.outcome(-array.model->entry.outward_W);
  EXPECT_FALSE(outcome.back().isInside);
  EXPECT_EQ(outcome.back().toInnerWall, 0.0);
}

TEST(Outcome, RefusesAShapeOfAnotherModel)
{
  const LaidArray array;
  const std::vector<Eigen::Vector3d> few(7, Eigen::Vector3d::Zero());
  EXPECT_THROW(outcomeOf(*array.model, ArrayShape{few, {}, Eigen::Vector3d::UnitX()}),
               std::invalid_argument);
}

}  // namespace
}  // namespace perilymph::mechanics
