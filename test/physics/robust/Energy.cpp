// SPDX-License-Identifier: BSD-3-Clause
#include "Energy.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace perilymph::test {
namespace {

/// One edge: its vector, and the directions of its material.
struct Edge {
  Eigen::Vector3d tangent, curl, side;
};

Edge edgeAt(const ArrayPose& pose, std::size_t i)
{
  Edge edge;
  edge.tangent = (pose.nodes_W[i + 1] - pose.nodes_W[i]).normalized();
  edge.curl = pose.curl_W[i] - pose.curl_W[i].dot(edge.tangent) * edge.tangent;
  edge.curl.normalize();
  edge.side = edge.tangent.cross(edge.curl);
  return edge;
}

}  // namespace

double elasticEnergy(const mechanics::InsertionModel& model, const ArrayPose& pose)
{
  const double h = model.spacing;
  const double styletTip = model.styletFromTip + pose.styletWithdrawal;
  double energy = 0.0;
  for (std::size_t i = 1; i + 1 < pose.nodes_W.size(); ++i) {
    const Edge before = edgeAt(pose, i - 1), after = edgeAt(pose, i);
    double covered = 0.0;
    if (model.styletBending > 0.0)
      covered = std::clamp((model.fromTip[i] - styletTip) / h + 0.5, 0.0, 1.0);
    // a piece without the stylet and a piece with it yield one after the other
    const auto inSeries = [&](double carrier) {
      return 1.0 / ((1.0 - covered) / carrier + covered / (carrier + model.styletBending));
    };
    const double bending = inSeries(model.bendingCarrier[i]);
    const double rest =
        pose.released * model.restCurvature[i] * (1.0 - covered * (1.0 - model.styletResidual));
    const Eigen::Vector3d bend =
        2.0 / (1.0 + before.tangent.dot(after.tangent)) * (after.tangent - before.tangent);
    const Eigen::Vector3d strain = bend - 0.5 * h * rest * (before.curl + after.curl);
    energy += bending / (2.0 * h) * strain.squaredNorm();
    if (!model.twists) continue;
    const Eigen::Vector3d stiffer = model.stifferAcross[i] != 0 ? 0.5 * (before.side + after.side)
                                                                : 0.5 * (before.curl + after.curl);
    const double more = inSeries(model.bendingCarrier[i] + model.bendingExcess[i]) - bending;
    energy += more / (2.0 * h) * std::pow(strain.dot(stiffer), 2);
    const Eigen::Vector3d carried =
        Eigen::Quaterniond::FromTwoVectors(before.tangent, after.tangent) * before.curl;
    const double twist =
        std::atan2(after.tangent.dot(carried.cross(after.curl)), carried.dot(after.curl));
    energy += model.twisting[i] / (2.0 * h) * twist * twist;
  }
  return energy;
}

}  // namespace perilymph::test
