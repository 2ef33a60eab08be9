// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/anatomy/MeanScala.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "lumen/OutlineTables.h"
#include "perilymph/anatomy/AnatomySource.h"
#include "perilymph/anatomy/Population.h"
#include "sources/MeanOutlines.h"

namespace perilymph::anatomy {
namespace {

struct Extent {
  double low, high;
};

Extent radii(const Outline& outline)
{
  Extent extent{outline.front().r, outline.front().r};
  for (const HalfPlanePoint& corner : outline)
    extent = {std::min(extent.low, corner.r), std::max(extent.high, corner.r)};
  return extent;
}

Extent heights(const Outline& outline)
{
  Extent extent{outline.front().z, outline.front().z};
  for (const HalfPlanePoint& corner : outline)
    extent = {std::min(extent.low, corner.z), std::max(extent.high, corner.z)};
  return extent;
}

/// The mean scala tympani scaled to a patient.
class ScaledMean {
public:
  ScaledMean(const MeanOutlines& mean, const BasalTurn& wanted, const IndividualShape& shape)
      : mean_(mean),
        typical_(likeliestHalfDiameters(diameter(mean, 0.0), diameter(mean, 90.0))),
        shape_(shape)
  {
    // 1 + even + odd cos 2 angle equals 1 + even + odd along A and 1 + even - odd along B
    const double alongA = wanted.a.si() / scaledDiameter(0.0);
    const double alongB = wanted.b.si() / scaledDiameter(90.0);
    even_ = 0.5 * (alongA + alongB) - 1.0;
    odd_ = 0.5 * (alongA - alongB);
    rise_ = 0.5 * (wanted.a / diameter(mean, 0.0) + wanted.b / diameter(mean, 90.0));
    if (wanted.h || shape.height != 1.0) rows_ = rows();
    if (wanted.h)
      fitHeight(wanted.h->si());
    else if (shape.height != 1.0)
      fitHeight(shape.height * height());
  }

  /// Ratio of the patient's radius to the mean's.
  double fraction(double angle) const
  {
    const double spiral =
        outerWallRadius(shape_.half, radians(angle)) / outerWallRadius(typical_, radians(angle));
    return spiral * (1.0 + shape_.radius.at(angle)) *
           (1.0 + even_ + odd_ * sineCosine(2.0 * angle).cosine);
  }

  Outline outline(double angle) const
  {
    Outline outline = mean_.outline(angle);
    const double size = fraction(angle);
    const double section = shape_.sectionAt(angle);
    const double course = shape_.course.at(angle);
    const double center = centroid(outline).z;
    const Extent extent = radii(outline);
    for (HalfPlanePoint& corner : outline)
      corner = {size * sized(corner.r, extent, section),
                rise_ * center + course + size * section * (corner.z - center)};
    return outline;
  }

  /// Distance of the organ-of-Corti path from the axis [m].
  double organOfCorti(double angle) const
  {
    const double r = mean_.organOfCorti(angle);
    const double section = shape_.sectionAt(angle);
    if (section == 1.0) return fraction(angle) * r;
    return fraction(angle) * sized(r, radii(mean_.outline(angle)), section);
  }

private:
  /// A radius of a section whose width has a factor; the outer wall stays, and the inner one is not
  /// nearer to the axis than half its distance in the mean.
  static double sized(double r, const Extent& extent, double section)
  {
    if (section == 1.0) return r;
    const double widest = (extent.high - 0.5 * extent.low) / (extent.high - extent.low);
    return extent.high - std::min(section, widest) * (extent.high - r);
  }

  static Length diameter(const MeanOutlines& mean, double from_deg)
  {
    return Length::fromSi(radii(mean.outline(degrees(from_deg).si())).high +
                          radii(mean.outline(degrees(from_deg + 180.0).si())).high);
  }

  double scaledDiameter(double from_deg) const
  {
    double sum = 0.0;
    for (const double angle_deg : {from_deg, from_deg + 180.0}) {
      const double angle = degrees(angle_deg).si();
      sum += fraction(angle) * radii(mean_.outline(angle)).high;
    }
    return sum;
  }

  /// From the lowest floor to the highest roof with the present rise [m].
  double height() const
  {
    Extent whole{1.0, -1.0};
    for (const Row& row : rows_)
      whole = {std::min(whole.low, rise_ * row.center + row.below),
               std::max(whole.high, rise_ * row.center + row.above)};
    return whole.high - whole.low;
  }

  /// Center of a section in the mean, and its floor and roof from there in the patient [m].
  struct Row {
    double center, below, above;
  };
  std::vector<Row> rows() const
  {
    std::vector<Row> rows;
    constexpr double step_deg = 3.0;
    for (double angle_deg = 0.0; angle_deg <= inDegrees(radians(MeanOutlines::lastAngle()));
         angle_deg += step_deg) {
      const double angle = degrees(angle_deg).si();
      const Outline outline = mean_.outline(angle);
      const double center = centroid(outline).z;
      const Extent extent = heights(outline);
      const double size = fraction(angle) * shape_.sectionAt(angle);
      const double course = shape_.course.at(angle);
      rows.push_back(
          {center, course + size * (extent.low - center), course + size * (extent.high - center)});
    }
    return rows;
  }

  // The height increases with the rise: bisection.
  void fitHeight(double wanted)
  {
    double low = 0.0, high = 4.0;
    for (int i = 0; i < 60; ++i) {
      rise_ = 0.5 * (low + high);
      (height() < wanted ? low : high) = rise_;
    }
  }

  const MeanOutlines& mean_;
  HalfDiameters typical_;
  IndividualShape shape_;
  double even_ = 0.0, odd_ = 0.0;
  double rise_ = 1.0;
  std::vector<Row> rows_;
};

std::shared_ptr<const ScalaTympani> measuredScala(const MeanOutlines& mean, SectionTables tables)
{
  tables.measuredTo = mean.measuredAngle();
  return std::make_shared<const ScalaTympani>(std::move(tables));
}

}  // namespace

Result<std::shared_ptr<const ScalaTympani>> buildMean(Length leadIn)
{
  const auto sections = loadMeasuredSections();
  if (!sections) return sections.error();
  const MeanOutlines mean(*sections);
  const double last = MeanOutlines::lastAngle();
  const OutlineSource source = [&](double angle) {
    return OutlineAtAngle{mean.outline(angle), mean.organOfCorti(angle),
                          membraneWidth(angle, last) * MeanOutlines::capFraction(angle)};
  };
  return measuredScala(mean, tablesFrom(source, nameOf(AnatomySource::mean), last, leadIn.si()));
}

Result<std::shared_ptr<const ScalaTympani>> buildMean(const std::string& label,
                                                      const BasalTurn& basalTurn, Length leadIn)
{
  return buildMean(label, basalTurn,
                   IndividualShape{likeliestHalfDiameters(basalTurn.a, basalTurn.b)}, leadIn);
}

Result<std::shared_ptr<const ScalaTympani>> buildMean(const std::string& label,
                                                      const BasalTurn& basalTurn,
                                                      const IndividualShape& shape, Length leadIn)
{
  const auto sections = loadMeasuredSections();
  if (!sections) return sections.error();
  const MeanOutlines mean(*sections);
  const ScaledMean scaled(mean, basalTurn, shape);
  const double last = MeanOutlines::lastAngle();
  const OutlineSource source = [&](double angle) {
    return OutlineAtAngle{scaled.outline(angle), scaled.organOfCorti(angle),
                          membraneWidth(angle, last) * MeanOutlines::capFraction(angle)};
  };
  return measuredScala(mean, tablesFrom(source, label, last, leadIn.si()));
}

}  // namespace perilymph::anatomy
