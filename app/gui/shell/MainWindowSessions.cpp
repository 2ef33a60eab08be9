// What was recorded, in the main window: the library and what is asked of it.

#include <QFileDialog>

#include "gui/pages/compare/ComparePage.h"
#include "gui/pages/insert/ForceCharts.h"
#include "gui/pages/sessions/Report.h"
#include "gui/pages/sessions/SessionsPage.h"
#include "gui/shell/MainWindow.h"
#include "perilymph/analysis/Comparison.h"

namespace perilymph::gui {

void MainWindow::connectSessions()
{
  connectReplay();
  connect(sessions_, &SessionsPage::replayAsked, this, &MainWindow::openReplay);
  connect(sessions_, &SessionsPage::compareAsked, this,
          [this](const std::vector<std::filesystem::path>& files) {
            showPage(Page::compare);
            comparison_->compare(files);
          });
  connect(sessions_, &SessionsPage::ghostAsked, this, &MainWindow::useGhost);
  connect(sessions_, &SessionsPage::reportAsked, this, &MainWindow::askForReport);
}

void MainWindow::useGhost(const std::filesystem::path& file)
{
  sessions_->say(tr("Reading %1…").arg(QString::fromStdString(file.stem().string())));
  reading_.run(
      "The ghost",
      [file](const std::atomic<bool>& isCanceled) {
        return analysis::readCompared(file, [&isCanceled] { return !isCanceled; });
      },
      [this](const Result<analysis::ComparedInsertion>& read) {
        if (!read) return sessions_->say(QString::fromStdString(read.error().message), true);
        std::vector<std::pair<Length, Force>> curve;
        for (const analysis::CurvePoint& point : read->profile.curve)
          curve.emplace_back(meters(point.travel), newtons(point.force));
        const QString name = QString::fromStdString(read->name);
        charts_->setGhost(curve, name);
        sessions_->say(tr("%1 stands behind the next insertions as their ghost.").arg(name));
      });
}

void MainWindow::askForReport(const std::filesystem::path& file)
{
  const QString suggested =
      QString::fromStdString((file.parent_path() / file.stem()).string()) + QStringLiteral(".pdf");
  const QString chosen =
      QFileDialog::getSaveFileName(this, tr("Report as PDF"), suggested, tr("PDF (*.pdf)"));
  if (!chosen.isEmpty()) saveReport(file, chosen.toStdString());
}

void MainWindow::saveReport(const std::filesystem::path& file, const std::filesystem::path& pdf)
{
  sessions_->say(
      tr("Replaying %1 for its report…").arg(QString::fromStdString(file.stem().string())));
  reading_.run(
      "The report",
      [file](const std::atomic<bool>& isCanceled) { return gatherReport(file, isCanceled); },
      [this, pdf](const Result<ReportContent>& content) {
        if (!content) return sessions_->say(QString::fromStdString(content.error().message), true);
        const auto written = writeReport(*content, pdf);
        if (!written) return sessions_->say(QString::fromStdString(written.error().message), true);
        sessions_->say(tr("The report is %1.").arg(QString::fromStdString(pdf.string())));
      });
}

void MainWindow::showSessions()
{
  sessions_->refresh(control_.recording(), control_.isRunning());
  sessions_->setFocus();
}

}  // namespace perilymph::gui
