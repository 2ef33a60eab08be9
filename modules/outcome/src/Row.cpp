// SPDX-License-Identifier: BSD-3-Clause
#include "Row.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "Ridge.h"
#include "perilymph/foundation/Quantile.h"

namespace perilymph::outcome {

namespace {

using Eigen::Vector3d;

constexpr double rowStep_mm = 0.05;
constexpr double rowBeforeTip_mm = 3.0;  // along the metal beyond the ridge's apical end
constexpr double rewardOfContrast = 3.0, lowestContrast = -0.5;
constexpr double rowSd_mm = 0.04, rowSdRelative = 0.03,
                 rowFarthest = 3.5;  // standard deviations
constexpr double costBeforeRow = 7.0, darkOfRow = 0.25, brightOfRow = 0.75;
constexpr double costOfDarkPlace = 3.0;
constexpr double rowsApart = 0.4;  // of the first spacing
constexpr double noRow = -1e9;

/// The course of a row: places at equal distances, what is seen there, and how much nearer to each other the contacts on
/// the inner side of the bend are, as a part of their distance for each millimeter from the center line.
struct Course {
  std::vector<Vector3d> point_P;
  std::vector<double> contrast, brightness, bend;
};

Course courseOf(const MetalGrid& grid, const std::vector<float>& contrast,
                const std::vector<Vector3d>& ridge_P, const EarFrame& frame, double length_mm)
{
  constexpr double towardEnds_mm = 0.6;  // of the ridge, that gives its direction there
  const Vector3d tipward = (ridge_P.front() - alongPolyline(ridge_P, towardEnds_mm)).normalized();
  std::vector<Vector3d> line = followed(grid, ridge_P.front(), tipward, 0.5 * rowBeforeTip_mm, 2);
  std::reverse(line.begin(), line.end());
  line.insert(line.end(), ridge_P.begin(), ridge_P.end());
  const std::size_t back = std::min<std::size_t>(ridge_P.size() - 1, 6);
  const Vector3d baseward = (ridge_P.back() - ridge_P[ridge_P.size() - 1 - back]).normalized();
  constexpr double leg_mm = 1.0;
  for (const Vector3d& point : followed(grid, ridge_P.back(), baseward, leg_mm,
                                        static_cast<int>(std::ceil(length_mm / leg_mm))))
    line.push_back(point);
  double whole = 0.0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) whole += (line[i + 1] - line[i]).norm();
  Course course;
  for (double at = 0.0; at < whole; at += rowStep_mm) {
    const Vector3d point = alongPolyline(line, at);
    course.point_P.push_back(point);
    course.contrast.push_back(grid.sample(contrast, point));
    course.brightness.push_back(grid.sample(grid.value, point));
    const EarPlace place = frame.placeOf(point);
    course.bend.push_back(place.isInside && place.angle > 0.0 ? 1.0 / std::max(1.0, place.radius_mm)
                                                              : 0.0);
  }
  return course;
}

}  // namespace

std::vector<std::vector<Vector3d>> rowsAlong(
    const MetalGrid& grid, const std::vector<float>& contrast, const std::vector<Vector3d>& ridge_P,
    const EarFrame& frame, const electrode::ArrayDesign& array, double fwhm_mm,
    const std::map<std::size_t, Vector3d>& byHand, std::size_t most)
{
  const std::size_t count = array.contactsFromTip.size();
  const double whole = inMillimeters(array.contactsFromTip.back() - array.contactsFromTip.front());
  const Course course = courseOf(grid, contrast, ridge_P, frame, whole);
  const std::size_t places = course.point_P.size();
  std::vector<double> peaks;
  for (std::size_t j = 1; j + 1 < places; ++j)
    if (course.contrast[j] > course.contrast[j - 1] && course.contrast[j] >= course.contrast[j + 1])
      peaks.push_back(course.contrast[j]);
  if (peaks.size() < 2) return {};
  std::sort(peaks.begin(), peaks.end(), std::greater<>());
  peaks.resize(std::min(peaks.size(), count));
  const double typical = std::max(1.0, peaks[peaks.size() / 2]);
  const double usual = std::max(1.0, quantile(course.brightness, 0.7));
  std::vector<double> reward(places);
  for (std::size_t j = 0; j < places; ++j)
    reward[j] = rewardOfContrast * std::clamp(course.contrast[j] / typical, lowestContrast, 1.0) -
                costOfDarkPlace * std::max(0.0, 1.0 - course.brightness[j] / (darkOfRow * usual));

  struct Row {
    double score;
    std::size_t first;
    std::vector<std::size_t> at;
  };
  std::vector<Row> rows;
  const bool isBeside = [&] {
    for (std::size_t i = 0; i < count; ++i)
      if (array.platesOf(i) == electrode::Plates::single) return true;
    return false;
  }();
  const std::vector<double> offsets =
      isBeside ? std::vector<double>{0.3, 0.7, 1.1} : std::vector<double>{0.0};
  for (const double offset : offsets) {
    // the best score of contacts i and on, with contact i at each place
    std::vector<std::vector<double>> score(count, std::vector<double>(places, noRow));
    std::vector<std::vector<std::size_t>> next(count, std::vector<std::size_t>(places, 0));
    const auto own = [&](std::size_t i, std::size_t j) {
      if (const auto placed = byHand.find(i); placed != byHand.end())
        return (course.point_P[j] - placed->second).norm() < 0.5 ? rewardOfContrast : noRow;
      return reward[j];
    };
    for (std::size_t i = count; i-- > 0;) {
      const double arc =
          i + 1 < count ? inMillimeters(array.contactsFromTip[i + 1] - array.contactsFromTip[i])
                        : 0.0;
      const double half = 0.5 * inMillimeters(array.sectionAt(array.contactsFromTip[i]).within);
      const double sd = rowSd_mm + rowSdRelative * arc;
      for (std::size_t j = 0; j < places; ++j) {
        const double here = own(i, j);
        if (here <= noRow) continue;
        if (i + 1 == count) {
          score[i][j] = here;
          continue;
        }
        const double expected = arc * (1.0 - offset * course.bend[j] * half);
        const auto low = static_cast<std::size_t>(
            std::max(1.0, std::floor((expected - rowFarthest * sd) / rowStep_mm)));
        const auto high =
            static_cast<std::size_t>(std::ceil((expected + rowFarthest * sd) / rowStep_mm));
        for (std::size_t d = low; d <= high && j + d < places; ++d) {
          const double off = (static_cast<double>(d) * rowStep_mm - expected) / sd;
          const double value = here + score[i + 1][j + d] - 0.5 * off * off;
          if (value > score[i][j]) score[i][j] = value, next[i][j] = j + d;
        }
      }
    }
    const double beyond_mm =
        std::max(inMillimeters(array.contactsFromTip[1] - array.contactsFromTip[0]), 1.3 * fwhm_mm);
    const auto beyond = static_cast<std::size_t>(std::lround(beyond_mm / rowStep_mm));
    for (std::size_t j = 0; j < places; ++j) {
      if (score[0][j] <= 0.5 * noRow) continue;
      const double metal = j >= beyond ? course.brightness[j - beyond] / usual : 0.0;
      Row row{
          score[0][j] -
              costBeforeRow * std::clamp((metal - darkOfRow) / (brightOfRow - darkOfRow), 0.0, 1.0),
          j,
          {}};
      std::size_t at = j;
      for (std::size_t i = 0; i < count; ++i) {
        row.at.push_back(at);
        at = next[i][at];
      }
      rows.push_back(std::move(row));
    }
  }
  std::stable_sort(rows.begin(), rows.end(),
                   [](const Row& a, const Row& b) { return a.score > b.score; });
  const double least =
      rowsApart * inMillimeters(array.contactsFromTip[1] - array.contactsFromTip[0]) / rowStep_mm;
  std::vector<std::vector<Vector3d>> found;
  std::vector<std::size_t> firsts;
  for (const Row& row : rows) {
    if (found.size() == most) break;
    if (std::any_of(firsts.begin(), firsts.end(), [&](std::size_t first) {
          return std::fabs(static_cast<double>(first) - static_cast<double>(row.first)) < least;
        }))
      continue;
    firsts.push_back(row.first);
    std::vector<Vector3d> positions;
    for (std::size_t i = 0; i < count; ++i)
      positions.push_back(byHand.contains(i) ? byHand.at(i) : course.point_P[row.at[i]]);
    found.push_back(std::move(positions));
  }
  return found;
}

}  // namespace perilymph::outcome
