// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/PlanReporting.h"

#include <QByteArray>
#include <QTemporaryDir>

#include "gui/report/PlanReportPdf.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/imaging/EncapsulatedPdf.h"

namespace perilymph::gui {

namespace {

bool isDicom(const std::filesystem::path& file) { return file.extension() == ".dcm"; }

constexpr std::size_t maxPdfBytes = std::size_t{64} << 20;

}  // namespace

Result<PlanReportContent> reportedPlan(const CommandLine& options)
{
  if (const auto place = checkWritable(*options.report); !place) return place.error();
  if (options.ct && !isDicom(*options.report))
    return Error{"--ct needs a report that ends in .dcm, because a PDF carries no study."};
  auto stored = planning::readPlan(*options.plan);
  if (!stored) return stored.error();
  if (options.ct && stored->plan.seal == Seal::changed)
    return Error{
        options.plan->string() +
        " was changed by hand after the program wrote it, so it is not filed into a study. "
        "Make the plan again, or leave --ct out."};
  auto content = planReportContent(*std::move(stored));
  if (content)
    content->isStudyNotCompared =
        options.ct && content->plan().request.patient.origin.seriesKey.empty();
  return content;
}

Result<Done> writeReport(const PlanReportContent& content, const CommandLine& options)
{
  if (!isDicom(*options.report)) return writePlanReport(content, *options.report);
  const QTemporaryDir folder;
  if (!folder.isValid())
    return Error{"No temporary folder can be made for the report. Check the space on the disk."};
  const std::filesystem::path pdf = folder.filePath(QStringLiteral("plan.pdf")).toStdString();
  if (const auto written = writePlanReport(content, pdf); !written) return written;
  auto bytes = readWhole(pdf, maxPdfBytes);
  if (!bytes) return bytes.error();
  const bool hasCode(anatomy::checkPatientCode(content.plan().request.patient.label));
  return imaging::writeEncapsulatedPdf(
      {*std::move(bytes), "Insertion plan",
       hasCode ? content.plan().request.patient.label : std::string(), buildId().substr(0, 64),
       content.plan().request.patient.origin.seriesKey, options.isCtNotCompared},
      options.ct, *options.report);
}

void drawWithoutDisplay() { qputenv("QT_QPA_PLATFORM", "offscreen"); }

}  // namespace perilymph::gui
