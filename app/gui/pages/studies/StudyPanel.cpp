// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/studies/StudyPanel.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "gui/pages/studies/StudyText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

constexpr int panelWidth_px = 264;

/// Selects a value, or the first one that a study has.
void select(Selector& list, const QString& wanted, const QString& usual)
{
  const int index = std::max({0, list.findData(usual), list.findData(wanted)});
  const int chosen = list.findData(wanted) >= 0 ? list.findData(wanted) : index;
  list.show(list.itemData(chosen).toString(), {});
}

}  // namespace

StudyPanel::StudyPanel(QWidget* parent)
    : QWidget(parent),
      x_(new Selector("studyX", tr("Horizontal axis"), this)),
      y_(new Selector("studyY", tr("Vertical axis"), this)),
      group_(new Selector("studyGroup", tr("Color by"), this)),
      selection_(new Selector("studySelection", tr("Statistics of"), this))
{
  setFixedWidth(sized(panelWidth_px));
  auto* content = new QWidget(this);
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(2 * spacing, 2 * spacing, 2 * spacing, 2 * spacing);
  column->setSpacing(spacing);
  auto* make = panelButton(tr("New study…"), "newStudyButton", content);
  connect(make, &QPushButton::clicked, this, &StudyPanel::newRequested);
  column->addWidget(make);
  auto* open = panelButton(tr("Open study…"), "openStudyButton", content);
  open->setToolTip(tr("study.sqlite, or a shard, as 'perilymph-cli study' writes them"));
  connect(open, &QPushButton::clicked, this, &StudyPanel::openRequested);
  column->addWidget(open);
  addAxes(*column);
  addSize(*column);
  filters_ = new QVBoxLayout;
  column->addLayout(filters_);
  auto* all = panelButton(tr("Show all"), "resetStudyFilterButton", content);
  connect(all, &QPushButton::clicked, this, &StudyPanel::reset);
  column->addWidget(all);
  column->addStretch();
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->addWidget(verticalScroll(content, this));
}

void StudyPanel::addAxes(QVBoxLayout& column)
{
  for (const auto& [list, title] : {std::pair{y_, tr("VERTICAL")}, std::pair{x_, tr("HORIZONTAL")},
                                    std::pair{group_, tr("COLOR BY")}}) {
    column.addWidget(panelHeading(title, this));
    column.addWidget(list);
    connect(list, &Selector::chosen, this, &StudyPanel::axesChanged);
  }
  column.addWidget(panelHeading(tr("STATISTICS OF"), this));
  column.addWidget(selection_);
  for (const study::StudySelection each : study::studySelections)
    selection_->addChoice(inTheList(selectionText(each)), QLatin1String(study::nameOf(each)));
  connect(selection_, &Selector::chosen, this, &StudyPanel::selectionChanged);
}

study::StudySelection StudyPanel::selection() const
{
  return selection_->currentIndex() == 0 ? study::studySelections.front()
                                         : study::studySelections.back();
}

QLineEdit* StudyPanel::addLimit(const char* name, const QString& title)
{
  auto* field = new QLineEdit(this);
  field->setObjectName(QLatin1String(name));
  field->setAccessibleName(title);
  field->setPlaceholderText(title);
  field->setFont(typeface(13));
  field->setFixedHeight(sized(28));
  field->setMaxLength(8);
  connect(field, &QLineEdit::textChanged, this, &StudyPanel::filterChanged);
  return field;
}

void StudyPanel::addSize(QVBoxLayout& column)
{
  column.addWidget(panelHeading(tr("COCHLEAR SIZE: A, MM"), this));
  auto* row = new QHBoxLayout;
  row->setSpacing(spacing);
  row->addWidget(minA_ = addLimit("studyMinA", tr("from")));
  row->addWidget(maxA_ = addLimit("studyMaxA", tr("to")));
  column.addLayout(row);
}

void StudyPanel::offer(const study::StudyColumns& columns)
{
  StudyPlot::Axes before = axes();
  if (group_->count() == 0) before.group = "array";
  for (Selector* list : {x_, y_, group_}) list->clear();
  for (const study::StudyQuantity& each : columns.quantities())
    for (Selector* list : {x_, y_})
      list->addChoice(inTheList(quantityTitle(each.key)), QString::fromStdString(each.key));
  group_->addChoice(inTheList(tr("nothing")), QString());
  for (const study::StudyFactor& each : columns.factors())
    group_->addChoice(inTheList(settingTitle(each.key)), QString::fromStdString(each.key));
  select(*x_, QString::fromStdString(before.x), QStringLiteral("A_mm"));
  select(*y_, QString::fromStdString(before.y), QStringLiteral("angle_deg"));
  select(*group_, QString::fromStdString(before.group), QStringLiteral("array"));
  {
    const QSignalBlocker quiet(this);  // the caller shows the study's rows
    minA_->clear();
    maxA_->clear();
  }
  offerFilters(columns);
}

void StudyPanel::offerFilters(const study::StudyColumns& columns)
{
  delete boxesOfStudy_;
  boxes_.clear();
  boxesOfStudy_ = new QWidget(this);
  auto* column = new QVBoxLayout(boxesOfStudy_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  for (const study::StudyFactor& factor : columns.factors()) {
    column->addSpacing(spacing);
    column->addWidget(panelHeading(settingTitle(factor.key).toUpper(), boxesOfStudy_));
    boxes_.emplace_back();
    for (std::size_t i = 0; i < factor.levels.size(); ++i) {
      auto* box = new CheckBox(inTheList(valueText(factor.key, factor.levels[i])), boxesOfStudy_);
      box->setObjectName(
          QStringLiteral("study-%1-%2")
              .arg(QString::fromStdString(factor.key), QString::fromStdString(factor.levels[i])));
      box->setChecked(true);
      column->addWidget(box);
      boxes_.back().push_back(box);
      connect(box, &QAbstractButton::toggled, this, &StudyPanel::filterChanged);
    }
  }
  filters_->addWidget(boxesOfStudy_);
}

StudyPlot::Axes StudyPanel::axes() const
{
  return {x_->value().toStdString(), y_->value().toStdString(), group_->value().toStdString()};
}

study::StudyFilter StudyPanel::filter() const
{
  study::StudyFilter filter;
  for (const auto& boxes : boxes_) {
    filter.levels.emplace_back();
    for (const CheckBox* box : boxes) filter.levels.back().push_back(box->isChecked());
  }
  filter.minA_mm = typedNumber(minA_->text()).value_or(filter.minA_mm);
  filter.maxA_mm = typedNumber(maxA_->text()).value_or(filter.maxA_mm);
  return filter;
}

QString StudyPanel::problem() const
{
  for (const QLineEdit* each : {minA_, maxA_})
    if (!each->text().trimmed().isEmpty() && !typedNumber(each->text()))
      return tr("Cochlear size, %1: “%2” is no number and limits nothing. Enter millimeters, or "
                "empty the field.")
          .arg(each->accessibleName(), each->text());
  const study::StudyFilter limits = filter();
  if (limits.minA_mm > limits.maxA_mm)
    return tr("Cochlear size: from %1 to %2 holds no insertion. Exchange the limits.")
        .arg(minA_->text(), maxA_->text());
  return {};
}

void StudyPanel::reset()
{
  {
    const QSignalBlocker quiet(this);
    for (const auto& boxes : boxes_)
      for (CheckBox* box : boxes) box->setChecked(true);
    minA_->clear();
    maxA_->clear();
  }
  Q_EMIT filterChanged();
}

}  // namespace perilymph::gui
