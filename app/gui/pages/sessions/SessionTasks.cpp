// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/SessionTasks.h"

#include "gui/pages/sessions/Report.h"
#include "perilymph/analysis/Comparison.h"

namespace perilymph::gui {

SessionTasks::SessionTasks(QObject* parent) : QObject(parent), reading_(this) {}

void SessionTasks::readReference(const std::filesystem::path& file)
{
  said(tr("Reading %1…").arg(QString::fromStdString(session::displayNameOf(file))), false);
  reading_.run(
      "The reference",
      [file](const std::atomic<bool>& isCanceled) {
        return analysis::readCompared(file, [&isCanceled] { return !isCanceled; });
      },
      [this](const Result<analysis::ComparedInsertion>& read) {
        if (!read) return said(QString::fromStdString(read.error().message), true);
        ReferenceInsertion reference;
        reference.name = QString::fromStdString(read->name);
        reference.subject = read->subject;
        for (const analysis::CurvePoint& point : read->profile.curve)
          reference.curve.emplace_back(meters(point.travel), newtons(point.force));
        Q_EMIT referenceRead(reference);
        said(tr("%1 is shown as reference in the next insertions.").arg(reference.name), false);
      });
}

void SessionTasks::writeReportOf(const std::filesystem::path& file,
                                 const std::filesystem::path& pdf)
{
  said(tr("Replaying %1 for the report…").arg(QString::fromStdString(session::displayNameOf(file))),
       false);
  reading_.run(
      "The report",
      [file](const std::atomic<bool>& isCanceled) { return gatherReport(file, isCanceled); },
      [this, pdf](const Result<ReportContent>& content) {
        if (!content) return said(QString::fromStdString(content.error().message), true);
        const auto written = writeReport(*content, pdf);
        if (!written) return said(QString::fromStdString(written.error().message), true);
        Q_EMIT reportWritten(pdf);
      });
}

}  // namespace perilymph::gui
