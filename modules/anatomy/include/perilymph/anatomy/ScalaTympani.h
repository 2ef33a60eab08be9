// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The scala tympani as tables over the angle from the round window: center of the section and
// distance of the wall from it in every direction. Every source of anatomy is converted to these
// tables.

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

class LumenField;
class ScalaeAbove;

/// Tables that a source of anatomy provides. Sections lie in half-planes through the modiolar axis
/// at equal angular spacing; the last one closes the apex.
struct SectionTables {
  std::string name;                  ///< For display: "published, 35.58 mm".
  double step = 0.0;                 ///< Angle between sections [rad].
  std::vector<double> centerRadius;  ///< Distance of the section's center from the axis [m].
  std::vector<double> centerHeight;  ///< Height of the section's center along the axis [m].
  int directions = 0;                ///< Directions around the section, the first radially outward.
  std::vector<double> wallRadius;    ///< From the center to the wall [m], `directions` per section.
  std::vector<double>
      membraneInner;  ///< Inner edge of the basilar membrane from the center, radial [m].
  std::vector<double> membraneOuter;   ///< Its outer edge [m].
  std::vector<double> membraneHeight;  ///< Its height above the section's center [m].
  std::vector<double> planRadius;      ///< Distance of the organ-of-Corti path from the axis [m].
  double leadIn = 0.0;                 ///< Straight length before the first section [m].
  /// Angle up to which sections were measured [rad]; those beyond are extrapolated. 0: all were
  /// measured.
  double measuredTo = 0.0;
};

/// Values interpolated between the tables at one angle.
struct Section {
  double centerRadius;  ///< [m]
  double centerHeight;  ///< [m]
  double innerRadius;   ///< Minimum distance of the wall from the axis [m].
  double outerRadius;   ///< Maximum distance of the wall from the axis [m].
  double floorHeight;   ///< [m]
  double roofHeight;    ///< [m]
  double area;          ///< [m^2]
};

/// The lumen of a scala tympani in the cochlear frame W: z along the modiolus toward the apex,
/// angle zero at the center of the round window on the x axis, right ear.
///
/// Values between the table entries are uniform cubic B-splines: twice continuously differentiable
/// in the angle and around the section. The wall query reads a distance table (LumenField), which
/// prepare() builds from them: measures and pictures need none. Before the round window the first section continues straight, along the tangent of
/// the center line, for the length of the lead-in, where the opening is.
class ScalaTympani : public Lumen {
public:
  /// @throws std::invalid_argument if the tables are inconsistent.
  explicit ScalaTympani(SectionTables tables);
  ~ScalaTympani() override;

  const std::string& name() const noexcept { return tables_.name; }

  void prepare() const override;

  Entry entry() const noexcept override { return entry_; }
  const ScalaTympani* scala() const noexcept override { return this; }
  LumenTrack startTrack() const noexcept override { return {}; }

  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<LumenTrack> tracks,
                   std::span<WallPoint> walls) const noexcept override;
  void follow(const Eigen::Vector3d& point_W, LumenTrack& track) const noexcept override;
  void addTo(Hash& hash) const noexcept override;

  Angle lastAngle() const noexcept { return Angle::fromSi(lastAngle_); }
  /// Angle at which measured sections end and extrapolation begins; the last angle if all are
  /// measured.
  Angle measuredAngle() const noexcept
  {
    return tables_.measuredTo > 0.0 ? Angle::fromSi(tables_.measuredTo) : lastAngle();
  }
  Length leadIn() const noexcept { return Length::fromSi(tables_.leadIn); }

  /// Center of the section at an angle [rad]; for negative angles the start of the lead-in's axis.
  Eigen::Vector3d center_W(double angle) const noexcept;
  /// Point of the wall at an angle and a direction around the section [rad], 0 radially outward,
  /// pi/2 apical.
  Eigen::Vector3d wall_W(double angle, double direction) const noexcept;
  /// The measures of the section at an angle [rad].
  Section section(double angle) const;
  /// Point of the basilar membrane at an angle [rad]; `across` from 0 (inner edge) to 1 (outer
  /// edge).
  Eigen::Vector3d membrane_W(double angle, double across) const noexcept;

  const SectionTables& tables() const noexcept { return tables_; }

private:
  const LumenField& field() const noexcept;

  friend class SectionWall;
  friend class ScalaeAbove;

  SectionTables tables_;
  double lastAngle_ = 0.0;
  Entry entry_;
  // Spline coefficients over the angle; two more than sections.
  std::vector<double> centerRadius_, centerHeight_;
  std::vector<double> membraneInner_, membraneOuter_, membraneHeight_;
  std::vector<double> wallRadius_;  ///< Rows over the angle, each of `rowLength_` values around the
                                    ///< section.
  std::size_t rowLength_ = 0;       ///< Number of directions plus three that repeat the first.
  struct WallQuery;
  std::unique_ptr<WallQuery> wall_;     ///< Built when first asked for.
  std::unique_ptr<ScalaeAbove> above_;  ///< Built when first asked for.
};

}  // namespace perilymph::anatomy
