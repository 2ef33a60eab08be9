// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/imaging/CtSeries.h"

#include <algorithm>
#include <exception>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "dicom/DicomFiles.h"
#include "dicom/DicomSeries.h"
#include "dicom/DicomVoxels.h"
#include "dicom/Thumbnail.h"
#include "statements/Warnings.h"
#include "volume/VolumeFile.h"

namespace perilymph::imaging {

namespace fs = std::filesystem;

/// The series of a DICOM folder, or one volume in a file of its own.
struct ListedFiles {
  std::vector<DicomSeries> series;
  std::size_t others = 0;
  std::optional<VolumeFile> volume;
  std::shared_ptr<const UnpackedZip> unpacked;  ///< Where the files are, of a .zip.
};

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

Result<void> checkExists(const fs::path& path)
{
  std::error_code failed;
  if (fs::is_directory(path, failed) || fs::is_regular_file(path, failed)) return {};
  if (!fs::exists(path, failed)) return Error{"%1 does not exist. Check the path.", path};
  return Error{
      "%1 is neither a file nor a folder. Give a folder of DICOM files, a DICOMDIR, a DICOM, NIfTI "
      "or NRRD file.",
      path};
}

Result<ListedFiles> listFiles(const fs::path& path, const ReadingHooks& hooks)
{
  if (const auto there = checkExists(path); !there) return there.error();
  ListedFiles listed;
  if (auto volume = readVolumeHeader(path)) {
    if (!*volume) return volume->error();
    listed.volume = **std::move(volume);
    return listed;
  }
  auto files = listDicomFiles(path, hooks);
  if (!files) return files.error();
  listed.others = files->others;
  listed.unpacked = files->unpacked;
  listed.series = seriesOf(*std::move(files));
  if (listed.series.empty())
    return Error{
        "%1 holds no DICOM image. Give a folder of DICOM files, a DICOMDIR, a DICOM, NIfTI or NRRD "
        "file.",
        path};
  return listed;
}

Result<const DicomSeries*> choose(const ListedFiles& listed, const fs::path& path,
                                  const std::string& uid)
{
  const auto& all = listed.series;
  if (!uid.empty()) {
    const auto found = std::find_if(all.begin(), all.end(), [&uid](const DicomSeries& series) {
      return series.summary.uid == uid;
    });
    const auto isOneOf = [&uid](const DicomSeries& series) {
      return series.summary.uid.starts_with(uid + "#");
    };
    const auto parts = std::count_if(all.begin(), all.end(), isOneOf);
    if (found == all.end() && parts > 0)
      return Error{
          "%1 holds %2 series of the number %3, of several patients or studies. Choose one of "
          "them: %3#1 and so on.",
          path, parts, uid};
    if (found == all.end())
      return Error{"%1 holds no series %2; it holds %3. 'perilymph-cli ct info' lists them.", path,
                   uid, all.size()};
    return &*found;
  }
  const auto found = std::find_if(all.begin(), all.end(), [](const DicomSeries& series) {
    return series.summary.obstacle.empty();
  });
  if (found != all.end()) return &*found;
  if (all.size() == 1) return &all.front();
  return Error{"%1 holds %2 series, and none of them can be read; of the first: %3", path,
               all.size(), all.front().summary.obstacle};
}

Result<LoadedCt> readListed(const ListedFiles& listed, const fs::path& path, const std::string& uid,
                            const ReadingHooks& hooks)
{
  if (listed.volume) {
    if (!uid.empty())
      return Error{"%1 is one volume and holds no series %2. Leave the series out.", path, uid};
    return readVolumeFile(path, *listed.volume, hooks);
  }
  const auto chosen = choose(listed, path, uid);
  if (!chosen) return chosen.error();
  const CtSeries& summary = (*chosen)->summary;
  if (!summary.obstacle.empty()) return Error{"%1: %2", path, summary.obstacle};
  auto volume = readVoxels(**chosen, hooks);
  if (!volume) return Error{"%1: %2", path, volume.error().message};
  LoadedCt loaded{std::move(volume->volume), summary};
  loaded.series.warnings.insert(loaded.series.warnings.end(), volume->warnings.begin(),
                                volume->warnings.end());
  return loaded;
}

Error tooLarge(const fs::path& path)
{
  return Error{"%1 asks for more memory than there is. Export the region of the temporal bone.",
               path};
}

}  // namespace

Sentence grayValueNote(const CtSeries& series)
{
  for (const Sentence& warning : series.warnings)
    if (warning.phrase() == warnings::grayValues.english()) return warning;
  return {};
}

Result<CtSeriesList> findSeries(const fs::path& path, const ReadingHooks& hooks)
{
  try {
    auto listed = listFiles(path, hooks);
    if (!listed) return listed.error();
    CtSeriesList list;
    list.path = path;
    if (listed->volume) list.series.push_back(describeVolume(*listed->volume));
    for (const DicomSeries& series : listed->series) list.series.push_back(series.summary);
    list.otherFiles = listed->others;
    list.files = std::make_shared<const ListedFiles>(*std::move(listed));
    return list;
  } catch (const std::bad_alloc&) {
    return tooLarge(path);
  }
}

std::string acquisitionDay(const CtSeriesList& list, const std::string& uid)
{
  std::string first;
  if (list.files == nullptr) return first;
  for (const DicomSeries& series : list.files->series)
    for (const DicomHeader& header : series.headers)
      if (series.summary.uid == uid && !header.acquired.empty() &&
          (first.empty() || header.acquired < first))
        first = header.acquired;
  return first;
}

std::vector<CtThumbnail> readThumbnails(const CtSeriesList& list, int edge,
                                        const ReadingHooks& hooks)
{
  std::vector<CtThumbnail> pictures;
  if (!list.files) return pictures;
  try {
    for (const DicomSeries& series : list.files->series) {
      if (hooks.stop.stop_requested()) break;
      if (auto picture = thumbnailOf(series, edge, hooks.stop))
        pictures.push_back(*std::move(picture));
    }
  } catch (const std::bad_alloc&) {
    return pictures;  // those that there was memory for
  }
  return pictures;
}

Result<LoadedCt> readCt(const fs::path& path, const std::string& uid, const ReadingHooks& hooks)
{
  try {
    const auto listed = listFiles(path, part(hooks, 0.0, listingFraction));
    if (!listed) return listed.error();
    // a volume in a file of its own takes no time to list
    return readListed(*listed, path, uid,
                      listed->volume ? hooks : part(hooks, listingFraction, 1.0));
  } catch (const std::bad_alloc&) {
    return tooLarge(path);
  }
}

Result<LoadedCt> readCt(const CtSeriesList& list, const std::string& uid, const ReadingHooks& hooks)
{
  if (!list.files) return readCt(list.path, uid, hooks);
  try {
    return readListed(*list.files, list.path, uid, hooks);
  } catch (const std::bad_alloc&) {
    return tooLarge(list.path);
  }
}

}  // namespace perilymph::imaging
