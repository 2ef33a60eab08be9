#pragma once

// The elastic energy of an array, by the formula and not by the solver.

#include <Eigen/Core>
#include <vector>

#include "perilymph/mechanics/InsertionModel.h"

namespace perilymph::test {

/// Energy of bending [J]: the sum of EI |w - h kappa d|^2 / (2 h) over the inner nodes, with the
/// stylet withdrawn by a length [m] and the curl's direction carried along from the base without
/// turning.
double bendingEnergy(const mechanics::InsertionModel& model,
                     const std::vector<Eigen::Vector3d>& nodes_W, const Eigen::Vector3d& curl_W,
                     double styletWithdrawal);

}  // namespace perilymph::test
