// SPDX-License-Identifier: BSD-3-Clause
#include "DicomVoxels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "../statements/Warnings.h"
#include "DicomFiles.h"
#include "DicomStatements.h"
#include "FrameDecoder.h"
#include "GrayScales.h"
#include "Rectification.h"

namespace perilymph::imaging {
namespace {

constexpr double maxClippedFraction = 1e-3;
constexpr int minSpan_HU = 100;  // as of volume files

/// Slices of a series, each decoded once if its file is asked for in a row.
class SliceReader {
public:
  SliceReader(const DicomSeries& series, const std::stop_token& stop) : series_(series), stop_(stop)
  {
  }

  /// The voxels of one slice; valid until the next call.
  Result<const std::int16_t*> read(const SliceSource& slice)
  {
    const DicomHeader& header = series_.headers[slice.header];
    if (current_ != slice.header) {
      auto frames = decodeFrames(header, stop_);
      if (!frames) return frames.error();
      clipped_ += frames->clipped;
      compareRange(header, frames->voxels);
      frames_ = *std::move(frames);
      current_ = slice.header;
    }
    const std::size_t perFrame =
        static_cast<std::size_t>(header.rows) * static_cast<std::size_t>(header.columns);
    return static_cast<const std::int16_t*>(frames_.voxels.data() + slice.frame * perFrame);
  }

  std::size_t clipped() const { return clipped_; }

  /// Sentences about smallest and largest gray values that files state and do not hold.
  std::vector<Sentence> doubts() const
  {
    std::vector<Sentence> sentences;
    for (const auto& doubt : {smallest_, largest_})
      if (doubt) sentences.push_back(*doubt);
    return sentences;
  }

private:
  /// Compares the range of a file of one frame with the stated one. Padding may be counted in it or not.
  void compareRange(const DicomHeader& header, const std::vector<std::int16_t>& voxels)
  {
    if ((!header.smallest && !header.largest) || header.frames.size() != 1) return;
    const DicomFrame& frame = header.frames.front();
    std::int16_t minimum = std::numeric_limits<std::int16_t>::max(), maximum = ct::unmeasured;
    for (const std::int16_t voxel : voxels) {
      maximum = std::max(maximum, voxel);
      minimum = std::min(minimum, voxel == ct::unmeasured ? minimum : voxel);
    }
    const auto compare = [&](const StatedTwice& pair, std::int16_t found,
                             const std::optional<double>& stated, std::optional<Sentence>& doubt) {
      const bool isPadding = stated && header.padding && *stated >= (*header.padding)[0] &&
                             *stated <= (*header.padding)[1];
      if (doubt || !stated || isPadding) return;
      doubt = disagreement(Sentence{"The series"}, pair, found,
                           std::round(frame.slope * *stated + frame.intercept),
                           Sentence{" in %1", nameOf(header)});
    };
    compare(dicomPairs::smallest, minimum, header.smallest, smallest_);
    compare(dicomPairs::largest, maximum, header.largest, largest_);
  }

  const DicomSeries& series_;
  const std::stop_token& stop_;
  std::optional<std::size_t> current_;
  DecodedFrames frames_;
  std::size_t clipped_ = 0;
  std::optional<Sentence> smallest_, largest_;
};

Error differing(std::size_t place, std::size_t count, std::size_t images)
{
  return Error{
      "%1 images that differ lie at the position of slice %2 of %3: the series holds several "
      "phases or reconstructions. Export each as a series of its own.",
      images, place + 1, count};
}

Result<void> checkSpan(const std::vector<std::int16_t>& voxels)
{
  int minimum = std::numeric_limits<std::int16_t>::max(), maximum = ct::unmeasured;
  for (const std::int16_t voxel : voxels) {
    if (voxel == ct::unmeasured) continue;
    minimum = std::min<int>(minimum, voxel);
    maximum = std::max<int>(maximum, voxel);
  }
  if (maximum - minimum >= minSpan_HU) return {};
  return Error{
      "Its intensities span less than 100, so they are no Hounsfield units: a mask, a label or a "
      "normalized volume. Export the CT itself."};
}

/// The sentence about two slices with the same voxels, which noise makes impossible: a copy stands for one that is
/// lost. Slices of one intensity hold nothing.
std::optional<Sentence> copiedSlice(const Grid& grid)
{
  const auto count = static_cast<std::size_t>(grid.size[2]);
  const std::size_t perSlice = grid.voxels.size() / count;
  std::unordered_map<std::size_t, std::size_t> known;
  for (std::size_t k = 0; k < count; ++k) {
    const auto slice = std::span(grid.voxels).subspan(k * perSlice, perSlice);
    if (std::ranges::all_of(slice, [&slice](std::int16_t voxel) { return voxel == slice[0]; }))
      continue;
    const std::string_view bytes(reinterpret_cast<const char*>(slice.data()), slice.size_bytes());
    const auto [same, isNew] = known.emplace(std::hash<std::string_view>()(bytes), k);
    if (!isNew && std::ranges::equal(
                      slice, std::span(grid.voxels).subspan(same->second * perSlice, perSlice)))
      return Sentence(warnings::copied, {std::to_string(same->second + 1), std::to_string(k + 1),
                                         std::to_string(count)});
  }
  return std::nullopt;
}

/// The grid of a series; adds what is to be said of its voxels.
Result<Grid> assemble(const DicomSeries& series, const ReadingHooks& hooks,
                      std::vector<Sentence>& warnings)
{
  const ct::SliceStack& stack = *series.stack;
  const std::size_t count = stack.places.size();
  Grid grid;
  grid.size = series.summary.size;
  const auto& spacing = series.summary.spacing_mm;
  grid.lps_PI.block<3, 1>(0, 0) = spacing.x() * stack.axes_P.col(0);
  grid.lps_PI.block<3, 1>(0, 1) = spacing.y() * stack.axes_P.col(1);
  grid.lps_PI.block<3, 1>(0, 2) = stack.step_P;
  grid.lps_PI.block<3, 1>(0, 3) = stack.origin_P;
  const std::size_t perSlice =
      static_cast<std::size_t>(grid.size[0]) * static_cast<std::size_t>(grid.size[1]);
  grid.voxels.resize(perSlice * count);
  SliceReader reader(series, hooks.stop);
  for (std::size_t k = 0; k < count; ++k) {
    if (hooks.stop.stop_requested()) return canceledReading();
    const auto slab = grid.voxels.begin() + static_cast<std::ptrdiff_t>(k * perSlice);
    const std::vector<std::size_t>& place = stack.places[k];
    for (std::size_t i = 0; i < place.size(); ++i) {
      const auto voxels = reader.read(series.slices[place[i]]);
      if (!voxels) return hooks.stop.stop_requested() ? canceledReading() : voxels.error();
      if (i == 0)
        std::copy(*voxels, *voxels + perSlice, slab);
      else if (!std::equal(*voxels, *voxels + perSlice, slab))
        return differing(k, count, place.size());
    }
    if (hooks.onProgress) hooks.onProgress(static_cast<double>(k + 1) / static_cast<double>(count));
  }
  const double clipped =
      static_cast<double>(reader.clipped()) / static_cast<double>(grid.voxels.size());
  if (clipped > maxClippedFraction)
    return Error{
        "%1 voxels lie beyond -32768 to 32767, which 16 bits hold. Export the series as Hounsfield "
        "units.",
        reader.clipped()};
  if (const auto done = checkSpan(grid.voxels); !done) return done.error();
  auto scales = checkScales(series, grid);
  if (!scales) return scales.error();
  warnings = *std::move(scales);
  for (const Sentence& doubt : reader.doubts()) warnings.push_back(doubt);
  if (auto copied = copiedSlice(grid)) warnings.push_back(*std::move(copied));
  return grid;
}

/// The side that every image states that states one.
std::optional<anatomy::Side> statedSide(const DicomSeries& series)
{
  std::string letters;
  for (const DicomHeader& header : series.headers)
    for (const std::string& stated : {header.laterality, header.imageLaterality})
      if (!stated.empty() && letters.find(stated) == std::string::npos) letters += stated;
  if (letters == "R") return anatomy::Side::right;
  if (letters == "L") return anatomy::Side::left;
  return std::nullopt;
}

}  // namespace

Result<ReadVolume> readVoxels(const DicomSeries& series, const ReadingHooks& hooks)
{
  std::vector<Sentence> warnings;
  auto grid = assemble(series, hooks, warnings);
  if (!grid) return grid.error();
  ct::CtProvenance provenance{series.summary.key, series.summary.scanner, "DICOM", {}};
  if (series.stack->tilt_deg > maxTilt_deg) {
    grid = rectified(*grid);
    if (!grid) return grid.error();
    char note[96];
    std::snprintf(note, sizeof note,
                  "Resampled to right angles: the gantry was tilted by %.1f degrees.",
                  series.stack->tilt_deg);
    provenance.notes.emplace_back(note);
  }
  std::vector<std::string>& notes = provenance.notes;
  notes.insert(notes.end(), series.doubts.begin(), series.doubts.end());
  notes.insert(notes.end(), warnings.begin(), warnings.end());
  provenance.side = statedSide(series);
  provenance.isInDoubt = !series.doubts.empty() || !warnings.empty();
  auto volume =
      ct::CtVolume::make(grid->size, grid->lps_PI, std::move(grid->voxels), std::move(provenance));
  if (!volume) return volume.error();
  return ReadVolume{*std::move(volume), std::move(warnings)};
}

}  // namespace perilymph::imaging
