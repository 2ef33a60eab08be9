// SPDX-License-Identifier: BSD-3-Clause
#include "perilymph/archive/MeasurementReport.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmsr/cmr/tid1500.h>
#include <dcmtk/dcmsr/codes/ucum.h>
#include <dcmtk/dcmsr/dsrdoc.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "Association.h"
#include "CtHeaders.h"
#include "Rows.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Sha256.h"

namespace perilymph::archive {

namespace fs = std::filesystem;

namespace {

// Codes of this program, PS3.16 section 8.2: designators that begin with 99 are private.
constexpr const char* scheme = "99PERILYMPH";

struct Row {
  Quantity quantity;
  const char* code;
  const char* meaning;
};
constexpr std::array<Row, 4> rows = {
    {{Quantity::a, "A", "Cochlear diameter A, round window through modiolus"},
     {Quantity::b, "B", "Cochlear width B, perpendicular to A"},
     {Quantity::h, "H", "Cochlear height H, base to apex"},
     {Quantity::ductLength, "CDL-OC", "Cochlear duct length, organ of Corti, from A and B"}}};

DSRCodedEntryValue ownCode(const char* code, const char* meaning)
{
  return {code, scheme, meaning};
}

const Row& rowOf(Quantity quantity)
{
  return *std::find_if(rows.begin(), rows.end(),
                       [quantity](const Row& row) { return row.quantity == quantity; });
}

/// A length to a hundredth of a millimeter.
std::string millimeters(double value)
{
  char text[16];  // a DS has at most 16 letters
  std::snprintf(text, sizeof text, "%.2f", value);
  return text;
}

/// The number of 16 bytes in digits.
std::string decimal(std::array<unsigned, 16> bytes)
{
  std::string digits;
  while (std::any_of(bytes.begin(), bytes.end(), [](unsigned byte) { return byte != 0; })) {
    unsigned rest = 0;
    for (unsigned& byte : bytes) {
      const unsigned whole = rest * 256 + byte;
      byte = whole / 10;
      rest = whole % 10;
    }
    digits.insert(digits.begin(), static_cast<char>('0' + rest));
  }
  return digits;
}

/// The same UID for one cochlea of one series each time: PS3.5 B.2, from a UUID of version 8 (RFC 9562).
std::string trackingUid(const MeasurementReport& report)
{
  Sha256 hash;
  hash.add("perilymph cochlea ");
  hash.add(report.seriesKey);
  hash.add(report.isRight ? std::string_view(" right") : std::string_view(" left"));
  const std::string hex = hash.hex();
  std::array<unsigned, 16> bytes{};
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<unsigned>(std::stoul(hex.substr(2 * i, 2), nullptr, 16));
  bytes[6] = (bytes[6] & 0x0fU) | 0x80U;
  bytes[8] = (bytes[8] & 0x3fU) | 0x80U;
  return "2.25." + decimal(bytes);
}

Result<void> check(const MeasurementReport& report)
{
  if (report.measures.empty()) return Error{"A report without measures is not written."};
  return checkSoftware(report.software);
}

/// The tree of TID 1500.
OFCondition fill(TID1500_MeasurementReport& tree, const MeasurementReport& report,
                 const Headers& headers)
{
  // by code: DCMTK 3.6.8 renamed the classes of the context groups
  OFCondition done = tree.setLanguage(DSRCodedEntryValue("eng", "RFC5646", "English"));
  const auto then = [&done](const auto& step) {
    if (done.good()) done = step();
  };
  char uid[maxLetters + 1];
  dcmGenerateUniqueIdentifier(uid);
  then([&] {
    return tree.getObservationContext().addDeviceObserver(uid, "Perilymph", "Perilymph",
                                                          report.software.c_str());
  });
  then([&] { return tree.addProcedureReported(CMR_CID100::CTUnspecifiedBodyRegion); });
  TID1600_ImageLibrary& library = tree.getImageLibrary();
  then([&] { return library.createNewImageLibrary(); });
  then([&] { return library.addImageGroup(); });
  for (const auto& header : headers)
    then([&] {
      return library.addImageEntry(*header->getDataset(), TID1600_ImageLibrary::withAllDescriptors);
    });
  then([&] { return library.moveCommonImageDescriptorsToImageGroups(); });
  auto& group = tree.getIndividualMeasurements();
  const char* const side = report.isRight ? "Right cochlea" : "Left cochlea";
  then([&] { return group.setTrackingIdentifier(side); });
  then([&] { return group.setTrackingUniqueIdentifier(trackingUid(report).c_str()); });
  then([&] {
    return group.setMeasurementMethod(
        report.hasMarksByHand
            ? ownCode("FIT-MARKS", "Fit of the bony lumen in CT, landmarks placed by a person")
            : ownCode("FIT", "Fit of the bony lumen in CT"));
  });
  then([&] {
    return group.addFindingSite(
        DSRCodedEntryValue("80169004", "SCT", "Cochlea"),
        report.isRight ? CID244e_Laterality::Right : CID244e_Laterality::Left);
  });
  for (const ReportedMeasure& measure : report.measures) {
    const Row& row = rowOf(measure.quantity);
    then([&] {
      return group.addMeasurement(
          ownCode(row.code, row.meaning),
          TID1500_MeasurementReport::TID1501_Measurements::MeasurementValue(
              millimeters(measure.value_mm).c_str(), DSRCodedEntryValue(CODE_UCUM_Millimeter)));
    });
  }
  return done;
}

/// Adds the error of each measure: TID 310, with a concept of CID 225.
OFCondition addErrors(DSRDocumentTree& tree, const MeasurementReport& report)
{
  for (const ReportedMeasure& measure : report.measures) {
    if (!(measure.halfWidth95_mm > 0.0)) continue;
    const Row& row = rowOf(measure.quantity);
    if (tree.gotoNamedNode(ownCode(row.code, row.meaning), OFTrue) == 0 ||
        tree.addContentItem(DSRTypes::RT_hasProperties, DSRTypes::VT_Num,
                            DSRTypes::AM_belowCurrent) == 0)
      return SR_EC_InvalidDocumentTree;
    DSRContentItem& item = tree.getCurrentContentItem();
    OFCondition done = item.setConceptName(
        DSRCodedEntryValue("371884006", "SCT", "+/-, range of measurement uncertainty"));
    if (done.good())
      done = item.setNumericValue(DSRNumericMeasurementValue(
          millimeters(measure.halfWidth95_mm).c_str(), DSRCodedEntryValue(CODE_UCUM_Millimeter)));
    if (done.bad()) return done;
  }
  return EC_Normal;
}

/// Patient, study, equipment and evidence.
OFCondition setHeader(DSRDocument& document, const MeasurementReport& report,
                      const Headers& headers)
{
  DcmDataset& first = *headers.front()->getDataset();
  OFCondition done = document.createNewDocument(DSRTypes::DT_EnhancedSR);
  const auto then = [&done](const auto& step) {
    if (done.good()) done = step();
  };
  then(
      [&] { return document.createNewSeriesInStudy(textIn(first, DCM_StudyInstanceUID).c_str()); });
  // names and descriptions stay in the CT's own characters; the report's own texts are ASCII
  then([&] {
    return document.setSpecificCharacterSet(textIn(first, DCM_SpecificCharacterSet).c_str());
  });
  then([&] { return document.readPatientData(first); });
  then([&] { return document.readStudyData(first); });
  then([&] { return document.setManufacturer("Perilymph"); });
  then([&] { return document.setManufacturerModelName("Perilymph"); });
  then([&] { return document.setSoftwareVersions(report.software.c_str()); });
  then([&] { return document.setSeriesDescription("Cochlear measures"); });
  then([&] { return document.setSeriesNumber("1"); });
  auto& schemes = document.getCodingSchemeIdentification();
  then([&] { return schemes.addItem(scheme); });
  then([&] { return schemes.setCodingSchemeName("Codes of Perilymph"); });
  for (const auto& header : headers)
    then([&] {
      return document.getCurrentRequestedProcedureEvidence().addItem(*header->getDataset());
    });
  return done;
}

}  // namespace

Result<void> writeMeasurementReport(const MeasurementReport& report, const fs::path& ct,
                                    const fs::path& file)
{
  if (const auto ready = prepareDcmtk(); !ready) return ready;
  if (const auto checked = check(report); !checked) return checked;
  const auto headers = readHeaders(ct, report.seriesKey);
  if (!headers) return headers.error();
  DSRDocument document;
  TID1500_MeasurementReport tree(CMR_CID7021::ImagingMeasurementReport);
  OFCondition done = setHeader(document, report, *headers);
  if (done.good()) done = fill(tree, report, *headers);
  if (done.good()) done = document.setTreeFromRootTemplate(tree);
  if (done.good()) done = addErrors(document.getTree(), report);
  if (done.good()) done = document.completeDocument();
  DcmFileFormat written;
  if (done.good()) done = document.write(*written.getDataset());
  if (done.bad())
    return Error{"The measures cannot be written as a structured report of %1: %2.", ct,
                 done.text()};
  return writeWhole(file,
                    [&written](const fs::path& place) {
                      return written.saveFile(place.c_str(), EXS_LittleEndianExplicit).good();
                    },
                    {Links::followed, Audience::owner});
}

}  // namespace perilymph::archive
