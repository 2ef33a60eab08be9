// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/ct/Markups.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph::ct {

namespace {

constexpr double largest_mm = 1e4;     // of a position in a scanner
constexpr double samePlace_mm = 1e-6;  // no length or direction between them
constexpr double oneLine = 1e-9;       // sine of an angle whose sides are one line
constexpr double shortestEdge_mm = 1e-3, longestEdge_mm = 100.0;
constexpr double uniformVariance = 1.0 / 12.0;  // of a uniform distribution of width 1
constexpr std::size_t keyDigits = 64;           // SHA-256

bool isKey(const std::string& text)
{
  return text.size() == keyDigits &&
         text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

bool areApart(const Eigen::Vector3d& one, const Eigen::Vector3d& other)
{
  return (one - other).norm() > samePlace_mm;
}

/// The largest of |Eᵀm|² over the unit vectors m across a direction.
double largestAcross(const Eigen::Matrix3d& edges_P, const Eigen::Vector3d& along_P)
{
  const Eigen::Vector3d x = along_P.unitOrthogonal(), y = along_P.cross(x);
  const Eigen::Vector3d ex = edges_P.transpose() * x, ey = edges_P.transpose() * y;
  // the larger eigenvalue of a symmetric matrix of 2 x 2
  const double half = 0.5 * (ex.squaredNorm() - ey.squaredNorm()), mixed = ex.dot(ey);
  return 0.5 * (ex.squaredNorm() + ey.squaredNorm()) + std::sqrt(half * half + mixed * mixed);
}

MarkupValue distanceOf(const std::vector<Eigen::Vector3d>& points_P, const Eigen::Matrix3d& edges_P)
{
  const Eigen::Vector3d between = points_P[1] - points_P[0];
  const double length = between.norm();
  const Eigen::Vector3d edgesAlong = edges_P.transpose() * (between / length);
  return {length, std::sqrt(2.0 * uniformVariance) * edgesAlong.norm()};
}

MarkupValue angleOf(const std::vector<Eigen::Vector3d>& points_P, const Eigen::Matrix3d& edges_P)
{
  const Eigen::Vector3d toP = points_P[0] - points_P[1], toQ = points_P[2] - points_P[1];
  const double p = toP.norm(), q = toQ.norm();
  const Eigen::Vector3d u = toP / p, w = toQ / q;
  const double sine = u.cross(w).norm(), cosine = u.dot(w);
  const double angle = arcTangent(sine, cosine);
  double squares = 0.0;
  if (sine > oneLine) {
    const Eigen::Vector3d byP = (cosine * u - w) / (sine * p), byQ = (cosine * w - u) / (sine * q);
    squares = (edges_P.transpose() * byP).squaredNorm() +
              (edges_P.transpose() * byQ).squaredNorm() +
              (edges_P.transpose() * (byP + byQ)).squaredNorm();
  } else {
    const double byVertex = cosine > 0.0 ? 1.0 / p - 1.0 / q : 1.0 / p + 1.0 / q;
    squares = (1.0 / (p * p) + 1.0 / (q * q) + byVertex * byVertex) * largestAcross(edges_P, u);
  }
  const double sd = std::sqrt(uniformVariance * squares);
  return {inDegrees(radians(angle)), inDegrees(radians(sd))};
}

}  // namespace

CtMarkups markupsOf(const CtVolume& volume)
{
  return {volume.provenance().seriesKey, volume.lpsFromIndex().topLeftCorner<3, 3>()};
}

PointCount pointCountOf(MarkupKind kind)
{
  switch (kind) {
    case MarkupKind::distance:
      return {2, 2};
    case MarkupKind::approach:
      return {2, 2};
    case MarkupKind::angle:
      return {3, 3};
    case MarkupKind::note:
      return {1, 1};
    case MarkupKind::facialNerve:
    case MarkupKind::chordaTympani:
    case MarkupKind::canalWall:
      break;
  }
  return {1, maxMarkupPoints};
}

Result<void> checkMarkup(const Markup& markup)
{
  const char* name = nameIn(markupKinds, markup.kind);
  const auto [least, most] = pointCountOf(markup.kind);
  const auto& points = markup.points_P;
  if (points.size() < least || points.size() > most)
    return Error{"The markup %1 has %2 points; it needs %3 to %4. Place it again.", name,
                 points.size(), least, most};
  for (const Eigen::Vector3d& point : points)
    if (!point.allFinite() || point.cwiseAbs().maxCoeff() > largest_mm)
      return Error{
          "The markup %1 has a point that is not finite or beyond 10 m from the scanner's origin. "
          "Place it again.",
          name};
  // an angle's sides run from its second point
  const bool isMeasured = least > 1;
  for (std::size_t k = 0; isMeasured && k + 1 < points.size(); ++k)
    if (!areApart(points[k], points[k + 1]))
      return Error{"The markup %1 has two points at one place. Move one of them.", name};
  if (markup.kind == MarkupKind::note && markup.text.empty())
    return Error{"A note has no text. Write one, or remove it."};
  if (markup.text.size() > maxMarkupText)
    return Error{"The text of a markup %1 has %2 bytes; at most %3 are kept. Shorten it.", name,
                 markup.text.size(), maxMarkupText};
  if (onOneLine(markup.text) != markup.text)
    return Error{
        "The text of a markup %1 has a line break, a control character or a character that is no "
        "UTF-8. Write it in one line.",
        name};
  return {};
}

Result<void> checkMarkups(const CtMarkups& markups)
{
  if (!isKey(markups.seriesKey))
    return Error{
        "Markups are of the CT series \"%1\", which is no SHA-256 of 64 hexadecimal digits. Place "
        "them in an open CT.",
        onOneLine(markups.seriesKey.substr(0, keyDigits))};
  const Eigen::Vector3d edges = markups.voxelEdges_P.colwise().norm();
  const double box = std::fabs(markups.voxelEdges_P.determinant());
  if (!markups.voxelEdges_P.allFinite() || edges.minCoeff() < shortestEdge_mm ||
      edges.maxCoeff() > longestEdge_mm || !(box > 0.1 * edges.prod()))
    return Error{
        "Markups are of voxels whose edges are not 0.001 to 100 mm long or lie in one plane. Place "
        "them in an open CT."};
  if (markups.markups.size() > maxMarkups)
    return Error{"A CT has %1 markups; at most %2 are kept. Remove some.", markups.markups.size(),
                 maxMarkups};
  for (const Markup& each : markups.markups)
    if (const auto possible = checkMarkup(each); !possible) return possible;
  return {};
}

std::optional<MarkupValue> valueOf(const Markup& markup, const Eigen::Matrix3d& voxelEdges_P)
{
  const auto& points = markup.points_P;
  if (points.size() != pointCountOf(markup.kind).least) return std::nullopt;
  if (markup.kind == MarkupKind::distance) return distanceOf(points, voxelEdges_P);
  if (markup.kind == MarkupKind::angle) return angleOf(points, voxelEdges_P);
  return std::nullopt;
}

std::optional<Sentence> outsideNote(const CtMarkups& markups, const CtVolume& volume)
{
  const auto outside = std::ranges::count_if(markups.markups, [&](const Markup& each) {
    // a line of approach begins outside the head, or outside a small field of view
    const std::size_t first = each.kind == MarkupKind::approach ? each.points_P.size() - 1 : 0;
    return !std::all_of(each.points_P.begin() + static_cast<std::ptrdiff_t>(first),
                        each.points_P.end(),
                        [&](const auto& point_P) { return volume.contains(point_P); });
  });
  if (outside == 0) return std::nullopt;
  return Sentence{
      "%1 of %2 markups have a point outside the CT, which is not shown. Remove them or place them "
      "again.",
      outside, markups.markups.size()};
}

}  // namespace perilymph::ct
