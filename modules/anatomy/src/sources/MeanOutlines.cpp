// SPDX-License-Identifier: BSD-3-Clause
#include "sources/MeanOutlines.h"

#include <algorithm>
#include <cmath>

#include "lumen/SectionWall.h"
#include "perilymph/foundation/Math.h"

namespace perilymph::anatomy {
namespace {

// The measured angles are counted from the first section. That this section is at the center of the
// round window is an assumption (confidence medium: it reproduces A, B and the lengths). A negative
// angle would put the round window beyond the first section.
constexpr double firstSection_deg = 0.0;

// Beyond the last measured section at 675 degrees: extrapolated to 2.5 turns by the trend of the
// last turn and closed by a cap (ours; confidence low).
constexpr double last_deg = 900.0;
constexpr double trendStep_deg = 22.5;
// The cap: an ellipsoid about as long as half the section's width there, truncated where it has
// shrunk to 31 %.
constexpr double cap_deg = 50.0;
constexpr double capCut = 0.95;

// Distance of the organ-of-Corti path inside the outermost wall: with it the path is 31.0 mm long
// to 675 degrees, as in the same cochleae (Schurzig et al. 2021, Life 11:373).
constexpr double organOfCortiInside = 0.176e-3;

constexpr double membraneWidthBase = 0.15e-3;
constexpr double membraneWidthApex = 0.52e-3;

constexpr int corners = 240;

/// Extrapolates sections by the trend of the last measured turn: all dimensions shrink with the
/// radius of the outer wall, and the rise with them.
std::vector<MeasuredSection> continued(std::vector<MeasuredSection> sections)
{
  const MeasuredSection last = sections.back();
  const auto before = std::find_if(sections.begin(), sections.end(), [&](const auto& section) {
    return section.angle >= last.angle - 2.0 * pi - 1e-6;
  });
  constexpr auto center = static_cast<std::size_t>(MeasuredSection::harmonics);
  const double turn = last.angle - before->angle;
  const double shrinking = logarithm(before->outerRadius / last.outerRadius) / turn;
  const double rise = (last.imaginary[center] - before->imaginary[center]) / turn;
  const double end = degrees(last_deg - firstSection_deg).si();
  const auto steps = std::lround(inDegrees(radians(end - last.angle)) / trendStep_deg);
  for (long i = 1; i <= steps; ++i) {
    MeasuredSection next = last;
    const double past = (end - last.angle) * static_cast<double>(i) / static_cast<double>(steps);
    const double fraction = exponential(-shrinking * past);
    next.angle = last.angle + past;
    for (double& value : next.real) value *= fraction;
    for (double& value : next.imaginary) value *= fraction;
    next.imaginary[center] = last.imaginary[center] + rise * (1.0 - fraction) / shrinking;
    next.outerRadius *= fraction;
    sections.push_back(next);
  }
  return sections;
}

}  // namespace

MeanOutlines::MeanOutlines(const std::vector<MeasuredSection>& measured)
    : measured_(measured.back().angle + degrees(firstSection_deg).si())
{
  const std::vector<MeasuredSection> sections = continued(measured);
  std::vector<double> angles;
  angles.reserve(sections.size());
  for (const MeasuredSection& section : sections)
    angles.push_back(section.angle + degrees(firstSection_deg).si());
  // Not-a-knot ends: the wall curves in so fast at the round window that a natural end has a mean
  // error of 40 um at 8 degrees, this one 15.
  for (std::size_t k = 0; k < sections.front().real.size(); ++k) {
    std::vector<double> real, imaginary;
    for (const MeasuredSection& section : sections) {
      real.push_back(section.real[k]);
      imaginary.push_back(section.imaginary[k]);
    }
    real_.emplace_back(angles, real, SplineEnds::notAKnot);
    imaginary_.emplace_back(angles, imaginary, SplineEnds::notAKnot);
  }
}

double MeanOutlines::lastAngle() { return degrees(last_deg).si(); }

double MeanOutlines::capFraction(double angle)
{
  const double begin = lastAngle() - degrees(cap_deg).si();
  const double x = capCut * std::clamp((angle - begin) / degrees(cap_deg).si(), 0.0, 1.0);
  return std::sqrt(1.0 - x * x);
}

Outline MeanOutlines::outline(double angle) const { return outline(angle, capFraction(angle)); }

Outline MeanOutlines::outline(double angle, double fraction) const
{
  constexpr int harmonics = MeasuredSection::harmonics;
  constexpr std::size_t count = 2 * harmonics + 1;
  std::array<double, count> real{}, imaginary{};
  for (std::size_t k = 0; k < real.size(); ++k) {
    const double size = k == harmonics ? 1.0 : fraction;
    real[k] = size * real_[k](angle);
    imaginary[k] = size * imaginary_[k](angle);
  }
  const auto& turns = directionsAround<corners>();
  Outline outline;
  outline.reserve(corners);
  for (int i = 0; i < corners; ++i) {
    HalfPlanePoint point{real[harmonics], imaginary[harmonics]};
    for (int k = 1; k <= harmonics; ++k) {
      // e^(i k t) and its conjugate, each times its coefficient
      const SineCosine& turn = turns[static_cast<std::size_t>((i * k) % corners)].around;
      const int forward = harmonics + k;
      const int backward = harmonics - k;
      const auto ahead = static_cast<std::size_t>(forward);
      const auto back = static_cast<std::size_t>(backward);
      point.r += (real[ahead] + real[back]) * turn.cosine -
                 (imaginary[ahead] - imaginary[back]) * turn.sine;
      point.z += (imaginary[ahead] + imaginary[back]) * turn.cosine +
                 (real[ahead] - real[back]) * turn.sine;
    }
    outline.push_back(point);
  }
  return outline;
}

double MeanOutlines::organOfCorti(double angle) const
{
  // the path does not follow the cap
  double outermost = 0.0;
  for (const HalfPlanePoint& corner : outline(angle, 1.0))
    outermost = std::max(outermost, corner.r);
  return outermost - organOfCortiInside;
}

double membraneWidth(double angle, double lastAngle)
{
  return membraneWidthBase + angle / lastAngle * (membraneWidthApex - membraneWidthBase);
}

}  // namespace perilymph::anatomy
