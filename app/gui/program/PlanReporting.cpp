// SPDX-License-Identifier: BSD-3-Clause
#include "gui/program/PlanReporting.h"

#include <QByteArray>
#include <QLatin1String>
#include <QString>

#include "gui/report/PlanReportPdf.h"
#include "gui/report/ReportFile.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::gui {

namespace {

ReportPlace placeOf(const CommandLine& options)
{
  return {*options.report, options.ct, options.isCtNotCompared};
}

QtMessageHandler qtHandler = nullptr;  // before drawWithoutDisplay()

}  // namespace

Result<PlanReportContent> reportedPlan(const CommandLine& options)
{
  if (const auto place = checkWritable(*options.report); !place) return place.error();
  if (options.ct && !placeOf(options).isDicom())
    return Error{"--ct needs a report that ends in .dcm, because a PDF carries no study."};
  if (const auto place = checkPlace(placeOf(options)); !place) return place.error();
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
  if (content) content->isStudyNotCompared = options.ct && content->identity().seriesKey.empty();
  return content;
}

Result<void> writeReport(const PlanReportContent& content, const CommandLine& options)
{
  const ReportPlace place = placeOf(options);
  if (!place.isDicom()) return writePlanReport(content, place.file);
  auto pdf = pdfBytes(
      [&content](const std::filesystem::path& file) { return writePlanReport(content, file); });
  if (!pdf) return pdf.error();
  return writeDicom(*std::move(pdf), content.identity(), place);
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
