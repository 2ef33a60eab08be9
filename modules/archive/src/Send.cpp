// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/archive/Send.h"

#include <dcmtk/dcmnet/diutil.h>

#include <algorithm>
#include <set>
#include <system_error>

#include "Association.h"
#include "Rows.h"
#include "StoreRequest.h"
#include "perilymph/archive/Query.h"

namespace perilymph::archive {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t maxObjectBytes = std::uintmax_t{128} << 20;
constexpr const char* manufacturer = "Perilymph";  // of all that this program writes

Result<void> load(DcmFileFormat& file, const fs::path& place)
{
  std::error_code failed;
  if (!fs::is_regular_file(place, failed) || fs::file_size(place, failed) > maxObjectBytes)
    return Error{"%1 is no file of at most 128 MiB. Give a DICOM file that this program wrote.",
                 place};
  if (const OFCondition read = file.loadFile(place.c_str()); read.bad())
    return Error{"%1 is no DICOM file: %2. Give one that this program wrote.", place, read.text()};
  DcmDataset& data = *file.getDataset();
  const std::string kind = textIn(data, DCM_SOPClassUID);
  const bool isResult = kind == UID_SecondaryCaptureImageStorage ||
                        std::any_of(documentClasses().begin(), documentClasses().end(),
                                    [&kind](const char* each) { return kind == each; });
  if (!isResult || textIn(data, DCM_Manufacturer) != manufacturer)
    return Error{
        "%1 is no result of this program: only those are sent. Give a report that it wrote "
        "as DICOM.",
        place};
  for (const auto& [tag, what] : {std::pair{DCM_StudyInstanceUID, Sentence{"study"}},
                                  {DCM_SeriesInstanceUID, Sentence{"series"}},
                                  {DCM_SOPInstanceUID, Sentence{"object"}}})
    if (const auto checked = checkUid(textIn(data, tag), what); !checked)
      return Error{"%1: %2", place, checked.error().message};
  return {};
}

/// Whether the server has the study, of the same patient. No error says who that is.
Result<void> checkStudy(const Server& server, DcmDataset& data, const fs::path& place,
                        const Exchange& exchange)
{
  const std::string study = textIn(data, DCM_StudyInstanceUID);
  DcmDataset keys;
  setLevel(keys, "STUDY", study);
  for (const DcmTagKey& tag : {DCM_PatientID, DCM_PatientBirthDate})
    keys.putAndInsertString(tag, "");
  std::size_t studies = 0;
  bool isSame = true;
  const auto asked = queryRows(server, keys, 2, exchange, [&](DcmItem& row) {
    ++studies;
    const std::string birth = textIn(row, DCM_PatientBirthDate);
    const std::string own = textIn(data, DCM_PatientBirthDate);
    isSame = isSame && textIn(row, DCM_StudyInstanceUID) == study &&
             textIn(row, DCM_PatientID) == textIn(data, DCM_PatientID) &&
             (birth.empty() || own.empty() || birth == own);
  });
  if (!asked) return asked.error();
  if (studies == 0)
    return Error{
        "%1 has no study %2, of which %3 is a part. Write the report with the CT of the "
        "archive's study, or send it to the archive that has it.",
        server.name, study, place};
  if (studies > 1 || !isSame)
    return Error{
        "%1 has the study %2 under another patient number or birth date than %3 states: "
        "nothing was sent. Compare both before you send it again.",
        server.name, study, place};
  return {};
}

/// The first number that no series of the study has.
Result<std::string> freeSeriesNumber(const Server& server, DcmDataset& data,
                                     const Exchange& exchange)
{
  const auto found = findSeries(server, textIn(data, DCM_StudyInstanceUID), exchange);
  if (!found) return found.error();
  std::set<std::string> taken;
  for (const FoundSeries& series : found->rows) {
    // the same object is sent a second time under its number
    if (series.uid == textIn(data, DCM_SeriesInstanceUID)) return series.number;
    taken.insert(series.number);
  }
  std::string number = textIn(data, DCM_SeriesNumber);
  for (int next = 1; number.empty() || taken.contains(number); ++next)
    number = std::to_string(next);
  return number;
}

}  // namespace

Result<SentObject> sendObject(const Server& server, const fs::path& place, const Exchange& exchange)
{
  DcmFileFormat file;
  if (const auto loaded = load(file, place); !loaded) return loaded.error();
  DcmDataset& data = *file.getDataset();
  if (const auto checked = checkStudy(server, data, place, exchange); !checked)
    return checked.error();
  const auto number = freeSeriesNumber(server, data, exchange);
  if (!number) return number.error();
  data.putAndInsertString(DCM_SeriesNumber, number->c_str());

  const std::string kind = textIn(data, DCM_SOPClassUID);
  auto opened = Association::open(server, {{kind.c_str(), plainSyntaxes()}}, exchange);
  if (!opened) return opened.error();
  Association& association = **opened;
  const auto context =
      association.contextOf(kind.c_str(), Sentence{"storage of this kind of object"});
  if (!context) return context.error();
  T_DIMSE_C_StoreRQ request{};
  request.MessageID = association.nextMessage();
  copyText(kind, request.AffectedSOPClassUID);
  copyText(textIn(data, DCM_SOPInstanceUID), request.AffectedSOPInstanceUID);
  request.DataSetType = DIMSE_DATASET_PRESENT;
  T_DIMSE_C_StoreRSP response{};
  DcmDataset* detail = nullptr;
  if (exchange.onStore) exchange.onStore();
  const OFCondition stored =
      DIMSE_storeUser(association.get(), *context, &request, nullptr, &data, nullptr, nullptr,
                      DIMSE_NONBLOCKING, association.answerSeconds(), &response, &detail);
  delete detail;
  if (stored.bad() && exchange.stop.stop_requested())
    return Error{
        "The sending to %1 was canceled while an object was under way: it may have stored it. Look "
        "there before you send it again.",
        server.name};
  if (stored.bad()) return association.failure(stored);
  const DIC_US status = response.DimseStatus;
  if (status != STATUS_Success && !DICOM_WARNING_STATUS(status))
    return association.refusal(status, DU_cstoreStatusString(status));
  association.release();
  SentObject sent{textIn(data, DCM_StudyInstanceUID),
                  textIn(data, DCM_SeriesInstanceUID),
                  textIn(data, DCM_SOPInstanceUID),
                  *number,
                  {}};
  if (status != STATUS_Success)
    sent.warning = Sentence{"The server stored it with a change of its own: %1.",
                            std::string(DU_cstoreStatusString(status))};
  return sent;
}

}  // namespace perilymph::archive
