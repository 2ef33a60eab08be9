// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/validate/ValidatePage.h"

#include <QButtonGroup>
#include <QFileDialog>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/DrawingView.h"
#include "gui/widgets/StatusLine.h"
#include "gui/widgets/Theme.h"
#include "perilymph/figures/Svg.h"
#include "perilymph/foundation/AtomicFile.h"

namespace perilymph::gui {

namespace {

constexpr int columnWidth_px = 480;
constexpr int minRuns = 2;
constexpr int usualRuns = 200;  // as many as the published simulator made
constexpr int maxRuns = 1000;

QLabel* text(const QString& caption, int size_px, QWidget* parent, bool isQuiet = false)
{
  auto* label = new QLabel(caption, parent);
  label->setFont(typeface(size_px));
  label->setProperty("quiet", isQuiet);
  return label;
}

}  // namespace

ValidatePage::ValidatePage(QWidget* parent)
    : Page("validate", tr("Validate"), Icon::validate, parent), basis_(shippedBasis()), work_(this)
{
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(3 * spacing, 3 * spacing, 3 * spacing, 2 * spacing);
  row->setSpacing(3 * spacing);
  row->addWidget(addColumn());
  row->addWidget(addFigures(), 1);

  connect(
      &work_, &ValidationWork::progressed, this,
      [this](int done, int all, const validation::ValidationResult& sofar) {
        progress_->setRange(0, std::max(all, 1));
        progress_->setValue(done);
        const int runs = typedRuns().value_or(all);
        status_->showMessage(
            done <= runs
                ? tr("Insertion %1 of %2").arg(done).arg(runs)
                : tr("Causes of the spread: insertion %1 of %2").arg(done - runs).arg(all - runs));
        sofar_ = sofar;
        showFigure();
      });
  connect(&work_, &ValidationWork::finished, this, &ValidatePage::finish);
  if (!basis_) status_->showMessage(dataText(basis_.error().message), true);
  showFigure();
  showState();
}

QWidget* ValidatePage::addColumn()
{
  auto* page = new QWidget(this);
  page->setFixedWidth(sized(columnWidth_px));
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  auto* title = text(tr("Reproduce the published experiment"), 22, page);
  title->setWordWrap(true);
  column->addWidget(title);
  auto* what =
      text(tr("Simulates repeated insertions with realistic variability in start position, "
              "alignment, array curvature and friction. Their mean is compared with the "
              "published forces. One force was used to calibrate the array; the others "
              "are predictions from one choice of each constant. A mean is met within "
              "1.96 standard errors."),
           13, page, true);
  what->setWordWrap(true);
  column->addWidget(what);
  column->addSpacing(spacing);

  runs_ = new QLineEdit(QString::number(usualRuns), page);
  runs_->setObjectName(QStringLiteral("validationRuns"));
  runs_->setAccessibleName(tr("Insertions"));
  runs_->setFont(typeface(13));
  runs_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  runs_->setFixedSize(sized(88), sized(32));
  runsError_ = text(
      tr("Enter a whole number of insertions from %1 to %2.").arg(minRuns).arg(maxRuns), 11, page);
  runsError_->setObjectName(QStringLiteral("validationRunsError"));
  runsError_->setProperty("error", true);
  runsError_->hide();
  start_ = new QPushButton(page);
  start_->setObjectName(QStringLiteral("validateButton"));
  save_ = new QPushButton(tr("Save…"), page);
  save_->setObjectName(QStringLiteral("saveValidationButton"));
  save_->setToolTip(tr("Save curves as CSV, results as JSON and figures as SVG."));
  for (QPushButton* button : {start_, save_}) {
    button->setFont(typeface(13, QFont::Medium));
    button->setFixedHeight(sized(32));
  }
  start_->setProperty("primary", true);
  start_->setMinimumWidth(sized(108));
  auto* verbs = new QHBoxLayout;
  verbs->setSpacing(spacing);
  verbs->addWidget(runs_);
  verbs->addWidget(text(tr("insertions"), 13, page));
  verbs->addStretch();
  verbs->addWidget(save_);
  verbs->addWidget(start_);
  column->addLayout(verbs);
  column->addWidget(runsError_);
  progress_ = new QProgressBar(page);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(6);
  column->addWidget(progress_);
  status_ = new StatusLine("validationStatus", page);
  column->addWidget(status_);
  headline_ = text({}, 18, page);
  headline_->setObjectName(QStringLiteral("validationHeadline"));
  headline_->hide();
  column->addWidget(headline_);

  auto* inside = new QWidget(page);
  verdicts_ = new QGridLayout;
  verdicts_->setContentsMargins(0, 0, spacing, 0);
  verdicts_->setHorizontalSpacing(2 * spacing);
  verdicts_->setVerticalSpacing(6);
  auto* stack = new QVBoxLayout(inside);
  stack->setContentsMargins(0, 0, 0, 0);
  stack->addLayout(verdicts_);
  stack->addStretch();
  auto* scroll = new QScrollArea(page);
  scroll->setObjectName(QStringLiteral("verdictScroll"));
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(inside);
  column->addWidget(scroll, 1);

  connect(start_, &QPushButton::clicked, this, [this] {
    if (!cancel()) start();
  });
  connect(runs_, &QLineEdit::textChanged, this, &ValidatePage::showState);
  connect(runs_, &QLineEdit::returnPressed, this, &ValidatePage::start);
  connect(save_, &QPushButton::clicked, this, &ValidatePage::save);
  return page;
}

QWidget* ValidatePage::addFigures()
{
  auto* page = new QWidget(this);
  auto* group = new QButtonGroup(page);
  auto* choices = new QHBoxLayout;
  choices->setSpacing(3 * spacing);
  const auto add = [&](const QString& name, const char* object, Shown shown) {
    auto* choice = new Choice(name, page);
    choice->setObjectName(QLatin1String(object));
    choice->setFocusPolicy(Qt::TabFocus);
    group->addButton(choice);
    choices->addWidget(choice);
    connect(choice, &QAbstractButton::clicked, this, [this, shown] {
      shown_ = shown;
      showFigure();
    });
    return choice;
  };
  simulation_ = add(tr("Simulation"), "simulationFigure", Shown::simulation);
  difference_ = add(tr("Difference"), "differenceFigure", Shown::difference);
  experiment_ = add(tr("Experiment"), "experimentFigure", Shown::experiment);
  choices->addStretch();
  drawing_ = new DrawingView(page);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addLayout(choices);
  column->addWidget(drawing_, 1);
  return page;
}

std::optional<int> ValidatePage::typedRuns() const
{
  bool isNumber = false;
  const int typed = runs_->text().trimmed().toInt(&isNumber);
  return isNumber && typed >= minRuns && typed <= maxRuns ? std::optional(typed) : std::nullopt;
}

void ValidatePage::start()
{
  const auto runs = typedRuns();
  if (isBusy() || !basis_ || !runs) return;
  validation::ValidationRequest request = basis_->request;
  request.runs = *runs;
  result_.reset();
  sofar_ = {};
  shown_ = Shown::simulation;
  status_->showMessage(tr("Building the cochlea…"));
  work_.start(std::move(request));
  showVerdicts();
  showFigure();
  showState();
}

bool ValidatePage::cancel()
{
  if (!isBusy()) return false;
  work_.cancel();
  status_->showMessage(tr("Stopping…"));
  return true;
}

void ValidatePage::finish(const std::optional<validation::ValidationResult>& result,
                          const QString& error)
{
  result_ = result;
  sofar_ = result.value_or(validation::ValidationResult{});
  if (result) {
    progress_->setValue(progress_->maximum());
    status_->showMessage(tr("%1 of %2 insertions completed, seed %3. Mean SD over travel %4 mN.")
                             .arg(result->runs - static_cast<int>(result->incomplete.size()))
                             .arg(result->runs)
                             .arg(result->seed)
                             .arg(numberText(1e3 * result->standardDeviation, 1)));
  } else {
    status_->showMessage(error);
    progress_->reset();
  }
  showVerdicts();
  showFigure();
  showState();
}

void ValidatePage::showFigure()
{
  if (!basis_) return;
  simulation_->setEnabled(sofar_.profile.size() > 1);
  difference_->setEnabled(result_.has_value());
  Shown shown = shown_;
  if (shown == Shown::difference && !result_) shown = Shown::simulation;
  if (shown == Shown::simulation && sofar_.profile.empty()) shown = Shown::experiment;
  (shown == Shown::simulation   ? simulation_
   : shown == Shown::difference ? difference_
                                : experiment_)
      ->setChecked(true);
  const analysis::Reference& experiment = basis_->request.experiment;
  drawing_->show(figures::draw(
      translated(shown == Shown::simulation ? validation::simulationFigure(sofar_, experiment)
                 : shown == Shown::difference
                     ? validation::differenceFigure(*result_, basis_->references.difference)
                     : validation::experimentFigure(experiment, basis_->references.simulator))));
}

void ValidatePage::showState()
{
  start_->setText(isBusy() ? tr("Cancel") : tr("Run"));
  start_->setEnabled(isBusy() || (bool(basis_) && typedRuns()));
  runsError_->setVisible(!typedRuns());
  runs_->setEnabled(!isBusy());
  save_->setEnabled(result_.has_value());
}

void ValidatePage::showVerdicts()
{
  while (QLayoutItem* item = verdicts_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  headline_->setVisible(result_.has_value());
  if (!result_) return;
  const auto verdicts = validation::verdictsOf(*result_, basis_->request.experiment);
  const auto met = std::count_if(verdicts.begin(), verdicts.end(),
                                 [](const validation::Verdict& verdict) { return verdict.isMet; });
  headline_->setText(tr("%1 of %2 criteria met").arg(met).arg(verdicts.size()));
  int line = 0;
  for (const validation::Verdict& verdict : verdicts) {
    // a text in addition to the color
    auto* mark = text(verdict.isMet ? tr("✓ met") : tr("✗ missed"), 13, this);
    mark->setStyleSheet(
        QStringLiteral("color: %1;")
            .arg((verdict.isMet ? shownTheme().accent : shownTheme().warning).name()));
    auto* what = text(dataText(verdict.what), 13, this);
    what->setWordWrap(true);
    auto* found = text(dataText(verdict.found), 13, this);
    found->setAlignment(Qt::AlignRight | Qt::AlignTop);
    auto* wanted = text(dataText(verdict.wanted), 11, this, true);
    wanted->setWordWrap(true);
    verdicts_->addWidget(mark, line, 0, Qt::AlignTop);
    verdicts_->addWidget(what, line, 1);
    verdicts_->addWidget(found, line, 2);
    verdicts_->addWidget(wanted, ++line, 1, 1, 2);
    ++line;
  }
  verdicts_->setColumnStretch(1, 1);
}

void ValidatePage::save()
{
  if (!result_) return;
  const QString chosen =
      QFileDialog::getExistingDirectory(this, tr("Save to folder"), documentsFolder());
  if (chosen.isEmpty()) return;
  const std::filesystem::path folder = chosen.toStdString();
  const validation::ValidationFiles files =
      validation::validationFiles(basis_->request, *result_, basis_->references);
  const auto keep = [&](const std::string& name, const std::string& content) {
    const auto written = writeWhole(folder / name, content, {Links::refused});
    if (!written) status_->showMessage(dataText(written.error().message), true);
    return bool(written);
  };
  for (const auto& [name, content] : files.texts)
    if (!keep(name, content)) return;
  for (const auto& [name, figure] : files.figures)
    if (!keep(name + ".svg", figures::svg(figure))) return;
  const auto saved = int(files.texts.size() + files.figures.size());
  status_->sayWritten(tr("%n file(s) saved to %1.", nullptr, saved).arg(chosen), folder);
}

}  // namespace perilymph::gui
