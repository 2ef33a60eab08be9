#include "Energy.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace perilymph::test {

double bendingEnergy(const mechanics::InsertionModel& model,
                     const std::vector<Eigen::Vector3d>& nodes_W, const Eigen::Vector3d& curl_W,
                     double styletWithdrawal)
{
  const double h = model.spacing;
  const double styletTip = model.styletFromTip + styletWithdrawal;
  double energy = 0.0;
  Eigen::Vector3d before = (nodes_W[1] - nodes_W[0]).normalized();
  Eigen::Vector3d curl = curl_W;
  for (std::size_t i = 1; i + 1 < nodes_W.size(); ++i) {
    const Eigen::Vector3d after = (nodes_W[i + 1] - nodes_W[i]).normalized();
    const Eigen::Vector3d next = Eigen::Quaterniond::FromTwoVectors(before, after) * curl;
    double covered = 0.0;
    if (model.styletBending > 0.0)
      covered = std::clamp((model.fromTip[i] - styletTip) / h + 0.5, 0.0, 1.0);
    const double bending = 1.0 / ((1.0 - covered) / model.bendingCarrier[i] +
                                  covered / (model.bendingCarrier[i] + model.styletBending));
    const double rest = model.restCurvature[i] * (1.0 - covered * (1.0 - model.styletResidual));
    const Eigen::Vector3d bend = 2.0 / (1.0 + before.dot(after)) * (after - before);
    energy += bending / (2.0 * h) * (bend - 0.5 * h * rest * (curl + next)).squaredNorm();
    before = after;
    curl = next;
  }
  return energy;
}

}  // namespace perilymph::test
