// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PopulationField.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QStyle>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "gui/setup/ValueEdit.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Placeholder.h"
#include "gui/widgets/Theme.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/foundation/Normal.h"

namespace perilymph::gui {

namespace {

// Standard deviations from the mean from which a value is to be checked, as in unusualMeasures().
constexpr double unusualFrom = 2.0;

constexpr int lineHeight_px = 14;  // of the population line below the field
constexpr int fieldWidth_px = 96;
constexpr int narrowFieldWidth_px = 68;

}  // namespace

PopulationField::PopulationField(const QString& title, const char* name,
                                 const Population& population, bool mayBeEmpty, QWidget* parent,
                                 Width width)
    : QWidget(parent),
      population_(population),
      mayBeEmpty_(mayBeEmpty),
      width_(width),
      field_(new ValueEdit(this)),
      title_(new QLabel(title, this)),
      place_(new QLabel(this)),
      provenance_(new QLabel(this))
{
  title_->setFont(typeface(13));
  title_->setBuddy(field_);
  title_->setWordWrap(true);
  title_->installEventFilter(this);
  field_->setObjectName(QLatin1String(name));
  field_->setAccessibleName(title);
  field_->setFont(typeface(13, QFont::Medium));
  field_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  if (width == Width::wide)
    field_->setFixedSize(sized(fieldWidth_px), sized(28));
  else
    field_->setFixedSize(sized(narrowFieldWidth_px), sized(26));
  if (mayBeEmpty)
    markPlaceholder(*field_, width == Width::wide ? tr("optional") : tr("none"));
  else if (population.mean && width == Width::wide)
    markPlaceholder(*field_, tr("mean %1").arg(numberText(inMillimeters(*population.mean), 2)));
  field_->installEventFilter(this);
  auto* unit = new QLabel(tr("mm"), this);
  unit->setFont(typeface(11));
  unit->setProperty("quiet", true);
  place_->setObjectName(QLatin1String(name) + QStringLiteral("Place"));
  place_->setFont(typeface(11));
  place_->setProperty("quiet", true);
  place_->setToolTip(population.source);
  place_->setWordWrap(true);
  provenance_->setFont(typeface(11));
  provenance_->setProperty("quiet", true);
  provenance_->setToolTip(tr("Source of the value"));
  provenance_->hide();
  setToolTip(population.measuring.isEmpty()
                 ? population.source
                 : population.measuring + QStringLiteral("\n") + population.source);
  field_->setToolTip(toolTip());

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(spacing);
  grid->setVerticalSpacing(0);
  grid->addWidget(title_, 0, 0);
  grid->addWidget(field_, 0, 1);
  grid->addWidget(unit, 0, 2);
  grid->setRowMinimumHeight(1, lineHeight_px);
  auto* label = new QHBoxLayout;
  label->setSpacing(4);
  label->addWidget(place_, 1);
  label->addWidget(provenance_);
  grid->addLayout(label, 2, 0, 1, 3);
  grid->setColumnStretch(0, 1);

  connect(field_, &QLineEdit::textChanged, this, [this] {
    showPlace();
    Q_EMIT changed();
  });
  connect(field_, &QLineEdit::editingFinished, this, [this] {
    commit();
    // the same spelling of every number: "34,2" becomes "34.20"
    if (!isPending() && isAcceptable() && field_->text() != textOf(value())) setValue(value());
  });
  connect(field_, &QLineEdit::returnPressed, this, &PopulationField::submitted);
  showPlace();
}

QString PopulationField::textOf(std::optional<Length> value)
{
  int decimals = 2;
  const auto reads = [&] {
    return !value ||
           millimeters(typedNumber(numberText(inMillimeters(*value), decimals)).value_or(0.0)) ==
               *value;
  };
  while (decimals < 4 && !reads()) ++decimals;
  return value ? numberText(inMillimeters(*value), decimals) : QString();
}

void PopulationField::setHeld(std::optional<Length> value, const QString& provenance)
{
  field_->setHeld(textOf(value));
  provenance_->setText(provenance);
  provenance_->setVisible(!provenance.isEmpty());
}

bool PopulationField::isPending() const { return field_->isPending(); }

void PopulationField::takeBack() { field_->takeBack(); }

bool PopulationField::commit()
{
  if (!isPending()) return true;
  if (!isAcceptable()) return false;
  if (!field_->held().isEmpty() && typedNumber(field_->text()) == typedNumber(field_->held())) {
    takeBack();
    return true;
  }
  Q_EMIT given(value());
  return true;
}

void PopulationField::setValue(std::optional<Length> value) { field_->setText(textOf(value)); }

std::optional<Length> PopulationField::value() const
{
  const auto number = typedNumber(field_->text());
  if (!number) return std::nullopt;
  return millimeters(*number);
}

bool PopulationField::isAcceptable() const
{
  if (field_->text().trimmed().isEmpty()) return mayBeEmpty_;
  const auto typed = value();
  return typed && *typed >= population_.low && *typed <= population_.high;
}

bool PopulationField::isUnusual() const
{
  const auto typed = value();
  if (!typed || !population_.mean || !population_.standardDeviation) return false;
  return std::fabs((*typed - *population_.mean) / *population_.standardDeviation) >= unusualFrom;
}

QWidget* PopulationField::input() const { return field_; }

QString PopulationField::error() const
{
  if (isAcceptable()) return {};
  const QString low = numberText(inMillimeters(population_.low), 1);
  const QString high = numberText(inMillimeters(population_.high), 1);
  if (width_ == Width::narrow) return tr("must be %1 to %2 mm").arg(low, high);
  const QString range = tr("Enter a value from %1 to %2 mm").arg(low, high);
  const auto typed = value();
  const bool isBelow = typed && *typed > Length{} && *typed < population_.low;
  return isBelow && !population_.belowLow.isEmpty()
             ? range + QStringLiteral(". ") + population_.belowLow
             : range;
}

QString PopulationField::placeOf(Length value) const
{
  const bool isNarrow = width_ == Width::narrow;
  const QString error = numberText(
      halfWidth95 * inMillimeters(measuringError_.value_or(analysis::measuringError)), 2);
  if (population_.mean && population_.standardDeviation) {
    const double off = (value - *population_.mean) / *population_.standardDeviation;
    const bool isBelow = off < -0.05;
    const QString distance = numberText(std::fabs(off), 1);
    if (isNarrow)
      return (isUnusual() ? tr("%1%2 SD: check it · ± %3 mm (95 %)")
                          : tr("%1%2 SD · ± %3 mm (95 %)"))
          .arg(isBelow ? QStringLiteral("−") : QStringLiteral("+"), distance, error);
    const QString mean = tr("%1 mm, SD %2")
                             .arg(numberText(inMillimeters(*population_.mean), 2),
                                  numberText(inMillimeters(*population_.standardDeviation), 2));
    const QString place =
        (isBelow ? tr("%1 SD below population mean (%2)") : tr("%1 SD above population mean (%2)"))
            .arg(distance, mean);
    return isUnusual() ? tr("%1: check the measurement").arg(place)
                       : tr("%1 · ± %2 mm (95 %)").arg(place, error);
  }
  return (isNarrow ? tr("%1–%2 mm · ± %3 mm (95 %)") : tr("range %1–%2 mm · ± %3 mm (95 %)"))
      .arg(numberText(inMillimeters(population_.low), 1),
           numberText(inMillimeters(population_.high), 1), error);
}

void PopulationField::setMeasuringError(std::optional<Length> error)
{
  if (error == measuringError_) return;
  measuringError_ = error;
  showPlace();
}

QString PopulationField::emptyText() const
{
  if (!mayBeEmpty_) return error();
  return width_ == Width::narrow ? tr("estimated from A and B")
                                 : tr("optional; estimated from A and B");
}

void PopulationField::showPlace()
{
  const auto typed = value();
  const bool isEmpty = field_->text().trimmed().isEmpty();
  place_->setText(isEmpty ? emptyText() : isAcceptable() ? placeOf(*typed) : error());
  // an empty field is no error of the user yet
  const bool isMarked = (!isEmpty && !isAcceptable()) || isUnusual();
  if (place_->property("error").toBool() != isMarked) {
    place_->setProperty("error", isMarked);
    place_->setProperty("quiet", !isMarked);
    place_->style()->unpolish(place_);
    place_->style()->polish(place_);
  }
  update();
}

bool PopulationField::eventFilter(QObject* watched, QEvent* event)
{
  // nested layouts lose the height of a wrapped text
  if (watched == title_ && event->type() == QEvent::Resize)
    title_->setMinimumHeight(title_->heightForWidth(title_->width()));
  if (event->type() == QEvent::FocusIn) Q_EMIT focused(true);
  if (event->type() == QEvent::FocusOut) Q_EMIT focused(false);
  return QWidget::eventFilter(watched, event);
}

double PopulationField::fractionOf(Length value) const
{
  const double fraction = (value - population_.low) / (population_.high - population_.low);
  return std::clamp(fraction, 0.0, 1.0);
}

void PopulationField::paintEvent(QPaintEvent*)
{
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double y = place_->y() - lineHeight_px / 2.0;
  const double left = 4.0, right = width() - 4.0;
  const auto at = [&](Length value) { return left + fractionOf(value) * (right - left); };
  painter.setPen(QPen(shownTheme().line, 3, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(left, y), QPointF(right, y));
  if (population_.mean && population_.standardDeviation) {
    // one standard deviation to both sides
    painter.setPen(QPen(shownTheme().quietText, 3, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(at(*population_.mean - *population_.standardDeviation), y),
                     QPointF(at(*population_.mean + *population_.standardDeviation), y));
  }
  const auto typed = value();
  if (!typed) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(isAcceptable() && !isUnusual() ? shownTheme().accent : shownTheme().warning);
  painter.drawEllipse(QPointF(at(*typed), y), 4.5, 4.5);
}

}  // namespace perilymph::gui
