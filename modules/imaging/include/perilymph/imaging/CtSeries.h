// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// CT series on disk: DICOM folders, DICOMDIR and single files, NIfTI, NRRD.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "perilymph/ct/CtVolume.h"
#include "perilymph/foundation/Result.h"

namespace perilymph::imaging {

/// Files below a folder, and voxels of a volume (2 GB), up to which a series is read.
inline constexpr std::size_t maxCtFiles = 20'000, maxCtVoxels = 1'000'000'000;

/// How a reader reports its progress, on the calling thread, and is canceled.
struct ReadingHooks {
  std::function<void(double)> onProgress = {};  ///< Told the fraction done, 0 to 1.
  std::stop_token stop = {};                    ///< Ends the reading with an error.
};

/// One series as its headers describe it. Nothing here names the patient.
struct CtSeries {
  /// SeriesInstanceUID; "without-uid-1" and so on without one; empty for NIfTI and NRRD.
  std::string uid;
  /// SHA-256 of the UID, for logs and records; of NIfTI and NRRD that of the voxels' bytes, once
  /// they are read.
  std::string key;
  std::string format;                     ///< "DICOM", "NIfTI" or "NRRD".
  std::string modality, scanner, kernel;  ///< Empty where unknown.
  std::array<int, 3> size{};              ///< Voxels along a row, along a column, slices.
  /// Distance between columns, rows and slice planes [mm]; 0 where unknown.
  Eigen::Vector3d spacing_mm = Eigen::Vector3d::Zero();
  std::vector<Sentence> warnings;  ///< Sentences.
  Sentence obstacle;               ///< Why it cannot be read, one sentence; empty if it can.
  double score = 0.0;              ///< How well it suits the measurement of a cochlea, 0 to 100.
};

/// Why the values of a series are no Hounsfield units, one of its warnings; empty where its files state no reason.
Sentence grayValueNote(const CtSeries& series);

struct ListedFiles;

struct CtSeriesList {
  std::vector<CtSeries> series;  ///< The best score first.
  std::size_t otherFiles = 0;    ///< Files that are no images of a known format.
  std::filesystem::path path;    ///< What was listed.
  /// Files and headers of the series, so that they are read without listing the path again.
  std::shared_ptr<const ListedFiles> files = nullptr;
};

/// Lists the series in a folder, a DICOMDIR or a single file, without reading voxels.
///
/// Refuses a path without any series, and more files than maxCtFiles.
Result<CtSeriesList> findSeries(const std::filesystem::path& path, const ReadingHooks& hooks = {});

/// A small gray picture of a series' middle slice, rows from the top.
struct CtThumbnail {
  std::string uid;  ///< The series' UID.
  int width = 0, height = 0;
  std::vector<std::uint8_t> gray;
};

/// Pictures of the series of a listed DICOM folder, at most `edge` pixels wide and high, for those that can
/// be read. Takes the time of a slice for each.
std::vector<CtThumbnail> readThumbnails(const CtSeriesList& list, int edge,
                                        const ReadingHooks& hooks = {});

/// A volume, and the series it was read from with every warning.
struct LoadedCt {
  ct::CtVolume volume;
  CtSeries series;
};

/// Reads a series. Positions come from the slices' own positions and orientations alone; a tilted
/// gantry's volume is resampled to right angles, which its provenance notes.
///
/// @param uid  The series' UID; empty for the one with the best score.
///
/// Returns an error for a series that has no trustworthy geometry (ct::stackSlices), is no CT, is
/// cut off, encrypted or too large, and a canceled reading. Takes seconds; not real-time safe.
Result<LoadedCt> readCt(const std::filesystem::path& path, const std::string& uid = {},
                        const ReadingHooks& hooks = {});

/// Reads a series of a list, as above; the path is not listed again.
Result<LoadedCt> readCt(const CtSeriesList& list, const std::string& uid = {},
                        const ReadingHooks& hooks = {});

}  // namespace perilymph::imaging
