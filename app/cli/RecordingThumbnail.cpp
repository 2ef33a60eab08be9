// SPDX-License-Identifier: BSD-3-Clause
#include "RecordingThumbnail.h"

#include <algorithm>

#include "Terminal.h"
#include "perilymph/figures/Figure.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::cli {

namespace {

// Least range of the force, so that a gentle insertion looks gentle: about the highest peak in patients
// (Rau et al. 2024).
constexpr double minShownForce = 0.1;    // [N]
constexpr double minShownTravel = 5e-3;  // [m]

}  // namespace

figures::Drawing thumbnailOf(const analysis::ForceProfile& profile, double side)
{
  const double left = 0.08 * side, right = 0.94 * side, top = 0.3 * side, bottom = 0.78 * side;
  double farthest = minShownTravel, highest = minShownForce;
  for (const analysis::CurvePoint& point : profile.curve) {
    farthest = std::max(farthest, point.travel);
    highest = std::max(highest, point.force);
  }
  figures::Stroke curve{{}, figures::ink::blue, 0.03 * side};
  for (const analysis::CurvePoint& point : profile.curve)
    curve.points.push_back({left + (right - left) * point.travel / farthest,
                            bottom - (bottom - top) * std::clamp(point.force / highest, 0.0, 1.0)});

  const double text = 0.17 * side;
  figures::Drawing drawing{side, side, {}};
  drawing.marks.emplace_back(figures::Area{{{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}},
                                           figures::Ink{{255, 255, 255}, 1.0}});
  drawing.marks.emplace_back(figures::Stroke{
      {{left, top}, {left, bottom}, {right, bottom}}, figures::ink::gray, 0.015 * side});
  if (curve.points.size() > 1) {
    figures::Area under{curve.points, figures::ink::tint(figures::ink::blue, 0.15)};
    under.points.push_back({curve.points.back().x, bottom});
    under.points.push_back({curve.points.front().x, bottom});
    drawing.marks.emplace_back(std::move(under));
    drawing.marks.emplace_back(std::move(curve));
  }
  const auto write = [&](double x, double y, std::string words, figures::Anchor anchor) {
    figures::Label label{{x, y}, std::move(words), text, figures::ink::black, anchor};
    label.isBold = true;
    drawing.marks.emplace_back(std::move(label));
  };
  write(left, 0.19 * side, fixed(1e3 * profile.peak.force, 0) + " mN", figures::Anchor::start);
  write(right, 0.96 * side, fixed(inMillimeters(meters(profile.deepest)), 1) + " mm",
        figures::Anchor::end);
  return drawing;
}

}  // namespace perilymph::cli
