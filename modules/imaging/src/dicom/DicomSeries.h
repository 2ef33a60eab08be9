// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// Series of DICOM files: which files belong together, and what stands against reading them.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "DicomFiles.h"
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
  /// Those of the summary's warnings that say that something stated is not so, or not there.
  std::vector<Sentence> doubts;
};

/// Number of files of which a claim is true.
template <class Claim>
std::size_t countOf(const std::vector<DicomHeader>& headers, Claim claim)
{
  return static_cast<std::size_t>(std::count_if(headers.begin(), headers.end(), claim));
}

/// CtSeries::key of a series by its UID.
std::string seriesKeyOf(const std::string& uid);

/// Files of one series together, each series described and judged; the best score first.
std::vector<DicomSeries> seriesOf(DicomFiles files);

}  // namespace perilymph::imaging
