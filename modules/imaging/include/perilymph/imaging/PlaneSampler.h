// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Pictures of a CT in any plane.

#include <cstdint>
#include <memory>
#include <span>

#include "perilymph/ct/CtVolume.h"
#include "perilymph/ct/ViewPlane.h"

namespace perilymph::imaging {

/// Which intensities are shown: black below center - width / 2, white above center + width / 2.
struct GrayWindow {
  double center = 700.0, width = 4000.0;

  bool operator==(const GrayWindow&) const = default;
};

/// Windows for Hounsfield units; cone-beam scanners have gray values of their own.
inline constexpr GrayWindow boneWindow{700.0, 4000.0}, softWindow{40.0, 400.0};
/// The window from the 1st to the 99th percentile of a volume's voxels, for any gray values.
GrayWindow wholeWindow(const ct::CtVolume& volume);

/// How several layers of a thick plane become one picture.
enum class Projection { mean, maximum };

/// A picture to be sampled.
struct PlanePicture {
  ct::ViewPlane plane;
  int width = 0, height = 0;  ///< Pixels.
  double pixel_mm = 0.1;
  GrayWindow window;
  double thickness_mm = 0.0;  ///< Thickness of a slab about the plane; 0: a single layer.
  Projection projection = Projection::mean;
};

/// Samples pictures of one volume by trilinear interpolation. Not thread-safe.
class PlaneSampler {
public:
  explicit PlaneSampler(std::shared_ptr<const ct::CtVolume> volume);
  ~PlaneSampler();
  PlaneSampler(const PlaneSampler&) = delete;
  PlaneSampler& operator=(const PlaneSampler&) = delete;

  const ct::CtVolume& volume() const noexcept { return *volume_; }

  /// Gray values of a picture, row by row from the top, 0 outside the volume; valid until the next
  /// call. Refuses nothing: sizes below 1 give an empty picture.
  std::span<const std::uint8_t> sample(const PlanePicture& picture);

private:
  struct Pipeline;
  std::shared_ptr<const ct::CtVolume> volume_;
  std::unique_ptr<Pipeline> pipeline_;
};

}  // namespace perilymph::imaging
