// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/analysis/AnatomyMeasures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "perilymph/analysis/ClinicalEstimates.h"
#include "perilymph/analysis/Tonotopy.h"
#include "perilymph/foundation/Math.h"
#include "perilymph/session/Csv.h"

namespace perilymph::analysis {

namespace {

/// Radius from the axis and height of a path at an angle [m].
struct PathPoint {
  double radius, height;
};
using Path = std::function<PathPoint(double angle)>;

/// Length of a polyline along a path [m].
double lengthOf(const Path& path, double last, int pieces)
{
  const auto place = [&](int i) -> Eigen::Vector3d {
    const double angle = last * i / pieces;
    const PathPoint point = path(angle);
    const SineCosine turn = sineCosine(angle);
    return {point.radius * turn.cosine, point.radius * turn.sine, point.height};
  };
  double length = 0.0;
  Eigen::Vector3d before = place(0);
  for (int i = 1; i <= pieces; ++i) {
    const Eigen::Vector3d now = place(i);
    length += (now - before).norm();
    before = now;
  }
  return length;
}

int piecesOver(double angle)
{
  return std::max(1, static_cast<int>(std::ceil(inDegrees(radians(angle)) * 4.0)));
}

/// The outermost point of the section at an angle.
PathPoint outermost(const anatomy::ScalaTympani& scala, double angle)
{
  constexpr int directions = 360;
  PathPoint best{0.0, 0.0};
  for (int k = 0; k < directions; ++k) {
    const Eigen::Vector3d wall = scala.wall_W(angle, 2.0 * pi * k / directions);
    const double radius = std::sqrt(wall.x() * wall.x() + wall.y() * wall.y());
    if (radius > best.radius) best = {radius, wall.z()};
  }
  return best;
}

// The spacing of the sections of the mean scala tympani (Froehlich et al. 2024), for lengths
// comparable with those measured on it.
constexpr double outerWallStep_deg = 22.5;

/// The outermost points of sections at equal angles, linearly interpolated in radius and height.
Path outerWall(const anatomy::ScalaTympani& scala)
{
  const double step = degrees(outerWallStep_deg).si();
  const double last = scala.lastAngle().si();
  std::vector<PathPoint> points;
  for (std::size_t i = 0; step * static_cast<double>(i) < last + step; ++i)
    points.push_back(outermost(scala, std::min(step * static_cast<double>(i), last)));
  return [points, step, last](double angle) {
    const auto i = std::min(static_cast<std::size_t>(angle / step), points.size() - 2);
    const double from = step * static_cast<double>(i);
    const double fraction = (angle - from) / (std::min(from + step, last) - from);
    const PathPoint& a = points[i];
    const PathPoint& b = points[i + 1];
    return PathPoint{a.radius + fraction * (b.radius - a.radius),
                     a.height + fraction * (b.height - a.height)};
  };
}

/// The organ-of-Corti path in the plan view, linear between the table entries.
Path organOfCortiPlan(const anatomy::ScalaTympani& scala)
{
  return [&scala](double angle) {
    const std::vector<double>& plan = scala.tables().planRadius;
    const double place = angle / scala.tables().step;
    const auto i = std::min(static_cast<std::size_t>(place), plan.size() - 2);
    const double fraction = place - static_cast<double>(i);
    return PathPoint{plan[i] + fraction * (plan[i + 1] - plan[i]), 0.0};
  };
}

/// Number of equal pieces of an angle, none above the maximum.
int piecesIn(double angle, Angle maxStep)
{
  return std::max(1, static_cast<int>(std::ceil(angle / maxStep.si() - 1e-9)));
}

/// Length of a chord in cylindrical coordinates [m].
double chord(const PathPoint& from, const PathPoint& to, double angle)
{
  const double mean = 0.5 * (to.radius + from.radius) * angle;
  const double out = to.radius - from.radius;
  const double up = to.height - from.height;
  return std::sqrt(mean * mean + out * out + up * up);
}

/// Integral of r over the area of the section at an angle [m^3]: volume per radian.
double sweptPerRadian(const anatomy::ScalaTympani& scala, double angle)
{
  constexpr int corners = 360;
  double sum = 0.0;
  PathPoint before{};
  for (int k = 0; k <= corners; ++k) {
    const Eigen::Vector3d wall = scala.wall_W(angle, 2.0 * pi * k / corners);
    const PathPoint now{std::sqrt(wall.x() * wall.x() + wall.y() * wall.y()), wall.z()};
    // Green's theorem: the integral of r over an area is that of r^2/2 dz around it.
    if (k > 0)
      sum +=
          (now.height - before.height) *
          (before.radius * before.radius + before.radius * now.radius + now.radius * now.radius) /
          6.0;
    before = now;
  }
  return sum;
}

/// Simpson's rule over the angle, from the round window on.
double volume(const anatomy::ScalaTympani& scala, double last)
{
  const int pieces = 2 * std::max(1, static_cast<int>(std::ceil(inDegrees(radians(last)) / 2.0)));
  double sum = 0.0;
  for (int i = 0; i <= pieces; ++i) {
    const double weight = i == 0 || i == pieces ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * sweptPerRadian(scala, last * i / pieces);
  }
  return sum * last / (3.0 * pieces);
}

}  // namespace

BasalDiameters basalDiameters(const anatomy::ScalaTympani& scala)
{
  const auto outer = [&scala](double angle_deg) {
    return meters(scala.section(degrees(angle_deg).si()).outerRadius);
  };
  return {outer(0) + outer(180), outer(90) + outer(270)};
}

BasalDiameters basalDiameters(const anatomy::ScalaTympani& scala, const anatomy::Cochlea& cochlea)
{
  const auto& turn = cochlea.patient.basalTurn;
  if (turn && isScaledBy(cochlea.source, cochlea.patient)) return {turn->a, turn->b};
  return basalDiameters(scala);
}

Length organOfCortiLength(const anatomy::ScalaTympani& scala)
{
  const double last = scala.lastAngle().si();
  return meters(lengthOf(organOfCortiPlan(scala), last, piecesOver(last)));
}

OrganOfCorti::OrganOfCorti(const anatomy::ScalaTympani& scala)
{
  const double last = scala.lastAngle().si();
  const int pieces = piecesIn(last, degrees(2));
  step_ = last / pieces;
  const Path path = organOfCortiPlan(scala);
  PathPoint before = path(0.0);
  length_.push_back(0.0);
  for (int i = 1; i <= pieces; ++i) {
    const PathPoint now = path(step_ * i);
    length_.push_back(length_.back() + chord(before, now, step_));
    before = now;
  }
}

double OrganOfCorti::fractionAt(Angle angle) const noexcept
{
  const double place = angle.si() / step_;
  if (!(place > 0.0)) return 0.0;
  const auto i = static_cast<std::size_t>(place);
  if (i + 1 >= length_.size()) return 1.0;
  const double part = place - static_cast<double>(i);
  return (length_[i] + part * (length_[i + 1] - length_[i])) / length_.back();
}

std::vector<Measure> measure(const anatomy::ScalaTympani& scala, const anatomy::Cochlea& cochlea)
{
  const double last = scala.lastAngle().si();
  const auto mm = [](double length) { return inMillimeters(meters(length)); };
  const BasalDiameters basal = basalDiameters(scala), stated = basalDiameters(scala, cochlea);
  const double a_mm = inMillimeters(basal.a), b_mm = inMillimeters(basal.b);

  const anatomy::Section first = scala.section(0.0);
  double floor = first.floorHeight, roof = first.roofHeight;
  double lowest = first.centerHeight, highest = lowest;
  for (const SectionRow& row : sectionRows(scala, degrees(1))) {
    floor = std::min(floor, row.section.floorHeight);
    roof = std::max(roof, row.section.roofHeight);
    lowest = std::min(lowest, row.section.centerHeight);
    highest = std::max(highest, row.section.centerHeight);
  }
  const double turn = std::min(2.0 * pi, last);
  const double measured = scala.measuredAngle().si();
  const Path outer = outerWall(scala);
  const auto outerLength_mm = [&](double to) { return mm(lengthOf(outer, to, piecesOver(to))); };
  const std::string own = "measured from the lumen of this model";
  std::vector<Measure> measures = {
      {"A_mm", a_mm, "outer wall radius at 0 deg + at 180 deg",
       own + "; A as in clinical planning, from the round window through the modiolus to the "
             "far wall"},
      {"B_mm", b_mm, "outer wall radius at 90 deg + at 270 deg",
       own + "; B as in clinical planning, across A through the modiolus"},
      {"H_mm", mm(roof - floor), "highest roof - lowest floor along the modiolar axis", own},
      {"turns", inDegrees(radians(last)) / 360.0, "angle of the last section / 360 deg", own},
      {"st_length_mm", inMillimeters(organOfCortiLength(scala)),
       "length of the organ-of-Corti path in the plan, round window to apex",
       own + "; definition of Todd and Naghdy, section II.B"},
      ductLength("cdl_oc_mm", stated.a, stated.b),
      {"outer_wall_length_360_mm", outerLength_mm(turn),
       "length through the outermost points of sections 22.5 deg apart, 0 to 360 deg", own},
      {"outer_wall_length_mm", outerLength_mm(measured),
       "the same, 0 deg to the last measured section", own},
      {"volume_mm3", volume(scala, measured) * 1e9,
       "integral of r over each section's area and over the angle (Pappus), 0 deg to the last "
       "measured section",
       own},
      {"axial_height_mm", mm(highest - lowest), "highest - lowest center of a section", own},
      {"rw_width_mm", mm(first.outerRadius - first.innerRadius),
       "outer - inner wall radius of the section at 0 deg", own},
      {"rw_height_mm", mm(first.roofHeight - first.floorHeight),
       "roof - floor of the section at 0 deg", own},
      {"measured_to_deg", inDegrees(scala.measuredAngle()),
       "angle of the last measured section; beyond it the model extrapolates", own}};
  if (measured < last) {
    measures.push_back({"outer_wall_length_to_apex_mm", outerLength_mm(last),
                        "as outer_wall_length_mm, 0 deg to the last section", own});
    measures.push_back({"volume_to_apex_mm3", volume(scala, last) * 1e9,
                        "as volume_mm3, 0 deg to the last section", own});
  }
  for (Measure& estimate : clinicalEstimates(stated.a, stated.b))
    measures.push_back(std::move(estimate));
  return measures;
}

std::vector<SectionRow> sectionRows(const anatomy::ScalaTympani& scala, Angle maxStep)
{
  const double last = scala.lastAngle().si();
  const int pieces = piecesIn(last, maxStep);
  const std::array<Path, 4> paths = {
      outerWall(scala),
      [&scala](double angle) {
        const anatomy::Section section = scala.section(angle);
        return PathPoint{section.centerRadius, section.centerHeight};
      },
      [&scala](double angle) {
        const Eigen::Vector3d wall = scala.wall_W(angle, pi);
        return PathPoint{std::sqrt(wall.x() * wall.x() + wall.y() * wall.y()), wall.z()};
      },
      organOfCortiPlan(scala)};
  std::vector<SectionRow> rows;
  std::array<double, 4> length{};
  std::array<PathPoint, 4> before{};
  const double step = last / pieces;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = step * i;
    for (std::size_t p = 0; p < paths.size(); ++p) {
      const PathPoint now = paths[p](angle);
      if (i > 0) length[p] += chord(before[p], now, step);
      before[p] = now;
    }
    rows.push_back({angle, scala.section(angle), length[0], length[1], length[2], length[3]});
  }
  return rows;
}

std::vector<std::pair<const char*, std::vector<double>>> sectionColumns(
    const std::vector<SectionRow>& rows)
{
  using Value = double (*)(const SectionRow&);
  static constexpr auto mm = [](double length) { return inMillimeters(meters(length)); };
  constexpr std::pair<const char*, Value> measured[] = {
      {"angle_deg", [](const SectionRow& row) { return inDegrees(radians(row.angle)); }},
      {"center_r_mm", [](const SectionRow& row) { return mm(row.section.centerRadius); }},
      {"center_z_mm", [](const SectionRow& row) { return mm(row.section.centerHeight); }},
      {"inner_r_mm", [](const SectionRow& row) { return mm(row.section.innerRadius); }},
      {"outer_r_mm", [](const SectionRow& row) { return mm(row.section.outerRadius); }},
      {"width_mm",
       [](const SectionRow& row) { return mm(row.section.outerRadius - row.section.innerRadius); }},
      {"floor_z_mm", [](const SectionRow& row) { return mm(row.section.floorHeight); }},
      {"roof_z_mm", [](const SectionRow& row) { return mm(row.section.roofHeight); }},
      {"height_mm",
       [](const SectionRow& row) { return mm(row.section.roofHeight - row.section.floorHeight); }},
      {"area_mm2", [](const SectionRow& row) { return row.section.area * 1e6; }},
      {"outer_wall_length_mm", [](const SectionRow& row) { return mm(row.outerWallLength); }},
      {"center_length_mm", [](const SectionRow& row) { return mm(row.centerLength); }},
      {"inner_wall_length_mm", [](const SectionRow& row) { return mm(row.innerWallLength); }},
      {"organ_of_corti_mm", [](const SectionRow& row) { return mm(row.organOfCortiLength); }}};
  std::vector<std::pair<const char*, std::vector<double>>> columns;
  for (const auto& [name, value] : measured) {
    columns.emplace_back(name, std::vector<double>());
    for (const SectionRow& row : rows) columns.back().second.push_back(value(row));
  }
  const double organ = rows.empty() ? 1.0 : rows.back().organOfCortiLength;
  std::vector<double> greenwood, spiralGanglion;
  for (const SectionRow& row : rows) {
    greenwood.push_back(greenwoodFrequency(1.0 - row.organOfCortiLength / organ));
    spiralGanglion.push_back(spiralGanglionFrequency(radians(row.angle)));
  }
  columns.emplace_back("greenwood_Hz", std::move(greenwood));
  columns.emplace_back("spiral_ganglion_Hz", std::move(spiralGanglion));
  return columns;
}

std::string sectionsCsv(const std::vector<SectionRow>& rows)
{
  const auto columns = sectionColumns(rows);
  std::string csv;
  for (const auto& [name, values] : columns) csv += (csv.empty() ? "" : ",") + std::string(name);
  csv += '\n';
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < columns.size(); ++k)
      csv += (k > 0 ? "," : "") + session::shortestDecimal(columns[k].second[i]);
    csv += '\n';
  }
  return csv;
}

}  // namespace perilymph::analysis
