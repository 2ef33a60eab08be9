// SPDX-License-Identifier: BSD-3-Clause
#include "contact/Mouth.h"

#include <algorithm>
#include <limits>
#include <vector>

#include "contact/Contact.h"
#include "perilymph/anatomy/ScalaTympani.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::mechanics {

double mouthRadiusOf(const anatomy::ScalaTympani& scala)
{
  const anatomy::Entry entry = scala.entry();
  const Eigen::Vector3d center_W = scala.center_W(0.0);
  constexpr int directions = 180;
  std::vector<Eigen::Vector2d> outline;
  for (int k = 0; k < directions; ++k) {
    const Eigen::Vector3d from_W = scala.wall_W(0.0, 2.0 * pi * k / directions) - center_W;
    outline.emplace_back(from_W.dot(entry.outward_W), from_W.dot(entry.vertical_W));
  }
  const auto distance = [&outline](const Eigen::Vector2d& at) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const Eigen::Vector2d& from = outline[k];
      const Eigen::Vector2d edge = outline[(k + 1) % outline.size()] - from;
      const double along = std::clamp((at - from).dot(edge) / edge.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (at - from - along * edge).norm());
    }
    return nearest;
  };
  // the center of the largest circle, by steps that are halved
  Eigen::Vector2d best = Eigen::Vector2d::Zero();
  double radius = distance(best);
  for (double step = 0.2e-3; step > 0.1e-6;) {
    const Eigen::Vector2d before = best;
    for (int k = 0; k < 8; ++k) {
      const SineCosine turn = sineCosine(0.25 * pi * k);
      const Eigen::Vector2d at = before + step * Eigen::Vector2d(turn.cosine, turn.sine);
      if (const double there = distance(at); there > radius) {
        radius = there;
        best = at;
      }
    }
    if (best == before) step *= 0.5;
  }
  return radius;
}

void addMouthForces(const InsertionModel& model, const Crossing& crossing,
                    std::vector<Eigen::Vector3d>& force_W) noexcept
{
  double half = 0.0, stiffness = 0.0;
  for (std::size_t k = 0; k < crossing.count; ++k) {
    const std::size_t node = crossing.first + k;
    half += crossing.weight[k] * std::min(model.halfWithin[node], model.halfAcross[node]);
    stiffness += crossing.weight[k] * model.wallStiffness[node];
  }
  const double squeezed = half - model.mouthRadius;
  if (!(squeezed > 0.0)) return;
  const double perLength =
      energyOf(squeezed, stiffness, model.parts.wall.lining.si()) / model.spacing;
  for (std::size_t k = 0; k < crossing.count; ++k)
    force_W[crossing.first + k] += crossing.weight[k] * perLength * model.entry.out_W;
}

}  // namespace perilymph::mechanics
