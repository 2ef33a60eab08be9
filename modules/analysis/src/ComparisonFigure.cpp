// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "perilymph/analysis/ComparisonGroups.h"

namespace perilymph::analysis {

using figures::Figure;
using figures::FigureBand;
using figures::FigureCurve;
using figures::FigureValues;
namespace ink = figures::ink;

namespace {

// Distinguished by color and dashes; from the fifth on by longer dashes, too.
constexpr figures::Ink inks[] = {ink::blue, ink::vermilion, ink::green, ink::purple};

double shownForce(double force) { return inMillinewtons(newtons(force)); }

FigureCurve emptyCurve(Sentence label, std::size_t number)
{
  FigureCurve curve;
  curve.label = std::move(label);
  curve.ink = inks[number % 4];
  curve.dash = 2.0 * static_cast<double>(number);
  return curve;
}

void addInsertion(Figure& figure, const ComparedInsertion& insertion, CurveAxis axis,
                  std::size_t number)
{
  FigureCurve curve = emptyCurve(labelOf(insertion), number);
  for (const AxisPoint& point : curveOver(insertion, axis)) {
    curve.x.push_back(shownPlace(axis, point.place));
    curve.y.push_back(shownForce(point.force));
  }
  const auto& rib = insertion.ribPeak;
  if (rib && figure.texts.empty())  // one text: those of several would lie on each other
    figure.texts.push_back({Sentence{"rib %1 at the opening", insertion.ribNumber},
                            shownPlace(axis, placeOf(*rib, axis)), shownForce(rib->force),
                            curve.ink});
  figure.curves.push_back(std::move(curve));
}

void addGroup(Figure& figure, const MeanCurve& mean, const InsertionGroup& group, CurveAxis axis,
              std::size_t number)
{
  FigureCurve curve =
      emptyCurve(Sentence{"%1, mean ± SD, n = %2", group.title(), group.members.size()}, number);
  FigureBand band;
  band.ink = ink::tint(curve.ink, 0.15);
  for (std::size_t i = 0; i < mean.place.size(); ++i) {
    curve.x.push_back(shownPlace(axis, mean.place[i]));
    curve.y.push_back(shownForce(mean.mean[i]));
    band.low.push_back(shownForce(mean.mean[i] - mean.sd[i]));
    band.high.push_back(shownForce(mean.mean[i] + mean.sd[i]));
  }
  band.x = curve.x;
  figure.curves.push_back(std::move(curve));
  figure.bands.push_back(std::move(band));
}

FigureValues valuesOfPublished(const Reference& published)
{
  FigureValues printed;
  printed.label = published.label;
  printed.ink = ink::black;
  printed.shape = figures::MarkerShape::ring;
  for (const PrintedForce& point : published.points) {
    printed.x.push_back(shownPlace(CurveAxis::travel, point.travel));
    printed.y.push_back(shownForce(point.mean));
    printed.low.push_back(shownForce(point.mean - point.standardDeviation));
    printed.high.push_back(shownForce(point.mean + point.standardDeviation));
  }
  return printed;
}

Sentence titleOf(CurveAxis axis)
{
  if (axis == CurveAxis::depth) return Sentence{"insertion depth, mm"};
  if (axis == CurveAxis::angle) return Sentence{"tip angle, °"};
  return Sentence{"travel, mm"};
}

}  // namespace

double placeOf(const ForceAtDepth& maximum, CurveAxis axis)
{
  if (axis == CurveAxis::depth) return maximum.depth;
  return axis == CurveAxis::angle ? maximum.angle : maximum.travel;
}

Figure comparisonFigure(const std::vector<ComparedInsertion>& insertions,
                        const Reference* published, CurveAxis axis,
                        const std::vector<InsertionGroup>& groups)
{
  Figure figure;
  figure.title = Sentence{"Recorded insertions: insertion force"};
  if (groups.empty())
    for (std::size_t i = 0; i < insertions.size(); ++i)
      addInsertion(figure, insertions[i], axis, i);
  for (std::size_t i = 0; i < groups.size(); ++i)
    addGroup(figure, meanCurve(insertions, groups[i], axis), groups[i], axis, i);
  if (published != nullptr && axis == CurveAxis::travel)
    figure.values.push_back(valuesOfPublished(*published));

  double nearest = 0.0, farthest = 0.0, lowest = 0.0, highest = 0.0;
  const auto include = [](double& low, double& high, const std::vector<double>& values) {
    for (const double value : values) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  };
  for (const FigureCurve& curve : figure.curves) {
    include(nearest, farthest, curve.x);
    include(lowest, highest, curve.y);
  }
  for (const FigureBand& band : figure.bands) {
    include(lowest, highest, band.low);
    include(lowest, highest, band.high);
  }
  for (const FigureValues& values : figure.values) {
    include(nearest, farthest, values.x);
    include(lowest, highest, values.high);
  }
  constexpr double negligible_mN = 10.0;  // the vibration of an array at rest moves no axis
  if (lowest > -negligible_mN) lowest = 0.0;
  figure.x = figures::axisOver(titleOf(axis), nearest, farthest);
  figure.y = figures::axisOver(Sentence{"insertion force, mN"}, lowest, highest);
  return figure;
}

}  // namespace perilymph::analysis
