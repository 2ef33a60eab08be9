// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/SessionTasks.h"

#include <stop_token>
#include <utility>

#include "gui/report/InsertionReport.h"
#include "gui/report/ReportSending.h"
#include "gui/text/DataText.h"
#include "perilymph/analysis/Comparison.h"

namespace perilymph::gui {

namespace {

Result<ReferenceInsertion> referenceOf(const std::filesystem::path& file,
                                       const std::stop_token& stop)
{
  const auto read = analysis::readCompared(file, stop);
  if (!read) return read.error();
  auto shapes = readShapes(file, stop);
  if (!shapes) return shapes.error();
  ReferenceInsertion reference;
  reference.name = QString::fromStdString(read->name);
  reference.subject = read->subject;
  for (const analysis::CurvePoint& point : read->profile.curve)
    reference.curve.emplace_back(meters(point.travel), newtons(point.force));
  reference.shapes = *std::move(shapes);
  return reference;
}

}  // namespace

SessionTasks::SessionTasks(QObject* parent) : QObject(parent), reading_(this), saving_(this)
{
  connect(&saving_, &ReportSaving::saved, this, &SessionTasks::reportWritten);
  connect(&saving_, &ReportSaving::failed, this,
          [this](const QString& sentence) { said(sentence, true); });
}

void SessionTasks::readReference(const std::filesystem::path& file)
{
  said(tr("Reading %1…").arg(QString::fromStdString(session::displayNameOf(file))), false);
  reading_.run(
      "The reference", [file](const std::stop_token& stop) { return referenceOf(file, stop); },
      [this](const Result<ReferenceInsertion>& reference) {
        if (!reference) return said(dataText(reference.error().message), true);
        Q_EMIT referenceRead(*reference);
        said(tr("%1 is shown as reference in the next insertions.").arg(reference->name), false);
      });
}

void SessionTasks::gather(const std::filesystem::path& file,
                          std::function<void(const ReportContent&)> then)
{
  said(tr("Replaying %1 for the report…").arg(QString::fromStdString(session::displayNameOf(file))),
       false);
  reading_.run(
      "The report", [file](const std::stop_token& stop) { return gatherReport(file, stop); },
      [this, then = std::move(then)](const Result<ReportContent>& content) {
        if (!content) return said(dataText(content.error().message), true);
        then(*content);
      });
}

void SessionTasks::writeReportOf(const std::filesystem::path& file, const ReportPlace& place)
{
  gather(file, [this, place](const ReportContent& content) {
    saving_.save([&content](const std::filesystem::path& pdf) { return writeReport(content, pdf); },
                 content.identity(), place);
  });
}

void SessionTasks::prepareReportOf(const std::filesystem::path& file)
{
  gather(file, [this](const ReportContent& content) {
    const auto pdf = pdfToSend(
        [&content](const std::filesystem::path& place) { return writeReport(content, place); },
        content.identity());
    if (!pdf) return said(dataText(pdf.error().message), true);
    said({}, false);
    Q_EMIT reportPrepared(*pdf, content.identity());
  });
}

}  // namespace perilymph::gui
