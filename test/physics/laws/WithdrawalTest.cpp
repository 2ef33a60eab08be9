// SPDX-License-Identifier: BSD-3-Clause

// A withdrawn array has no memory of the insertion.

#include <gtest/gtest.h>

#include <cmath>

#include "perilymph/anatomy/MeanScala.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Resources.h"
#include "perilymph/mechanics/advance.h"
#include "perilymph/test/Tolerance.h"

namespace perilymph {
namespace {

/// An array that starts before the opening, is inserted and withdrawn again.
class Insertion {
public:
  explicit Insertion(mechanics::ModelParts parts)
      : model_(mechanics::InsertionModel::build(std::move(parts))), state_(*model_)
  {
    drive_.handPosition_W = model_->startBase_W;
    drive_.handAxis_W = model_->startAxis_W;
    drive_.handCurl_W = model_->startCurl_W;
  }

  void move(double distance, double speed)
  {
    const Eigen::Vector3d from_W = drive_.handPosition_W;
    const long ticks = std::lround(std::ceil(std::fabs(distance) / speed / model_->timeStep));
    for (long k = 1; k <= ticks; ++k) {
      const double fraction = static_cast<double>(k) / static_cast<double>(ticks);
      drive_.handPosition_W = from_W + fraction * distance * model_->startAxis_W;
      mechanics::advance(*model_, state_, drive_);
    }
  }
  void rest(double duration)
  {
    const long ticks = std::lround(duration / model_->timeStep);
    for (long k = 0; k < ticks; ++k) mechanics::advance(*model_, state_, drive_);
  }

  const mechanics::InsertionState& state() const { return state_; }

private:
  std::shared_ptr<const mechanics::InsertionModel> model_;
  mechanics::InsertionState state_;
  mechanics::Drive drive_;
};

mechanics::ModelParts partsOf(const std::string& anatomy, const std::string& array)
{
  mechanics::ModelParts parts;
  if (anatomy == "published")
    parts.lumen = anatomy::buildPublished({}, millimeters(1));
  else
    parts.lumen = *anatomy::buildMean(millimeters(1));
  parts.array = *electrode::loadArray(resource("plugins/electrodes/" + array + ".toml"));
  parts.opening = mechanics::cochleostomy();
  parts.startInside = millimeters(-0.5);
  return parts;
}

TEST(WithdrawnArray, PushesNobodyAndIsAsItWas)
{
  for (const auto& [anatomy, array] :
       {std::pair("published", "cochlear/contour"), std::pair("mean", "med-el/flex28")}) {
    Insertion insertion(partsOf(anatomy, array));
    insertion.rest(1.0);
    const auto shapeOf = [&insertion] {
      std::vector<Eigen::Vector3d> shape;
      for (const Eigen::Vector3d& node : insertion.state().position_W)
        shape.emplace_back(node - insertion.state().base_W);
      return shape;
    };
    const std::vector<Eigen::Vector3d> before = shapeOf();
    insertion.move(19e-3, 4e-3);
    ASSERT_GT(insertion.state().readings.axialForce, 3e-3) << array;
    insertion.move(-19e-3, 4e-3);
    insertion.rest(1.0);
    const std::vector<Eigen::Vector3d> after = shapeOf();
    double changed = 0.0;
    for (std::size_t i = 0; i < after.size(); ++i)
      changed = std::max(changed, (after[i] - before[i]).norm());
    EXPECT_EQ(insertion.state().readings.contacts, 0) << array;
    EXPECT_EQ(insertion.state().readings.rimForce, 0.0) << array;
    EXPECT_LT(insertion.state().readings.handForce_W.norm(), test::tolerance(2e-6, "solver"))
        << array;
    EXPECT_LT(changed, test::tolerance(1e-6, "2 uN on a soft array")) << array;
  }
}

}  // namespace
}  // namespace perilymph
