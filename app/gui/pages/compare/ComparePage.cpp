// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/compare/ComparePage.h"

#include <QDateTime>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QPushButton>
#include <QStackedWidget>
#include <QTableWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <stop_token>

#include "gui/pages/compare/ComparisonPlot.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/EmptyPage.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "perilymph/anatomy/Patient.h"
#include "perilymph/charts/FigurePicture.h"
#include "perilymph/figures/Svg.h"
#include "perilymph/foundation/AtomicFile.h"
#include "perilymph/session/ScenarioChoices.h"

namespace perilymph::gui {

namespace {

enum Column {
  run,
  atCursor,
  peak,
  peakDepth,
  work,
  reversals,
  duration,
  angle,
  translocation,
  score,
  columns
};

constexpr int rowHeight_px = 44;  // two lines
constexpr int swatchWidth_px = 36;

QLabel* text(const QString& caption, int size_px, QWidget* parent, bool isQuiet = false)
{
  auto* label = new QLabel(caption, parent);
  label->setFont(typeface(size_px));
  label->setProperty("quiet", isQuiet);
  return label;
}

/// "left", "right", or a dash for a recording that does not say.
QString sideText(const std::string& name)
{
  const auto side = valueIn(anatomy::sides, name);
  if (!side) return QStringLiteral("–");
  return *side == anatomy::Side::left ? ComparePage::tr("left") : ComparePage::tr("right");
}

/// "FLEX28 · standard", and below it patient, ear and time.
QString titleOf(const analysis::ComparedInsertion& insertion)
{
  const session::ScenarioSubject& subject = insertion.subject;
  const QString own = subject.technique == session::nameOf(session::Technique::advanceOffStylet)
                          ? ComparePage::tr("advance off stylet")
                          : ComparePage::tr("standard");
  const QString technique =
      insertion.check.damage.empty() ? own : ComparePage::tr("%1 · changed by hand").arg(own);
  const auto utc = QDateTime::fromString(QString::fromStdString(insertion.startedUtc), Qt::ISODate);
  return ComparePage::tr("%1 · %2\n%3 · %4 ear · %5")
      .arg(QString::fromStdString(subject.array), technique,
           QString::fromStdString(subject.patient), sideText(subject.side),
           utc.toLocalTime().toString(QStringLiteral("yyyy-MM-dd HH:mm")));
}

/// "3.2 mm" of the array in the scala vestibuli, "rupture at 210°" without it; a dash if the partition
/// held.
QString translocationText(const analysis::ComparedInsertion& each)
{
  if (!each.translocation) return ComparePage::tr("–");
  const double above_mm = inMillimeters(meters(each.translocation->lengthAbove));
  if (above_mm > 0.0) return ComparePage::tr("%1 mm").arg(numberText(above_mm, 1));
  return ComparePage::tr("rupture at %1°")
      .arg(numberText(inDegrees(radians(each.translocation->angle)), 0));
}

QPixmap swatch(std::size_t number)
{
  constexpr int fineness = 2;
  QPixmap pixmap(fineness * swatchWidth_px, fineness * 12);
  pixmap.setDevicePixelRatio(fineness);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setPen(penOfRun(number));
  painter.drawLine(QPointF(0, 6), QPointF(swatchWidth_px, 6));
  return pixmap;
}

}  // namespace

ComparePage::ComparePage(QWidget* parent)
    : Page("compare", tr("Compare"), Icon::compare, parent),
      published_(analysis::shippedReference("todd-naghdy-experiment")),
      stack_(new QStackedWidget(this)),
      empty_(new EmptyPage(
          tr("Compare insertions"),
          tr("Select two or more recordings on the Sessions page and press Compare to "
             "plot their insertion forces on common axes, with the published "
             "measurements."),
          this)),
      reading_(this)
{
  empty_->offer(tr("Choose recordings"));
  connect(empty_, &EmptyPage::actionAsked, this,
          [this] { Q_EMIT pageRequested(QStringLiteral("sessions")); });
  stack_->addWidget(empty_);
  stack_->addWidget(addRuns());
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * spacing, 3 * spacing, 3 * spacing, 2 * spacing);
  column->addWidget(stack_);
}

QWidget* ComparePage::addRuns()
{
  auto* page = new QWidget(this);
  save_ = new QPushButton(tr("Export…"), page);
  save_->setObjectName(QStringLiteral("exportButton"));
  save_->setFont(typeface(13, QFont::Medium));
  save_->setFixedHeight(sized(32));
  save_->setToolTip(tr("Export table and curves as CSV and the figure as SVG and PNG."));
  connect(save_, &QPushButton::clicked, this, &ComparePage::save);
  legend_ = text(tr("○  published measurements, mean ± SD"), 11, page, true);
  auto* top = new QHBoxLayout;
  top->setSpacing(2 * spacing);
  top->addWidget(text(tr("Insertion force over travel"), 22, page));
  top->addWidget(legend_, 0, Qt::AlignBottom);
  top->addStretch();
  top->addWidget(save_);

  plot_ = new ComparisonPlot(page);
  if (!published_) legend_->setText(dataText(published_.error().message));
  connect(plot_, &ComparisonPlot::cursorMoved, this, &ComparePage::showCursor);

  table_ = new QTableWidget(0, columns, page);
  table_->setObjectName(QStringLiteral("comparisonTable"));
  table_->setAccessibleName(tr("Results"));
  table_->setFont(typeface(13));
  table_->setShowGrid(false);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setIconSize({swatchWidth_px, 12});
  table_->setWordWrap(false);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(sized(rowHeight_px));
  table_->horizontalHeader()->setFont(typeface(11));
  table_->horizontalHeader()->setHighlightSections(false);
  table_->setHorizontalHeaderLabels(
      {tr("Insertion"), tr("At cursor"), tr("Peak force"), tr("at depth"), tr("Insertion work"),
       tr("Reversals"), tr("Time"), tr("Tip angle"), tr("Translocation"), tr("Score")});
  const int widths_px[] = {200, 104, 96, 88, 120, 84, 76, 100, 112, 96};
  for (int column = 0; column < columns; ++column) {
    table_->horizontalHeader()->resizeSection(column, widths_px[column]);
    table_->horizontalHeaderItem(column)->setTextAlignment(
        int(column == run ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
  }
  table_->horizontalHeader()->setSectionResizeMode(run, QHeaderView::Stretch);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &ComparePage::showScore);

  score_ = text({}, 11, page, true);
  score_->setObjectName(QStringLiteral("scoreReasons"));
  score_->setWordWrap(true);
  score_->setMinimumHeight(84);
  score_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  status_ = new StatusLine("comparisonStatus", page);

  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addLayout(top);
  column->addWidget(plot_, 1);
  column->addWidget(table_);
  column->addWidget(score_);
  column->addWidget(status_);
  return page;
}

void ComparePage::compare(const std::vector<std::filesystem::path>& files)
{
  Q_EMIT pageRequested(id());
  stack_->setCurrentIndex(0);
  empty_->offer({});
  empty_->say(tr("Reading %n recording(s)…", nullptr, int(files.size())), tr("Esc cancels."));
  reading_.run(
      "The comparison",
      [files](const std::stop_token& stop) -> Result<std::vector<analysis::ComparedInsertion>> {
        std::vector<analysis::ComparedInsertion> runs;
        for (const std::filesystem::path& file : files) {
          auto read = analysis::readCompared(file, stop);
          if (!read) return read.error();
          runs.push_back(*std::move(read));
        }
        analysis::tellApart(runs);
        return runs;
      },
      [this](Result<std::vector<analysis::ComparedInsertion>> runs) {
        if (runs) return showRuns(*std::move(runs));
        empty_->offer(tr("Choose recordings"));
        empty_->say(tr("Recordings cannot be compared"), dataText(runs.error().message));
      });
}

bool ComparePage::cancel()
{
  if (!isBusy()) return false;
  reading_.forget();
  empty_->offer(tr("Choose recordings"));
  empty_->say(tr("Canceled"),
              tr("Select two or more recordings on the Sessions page and press Compare."));
  return true;
}

void ComparePage::showRuns(std::vector<analysis::ComparedInsertion> runs)
{
  runs_ = std::move(runs);
  scores_.clear();
  for (const analysis::ComparedInsertion& each : runs_) scores_.push_back(analysis::scoreOf(each));
  plot_->setRuns(runs_);
  const analysis::Reference* const published = comparedWith();
  plot_->setPublished(published != nullptr ? std::optional(*published) : std::nullopt);
  legend_->setVisible(published != nullptr || !published_);
  // initially at the peak of the first one
  if (!runs_.empty()) plot_->setCursor_mm(inMillimeters(meters(runs_[0].profile.peak.travel)));
  fillTable();
  showCursor();
  status_->say({});
  stack_->setCurrentIndex(1);
  plot_->setFocus();
}

const analysis::Reference* ComparePage::comparedWith() const
{
  return published_ && analysis::areComparableWithPublished(runs_) ? &*published_ : nullptr;
}

void ComparePage::fillTable()
{
  table_->setRowCount(int(runs_.size()));
  for (int row = 0; row < int(runs_.size()); ++row) {
    const analysis::ComparedInsertion& each = runs_[std::size_t(row)];
    const analysis::ForceProfile& profile = each.profile;
    const auto& scored = scores_[std::size_t(row)];
    const std::pair<int, QString> cells[] = {
        {run, titleOf(each)},
        {peak, tr("%1 mN").arg(forceNumber(inMillinewtons(newtons(profile.peak.force))))},
        {peakDepth, tr("%1 mm").arg(numberText(inMillimeters(meters(profile.peakDepth)), 1))},
        {work, tr("%1 mJ").arg(numberText(profile.work * 1e3, 3))},
        {reversals, QString::number(each.reversals)},
        {duration, tr("%1 s").arg(numberText(profile.duration, 1))},
        {angle, tr("%1°").arg(numberText(inDegrees(radians(profile.deepestAngle)), 0))},
        {translocation, translocationText(each)},
        {score, scored ? tr("%1 of 100").arg(numberText(scored->total, 0)) : tr("none")},
        {atCursor, QString()}};
    for (const auto& [column, caption] : cells) {
      auto* item = new QTableWidgetItem(caption);
      item->setTextAlignment(int(column == run ? Qt::AlignLeft : Qt::AlignRight) |
                             Qt::AlignVCenter);
      if (column == run) {
        item->setIcon(QIcon(swatch(std::size_t(row))));
        item->setToolTip(QString::fromStdString(each.name));
      }
      if (column == score)
        item->setToolTip(scored ? QString::fromStdString(scored->sentence())
                                : dataText(scored.error().message));
      table_->setItem(row, column, item);
    }
  }
  const auto isTorn = [](const analysis::ComparedInsertion& each) {
    return each.translocation.has_value();
  };
  table_->setColumnHidden(translocation, std::ranges::none_of(runs_, isTorn));
  // height of its rows, up to five
  constexpr int maxColumns = 5;
  const int rows = std::min(maxColumns, std::max(1, int(runs_.size())));
  table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                         rows * sized(rowHeight_px) + 2 * table_->frameWidth() + 2);
  table_->selectRow(0);
  showScore();
}

void ComparePage::showCursor()
{
  const double travel = millimeters(plot_->cursor_mm()).si();
  for (int row = 0; row < int(runs_.size()) && row < table_->rowCount(); ++row) {
    const auto force = analysis::forceAt(runs_[std::size_t(row)].profile.curve, travel);
    table_->item(row, atCursor)
        ->setText(force ? tr("%1 mN").arg(numberText(inMillinewtons(newtons(*force)), 1))
                        : tr("–"));
  }
  if (auto* header = table_->horizontalHeaderItem(atCursor))
    header->setText(tr("At %1 mm").arg(numberText(plot_->cursor_mm(), 1)));
}

void ComparePage::showScore()
{
  const int row = table_->currentRow();
  if (row < 0 || row >= int(scores_.size())) return score_->clear();
  const auto& scored = scores_[std::size_t(row)];
  if (!scored) return score_->setText(dataText(scored.error().message));
  QStringList lines;
  lines << tr("Score of %1. Rates technique only; it does not assess trauma.")
               .arg(QString::fromStdString(runs_[std::size_t(row)].name));
  for (const analysis::ScoreCriterion& each : scored->criteria)
    lines << tr("%1: %2 % (%3). Criterion: %4. Source: %5.")
                 .arg(dataText(each.name), numberText(100.0 * each.fraction, 0),
                      dataText(each.found), dataText(each.band), dataText(each.source));
  score_->setText(lines.join(QLatin1Char('\n')));
}

Result<Done> ComparePage::writeInto(const std::filesystem::path& folder) const
{
  const figures::Drawing figure = figures::draw(analysis::comparisonFigure(runs_, comparedWith()));
  const std::pair<const char*, std::string> files[] = {
      {"comparison.csv", analysis::comparisonCsv(runs_)},
      {"curves.csv", analysis::curvesCsv(runs_)},
      {"curves.svg", figures::svg(figure)}};
  for (const auto& [name, content] : files)
    if (const auto written = writeWhole(folder / name, content, {Links::refused}); !written)
      return written;
  return charts::writePicture(figure, folder / "curves.png");
}

void ComparePage::save()
{
  const QString chosen =
      QFileDialog::getExistingDirectory(this, tr("Export to folder"), documentsFolder());
  if (chosen.isEmpty()) return;
  const auto written = writeInto(chosen.toStdString());
  if (!written) return status_->say(dataText(written.error().message), true);
  status_->sayWritten(tr("4 files saved to %1.").arg(chosen), chosen.toStdString());
}

}  // namespace perilymph::gui
