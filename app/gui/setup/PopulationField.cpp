// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/PopulationField.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QStyle>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "gui/parts/Numbers.h"
#include "gui/parts/Theme.h"
#include "gui/setup/ValueEdit.h"
#include "perilymph/analysis/ErrorBand.h"

namespace perilymph::gui {

namespace {

constexpr int lineHeight_px = 14;  // of the population line below the field
constexpr int fieldWidth_px = 84;
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
      place_(new QLabel(this)),
      provenance_(new QLabel(this))
{
  auto* titleLabel = new QLabel(title, this);
  titleLabel->setFont(typeface(13));
  titleLabel->setBuddy(field_);
  titleLabel->setWordWrap(true);
  field_->setObjectName(QLatin1String(name));
  field_->setAccessibleName(title);
  field_->setFont(typeface(13, QFont::Medium));
  field_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  if (width == Width::wide)
    field_->setFixedSize(fieldWidth_px, 28);
  else
    field_->setFixedSize(narrowFieldWidth_px, 26);
  if (mayBeEmpty) field_->setPlaceholderText(width == Width::wide ? tr("optional") : tr("none"));
  auto* unit = new QLabel(tr("mm"), this);
  unit->setFont(typeface(11));
  unit->setProperty("quiet", true);
  place_->setFont(typeface(11));
  place_->setProperty("quiet", true);
  place_->setToolTip(population.source);
  place_->setWordWrap(true);
  provenance_->setFont(typeface(11));
  provenance_->setProperty("quiet", true);
  provenance_->setToolTip(tr("Source of the value"));
  provenance_->hide();
  setToolTip(population.source);

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(spacing);
  grid->setVerticalSpacing(0);
  grid->addWidget(titleLabel, 0, 0);
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
  connect(field_, &QLineEdit::editingFinished, this, [this] { commit(); });
  showPlace();
}

void PopulationField::setHeld(std::optional<Length> value, const QString& provenance)
{
  int decimals = 2;
  const auto reads = [&] {
    return !value ||
           millimeters(typedNumber(numberText(inMillimeters(*value), decimals)).value_or(0.0)) ==
               *value;
  };
  while (decimals < 4 && !reads()) ++decimals;
  field_->setHeld(value ? numberText(inMillimeters(*value), decimals) : QString());
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

void PopulationField::setValue(std::optional<Length> value)
{
  field_->setText(value ? numberText(inMillimeters(*value), 2) : QString());
}

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

QString PopulationField::error() const
{
  if (isAcceptable()) return {};
  const QString low = numberText(inMillimeters(population_.low), 1);
  const QString high = numberText(inMillimeters(population_.high), 1);
  if (width_ == Width::narrow) return tr("must be %1 to %2 mm").arg(low, high);
  return tr("Enter a value from %1 to %2 mm").arg(low, high);
}

QString PopulationField::placeOf(Length value) const
{
  const bool isNarrow = width_ == Width::narrow;
  const QString error = numberText(inMillimeters(analysis::measuringError), 1);
  if (population_.mean && population_.standardDeviation) {
    const double off = (value - *population_.mean) / *population_.standardDeviation;
    if (isNarrow)
      return tr("%1%2 SD · CT ± %3 mm")
          .arg(off < -0.05 ? QStringLiteral("−") : QStringLiteral("+"),
               numberText(std::fabs(off), 1), error);
    const QString spread = numberText(inMillimeters(*population_.standardDeviation), 1);
    const QString mean = numberText(inMillimeters(*population_.mean), 1);
    if (std::fabs(off) < 0.05)
      return tr("at population mean (%1 ± %2 mm) · CT ± %3 mm").arg(mean, spread, error);
    return (off < 0.0 ? tr("%1 SD below population mean (%2 ± %3 mm) · CT ± %4 mm")
                      : tr("%1 SD above population mean (%2 ± %3 mm) · CT ± %4 mm"))
        .arg(numberText(std::fabs(off), 1), mean, spread, error);
  }
  return (isNarrow ? tr("%1–%2 mm · CT ± %3 mm") : tr("range %1–%2 mm · CT ± %3 mm"))
      .arg(numberText(inMillimeters(population_.low), 1),
           numberText(inMillimeters(population_.high), 1), error);
}

void PopulationField::showPlace()
{
  const auto typed = value();
  QString label = error();
  if (label.isEmpty()) label = typed ? placeOf(*typed) : tr("optional; estimated from A and B");
  place_->setText(label);
  const bool isError = !isAcceptable();
  if (place_->property("error").toBool() != isError) {
    place_->setProperty("error", isError);
    place_->setProperty("quiet", !isError);
    place_->style()->unpolish(place_);
    place_->style()->polish(place_);
  }
  update();
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
  painter.setPen(QPen(lineColor, 3, Qt::SolidLine, Qt::RoundCap));
  painter.drawLine(QPointF(left, y), QPointF(right, y));
  if (population_.mean && population_.standardDeviation) {
    // one standard deviation to both sides
    painter.setPen(QPen(quietTextColor, 3, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(at(*population_.mean - *population_.standardDeviation), y),
                     QPointF(at(*population_.mean + *population_.standardDeviation), y));
  }
  const auto typed = value();
  if (!typed) return;
  painter.setPen(Qt::NoPen);
  painter.setBrush(isAcceptable() ? accentColor : warningColor);
  painter.drawEllipse(QPointF(at(*typed), y), 4.5, 4.5);
}

}  // namespace perilymph::gui
