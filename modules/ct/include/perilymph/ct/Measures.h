// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Measures A, B and H of the patient's cochlea from a temporal-bone CT, each with its error.

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/ct/CtVolume.h"
#include "perilymph/ct/Marks.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::ct {

/// Warnings about the measures. Each has a name and a sentence.
enum class Flag {
  coarseVoxels,       ///< A voxel is longer than those the fit was tested with.
  airInCochlea,       ///< The lumen is filled with air, as in a dried specimen.
  mirrored,           ///< The spiral's handedness contradicts the side.
  outsidePopulation,  ///< A or B is more than two standard deviations from the population mean.
  poorFit,            ///< The model explains the voxels near the wall poorly.
  sectionsDisagree,   ///< Half-maximum walls and fitted ones differ.
  roundWindowUnsure,  ///< The round window was not found; 0 degrees is estimated from the spiral.
  clipped,            ///< Part of the cochlea is outside the volume or was not measured.
  landmarkContradicted,  ///< The voxels contradict a landmark that a person placed.
  fewTurns,              ///< Fewer turns of the lumen were seen than nearly all cochleae have.
  cysticApex,            ///< The middle turn has no modiolus: it is one cavity.
  apexNotJudged,         ///< The modiolus of the middle turn cannot be told from its absence.
  wallWithoutContrast,   ///< A part of the basal turn has no contrast between lumen and wall.
  metal,                 ///< Metal lies in or beside the cochlea.
  unusualProportions,    ///< B does not fit A, or H is not a patient's.
  secondCochlea,         ///< The search found two cochleae and chose one.
  landmarksDisagree,  ///< A, B or H between landmarks placed by hand differs from the fitted one.
  seriesInDoubt,  ///< The files of the CT contradict themselves, or something of them is missing.
};

/// Name of a flag as in files: "air_in_cochlea".
const char* nameOf(Flag flag);
/// One sentence with the meaning and the recommended action.
Sentence sentenceOf(Flag flag);
/// All flags, for help texts.
std::vector<Flag> allFlags();

/// A measure with the standard deviations of its error, by source. Values of A, B and H are given to 0.01 mm.
struct Measure {
  double value = 0.0;
  double statistical = 0.0;  ///< Due to noise, voxels and blur.
  double model = 0.0;        ///< Due to the limits of the fitted shape.
  double definition = 0.0;  ///< Due to the position of 0 degrees, the round window's center; of the
                            ///< duct length also due to the choice of its formula.

  double sd() const;                         ///< Square root of the sum of squares.
  std::array<double, 2> interval95() const;  ///< value -+ 1.96 sd.
};

/// A length in a sentence, to 0.01 mm: "8.70".
std::string millimetersOf(double value_mm);

/// Result of a measurement. Lengths in mm, positions and directions in P (LPS).
struct CochleaMeasures {
  /// Diameters of the bony lumen's outer wall (half maximum) through the axis: A from 0 to 180
  /// degrees, B from 90 to 270, with 0 at the round window's center.
  Measure a, b;
  /// Along the axis, from the lowest floor to the highest roof of the lumen.
  Measure h;
  /// Organ-of-Corti length by the elliptic-circular approximation of A and B, which assumes a
  /// spiral of full length: empty with a flag that denies it, see noFullSpiral().
  std::optional<Measure> cdlOc;
  double turnsSeen = 0.0;  ///< From 0 degrees to where the lumen ends, or to the fitted apex.

  Eigen::Vector3d axis_P;  ///< Modiolar axis, from the base to the apex, unit.
  /// Angle between the axis and that of the best-fitting spiral motion of the half-maximum wall,
  /// found without the shape prior [deg]; the two definitions differ by 4 to 12 degrees.
  double kinematicTilt_deg = 0.0;
  double axisError_deg = 0.0;     ///< Standard deviation of its tilt.
  Eigen::Vector3d center_P;       ///< On the axis, at the height of the round window's center.
  Eigen::Vector3d roundWindow_P;  ///< The round window's center, on the outer wall.
  /// Axes of the cochlear frame W in P, as columns: x toward the round window, z along the axis.
  /// Determinant -1 for a left ear, whose W is mirrored.
  Eigen::Matrix3d axes_PW = Eigen::Matrix3d::Identity();

  /// Frame W of the mean anatomy in P: z along the axis of its sections (5.3 degrees from axis_P), x
  /// toward the round window's center. Determinant -1 for a left ear.
  Eigen::Matrix3d anatomyAxes_PW = Eigen::Matrix3d::Identity();
  Eigen::Vector3d anatomyOrigin_P = Eigen::Vector3d::Zero();  ///< [mm]

  anatomy::Side side = anatomy::Side::right;  ///< From the handedness of the spiral.
  double handednessMargin = 0.0;  ///< Misfit of the best mirror image minus that of the fit.

  double boneLevel = 0.0, lumenLevel = 0.0;         ///< Intensities.
  double blurInPlane_mm = 0.0, blurAxial_mm = 0.0;  ///< Standard deviations of the PSF.
  double misfit = 0.0;         ///< Fraction of the voxels near the wall that is not explained, 0 to
                               ///< 1.
  double sectionRms_mm = 0.0;  ///< Distance of the half-maximum wall in mid-modiolar sections from
                               ///< the fit.

  /// Points of the lumen's wall: rings 4 degrees apart, from the spiral's 0 degrees on.
  std::vector<Eigen::Vector3d> wall_P;
  std::size_t wallPointsPerRing = 0;
  std::vector<std::array<int, 3>> wallTriangles;  ///< Triangles between these points.
  std::vector<Flag> flags;
  std::optional<Eigen::Vector3d> otherCochlea_P;  ///< In the other ear's, if the search found it.
  CtProvenance provenance;
  Marks marksByHand;  ///< Landmarks that a person placed or corrected; the fit was steered by them.

  bool has(Flag flag) const;
  /// The flag for which the formulas and the model of 2.5 turns do not apply; empty: they do.
  std::optional<Flag> noFullSpiral() const;
  /// Position in P [mm] of a point of the anatomy built from these measures, in its frame W [m].
  Eigen::Vector3d fromAnatomy(const Eigen::Vector3d& point_W) const
  {
    return anatomyOrigin_P + 1e3 * (anatomyAxes_PW * point_W);
  }
};

/// Where a cochlea may lie, for a fit to start from; an error of a millimeter or 20 degrees does not matter.
struct CochleaStart {
  Eigen::Vector3d roundWindow_P, center_P;  ///< The center is on the axis, at the window's height.
  Eigen::Vector3d apex_P;                   ///< On the axis.
  anatomy::Side side = anatomy::Side::right;
};

struct MeasureRequest {
  std::optional<Eigen::Vector3d> click_P;  ///< Any point in the cochlea; empty: search the volume.
  /// Landmarks that a person placed or corrected: soft constraints, never ground truth. Standard
  /// deviations are 0.5 mm for round window, modiolus and the apex' place across the axis, 0.3 mm
  /// for points of the wall (src/MarkConstraint.cpp).
  Marks marks;
  /// If there are any, the fit starts from these places and nothing is searched.
  std::vector<CochleaStart> starts;
  /// Side of the ear: a search takes the cochlea that winds so; otherwise for comparison.
  std::optional<anatomy::Side> side;
  /// Receives the completed fraction, 0 to 1, on the calling thread.
  std::function<void(double)> onProgress;
  std::stop_token stop;  ///< Ends the measurement early, with an error.
};

/// Finds the cochlea, fits the anatomy to the voxels and measures it. Deterministic; takes seconds.
/// Not real-time safe.
///
/// Refuses with a message: a volume without a cochlea, voxels over 1 mm, a cochlea so far from the
/// population that A, B and H do not apply (malformation, ossification), metal that hides the wall,
/// and a canceled search. Padding is not used: `unmeasured` voxels, and regions of one intensity at
/// the border of the volume.
Result<CochleaMeasures> measureCochlea(const CtVolume& volume, const MeasureRequest& request);

/// The same for both ears of a volume, the right one first; click, landmarks and side of the request
/// are not used. Refuses with a message if not both are found.
Result<std::array<CochleaMeasures, 2>> measureBothCochleae(const CtVolume& volume,
                                                           const MeasureRequest& request);

}  // namespace perilymph::ct
