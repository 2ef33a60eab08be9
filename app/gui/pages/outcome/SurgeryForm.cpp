// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/outcome/SurgeryForm.h"

#include <QDate>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "gui/setup/Catalog.h"
#include "gui/setup/OutcomeWords.h"
#include "gui/setup/Section.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/foundation/Resources.h"

namespace perilymph::gui {

namespace {

constexpr int field_px = 118, widestField_px = 150, row_px = 26, unit_px = 24;

/// "2026-11-20" or "20.11.2026"; invalid for another text and for a day to come.
QDate dayIn(const QString& text)
{
  QDate day = QDate::fromString(text, Qt::ISODate);
  if (!day.isValid()) day = QDate::fromString(text, QStringLiteral("d.M.yyyy"));
  return day <= QDate::currentDate() ? day : QDate();
}

}  // namespace

SurgeryForm::SurgeryForm(QWidget* parent)
    : QWidget(parent),
      more_(new Section(tr("More that you know"), "surgeryMore", this)),
      array_(new Selector("surgeryArray", tr("Implanted array"), this)),
      stopReason_(new Selector("surgeryStopReason", tr("Stopped because"), this)),
      markReached_(new Selector("surgeryMarkReached", tr("Mark reached"), this)),
      opening_(new Selector("surgeryOpening", tr("Opening"), this)),
      tool_(new Selector("surgeryTool", tr("Tool"), this)),
      error_(new WrappedLabel({}, this))
{
  setObjectName(QStringLiteral("surgeryForm"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  array_->addChoice(tr("Choose the array"), QString());
  QString maker;
  for (const CatalogArray& each : catalogArrays()) {
    if (each.maker != maker) array_->addHeading(maker = each.maker);
    array_->addChoice(each.title + QStringLiteral(" · ") + each.summary, each.name, each.note);
  }
  column->addWidget(array_);
  addUsual(*column);
  column->addWidget(more_);
  addOthers();
  more_->setFolded(true);
  error_->setObjectName(QStringLiteral("surgeryError"));
  error_->setFont(typeface(12));
  error_->setProperty("error", true);
  column->addWidget(error_);
  connect(array_, &Selector::chosen, this, [this] {
    isArrayChosen_ = true;
    readDesign();
    showError();
    Q_EMIT changed();
  });
  for (Selector* each : {stopReason_, markReached_, opening_, tool_})
    connect(each, &Selector::chosen, this, &SurgeryForm::changed);
  showError();
}

QWidget* SurgeryForm::addRow(QVBoxLayout& column, const QString& name, QWidget* field,
                             const QString& unit)
{
  auto* line = new QWidget(this);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  auto* title = new WrappedLabel(name, line);
  title->setFont(typeface(12));
  auto* suffix = new QLabel(unit, line);
  suffix->setFont(typeface(11));
  suffix->setProperty("quiet", true);
  // all rows have the room that their longest short text needs, in every language
  suffix->setFixedWidth(
      std::max(sized(unit_px), suffix->fontMetrics().horizontalAdvance(tr("mm")) + 2));
  field->setFont(typeface(12));
  field->setFixedSize(std::clamp(std::max(markReached_->widest_px(), stopReason_->widest_px()),
                                 sized(field_px), sized(widestField_px)),
                      sized(row_px));
  row->addWidget(title, 1);
  row->addWidget(field);
  row->addWidget(suffix);
  column.addWidget(line);
  return line;
}

QLineEdit* SurgeryForm::addEdit(QVBoxLayout& column, const char* object, const QString& name,
                                const QString& unit)
{
  auto* edit = new QLineEdit(this);
  edit->setObjectName(QLatin1String(object));
  edit->setAccessibleName(unit.isEmpty() ? name : QStringLiteral("%1, %2").arg(name, unit));
  edit->setPlaceholderText(tr("not known"));
  addRow(column, name, edit, unit);
  connect(edit, &QLineEdit::textChanged, this, [this] {
    showError();
    if (!isShowing_) Q_EMIT changed();
  });
  return edit;
}

void SurgeryForm::addNumber(QVBoxLayout& column, const char* object, const QString& name,
                            const QString& unit, std::optional<Length> outcome::Surgery::*value)
{
  numbers_.push_back(
      {name, addEdit(column, object, name, unit),
       [value](outcome::Surgery& surgery, double typed) { surgery.*value = millimeters(typed); },
       [value](const outcome::Surgery& surgery) {
         return surgery.*value ? numberText(inMillimeters(*(surgery.*value)), 1) : QString();
       },
       false});
}

void SurgeryForm::addNumber(QVBoxLayout& column, const char* object, const QString& name,
                            const QString& unit, std::optional<double> outcome::Surgery::*value)
{
  numbers_.push_back({name, addEdit(column, object, name, unit),
                      [value](outcome::Surgery& surgery, double typed) { surgery.*value = typed; },
                      [value](const outcome::Surgery& surgery) {
                        return surgery.*value ? numberText(*(surgery.*value), 1) : QString();
                      },
                      false});
}

void SurgeryForm::addNumber(QVBoxLayout& column, const char* object, const QString& name,
                            std::optional<int> outcome::Surgery::*value)
{
  numbers_.push_back(
      {name, addEdit(column, object, name, {}),
       [value](outcome::Surgery& surgery, double typed) { surgery.*value = int(typed); },
       [value](const outcome::Surgery& surgery) {
         return surgery.*value ? QString::number(*(surgery.*value)) : QString();
       },
       true});
}

void SurgeryForm::addUsual(QVBoxLayout& column)
{
  markReached_->setFont(typeface(12));  // its width is that of all fields
  markReached_->addChoice(tr("not known"), QString());
  markReached_->addChoice(tr("yes"), QStringLiteral("yes"));
  markReached_->addChoice(tr("no"), QStringLiteral("no"));
  for (const auto& each : outcome::stopReasons)
    stopReason_->addChoice(textOf(each.value), QLatin1String(each.name));
  stopReason_->setFont(typeface(12));
  stopReason_->setToolTip(
      tr("Why the array was not pushed further. A stop by resistance is what a plan predicts."));
  addRow(column, tr("Stopped because of"), stopReason_);
  addRow(column, tr("Intended mark reached"), markReached_);
  addNumber(column, "surgeryIntendedDepth", tr("Intended depth"), tr("mm"),
            &outcome::Surgery::intendedDepth);
  addNumber(column, "surgeryContactsOutside", tr("Contacts outside"),
            &outcome::Surgery::contactsOutside);
  ctDay_ = addEdit(column, "surgeryCtDay", tr("Day of the CT"), {});
  ctDay_->setToolTip(tr(
      "As the images state it; type it where they state none. With the days from surgery it tells "
      "which plans were made before surgery."));
  addNumber(column, "surgeryDaysToCt", tr("Days from surgery to CT"), &outcome::Surgery::daysToCt);
}

void SurgeryForm::addOthers()
{
  QVBoxLayout& column = more_->rows();
  column.setSpacing(4);
  for (const auto& each : outcome::openings)
    opening_->addChoice(textOf(each.value), QLatin1String(each.name));
  addRow(column, tr("Opening"), opening_);
  for (const auto& each : outcome::tools)
    tool_->addChoice(textOf(each.value), QLatin1String(each.name));
  addRow(column, tr("Tool"), tool_);
  lubricant_ = addEdit(column, "surgeryLubricant", tr("Lubricant"), {});
  lot_ = addEdit(column, "surgeryLot", tr("Lot of the array"), {});
  addNumber(column, "surgeryIntendedContacts", tr("Contacts intended inside"),
            &outcome::Surgery::intendedContacts);
  addNumber(column, "surgeryOutside", tr("Length outside"), tr("mm"), &outcome::Surgery::outside);
  addNumber(column, "surgeryContactAtResistance", tr("Contact at first resistance"),
            &outcome::Surgery::contactAtResistance);
  addNumber(column, "surgeryAttempts", tr("Attempts"), &outcome::Surgery::attempts);
  addNumber(column, "surgeryPullBacks", tr("Pull-backs"), &outcome::Surgery::pullBacks);
  addNumber(column, "surgeryTilt", tr("Tilt of the approach"), tr("°"),
            &outcome::Surgery::tilt_deg);
  addNumber(column, "surgeryTurn", tr("Turn of the approach"), tr("°"),
            &outcome::Surgery::turn_deg);
}

outcome::Surgery SurgeryForm::surgery() const
{
  outcome::Surgery surgery;
  surgery.array = array_->value().toStdString();
  const auto name = [](const Selector& list) { return list.value().toStdString(); };
  surgery.stopReason =
      valueIn(outcome::stopReasons, name(*stopReason_)).value_or(outcome::StopReason::unknown);
  surgery.opening = valueIn(outcome::openings, name(*opening_)).value_or(outcome::Opening::unknown);
  surgery.tool = valueIn(outcome::tools, name(*tool_)).value_or(outcome::Tool::unknown);
  if (!markReached_->value().isEmpty())
    surgery.isMarkReached = markReached_->value() == QLatin1String("yes");
  surgery.lubricant = lubricant_->text().trimmed().toStdString();
  surgery.lot = lot_->text().trimmed().toStdString();
  for (const Field& each : numbers_) {
    const auto typed = typedNumber(each.edit->text());
    if (typed && (!each.isWhole || *typed == std::floor(*typed))) each.set(surgery, *typed);
  }
  return surgery;
}

void SurgeryForm::setSurgery(const outcome::Surgery& surgery)
{
  isShowing_ = true;
  isArrayChosen_ = !surgery.array.empty();
  array_->show(QString::fromStdString(surgery.array), QString::fromStdString(surgery.array));
  stopReason_->show(QLatin1String(nameIn(outcome::stopReasons, surgery.stopReason)), {});
  opening_->show(QLatin1String(nameIn(outcome::openings, surgery.opening)), {});
  tool_->show(QLatin1String(nameIn(outcome::tools, surgery.tool)), {});
  markReached_->show(!surgery.isMarkReached   ? QString()
                     : *surgery.isMarkReached ? QStringLiteral("yes")
                                              : QStringLiteral("no"),
                     {});
  lubricant_->setText(QString::fromStdString(surgery.lubricant));
  lot_->setText(QString::fromStdString(surgery.lot));
  for (const Field& each : numbers_) each.edit->setText(each.text(surgery));
  isShowing_ = false;
  readDesign();
  showError();
  Q_EMIT changed();
}

bool SurgeryForm::hasAnswers() const
{
  outcome::Surgery answered = surgery();
  answered.array.clear();
  return answered != outcome::Surgery{};
}

std::string SurgeryForm::ctDay() const
{
  return dayIn(ctDay_->text().trimmed()).toString(Qt::ISODate).toStdString();
}

void SurgeryForm::setCtDay(const std::string& day)
{
  isShowing_ = true;
  ctDay_->setText(QString::fromStdString(day));
  isShowing_ = false;
}

void SurgeryForm::proposeArray(const std::string& array)
{
  const QString name = QString::fromStdString(array);
  if (isArrayChosen_ || array_->findData(name) < 0) return;
  array_->show(name, {});
  readDesign();
  showError();
  Q_EMIT changed();
}

QString SurgeryForm::error() const
{
  for (const Field& each : numbers_) {
    const QString text = each.edit->text().trimmed();
    if (text.isEmpty()) continue;
    const auto typed = typedNumber(text);
    if (!typed)
      return tr("%1 is “%2”, which is not a number; leave it empty if it is not known.")
          .arg(each.name, text);
    if (each.isWhole && *typed != std::floor(*typed))
      return tr("%1 is %2; a whole number is expected.").arg(each.name, text);
  }
  if (const QString day = ctDay_->text().trimmed(); !day.isEmpty() && !dayIn(day).isValid())
    return tr("Day of the CT is “%1”; a day up to today is expected, such as 2026-11-20.").arg(day);
  const outcome::Surgery answered = surgery();
  const auto checked = design_ && designOf_ == answered.array
                           ? outcome::checkSurgery(answered, *design_)
                           : outcome::checkSurgery(answered);
  return checked ? QString() : dataText(checked.error().message);
}

void SurgeryForm::readDesign()
{
  const std::string name = array_->value().toStdString();
  if (name == designOf_) return;
  designOf_ = name;
  design_.reset();
  if (name.empty()) return;
  if (const auto file = findByName("array", "plugins/electrodes", name))
    if (auto read = electrode::loadArray(*file)) design_ = *std::move(read);
}

void SurgeryForm::showError()
{
  const QString sentence = numbers_.empty() || lot_ == nullptr ? QString() : error();
  error_->setText(sentence);
  error_->setVisible(!sentence.isEmpty());
}

}  // namespace perilymph::gui
