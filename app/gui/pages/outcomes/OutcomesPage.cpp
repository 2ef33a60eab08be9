// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/outcomes/OutcomesPage.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>

#include "gui/setup/OutcomeWords.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/setup/TableFiles.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/DrawingView.h"
#include "gui/widgets/EmptyPage.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/TableRows.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

constexpr int outcomesRow_px = 24, coverageHeight_px = 124;

void addColumns(QTableWidget& table, const std::vector<std::pair<QString, QString>>& columns)
{
  table.setColumnCount(int(columns.size()));
  for (int column = 0; column < int(columns.size()); ++column) {
    auto* head = new QTableWidgetItem(columns[std::size_t(column)].first);
    head->setToolTip(columns[std::size_t(column)].second);
    table.setHorizontalHeaderItem(column, head);
  }
  table.setFont(typeface(12));
  showInRows(table, sized(outcomesRow_px));
  table.setWordWrap(false);
  table.horizontalHeader()->setFont(typeface(11));
  table.horizontalHeader()->setHighlightSections(false);
  table.horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

void addRow(QTableWidget& table, const QStringList& texts)
{
  const int row = table.rowCount();
  table.insertRow(row);
  for (int column = 0; column < texts.size(); ++column)
    table.setItem(row, column, new QTableWidgetItem(texts[column]));
}

QString intervalWords(const outcome::Uncertain& measured, int decimals, const QString& unit)
{
  const auto interval = measured.interval95();
  return OutcomesPage::tr("%1 (%2–%3)%4")
      .arg(numberText(measured.value, decimals), numberText(interval[0], decimals),
           numberText(interval[1], decimals), unit);
}

QString shareWords(double share)
{
  return OutcomesPage::tr("%1 %").arg(numberText(100.0 * share, 0));
}

/// "7 of 12: 58 % (32–81)"
QString hitsWords(std::size_t hits, std::size_t all, const analysis::Estimate& estimate)
{
  if (all == 0) return OutcomesPage::tr("–");
  return OutcomesPage::tr("%1 of %2: %3 % (%4–%5)")
      .arg(hits)
      .arg(all)
      .arg(numberText(100.0 * estimate.value, 0), numberText(100.0 * estimate.low, 0),
           numberText(100.0 * estimate.high, 0));
}

void showFigure(DrawingView& view, const outcome::ClinicOutcomes& clinic, const char* name)
{
  for (const auto& [key, figure] : outcome::outcomesFigures(clinic))
    if (key == name) view.show(figures::draw(translated(figure)));
}

}  // namespace

OutcomesPage::OutcomesPage(QWidget* parent)
    : Page("outcomes", tr("Outcomes"), Icon::outcomes, parent),
      background_(this),
      stages_(new QStackedWidget(this)),
      empty_(new EmptyPage(tr("Outcomes of all patients"),
                           tr("Outcomes that are saved on the page Outcome stand here beside their "
                              "plans: how often the bands held, and where in them each ear came."),
                           this)),
      rows_(new QTableWidget(this)),
      coverage_(new QTableWidget(this)),
      depths_(new DrawingView(this)),
      percentiles_(new DrawingView(this)),
      status_(new StatusLine("outcomesStatus", this))
{
  empty_->offer(tr("Find an array in a CT"));
  connect(empty_, &EmptyPage::actionRequested, this,
          [this] { Q_EMIT pageRequested(QStringLiteral("outcome")); });
  stages_->addWidget(empty_);
  stages_->addWidget(addContent());
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(2 * spacing, 2 * spacing, 2 * spacing, spacing);
  column->setSpacing(spacing);
  column->addWidget(stages_, 1);
  column->addWidget(status_);
}

QWidget* OutcomesPage::addContent()
{
  auto* page = new QWidget(this);
  rows_->setObjectName(QStringLiteral("outcomesTable"));
  rows_->setAccessibleName(tr("Outcomes, a row an ear"));
  const QString bandTip = tr(
      "Median and band of the plan’s simulations, 5 to 95 %; of fewer than 19 the lowest and the "
      "highest");
  addColumns(*rows_,
             {{tr("Patient"), tr("Code and ear; the newest outcome of each")},
              {tr("Array"), tr("The implanted array")},
              {tr("Depth, plan"), bandTip},
              {tr("Depth, found"), tr("Inserted length past the opening, with its 95 % interval")},
              {tr("Percentile"),
               tr("Share of the plan’s simulations below the depth found, with its error")},
              {tr("Angle, plan"), bandTip},
              {tr("Angle, found"), tr("Of the most apical contact, with its 95 % interval")},
              {tr("Percentile"),
               tr("Share of the plan’s simulations below the angle found, with its error")},
              {tr("Stopped because of"), tr("As the surgeon states it")}});
  coverage_->setObjectName(QStringLiteral("outcomesCoverage"));
  coverage_->setAccessibleName(tr("How often the bands held, by array"));
  const QString wilson = tr("Ears inside the band, with the 95 % interval of Wilson");
  addColumns(*coverage_, {{tr("Array"), {}},
                          {tr("Depth in 50 %"), wilson},
                          {tr("Depth in 90 %"), wilson},
                          {tr("Angle in 50 %"), wilson},
                          {tr("Angle in 90 %"), wilson}});
  coverage_->setSelectionMode(QAbstractItemView::NoSelection);
  coverage_->setFixedHeight(sized(coverageHeight_px));
  depths_->setObjectName(QStringLiteral("outcomesDepths"));
  depths_->setAccessibleName(tr("Predicted against measured depth"));
  percentiles_->setObjectName(QStringLiteral("outcomesPercentiles"));
  percentiles_->setAccessibleName(tr("Histogram of the percentiles"));
  auto* note = new WrappedLabel(tr("Each ear is compared with the plan as it was made before. "
                                   "Where the bands are right, half of the "
                                   "ears lie in that of 50 %, nine of ten in that of 90 %, and the "
                                   "percentiles are spread evenly."),
                                page);
  note->setFont(typeface(12));
  note->setProperty("quiet", true);
  auto* save = panelButton(tr("Save table…"), "saveOutcomesButton", page);
  save->setToolTip(
      tr("CSV with a dictionary of its columns; neither codes nor dates finer than a year"));
  connect(save, &QPushButton::clicked, this, &OutcomesPage::save);
  auto* figures = new QHBoxLayout;
  figures->setSpacing(spacing);
  figures->addWidget(depths_, 1);
  figures->addWidget(percentiles_, 1);
  auto* head = new QHBoxLayout;
  head->addWidget(note, 1);
  head->addWidget(save, 0, Qt::AlignTop);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addLayout(head);
  column->addWidget(rows_, 2);
  column->addWidget(coverage_);
  column->addLayout(figures, 3);
  return page;
}

void OutcomesPage::onShown()
{
  status_->showMessage(tr("Comparing outcomes with their plans…"));
  background_.run(
      "The comparison", [](const std::stop_token& stop) { return allOutcomes(stop); },
      [this](const Result<AllOutcomes>& all) {
        if (!all) return status_->showMessage(dataText(all.error().message), true);
        show(*all);
      });
}

bool OutcomesPage::cancel()
{
  if (!background_.isBusy()) return false;
  background_.cancel();
  status_->showMessage({});
  return true;
}

void OutcomesPage::show(const AllOutcomes& all)
{
  clinic_ = all.clinic;
  QStringList notes;
  for (const Sentence& each : all.notes) notes << dataText(each);
  status_->showMessage(notes.join(QLatin1Char('\n')));
  stages_->setCurrentIndex(all.clinic.ears.empty() ? 0 : 1);
  if (all.clinic.ears.empty()) return;
  showRows(all);
  showCoverage(all.clinic);
  showFigure(*depths_, all.clinic, "depths");
  showFigure(*percentiles_, all.clinic, "percentiles");
}

void OutcomesPage::showRows(const AllOutcomes& all)
{
  rows_->setRowCount(0);
  for (std::size_t k = 0; k < all.clinic.ears.size(); ++k) {
    const outcome::ScoredOutcome& ear = all.clinic.ears[k];
    const QString none = tr("–");
    addRow(*rows_,
           {nameOfPatient(all.patients[k]), arrayTitle(ear.array),
            bandWords(ear.plannedDepth_mm, 1, tr(" mm")), intervalWords(ear.depth_mm, 1, tr(" mm")),
            shareWords(ear.percentile),
            ear.angle_deg ? bandWords(ear.plannedAngle_deg, 0, tr("°")) : none,
            ear.angle_deg ? intervalWords(*ear.angle_deg, 0, tr("°")) : none,
            ear.anglePercentile ? shareWords(*ear.anglePercentile) : none, textOf(ear.stopReason)});
  }
}

void OutcomesPage::showCoverage(const outcome::ClinicOutcomes& clinic)
{
  coverage_->setRowCount(0);
  for (const outcome::ArrayOutcomes& each : clinic.arrays)
    addRow(*coverage_, {each.array.empty() ? tr("all") : arrayTitle(each.array),
                        hitsWords(each.depth.inHalf, each.depth.all, each.depth.half()),
                        hitsWords(each.depth.inNinety, each.depth.all, each.depth.ninety()),
                        hitsWords(each.angle.inHalf, each.angle.all, each.angle.half()),
                        hitsWords(each.angle.inNinety, each.angle.all, each.angle.ninety())});
}

void OutcomesPage::save()
{
  const QString file = QFileDialog::getSaveFileName(
      this, tr("Save the outcomes"), documentsFolder() + QStringLiteral("/outcomes.csv"),
      tr("Tables (*.csv)"));
  if (file.isEmpty()) return;
  const auto written = writeTable(file.toStdString(), outcome::outcomesCsv(clinic_),
                                  outcome::outcomesDictionaryCsv());
  if (!written) return status_->showMessage(dataText(written.error().message), true);
  status_->sayWritten(tr("Saved to %1.").arg(file),
                      std::filesystem::path(file.toStdString()).parent_path());
}

}  // namespace perilymph::gui
