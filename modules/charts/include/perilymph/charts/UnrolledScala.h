// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The scala tympani unrolled: angle along, width across, with the array and its contacts.

#include <vector>

#include "perilymph/charts/ArrayInScala.h"
#include "perilymph/charts/ChartStyle.h"
#include "perilymph/figures/Drawing.h"

namespace perilymph::charts {

class PlotSheet;

/// A contact that was found in a CT.
struct FoundPlace {
  int number = 0;  ///< 1 at the tip.
  double angle_deg = 0.0, low_deg = 0.0,
         high_deg = 0.0;     ///< From the round window, with its 95 % interval.
  double modiolus_mm = 0.0;  ///< From the inner wall to the contact.
  bool isPlaced = true;      ///< By its own brightness or by hand; else by the array's spacings.
  bool isAbove = false;      ///< More likely above the basilar membrane than below.
};
/// What a plan expected of a contact: the band of its angle.
struct PlannedPlace {
  double low_deg = 0.0, median_deg = 0.0, high_deg = 0.0;
};

/// The scala seen along the modiolus and unrolled: angle from the round window [degrees] to the
/// right, radial distance from the section's center [mm] upward, outer wall at the top. The scales
/// differ. The lumen is drawn with its maximum width, so an array on the floor may touch where it
/// appears free.
///
/// The normal force of the wall on each millimeter of the array is a bar at the wall; forces of
/// floor and roof are rings on the array. Where the cochlear partition is torn, the lumen is red; what is
/// above it, in the scala vestibuli, is outlined in red.
class UnrolledScala {
public:
  /// Length of a bar [px] for this force per length.
  static constexpr double bar_px = 18.0, bar_mN_mm = 50.0;

  explicit UnrolledScala(const anatomy::ScalaTympani& scala, ChartStyle style = {});

  /// Draws the view at a size in pixels. The range, 0 to 540 degrees, is extended by quarter turns
  /// with the tip.
  figures::Drawing draw(const ArrayInScala& now, double width, double height) const;

  /// The same as a standalone picture, with a line that explains the axes.
  figures::Drawing drawPage(const ArrayInScala& now, double width, double height) const;

  /// Draws contacts that were found in a CT, by number, with the intervals of their angles, over what a
  /// plan expected: a bar for each contact at the modiolus, and the band of the most apical one across
  /// the scala. An empty plan draws none. A contact that the spacings place is hollow; one more likely above
  /// the basilar membrane is a diamond.
  ///
  /// @param planned  Of the contacts, the most apical one first.
  figures::Drawing drawFound(const std::vector<FoundPlace>& found,
                             const std::vector<PlannedPlace>& planned, double width,
                             double height) const;

private:
  struct Width {
    double angle_deg, inner_mm, outer_mm;
  };
  Width widthAt(double angle_deg) const;
  void drawLumen(PlotSheet& sheet, double last_deg) const;

  ChartStyle style_;
  double lastAngle_deg_, leadIn_deg_;
  double inner_mm_ = 0.0, outer_mm_ = 0.0;  ///< Maximum extent.
  std::vector<Width> widths_;               ///< At equal angles, from the opening on.
};

}  // namespace perilymph::charts
