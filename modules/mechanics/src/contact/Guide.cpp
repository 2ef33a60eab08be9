// SPDX-License-Identifier: BSD-3-Clause
#include "contact/Guide.h"

#include <algorithm>

#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

/// Stiffness of the hold per length of array: silicone of about 1 MPa between two flat jaws as wide
/// as it is thick (choice, medium). Above it, results do not change.
constexpr double holdStiffness = 1e6;  // [N/m^2]
/// Length over which the hold sets in; avoids a jump when a node leaves it (choice, high).
constexpr double onset = 0.5e-3;  // [m]

/// Fraction of the hold at a height above its lower end, and its derivative by the height.
struct Hold {
  double fraction;
  double slope;  ///< [1/m]
};

Hold holdAt(double height) noexcept
{
  const double s = std::clamp(height / onset, 0.0, 1.0);
  return {s * s * (3.0 - 2.0 * s), 6.0 * s * (1.0 - s) / onset};
}

}  // namespace

void setGuide(const Drive& drive, const Eigen::Vector3d& base_W, GuideLine& guide) noexcept
{
  guide.origin_W = drive.coupling == Coupling::rigid ? drive.handPosition_W : base_W;
  guide.axis_W = drive.handAxis_W;
}

void addGuideForces(const InsertionModel& model, const std::vector<Eigen::Vector3d>& position_W,
                    const std::vector<double>& height, GuideLine& guide,
                    std::vector<Eigen::Vector3d>& force_W) noexcept
{
  if (!model.parts.freeLength) return;
  const double end = model.parts.freeLength->si();
  const double perNode = holdStiffness * model.spacing;
  const Eigen::Vector3d& out_W = model.entry.out_W;
  for (std::size_t i = 2; i < position_W.size(); ++i) {
    guide.stiffness[i] = 0.0;
    const double above = height[i] - end;
    if (above <= 0.0) continue;
    const Hold hold = holdAt(above);
    const Eigen::Vector3d from_W = position_W[i] - guide.origin_W;
    const Eigen::Vector3d aside_W = from_W - from_W.dot(guide.axis_W) * guide.axis_W;
    guide.stiffness[i] = perNode * hold.fraction;
    const Eigen::Vector3d push_W = -guide.stiffness[i] * aside_W -
                                   (0.5 * perNode * hold.slope * aside_W.squaredNorm()) * out_W;
    force_W[i] += push_W;
    force_W[0] -= push_W;
  }
}

void addGuideStiffness(const InsertionModel& model, const GuideLine& guide,
                       BandMatrix& matrix) noexcept
{
  if (!model.parts.freeLength) return;
  const Eigen::Vector3d& a = guide.axis_W;
  for (std::size_t i = 2; i < guide.stiffness.size(); ++i) {
    const double k = guide.stiffness[i];
    if (k == 0.0) continue;
    matrix.diagonal[blockOf(i)] +=
        SymmetricBlock<double>{k * (1.0 - a[0] * a[0]), -k * a[0] * a[1], -k * a[0] * a[2],
                               k * (1.0 - a[1] * a[1]), -k * a[1] * a[2], k * (1.0 - a[2] * a[2])};
  }
}

}  // namespace perilymph::mechanics
