// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/archive/Query.h"

#include <dcmtk/dcmnet/diutil.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <initializer_list>
#include <utility>

#include "Association.h"
#include "Rows.h"
#include "perilymph/foundation/Utf8.h"

namespace perilymph::archive {

namespace {

constexpr std::size_t maxText = 64;      // of LO and PN components, PS3.5
constexpr std::size_t maxModality = 16;  // of CS

struct Reading {
  Association& association;
  T_ASC_PresentationContextID context;
  std::size_t maxRows;
  const std::function<void(DcmItem&)>& take;
  std::size_t count = 0;
  bool isCut = false;
};

void onRow(void* data, T_DIMSE_C_FindRQ* request, int, T_DIMSE_C_FindRSP*, DcmDataset* row)
{
  Reading& reading = *static_cast<Reading*>(data);
  if (row == nullptr || reading.isCut) return;
  if (reading.count == reading.maxRows) {
    reading.isCut = true;
    DIMSE_sendCancelRequest(reading.association.get(), reading.context, request->MessageID);
    reading.association.watch().ending = Ending::canceled;
    return;
  }
  ++reading.count;
  row->convertToUTF8();  // what has an unknown character set stays as it is
  reading.take(*row);
}

bool isDate(const std::string& text)
{
  const bool hasDigits = text.size() == 8 && std::all_of(text.begin(), text.end(), [](char c) {
                           return c >= '0' && c <= '9';
                         });
  if (!hasDigits) return false;
  const auto number = [&text](std::size_t at, std::size_t size) {
    int value = 0;
    std::from_chars(text.data() + at, text.data() + at + size, value);
    return value;
  };
  return std::chrono::year_month_day(std::chrono::year(number(0, 4)),
                                     std::chrono::month(static_cast<unsigned>(number(4, 2))),
                                     std::chrono::day(static_cast<unsigned>(number(6, 2))))
      .ok();
}

Result<void> checkText(const std::string& text, const Sentence& what)
{
  const bool isPlain = std::none_of(text.begin(), text.end(), [](char letter) {
    return static_cast<unsigned char>(letter) < ' ' || letter == '\x7f' || letter == '\\';
  });
  if (isPlain && text.size() <= maxText && text == validUtf8(text)) return {};
  // the text itself may name a patient
  return Error{
      "The %1 of a query has at most 64 bytes of UTF-8 without \\ and control characters. "
      "Shorten it with *.",
      what};
}

Result<void> check(const StudyQuery& query)
{
  for (const auto& [text, what] : {std::pair{&query.patientId, Sentence{"patient number"}},
                                   {&query.patientName, Sentence{"patient name"}}})
    if (const auto checked = checkText(*text, what); !checked) return checked;
  for (const std::string* date : {&query.birthDate, &query.from, &query.until})
    if (!date->empty() && !isDate(*date))
      return Error{"A date of a query is no date of the calendar. Write YYYYMMDD, as in 20260131."};
  if (!query.from.empty() && !query.until.empty() && query.from > query.until)
    return Error{"The study dates of the query end before they begin. Exchange them."};
  const bool isCode = std::all_of(query.modality.begin(), query.modality.end(), [](char letter) {
    return (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9');
  });
  if (!isCode || query.modality.size() > maxModality)
    return Error{"'%1' is no modality. Write its code, as in CT.", query.modality};
  for (const std::string* text : {&query.patientId, &query.patientName, &query.birthDate,
                                  &query.from, &query.until, &query.modality})
    if (!text->empty()) return {};
  return Error{
      "The query has no condition and would list the whole archive. Give a patient number, "
      "a name, a date or a modality."};
}

void setText(DcmDataset& keys, const DcmTagKey& tag, const std::string& text)
{
  keys.putAndInsertString(tag, text.c_str());
}

bool isAscii(const std::string& text)
{
  return std::all_of(text.begin(), text.end(), [](char letter) { return letter >= 0; });
}

}  // namespace

std::string textIn(DcmItem& item, const DcmTagKey& tag)
{
  OFString found;
  if (item.findAndGetOFStringArray(tag, found).bad()) return {};
  std::string text(found.c_str(), found.size());
  const auto isPadding = [](char letter) { return letter == ' ' || letter == '\0'; };
  while (!text.empty() && isPadding(text.back())) text.pop_back();
  text.erase(0, std::min(text.find_first_not_of(' '), text.size()));
  return validUtf8(text);
}

Result<void> checkUid(const std::string& uid, const Sentence& what)
{
  const bool isUid =
      !uid.empty() && uid.size() <= 64 && uid.find_first_not_of("0123456789.") == std::string::npos;
  if (isUid) return {};
  return Error{
      "'%1' is no UID of a %2: digits and dots, at most 64. Take it from 'perilymph-cli "
      "archive find'.",
      uid, what};
}

void setLevel(DcmDataset& keys, const char* level, const std::string& studyUid)
{
  keys.putAndInsertString(DCM_QueryRetrieveLevel, level);
  setText(keys, DCM_StudyInstanceUID, studyUid);
}

Result<bool> queryRows(const Server& server, DcmDataset& keys, std::size_t maxRows,
                       const Exchange& exchange, const std::function<void(DcmItem&)>& take)
{
  constexpr const char* service = UID_FINDStudyRootQueryRetrieveInformationModel;
  auto opened = Association::open(server, {{service, plainSyntaxes()}}, exchange);
  if (!opened) return opened.error();
  Association& association = **opened;
  const auto context = association.contextOf(service, Sentence{"queries (C-FIND)"});
  if (!context) return context.error();
  T_DIMSE_C_FindRQ request{};
  request.MessageID = association.nextMessage();
  copyText(service, request.AffectedSOPClassUID);
  request.DataSetType = DIMSE_DATASET_PRESENT;
  request.Priority = DIMSE_PRIORITY_MEDIUM;
  T_DIMSE_C_FindRSP response{};
  Reading reading{association, *context, maxRows, take};
  DcmDataset* detail = nullptr;
  int count = 0;
  const OFCondition answered =
      DIMSE_findUser(association.get(), *context, &request, &keys, count, onRow, &reading,
                     DIMSE_NONBLOCKING, association.answerSeconds(), &response, &detail);
  delete detail;
  if (reading.isCut) return true;
  if (answered.bad()) return association.failure(answered);
  if (response.DimseStatus != STATUS_Success)
    return association.refusal(response.DimseStatus, DU_cfindStatusString(response.DimseStatus));
  association.release();
  return false;
}

Result<Found<FoundStudy>> findStudies(const Server& server, const StudyQuery& query,
                                      const Exchange& exchange)
{
  if (const auto checked = check(query); !checked) return checked.error();
  DcmDataset keys;
  setLevel(keys, "STUDY", "");
  if (!isAscii(query.patientId + query.patientName))
    setText(keys, DCM_SpecificCharacterSet, "ISO_IR 192");
  setText(keys, DCM_PatientID, query.patientId);
  setText(keys, DCM_PatientName, query.patientName);
  setText(keys, DCM_PatientBirthDate, query.birthDate);
  const bool hasDates = !query.from.empty() || !query.until.empty();
  setText(keys, DCM_StudyDate, hasDates ? query.from + "-" + query.until : "");
  setText(keys, DCM_ModalitiesInStudy, query.modality);
  setText(keys, DCM_StudyDescription, "");
  Found<FoundStudy> found;
  const auto cut = queryRows(server, keys, maxFoundRows, exchange, [&found](DcmItem& row) {
    FoundStudy study{textIn(row, DCM_StudyInstanceUID), textIn(row, DCM_StudyDate),
                     textIn(row, DCM_StudyDescription), textIn(row, DCM_ModalitiesInStudy),
                     textIn(row, DCM_PatientName),      textIn(row, DCM_PatientID),
                     textIn(row, DCM_PatientBirthDate)};
    std::replace(study.modalities.begin(), study.modalities.end(), '\\', '/');
    if (!study.uid.empty()) found.rows.push_back(std::move(study));
  });
  if (!cut) return cut.error();
  found.isCut = *cut;
  return found;
}

Result<Found<FoundSeries>> findSeries(const Server& server, const std::string& studyUid,
                                      const Exchange& exchange)
{
  if (const auto checked = checkUid(studyUid, Sentence{"study"}); !checked) return checked.error();
  DcmDataset keys;
  setLevel(keys, "SERIES", studyUid);
  for (const DcmTagKey& tag : {DCM_SeriesInstanceUID, DCM_SeriesNumber, DCM_Modality,
                               DCM_SeriesDescription, DCM_NumberOfSeriesRelatedInstances})
    setText(keys, tag, "");
  Found<FoundSeries> found;
  const auto cut = queryRows(server, keys, maxFoundRows, exchange, [&found](DcmItem& row) {
    FoundSeries series{textIn(row, DCM_SeriesInstanceUID),
                       textIn(row, DCM_SeriesNumber),
                       textIn(row, DCM_Modality),
                       textIn(row, DCM_SeriesDescription),
                       {}};
    const std::string images = textIn(row, DCM_NumberOfSeriesRelatedInstances);
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(images.data(), images.data() + images.size(), count);
    if (error == std::errc{} && end == images.data() + images.size()) series.images = count;
    if (!series.uid.empty()) found.rows.push_back(std::move(series));
  });
  if (!cut) return cut.error();
  found.isCut = *cut;
  return found;
}

}  // namespace perilymph::archive
