// SPDX-License-Identifier: BSD-3-Clause
#include "MetalSpiral.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::outcome {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// An array's circles in a cochlea: the basal turn's center line has a radius of 3 to 5 mm, the middle turn's 2 mm
// (constants of this file are choices, made on development phantoms).
constexpr double minRadius_mm = 1.5, maxRadius_mm = 6.0;
constexpr double ballRadius_mm = 4.5;  // metal of which a circle is fitted
constexpr double besideCircle_mm = 0.9, aboveCircle_mm = 1.6;
constexpr int circleSectors = 16, fewestSectors = 6;
constexpr std::size_t ballCenters = 200, circlesKept = 10, fewestPoints = 12;
constexpr double sameCircle_mm = 1.0, sameAxis_cosine = 0.9;
constexpr double around_mm = 9.0;  // metal beyond is not of the cochlea
constexpr double free_mm = 0.45;   // metal so near to the center line is in the duct
constexpr double scale_mm = 0.5;   // deviation beyond it that counts half
constexpr double leadLength_mm = 8.0;
constexpr int rolls = 24, rollsKept = 10, alignments = 25;
constexpr double sameStart_mm = 0.5, sameTurn_cosine = 0.985;
constexpr std::size_t startsKept = 10, pointsKept = 500;

/// The mean scala tympani's course with the lead before it, frame W [mm].
struct DuctCourse {
  std::vector<Vector3d> points_W;
  std::vector<double> free_mm;  // the lead leaves the opening in no exact direction
  Vector3d window_W = Vector3d::Zero(), center_W = Vector3d::Zero(), apex_W = Vector3d::Zero();
};

std::optional<DuctCourse> meanCourse()
{
  anatomy::Cochlea cochlea;
  cochlea.source = anatomy::AnatomySource::mean;
  const auto scala = anatomy::buildAnatomy(cochlea, "the mean cochlea");
  if (!scala) return std::nullopt;
  DuctCourse course;
  const anatomy::Entry entry = (*scala)->entry();
  for (double back = leadLength_mm; back > 0.0; back -= 0.4) {
    course.points_W.push_back(1e3 * entry.origin_W + back * entry.out_W);
    course.free_mm.push_back(free_mm + 0.35 * back);
  }
  const double last = (*scala)->lastAngle().si();
  constexpr double step = 5.0 * pi / 180.0;
  for (double angle = 0.0; angle <= last; angle += step) {
    course.points_W.push_back(1e3 * (*scala)->center_W(angle));
    course.free_mm.push_back(free_mm);
  }
  course.window_W = 1e3 * (*scala)->wall_W(0.0, 0.0);
  course.center_W = Vector3d(0.0, 0.0, course.window_W.z());
  course.apex_W = Vector3d(0.0, 0.0, 1e3 * (*scala)->center_W(last).z());
  return course;
}

struct MetalCircle {
  Vector3d center_P, axis_P;
  double radius = 0.0;
  int sectors = 0;  // of the circle, with metal on it
};

/// The circle through the metal of a ball, by least squares in its plane.
std::optional<MetalCircle> circleIn(const std::vector<Vector3d>& metal_P, const Vector3d& ball_P)
{
  std::vector<Vector3d> inside;
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& each : metal_P)
    if ((each - ball_P).squaredNorm() < ballRadius_mm * ballRadius_mm) {
      inside.push_back(each);
      mean += each;
    }
  if (inside.size() < fewestPoints) return std::nullopt;
  mean /= static_cast<double>(inside.size());
  Matrix3d spread = Matrix3d::Zero();
  for (const Vector3d& each : inside) spread += (each - mean) * (each - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(spread);
  const Vector3d z = axes.eigenvectors().col(0), x = axes.eigenvectors().col(2), y = z.cross(x);
  // x² + y² = 2 a x + 2 b y + c
  Matrix3d normal = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (const Vector3d& each : inside) {
    const Vector3d row(2.0 * x.dot(each - mean), 2.0 * y.dot(each - mean), 1.0);
    normal += row * row.transpose();
    right += row * (0.25 * row.head<2>().squaredNorm());
  }
  const Vector3d solved = normal.ldlt().solve(right);
  const double radius = std::sqrt(solved[2] + solved[0] * solved[0] + solved[1] * solved[1]);
  if (!(radius > minRadius_mm && radius < maxRadius_mm)) return std::nullopt;
  MetalCircle circle{mean + solved[0] * x + solved[1] * y, z, radius, 0};
  std::array<bool, circleSectors> seen{};
  for (const Vector3d& each : metal_P) {
    const Vector3d off = each - circle.center_P;
    const double across = std::hypot(x.dot(off), y.dot(off));
    if (std::fabs(z.dot(off)) > aboveCircle_mm || std::fabs(across - radius) > besideCircle_mm)
      continue;
    const double part = (std::atan2(y.dot(off), x.dot(off)) / pi + 1.0) * 0.5 * circleSectors;
    seen[static_cast<std::size_t>(std::clamp(static_cast<int>(part), 0, circleSectors - 1))] = true;
  }
  circle.sectors = static_cast<int>(std::count(seen.begin(), seen.end(), true));
  if (circle.sectors < fewestSectors) return std::nullopt;
  return circle;
}

std::vector<MetalCircle> circlesIn(const std::vector<Vector3d>& metal_P)
{
  std::vector<MetalCircle> all, kept;
  const std::size_t step = std::max<std::size_t>(1, metal_P.size() / ballCenters);
  for (std::size_t i = 0; i < metal_P.size(); i += step)
    if (const auto circle = circleIn(metal_P, metal_P[i])) all.push_back(*circle);
  std::stable_sort(all.begin(), all.end(), [](const MetalCircle& a, const MetalCircle& b) {
    return a.sectors > b.sectors;
  });
  for (const MetalCircle& each : all) {
    const bool isKnown = std::any_of(kept.begin(), kept.end(), [&](const MetalCircle& other) {
      return (other.center_P - each.center_P).norm() < sameCircle_mm &&
             std::fabs(other.axis_P.dot(each.axis_P)) > sameAxis_cosine;
    });
    if (!isKnown) kept.push_back(each);
    if (kept.size() == circlesKept) break;
  }
  return kept;
}

struct PlacedDuct {
  Matrix3d axes_PW = Matrix3d::Identity();
  Vector3d origin_P = Vector3d::Zero();
  double cost = 1e9;
};

/// Moves a course to the metal: each point pulls the nearest point of the course, unless it is in the duct; far ones
/// pull less. The cost is the mean of d² / (d² + scale²) over the metal.
class DuctAlignment {
public:
  DuctAlignment(const DuctCourse& course, const std::vector<Vector3d>& metal_P)
      : course_(course), metal_P_(metal_P)
  {
  }

  double cost(const PlacedDuct& placed) const
  {
    double sum = 0.0;
    for (const Vector3d& each : metal_P_) {
      const double beyond = nearest(placed, each).beyond_mm;
      sum += beyond * beyond / (beyond * beyond + scale_mm * scale_mm);
    }
    return sum / static_cast<double>(metal_P_.size());
  }

  void improve(PlacedDuct& placed, int steps) const
  {
    for (int step = 0; step < steps; ++step) {
      Vector3d meanW = Vector3d::Zero(), meanP = Vector3d::Zero();
      Matrix3d cross = Matrix3d::Zero();
      double total = 0.0;
      std::vector<std::pair<Vector3d, Vector3d>> pairs;
      std::vector<double> weights;
      for (const Vector3d& each : metal_P_) {
        const Near near = nearest(placed, each);
        const Vector3d at_W = course_.points_W[near.place];
        const Vector3d at_P = placed.origin_P + placed.axes_PW * at_W;
        const double ratio = near.beyond_mm * near.beyond_mm / (scale_mm * scale_mm);
        const double weight = 1.0 / ((1.0 + ratio) * (1.0 + ratio));
        const double d = (each - at_P).norm();
        const Vector3d target_P = d > 0.0 ? at_P + (near.beyond_mm / d) * (each - at_P) : at_P;
        pairs.emplace_back(at_W, target_P);
        weights.push_back(weight);
        meanW += weight * at_W, meanP += weight * target_P, total += weight;
      }
      meanW /= total, meanP /= total;
      for (std::size_t i = 0; i < pairs.size(); ++i)
        cross += weights[i] * (pairs[i].second - meanP) * (pairs[i].first - meanW).transpose();
      const Eigen::JacobiSVD<Matrix3d> parts(cross, Eigen::ComputeFullU | Eigen::ComputeFullV);
      const double mirrored = placed.axes_PW.determinant();
      const double proper = (parts.matrixU() * parts.matrixV().transpose()).determinant();
      placed.axes_PW = parts.matrixU() * Vector3d(1.0, 1.0, proper * mirrored).asDiagonal() *
                       parts.matrixV().transpose();
      placed.origin_P = meanP - placed.axes_PW * meanW;
    }
    placed.cost = cost(placed);
  }

private:
  struct Near {
    std::size_t place = 0;
    double beyond_mm = 0.0;  // beyond the duct
  };
  Near nearest(const PlacedDuct& placed, const Vector3d& point_P) const
  {
    const Vector3d at_W = placed.axes_PW.transpose() * (point_P - placed.origin_P);
    Near near;
    double least = 1e9;
    for (std::size_t i = 0; i < course_.points_W.size(); ++i) {
      const double d = (course_.points_W[i] - at_W).norm() - course_.free_mm[i];
      if (d < least) least = d, near.place = i;
    }
    near.beyond_mm = std::max(0.0, least);
    return near;
  }

  const DuctCourse& course_;
  const std::vector<Vector3d>& metal_P_;
};

}  // namespace

std::vector<ct::CochleaStart> cochleaeAroundMetal(const std::vector<Vector3d>& metal_P,
                                                  std::optional<anatomy::Side> side,
                                                  const std::stop_token& stop)
{
  const auto course = meanCourse();
  if (!course) return {};
  Vector3d middle_W = Vector3d::Zero();  // of the basal turn, on the axis
  middle_W.z() = course->center_W.z() + 0.3;

  std::vector<PlacedDuct> found;
  for (const MetalCircle& circle : circlesIn(metal_P)) {
    std::vector<Vector3d> near_P;
    for (const Vector3d& each : metal_P)
      if ((each - circle.center_P).norm() < around_mm) near_P.push_back(each);
    std::vector<Vector3d> few_P;
    const std::size_t step = std::max<std::size_t>(1, near_P.size() / pointsKept);
    for (std::size_t i = 0; i < near_P.size(); i += step) few_P.push_back(near_P[i]);
    const DuctAlignment alignment(*course, few_P);
    std::vector<PlacedDuct> turned;
    const Vector3d across = circle.axis_P.unitOrthogonal();
    for (const double up : {1.0, -1.0})
      for (const anatomy::Side ear : {anatomy::Side::right, anatomy::Side::left}) {
        if (side && ear != *side) continue;
        for (int roll = 0; roll < rolls; ++roll) {
          if (stop.stop_requested()) return {};
          const double angle = 2.0 * pi * roll / rolls;
          const Vector3d z = up * circle.axis_P;
          const Vector3d x =
              std::cos(angle) * across + std::sin(angle) * circle.axis_P.cross(across);
          PlacedDuct placed;
          placed.axes_PW << x, (ear == anatomy::Side::right ? 1.0 : -1.0) * z.cross(x), z;
          placed.origin_P = circle.center_P - placed.axes_PW * middle_W;
          alignment.improve(placed, 4);
          turned.push_back(placed);
        }
      }
    std::stable_sort(turned.begin(), turned.end(),
                     [](const PlacedDuct& a, const PlacedDuct& b) { return a.cost < b.cost; });
    if (turned.size() > rollsKept) turned.resize(rollsKept);
    for (PlacedDuct& each : turned) {
      alignment.improve(each, alignments);
      found.push_back(each);
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const PlacedDuct& a, const PlacedDuct& b) { return a.cost < b.cost; });

  std::vector<PlacedDuct> kept;
  std::vector<ct::CochleaStart> starts;
  for (const PlacedDuct& each : found) {
    const bool isKnown = std::any_of(kept.begin(), kept.end(), [&](const PlacedDuct& other) {
      return (other.origin_P - each.origin_P).norm() < sameStart_mm &&
             other.axes_PW.col(0).dot(each.axes_PW.col(0)) > sameTurn_cosine &&
             other.axes_PW.col(2).dot(each.axes_PW.col(2)) > sameTurn_cosine;
    });
    if (isKnown) continue;
    kept.push_back(each);
    const auto toP = [&](const Vector3d& at_W) {
      return Vector3d(each.origin_P + each.axes_PW * at_W);
    };
    starts.push_back(
        {toP(course->window_W), toP(course->center_W), toP(course->apex_W),
         each.axes_PW.determinant() > 0.0 ? anatomy::Side::right : anatomy::Side::left});
    if (starts.size() == startsKept) break;
  }
  return starts;
}

}  // namespace perilymph::outcome
