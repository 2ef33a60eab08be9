// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/studies/StudiesPage.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <stop_token>

#include "gui/pages/studies/NewStudy.h"
#include "gui/pages/studies/StudyDetails.h"
#include "gui/pages/studies/StudyPanel.h"
#include "gui/pages/studies/StudyPlot.h"
#include "gui/pages/studies/StudyText.h"
#include "gui/pages/studies/SummaryTables.h"
#include "gui/text/DataText.h"
#include "gui/widgets/ElidedLabel.h"
#include "gui/widgets/EmptyPage.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/study/StudyRun.h"

namespace perilymph::gui {

namespace {

constexpr int emptyStage = 0, studyStage = 1, formStage = 2;
constexpr int progressSteps = 1000;

}  // namespace

StudiesPage::StudiesPage(QWidget* parent)
    : Page("studies", tr("Studies"), Icon::studies, parent),
      work_(this),
      running_(this),
      summarizing_(this),
      stages_(new QStackedWidget(this)),
      empty_(new EmptyPage(tr("Studies"),
                           tr("A study runs many insertions: arrays, cochleae and techniques. Make "
                              "one here, or open what perilymph-cli study or an earlier study has "
                              "written."),
                           this)),
      form_(new NewStudy(this)),
      panel_(new StudyPanel(this)),
      plot_(new StudyPlot(this)),
      tables_(new SummaryTables(this)),
      details_(new StudyDetails(this)),
      title_(new ElidedLabel(this)),
      count_(new QLabel(this)),
      export_(panelButton(tr("Export…"), "exportStudyButton", this)),
      progress_(new QProgressBar(this)),
      continue_(panelButton(tr("Continue"), "continueStudyButton", this)),
      cancel_(panelButton(tr("Cancel"), "cancelStudyButton", this)),
      status_(new StatusLine("studyStatus", this))
{
  empty_->offer(tr("New study…"));
  empty_->offerAlso(tr("Open study…"));
  connect(empty_, &EmptyPage::actionRequested, this, &StudiesPage::askNew);
  connect(empty_, &EmptyPage::otherRequested, this, &StudiesPage::ask);
  auto* study = new QWidget(this);
  auto* row = new QHBoxLayout(study);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(panel_);
  row->addWidget(addPlot(), 1);
  row->addWidget(details_);
  stages_->addWidget(empty_);
  stages_->addWidget(study);
  stages_->addWidget(form_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(stages_, 1);
  column->addWidget(addFoot());

  connect(panel_, &StudyPanel::newRequested, this, &StudiesPage::askNew);
  connect(panel_, &StudyPanel::openRequested, this, &StudiesPage::ask);
  connect(panel_, &StudyPanel::axesChanged, this, [this] {
    plot_->show(columns_, panel_->axes());
    summarize();
  });
  connect(panel_, &StudyPanel::filterChanged, this, [this] {
    showMessage(panel_->problem(), true);
    showRows();
  });
  connect(panel_, &StudyPanel::selectionChanged, this, &StudiesPage::showSummary);
  connect(plot_, &StudyPlot::chosen, this, &StudiesPage::choose);
  connect(plot_, &StudyPlot::opened, this, [this](std::uint32_t chosen) {
    choose(chosen);
    runAgain();
  });
  connect(details_, &StudyDetails::replayRequested, this, &StudiesPage::runAgain);
  connect(form_, &NewStudy::startRequested, this, &StudiesPage::startStudy);
  connect(form_, &NewStudy::storedRequested, this, &StudiesPage::takeStored);
  connect(form_, &NewStudy::leaveRequested, this, &StudiesPage::leaveForm);
  connectWork();
  continue_->hide();
  showBusy();
}

QWidget* StudiesPage::addFoot()
{
  auto* foot = new QWidget(this);
  cancel_->setToolTip(tr("Esc. Of a study that runs, what is done is kept."));
  connect(cancel_, &QPushButton::clicked, this, &StudiesPage::endWork);
  continue_->setToolTip(tr("Runs the rest of the study that was canceled"));
  connect(continue_, &QPushButton::clicked, this, &StudiesPage::resume);
  progress_->setTextVisible(false);
  progress_->setFixedSize(sized(120), 6);
  auto* row = new QHBoxLayout(foot);
  row->setContentsMargins(2 * spacing, 0, 2 * spacing, spacing);
  row->setSpacing(spacing);
  row->addWidget(status_, 1);
  row->addWidget(progress_);
  row->addWidget(continue_);
  row->addWidget(cancel_);
  return foot;
}

void StudiesPage::connectWork()
{
  connect(&work_, &StudyWork::opened, this, &StudiesPage::showStudy);
  connect(&work_, &StudyWork::recorded, this,
          [this](const std::filesystem::path& recording, const QString& sentence) {
            showBusy();
            showMessage(sentence);
            Q_EMIT replayRequested(recording);
          });
  connect(&work_, &StudyWork::failed, this, [this](const QString& sentence) {
    showBusy();
    showMessage(sentence, true);
  });
  connect(&running_, &StudyRunWork::progressed, this, &StudiesPage::showRun);
  connect(&running_, &StudyRunWork::ended, this, &StudiesPage::showEnd);
  connect(&running_, &StudyRunWork::failed, this, [this](const QString& sentence) {
    showBusy();
    showMessage(sentence, true);
  });
}

QWidget* StudiesPage::addPlot()
{
  auto* middle = new QWidget(this);
  title_->setObjectName(QStringLiteral("studyTitle"));
  title_->setFont(typeface(15, QFont::DemiBold));
  count_->setObjectName(QStringLiteral("studyCount"));
  count_->setFont(typeface(13));
  count_->setProperty("quiet", true);
  export_->setToolTip(
      tr("Export the shown insertions, groups, differences and slopes as CSV, with units."));
  connect(export_, &QPushButton::clicked, this, &StudiesPage::save);
  auto* head = new QHBoxLayout;
  head->setSpacing(2 * spacing);
  head->addWidget(title_, 1);
  head->addWidget(count_);
  head->addWidget(export_);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 2 * spacing, 0, spacing);
  column->setSpacing(spacing);
  column->addLayout(head);
  column->addWidget(plot_, 1);
  column->addWidget(tables_);
  return middle;
}

void StudiesPage::ask()
{
  const QString file =
      QFileDialog::getOpenFileName(this, tr("Open study"), documentsFolder(),
                                   tr("Results of studies (*.sqlite);;All files (*)"));
  if (!file.isEmpty()) open(file.toStdString());
}

void StudiesPage::open(const std::filesystem::path& file)
{
  showMessage(tr("Reading %1…").arg(QString::fromStdString(file.filename().string())));
  work_.open(file);
  showBusy();
}

void StudiesPage::askNew()
{
  form_->refresh();
  stages_->setCurrentIndex(formStage);
  form_->setFocus();
}

void StudiesPage::leaveForm()
{
  if (stages_->currentIndex() == formStage)
    stages_->setCurrentIndex(columns_ ? studyStage : emptyStage);
}

void StudiesPage::startStudy(const StudyDraft& draft)
{
  showMessage(tr("Preparing the study…"));
  running_.start(draft, form_->jobs());
  leaveForm();
  showBusy();
}

void StudiesPage::takeStored(const StoredStudy& study)
{
  leaveForm();
  if (study.isComplete) return open(study.folder / study::mergedFile);
  folder_ = study.folder;
  resume();
}

void StudiesPage::resume()
{
  showMessage(tr("Preparing the study…"));
  running_.resume(folder_, form_->jobs());
  showBusy();
}

void StudiesPage::showRun(std::size_t done, std::size_t all, double left_s)
{
  progress_->setRange(0, progressSteps);
  progress_->setValue(int(progressSteps * done / all));
  if (work_.isBusy()) return;
  const QString count = tr("%1 of %2 insertions").arg(done).arg(all);
  showMessage(left_s < 0.0 ? count
                           : tr("%1, about %2 left. You can switch pages meanwhile.")
                                 .arg(count, durationText(left_s)));
}

void StudiesPage::showEnd(const StoredStudy& study)
{
  folder_ = study.folder;
  showBusy();
  if (study.isComplete) return open(study.folder / study::mergedFile);
  continue_->show();
  showMessage(tr("Canceled. %1 of %2 insertions are kept; Continue runs the rest.")
                  .arg(study.done)
                  .arg(study.cases));
}

bool StudiesPage::cancel()
{
  if (stages_->currentIndex() == formStage) {
    leaveForm();
    return true;
  }
  return endWork();
}

bool StudiesPage::endWork()
{
  if (work_.isBusy()) {
    work_.cancel();
    showBusy();
    showMessage(tr("Canceled."));
    return true;
  }
  if (!running_.isBusy()) return false;
  running_.requestStop();
  showMessage(tr("Canceling…"));
  return true;
}

void StudiesPage::showStudy(const StudyWork::Columns& columns, const std::filesystem::path& file)
{
  showBusy();
  columns_ = columns;
  file_ = file;
  const QString title = QString::fromStdString(columns->facts().title);
  const QString name = title.isEmpty() ? QString::fromStdString(file.filename().string()) : title;
  const Seal seal = columns->facts().seal;
  title_->setText(seal == Seal::changed ? tr("%1 · changed by hand").arg(name) : name);
  // The first of the sentences: those on what was changed come before the others.
  const std::vector<std::string>& notes = columns->facts().notes;
  const Sentence note =
      seal != Seal::intact || notes.empty() ? noteOn(seal) : anatomy::storedNote(notes.front());
  if (note.empty() && file.parent_path() == folder_)
    status_->sayWritten(tr("The study is complete. Its settings, study.toml, are beside it."),
                        folder_);
  else
    showMessage(dataText(note), seal == Seal::changed || seal == Seal::intact);
  details_->showNone();
  panel_->offer(*columns);
  if (stages_->currentIndex() == emptyStage) stages_->setCurrentIndex(studyStage);
  plot_->select(std::nullopt);
  plot_->show(columns, panel_->axes());
  showRows();
  plot_->setFocus();
}

void StudiesPage::showRows()
{
  if (!columns_) return;
  std::vector<std::uint32_t> rows = columns_->rows(panel_->filter());
  const QLocale locale;
  count_->setText(tr("%1 of %2 insertions")
                      .arg(locale.toString(qulonglong(rows.size())),
                           locale.toString(qulonglong(columns_->size()))));
  const auto chosen = plot_->selected();
  if (chosen && !std::binary_search(rows.begin(), rows.end(), *chosen)) {
    plot_->select(std::nullopt);
    details_->showNone();
  }
  plot_->showRows(std::move(rows));
  summarize();
}

/// In the background: of a million insertions it takes seconds.
void StudiesPage::summarize()
{
  if (!columns_) return;
  summary_.reset();
  export_->setEnabled(false);
  using Summary = std::shared_ptr<const study::StudySummary>;
  summarizing_.run(
      "The summary",
      [columns = columns_, rows = plot_->rows(),
       axes = panel_->axes()](const std::stop_token& stop) -> Result<Summary> {
        return std::make_shared<const study::StudySummary>(
            study::summaryOf(*columns, rows, axes, stop));
      },
      [this](const Result<Summary>& summary) {
        if (!summary) return showMessage(dataText(summary.error().message), true);
        summary_ = *summary;
        export_->setEnabled(true);
        showSummary();
      });
}

void StudiesPage::showSummary()
{
  if (!summary_) return;
  tables_->show(*summary_, panel_->selection());
  plot_->showTrends(*summary_, panel_->selection());
}

void StudiesPage::choose(std::uint32_t row)
{
  plot_->select(row);
  details_->show(columns_->result(row));
}

void StudiesPage::runAgain()
{
  const auto row = plot_->selected();
  if (!row || work_.isBusy()) return;
  showMessage(tr("Running insertion %1 again…").arg(columns_->result(*row).number));
  work_.runAgain(columns_, file_, *row);
  showBusy();
}

Result<void> StudiesPage::writeInto(const std::filesystem::path& folder) const
{
  if (!summary_) return {};
  for (const auto& [name, content] : study::tablesOf(*columns_, plot_->rows(), *summary_))
    if (const auto written = writeWhole(folder / name, content, {Links::refused}); !written)
      return written;
  return {};
}

void StudiesPage::save()
{
  const QString chosen =
      QFileDialog::getExistingDirectory(this, tr("Export to folder"), documentsFolder());
  if (chosen.isEmpty()) return;
  const auto written = writeInto(chosen.toStdString());
  if (!written) return showMessage(dataText(written.error().message), true);
  status_->sayWritten(tr("%1 files saved to %2.").arg(study::summaryTables.size()).arg(chosen),
                      chosen.toStdString());
}

void StudiesPage::showMessage(const QString& sentence, bool isError)
{
  status_->showMessage(sentence, isError);
}

void StudiesPage::showBusy()
{
  progress_->setRange(0, 0);
  progress_->setVisible(isBusy());
  cancel_->setVisible(isBusy());
  if (running_.isBusy()) continue_->hide();
  details_->setBusy(work_.isBusy());
  form_->setBusy(running_.isBusy());
}

}  // namespace perilymph::gui
