// SPDX-License-Identifier: BSD-3-Clause
#include "CoarseSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stop_token>

#include "perilymph/foundation/Four.h"
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

constexpr double infinitelyMuch = std::numeric_limits<double>::infinity();

/// Indices that the compiler computes together, as many as the machine's lanes hold.
constexpr std::size_t block = 32;

/// Points by coordinate, with zeros up to a whole number of blocks.
class Points {
public:
  explicit Points(std::size_t size) : size_(size)
  {
    for (std::vector<double>& each : along) each.resize((size + block - 1) / block * block);
  }
  Points(const std::vector<Eigen::Vector3d>& points_W, std::size_t stride)
      : Points((points_W.size() + stride - 1) / stride)
  {
    for (std::size_t i = 0; i < size_; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        along[axis][i] = points_W[i * stride][static_cast<Eigen::Index>(axis)];
  }
  std::size_t size() const { return size_; }

  std::array<std::vector<double>, 3> along;

private:
  std::size_t size_;
};

/// Similarity of a grid point to lumen: 1 at its level, 0 at bone's and at other levels, such as
/// air in an ear filled with fluid. A search asks for hundreds of millions.
class TemplateScore {
public:
  TemplateScore(const Region& region, double bone, double lumen)
      : count_(region.count()), corner_(region.corner_P())
  {
    const auto n = static_cast<std::size_t>(count_);
    values_.resize(n * n * n);
    for (std::size_t i = 0; i < values_.size(); ++i) {
      const double fraction = (static_cast<double>(region.value(i)) - bone) / (lumen - bone);
      double likeness = std::clamp(fraction, 0.0, 1.0);
      if (fraction > 1.25) likeness = std::max(0.0, 1.0 - 4.0 * (fraction - 1.25));
      // Without smaller values every sum of theirs is exact, in any order.
      if (likeness < smallest) likeness = 0.0;
      // Unknown points outside the volume are neutral.
      values_[i] = region.isKnown(i) ? static_cast<float>(likeness) : neutral;
    }
    values_.push_back(neutral);  // what lies outside of the grid
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

  /// The sum of the values at the grid's points nearest to those of one pose, which grows from point to
  /// point; summing ends where it is above `enough`.
  double sum(const Rows& rows, const Points& points, double enough = infinitelyMuch) const
  {
    double result = 0.0;
    withLanes([&]() PERILYMPH_KERNEL { result = sumInLanes(rows, points, enough); });
    return result;
  }

  /// Adds to `sums` those of many poses that differ by their origins alone.
  ///
  /// @param rows     Those of one of them.
  /// @param origins  The last number of each row, of every pose.
  void addSums(const Rows& rows, const Points& origins, const Points& points,
               std::vector<double>& sums) const
  {
    withLanes([&]() PERILYMPH_KERNEL { addSumsInLanes(rows, origins, points, sums); });
  }

private:
  PERILYMPH_IN_LANES double sumInLanes(const Rows& rows, const Points& points, double enough) const
  {
    const float* const values = values_.data();
    std::array<double, 4> sums{};  // which do not wait for each other
    for (std::size_t from = 0; from < points.size(); from += block) {
      const double* const x = points.along[0].data() + from;
      const double* const y = points.along[1].data() + from;
      const double* const z = points.along[2].data() + from;
      const auto along = [&](const std::array<double, 4>& row, std::size_t i) PERILYMPH_KERNEL {
        return static_cast<int>(row[0] * x[i] + row[1] * y[i] + row[2] * z[i] + row[3]);
      };
      std::array<unsigned, block> indices;
      for (std::size_t i = 0; i < block; ++i)
        indices[i] = indexOf(along(rows[0], i), along(rows[1], i), along(rows[2], i));
      const std::size_t count = std::min(block, points.size() - from);
      if (count == block) {
        for (std::size_t i = 0; i < block; i += sums.size())
          for (std::size_t k = 0; k < sums.size(); ++k)
            sums[k] += static_cast<double>(values[indices[i + k]]);
      } else {
        for (std::size_t i = 0; i < count; ++i) sums[0] += static_cast<double>(values[indices[i]]);
      }
      if ((sums[0] + sums[1]) + (sums[2] + sums[3]) > enough) break;
    }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
  }

  PERILYMPH_IN_LANES void addSumsInLanes(const Rows& rows, const Points& origins,
                                         const Points& points, std::vector<double>& sums) const
  {
    const float* const values = values_.data();
    for (std::size_t point = 0; point < points.size(); ++point) {
      std::array<double, 3> turned{};
      for (std::size_t axis = 0; axis < 3; ++axis)
        turned[axis] = rows[axis][0] * points.along[0][point] +
                       rows[axis][1] * points.along[1][point] +
                       rows[axis][2] * points.along[2][point];
      for (std::size_t from = 0; from < sums.size(); from += block) {
        const double* const x = origins.along[0].data() + from;
        const double* const y = origins.along[1].data() + from;
        const double* const z = origins.along[2].data() + from;
        std::array<unsigned, block> indices;
        for (std::size_t i = 0; i < block; ++i)
          indices[i] =
              indexOf(static_cast<int>(turned[0] + x[i]), static_cast<int>(turned[1] + y[i]),
                      static_cast<int>(turned[2] + z[i]));
        const std::size_t count = std::min(block, sums.size() - from);
        for (std::size_t i = 0; i < count; ++i)
          sums[from + i] += static_cast<double>(values[indices[i]]);
      }
    }
  }

  static constexpr float neutral = 0.5F;
  /// A float above it is a multiple of 2^-44, and a double holds sums of those up to 2^9.
  static constexpr double smallest = 1.0 / (1 << 21);

  /// Without branches: which points lie outside is not to be foreseen.
  PERILYMPH_IN_LANES unsigned indexOf(int i, int j, int k) const
  {
    const auto n = static_cast<unsigned>(count_);
    const auto a = static_cast<unsigned>(i), b = static_cast<unsigned>(j),
               c = static_cast<unsigned>(k);
    const bool isInside = (a < n) & (b < n) & (c < n);
    return isInside ? (c * n + b) * n + a : n * n * n;
  }

  int count_;
  Eigen::Vector3d corner_;
  std::vector<float> values_;
};

/// The template's points, every `stride`th of them.
struct Sampling {
  Sampling(const Template& points, std::size_t stride)
      : inside(points.inside_W, stride), outside(points.outside_W, stride)
  {
  }
  double score(double insideSum, double outsideSum) const
  {
    return insideSum / static_cast<double>(inside.size()) -
           outsideSum / static_cast<double>(outside.size());
  }

  Points inside, outside;
};

/// The score of a pose, or, once it cannot be above `least`, any number that is not.
double score(const TemplateScore& image, const Sampling& points, const Pose& pose,
             double least = -infinitelyMuch)
{
  const TemplateScore::Rows rows = image.rowsOf(pose);
  const double inside = image.sum(rows, points.inside);
  // what lies outside only lowers the score; a rounding more than what lowers it to `least`
  const double enough =
      (points.score(inside, 0.0) - least) * static_cast<double>(points.outside.size()) + 1e-6;
  return enough < 0.0 ? least : points.score(inside, image.sum(rows, points.outside, enough));
}

/// The best of poses that differ by their origins alone, the first of equals.
Candidate bestOf(const TemplateScore& image, const Sampling& points, const std::vector<Pose>& poses)
{
  Points origins(poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const TemplateScore::Rows rows = image.rowsOf(poses[i]);
    for (std::size_t axis = 0; axis < 3; ++axis) origins.along[axis][i] = rows[axis][3];
  }
  const TemplateScore::Rows rows = image.rowsOf(poses.front());
  std::vector<double> inside(poses.size());
  image.addSums(rows, origins, points.inside, inside);
  // What lies outside only lowers a score: those whose points inside alone score less than one whole
  // pose cannot be the best.
  const auto fullest =
      static_cast<std::size_t>(std::max_element(inside.begin(), inside.end()) - inside.begin());
  const double reached = score(image, points, poses[fullest]);
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < poses.size(); ++i)
    if (points.score(inside[i], 0.0) >= reached) left.push_back(i);
  Points leftOrigins(left.size());
  for (std::size_t k = 0; k < left.size(); ++k)
    for (std::size_t axis = 0; axis < 3; ++axis)
      leftOrigins.along[axis][k] = origins.along[axis][left[k]];
  std::vector<double> outside(left.size());
  image.addSums(rows, leftOrigins, points.outside, outside);
  Candidate best{{}, -10.0};
  for (std::size_t k = 0; k < left.size(); ++k)
    if (const double here = points.score(inside[left[k]], outside[k]); here > best.score)
      best = {poses[left[k]], here};
  return best;
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
Candidate climb(const TemplateScore& image, const Sampling& points, Candidate candidate)
{
  candidate.score = score(image, points, candidate.pose);
  constexpr int moves = 12, rounds = 2;
  for (const double step : {1.0, 0.5, 0.25}) {
    const double turn = 0.2 * step, shift = 0.7 * step;
    // after as many failures as there are moves, each was tried at this pose
    for (int trial = 0, failures = 0; trial < rounds * moves && failures < moves; ++trial) {
      const int move = trial % moves;
      Eigen::Vector3d by = Eigen::Vector3d::Zero();
      by[move % 3] = (move / 3) % 2 == 0 ? 1.0 : -1.0;
      const bool isTurn = move < 6;
      const Pose pose =
          candidate.pose.moved((isTurn ? turn : 0.0) * by, (isTurn ? 0.0 : shift) * by);
      const double better = score(image, points, pose, candidate.score);
      if (better > candidate.score) {
        candidate = {pose, better};
        failures = 0;
      } else {
        ++failures;
      }
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
                                   double reach_mm, std::size_t count, Threads threads,
                                   const std::stop_token& stop)
{
  const TemplateScore image(region, bone, lumen);
  const int steps = static_cast<int>(std::ceil(reach_mm / offsetStep));
  std::vector<Eigen::Vector3d> offsets;
  for (int k = -steps; k <= steps; ++k)
    for (int j = -steps; j <= steps; ++j)
      for (int i = -steps; i <= steps; ++i) {
        const Eigen::Vector3d offset = offsetStep * Eigen::Vector3d(i, j, k);
        if (offset.norm() <= reach_mm) offsets.push_back(offset);
      }
  const Sampling coarse(points, 4), whole(points, 1);
  constexpr std::size_t perDirection = 2 * rolls;
  std::vector<Candidate> found(axisDirections * perDirection);
  const auto searchDirection = [&](std::size_t direction) {
    for (std::size_t k = 0; k < perDirection; ++k) {
      const Eigen::Matrix3d axes =
          axesOf(static_cast<int>(direction), static_cast<int>(k / 2), k % 2 == 0);
      std::vector<Pose> poses;
      poses.reserve(offsets.size());
      for (const Eigen::Vector3d& offset : offsets)
        poses.push_back({axes, near_P + offset - axes * middle_W});
      found[direction * perDirection + k] = bestOf(image, coarse, poses);
    }
  };
  eachPiece(axisDirections, threads, searchDirection, {}, stop);
  if (stop.stop_requested()) return {};
  const auto better = [](const Candidate& a, const Candidate& b) { return a.score > b.score; };
  std::stable_sort(found.begin(), found.end(), better);
  found.resize(std::min(found.size(), polished));
  constexpr std::size_t together = 16;
  const auto climbSome = [&](std::size_t piece) {
    for (std::size_t i = piece * together; i < std::min(found.size(), (piece + 1) * together); ++i)
      found[i] = climb(image, whole, found[i]);
  };
  eachPiece((found.size() + together - 1) / together, threads, climbSome, {}, stop);
  if (stop.stop_requested()) return {};
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
