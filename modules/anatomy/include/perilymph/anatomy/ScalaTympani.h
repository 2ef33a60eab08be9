#pragma once

// The scala tympani as tables over the angle from the round window: where the section's center is,
// and how far the wall is from it in every direction. Every anatomy becomes this, whatever its
// source.

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "perilymph/anatomy/Lumen.h"
#include "perilymph/foundation/Units.h"

namespace perilymph::anatomy {

class LumenField;

/// What a source of anatomy must deliver. Sections stand in half-planes through the modiolar axis,
/// at equal angles; the last one closes the apex.
struct SectionTables {
  std::string name;                  ///< For people: "published, 35.58 mm".
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
  double leadIn = 0.0;                 ///< Straight stretch before the first section [m].
  /// The angle up to which sections were measured [rad]; beyond it they go on by a trend. 0: all
  /// were.
  double measuredTo = 0.0;
};

/// One point of the tables, between them interpolated.
struct Section {
  double centerRadius;  ///< [m]
  double centerHeight;  ///< [m]
  double innerRadius;   ///< Distance of the innermost wall from the axis [m].
  double outerRadius;   ///< Distance of the outermost wall from the axis [m].
  double floorHeight;   ///< [m]
  double roofHeight;    ///< [m]
  double area;          ///< [m^2]
};

/// The lumen of a scala tympani in the cochlear frame W: z along the modiolus toward the apex,
/// angle zero at the center of the round window on the x axis, right ear.
///
/// Between the tables, uniform cubic B-splines: twice continuously differentiable in the angle and
/// around the section. The wall query reads a table of distances made from them (LumenField).
/// Before the round window the first section goes on straight, along the tangent of the center
/// line, for the length of the lead-in; there the opening is.
class ScalaTympani : public Lumen {
public:
  /// Builds the lumen. @throws std::invalid_argument if the tables do not fit each other.
  explicit ScalaTympani(SectionTables tables);
  ~ScalaTympani() override;

  const std::string& name() const noexcept { return tables_.name; }

  Entry entry() const noexcept override { return entry_; }
  LumenTrack startTrack() const noexcept override { return {}; }

  void nearestWall(std::span<const Eigen::Vector3d> points_W, std::span<const double> reach,
                   std::span<LumenTrack> tracks,
                   std::span<WallPoint> walls) const noexcept override;

  Angle lastAngle() const noexcept { return Angle::fromSi(lastAngle_); }
  /// Where measured sections end and a trend begins; the last angle if there is none.
  Angle measuredAngle() const noexcept
  {
    return tables_.measuredTo > 0.0 ? Angle::fromSi(tables_.measuredTo) : lastAngle();
  }
  Length leadIn() const noexcept { return Length::fromSi(tables_.leadIn); }

  /// Center of the section at an angle [rad]; negative angles give the start of the lead-in's axis.
  Eigen::Vector3d center_W(double angle) const noexcept;
  /// The wall at an angle and a direction around the section [rad], 0 radially outward, pi/2
  /// apical.
  Eigen::Vector3d wall_W(double angle, double direction) const noexcept;
  /// The measures of the section at an angle [rad].
  Section section(double angle) const;
  /// Inner (0) to outer (1) edge of the basilar membrane at an angle [rad].
  Eigen::Vector3d membrane_W(double angle, double across) const noexcept;

  const SectionTables& tables() const noexcept { return tables_; }

private:
  SectionTables tables_;
  double lastAngle_ = 0.0;
  Entry entry_;
  // Spline coefficients over the angle, two more than sections.
  std::vector<double> centerRadius_, centerHeight_;
  std::vector<double> membraneInner_, membraneOuter_, membraneHeight_;
  std::vector<double> wallRadius_;  ///< Rows over the angle of `rowLength_` around the section.
  std::size_t rowLength_ = 0;       ///< Directions and three that repeat the first.
  std::unique_ptr<const LumenField> field_;
};

}  // namespace perilymph::anatomy
