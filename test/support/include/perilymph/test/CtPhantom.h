// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Synthetic temporal bones with known ground truth, from shapes that the fit of modules/ct cannot
// represent: sections are kidneys and not the mean's outlines, radii, heights and axial positions
// are warped individually, and the cochlea is surrounded by the other structures of a temporal
// bone.

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "perilymph/ct/CtVolume.h"
#include "perilymph/ct/Marks.h"

namespace perilymph::test {

/// Imaging parameters of a phantom.
struct PhantomScan {
  Eigen::Vector3d spacing_mm{0.3, 0.3, 0.3};
  double blurInPlane_mm = 0.25, blurAxial_mm = 0.25;  ///< Standard deviations.
  double noise = 120.0;                               ///< Standard deviation of a voxel.
  bool isAirFilled = false;                           ///< The lumen is filled with air, as in a
                                                      ///< specimen.
};

/// The scanners of the table: cone-beam 0.15 mm, high-resolution 0.3 mm, clinical 0.45 x 0.6 mm.
PhantomScan coneBeamScan();
PhantomScan highResolutionScan();
PhantomScan clinicalScan();

/// A phantom's volume and its ground truth, measured on its geometry before any blur. LPS mm.
struct CtPhantom {
  ct::CtVolume volume;
  double a = 0.0, b = 0.0, h = 0.0;
  bool isRight = true;
  Eigen::Vector3d axis_P, roundWindow_P;
  ct::Marks marks;           ///< Where a perfect observer places the landmarks.
  Eigen::Vector3d inside_P;  ///< In the lumen of the basal turn: position of a click.
  Eigen::Matrix4d pose_PW =
      Eigen::Matrix4d::Identity();  ///< The phantom's own frame in P; mirrored
                                    ///< for a left ear.
};

/// Malformation, disease and surgery of a phantom, and its place.
struct PhantomCondition {
  std::optional<double> turns = {};  ///< Turns of the lumen; empty: individual, 2.3 to 2.6.
  bool isCystic = false;             ///< A cavity beyond the last turn (incomplete partition II).
  std::array<double, 2> ossified = {};  ///< Filled with bone from an angle to another [deg].
  bool hasImplant = false;        ///< A wire with contacts in the lower scala, to 400 degrees.
  bool isExtended = false;        ///< Intensities above 3071 are kept, as in an extended scale.
  bool hasRoomForArrays = false;  ///< The spiral lamina lies higher, so that the lower scala is as
                                  ///< high as that of the mean cochlea.
  std::optional<bool> isRight = {};              ///< The ear; empty: either.
  std::optional<Eigen::Vector3d> center_P = {};  ///< Center of a volume aligned with the patient.
};

/// Builds the phantom of a seed: the same on all machines of one kind. Takes a second.
CtPhantom makeCtPhantom(std::uint64_t seed, const PhantomScan& scan,
                        const PhantomCondition& condition = {});

/// Both ears of a head in one volume, in noisy soft tissue.
struct TwoEars {
  ct::CtVolume volume;
  CtPhantom right, left;
};
/// @param apart_mm  Distance of both ears; the volume is 19 mm wider.
TwoEars makeTwoEars(std::uint64_t seed, const PhantomScan& scan, double apart_mm);

/// The volume with what lies behind a plane replaced by one value, as a tilt leaves corners empty.
ct::CtVolume withEmptyCorner(const ct::CtVolume& volume, const Eigen::Vector3d& point_P,
                             const Eigen::Vector3d& normal_P, std::int16_t value);

/// The volume as a coarser scanner shows it, without that scanner's noise.
/// @param blur_mm  Standard deviation of the volume's own blur.
ct::CtVolume coarser(const ct::CtVolume& volume, const PhantomScan& scan, double blur_mm);

/// A click in the cochlea, displaced by a normal deviate of 0.5 mm along every axis.
Eigen::Vector3d jitteredClick(const CtPhantom& phantom, std::uint64_t seed);

}  // namespace perilymph::test
