// SPDX-License-Identifier: BSD-3-Clause
#include "rod/Wires.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "StepWorkspace.h"
#include "lumen/PlainLumens.h"
#include "perilymph/mechanics/advance.h"
#include "rod/Material.h"
#include "rod/Relaxation.h"
#include "rod/Rod.h"

// A rod whose shape is given: an arc that is bent and straightened.

namespace perilymph::mechanics {
namespace {

constexpr double wires = 0.6e-6;  // [N.m^2]
constexpr double moment = 2e-6;   // [N.m] at which they yield fully

/// A round array with single wires of the stiffness above in silicone of another.
std::shared_ptr<const InsertionModel> model(double silicone, bool yields = true)
{
  ModelParts parts;
  parts.lumen = std::make_shared<anatomy::StraightTube>(50e-3);
  parts.array.length = parts.array.insertable = millimeters(20);
  parts.array.diameter = {{millimeters(0)}, {millimeters(0.5)}};
  parts.array.bending = {{millimeters(0)}, {newtonSquareMeters(silicone + wires)}};
  parts.array.restCurvature = {{millimeters(0)}, {perMillimeter(0)}};
  parts.nodes = 41;
  if (yields) {
    electrode::Wires each;
    each.diameter = millimeters(0.1);
    const double d = each.diameter.si();
    each.number = {{millimeters(0)}, {1.0}};
    each.modulus = Modulus::fromSi(wires * 64.0 / (pi * d * d * d * d));
    each.yieldStress.value = Modulus::fromSi(moment * 6.0 / (d * d * d));
    parts.array.wires = each;
  }
  return InsertionModel::build(parts);
}

/// Such a rod in steps from one arc to the next.
class Arc {
public:
  explicit Arc(std::shared_ptr<const InsertionModel> of, double curlTurn = 0.0)
      : model_(std::move(of)),
        state_(*model_),
        curl_(std::cos(curlTurn), std::sin(curlTurn), 0.0),
        work_(state_.workspace->rod)
  {
    place(0.0);
    for (Eigen::Vector3d& each : state_.curl_W) each = curl_;
    setStiffness(*model_, 0.0, 1.0, work_.section);
  }

  /// One step to the arc with this bend at every node; returns the moment there [N.m].
  double stepTo(double bend)
  {
    setEdges(state_.position_W, work_.rod);
    setRestShape(*model_, curl_, work_.section, work_.rod);
    if (work_.section.holds) {
      setHeldBend(*model_, state_, work_.section);
      turnMaterial(*model_, curl_, work_.section, state_, work_.rod, work_.twist);
    }
    place(bend);
    // without the material's damping: as after many steps in this place
    setEdges(state_.position_W, work_.rod);
    for (std::size_t i = 1; i + 1 < state_.position_W.size(); ++i)
      work_.rod.bendBefore_W.set(
          i, Eigen::Vector3d(2.0 * std::tan(0.5 * angle_) * bisector(static_cast<double>(i))));
    setRodForces(*model_, state_.position_W, work_.section, work_.rod, work_.force_W);
    if (work_.section.holds) dissipated += commitBends(*model_, work_.section, work_.rod, state_);
    // the last link turns about its node by the moment
    const Eigen::Vector3d across(std::cos(lastAngle()), 0.0, -std::sin(lastAngle()));
    return -work_.force_W.back().dot(across) * model_->spacing;
  }
  /// The same in many steps.
  double bendTo(double bend)
  {
    double at = 0.0;
    const double from = 2.0 * std::tan(0.5 * angle_);
    for (int i = 1; i <= 40; ++i) at = stepTo(from + (bend - from) * i / 40.0);
    return at;
  }

  double set(std::size_t node) const
  {
    return std::hypot(state_.plasticBend[0].along[node], state_.plasticBend[0].across[node]);
  }

  double dissipated = 0.0;  ///< By all nodes [J].

private:
  void place(double bend)
  {
    angle_ = 2.0 * std::atan(0.5 * bend);
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < state_.position_W.size(); ++i) {
      state_.position_W[i] = at;
      const double along = static_cast<double>(i) * angle_;
      at += model_->spacing * Eigen::Vector3d(std::sin(along), 0.0, std::cos(along));
    }
  }
  Eigen::Vector3d bisector(double node) const
  {
    const double along = (node - 0.5) * angle_;
    return {std::cos(along), 0.0, -std::sin(along)};
  }
  double lastAngle() const { return static_cast<double>(state_.position_W.size() - 2) * angle_; }

  std::shared_ptr<const InsertionModel> model_;
  InsertionState state_;
  Eigen::Vector3d curl_;
  RodWorkspace& work_;
  double angle_ = 0.0;
};

double stiffnessOfAJoint(double bending) { return bending / (20e-3 / 40.0); }

TEST(Wires, BentBeyondYieldKeepTheBendBeyondIt)
{
  const double stiffness = stiffnessOfAJoint(wires), yield = moment / stiffness;
  for (const double turned : {0.0, 1.0})
    for (const double times : {1.2, 1.6, 1.95}) {
      Arc arc(model(0.2e-6), turned);
      const double bend = times * yield;
      const double bent = arc.bendTo(bend);
      const double soft = stiffnessOfAJoint(0.2e-6);
      EXPECT_NEAR(bent, soft * bend + moment, 2e-3 * moment);
      const double work = arc.dissipated;
      EXPECT_NEAR(work, 39.0 * moment * (bend - yield), 0.01 * work);
      // straight again, the wires are bent the other way, but not beyond yield
      arc.bendTo(0.0);
      EXPECT_NEAR(arc.set(20), bend - yield, 1e-4 * bend) << "k1 - M / B";
      EXPECT_NEAR(arc.dissipated, work, 1e-6 * work);
      // no moment is left at this bend
      const double free = stiffness / (soft + stiffness) * (bend - yield);
      EXPECT_NEAR(arc.bendTo(free), 0.0, 1e-3 * moment) << "(B / (A + B)) (k1 - M / B)";
    }
}

TEST(Wires, InACycleDissipateFourTimesTheirMomentTimesTheBendBeyondYield)
{
  const double yield = moment / stiffnessOfAJoint(wires), bend = 1.7 * yield;
  Arc arc(model(0.1e-6));
  arc.bendTo(bend);
  arc.bendTo(-bend);
  arc.dissipated = 0.0;
  arc.bendTo(bend);
  arc.bendTo(-bend);
  const double expected = 39.0 * 4.0 * moment * (bend - yield);
  EXPECT_NEAR(arc.dissipated, expected, 1e-3 * expected);
}

TEST(Wires, BentBelowYieldAreElastic)
{
  const double yield = moment / stiffnessOfAJoint(wires);
  Arc arc(model(0.1e-6)), elastic(model(0.1e-6, false));
  for (const double bend : {0.9 * yield, -0.9 * yield, 0.5 * yield})
    EXPECT_NEAR(arc.bendTo(bend), elastic.bendTo(bend), 1e-9 * moment);
  EXPECT_EQ(arc.dissipated, 0.0);
  EXPECT_EQ(arc.set(20), 0.0);
}

TEST(Wires, AreSofterThanTheArray)
{
  // a study that makes the array softer than its wires makes those softer, too
  ModelParts parts = model(0.1e-6)->parts;
  parts.array.bending.value[0] = newtonSquareMeters(0.5 * wires);
  const auto soft = InsertionModel::build(parts);
  EXPECT_NEAR(soft->wires[0].stiffness[20], stiffnessOfAJoint(0.5 * wires), 1e-12);
}

/// A straight array of silicone that curls by 0.1 / mm around a stylet, which yields at a stress.
ModelParts withStylet(double stress_MPa, double curvature_per_mm = 0.1)
{
  ModelParts parts = model(0.1e-6, false)->parts;
  parts.array.restCurvature.value[0] = perMillimeter(curvature_per_mm);
  parts.array.hasStylet = true;
  parts.array.stylet.fromTip = millimeters(2);
  parts.array.stylet.bending = newtonSquareMeters(1e-6);
  parts.array.stylet.diameter = millimeters(0.11);
  parts.array.stylet.yieldStress.value = megapascals(stress_MPa);
  return parts;
}

std::string refusal(const ModelParts& parts)
{
  try {
    InsertionModel::build(parts);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Stylet, ThatYieldsBeforeItHoldsTheCarrierStraightIsRefused)
{
  // the carrier curls with 0.7e-6 N m2 times 100 / m; a stylet of 0.11 mm holds 77.6 uN m at 350 MPa
  EXPECT_EQ(refusal(withStylet(350)), "accepted");
  EXPECT_THAT(refusal(withStylet(150)), testing::HasSubstr("yields at 33.3 uN.m"));
  EXPECT_THAT(refusal(withStylet(150)),
              testing::HasSubstr("curls with 70 uN.m; it needs a yield stress of 316 MPa"));
  EXPECT_EQ(refusal(withStylet(150, 0.02)), "accepted");
}

TEST(Stylet, TakesItsPlasticBendAlongWithoutGainingEnergy)
{
  const auto built = InsertionModel::build(withStylet(600));
  InsertionState state(*built);
  RodWorkspace& work = state.workspace->rod;
  setStiffness(*built, 0.0, 0.0, work.section);
  setEdges(state.position_W, work.rod);
  setRestShape(*built, built->startCurl_W, work.section, work.rod);
  MaterialBend& plastic = state.plasticBend.back();
  // the rod is straight: a bend is what the stylet is bent against itself
  for (std::size_t i = 0; i < plastic.along.size(); ++i)
    plastic.along[i] = 0.001 * std::sin(0.3 * static_cast<double>(i));
  const std::vector<double> before = plastic.along;
  moveStylet(*built, 3.0 * built->spacing, work.section, work.rod, state);
  for (std::size_t i = 1; i + 4 < before.size(); ++i) {
    const double moved = before[i + 3];
    EXPECT_LE(std::fabs(plastic.along[i]), std::fabs(before[i]) + 1e-15) << i;
    if (std::fabs(moved) <= std::fabs(before[i])) {
      EXPECT_NEAR(plastic.along[i], moved, 1e-15) << i;
    }
    EXPECT_GE(plastic.along[i] * moved, 0.0) << "of the same side as what moved here";
  }
}

}  // namespace
}  // namespace perilymph::mechanics
