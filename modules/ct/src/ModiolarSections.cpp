// SPDX-License-Identifier: BSD-3-Clause
#include "ModiolarSections.h"

#include <cmath>
#include <optional>
#include <vector>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {

SectionCheck checkSections(const CtVolume& volume, const ShapedLumen& lumen, const FitState& state)
{
  constexpr double reach_mm = 0.8, step_mm = 0.05;
  const double middle = 0.5 * (state.bone + state.lumen);
  const double sign = state.bone > state.lumen ? 1.0 : -1.0;
  int rays = 0, found = 0, missing = 0, clipped = 0;
  double sum = 0.0, squares = 0.0;
  std::vector<SurfacePoint> points;
  for (int angle_deg = 20; angle_deg <= 540; angle_deg += 15) {
    const double angle = degrees(angle_deg).si();
    const SineCosine turn = sineCosine(angle);
    const SectionPlace place = lumen.place(angle);
    const double half = place.height * lumen.mean().halfHeight(angle);
    const double halfWidth = 0.5 * place.width * lumen.mean().width(angle);
    const double middleRadius = place.outer - halfWidth;
    const double middleHeight = place.middle - place.tilt * halfWidth;
    // Outward, and in the first turn, where no other turn is near, up and down.
    for (int direction = 0; direction < (angle_deg <= 300 ? 3 : 1); ++direction) {
      const double along = direction == 0 ? halfWidth : half;
      const Eigen::Vector3d ray_W = direction == 0
                                        ? Eigen::Vector3d(turn.cosine, turn.sine, 0.0)
                                        : Eigen::Vector3d(0.0, 0.0, direction == 1 ? 1.0 : -1.0);
      const Eigen::Vector3d start_W(middleRadius * turn.cosine, middleRadius * turn.sine,
                                    middleHeight);
      ++rays;
      std::optional<double> wall;
      double valueBefore = 0.0;
      bool isOut = false;
      for (double t = 0.2; t < along + reach_mm && !wall; t += step_mm) {
        const auto value = volume.sample(state.pose.outOf_W(start_W + t * ray_W));
        if (!value) {
          isOut = true;
          break;
        }
        if ((*value - middle) * sign > 0.0) {
          const double change = *value - valueBefore;
          wall = t - step_mm * (change != 0.0 && t > 0.2 ? (*value - middle) / change : 0.0);
        }
        valueBefore = *value;
      }
      clipped += isOut ? 1 : 0;
      if (!wall || std::fabs(*wall - along) > reach_mm) {
        ++missing;
        continue;
      }
      // A ray in the half-plane meets a slanted wall slightly later, which is negligible here.
      ++found;
      const Eigen::Vector3d point_W = start_W + *wall * ray_W;
      const NearTurns near = lumen.distances(point_W, 1.0);
      if (near.nearest >= 0)
        points.push_back(
            {point_W, near.turn[static_cast<std::size_t>(near.nearest)].gradient.normalized()});
      sum += *wall - along;
      squares += (*wall - along) * (*wall - along);
    }
  }
  SectionCheck check;
  check.missing = static_cast<double>(missing) / rays;
  check.clipped = static_cast<double>(clipped) / rays;
  if (found > 0) {
    check.bias_mm = sum / found;
    check.rms_mm = std::sqrt(squares / found);
  }
  check.kinematic = fitSpiralMotion(points);
  return check;
}

}  // namespace perilymph::ct
