// SPDX-License-Identifier: BSD-3-Clause
#include "ReceivedSeries.h"

#include <system_error>

#include "Rows.h"
#include "perilymph/foundation/Sha256.h"
#include "perilymph/foundation/Unfinished.h"

namespace perilymph::archive {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t nameDigits = 24;

struct Identity {
  std::string study, series, instance, patientId, birthDate;
};

/// The identity that a DICOM file states; nothing if it is none. Only the elements before the image
/// are parsed.
std::optional<Identity> identityIn(const fs::path& place)
{
  DcmFileFormat file;
  const OFCondition read =
      file.loadFileUntilTag(place.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength,
                            ERM_fileOnly, DcmTagKey(DCM_SeriesNumber));
  if (read.bad()) return std::nullopt;
  DcmDataset& data = *file.getDataset();
  return Identity{textIn(data, DCM_StudyInstanceUID), textIn(data, DCM_SeriesInstanceUID),
                  textIn(data, DCM_SOPInstanceUID), textIn(data, DCM_PatientID),
                  textIn(data, DCM_PatientBirthDate)};
}

}  // namespace

ReceivedSeries::ReceivedSeries(fs::path folder, SeriesAddress series,
                               std::set<std::string> expected)
    : folder_(std::move(folder)), series_(std::move(series)), expected_(std::move(expected))
{
  for (const std::string& uid : expected_) {
    std::error_code ignored;
    const fs::path place = placeOf(uid);
    if (!fs::is_regular_file(fs::symlink_status(place, ignored))) {
      missing_.insert(uid);
      continue;
    }
    if (patient_) continue;
    if (const auto found = identityIn(place)) patient_ = {found->patientId, found->birthDate};
  }
}

fs::path ReceivedSeries::placeOf(const std::string& instanceUid) const
{
  Sha256 hash;
  hash.add(instanceUid);
  return folder_ / (hash.hex().substr(0, nameDigits) + ".dcm");
}

fs::path ReceivedSeries::newPlace() const { return unfinishedPath(folder_ / "object.dcm"); }

std::optional<Sentence> ReceivedSeries::faultOf(const fs::path& place, std::string& instanceUid)
{
  const auto found = identityIn(place);
  if (!found) return Sentence{"The server sent an object that is no DICOM. Ask its administrator."};
  if (found->study != series_.studyUid || found->series != series_.seriesUid)
    return Sentence{
        "The server sent an object of another series, which was deleted. Ask its administrator."};
  if (!expected_.contains(found->instance))
    return Sentence{
        "The server sent an object that it had not listed, which was deleted. Fetch the series "
        "again."};
  const std::pair patient{found->patientId, found->birthDate};
  if (patient_ && *patient_ != patient)
    return Sentence{
        "The server sent objects of several patients under one series, and the last was deleted. "
        "Ask its administrator."};
  patient_ = patient;
  instanceUid = found->instance;
  return std::nullopt;
}

void ReceivedSeries::setUnwritable(const std::string& why)
{
  setObstacle(Sentence{"A file in %1 could not be written: %2. Free some space, and fetch again.",
                       folder_, why});
}

bool ReceivedSeries::take(const fs::path& place)
{
  std::error_code failed;
  std::string instanceUid;
  if (auto fault = faultOf(place, instanceUid)) {
    setObstacle(*std::move(fault));
    fs::remove(place, failed);
    return false;
  }
  fs::permissions(place, fs::perms::owner_read | fs::perms::owner_write, failed);
  fs::rename(place, placeOf(instanceUid), failed);
  if (failed) {
    setUnwritable(failed.message());
    fs::remove(place, failed);
    return false;
  }
  missing_.erase(instanceUid);
  return true;
}

}  // namespace perilymph::archive
