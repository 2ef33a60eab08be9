// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Ground truth of a real ear, from its label's surface in its published frame.

#include "perilymph/ct/Measures.h"
#include "perilymph/test/RealEars.h"

namespace perilymph::test {

/// Diameters of a label [mm]. A: sum of the marked round window's distance from the published axis
/// and that of the outermost label surface at 180 degrees. B: outermost label surface at 90 and 270
/// degrees. Rays start on the axis at heights from -1.3 to 1.5 mm (270: 1.0) about the marked
/// center; the surface is where the trilinear label passes 50 %.
struct LabelMeasures {
  double a, b;
};
LabelMeasures measureLabel(const RealEar& ear);

/// A plausible click: in the basal turn, about 1.7 mm beside the modiolus.
Eigen::Vector3d clickOf(const RealEar& ear);

/// Mean distance of a measured wall's points, from 20 to 720 degrees without the inner third, to
/// the nearest face between voxels inside and outside the label [mm].
double meanDistanceToLabel(const RealEar& ear, const ct::CochleaMeasures& found);

}  // namespace perilymph::test
