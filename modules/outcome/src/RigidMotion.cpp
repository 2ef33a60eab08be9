// SPDX-License-Identifier: BSD-3-Clause
#include "RigidMotion.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "MetalGrid.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::outcome {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double radius_mm = 12.0;       // of the surroundings
constexpr double metalQuantile = 0.985;  // of the intensities: above, they are cut for the search
constexpr double coarseStep_mm = 2.0, mediumStep_mm = 1.0, fineStep_mm = 0.6;
constexpr double turnStep_deg = 12.0;
constexpr int turns = 2;  // to each side
constexpr double student = 4.0;
constexpr std::size_t kept = 8;
// parts of the time, as in phantoms of 0.3 mm (measured, medium); the rest is the fit on the voxels
constexpr double searchPart = 0.5, climbPart = 0.2;

/// A volume on an isotropic grid, cut at a level.
MetalGrid coarse(const ct::CtVolume& volume, double step, double level)
{
  MetalGrid grid;
  grid.step_mm = step;
  Vector3d low = Vector3d::Constant(1e9), high = -low;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d at = volume.toLps({corner & 1 ? volume.size()[0] - 1.0 : 0.0,
                                      corner & 2 ? volume.size()[1] - 1.0 : 0.0,
                                      corner & 4 ? volume.size()[2] - 1.0 : 0.0});
    low = low.cwiseMin(at);
    high = high.cwiseMax(at);
  }
  grid.first_P = low;
  for (std::size_t axis = 0; axis < 3; ++axis)
    grid.size[axis] =
        std::max(2, static_cast<int>((high - low)[static_cast<Eigen::Index>(axis)] / step) + 1);
  grid.value.assign(static_cast<std::size_t>(grid.size[0]) *
                        static_cast<std::size_t>(grid.size[1]) *
                        static_cast<std::size_t>(grid.size[2]),
                    -1e6F);
  const int parts = std::max(
      1, static_cast<int>(std::lround(step / std::max(0.3, volume.spacing_mm().minCoeff()))));
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        double sum = 0.0;
        int count = 0;
        for (int c = 0; c < parts; ++c)
          for (int b = 0; b < parts; ++b)
            for (int a = 0; a < parts; ++a) {
              const Vector3d off =
                  (step / parts) * (Vector3d(a, b, c) - Vector3d::Constant(0.5 * (parts - 1)));
              if (const auto value = volume.sample(grid.at_P(i, j, k) + off))
                sum += std::min(level, *value), ++count;
            }
        if (2 * count >= parts * parts * parts)
          grid.value[grid.index(i, j, k)] = static_cast<float>(sum / count);
      }
  return grid;
}

double levelOf(const ct::CtVolume& volume)
{
  std::vector<std::int16_t> values;
  for (std::size_t i = 0; i < volume.voxels().size(); i += 7)
    if (volume.voxels()[i] != ct::unmeasured) values.push_back(volume.voxels()[i]);
  if (values.empty()) return 1e9;
  const auto at =
      static_cast<std::ptrdiff_t>(metalQuantile * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return static_cast<double>(values[static_cast<std::size_t>(at)]);
}

struct Sample {
  Vector3d point;
  double value;
};

/// Points of a grid around a center.
std::vector<Sample> samplesOf(const MetalGrid& grid, const Vector3d& center)
{
  std::vector<Sample> samples;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const float value = grid.value[grid.index(i, j, k)];
        if (value > -1e5F && (grid.at_P(i, j, k) - center).norm() < radius_mm)
          samples.push_back({grid.at_P(i, j, k), static_cast<double>(value)});
      }
  return samples;
}

/// Nearest cell of a grid; nothing outside and where nothing was measured.
inline float nearest(const MetalGrid& grid, const Vector3d& point)
{
  const Vector3d x = (point - grid.first_P) / grid.step_mm;
  const int i = static_cast<int>(std::floor(x[0] + 0.5)),
            j = static_cast<int>(std::floor(x[1] + 0.5)),
            k = static_cast<int>(std::floor(x[2] + 0.5));
  if (i < 0 || j < 0 || k < 0 || i >= grid.size[0] || j >= grid.size[1] || k >= grid.size[2])
    return -1e6F;
  return grid.value[grid.index(i, j, k)];
}

/// Correlation of samples with a grid under a motion; -1 if less than two thirds of them lie in it.
double correlationOf(const std::vector<Sample>& samples, const MetalGrid& grid,
                     const RigidMotion& motion)
{
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
  for (const Sample& each : samples) {
    const float there = nearest(grid, motion.apply(each.point));
    if (there < -1e5F) continue;
    const auto v = static_cast<double>(there);
    n += 1.0, x += each.value, y += v, xx += each.value * each.value, yy += v * v,
        xy += each.value * v;
  }
  if (3.0 * n < 2.0 * static_cast<double>(samples.size()) || n < 20.0) return -1.0;
  const double varX = xx - x * x / n, varY = yy - y * y / n;
  return varX > 0.0 && varY > 0.0 ? (xy - x * y / n) / std::sqrt(varX * varY) : -1.0;
}

Matrix3d turned(const Vector3d& axisAngle)
{
  const double angle = axisAngle.norm();
  return angle > 0.0 ? Eigen::AngleAxisd(angle, axisAngle / angle).toRotationMatrix()
                     : Matrix3d::Identity();
}

/// Gauss-Newton on the intensities, with Student-t weights, without points on metal.
void refine(const ct::CtVolume& to, const std::vector<Sample>& samples, double metalLevel,
            int rounds, RigidMotion& motion)
{
  const double h = std::max(0.15, 0.5 * to.spacing_mm().mean());
  struct Row {
    double from, there;
    Vector3d gradient, arm;
  };
  std::vector<Row> rows;
  double scale = 0.0;
  for (int round = 0; round < rounds; ++round) {
    rows.clear();
    for (const Sample& each : samples) {
      const Vector3d at = motion.apply(each.point);
      const auto value = to.sample(at);
      if (!value || *value > metalLevel) continue;
      Vector3d gradient;
      bool isWhole = true;
      for (int axis = 0; axis < 3 && isWhole; ++axis) {
        const auto up = to.sample(at + h * Vector3d::Unit(axis)),
                   down = to.sample(at - h * Vector3d::Unit(axis));
        isWhole = up && down && *up < metalLevel && *down < metalLevel;
        if (isWhole) gradient[axis] = (*up - *down) / (2.0 * h);
      }
      if (isWhole) rows.push_back({each.value, *value, gradient, each.point - motion.center});
    }
    if (rows.size() < 100) return;
    // a line between both scanners' intensities
    double a = 0.0, b = 1.0;
    for (int again = 0; again < 3; ++again) {
      double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
      for (const Row& row : rows) {
        const double r = row.there - a - b * row.from;
        const double w = scale > 0.0 ? 1.0 / (student + r * r / (scale * scale)) : 1.0;
        n += w, x += w * row.from, y += w * row.there, xx += w * row.from * row.from,
            xy += w * row.from * row.there;
      }
      const double var = xx - x * x / n;
      if (var <= 0.0) return;
      b = (xy - x * y / n) / var;
      a = (y - b * x) / n;
      std::vector<double> left;
      for (const Row& row : rows) left.push_back(std::fabs(row.there - a - b * row.from));
      std::nth_element(left.begin(), left.begin() + static_cast<std::ptrdiff_t>(left.size() / 2),
                       left.end());
      scale = std::max(20.0, left[left.size() / 2] / 0.6745);
    }
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 1> right = Eigen::Matrix<double, 6, 1>::Zero();
    double squares = 0.0, gradients = 0.0;
    for (const Row& row : rows) {
      const double r = row.there - a - b * row.from;
      const double w = (student + 1.0) / (student + r * r / (scale * scale));
      Eigen::Matrix<double, 6, 1> slope;
      slope << (motion.rotation * row.arm).cross(row.gradient), row.gradient;
      normal += w * slope * slope.transpose();
      right -= w * r * slope;
      squares += w * r * r;
      gradients += w * row.gradient.squaredNorm() / 3.0;
    }
    normal.diagonal() *= 1.0 + 1e-6;
    Eigen::Matrix<double, 6, 1> step = normal.ldlt().solve(right);
    if (!step.allFinite()) return;
    const double largest = std::max(step.tail<3>().norm(), radius_mm * step.head<3>().norm());
    if (largest > 1.0) step /= largest;
    motion.rotation = turned(step.head<3>()) * motion.rotation;
    motion.shift += step.tail<3>();
    motion.residual_mm = std::sqrt(squares / std::max(1e-9, gradients));
    if (largest < 1e-3) break;
  }
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, yy = 0.0, xy = 0.0;
  for (const Row& row : rows)
    n += 1.0, x += row.from, y += row.there, xx += row.from * row.from, yy += row.there * row.there,
        xy += row.from * row.there;
  motion.correlation =
      (xy - x * y / n) / std::sqrt(std::max(1e-9, (xx - x * x / n) * (yy - y * y / n)));
}

}  // namespace

Result<RigidMotion> registration(const ct::CtVolume& from, const Vector3d& center_P,
                                 const ct::CtVolume& to, const std::stop_token& stop,
                                 const std::function<void(double)>& onProgress)
{
  const auto report = [&](double done) {
    if (onProgress) onProgress(done);
  };
  const double fromLevel = levelOf(from), toLevel = levelOf(to);
  const std::vector<Sample> few = samplesOf(coarse(from, coarseStep_mm, fromLevel), center_P);
  const std::vector<Sample> more = samplesOf(coarse(from, mediumStep_mm, fromLevel), center_P);
  const MetalGrid coarseTo = coarse(to, coarseStep_mm, toLevel),
                  mediumTo = coarse(to, mediumStep_mm, toLevel);
  if (few.size() < 50)
    return Error{
        "The CT before surgery shows too little around the cochlea to be compared with that after "
        "it. Choose the series in which the cochlea was measured."};

  std::vector<RigidMotion> best;
  const auto keep = [&](const RigidMotion& motion) {
    best.push_back(motion);
    std::stable_sort(best.begin(), best.end(), [](const RigidMotion& a, const RigidMotion& b) {
      return a.correlation > b.correlation;
    });
    if (best.size() > kept) best.pop_back();
  };
  for (int x = -turns; x <= turns; ++x)
    for (int y = -turns; y <= turns; ++y)
      for (int z = -turns; z <= turns; ++z) {
        if (stop.stop_requested()) return Error{"The registration was canceled."};
        constexpr int places = 2 * turns + 1;
        const int place = ((x + turns) * places + y + turns) * places + z + turns;
        report(searchPart * place / (places * places * places));
        RigidMotion motion;
        motion.center = center_P;
        motion.rotation = turned(degrees(turnStep_deg).si() * Vector3d(x, y, z));
        for (int k = 0; k < coarseTo.size[2]; ++k)
          for (int j = 0; j < coarseTo.size[1]; ++j)
            for (int i = 0; i < coarseTo.size[0]; ++i) {
              motion.shift = coarseTo.at_P(i, j, k) - center_P;
              motion.correlation = correlationOf(few, coarseTo, motion);
              if (motion.correlation > 0.0 &&
                  (best.size() < kept || motion.correlation > best.back().correlation))
                keep(motion);
            }
      }
  if (best.empty())
    return Error{
        "The two CTs show no common surroundings of the cochlea. Check that both are of the same "
        "patient and ear."};

  // hill climbing on the finer grid
  std::vector<RigidMotion> starts;
  std::swap(starts, best);
  for (std::size_t i = 0; i < starts.size(); ++i) {
    if (stop.stop_requested()) return Error{"The registration was canceled."};
    report(searchPart + climbPart * static_cast<double>(i) / static_cast<double>(starts.size()));
    RigidMotion motion = starts[i];
    motion.correlation = correlationOf(more, mediumTo, motion);
    for (double size = 1.0; size > 0.2; size *= 0.5)
      for (bool isBetter = true; isBetter;) {
        isBetter = false;
        for (int axis = 0; axis < 6; ++axis)
          for (const double sign : {-1.0, 1.0}) {
            RigidMotion next = motion;
            if (axis < 3)
              next.shift[axis] += sign * size;
            else
              next.rotation =
                  turned(sign * size * degrees(5).si() * Vector3d::Unit(axis - 3)) * next.rotation;
            next.correlation = correlationOf(more, mediumTo, next);
            if (next.correlation > motion.correlation + 1e-6) motion = next, isBetter = true;
          }
      }
    keep(motion);
  }

  // on the voxels
  const std::vector<Sample> fine = samplesOf(coarse(from, fineStep_mm, 1e9), center_P);
  const double metalLevel = 1.15 * toLevel + 300.0;
  RigidMotion found;
  const std::size_t refined = std::min<std::size_t>(3, best.size());
  for (std::size_t i = 0; i < refined; ++i) {
    if (stop.stop_requested()) return Error{"The registration was canceled."};
    report(searchPart + climbPart +
           (1.0 - searchPart - climbPart) * static_cast<double>(i) / static_cast<double>(refined));
    RigidMotion motion = best[i];
    refine(to, more, metalLevel, 15, motion);
    refine(to, fine, metalLevel, 10, motion);
    if (motion.correlation > found.correlation) found = motion;
  }
  return found;
}

}  // namespace perilymph::outcome
