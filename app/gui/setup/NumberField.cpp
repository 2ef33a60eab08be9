// SPDX-License-Identifier: BSD-3-Clause
#include "gui/setup/NumberField.h"

#include <QGridLayout>
#include <QLabel>
#include <QVariant>
#include <cmath>

#include "gui/setup/ValueEdit.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr double rounding = 1e-9;  // left by the conversion from SI units

}  // namespace

NumberField::NumberField(const Form& form, QWidget* parent)
    : QWidget(parent), form_(form), edit_(new ValueEdit(this)), error_(new QLabel(this))
{
  auto* title = new QLabel(form.title, this);
  title->setFont(typeface(13));
  title->setWordWrap(true);
  edit_->setObjectName(QLatin1String(form.name));
  edit_->setAccessibleName(form.title + QLatin1Char(' ') + form.unit);
  edit_->setFont(typeface(13));
  edit_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  edit_->setFixedSize(sized(68), sized(26));
  auto* unit = new QLabel(form.unit, this);
  unit->setFont(typeface(11));
  unit->setProperty("quiet", true);
  unit->setMinimumWidth(sized(32));
  error_->setFont(typeface(11));
  error_->setProperty("error", true);
  error_->setWordWrap(true);
  error_->hide();

  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(spacing);
  grid->setVerticalSpacing(0);
  grid->addWidget(title, 0, 0);
  grid->addWidget(edit_, 0, 1);
  grid->addWidget(unit, 0, 2);
  grid->addWidget(error_, 1, 0, 1, 3);
  grid->setColumnStretch(0, 1);

  connect(edit_, &QLineEdit::textChanged, this, [this] { showError(); });
  connect(edit_, &QLineEdit::editingFinished, this, [this] { commit(); });
}

void NumberField::setRange(Range allowed)
{
  allowed_ = allowed;
  // on the whole row; the field itself inherits it
  setToolTip(tr("%1–%2 %3. %4")
                 .arg(numberText(allowed.low, form_.decimals),
                      numberText(allowed.high, form_.decimals), form_.unit, form_.tip));
  showError();
}

void NumberField::setValue(double value)
{
  // a second decimal if the first does not suffice
  int decimals = form_.decimals;
  const auto isWhole = [value](int shown) {
    return std::fabs(typedNumber(numberText(value, shown)).value_or(0.0) - value) < rounding;
  };
  while (decimals < 2 && !isWhole(decimals)) ++decimals;
  edit_->setHeld(numberText(value, decimals));
}

QString NumberField::error() const
{
  const auto typed = typedNumber(edit_->text());
  if (typed && *typed >= allowed_.low && *typed <= allowed_.high) return {};
  return tr("must be %1 to %2 %3")
      .arg(numberText(allowed_.low, form_.decimals), numberText(allowed_.high, form_.decimals),
           form_.unit);
}

void NumberField::showError()
{
  const QString label = error();
  error_->setText(label);
  error_->setVisible(!label.isEmpty());
}

bool NumberField::isPending() const { return edit_->isPending(); }

void NumberField::takeBack() { edit_->takeBack(); }

bool NumberField::commit()
{
  if (!isPending()) return true;
  const auto typed = typedNumber(edit_->text());
  if (!typed || !error().isEmpty()) return false;
  if (typed == typedNumber(edit_->held())) {
    takeBack();
    return true;
  }
  Q_EMIT given(*typed);
  return true;
}

}  // namespace perilymph::gui
