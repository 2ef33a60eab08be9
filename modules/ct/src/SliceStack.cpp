// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/ct/SliceStack.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

using Axes = Eigen::Matrix<double, 3, 2>;

// Headers give directions with four decimals or more.
constexpr double maxDirectionError = 1e-3;
// Two slices nearer than this are at the same position; the finest scanners step 0.04 mm.
constexpr double samePlace_mm = 0.01;

std::string inMm(double value, int digits = 3)
{
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

Sentence nameOf(std::size_t place, std::size_t places, double along_mm)
{
  return Sentence{"slice %1 of %2 (at %3 mm along the normal)", place + 1, places,
                  inMm(along_mm, 2)};
}

bool isOrientation(const Axes& axes)
{
  return axes.allFinite() && std::fabs(axes.col(0).norm() - 1.0) < maxDirectionError &&
         std::fabs(axes.col(1).norm() - 1.0) < maxDirectionError &&
         std::fabs(axes.col(0).dot(axes.col(1))) < maxDirectionError;
}

Axes atRightAngles(const Axes& axes)
{
  Axes right;
  right.col(0) = axes.col(0).normalized();
  right.col(1) = (axes.col(1) - axes.col(1).dot(right.col(0)) * right.col(0)).normalized();
  return right;
}

// Farther away no scanner measures, and squares of lengths stay finite.
constexpr double farthest_mm = 1e6;

Result<void> checkPoses(const std::vector<SlicePose>& slices)
{
  std::size_t without = 0, far = 0, odd = 0;
  for (const SlicePose& slice : slices) {
    if (!slice.position_P || !slice.position_P->allFinite() || !slice.axes_P)
      ++without;
    else if (slice.position_P->norm() > farthest_mm)
      ++far;
    else if (!isOrientation(*slice.axes_P))
      ++odd;
  }
  const std::size_t count = slices.size();
  if (without > 0)
    return Error{
        "%1 of %2 slices have no position or orientation in the patient, so no length along the "
        "stack "
        "can be trusted. Export the series again as original images.",
        without, count};
  if (far > 0)
    return Error{
        "%1 of %2 slices have a position more than 1 km from the origin of the patient's "
        "coordinates, "
        "where no scanner measures. Export the series again as original images.",
        far, count};
  if (odd > 0)
    return Error{
        "%1 of %2 slices have an orientation that is not two unit vectors at right angles. Export "
        "the "
        "series again as original images.",
        odd, count};
  std::size_t other = 0;
  for (const SlicePose& slice : slices)
    if ((*slice.axes_P - *slices.front().axes_P).cwiseAbs().maxCoeff() > maxDirectionError) ++other;
  if (other > 0)
    return Error{
        "%1 of %2 slices have another orientation than the first. Export each orientation as a "
        "series "
        "of its own.",
        other, count};
  return {};
}

struct Placed {
  double along_mm;
  std::size_t slice;
};

/// Slices at one position together, in the direction of the normal.
std::vector<std::vector<std::size_t>> placesOf(const std::vector<SlicePose>& slices,
                                               const Eigen::Vector3d& normal_P)
{
  std::vector<Placed> sorted;
  for (std::size_t i = 0; i < slices.size(); ++i)
    sorted.push_back({normal_P.dot(*slices[i].position_P), i});
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Placed& a, const Placed& b) { return a.along_mm < b.along_mm; });
  std::vector<std::vector<std::size_t>> places;
  for (const Placed& one : sorted) {
    const bool isSame =
        !places.empty() &&
        one.along_mm - normal_P.dot(*slices[places.back().front()].position_P) < samePlace_mm;
    if (!isSame) places.emplace_back();
    places.back().push_back(one.slice);
  }
  return places;
}

/// Refuses gaps of a whole number of steps.
Result<void> checkGaps(const std::vector<double>& along_mm)
{
  std::vector<double> gaps;
  for (std::size_t i = 1; i < along_mm.size(); ++i) gaps.push_back(along_mm[i] - along_mm[i - 1]);
  std::vector<double> sorted = gaps;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2),
                   sorted.end());
  const double step_mm = sorted[sorted.size() / 2];
  long missing = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const double steps = gaps[i] / step_mm;
    if (steps < 1.5 || std::fabs(steps - std::round(steps)) > 0.1) continue;
    if (missing == 0) first = i;
    missing += std::lround(steps) - 1;
  }
  if (missing == 0) return {};
  const Sentence before = nameOf(first, along_mm.size(), along_mm[first]);
  const std::string gap = inMm(gaps[first], 2), step = inMm(step_mm, 2);
  if (missing == 1)
    return Error{
        "1 slice is missing behind %1, where the gap is %2 mm and the step elsewhere %3 mm. Export "
        "the whole series again.",
        before, gap, step};
  return Error{
      "%1 slices are missing, the first behind %2, where the gap is %3 mm and the step elsewhere "
      "%4 mm. Export the whole series again.",
      missing, before, gap, step};
}

/// Whether all coordinates of all positions are multiples of a hundredth of a millimeter.
bool areRounded(const std::vector<SlicePose>& slices)
{
  return std::all_of(slices.begin(), slices.end(), [](const SlicePose& slice) {
    const Eigen::Array3d hundredths = 100.0 * slice.position_P->array();
    return ((hundredths - hundredths.round()).abs() < 1e-6).all();
  });
}

}  // namespace

Result<SliceStack> stackSlices(const std::vector<SlicePose>& slices)
{
  if (slices.empty()) return Error{"There is no slice. Choose another series."};
  if (const auto done = checkPoses(slices); !done) return done.error();
  SliceStack stack;
  stack.axes_P = atRightAngles(*slices.front().axes_P);
  const Eigen::Vector3d normal_P = stack.axes_P.col(0).cross(stack.axes_P.col(1));
  stack.places = placesOf(slices, normal_P);
  const std::size_t count = stack.places.size();
  if (count < 2)
    return slices.size() == 1
               ? Error{"There is a single slice; at least 2 are needed. Choose another series."}
               : Error{
                     "All %1 slices lie at one position; a volume needs them one above the "
                     "other. Choose another series.",
                     slices.size()};

  std::vector<Eigen::Vector3d> positions_P;
  std::vector<double> along_mm;
  for (const auto& place : stack.places) {
    positions_P.push_back(*slices[place.front()].position_P);
    along_mm.push_back(normal_P.dot(positions_P.back()));
  }
  if (const auto done = checkGaps(along_mm); !done) return done.error();

  // The line of equal steps nearest to the positions.
  const double middle = 0.5 * static_cast<double>(count - 1);
  Eigen::Vector3d mean_P = Eigen::Vector3d::Zero(), slope_P = Eigen::Vector3d::Zero();
  double squares = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    const double off = static_cast<double>(k) - middle;
    mean_P += positions_P[k] / static_cast<double>(count);
    slope_P += off * positions_P[k];
    squares += off * off;
  }
  stack.step_P = slope_P / squares;
  stack.origin_P = mean_P - middle * stack.step_P;

  std::size_t worst = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const Eigen::Vector3d expected_P = stack.origin_P + static_cast<double>(k) * stack.step_P;
    for (const std::size_t slice : stack.places[k]) {
      const double deviation = (*slices[slice].position_P - expected_P).norm();
      if (!(deviation > stack.maxDeviation_mm)) continue;
      stack.maxDeviation_mm = deviation;
      worst = k;
    }
  }
  const double step_mm = stack.step_P.norm();
  const double regular_mm = std::min(allowedDeviationFraction * step_mm, allowedDeviation_mm);
  const double allowed_mm =
      areRounded(slices) ? std::max(regular_mm, roundedDeviation_mm) : regular_mm;
  if (stack.maxDeviation_mm > allowed_mm)
    return Error{
        "The slices are not equally spaced: %1 lies %2 mm from where equal steps of %3 mm put it, "
        "and at most %4 mm is allowed. Export the series again as original images.",
        nameOf(worst, count, along_mm[worst]), inMm(stack.maxDeviation_mm), inMm(step_mm),
        inMm(allowed_mm)};
  const double along = stack.planeDistance_mm();
  const double across = (stack.step_P - along * normal_P).norm();
  stack.tilt_deg = inDegrees(radians(arcTangent(across, along)));
  return stack;
}

}  // namespace perilymph::ct
