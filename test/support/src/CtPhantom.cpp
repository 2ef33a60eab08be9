// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/test/CtPhantom.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "CtPhantomAnatomy.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::test {
namespace {

constexpr double fieldOfView_mm = 19.0;
constexpr double maxHu = 3071.0, minHu = -1024.0;  // 12 bits
constexpr double maxExtendedHu = 30710.0;
// The clinical axis is inclined against that of the sections as in the mean cochlea: from the
// center of the modiolus in the basal turn to that of the cupola.
const Eigen::Vector3d clinicalAxis_W = Eigen::Vector3d(0.001, 0.092, 1.0).normalized();
const Eigen::Vector3d base_W(0.0, 0.0, 0.4);

struct Grid {
  std::array<int, 3> size;
  std::vector<float> values;
  std::size_t index(int i, int j, int k) const
  {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size[0]) +
           static_cast<std::size_t>(i);
  }
};

/// Separable Gaussian along one axis, with constant extrapolation.
void blur(Grid& grid, int axis, double sigma)
{
  if (sigma <= 0.0) return;
  const int reach = std::max(1, static_cast<int>(std::ceil(3.0 * sigma)));
  std::vector<float> kernel;
  float sum = 0.0F;
  for (int d = -reach; d <= reach; ++d) {
    kernel.push_back(static_cast<float>(std::exp(-0.5 * d * d / (sigma * sigma))));
    sum += kernel.back();
  }
  const auto n = grid.size[static_cast<std::size_t>(axis)];
  const std::size_t stride = axis == 0   ? 1
                             : axis == 1 ? static_cast<std::size_t>(grid.size[0])
                                         : static_cast<std::size_t>(grid.size[0] * grid.size[1]);
  const auto count = static_cast<std::size_t>(n), margin = static_cast<std::size_t>(reach);
  std::vector<float> line(count + 2 * margin);  // with its ends repeated
  std::vector<float> blurred(count);
  for (std::size_t start = 0; start < grid.values.size(); ++start) {
    if ((start / stride) % count != 0) continue;
    for (std::size_t i = 0; i < count; ++i) line[margin + i] = grid.values[start + stride * i];
    std::fill_n(line.begin(), margin, line[margin]);
    std::fill_n(line.end() - reach, margin, line[margin + count - 1]);
    std::fill(blurred.begin(), blurred.end(), 0.0F);
    for (std::size_t d = 0; d < kernel.size(); ++d)
      for (std::size_t i = 0; i < count; ++i) blurred[i] += kernel[d] * line[i + d];
    for (std::size_t i = 0; i < count; ++i) grid.values[start + stride * i] = blurred[i] / sum;
  }
}

void blur(Grid& grid, double inPlane, double axial)
{
  blur(grid, 0, inPlane);
  blur(grid, 1, inPlane);
  blur(grid, 2, axial);
}

/// Sharpens like bone kernels: adds a part of the difference to a wider blur.
void sharpen(Grid& grid, double inPlane, double strength)
{
  Grid wide = grid;
  blur(wide, inPlane, 0.0);
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    grid.values[i] += static_cast<float>(strength) * (grid.values[i] - wide.values[i]);
}

/// The outermost point of a half-plane through the axis.
struct Outermost {
  double radius;
  Eigen::Vector3d point_W;
};

/// Measures the ground truth on the geometry: scans half-planes of the clinical frame point by
/// point. The landmarks are in W.
void measureTruth(const PhantomAnatomy& anatomy, CtPhantom& phantom)
{
  const Eigen::Vector3d window = anatomy.roundWindow_W();
  const Eigen::Vector3d origin = base_W + (window - base_W).dot(clinicalAxis_W) * clinicalAxis_W;
  const Eigen::Vector3d x = (window - origin).normalized();
  const Eigen::Vector3d y = clinicalAxis_W.cross(x);
  const auto outermost = [&](double angle) {
    const Eigen::Vector3d out = std::cos(angle) * x + std::sin(angle) * y;
    double best = 0.0, height = 0.0;
    for (double z = -1.5; z < 2.5; z += 0.02)
      for (double r = 6.5; r > std::max(best, 1.8); r -= 0.005)
        if (anatomy.inside(origin + r * out + z * clinicalAxis_W) >= 0.0) {
          best = r;
          height = z;
        }
    return Outermost{best, origin + best * out + height * clinicalAxis_W};
  };
  const Outermost far = outermost(pi), near = outermost(0.5 * pi), other = outermost(1.5 * pi);
  phantom.a = (window - origin).norm() + far.radius;
  phantom.b = near.radius + other.radius;
  phantom.marks[ct::Mark::roundWindow] = window;
  phantom.marks[ct::Mark::farWall] = far.point_W;
  phantom.marks[ct::Mark::nearB] = near.point_W;
  phantom.marks[ct::Mark::farB] = other.point_W;
  phantom.marks[ct::Mark::modiolus] = origin;
  double low = 1e9, high = -1e9;
  for (double angle = degrees(20).si(); angle < anatomy.lastAngle(); angle += 0.03) {
    const KidneySection section = anatomy.sectionAt(angle);
    for (int k = 0; k < 90; ++k) {
      const double t = 2.0 * pi * k / 90.0;
      const double u = (std::cos(t) > 0.0 ? section.outward : section.inward) * std::cos(t);
      const double v = section.half * std::sin(t) + section.shear * u + section.bend * u * u;
      const double r = section.middleRadius + u;
      const Eigen::Vector3d point(r * std::cos(angle), r * std::sin(angle),
                                  section.middleHeight + v);
      const double z = (point - origin).dot(clinicalAxis_W);
      low = std::min(low, z);
      high = std::max(high, z);
    }
  }
  phantom.h = high - low;
  phantom.marks[ct::Mark::floor] = origin + low * clinicalAxis_W;
  phantom.marks[ct::Mark::apex] = origin + high * clinicalAxis_W;
}

}  // namespace

Eigen::Vector3d jitteredClick(const CtPhantom& phantom, std::uint64_t seed)
{
  Dice dice(seed + 77);
  return phantom.inside_P + 0.5 * Eigen::Vector3d(dice.normal(), dice.normal(), dice.normal());
}

PhantomScan coneBeamScan() { return {{0.15, 0.15, 0.15}, 0.16, 0.16, 120.0, false}; }
PhantomScan highResolutionScan() { return {{0.3, 0.3, 0.3}, 0.22, 0.22, 120.0, false}; }
PhantomScan clinicalScan() { return {{0.45, 0.45, 0.6}, 0.33, 0.33, 80.0, false}; }

CtPhantom makeCtPhantom(std::uint64_t seed, const PhantomScan& scan,
                        const PhantomCondition& condition)
{
  const PhantomAnatomy anatomy(seed, condition);
  Dice dice(seed ^ 0x9e3779b97f4a7c15U);

  // Arbitrary orientation: a rotation about any axis, and either ear.
  const Eigen::Vector3d about =
      Eigen::Vector3d(dice.normal(), dice.normal(), dice.normal()).normalized();
  Eigen::Matrix3d axes = Eigen::AngleAxisd(dice.uniform(0.0, pi), about).toRotationMatrix();
  const bool isDicedRight = dice.uniform(0.0, 1.0) < 0.5;
  const bool isRight = condition.isRight.value_or(isDicedRight);
  if (!isRight) axes.col(0) = -axes.col(0);
  Eigen::Vector3d origin_P(dice.uniform(-40, 40), dice.uniform(-40, 40), dice.uniform(-100, 100));
  const Eigen::Vector3d middle_W(1.2, -0.4, 0.6);

  // The volume's own axes are oblique, too, with its center displaced by up to 1.5 mm.
  Eigen::Matrix3d tilt =
      Eigen::AngleAxisd(degrees(dice.uniform(-15, 15)).si(),
                        Eigen::Vector3d(dice.normal(), dice.normal(), dice.normal()).normalized())
          .toRotationMatrix();
  const Eigen::Vector3d displaced(dice.uniform(-1.5, 1.5), dice.uniform(-1.5, 1.5),
                                  dice.uniform(-1.5, 1.5));
  if (condition.center_P) {
    origin_P = *condition.center_P - axes * middle_W - displaced;
    tilt.setIdentity();
  }
  const Eigen::Vector3d center_P = origin_P + axes * middle_W + displaced;

  // Fine grid: an integer number of its cells per voxel.
  std::array<int, 3> times{}, coarse{};
  Grid fine{};
  Eigen::Vector3d cell;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double spacing = scan.spacing_mm[static_cast<Eigen::Index>(axis)];
    times[axis] = std::max(1, static_cast<int>(std::ceil(spacing / 0.16)));
    cell[static_cast<Eigen::Index>(axis)] = spacing / times[axis];
    coarse[axis] = static_cast<int>(fieldOfView_mm / spacing);
    fine.size[axis] = coarse[axis] * times[axis];
  }
  fine.values.resize(static_cast<std::size_t>(fine.size[0]) *
                     static_cast<std::size_t>(fine.size[1]) *
                     static_cast<std::size_t>(fine.size[2]));
  Eigen::Matrix4d lps = Eigen::Matrix4d::Identity();
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    lps.block<3, 1>(0, axis) = tilt.col(axis) * scan.spacing_mm[axis];
  const Eigen::Vector3d half(0.5 * (coarse[0] - 1), 0.5 * (coarse[1] - 1), 0.5 * (coarse[2] - 1));
  lps.topRightCorner<3, 1>() = center_P - lps.topLeftCorner<3, 3>() * half;

  const double lumen = scan.isAirFilled ? -880.0 : 100.0;
  for (int k = 0; k < fine.size[2]; ++k)
    for (int j = 0; j < fine.size[1]; ++j)
      for (int i = 0; i < fine.size[0]; ++i) {
        // Centers of the fine cells in units of voxels.
        const Eigen::Vector3d index((i + 0.5) / times[0] - 0.5, (j + 0.5) / times[1] - 0.5,
                                    (k + 0.5) / times[2] - 0.5);
        const Eigen::Vector3d point_P =
            lps.topLeftCorner<3, 3>() * index + lps.topRightCorner<3, 1>();
        fine.values[fine.index(i, j, k)] = static_cast<float>(
            anatomy.intensity(axes.transpose() * (point_P - origin_P), lumen, cell.mean()));
      }
  blur(fine, scan.blurInPlane_mm / cell[0], scan.blurAxial_mm / cell[2]);
  sharpen(fine, 1.5 * scan.blurInPlane_mm / cell[0], dice.uniform(0.15, 0.3));

  // Voxels average their cells; the noise has the spectrum of the kernel.
  Grid noise{coarse, {}};
  noise.values.resize(static_cast<std::size_t>(coarse[0]) * static_cast<std::size_t>(coarse[1]) *
                      static_cast<std::size_t>(coarse[2]));
  for (float& value : noise.values) value = static_cast<float>(dice.normal());
  blur(noise, 0.6, 0.5);
  sharpen(noise, 1.2, 0.6);
  double power = 0.0;
  for (const float value : noise.values)
    power += static_cast<double>(value) * static_cast<double>(value);
  const double scale = scan.noise / std::sqrt(power / static_cast<double>(noise.values.size()));

  const double highest = condition.isExtended ? maxExtendedHu : maxHu;
  std::vector<std::int16_t> voxels;
  voxels.reserve(noise.values.size());
  for (int k = 0; k < coarse[2]; ++k)
    for (int j = 0; j < coarse[1]; ++j)
      for (int i = 0; i < coarse[0]; ++i) {
        double sum = 0.0;
        for (int c = 0; c < times[2]; ++c)
          for (int b = 0; b < times[1]; ++b)
            for (int a = 0; a < times[0]; ++a)
              sum += static_cast<double>(
                  fine.values[fine.index(i * times[0] + a, j * times[1] + b, k * times[2] + c)]);
        const double mean = sum / (times[0] * times[1] * times[2]);
        const double value = mean + scale * static_cast<double>(noise.values[noise.index(i, j, k)]);
        voxels.push_back(static_cast<std::int16_t>(std::lround(std::clamp(value, minHu, highest))));
      }
  auto volume = ct::CtVolume::make(coarse, lps, std::move(voxels), {"", "", "phantom"});
  if (!volume) throw std::runtime_error(volume.error().message);
  CtPhantom phantom{std::move(*volume), 0.0, 0.0, 0.0, true, {}, {}, {}, {}, {}};
  phantom.isRight = isRight;
  measureTruth(anatomy, phantom);
  const auto toP = [&](const Eigen::Vector3d& point_W) -> Eigen::Vector3d {
    return origin_P + axes * point_W;
  };
  for (auto& point : phantom.marks.points_P)
    if (point) point = toP(*point);
  phantom.pose_PW.setIdentity();
  phantom.pose_PW.topLeftCorner<3, 3>() = axes;
  phantom.pose_PW.topRightCorner<3, 1>() = origin_P;
  phantom.axis_P = axes * clinicalAxis_W;
  phantom.roundWindow_P = toP(anatomy.roundWindow_W());
  const KidneySection basal = anatomy.sectionAt(degrees(60).si());
  phantom.inside_P =
      toP({0.5 * basal.middleRadius, 0.866 * basal.middleRadius, basal.middleHeight});
  return phantom;
}

}  // namespace perilymph::test
