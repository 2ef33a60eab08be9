// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/sessions/SessionTasks.h"

#include "gui/pages/sessions/Report.h"
#include "perilymph/analysis/Comparison.h"

namespace perilymph::gui {

SessionTasks::SessionTasks(QObject* parent) : QObject(parent), reading_(this) {}

void SessionTasks::readGhost(const std::filesystem::path& file)
{
  said(tr("Reading %1…").arg(QString::fromStdString(file.stem().string())), false);
  reading_.run(
      "The ghost",
      [file](const std::atomic<bool>& isCanceled) {
        return analysis::readCompared(file, [&isCanceled] { return !isCanceled; });
      },
      [this](const Result<analysis::ComparedInsertion>& read) {
        if (!read) return said(QString::fromStdString(read.error().message), true);
        std::vector<std::pair<Length, Force>> curve;
        for (const analysis::CurvePoint& point : read->profile.curve)
          curve.emplace_back(meters(point.travel), newtons(point.force));
        const QString name = QString::fromStdString(read->name);
        Q_EMIT ghostRead(curve, name);
        said(tr("%1 is shown as reference in the next insertions.").arg(name), false);
      });
}

void SessionTasks::writeReportOf(const std::filesystem::path& file,
                                 const std::filesystem::path& pdf)
{
  said(tr("Replaying %1 for the report…").arg(QString::fromStdString(file.stem().string())), false);
  reading_.run(
      "The report",
      [file](const std::atomic<bool>& isCanceled) { return gatherReport(file, isCanceled); },
      [this, pdf](const Result<ReportContent>& content) {
        if (!content) return said(QString::fromStdString(content.error().message), true);
        const auto written = writeReport(*content, pdf);
        if (!written) return said(QString::fromStdString(written.error().message), true);
        said(tr("Report saved to %1.").arg(QString::fromStdString(pdf.string())), false);
      });
}

}  // namespace perilymph::gui
