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

#include "gui/pages/studies/StudyDetails.h"
#include "gui/pages/studies/StudyPanel.h"
#include "gui/pages/studies/StudyPlot.h"
#include "gui/text/DataText.h"
#include "gui/widgets/ElidedLabel.h"
#include "gui/widgets/EmptyPage.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "perilymph/anatomy/Patient.h"

namespace perilymph::gui {

namespace {

constexpr int emptyStage = 0, studyStage = 1;

}  // namespace

StudiesPage::StudiesPage(QWidget* parent)
    : Page("studies", tr("Studies"), Icon::studies, parent),
      work_(this),
      stages_(new QStackedWidget(this)),
      empty_(new EmptyPage(tr("Studies"),
                           tr("A study runs many insertions: arrays, cochleae and techniques. Run "
                              "one with perilymph-cli study, then open its result here."),
                           this)),
      panel_(new StudyPanel(this)),
      plot_(new StudyPlot(this)),
      details_(new StudyDetails(this)),
      title_(new ElidedLabel(this)),
      count_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)),
      status_(new StatusLine("studyStatus", this))
{
  empty_->offer(tr("Open study…"));
  connect(empty_, &EmptyPage::actionAsked, this, &StudiesPage::ask);
  auto* study = new QWidget(this);
  auto* row = new QHBoxLayout(study);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  row->addWidget(panel_);
  row->addWidget(addPlot(), 1);
  row->addWidget(details_);
  stages_->addWidget(empty_);
  stages_->addWidget(study);

  cancel_->setObjectName(QStringLiteral("cancelStudyButton"));
  cancel_->setFont(typeface(13));
  cancel_->setFixedHeight(sized(28));
  cancel_->setToolTip(tr("Esc"));
  connect(cancel_, &QPushButton::clicked, this, &StudiesPage::cancel);
  progress_->setTextVisible(false);
  progress_->setFixedSize(sized(120), 6);
  progress_->setRange(0, 0);
  auto* foot = new QHBoxLayout;
  foot->setContentsMargins(2 * spacing, 0, 2 * spacing, spacing);
  foot->setSpacing(spacing);
  foot->addWidget(status_, 1);
  foot->addWidget(progress_);
  foot->addWidget(cancel_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(stages_, 1);
  column->addLayout(foot);

  connect(panel_, &StudyPanel::openAsked, this, &StudiesPage::ask);
  connect(panel_, &StudyPanel::axesChanged, this,
          [this] { plot_->show(columns_, panel_->axes()); });
  connect(panel_, &StudyPanel::filterChanged, this, &StudiesPage::showRows);
  connect(plot_, &StudyPlot::chosen, this, &StudiesPage::choose);
  connect(plot_, &StudyPlot::opened, this, [this](std::uint32_t chosen) {
    choose(chosen);
    runAgain();
  });
  connect(details_, &StudyDetails::replayAsked, this, &StudiesPage::runAgain);
  connect(&work_, &StudyWork::opened, this, &StudiesPage::showStudy);
  connect(&work_, &StudyWork::recorded, this,
          [this](const std::filesystem::path& recording, const QString& sentence) {
            setBusy(false);
            say(sentence);
            Q_EMIT replayRequested(recording);
          });
  connect(&work_, &StudyWork::failed, this, [this](const QString& sentence) {
    setBusy(false);
    say(sentence, true);
  });
  setBusy(false);
}

QWidget* StudiesPage::addPlot()
{
  auto* middle = new QWidget(this);
  title_->setObjectName(QStringLiteral("studyTitle"));
  title_->setFont(typeface(15, QFont::DemiBold));
  count_->setObjectName(QStringLiteral("studyCount"));
  count_->setFont(typeface(13));
  count_->setProperty("quiet", true);
  auto* head = new QHBoxLayout;
  head->setSpacing(2 * spacing);
  head->addWidget(title_, 1);
  head->addWidget(count_);
  auto* column = new QVBoxLayout(middle);
  column->setContentsMargins(0, 2 * spacing, 0, spacing);
  column->setSpacing(spacing);
  column->addLayout(head);
  column->addWidget(plot_, 1);
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
  setBusy(true);
  say(tr("Reading %1…").arg(QString::fromStdString(file.filename().string())));
  work_.open(file);
}

bool StudiesPage::cancel()
{
  if (!work_.isBusy()) return false;
  work_.cancel();
  setBusy(false);
  say(tr("Canceled."));
  return true;
}

void StudiesPage::showStudy(const StudyWork::Columns& columns, const std::filesystem::path& file)
{
  setBusy(false);
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
  say(dataText(note), seal == Seal::changed || seal == Seal::intact);
  details_->showNone();
  panel_->offer(*columns);
  stages_->setCurrentIndex(studyStage);
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
  setBusy(true);
  say(tr("Running insertion %1 again…").arg(columns_->result(*row).number));
  work_.runAgain(columns_, file_, *row);
}

void StudiesPage::say(const QString& sentence, bool isError) { status_->say(sentence, isError); }

void StudiesPage::setBusy(bool isBusy)
{
  progress_->setVisible(isBusy);
  cancel_->setVisible(isBusy);
  details_->setBusy(isBusy);
}

}  // namespace perilymph::gui
