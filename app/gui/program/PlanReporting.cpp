// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/PlanReporting.h"

#include <QByteArray>
#include <QLatin1String>
#include <QString>

#include "gui/report/PlanReportPdf.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/foundation/FileIdentity.h"
#include "perilymph/foundation/Unfinished.h"
#include "perilymph/foundation/Version.h"
#include "perilymph/imaging/EncapsulatedPdf.h"

namespace perilymph::gui {

namespace {

bool isDicom(const std::filesystem::path& file) { return file.extension() == ".dcm"; }

QtMessageHandler qtHandler = nullptr;  // before drawWithoutDisplay()

constexpr std::size_t maxPdfBytes = std::size_t{64} << 20;

}  // namespace

/// The series in which a plan's patient was measured; none where nobody vouches for it.
std::string seriesOf(const planning::Plan& plan)
{
  const anatomy::Patient& patient = plan.request.patient;
  return plan.seal == Seal::intact && patient.seal == Seal::intact ? patient.origin.seriesKey
                                                                   : std::string();
}

Result<PlanReportContent> reportedPlan(const CommandLine& options)
{
  if (const auto place = checkWritable(*options.report); !place) return place.error();
  if (options.ct && !isDicom(*options.report))
    return Error{"--ct needs a report that ends in .dcm, because a PDF carries no study."};
  if (options.ct && isExistingBelow(*options.report, options.ct->filename() == "DICOMDIR"
                                                         ? options.ct->parent_path()
                                                         : *options.ct))
    return Error{"--report would replace %1, which --ct reads. Give --report another name.",
                 options.report->string()};
  auto stored = planning::readPlan(*options.plan);
  if (!stored) return stored.error();
  if (options.ct && stored->plan.seal == Seal::changed)
    return Error{
        "%1 was changed by hand after the program wrote it, so it is not filed into a study. Make "
        "the plan again, or leave --ct out.",
        options.plan->string()};
  if (options.ct && stored->plan.request.patient.seal == Seal::changed)
    return Error{
        "%1 is of measures that were changed by hand after the program wrote them, so it is not "
        "filed into a study. Measure the patient again and make a new plan, or leave --ct out.",
        options.plan->string()};
  if (options.ct && stored->plan.seal == Seal::absent && !options.isCtNotCompared)
    return Error{
        "%1 carries no seal, so the CT series that it states proves nothing. Make the plan again, "
        "leave --ct out, or, if you know that the CT is the patient's, add --ct-not-compared.",
        options.plan->string()};
  auto content = planReportContent(*std::move(stored));
  if (content) content->isStudyNotCompared = options.ct && seriesOf(content->plan()).empty();
  return content;
}

Result<Done> writeReport(const PlanReportContent& content, const CommandLine& options)
{
  if (!isDicom(*options.report)) return writePlanReport(content, *options.report);
  std::error_code failure;
  const auto folder =
      UnfinishedFolder::create(std::filesystem::temp_directory_path(failure) / "perilymph-report");
  if (failure || !folder)
    return Error{"No temporary folder can be made for the report. Check the space on the disk."};
  const std::filesystem::path pdf = folder->path() / "plan.pdf";
  if (const auto written = writePlanReport(content, pdf); !written) return written;
  auto bytes = readWhole(pdf, maxPdfBytes);
  if (!bytes) return bytes.error();
  const bool hasCode(anatomy::checkPatientCode(content.plan().request.patient.label));
  return imaging::writeEncapsulatedPdf(
      {*std::move(bytes), "Insertion plan",
       hasCode ? content.plan().request.patient.label : std::string(), buildId().substr(0, 64),
       seriesOf(content.plan()), options.isCtNotCompared},
      options.ct, *options.report);
}

void drawWithoutDisplay()
{
  qputenv("QT_QPA_PLATFORM", "offscreen");
  // Qt warns where there is no folder for sockets, of which a report has none.
  qtHandler = qInstallMessageHandler(
      [](QtMsgType type, const QMessageLogContext& context, const QString& message) {
        if (!message.startsWith(QLatin1String("QStandardPaths:")))
          qtHandler(type, context, message);
      });
}

}  // namespace perilymph::gui
