// SPDX-License-Identifier: BSD-3-Clause
#include "rod/BendingAlong.h"

#include <algorithm>
#include <array>

#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

using Eigen::Vector3d;

/// Adds k g g^T for the gradients g of a joint by its three nodes.
void addRankOne(BandMatrix& matrix, std::size_t i, const std::array<Vector3d, 3>& g,
                double k) noexcept
{
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      const Vector3d l = k * g[a];
      const Vector3d& r = g[b];
      const Block<double> block{l[0] * r[0], l[0] * r[1], l[0] * r[2], l[1] * r[0], l[1] * r[1],
                                l[1] * r[2], l[2] * r[0], l[2] * r[1], l[2] * r[2]};
      const std::size_t row = blockOf(i - 1 + a), column = blockOf(i - 1 + b);
      if (row == column) {
        const SymmetricBlock<double> symmetric{
            block.xx, 0.5 * (block.xy + block.yx), 0.5 * (block.xz + block.zx),
            block.yy, 0.5 * (block.yz + block.zy), block.zz};
        matrix.diagonal.add(row, symmetric);
        // both nodes belong to the base: their coupling counts twice
        if (a != b) matrix.diagonal.add(row, symmetric);
      } else if (row == column + 1) {
        matrix.beside.add(row, block);
      } else {
        matrix.beyond.add(row, block);
      }
    }
}

}  // namespace

void addBendingAlong(BandMatrix& matrix, const RodKinematics& rod, std::size_t i,
                     const Vector3d& way_W, double k) noexcept
{
  const Vector3d last_W = rod.tangent_W[i - 1], next_W = rod.tangent_W[i];
  const double c = 2.0 / std::max(1.0 + last_W.dot(next_W), 1e-3);
  const Vector3d byNext = c * rod.inverseLength[i] * (way_W - way_W.dot(next_W) * next_W);
  const Vector3d byLast = c * rod.inverseLength[i - 1] * (way_W - way_W.dot(last_W) * last_W);
  addRankOne(matrix, i, {byLast, -byLast - byNext, byNext}, k);
}

}  // namespace perilymph::mechanics
