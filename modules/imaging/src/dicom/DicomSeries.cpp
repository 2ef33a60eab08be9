// SPDX-License-Identifier: BSD-3-Clause
#include "DicomSeries.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

#include "../SeriesScore.h"
#include "perilymph/foundation/Sha256.h"

namespace perilymph::imaging {
namespace {

constexpr double maxSpacingChange = 1e-4;  // of the first slice's

std::string inMm(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.4g mm", value);
  return text;
}

std::string of(std::size_t count, std::size_t all)
{
  return std::to_string(count) + " of " + std::to_string(all);
}

template <class Claim>
std::size_t countOf(const std::vector<DicomHeader>& headers, Claim claim)
{
  return static_cast<std::size_t>(std::count_if(headers.begin(), headers.end(), claim));
}

/// Files of which nothing can be read; empty where there are none.
std::string deflatedObstacle(const DicomSeries& series)
{
  const auto isDeflated = [](const DicomHeader& header) {
    return header.coding == PixelCoding::deflated;
  };
  const std::size_t deflated = countOf(series.headers, isDeflated);
  if (deflated == 0) return {};
  return of(deflated, series.headers.size()) +
         " files are compressed as a whole (transfer syntax 1.2.840.10008.1.2.1.99, deflated), "
         "which this "
         "program does not read. Export the series uncompressed, or convert it with gdcmconv "
         "--raw.";
}

std::string cutObstacle(const DicomSeries& series)
{
  const auto isCut = [](const DicomHeader& header) { return header.isTruncated; };
  const std::size_t cut = countOf(series.headers, isCut);
  if (cut == 0) return {};
  return of(cut, series.headers.size()) +
         " files are cut off: they end before their voxels do. Copy the series "
         "again.";
}

/// What kind of image it is not; empty for a CT.
std::string kindObstacle(const DicomSeries& series)
{
  const DicomHeader& first = series.headers.front();
  // Secondary capture in all its classes.
  if (first.sopClass.rfind("1.2.840.10008.5.1.4.1.1.7", 0) == 0)
    return "It is a secondary capture, a picture of a screen, without a place in the patient. "
           "Choose a series of original images.";
  // Of a file that ends the parser, nothing else is known.
  if (first.modality.empty() && first.isTruncated) return cutObstacle(series);
  if (first.modality != "CT")
    return "It is of the modality " + (first.modality.empty() ? "(none)" : first.modality) +
           ", not CT. Choose a CT series.";
  if (series.slices.empty() && !first.frames.empty())
    return "It is a scout (localizer), a projection and no slices. Choose a series of slices.";
  const auto isColored = [](const DicomHeader& header) {
    return header.hasPixels &&
           (header.samples != 1 || header.photometric.rfind("MONOCHROME", 0) != 0);
  };
  if (countOf(series.headers, isColored) > 0)
    return "Its images are in color, as of a picture or a fusion, and hold no Hounsfield units. "
           "Choose a series of original images.";
  return {};
}

/// Whether every voxel is there and can be decoded.
std::string fileObstacle(const DicomSeries& series)
{
  const std::vector<DicomHeader>& headers = series.headers;
  const std::size_t all = headers.size();
  const auto isIncomplete = [](const DicomHeader& header) {
    return !header.hasPixels || header.frames.empty() || !header.frames.front().pose.position_P;
  };
  const auto isLocked = [&](const DicomHeader& header) {
    return header.isEncrypted && isIncomplete(header);
  };
  if (const std::size_t locked = countOf(headers, isLocked); locked > 0)
    return of(locked, all) + " files are encrypted. Export the series again without encryption.";
  if (std::string cut = cutObstacle(series); !cut.empty()) return cut;
  const auto isEmpty = [](const DicomHeader& header) {
    return !header.hasPixels || header.frames.empty();
  };
  if (const std::size_t empty = countOf(headers, isEmpty); empty > 0)
    return of(empty, all) + " files hold no image. Export the series again.";
  for (const DicomHeader& header : headers)
    if (header.coding == PixelCoding::unknown)
      return "Its voxels are stored in a way this program cannot decode (transfer syntax " +
             (header.transferSyntax.empty() ? "missing" : header.transferSyntax) +
             "). Export the series uncompressed, or convert it with gdcmconv --raw.";
  return {};
}

/// Whether all slices have one size, spacing and kernel.
std::string sizeObstacle(const DicomSeries& series)
{
  const DicomHeader& first = series.headers[series.slices.front().header];
  const auto spacing = first.frames[series.slices.front().frame].pixelSpacing_mm;
  for (const SliceSource& slice : series.slices) {
    const DicomHeader& header = series.headers[slice.header];
    if (header.rows != first.rows || header.columns != first.columns)
      return "Its slices are of several sizes, " + std::to_string(first.columns) + " x " +
             std::to_string(first.rows) + " and " + std::to_string(header.columns) + " x " +
             std::to_string(header.rows) + " voxels. Export each size as a series of its own.";
    if (header.kernel != first.kernel)
      return "Its slices are of several reconstruction kernels, " + first.kernel + " and " +
             header.kernel + ". Export each reconstruction as a series of its own.";
    const auto& own = header.frames[slice.frame].pixelSpacing_mm;
    if (!own)
      return "Its slices have no pixel spacing, so no length can be measured in them. Export the "
             "series again as original images.";
    if (((*own - *spacing).cwiseAbs().array() > maxSpacingChange * spacing->array()).any())
      return "Its slices have several pixel spacings, " + inMm((*spacing)[0]) + " and " +
             inMm((*own)[0]) + ". Export each as a series of its own.";
  }
  const double voxels =
      static_cast<double>(first.rows) * first.columns * static_cast<double>(series.slices.size());
  if (voxels > static_cast<double>(maxCtVoxels))
    return "It has " + std::to_string(std::lround(voxels / 1e6)) + " million voxels; at most " +
           std::to_string(maxCtVoxels / 1'000'000) +
           " million are read. Export the region of the temporal bone.";
  return {};
}

void setUp(DicomSeries& series)
{
  std::size_t scouts = 0;
  for (std::size_t h = 0; h < series.headers.size(); ++h)
    for (std::size_t f = 0; f < series.headers[h].frames.size(); ++f) {
      if (series.headers[h].frames[f].isLocalizer)
        ++scouts;
      else
        series.slices.push_back({h, f});
    }
  if (scouts > 0 && !series.slices.empty())
    series.summary.warnings.push_back(std::to_string(scouts) + " scout images were left out.");
}

void stackUp(DicomSeries& series)
{
  CtSeries& summary = series.summary;
  std::vector<ct::SlicePose> poses;
  for (const SliceSource& slice : series.slices)
    poses.push_back(series.headers[slice.header].frames[slice.frame].pose);
  auto stack = ct::stackSlices(poses);
  if (!stack) {
    summary.obstacle = stack.error().message;
    return;
  }
  summary.size[2] = static_cast<int>(stack->places.size());
  summary.spacing_mm.z() = stack->planeDistance_mm();
  if (const std::size_t more = poses.size() - stack->places.size(); more > 0)
    summary.warnings.push_back(std::to_string(more) +
                               " slices lie at the position of another; they are dropped if their "
                               "voxels are the same, and the series is refused if not.");
  if (stack->tilt_deg > maxTilt_deg) {
    char tilt[16];
    std::snprintf(tilt, sizeof tilt, "%.1f", stack->tilt_deg);
    summary.warnings.push_back(std::string("The gantry is tilted by ") + tilt +
                               " degrees; the volume is resampled to right angles.");
  }
  series.stack = std::move(*stack);
}

void describe(DicomSeries& series)
{
  setUp(series);
  CtSeries& summary = series.summary;
  const DicomHeader& first = series.headers.front();
  summary.key = [&] {
    Sha256 hash;
    hash.add(std::string_view(summary.uid));
    return hash.hex();
  }();
  summary.format = "DICOM";
  summary.modality = first.modality;
  summary.scanner = first.scanner;
  summary.kernel = first.kernel;
  summary.size = {first.columns, first.rows,
                  static_cast<int>(std::max(series.slices.size(), series.headers.size()))};
  if (!first.frames.empty() && first.frames.front().pixelSpacing_mm)
    summary.spacing_mm.head<2>() = *first.frames.front().pixelSpacing_mm;
  for (const auto check : {deflatedObstacle, kindObstacle, fileObstacle}) {
    summary.obstacle = check(series);
    if (!summary.obstacle.empty()) return;
  }
  const DicomHeader& slice = series.headers[series.slices.front().header];
  summary.size[0] = slice.columns;
  summary.size[1] = slice.rows;
  if (slice.frames.front().pixelSpacing_mm)
    summary.spacing_mm.head<2>() = *slice.frames.front().pixelSpacing_mm;
  summary.obstacle = sizeObstacle(series);
  if (!summary.obstacle.empty()) return;
  stackUp(series);
  if (!summary.obstacle.empty()) return;
  const auto isLossy = [](const DicomHeader& header) { return header.isLossy; };
  if (countOf(series.headers, isLossy) > 0)
    summary.warnings.push_back("Its images were compressed with loss; fine edges may be gone.");
  const auto isDerived = [](const DicomHeader& header) { return header.isDerived; };
  const bool isAnyDerived = countOf(series.headers, isDerived) > 0;
  if (isAnyDerived)
    summary.warnings.push_back(
        "Its images were computed from others, as reformatted planes are; original ones are "
        "sharper.");
  addSizeWarnings(summary);
  summary.score = scoreOf(summary, isAnyDerived);
}

}  // namespace

std::vector<DicomSeries> seriesOf(std::vector<DicomHeader> headers)
{
  std::map<std::string, DicomSeries> byUid;
  std::map<std::filesystem::path, std::string> unnamed;
  for (DicomHeader& header : headers) {
    std::string uid = header.seriesUid;
    if (uid.empty()) {
      std::string& name = unnamed[header.file.parent_path()];
      if (name.empty()) name = "without-uid-" + std::to_string(unnamed.size());
      uid = name;
    }
    DicomSeries& series = byUid[uid];
    series.summary.uid = uid;
    series.headers.push_back(std::move(header));
  }
  std::vector<DicomSeries> all;
  for (auto& [uid, series] : byUid) {
    describe(series);
    all.push_back(std::move(series));
  }
  std::stable_sort(all.begin(), all.end(), [](const DicomSeries& a, const DicomSeries& b) {
    return a.summary.score > b.summary.score;
  });
  return all;
}

}  // namespace perilymph::imaging
