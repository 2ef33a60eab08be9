// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/CtSeries.h"

#include <algorithm>
#include <exception>
#include <system_error>
#include <utility>

#include "dicom/DicomFiles.h"
#include "dicom/DicomSeries.h"
#include "dicom/DicomVoxels.h"
#include "dicom/Thumbnail.h"
#include "volume/VolumeFile.h"

namespace perilymph::imaging {

namespace fs = std::filesystem;

namespace {

constexpr double listingFraction = 0.2;  // of the time that reading takes

/// A part of the progress, mapped into the whole.
ReadingHooks part(const ReadingHooks& hooks, double from, double to)
{
  ReadingHooks mapped = hooks;
  if (hooks.onProgress)
    mapped.onProgress = [report = hooks.onProgress, from, to](double fraction) {
      report(from + (to - from) * fraction);
    };
  return mapped;
}

struct Listed {
  std::vector<DicomSeries> series;
  std::size_t others = 0;
};

Result<Done> checkExists(const fs::path& path)
{
  std::error_code failed;
  if (fs::is_directory(path, failed) || fs::is_regular_file(path, failed)) return Done{};
  return Error{path.string() + (fs::exists(path, failed)
                                    ? " is neither a file nor a folder. Give a folder of DICOM "
                                      "files, a DICOMDIR, a DICOM, NIfTI or NRRD file."
                                    : " does not exist. Check the path.")};
}

Result<Listed> listDicom(const fs::path& path, const ReadingHooks& hooks)
{
  auto files = listDicomFiles(path, hooks);
  if (!files) return files.error();
  Listed listed{seriesOf(std::move(files->headers)), files->others};
  if (listed.series.empty())
    return Error{path.string() +
                 " holds no DICOM image. Give a folder of DICOM files, a DICOMDIR, a DICOM, NIfTI "
                 "or NRRD file."};
  return listed;
}

Result<const DicomSeries*> choose(const Listed& listed, const fs::path& path,
                                  const std::string& uid)
{
  const auto& all = listed.series;
  if (!uid.empty()) {
    const auto found = std::find_if(all.begin(), all.end(), [&uid](const DicomSeries& series) {
      return series.summary.uid == uid;
    });
    if (found == all.end())
      return Error{path.string() + " holds no series " + uid + "; it holds " +
                   std::to_string(all.size()) + ". 'perilymph-cli ct info' lists them."};
    return &*found;
  }
  const auto found = std::find_if(all.begin(), all.end(), [](const DicomSeries& series) {
    return series.summary.obstacle.empty();
  });
  if (found != all.end()) return &*found;
  if (all.size() == 1) return &all.front();
  return Error{
      path.string() + " holds " + std::to_string(all.size()) +
      " series, and none of them can be read; of the first: " + all.front().summary.obstacle};
}

Result<LoadedCt> readDicom(const fs::path& path, const std::string& uid, const ReadingHooks& hooks)
{
  const auto listed = listDicom(path, part(hooks, 0.0, listingFraction));
  if (!listed) return listed.error();
  const auto chosen = choose(*listed, path, uid);
  if (!chosen) return chosen.error();
  const CtSeries& summary = (*chosen)->summary;
  if (!summary.obstacle.empty()) return Error{path.string() + ": " + summary.obstacle};
  auto volume = readVoxels(**chosen, part(hooks, listingFraction, 1.0));
  if (!volume) return Error{path.string() + ": " + volume.error().message};
  return LoadedCt{*std::move(volume), summary};
}

Error tooLarge(const fs::path& path)
{
  return Error{path.string() +
               " asks for more memory than there is. Export the region of the temporal bone."};
}

}  // namespace

Result<CtSeriesList> findSeries(const fs::path& path, const ReadingHooks& hooks)
{
  if (const auto there = checkExists(path); !there) return there.error();
  try {
    if (const auto volume = readVolumeHeader(path)) {
      if (!*volume) return volume->error();
      return CtSeriesList{{describeVolume(**volume)}, 0};
    }
    auto listed = listDicom(path, hooks);
    if (!listed) return listed.error();
    CtSeriesList list;
    list.otherFiles = listed->others;
    for (DicomSeries& series : listed->series) list.series.push_back(std::move(series.summary));
    return list;
  } catch (const std::bad_alloc&) {
    return tooLarge(path);
  }
}

std::vector<CtThumbnail> readThumbnails(const fs::path& path, int edge, const ReadingHooks& hooks)
{
  std::vector<CtThumbnail> pictures;
  try {
    if (!checkExists(path) || readVolumeHeader(path)) return pictures;
    const auto listed = listDicom(path, hooks);
    if (!listed) return pictures;
    for (const DicomSeries& series : listed->series) {
      if (hooks.isCanceled && hooks.isCanceled()) break;
      if (auto picture = thumbnailOf(series, edge, hooks.isCanceled))
        pictures.push_back(*std::move(picture));
    }
  } catch (const std::bad_alloc&) {
    return pictures;  // those that there was memory for
  }
  return pictures;
}

Result<LoadedCt> readCt(const fs::path& path, const std::string& uid, const ReadingHooks& hooks)
{
  if (const auto there = checkExists(path); !there) return there.error();
  try {
    if (const auto volume = readVolumeHeader(path)) {
      if (!*volume) return volume->error();
      if (!uid.empty())
        return Error{path.string() + " is one volume and holds no series " + uid +
                     ". Leave the series out."};
      return readVolumeFile(path, **volume, hooks);
    }
    return readDicom(path, uid, hooks);
  } catch (const std::bad_alloc&) {
    return tooLarge(path);
  }
}

}  // namespace perilymph::imaging
