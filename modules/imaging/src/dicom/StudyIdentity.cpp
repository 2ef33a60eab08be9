// SPDX-License-Identifier: BSD-3-Clause
#include "StudyIdentity.h"

#include <vtkDICOMMetaData.h>
#include <vtkDICOMParser.h>
#include <vtkDICOMValue.h>
#include <vtkSmartPointer.h>

#include <set>

#include "../VtkErrorCollector.h"
#include "DicomFiles.h"
#include "DicomSeries.h"

namespace perilymph::imaging {
namespace {

/// Length of a value beyond which it is no attribute of these kinds [bytes].
constexpr std::size_t maxValueBytes = 1024;

/// Attributes of the modules Patient and General Study, and their character set.
constexpr std::pair<std::uint16_t, std::uint16_t> tags[] = {
    {0x0008, 0x0005},   // SpecificCharacterSet
    {0x0008, 0x0020},   // StudyDate
    {0x0008, 0x0030},   // StudyTime
    {0x0008, 0x0050},   // AccessionNumber
    {0x0008, 0x0090},   // ReferringPhysicianName
    {0x0010, 0x0010},   // PatientName
    {0x0010, 0x0020},   // PatientID
    {0x0010, 0x0021},   // IssuerOfPatientID
    {0x0010, 0x0030},   // PatientBirthDate
    {0x0010, 0x0040},   // PatientSex
    {0x0020, 0x000D},   // StudyInstanceUID
    {0x0020, 0x0010}};  // StudyID

/// The number of the patient; empty where there is none.
std::string patientIn(const StudyIdentity& identity)
{
  const auto found = identity.values.find({0x0010, 0x0020});
  return found == identity.values.end() ? std::string() : found->second;
}

}  // namespace

std::optional<StudyIdentity> identityIn(const std::filesystem::path& file)
{
  const auto wanted = vtkSmartPointer<vtkDICOMMetaData>::New();
  for (const auto& [group, element] : tags)
    wanted->Set(vtkDICOMTag(group, element), vtkDICOMValue(vtkDICOMVR::UN));
  const auto complaints = vtkSmartPointer<ErrorCollector>::New();
  const auto parser = vtkSmartPointer<vtkDICOMParser>::New();
  const auto found = vtkSmartPointer<vtkDICOMMetaData>::New();
  complaints->listenTo({parser, found});
  parser->SetMetaData(found);
  parser->SetQuery(wanted);
  parser->SetFileName(file.c_str());
  parser->Update();
  StudyIdentity identity;
  for (const auto& tag : tags) {
    const vtkDICOMValue& value = found->Get(vtkDICOMTag(tag.first, tag.second));
    if (!value.IsValid() || value.GetVL() > maxValueBytes || value.GetCharData() == nullptr)
      continue;
    std::string text(value.GetCharData(), value.GetVL());
    while (!text.empty() && (text.back() == ' ' || text.back() == '\0')) text.pop_back();
    identity.values[tag] = text;
  }
  identity.studyUid = identity.values[{0x0020, 0x000D}];
  if (identity.studyUid.empty()) return std::nullopt;
  return identity;
}

Result<StudyIdentity> readStudyIdentity(const std::filesystem::path& ct)
{
  const auto listed = listDicomFiles(ct, {});
  if (!listed) return listed.error();
  std::optional<StudyIdentity> common;
  std::set<std::string> series, keys;
  for (const DicomHeader& header : listed->headers) {
    if (!header.seriesUid.empty()) keys.insert(seriesKeyOf(header.seriesUid));
    // one file of each series, patient and study, which may be several under one series number
    if (!series.insert(header.seriesUid + header.identity.patient + header.identity.study).second)
      continue;
    const auto identity = identityIn(header.file);
    if (!identity) continue;
    if (!common) common = identity;
    if (identity->studyUid != common->studyUid || patientIn(*identity) != patientIn(*common))
      return Error{
          "%1 holds series of several studies. Give the folder of the one study that the report "
          "belongs to.",
          ct};
  }
  if (common) {
    common->seriesKeys = std::move(keys);
    return *std::move(common);
  }
  return Error{
      "%1 holds no DICOM file that states its study. Give the folder of the patient's CT, or leave "
      "it out.",
      ct};
}

}  // namespace perilymph::imaging
