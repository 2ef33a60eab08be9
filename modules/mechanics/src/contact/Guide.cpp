// SPDX-License-Identifier: BSD-3-Clause
#include "contact/Guide.h"

#include "lanes/Lanes.h"
#include "rod/Rod.h"

namespace perilymph::mechanics {
namespace {

/// Stiffness of the hold per length of array: silicone of about 1 MPa between two flat jaws as wide
/// as it is thick (choice, medium). Above it, results do not change.
constexpr double holdStiffness = 1e6;  // [N/m^2]
/// Length over which the hold sets in; avoids a jump when a node leaves it (choice, high).
constexpr double onset = 0.5e-3;  // [m]

template <class T>
PERILYMPH_IN_LANES Triple<T> everywhere(const Eigen::Vector3d& v) noexcept
{
  return {T{} + v[0], T{} + v[1], T{} + v[2]};
}

/// The weight of the hold at a height above the free length, and its integral from there.
template <class T>
struct Onset {
  T weight, integral;
};

template <class T>
PERILYMPH_IN_LANES Onset<T> onsetAt(const T& above) noexcept
{
  const T s = smaller(larger(above / onset, 0.0), 1.0);
  const T square = s * s;
  return {square * (3.0 - 2.0 * s),
          onset * (square * s * (1.0 - 0.5 * s)) + larger(above - onset, 0.0)};
}

/// Adds the force of the forceps on a node, or on four, and returns it: zero within the free length.
template <class T>
PERILYMPH_IN_LANES Triple<T> pushOn(std::size_t i, const InsertionModel& model,
                                    const std::vector<Eigen::Vector3d>& position_W,
                                    const std::vector<double>& height, GuideLine& guide,
                                    std::vector<Eigen::Vector3d>& force_W) noexcept
{
  const Triple<T> axis = everywhere<T>(guide.axis_W);
  const T above = load<T>(height, i) - model.parts.freeLength->si();
  if (inAll(above + 0.5 * model.spacing <= 0.0)) {
    store(T{}, guide.stiffness, i);
    return {};
  }
  const Onset<T> upper = onsetAt(T{above + 0.5 * model.spacing});
  const Onset<T> lower = onsetAt(T{above - 0.5 * model.spacing});
  const T stiffness = holdStiffness * (upper.integral - lower.integral);
  const T slope = holdStiffness * (upper.weight - lower.weight);  // by the height
  const Triple<T> from = load<T>(position_W, i) - everywhere<T>(guide.origin_W);
  const Triple<T> aside = from - dot(from, axis) * axis;
  const T up = -0.5 * slope * dot(aside, aside);
  const Triple<T> push = up * everywhere<T>(model.entry.out_W) - stiffness * aside;
  store(stiffness, guide.stiffness, i);
  store(load<T>(force_W, i) + push, force_W, i);
  return push;
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
  Triple<double> sum;
  withLanes([&]() PERILYMPH_KERNEL {
    Triple<Four> byFour;
    std::size_t i = 2;
    for (; i + 4 <= position_W.size(); i += 4)
      byFour = byFour + pushOn<Four>(i, model, position_W, height, guide, force_W);
    for (; i < position_W.size(); ++i)
      sum = sum + pushOn<double>(i, model, position_W, height, guide, force_W);
    sum = sum + Triple<double>{sumOf(byFour.x), sumOf(byFour.y), sumOf(byFour.z)};
  });
  force_W[0] -= Eigen::Vector3d(sum.x, sum.y, sum.z);
}

void addGuideStiffness(const InsertionModel& model, const GuideLine& guide,
                       BandMatrix& matrix) noexcept
{
  if (!model.parts.freeLength) return;
  const Eigen::Vector3d& a = guide.axis_W;
  for (std::size_t i = 2; i < guide.stiffness.size(); ++i) {
    const double k = guide.stiffness[i];
    if (k == 0.0) continue;
    matrix.diagonal.add(blockOf(i),
                        {k * (1.0 - a[0] * a[0]), -k * a[0] * a[1], -k * a[0] * a[2],
                         k * (1.0 - a[1] * a[1]), -k * a[1] * a[2], k * (1.0 - a[2] * a[2])});
  }
}

}  // namespace perilymph::mechanics
