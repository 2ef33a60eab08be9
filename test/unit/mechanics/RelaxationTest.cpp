// SPDX-License-Identifier: BSD-3-Clause
#include "rod/Relaxation.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "StepWorkspace.h"
#include "lumen/PlainLumens.h"
#include "perilymph/mechanics/advance.h"
#include "rod/Material.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

ModelParts partsWith(const RelaxationLaw& law)
{
  ModelParts parts;
  parts.lumen = std::make_shared<anatomy::StraightTube>(50e-3);
  parts.array.length = parts.array.insertable = millimeters(20);
  parts.array.diameter = {{millimeters(0)}, {millimeters(0.5)}};
  parts.array.bending = {{millimeters(0)}, {newtonSquareMeters(1e-6)}};
  parts.array.restCurvature = {{millimeters(0)}, {perMillimeter(0)}};
  parts.nodes = 41;
  parts.relaxation = law;
  return parts;
}

RelaxationLaw twoTerms()
{
  RelaxationLaw law;
  law.bending = {{{0.13, seconds(0.02)}, {0.28, seconds(0.1)}}};
  return law;
}

TEST(Relaxation, OfABendThatIsHeldFallsByTheFactorOfBackwardEuler)
{
  const auto model = InsertionModel::build(partsWith(twoTerms()));
  const auto elastic = InsertionModel::build(partsWith({}));
  for (const double turned : {0.0, 1.1, 2.4}) {
    InsertionState state(*model);
    RodWorkspace& work = state.workspace->rod;
    const double angle = 0.05;
    Eigen::Vector3d at = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < state.position_W.size(); ++i) {
      state.position_W[i] = at;
      const double along = static_cast<double>(i) * angle;
      at += model->spacing * Eigen::Vector3d(std::sin(along), 0.0, std::cos(along));
    }
    const Eigen::Vector3d curl(std::cos(turned), std::sin(turned), 0.0);
    for (std::size_t i = 0; i < state.curl_W.size(); ++i)
      state.curl_W[i] =
          Eigen::AngleAxisd(static_cast<double>(i) * angle, Eigen::Vector3d::UnitY()) * curl;
    const auto force = [&](const InsertionModel& of) {
      setStiffness(of, 0.0, 1.0, work.section);
      setEdges(state.position_W, work.rod);
      setRestShape(of, curl, work.section, work.rod);
      if (of.twists) {
        setHeldBend(of, state, work.section);
        turnMaterial(of, curl, work.section, state, work.rod, work.twist);
        // only bends are of interest
        std::fill(work.section.twisting.begin(), work.section.twisting.end(), 0.0);
      }
      setRodForces(of, state.position_W, work.section, work.rod, work.force_W);
      return Eigen::Vector3d(work.force_W.back());
    };
    work.section.styletWithdrawal = std::nan("");
    const Eigen::Vector3d full = force(*elastic);
    ASSERT_GT(full.norm(), 0.05);
    work.section.styletWithdrawal = std::nan("");
    for (int n = 1; n <= 200; ++n) {
      double left = 1.0 - 0.13 - 0.28;
      left += 0.13 * std::pow(1.0 + 1e-3 / 0.02, -n) + 0.28 * std::pow(1.0 + 1e-3 / 0.1, -n);
      // the turn of the material takes the axes of a bend that is not in its plane to second order
      const double within = turned == 0.0 ? 1e-12 : 1e-5;
      ASSERT_LT((force(*model) - left * full).norm(), within * full.norm()) << n << ' ' << turned;
      commitBends(*model, work.section, work.rod, state);
    }
  }
}

std::string refusal(const RelaxationLaw& law, ModelKind kind = ModelKind::rod)
{
  ModelParts parts = partsWith(law);
  parts.kind = kind;
  if (kind == ModelKind::points) {
    parts.nodes = 12;
    parts.hapticSurface = std::make_shared<const anatomy::Surface>();
  }
  try {
    InsertionModel::build(std::move(parts));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Relaxation, OutOfRangeIsRefused)
{
  EXPECT_EQ(refusal(twoTerms()), "accepted");
  const auto changed = [](auto change) {
    RelaxationLaw law = twoTerms();
    change(law);
    return law;
  };
  using testing::HasSubstr;
  EXPECT_THAT(refusal(changed([](auto& law) { law.bending[0].fraction = -0.1; })),
              HasSubstr("A fraction of -0.1"));
  EXPECT_THAT(refusal(changed([](auto& law) { law.bending[1].fraction = 0.9; })),
              HasSubstr("must leave 0.05"));
  EXPECT_THAT(refusal(changed([](auto& law) { law.bending[1].time = seconds(0.001); })),
              HasSubstr("must be 0.01 to 10000 s"));
  EXPECT_THAT(refusal(changed([](auto& law) { law.film.fraction = 1.5; })), HasSubstr("0 to 1"));
  EXPECT_THAT(refusal(twoTerms(), ModelKind::points), HasSubstr("does not relax"));
}

}  // namespace
}  // namespace perilymph::mechanics
