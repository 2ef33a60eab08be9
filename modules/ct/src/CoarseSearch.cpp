// SPDX-License-Identifier: BSD-3-Clause
#include "CoarseSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

constexpr int axisDirections = 160;  // 16 degrees apart
constexpr int rolls = 16;
constexpr double offsetStep = 1.4;  // [mm]
constexpr std::size_t polished = 1200;

/// The center of the basal turn in W, near which a click into the cochlea is expected.
const Eigen::Vector3d middle_W(0.8, 0.0, 0.8);

/// Similarity of a grid point to lumen: 1 at its level, 0 at bone's and at other levels, such as
/// air in an ear filled with fluid.
class Likeness {
public:
  Likeness(const Region& region, double bone, double lumen)
      : count_(region.count()), corner_(region.corner_P())
  {
    const auto n = static_cast<std::size_t>(count_);
    values_.resize(n * n * n);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const double fraction = (static_cast<double>(region.value(i)) - bone) / (lumen - bone);
      double likeness = std::clamp(fraction, 0.0, 1.0);
      if (fraction > 1.25) likeness = std::max(0.0, 1.0 - 4.0 * (fraction - 1.25));
      // Unknown points outside the volume are neutral.
      values_[i] = region.isKnown(i) ? static_cast<float>(likeness) : 0.5F;
    }
  }

  /// From W to the grid's indices, which are the whole parts of the three rows' values.
  using Rows = std::array<std::array<double, 4>, 3>;
  Rows rowsOf(const Pose& pose) const
  {
    Rows rows{};
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      auto& row = rows[static_cast<std::size_t>(axis)];
      for (Eigen::Index i = 0; i < 3; ++i)
        row[static_cast<std::size_t>(i)] = pose.axes_PW(axis, i) / Region::step;
      row[3] = (pose.origin_P[axis] - corner_[axis]) / Region::step + 0.5;
    }
    return rows;
  }

  /// The value at the grid's nearest point: in plain numbers, because a search asks millions of times.
  float nearest(const Rows& rows, const Eigen::Vector3d& point_W) const
  {
    const double* const w = point_W.data();
    const auto along = [w](const std::array<double, 4>& row) {
      return static_cast<int>(row[0] * w[0] + row[1] * w[1] + row[2] * w[2] + row[3]);
    };
    return inGrid(along(rows[0]), along(rows[1]), along(rows[2]));
  }

private:
  float inGrid(int i, int j, int k) const
  {
    if (i < 0 || j < 0 || k < 0 || i >= count_ || j >= count_ || k >= count_) return 0.5F;
    const auto n = static_cast<std::size_t>(count_);
    return values_[(static_cast<std::size_t>(k) * n + static_cast<std::size_t>(j)) * n +
                   static_cast<std::size_t>(i)];
  }

  int count_;
  Eigen::Vector3d corner_;
  std::vector<float> values_;
};

double score(const Likeness& image, const Template& points, const Pose& pose, std::size_t stride)
{
  const Likeness::Rows rows = image.rowsOf(pose);
  double inside = 0.0, outside = 0.0;
  std::size_t insideCount = 0, outsideCount = 0;
  for (std::size_t i = 0; i < points.inside_W.size(); i += stride, ++insideCount)
    inside += static_cast<double>(image.nearest(rows, points.inside_W[i]));
  for (std::size_t i = 0; i < points.outside_W.size(); i += stride, ++outsideCount)
    outside += static_cast<double>(image.nearest(rows, points.outside_W[i]));
  return inside / static_cast<double>(insideCount) - outside / static_cast<double>(outsideCount);
}

/// Axes whose z is a direction of a Fibonacci sphere, rolled about it.
Eigen::Matrix3d axesOf(int direction, int roll, bool isRight)
{
  const double z = 1.0 - (2.0 * direction + 1.0) / axisDirections;
  const double r = std::sqrt(1.0 - z * z);
  const SineCosine around = sineCosine(direction * pi * (3.0 - std::sqrt(5.0)));
  const Eigen::Vector3d axis(r * around.cosine, r * around.sine, z);
  const Eigen::Vector3d other =
      std::fabs(z) < 0.7 ? Eigen::Vector3d::UnitZ().eval() : Eigen::Vector3d::UnitX().eval();
  const Eigen::Vector3d x = other.cross(axis).normalized();
  const Eigen::Vector3d y = axis.cross(x);
  const SineCosine turn = sineCosine(2.0 * pi * roll / rolls);
  Eigen::Matrix3d axes;
  axes.col(0) = turn.cosine * x + turn.sine * y;
  axes.col(1) = turn.cosine * y - turn.sine * x;
  if (!isRight) axes.col(1) = -axes.col(1);
  axes.col(2) = axis;
  return axes;
}

/// Improves a pose by hill climbing in steps along and about the axes of W.
Candidate climb(const Likeness& image, const Template& points, Candidate candidate)
{
  candidate.score = score(image, points, candidate.pose, 1);
  for (const double step : {1.0, 0.5, 0.25}) {
    const double turn = 0.2 * step, shift = 0.7 * step;
    for (int round = 0; round < 2; ++round)
      for (int move = 0; move < 12; ++move) {
        Eigen::Vector3d by = Eigen::Vector3d::Zero();
        by[move % 3] = (move / 3) % 2 == 0 ? 1.0 : -1.0;
        const bool isTurn = move < 6;
        const Pose pose =
            candidate.pose.moved((isTurn ? turn : 0.0) * by, (isTurn ? 0.0 : shift) * by);
        const double better = score(image, points, pose, 1);
        if (better > candidate.score) candidate = {pose, better};
      }
  }
  return candidate;
}

bool isSame(const Pose& a, const Pose& b)
{
  return a.isRight() == b.isRight() && (a.origin_P - b.origin_P).norm() < 0.7 &&
         a.axes_PW.col(2).dot(b.axes_PW.col(2)) > 0.97 &&
         a.axes_PW.col(0).dot(b.axes_PW.col(0)) > 0.9;
}

}  // namespace

Template meanTemplate(const LumenShape& family)
{
  Template result;
  const ShapeVector q = LumenShape::priorMean();
  const ShapedLumen lumen(family, q);
  const MeanLumen& mean = family.mean();
  for (int angle_deg = 20; angle_deg <= 660; angle_deg += 20) {
    const double angle = degrees(angle_deg).si();
    const SectionPlace place = lumen.place(angle);
    const SineCosine direction = sineCosine(angle);
    const auto add = [&](double u, double v, std::vector<Eigen::Vector3d>& to, double low,
                         double high) {
      const double r = place.outer + u;
      if (r < 0.1) return;
      const Eigen::Vector3d point(r * direction.cosine, r * direction.sine, place.middle + v);
      const NearTurns near = lumen.distances(point, 1.5);
      const double inside =
          near.nearest < 0 ? -1.5 : near.turn[static_cast<std::size_t>(near.nearest)].inside;
      if (inside >= low && inside <= high) to.push_back(point);
    };
    const double width = mean.width(angle), half = place.height * mean.halfHeight(angle);
    add(-0.3 * width, 0.0, result.inside_W, 0.25, 2.0);
    add(-0.6 * width, 0.0, result.inside_W, 0.25, 2.0);
    add(0.45, 0.0, result.outside_W, -1.5, -0.3);
    add(0.25, 0.7 * half, result.outside_W, -1.5, -0.3);
    add(0.25, -0.7 * half, result.outside_W, -1.5, -0.3);
    add(-0.4 * width, half + 0.45, result.outside_W, -1.5, -0.3);
    add(-0.4 * width, -half - 0.45, result.outside_W, -1.5, -0.3);
    // The modiolus between the first turn and the axis.
    if (angle_deg < 360) add(-width - 0.5, 0.0, result.outside_W, -1.5, -0.3);
  }
  return result;
}

std::vector<Candidate> searchPoses(const Region& region, double bone, double lumen,
                                   const Template& points, const Eigen::Vector3d& near_P,
                                   double reach_mm, std::size_t count,
                                   const std::function<bool()>& isStopped)
{
  const Likeness image(region, bone, lumen);
  const int steps = static_cast<int>(std::ceil(reach_mm / offsetStep));
  std::vector<Eigen::Vector3d> offsets;
  for (int k = -steps; k <= steps; ++k)
    for (int j = -steps; j <= steps; ++j)
      for (int i = -steps; i <= steps; ++i) {
        const Eigen::Vector3d offset = offsetStep * Eigen::Vector3d(i, j, k);
        if (offset.norm() <= reach_mm) offsets.push_back(offset);
      }
  std::vector<Candidate> found;
  for (int direction = 0; direction < axisDirections; ++direction) {
    if (isStopped()) return {};
    for (int roll = 0; roll < rolls; ++roll)
      for (const bool isRight : {true, false}) {
        const Eigen::Matrix3d axes = axesOf(direction, roll, isRight);
        // The best position of every orientation.
        Candidate best{{}, -10.0};
        for (const Eigen::Vector3d& offset : offsets) {
          const Pose pose{axes, near_P + offset - axes * middle_W};
          const double here = score(image, points, pose, 4);
          if (here > best.score) best = {pose, here};
        }
        found.push_back(best);
      }
  }
  const auto better = [](const Candidate& a, const Candidate& b) { return a.score > b.score; };
  std::stable_sort(found.begin(), found.end(), better);
  found.resize(std::min(found.size(), polished));
  for (Candidate& candidate : found) candidate = climb(image, points, candidate);
  std::stable_sort(found.begin(), found.end(), better);
  std::vector<Candidate> distinct;
  for (const Candidate& candidate : found) {
    if (distinct.size() == count) break;
    if (std::none_of(distinct.begin(), distinct.end(),
                     [&](const Candidate& other) { return isSame(other.pose, candidate.pose); }))
      distinct.push_back(candidate);
  }
  return distinct;
}

}  // namespace perilymph::ct
