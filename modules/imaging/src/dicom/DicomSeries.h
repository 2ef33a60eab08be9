// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Series of DICOM files: which files belong together, and what stands against reading them.

#include <optional>
#include <vector>

#include "DicomHeader.h"
#include "perilymph/imaging/CtSeries.h"

namespace perilymph::imaging {

/// Maximum tilt of the gantry whose shear the matrix holds; above, slices are resampled [deg].
inline constexpr double maxTilt_deg = 0.2;

/// Where a slice's voxels are.
struct SliceSource {
  std::size_t header = 0;  ///< Index of the file.
  std::size_t frame = 0;   ///< Within the file.
};

struct DicomSeries {
  CtSeries summary;
  std::vector<DicomHeader> headers;
  std::vector<SliceSource> slices;      ///< Without scouts.
  std::optional<ct::SliceStack> stack;  ///< Its places index `slices`; none where refused.
};

/// Files of one series together, each series described and judged; the best score first.
std::vector<DicomSeries> seriesOf(std::vector<DicomHeader> headers);

}  // namespace perilymph::imaging
