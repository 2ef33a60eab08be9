#include "perilymph/test/RealEarTruth.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Units.h"

namespace perilymph::test {
namespace {

constexpr double half = 50.0;  // labels are 0 and 100
constexpr double far_mm = 1.5;

double outermost(const RealEar& ear, double angle, double high_mm)
{
  double best = 0.0;
  for (double z = -1.3; z <= high_mm; z += 0.05)
    // No cochlea is wider; further out lie vestibule and canals.
    for (double r = 5.5; r > std::max(best, 0.5); r -= 0.01) {
      const auto label =
          ear.label.sample(ear.center_P + ear.axes_PW * Eigen::Vector3d(r * std::cos(angle),
                                                                        r * std::sin(angle), z));
      if (label && *label >= half) best = r;
    }
  return best;
}

}  // namespace

LabelMeasures measureLabel(const RealEar& ear)
{
  const double window =
      (ear.axes_PW.transpose() * (ear.roundWindow_P - ear.center_P)).head<2>().norm();
  return {window + outermost(ear, pi, 1.5),
          outermost(ear, 0.5 * pi, 1.5) + outermost(ear, 1.5 * pi, 1.0)};
}

Eigen::Vector3d clickOf(const RealEar& ear)
{
  return 0.7 * ear.center_P + 0.3 * ear.apex_P + ear.axes_PW * Eigen::Vector3d(1.5, 0.8, 0.0);
}

double meanDistanceToLabel(const RealEar& ear, const ct::CochleaMeasures& found)
{
  const std::size_t around = found.wallPointsPerRing;
  const std::size_t rings = found.wall_P.size() / around;
  double sum = 0.0;
  int count = 0;
  for (std::size_t ring = 5; ring + 1 < std::min<std::size_t>(rings, 180); ++ring)
    for (std::size_t k = 0; k < around; ++k) {
      // The inner third looks at the modiolus, where labels follow no bone.
      if (k > around / 3 && k < 2 * around / 3) continue;
      const auto at = [&](std::size_t r, std::size_t c) -> const Eigen::Vector3d& {
        return found.wall_P[r * around + c % around];
      };
      Eigen::Vector3d normal =
          (at(ring + 1, k) - at(ring - 1, k)).cross(at(ring, k + 1) - at(ring, k + around - 1));
      if (normal.norm() < 1e-6) continue;
      normal.normalize();
      double distance = far_mm;
      const auto isInside = [&](double along) {
        const auto label = ear.label.sample(at(ring, k) + along * normal);
        return label && *label >= half;
      };
      for (double along = 0.0; along < far_mm; along += 0.02)
        if (isInside(along) != isInside(along + 0.02) ||
            isInside(-along) != isInside(-along - 0.02)) {
          distance = along;
          break;
        }
      sum += distance;
      ++count;
    }
  return count > 0 ? sum / count : far_mm;
}

}  // namespace perilymph::test
