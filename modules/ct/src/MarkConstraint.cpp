// SPDX-License-Identifier: BSD-3-Clause
#include "MarkConstraint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "LumenWall.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

// Experts' A on clinical CT is off by a standard deviation of 4.3 % (Iyaniwura et al. 2018, 19
// bones, doi 10.1186/s40463-018-0253-3): 0.40 mm, 0.28 mm for each of its two ends.
constexpr double wallSd_mm = 0.3;
// Chosen, as for a click on the round window: a point of the axis has no edge to be placed on.
constexpr double axisSd_mm = 0.5;
// The fit's usual error at one end of a measure: RMS errors of B and H on phantoms are 0.04 to
// 0.19 mm for two ends (the module's README).
constexpr double usualError_mm = 0.1;
// Chosen: a fit that is wrong altogether misses by the width of the lumen, and one mark in five that
// a person moves says so.
constexpr double grossError_mm = 1.5, grossProbability = 0.2;

constexpr double wallReach_mm = 3.0;
constexpr double fullDisagreement = 4.0, contradiction = 3.0;  // standard deviations
// The lowest floor is looked for from here, as for H.
constexpr double floorFirst_deg = 20.0;
constexpr double windowAngle_deg = 5.0;  // of the round window in W, in ten real ears

/// Extreme point of the wall along the axis and the angle of its ring.
struct Extreme {
  Eigen::Vector3d point_W = Eigen::Vector3d::Zero();
  double angle = 0.0;
};

Extreme extremeOf(const LumenWall& wall, const Eigen::Vector3d& direction_W)
{
  Extreme extreme;
  double farthest = -std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < wall.points_W.size(); ++i) {
    const double along = direction_W.dot(wall.points_W[i]);
    if (along <= farthest) continue;
    farthest = along;
    const auto ring = static_cast<int>(i) / LumenWall::around;
    extreme = {wall.points_W[i], wall.firstAngle + ring * LumenWall::step};
  }
  return extreme;
}

/// Part of the distance from a mark by which a fit is to move.
double weightOf(double distance_mm, double sd_mm, GrossError grossError)
{
  const double person = sd_mm * sd_mm;
  const double usual = usualError_mm * usualError_mm, gross = grossError_mm * grossError_mm;
  if (grossError == GrossError::excluded) return usual / (usual + person);
  const auto likelihood = [&](double variance) {
    return exponential(-0.5 * distance_mm * distance_mm / variance) / std::sqrt(variance);
  };
  const double isGross = grossProbability * likelihood(gross + person);
  const double isUsual = (1.0 - grossProbability) * likelihood(usual + person);
  const double probability = isGross / (isGross + isUsual);
  return (1.0 - probability) * usual / (usual + person) + probability * gross / (gross + person);
}

/// Distance of a fit from each constraint in the person's standard deviations; as far as counts
/// where the wall is out of reach.
std::vector<double> relativeDistances(const Marks& marks, const LumenShape& family,
                                      const Pose& pose, const ShapeVector& shape,
                                      const Eigen::Vector3d& axis_W)
{
  std::vector<double> distances;
  const ShapedLumen lumen(family, shape);
  for (const MarkConstraint& each : constraintsOf(marks, family, pose, shape, axis_W)) {
    const auto residual = residualOf(each, family, lumen, pose);
    distances.push_back(residual ? std::fabs(residual->value_mm) / each.sd_mm : fullDisagreement);
  }
  return distances;
}

}  // namespace

std::vector<MarkConstraint> constraintsOf(const Marks& marks, const LumenShape& family,
                                          const Pose& pose, const ShapeVector& shape,
                                          const Eigen::Vector3d& axis_W)
{
  std::vector<MarkConstraint> constraints;
  for (const Mark mark : {Mark::farWall, Mark::nearB, Mark::farB}) {
    if (!marks[mark]) continue;
    const Eigen::Vector3d point_W = pose.into_W(*marks[mark]);
    double angle = arcTangent(point_W.y(), point_W.x());
    if (angle < MeanLumen::firstAngle()) angle += 2.0 * pi;
    constraints.push_back({mark, *marks[mark], wallSd_mm, angle, {}, 0.0});
  }
  if (marks[Mark::floor] || marks[Mark::apex]) {
    const LumenWall wall = wallOf(ShapedLumen(family, shape), degrees(floorFirst_deg).si());
    for (const Mark mark : {Mark::floor, Mark::apex}) {
      if (!marks[mark]) continue;
      const Extreme extreme = extremeOf(wall, mark == Mark::apex ? axis_W : -axis_W);
      // only the height counts: the wall's extreme point at the height of the mark
      const double off = axis_W.dot(pose.into_W(*marks[mark]) - extreme.point_W);
      constraints.push_back(
          {mark, pose.outOf_W(extreme.point_W + off * axis_W), wallSd_mm, extreme.angle, {}, 0.0});
    }
  }
  const Eigen::Vector3d x = (Eigen::Vector3d::UnitX() - axis_W.x() * axis_W).normalized();
  const Eigen::Vector3d y = axis_W.cross(x);
  for (const Mark mark : {Mark::modiolus, Mark::apex})
    if (marks[mark])
      for (const Eigen::Vector3d& across : {x, y})
        constraints.push_back({mark, *marks[mark], axisSd_mm, 0.0, across, 0.0});
  return constraints;
}

std::optional<MarkResidual> residualOf(const MarkConstraint& constraint, const LumenShape& family,
                                       const ShapedLumen& lumen, const Pose& pose)
{
  const Eigen::Vector3d point_W = pose.into_W(constraint.point_P);
  MarkResidual residual{0.0, PoseShapeRow::Zero()};
  Eigen::Vector3d gradient_W;
  if (constraint.across_W) {
    gradient_W = *constraint.across_W;
    residual.value_mm = gradient_W.dot(point_W - modiolusBase_W());
  } else {
    const NearTurns near = lumen.distances(point_W, wallReach_mm);
    const TurnDistance* turn = nullptr;
    for (int i = 0; i < near.count; ++i) {
      const TurnDistance& each = near.turn[static_cast<std::size_t>(i)];
      if (std::fabs(each.angle - constraint.angle) < pi) turn = &each;
    }
    if (turn == nullptr) return std::nullopt;
    gradient_W = turn->gradient;
    residual.value_mm = turn->inside;
    family.addDerivatives(*turn, 1.0, residual.row.segment<shape::count>(6));
  }
  // The point in W moves by -(shift) and by p x turn.
  residual.row.head<3>() = gradient_W.cross(point_W);
  residual.row.segment<3>(3) = -gradient_W;
  return residual;
}

void setPrecisions(std::vector<MarkConstraint>& constraints, const LumenShape& family,
                   const Pose& pose, const ShapeVector& shape, const Eigen::MatrixXd& posterior,
                   GrossError grossError)
{
  const ShapedLumen lumen(family, shape);
  for (MarkConstraint& constraint : constraints) {
    const auto residual = residualOf(constraint, family, lumen, pose);
    if (!residual) continue;
    const double weight = weightOf(residual->value_mm, constraint.sd_mm, grossError);
    const double formal = std::max(1e-12, residual->row.dot(posterior * residual->row));
    constraint.precision = weight / ((1.0 - weight) * formal);
  }
}

double disagreement(const Marks& marks, const LumenShape& family, const Pose& pose,
                    const ShapeVector& shape, const Eigen::Vector3d& axis_W)
{
  const std::vector<double> distances = relativeDistances(marks, family, pose, shape, axis_W);
  if (distances.empty()) return 0.0;
  double sum = 0.0;
  for (const double distance : distances)
    sum += std::min(1.0, distance * distance / (fullDisagreement * fullDisagreement));
  return sum / static_cast<double>(distances.size());
}

bool contradicts(const Marks& marks, const LumenShape& family, const Pose& pose,
                 const ShapeVector& shape, const Eigen::Vector3d& axis_W)
{
  return std::ranges::any_of(relativeDistances(marks, family, pose, shape, axis_W),
                             [](double distance) { return distance > contradiction; });
}

std::optional<Pose> poseOf(const Marks& marks, const LumenShape& family,
                           const Eigen::Vector3d& axis_W, bool isRight)
{
  const auto &window = marks[Mark::roundWindow], &center = marks[Mark::modiolus],
             &top = marks[Mark::apex];
  if (!window || !center || !top) return std::nullopt;
  const Eigen::Vector3d z = (*top - *center).normalized();
  const Eigen::Vector3d toWindow = *window - *center;
  const Eigen::Vector3d x = (toWindow - z.dot(toWindow) * z).normalized();
  Eigen::Matrix3d axes_P;
  axes_P << x, (isRight ? 1.0 : -1.0) * z.cross(x), z;
  if (!axes_P.allFinite()) return std::nullopt;
  const double angle = degrees(windowAngle_deg).si();
  const SineCosine turn = sineCosine(angle);
  const SectionPlace place = family.place(LumenShape::priorMean(), angle);
  const ClinicalFrame frame =
      clinicalFrame(axis_W, {place.outer * turn.cosine, place.outer * turn.sine, place.middle});
  Pose pose;
  pose.axes_PW = axes_P * frame.axes_W.transpose();
  pose.origin_P = *center - pose.axes_PW * frame.origin_W;
  return pose;
}

}  // namespace perilymph::ct
