// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFile.h"

#include <algorithm>
#include <initializer_list>
#include <system_error>
#include <utility>

#include "../SeriesScore.h"
#include "../dicom/DicomFiles.h"
#include "../statements/VolumePairs.h"
#include "HeaderText.h"
#include "perilymph/foundation/Sha256.h"

namespace perilymph::imaging {
namespace {

// At once: a multiple of every type's size.
constexpr std::size_t chunkBytes = std::size_t{1} << 22;
// Voxels that may be stored before their span is known, 64 MB; and that are looked at for it.
constexpr std::size_t smallVolume = std::size_t{1} << 25, seenForSpan = std::size_t{1} << 26;

Result<ByteSource> openVoxels(const VolumeFile& volume)
{
  auto source = ByteSource::open(volume.voxelFile, volume.from, volume.packing);
  if (!source) return source;
  if (const auto done = source->skip(volume.skipped); !done) return done.error();
  return source;
}

Error wrongLength(const std::filesystem::path& file, const VolumeFile& volume, std::size_t stated,
                  const Sentence& found)
{
  return Error{*disagreement(file.string(), *volume.bytes, Sentence{"%1 bytes", stated}, found)};
}

bool endsWithOneOf(const std::string& name, std::initializer_list<const char*> endings)
{
  return std::any_of(endings.begin(), endings.end(),
                     [&name](const char* ending) { return name.ends_with(ending); });
}

bool isVolumeName(const std::string& name)
{
  return endsWithOneOf(name, {".nii", ".nii.gz", ".nrrd", ".nhdr", ".mha", ".mhd"});
}

/// The volume of a folder that holds one and otherwise only files that are no DICOM by their names;
/// none for another folder. Refuses several.
std::optional<Result<VolumeFile>> volumeOfFolder(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> volumes;
  std::error_code failed;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failed)) {
    const std::string name = lowerCase(entry.path().filename().string());
    if (isVolumeName(name))
      volumes.push_back(entry.path());
    else if (!name.starts_with('.') &&
             !endsWithOneOf(name, {".raw", ".zraw", ".raw.gz", ".txt", ".md", ".json", ".csv",
                                   ".xml", ".pdf", ".png", ".jpg"}))
      return std::nullopt;
  }
  if (failed || volumes.empty()) return std::nullopt;
  if (volumes.size() == 1) return readVolumeHeader(volumes.front());
  std::sort(volumes.begin(), volumes.end());
  return Result<VolumeFile>(Error{"%1 holds %2 volumes, the first %3. Give one of these files.",
                                  folder, volumes.size(), volumes.front().filename()});
}

/// Fills up to `count` bytes; refuses less.
Result<void> readAll(ByteSource& source, char* to, std::size_t before, std::size_t count,
                     const std::filesystem::path& file, const VolumeFile& volume)
{
  std::size_t done = 0;
  while (done < count) {
    const auto got = source.read(to + done, count - done);
    if (!got) return got.error();
    if (*got == 0)
      return wrongLength(file, volume, voxelBytesOf(volume), Sentence{"%1 bytes", before + done});
    done += *got;
  }
  return {};
}

/// Refuses a large volume without contrast before there is memory for its voxels.
Result<void> checkSpan(const std::filesystem::path& file, const VolumeFile& volume,
                       const ReadingHooks& hooks)
{
  const std::size_t size = bytesOf(volume.coding.type);
  const std::size_t count = std::min(voxelBytesOf(volume) / size, seenForSpan) * size;
  auto source = openVoxels(volume);
  if (!source) return source.error();
  VoxelConverter seen(volume.coding);
  std::string chunk(chunkBytes, '\0');
  for (std::size_t at = 0; at < count && !seen.spansEnough() && seen.isFinite();) {
    if (hooks.stop.stop_requested()) return canceledReading();
    const std::size_t wanted = std::min(chunkBytes, count - at);
    if (const auto done = readAll(*source, chunk.data(), at, wanted, file, volume); !done)
      return done;
    seen.add(chunk.data(), wanted / size, nullptr);
    at += wanted;
  }
  const auto checked = seen.check();
  if (!checked && (!seen.isFinite() || !seen.spansEnough()))
    return Error{"%1: %2", file, checked.error().message};
  return {};
}

/// Refuses bytes behind the voxels.
Result<void> checkEnd(ByteSource& source, std::string& chunk, std::size_t stated,
                      const std::filesystem::path& file, const VolumeFile& volume)
{
  const auto more = source.read(chunk.data(), chunkBytes);
  if (!more) return more.error();
  if (*more == 0) return {};
  return wrongLength(file, volume, stated,
                     *more == chunkBytes ? Sentence{"more than %1 bytes", stated + *more}
                                         : Sentence{"%1 bytes", stated + *more});
}

}  // namespace

std::optional<Result<VolumeFile>> readVolumeHeader(const std::filesystem::path& file)
{
  std::error_code failed;
  if (std::filesystem::is_directory(file, failed)) return volumeOfFolder(file);
  const std::string name = lowerCase(file.filename().string());
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return readNiftiHeader(file);
  if (name.ends_with(".nrrd") || name.ends_with(".nhdr")) return readNrrdHeader(file);
  if (name.ends_with(".mha") || name.ends_with(".mhd")) return readMetaHeader(file);
  return std::nullopt;
}

std::size_t voxelBytesOf(const VolumeFile& volume)
{
  std::size_t bytes = bytesOf(volume.coding.type);
  for (const int along : volume.size) bytes *= static_cast<std::size_t>(along);
  return bytes;
}

Result<void> checkDataLength(const std::filesystem::path& file, const VolumeFile& volume)
{
  const auto source = ByteSource::open(volume.voxelFile, volume.from, volume.packing);
  if (!source) return source.error();
  const std::uintmax_t stated = voxelBytesOf(volume), there = source->fileBytes();
  if (source->isPacked()) {
    if (stated + volume.skipped <= maxInflation * there) return {};
    return wrongLength(file, volume, stated, Sentence{"at most %1 bytes", maxInflation * there});
  }
  const std::uintmax_t found = there - std::min<std::uintmax_t>(there, volume.skipped);
  if (found == stated) return {};
  return wrongLength(file, volume, stated, Sentence{"%1 bytes", found});
}

CtSeries describeVolume(const VolumeFile& volume)
{
  CtSeries series;
  series.format = volume.format;
  series.size = volume.size;
  series.spacing_mm = volume.lps_PI.topLeftCorner<3, 3>().colwise().norm().transpose();
  series.warnings = volume.warnings;
  addSizeWarnings(series);
  series.score = scoreOf(series, false);
  return series;
}

Result<LoadedCt> readVolumeFile(const std::filesystem::path& file, const VolumeFile& volume,
                                const ReadingHooks& hooks)
{
  const std::size_t size = bytesOf(volume.coding.type), stated = voxelBytesOf(volume);
  if (const auto done = checkDataLength(file, volume); !done) return done.error();
  if (stated / size > smallVolume)
    if (const auto done = checkSpan(file, volume, hooks); !done) return done.error();
  auto source = openVoxels(volume);
  if (!source) return source.error();
  std::vector<std::int16_t> voxels(stated / size);
  std::string chunk(chunkBytes, '\0');
  VoxelConverter converter(volume.coding);
  Sha256 hash;  // without a UID, what the file holds is its fingerprint
  for (std::size_t at = 0; at < stated;) {
    if (hooks.stop.stop_requested()) return canceledReading();
    const std::size_t wanted = std::min(chunkBytes, stated - at);
    if (const auto done = readAll(*source, chunk.data(), at, wanted, file, volume); !done)
      return done.error();
    hash.add(std::string_view(chunk.data(), wanted));
    converter.add(chunk.data(), wanted / size, voxels.data() + at / size);
    at += wanted;
    if (hooks.onProgress) hooks.onProgress(static_cast<double>(at) / static_cast<double>(stated));
  }
  if (const auto done = checkEnd(*source, chunk, stated, file, volume); !done) return done.error();
  if (const auto done = converter.check(); !done)
    return Error{"%1: %2", file, done.error().message};
  CtSeries series = describeVolume(volume);
  const std::size_t described = series.warnings.size();
  if (volume.grayRange)
    for (std::size_t end = 0; end < 2; ++end)
      if (const auto differs = disagreement(
              Sentence{"The file"}, meta::grayValues,
              end == 0 ? converter.smallest() : converter.largest(), (*volume.grayRange)[end],
              end == 0 ? Sentence{", the smallest,"} : Sentence{", the largest,"}))
        series.warnings.push_back(*differs);
  std::vector<std::string> doubts(volume.warnings.begin(), volume.warnings.end());
  doubts.insert(doubts.end(), series.warnings.begin() + static_cast<std::ptrdiff_t>(described),
                series.warnings.end());
  const bool isInDoubt = !doubts.empty();
  series.key = hash.hex();
  auto made = ct::CtVolume::make(volume.size, volume.lps_PI, std::move(voxels),
                                 {series.key, "", volume.format, std::move(doubts), isInDoubt});
  if (!made) return Error{"%1: %2", file, made.error().message};
  return LoadedCt{*std::move(made), std::move(series)};
}

}  // namespace perilymph::imaging
