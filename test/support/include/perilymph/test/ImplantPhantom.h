// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Implanted temporal bones with known truth: the anatomy of a phantom (CtPhantom.h), an array that the
// engine inserted into its lower scala, and a CT before and after the surgery in two poses of the head.
//
// Seeds: 1 to 200 are for development, whatever is tuned; 5000 and above are for evaluation, and each of
// these is used once.

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "perilymph/ct/CtVolume.h"
#include "perilymph/ct/Measures.h"
#include "perilymph/electrode/ArrayDesign.h"
#include "perilymph/test/CtPhantom.h"

namespace perilymph::test {

/// The scanner of the CT after surgery.
struct ImplantScan {
  Eigen::Vector3d spacing_mm{0.2, 0.2, 0.2};
  PhantomScan preoperative;       ///< The scanner of the CT before surgery.
  double detector_mm = 0.2;       ///< Aperture of a detector element, at the ear.
  double focalSpot_mm = 0.15;     ///< Width of the focal spot's image at the ear, glare of the
                                  ///< detector included.
  double sliceProfile_mm = 0.2;   ///< Width of the slice, a rectangle.
  double photons = 1.0e5;         ///< Incident on one detector element in one view.
  double electronicNoise = 10.0;  ///< Standard deviation, in detected photons.
  double scatterFraction =
      0.3;                   ///< Scattered part of what is detected behind the head, 0.2 to 0.6.
  double motion_mm = 0.0;    ///< Amplitude of the head's motion during the scan, 0 to 0.3.
  bool isBoneKernel = true;  ///< Ramp with overshoot; else a soft (Hann) one.
  bool isClipped = true;     ///< Intensities end at 3071.
  bool hasMetalCorrection = false;  ///< Metal traces are replaced in the projections.
};

/// Voxels of 0.125, 0.2 and 0.3 mm, and of 0.4 x 0.4 x 0.6 mm.
ImplantScan fineImplantScan();
ImplantScan coneBeamImplantScan();
ImplantScan highResolutionImplantScan();
ImplantScan clinicalImplantScan();

/// The array and how it lies.
struct ImplantCondition {
  std::string array = "flex28";      ///< Shipped name.
  std::optional<bool> isRight = {};  ///< The ear; empty: either.
  double insertedFraction = 1.0;     ///< Intended depth over the array's greatest; 0.2 to 1.
  int contactsOutside = 0;           ///< The intended depth is so small that these stay outside.
  bool isFolded = false;             ///< The last 4 to 6 mm are doubled back.
  /// From this angle on the array lies in the upper scala; it must reach it.
  std::optional<double> translocationAngle_deg = {};
  bool hasOldLead = false;  ///< The lead of an earlier implant lies in view.
};

/// The true place of a contact.
struct TrueContact {
  int number = 0;              ///< 1 at the tip.
  Eigen::Vector3d position_P;  ///< Centroid of its platinum, in the CT after surgery [mm].
  Eigen::Vector3d onCourse_P;  ///< The point of the array's center line at the contact's middle.
  double angle_deg = 0.0;  ///< From the round window about the phantom's axis, full turns included.
  bool isInside = false;   ///< Past the plane of the round window.
  bool isAbove = false;    ///< Above the partition, in the upper scala.
};

/// What is true of a phantom, in P of the CT after surgery. LPS mm.
struct ImplantTruth {
  std::vector<TrueContact> contacts;  ///< The most apical first along the array.
  std::vector<Eigen::Vector3d>
      course_P;  ///< Center line from the tip to the array's end, 0.1 mm apart.
  Eigen::Vector3d tip_P;
  double tipAngle_deg = 0.0;
  double angularInsertionDepth_deg = 0.0;  ///< Largest angle of a contact inside.
  double insertedLength_mm = 0.0;  ///< Length of the array past the plane of the round window.
  int contactsInside = 0;
  bool isFolded = false;
  double foldAngle_deg = 0.0;              ///< Angle of its turning point; 0 without.
  std::vector<Eigen::Vector3d> oldLead_P;  ///< Course of an earlier implant's lead, 0.1 mm apart.
  std::optional<double>
      translocation_deg;  ///< Angle at which the center line passes the partition.
  // The cochlea, measured on its geometry.
  double a = 0.0, b = 0.0, h = 0.0;
  bool isRight = true;
  Eigen::Vector3d axis_P, roundWindow_P, inside_P;
  Eigen::Matrix4d pose_PW =
      Eigen::Matrix4d::Identity();  ///< The phantom's own frame, see CtPhantom.
};

struct ImplantPhantom {
  CtPhantom preoperative;
  ct::CtVolume postoperative;
  Eigen::Matrix4d post_from_pre;  ///< Rigid: a point of the head before, in P after surgery.
  ImplantTruth truth;
  electrode::ArrayDesign array;
};

/// Builds the implanted phantom of a seed: the same on all machines of one kind. An insertion takes some
/// seconds; that of the same seed, array and condition is kept for further scans of the program.
///
/// @throws std::runtime_error if the array is unknown or its insertion fails.
ImplantPhantom makeImplantPhantom(std::uint64_t seed, const ImplantScan& scan,
                                  const ImplantCondition& condition = {});

/// A real ear with an array added to its CT in projections.
struct ImplantedEar {
  ct::CtVolume postoperative;
  Eigen::Matrix4d post_from_pre;  ///< Rigid: a point of the CT before, in P after surgery.
  ImplantTruth truth;             ///< Its pose, angles and cochlea are those of the measures.
  electrode::ArrayDesign array;
};

/// Adds an array to an ear: the engine inserts it into the mean scala tympani with the ear's A, B and H, at its
/// measured pose; the ear's CT is projected with the metal and reconstructed, in another pose of the head.
///
/// @param before  The ear's CT [HU]; bone and air cells are assumed beyond it.
/// @throws std::runtime_error for folds and translocations, and as makeImplantPhantom() does.
ImplantedEar implantInto(const ct::CtVolume& before, const ct::CochleaMeasures& ear,
                         std::uint64_t seed, const ImplantScan& scan,
                         const ImplantCondition& condition = {});

}  // namespace perilymph::test
