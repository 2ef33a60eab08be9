// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// CT data: voxels and their position in the patient. Independent of file formats.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::ct {

/// Intensity of a voxel that was not measured, such as padding or a corner that a tilt left empty:
/// neither air nor fluid, and no part of any fit.
inline constexpr std::int16_t unmeasured = -32768;

/// Value of an unmeasured voxel where no such mark exists (pictures, files, messages,
/// resampling): air [HU]. Other voxels are themselves.
constexpr std::int16_t asAir(std::int16_t voxel) noexcept
{
  constexpr std::int16_t air_HU = -1024;
  return voxel == unmeasured ? air_HU : voxel;
}

/// Origin of a volume. Never contains a patient's name, number or date of birth.
struct CtProvenance {
  std::string seriesKey;                ///< Fingerprint of the series, empty if unknown.
  std::string scanner;                  ///< Maker and model, empty if unknown.
  std::string source;                   ///< Kind of input: "DICOM", "NIfTI", "NRRD", "phantom".
  std::vector<std::string> notes = {};  ///< What was done to the voxels, as sentences.
  /// Its files state something twice and not alike, or something of them is missing; the notes say what.
  bool isInDoubt = false;
  std::optional<anatomy::Side> side = {};  ///< The ear's, as the files state it.
};

/// Voxels of 16 bits on a regular grid. Frame P is the patient's, LPS in mm, as in DICOM: x toward
/// the patient's left, y posterior, z superior. Frame I is the voxel index (i, j, k) with voxel
/// centers at integers. The grid may be oblique and may be left-handed, as in the file.
class CtVolume {
public:
  /// @param size    Voxels along i, j, k; i runs fastest.
  /// @param lps_PI  Index to LPS [mm]; last row 0 0 0 1.
  /// @param voxels  Intensities: Hounsfield units, or gray values of a cone-beam scanner.
  ///
  /// Refuses sizes below 2, a voxel count that does not match, and a singular or non-finite matrix.
  static Result<CtVolume> make(const std::array<int, 3>& size, const Eigen::Matrix4d& lps_PI,
                               std::vector<std::int16_t> voxels, CtProvenance provenance = {});

  const std::array<int, 3>& size() const noexcept { return size_; }
  const Eigen::Matrix4d& lpsFromIndex() const noexcept { return lps_PI_; }
  const CtProvenance& provenance() const noexcept { return provenance_; }

  /// Distance between voxel centers along i, j, k [mm].
  Eigen::Vector3d spacing_mm() const;
  /// The center of the volume in P [mm].
  Eigen::Vector3d center_P() const;

  Eigen::Vector3d toLps(const Eigen::Vector3d& index) const { return axes_ * index + origin_; }
  Eigen::Vector3d toIndex(const Eigen::Vector3d& point_P) const
  {
    return inverse_ * (point_P - origin_);
  }
  /// True if all eight voxels of a trilinear interpolation are in the volume.
  bool contains(const Eigen::Vector3d& point_P) const;

  /// All voxels, i fastest, then j.
  std::span<const std::int16_t> voxels() const noexcept { return voxels_; }
  std::int16_t voxel(int i, int j, int k) const
  {
    return voxels_[(static_cast<std::size_t>(k) * static_cast<std::size_t>(size_[1]) +
                    static_cast<std::size_t>(j)) *
                       static_cast<std::size_t>(size_[0]) +
                   static_cast<std::size_t>(i)];
  }

  /// Voxels that were not measured.
  std::size_t unmeasuredCount() const noexcept;

  /// Intensity at a point in P [mm], trilinear; empty outside the volume and beside unmeasured
  /// voxels.
  std::optional<double> sample(const Eigen::Vector3d& point_P) const;

  /// The part of the volume within `radius_mm` of a point along every index axis. Refuses points
  /// outside the volume.
  Result<CtVolume> crop(const Eigen::Vector3d& center_P, double radius_mm) const;

private:
  CtVolume() = default;

  std::array<int, 3> size_{};
  Eigen::Matrix4d lps_PI_ = Eigen::Matrix4d::Identity();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity(), inverse_ = Eigen::Matrix3d::Identity();
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
  std::vector<std::int16_t> voxels_;
  CtProvenance provenance_;
};

}  // namespace perilymph::ct
