// SPDX-License-Identifier: BSD-3-Clause
#include "LumenProfile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "perilymph/foundation/Math.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::ct {
namespace {

constexpr double firstSection_deg = 20.0, sectionStep_deg = 10.0, firstTurn_deg = 360.0;
constexpr double behindWall_mm = 0.45;  // in the bone, but before the next turn's lumen
// Phantoms and ten ears have 0.53 to 1.1 in the lumen, the least in the apex on 0.6 mm voxels; bone
// beyond the end of shorter lumens has 0.0 to 0.48.
constexpr double openLumen = 0.5;
constexpr double seenContrast = 0.35;
constexpr double lastBasal_deg = 180.0;  // bone before this angle is ossification, no apex
constexpr int closedSections = 4;
// A lumen fades towards its apex. Where coarse voxels leave the bone beyond its end above
// `openLumen`, the porous modiolus, which comes next, is seen as lumen again.
// Choices, made with the phantoms of EarGridTest in view; the ten ears that were tried keep their length.
constexpr double fadedLumen = 0.56, seenAgain = 0.08;
constexpr double aroundFit_mm = 8.0;
// The modiolus at the beginning of the middle turn: a cylinder about the axis, of two thirds of the
// inner wall's mean radius, and of the height that the turn climbs over a quarter; and one above it.
constexpr double secondTurn_deg = 720.0;
constexpr double coreRadius = 0.22;  // of the outer wall's
constexpr double coreHeight_mm = 0.5, coreStep_mm = 0.1;
// Chosen with one half of the ears and phantoms: whole ears had 0.067 and more, cavities up to 0.015.
// Of the other half two ears had 0.032 and 0.035 at 0.45 x 0.6 mm: what blur leaves of this counts
// as absence, and between both nothing is said (resources/guide/method.md).
constexpr double modiolusContrast = 0.04;
constexpr double judgedBlur_mm = 0.45;
constexpr double openTurn = 0.8;  // of what the fit shows in the lumen; less is filled

/// A section's content and that of the bone behind its outer wall: 1 at the lumen's level, 0 at the
/// bone's; empty if it is not measured.
struct SectionContent {
  double angle_deg = 0.0;
  std::optional<double> inside, wall;
};

class Content {
public:
  Content(const CtVolume& volume, const ShapedLumen& lumen, const FitState& state)
      : volume_(volume), lumen_(lumen), state_(state)
  {
  }

  SectionContent at(double angle_deg) const
  {
    const double half = halfHeight(angle_deg);
    return {angle_deg, mean(inside(angle_deg)),
            mean(placed<2>(angle_deg,
                           {{{-behindWall_mm, 0.2 * half}, {-behindWall_mm, -0.2 * half}}}))};
  }

  /// The modiolus is less of the lumen's level than the turn around it. Blur takes of the turn's
  /// level, but not of that in the middle of a cavity: the turn counts by what the fit shows there.
  ModiolusFinding modiolus(const ImageFit& fit, const FitResult& result) const
  {
    double seen = 0.0, shown = 0.0;
    for (double angle_deg = firstTurn_deg; angle_deg <= secondTurn_deg;
         angle_deg += sectionStep_deg) {
      const auto points_W = inside(angle_deg);
      const auto content = mean(points_W);
      if (!content) return ModiolusFinding::notJudged;
      seen += *content;
      for (const Eigen::Vector3d& point_W : points_W)
        shown += fit.contentAt(point_W, lumen_, state_) / static_cast<double>(points_W.size());
    }
    const auto core = mean(coreOfMiddleTurn(0.0)), above = mean(coreOfMiddleTurn(coreHeight_mm));
    if (!core || !above || seen < openTurn * shown) return ModiolusFinding::notJudged;
    const double contrast = seen / shown - *core;
    const double blur = std::max(state_.blurInPlane, state_.blurAxial);
    // a cavity may begin within the lower cylinder; blur of half its height joins it with the upper
    const double minimum =
        blur < 0.5 * coreHeight_mm ? std::min(contrast, seen / shown - *above) : contrast;
    const double error = errorOfCore(result.residual);
    const bool isNoisy = error > modiolusContrast;
    if (minimum >= modiolusContrast + (isNoisy ? 2.0 * error : 0.0)) return ModiolusFinding::seen;
    const double ratio = radiusOfCore() / blur;
    const double left = 1.0 - exponential(-0.5 * ratio * ratio);
    return isNoisy || blur > judgedBlur_mm || contrast >= left * modiolusContrast
               ? ModiolusFinding::notJudged
               : ModiolusFinding::absent;
  }

private:
  double halfHeight(double angle_deg) const
  {
    const double angle = degrees(angle_deg).si();
    return lumen_.place(angle).height * lumen_.mean().halfHeight(angle);
  }

  /// Points of the lumen off the spiral lamina, which reaches from the axis to the center.
  std::array<Eigen::Vector3d, 4> inside(double angle_deg) const
  {
    const double angle = degrees(angle_deg).si();
    const double width = lumen_.place(angle).width * lumen_.mean().width(angle);
    const double half = halfHeight(angle_deg);
    return placed<4>(angle_deg, {{{0.45 * width, 0.35 * half},
                                  {0.45 * width, -0.35 * half},
                                  {0.35 * width, 0.2 * half},
                                  {0.35 * width, -0.2 * half}}});
  }

  /// @param points  Inward from the outer wall and up from the section's center [mm].
  /// @returns       The points in W.
  template <std::size_t count>
  std::array<Eigen::Vector3d, count> placed(double angle_deg,
                                            const std::array<Eigen::Vector2d, count>& points) const
  {
    const double angle = degrees(angle_deg).si();
    const SectionPlace place = lumen_.place(angle);
    const SineCosine turn = sineCosine(angle);
    std::array<Eigen::Vector3d, count> points_W;
    for (std::size_t i = 0; i < count; ++i) {
      const double r = place.outer - points[i].x();
      points_W[i] = {r * turn.cosine, r * turn.sine,
                     place.middle - place.tilt * points[i].x() + points[i].y()};
    }
    return points_W;
  }

  double radiusOfCore() const
  {
    return coreRadius * lumen_.place(degrees(firstTurn_deg).si()).outer;
  }

  /// Standard deviation of the core's mean content.
  double errorOfCore(double residual) const
  {
    const double core_mm3 = pi * radiusOfCore() * radiusOfCore() * coreHeight_mm;
    return residual / std::fabs(state_.lumen - state_.bone) *
           std::sqrt(std::min(1.0, volume_.spacing_mm().prod() / core_mm3));
  }

  /// @param from_mm  Above the middle of the section at 360 degrees.
  std::vector<Eigen::Vector3d> coreOfMiddleTurn(double from_mm) const
  {
    const SectionPlace place = lumen_.place(degrees(firstTurn_deg).si());
    const double radius = radiusOfCore();
    const int across = static_cast<int>(radius / coreStep_mm);
    const int up = static_cast<int>(coreHeight_mm / coreStep_mm);
    std::vector<Eigen::Vector3d> points_W;
    for (int i = -across; i <= across; ++i)
      for (int j = -across; j <= across; ++j)
        for (int k = 0; k <= up; ++k) {
          const Eigen::Vector3d offset = coreStep_mm * Eigen::Vector3d(i, j, k);
          if (offset.head<2>().squaredNorm() <= radius * radius)
            points_W.emplace_back(offset + Eigen::Vector3d(0.0, 0.0, place.middle + from_mm));
        }
    return points_W;
  }

  template <class Points>
  std::optional<double> mean(const Points& points_W) const
  {
    double sum = 0.0;
    for (const Eigen::Vector3d& point_W : points_W) {
      const auto value = volume_.sample(state_.pose.outOf_W(point_W));
      if (!value) return std::nullopt;
      sum += (*value - state_.bone) / (state_.lumen - state_.bone);
    }
    return sum / static_cast<double>(points_W.size());
  }

  const CtVolume& volume_;
  const ShapedLumen& lumen_;
  const FitState& state_;
};

/// Calls a function with the center of every voxel within a distance of W's origin that is brighter
/// than bone, and has two neighbors that are: a single one is noise of dense bone.
void eachMetalVoxel(const CtVolume& volume, const Pose& pose,
                    const std::function<void(const Eigen::Vector3d&)>& function)
{
  std::array<int, 3> low{}, high{};
  const Eigen::Vector3d center = volume.toIndex(pose.origin_P), spacing = volume.spacing_mm();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<Eigen::Index>(axis);
    const double reach = aroundFit_mm / spacing[a];
    low[axis] = std::clamp(static_cast<int>(center[a] - reach), 0, volume.size()[axis] - 1);
    high[axis] = std::clamp(static_cast<int>(center[a] + reach), 0, volume.size()[axis] - 1);
  }
  const auto hasMetalNeighbors = [&](const std::array<int, 3>& index) {
    int neighbors = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int by : {-1, 1}) {
        std::array<int, 3> next = index;
        next[axis] += by;
        if (next[axis] < 0 || next[axis] >= volume.size()[axis]) continue;
        neighbors += volume.voxel(next[0], next[1], next[2]) > metalLevel ? 1 : 0;
      }
    return neighbors >= 2;
  };
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i)
        if (volume.voxel(i, j, k) > metalLevel && hasMetalNeighbors({i, j, k}))
          function(volume.toLps(Eigen::Vector3d(i, j, k)));
}

}  // namespace

LumenFindings examineLumen(const CtVolume& volume, const ShapedLumen& lumen, const ImageFit& fit,
                           const FitResult& result)
{
  const FitState& state = result.state;
  const double last_deg = inDegrees(radians(lumen.mean().lastAngle()));
  const Content content(volume, lumen, state);
  LumenFindings findings;
  int sections = 0, unknown = 0, basal = 0, gaps = 0, closed = 0;
  std::optional<double> end_deg, faded_deg;
  double minimum = 1e9;  // behind where it faded
  for (double angle_deg = firstSection_deg; angle_deg <= last_deg; angle_deg += sectionStep_deg) {
    const SectionContent section = content.at(angle_deg);
    ++sections;
    if (!section.inside || !section.wall) {
      ++unknown;
      continue;
    }
    if (angle_deg <= firstTurn_deg) {
      ++basal;
      gaps += *section.inside - *section.wall < seenContrast ? 1 : 0;
    }
    closed = *section.inside < openLumen ? closed + 1 : 0;
    if (!end_deg && closed == closedSections && angle_deg > lastBasal_deg)
      end_deg = angle_deg - (closedSections - 1) * sectionStep_deg;
    if (angle_deg > firstTurn_deg && *section.inside < fadedLumen) {
      if (!faded_deg) faded_deg = angle_deg;
      minimum = std::min(minimum, *section.inside);
    }
    if (!end_deg && *section.inside > minimum + seenAgain) end_deg = faded_deg;
  }
  findings.turns = end_deg.value_or(last_deg) / 360.0;
  findings.basalGap = basal > 0 ? static_cast<double>(gaps) / basal : 1.0;
  findings.unmeasured = sections > 0 ? static_cast<double>(unknown) / sections : 1.0;
  findings.modiolus = content.modiolus(fit, result);
  findings.metal_mm3 = metalAround_mm3(volume, state.pose);
  return findings;
}

double metalAround_mm3(const CtVolume& volume, const Pose& pose)
{
  double sum = 0.0;
  eachMetalVoxel(volume, pose, [&](const Eigen::Vector3d&) { sum += volume.spacing_mm().prod(); });
  return sum;
}

}  // namespace perilymph::ct
