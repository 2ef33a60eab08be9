// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/compare/ComparePage.h"

#include <QComboBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <stop_token>

#include "gui/pages/compare/ComparisonPlot.h"
#include "gui/pages/compare/GroupsTable.h"
#include "gui/pages/compare/RunsTable.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/EmptyPage.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "perilymph/charts/FigurePicture.h"
#include "perilymph/figures/Svg.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::gui {

namespace {

QLabel* text(const QString& caption, int size_px, QWidget* parent, bool isQuiet = false)
{
  auto* label = new QLabel(caption, parent);
  label->setFont(typeface(size_px));
  label->setProperty("quiet", isQuiet);
  return label;
}

/// A list of choices in a row, with its caption.
QComboBox* choice(const QString& caption, const char* name, const QStringList& texts,
                  QHBoxLayout* row, QWidget* parent)
{
  auto* label = text(caption, 13, parent, true);
  auto* box = new Selector(name, caption, parent);
  box->addItems(texts);
  label->setBuddy(box);
  row->addWidget(label);
  row->addWidget(box);
  return box;
}

using analysis::GroupKey;
/// In the order of the list of groups.
const std::vector<std::vector<GroupKey>>& groupings()
{
  static const std::vector<std::vector<GroupKey>> all = {{},
                                                         {GroupKey::array},
                                                         {GroupKey::technique},
                                                         {GroupKey::patient},
                                                         {GroupKey::friction},
                                                         {GroupKey::speed},
                                                         {GroupKey::array, GroupKey::technique}};
  return all;
}

}  // namespace

ComparePage::ComparePage(QWidget* parent)
    : Page("compare", tr("Compare"), Icon::compare, parent),
      published_(analysis::shippedReference("todd-naghdy-experiment")),
      stack_(new QStackedWidget(this)),
      empty_(new EmptyPage(
          tr("Compare insertions"),
          tr("Select two or more recordings on the Recordings page and press Compare to "
             "plot their insertion forces on common axes, with the published "
             "measurements."),
          this)),
      reading_(this)
{
  empty_->offer(tr("Choose recordings"));
  connect(empty_, &EmptyPage::actionRequested, this,
          [this] { Q_EMIT pageRequested(QStringLiteral("sessions")); });
  stack_->addWidget(empty_);
  // what does not fit on a small screen is reached by scrolling, never drawn over the rest
  stack_->addWidget(verticalScroll(addRuns(), this));
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
  save_->setToolTip(tr("Export tables, curves and events as CSV and the figure as SVG and PNG."));
  connect(save_, &QPushButton::clicked, this, &ComparePage::save);
  legend_ = text(tr("○  published measurements of this array, mean ± SD"), 11, page, true);
  auto* top = new QHBoxLayout;
  top->setSpacing(spacing);
  top->addWidget(text(tr("Insertion force"), 22, page));
  top->addSpacing(spacing);
  axis_ = choice(tr("over"), "comparisonAxis",
                 {tr("travel"), tr("insertion depth"), tr("tip angle")}, top, page);
  top->addSpacing(spacing);
  grouping_ =
      choice(tr("groups"), "comparisonGroups",
             {tr("none: each insertion"), tr("by array"), tr("by technique"), tr("by patient"),
              tr("by friction"), tr("by set speed"), tr("by array and technique")},
             top, page);
  for (QComboBox* box : {axis_, grouping_})
    connect(box, QOverload<int>::of(&QComboBox::activated), this, &ComparePage::showContent);
  connect(axis_, QOverload<int>::of(&QComboBox::activated), this, &ComparePage::placeCursor);
  top->addStretch();
  top->addWidget(save_);

  plot_ = new ComparisonPlot(page);
  if (!published_) legend_->setText(dataText(published_.error().message));
  connect(plot_, &ComparisonPlot::cursorMoved, this, &ComparePage::showCursor);
  runsTable_ = new RunsTable(page);
  connect(runsTable_, &QTableWidget::itemSelectionChanged, this, &ComparePage::showScore);
  groupsTable_ = new GroupsTable(page);
  mixed_ = text({}, 13, page);
  mixed_->setObjectName(QStringLiteral("mixedGroups"));
  mixed_->setProperty("error", true);
  mixed_->setWordWrap(true);
  method_ = text(tr("Differences of means with their 95 % intervals (Welch). %1 quantities are "
                    "compared; the intervals are not corrected for their number.")
                     .arg(analysis::comparedQuantities().size()),
                 11, page, true);
  method_->setWordWrap(true);

  score_ = text({}, 11, page, true);
  score_->setObjectName(QStringLiteral("scoreReasons"));
  score_->setWordWrap(true);
  score_->setMinimumHeight(sized(84));
  score_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  status_ = new StatusLine("comparisonStatus", page);

  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addLayout(top);
  column->addWidget(plot_, 1);
  column->addWidget(legend_);
  column->addWidget(runsTable_);
  column->addWidget(mixed_);
  column->addWidget(groupsTable_);
  column->addWidget(method_);
  column->addWidget(score_);
  column->addWidget(status_);
  return page;
}

void ComparePage::compare(const std::vector<std::filesystem::path>& files)
{
  Q_EMIT pageRequested(id());
  stack_->setCurrentIndex(0);
  empty_->offer({});
  empty_->showMessage(tr("Reading %n recording(s)…", nullptr, int(files.size())),
                      tr("Esc cancels."));
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
        empty_->showMessage(tr("Recordings cannot be compared"), dataText(runs.error().message));
      });
}

bool ComparePage::cancel()
{
  if (!isBusy()) return false;
  reading_.cancel();
  empty_->offer(tr("Choose recordings"));
  empty_->showMessage(
      tr("Canceled"),
      tr("Select two or more recordings on the Recordings page and press Compare."));
  return true;
}

void ComparePage::showRuns(std::vector<analysis::ComparedInsertion> runs)
{
  runs_ = std::move(runs);
  scores_.clear();
  for (const analysis::ComparedInsertion& each : runs_) scores_.push_back(analysis::scoreOf(each));
  runsTable_->show(runs_, scores_);
  showScore();
  showContent();
  placeCursor();
  status_->showMessage({});
  stack_->setCurrentIndex(1);
  plot_->setFocus();
}

void ComparePage::placeCursor()
{
  if (runs_.empty()) return;
  plot_->setCursorPlace(
      analysis::shownPlace(axis(), analysis::placeOf(runs_[0].arrayPeak, axis())));
}

analysis::CurveAxis ComparePage::axis() const
{
  return static_cast<analysis::CurveAxis>(axis_->currentIndex());
}

const std::vector<analysis::GroupKey>& ComparePage::keys() const
{
  return groupings()[std::size_t(grouping_->currentIndex())];
}

void ComparePage::showContent()
{
  groups_ = analysis::groupsOf(runs_, keys());
  PlottedContent content;
  content.axis = axis();
  for (std::size_t i = 0; i < groups_.size(); ++i) {
    const analysis::MeanCurve mean = analysis::meanCurve(runs_, groups_[i], axis());
    PlottedCurve curve{penOfRun(i), {}, mean.sd};
    for (std::size_t k = 0; k < mean.place.size(); ++k)
      curve.points.push_back({mean.place[k], mean.mean[k]});
    content.curves.push_back(std::move(curve));
  }
  bool isNamed = false;  // one text: the marks of several lie close together
  for (std::size_t i = 0; i < runs_.size() && groups_.empty(); ++i) {
    content.curves.push_back({penOfRun(i), analysis::curveOver(runs_[i], axis()), {}});
    const auto& rib = runs_[i].ribPeak;
    if (!rib) continue;
    content.notes.push_back(
        {analysis::placeOf(*rib, axis()), rib->force,
         isNamed ? QString() : tr("rib %1 at the opening").arg(runs_[i].ribNumber),
         penOfRun(i).color()});
    isNamed = true;
  }
  const analysis::Reference* const published = comparedWith();
  if (published != nullptr) content.published = *published;
  legend_->setVisible(published != nullptr || !published_);
  plot_->setContent(std::move(content));
  runsTable_->setVisible(groups_.empty());
  score_->setVisible(groups_.empty());
  groupsTable_->setVisible(!groups_.empty());
  method_->setVisible(groups_.size() > 1);
  showMixed();
  if (!groups_.empty()) groupsTable_->show(runs_, groups_, keys());
  showCursor();
}

void ComparePage::showMixed()
{
  QStringList lines;
  for (const analysis::InsertionGroup& group : groups_) {
    QStringList differing;
    for (const Phrase& each : analysis::differingIn(runs_, group))
      differing << dataText(Sentence(each));
    if (!differing.isEmpty())
      lines << tr("%1 mixes insertions that differ in %2.")
                   .arg(groupText(group, keys()), differing.join(QStringLiteral(", ")));
  }
  mixed_->setText(lines.join(QLatin1Char('\n')));
  mixed_->setVisible(!lines.isEmpty());
}

const analysis::Reference* ComparePage::comparedWith() const
{
  return published_ && axis() == analysis::CurveAxis::travel &&
                 analysis::areComparableWithPublished(runs_)
             ? &*published_
             : nullptr;
}

void ComparePage::showCursor()
{
  runsTable_->showCursor(runs_, axis(), plot_->cursorPlace());
  if (!groups_.empty()) groupsTable_->showCursor(runs_, groups_, axis(), plot_->cursorPlace());
}

void ComparePage::showScore()
{
  const int row = runsTable_->currentRow();
  if (row < 0 || row >= int(scores_.size())) return score_->clear();
  const auto& scored = scores_[std::size_t(row)];
  if (!scored) return score_->setText(dataText(scored.error().message));
  QStringList lines;
  lines << tr("Score of %1: insertion × peak force × geometric mean of speed, reversals and "
              "smoothness. Rates technique only; it does not assess trauma.")
               .arg(QString::fromStdString(runs_[std::size_t(row)].name));
  for (const analysis::ScoreCriterion& each : scored->criteria)
    lines << tr("%1: %2 % (%3). Criterion: %4. Source: %5.")
                 .arg(dataText(each.name), numberText(100.0 * each.fraction, 0),
                      dataText(each.found), dataText(each.band), dataText(each.source));
  score_->setText(lines.join(QLatin1Char('\n')));
}

Result<void> ComparePage::writeInto(const std::filesystem::path& folder) const
{
  const figures::Drawing figure =
      figures::draw(analysis::comparisonFigure(runs_, comparedWith(), axis(), groups_));
  std::vector<std::pair<const char*, std::string>> files = {
      {"comparison.csv", analysis::comparisonCsv(runs_)},
      {"comparison-dictionary.csv", analysis::comparisonDictionaryCsv()},
      {"curves.csv", analysis::curvesCsv(runs_, axis())},
      {"events.csv", analysis::eventsCsv(runs_)},
      {"curves.svg", figures::svg(figure)}};
  if (!groups_.empty()) {
    files.emplace_back("groups.csv", analysis::groupsCsv(runs_, groups_));
    files.emplace_back("differences.csv", analysis::differencesCsv(runs_, groups_));
  }
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
  if (!written) return status_->showMessage(dataText(written.error().message), true);
  status_->sayWritten(tr("%1 files saved to %2.").arg(groups_.empty() ? 6 : 8).arg(chosen),
                      chosen.toStdString());
}

}  // namespace perilymph::gui
