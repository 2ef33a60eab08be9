// SPDX-License-Identifier: BSD-3-Clause
#include "gui/report/ReportFile.h"

#include <system_error>
#include <utility>

#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/FileIdentity.h"
#include "perilymph/foundation/Unfinished.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/imaging/EncapsulatedPdf.h"

namespace perilymph::gui {

namespace {

constexpr std::size_t maxPdfBytes = std::size_t{64} << 20;
constexpr std::size_t maxVersion = 64;  // letters

}  // namespace

std::string codeOf(const anatomy::Patient& patient)
{
  return anatomy::checkPatientCode(patient.label) ? patient.label : std::string();
}

Result<void> checkPlace(const ReportPlace& place)
{
  if (place.ct &&
      isExistingBelow(place.file,
                      place.ct->filename() == "DICOMDIR" ? place.ct->parent_path() : *place.ct))
    return Error{"The report would replace %1, a file of the CT. Give the report another name.",
                 place.file.string()};
  return {};
}

Result<void> checkFiled(const ReportIdentity& identity)
{
  if (identity.seriesKey.empty())
    return Error{
        "The report states no CT series for which a seal vouches, so it cannot be filed in the "
        "study "
        "of a CT. Save it without a CT."};
  return {};
}

Result<std::string> pdfBytes(const PdfWriting& writing)
{
  std::error_code failure;
  const auto folder =
      UnfinishedFolder::create(std::filesystem::temp_directory_path(failure) / "perilymph-report");
  if (failure || !folder)
    return Error{"No temporary folder can be made for the report. Check the space on the disk."};
  const std::filesystem::path pdf = folder->path() / "report.pdf";
  if (const auto written = writing(pdf); !written) return written.error();
  return readWhole(pdf, maxPdfBytes);
}

Result<void> writeDicom(std::string pdf, const ReportIdentity& identity, const ReportPlace& place)
{
  if (const auto checked = checkPlace(place); !checked) return checked;
  return imaging::writeEncapsulatedPdf(
      {std::move(pdf), identity.title, identity.code, buildId().substr(0, maxVersion),
       identity.seriesKey, place.isCtNotCompared},
      place.ct, place.file);
}

}  // namespace perilymph::gui
