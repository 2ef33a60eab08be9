// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFile.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <utility>

#include "../SeriesScore.h"
#include "perilymph/foundation/Sha256.h"

namespace perilymph::imaging {

std::optional<Result<VolumeFile>> readVolumeHeader(const std::filesystem::path& file)
{
  std::string name = file.filename().string();
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return readNiftiHeader(file);
  if (name.ends_with(".nrrd")) return readNrrdHeader(file);
  return std::nullopt;
}

Result<Done> checkVolumeSize(const std::filesystem::path& file, const std::array<double, 3>& size)
{
  double voxels = 1.0;
  for (const double along : size) {
    if (!(along >= 2.0 && along <= 65'535.0) || along != std::floor(along))
      return Error{file.string() +
                   " holds no volume: each of its sizes must be 2 to 65535. Export it again."};
    voxels *= along;
  }
  if (voxels > static_cast<double>(maxCtVoxels))
    return Error{file.string() + " has " + std::to_string(std::lround(voxels / 1e6)) +
                 " million voxels; at most " + std::to_string(maxCtVoxels / 1'000'000) +
                 " million are read. Export the region of the temporal bone."};
  return Done{};
}

CtSeries describeVolume(const VolumeFile& volume)
{
  CtSeries series;
  series.format = volume.format;
  series.size = volume.size;
  series.spacing_mm = volume.lps_PI.topLeftCorner<3, 3>().colwise().norm().transpose();
  addSizeWarnings(series);
  series.score = scoreOf(series, false);
  return series;
}

Result<LoadedCt> readVolumeFile(const std::filesystem::path& file, const VolumeFile& volume,
                                const ReadingHooks& hooks)
{
  std::size_t count = 1;
  for (const int along : volume.size) count *= static_cast<std::size_t>(along);
  const std::size_t size = count * bytesOf(volume.type);
  const auto bytes = volume.packedFrom > 0 ? readPackedBytes(file, volume.packedFrom, size, hooks)
                                           : readBytes(file, volume.firstByte, size, hooks);
  if (!bytes) return bytes.error();
  auto voxels = toVoxels(*bytes, volume.type, volume.isBigEndian, volume.slope, volume.intercept);
  if (!voxels) return Error{file.string() + ": " + voxels.error().message};
  CtSeries series = describeVolume(volume);
  // Without a UID, what the file holds is its fingerprint.
  Sha256 hash;
  hash.add(std::string_view(*bytes));
  series.key = hash.hex();
  auto made = ct::CtVolume::make(volume.size, volume.lps_PI, *std::move(voxels),
                                 {series.key, "", volume.format, {}});
  if (!made) return Error{file.string() + ": " + made.error().message};
  return LoadedCt{*std::move(made), std::move(series)};
}

}  // namespace perilymph::imaging
