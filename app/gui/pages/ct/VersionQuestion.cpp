// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/VersionQuestion.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <cmath>
#include <optional>
#include <utility>

#include "gui/text/Numbers.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/analysis/ErrorBand.h"
#include "perilymph/anatomy/DuctLength.h"
#include "perilymph/foundation/Normal.h"

namespace perilymph::gui {

namespace {

/// A measure with the standard deviations of its measurement and of its formula [mm].
struct Measured {
  double value = 0.0, sd = 0.0, formula = 0.0;
};
using Compared = std::array<std::optional<Measured>, 4>;  ///< A, B, H, duct length.

Compared comparedOf(const anatomy::Patient& patient)
{
  Compared found;
  if (!patient.basalTurn) return found;
  const anatomy::BasalTurn& turn = *patient.basalTurn;
  const anatomy::BasalTurnErrors errors = analysis::errorsOf(patient);
  found[0] = {inMillimeters(turn.a), inMillimeters(errors.a)};
  found[1] = {inMillimeters(turn.b), inMillimeters(errors.b)};
  if (turn.h)
    found[2] = {inMillimeters(*turn.h), inMillimeters(errors.h.value_or(analysis::measuringError))};
  found[3] = {inMillimeters(anatomy::ellipticCircularDuctLength(turn.a, turn.b)),
              inMillimeters(anatomy::ductLengthError(turn.a, turn.b, errors)),
              inMillimeters(anatomy::ductLengthFormulaError(turn.a, turn.b))};
  return found;
}

QString dash() { return QStringLiteral("–"); }

}  // namespace

bool haveSameMeasures(const anatomy::Patient& one, const anatomy::Patient& other)
{
  const auto textOf = [](anatomy::Patient patient) {
    patient.origin.software.clear();
    return anatomy::patientText(patient);
  };
  return textOf(one) == textOf(other);
}

VersionQuestion::VersionQuestion(QWidget* parent)
    : QWidget(parent), title_(new WrappedLabel({}, this))
{
  setObjectName(QStringLiteral("versionQuestion"));
  title_->setObjectName(QStringLiteral("versionTitle"));
  title_->setFont(typeface(13, QFont::DemiBold));
  auto* table = new QGridLayout;
  table->setVerticalSpacing(2);
  const std::array heads{tr("saved"), tr("new"), tr("difference")};
  const std::array names{QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("H"), tr("CDL")};
  constexpr std::array keys{"A", "B", "H", "Cdl"};
  for (std::size_t k = 0; k < heads.size(); ++k)
    table->addWidget(panelHeading(heads[k], this), 0, int(k) + 1);
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    auto* name = new QLabel(names[row], this);
    name->setFont(typeface(12));
    table->addWidget(name, int(row) + 1, 0);
    constexpr std::array columns{"saved", "new", "difference"};
    for (std::size_t k = 0; k < columns.size(); ++k) {
      auto* cell = new QLabel(this);
      cell->setFont(typeface(12));
      cell->setObjectName(QLatin1String(columns[k]) + QLatin1String(keys[row]));
      table->addWidget(cell, int(row) + 1, int(k) + 1);
      cells_[row][k] = cell;
    }
  }
  auto* accept = rowButton(tr("New version"), "newVersionButton", this);
  auto* refuse = rowButton(tr("Other code"), "otherCodeButton", this);
  accept->setProperty("primary", true);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(accept);
  buttons->addWidget(refuse);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addWidget(title_);
  column->addLayout(table);
  column->addLayout(buttons);
  connect(accept, &QPushButton::clicked, this, [this] {
    const auto then = std::exchange(then_, {});
    drop();
    if (then) then();
  });
  connect(refuse, &QPushButton::clicked, this, [this] {
    drop();
    Q_EMIT otherCodeWanted();
  });
  drop();
}

void VersionQuestion::ask(const SavedPatient& saved, const anatomy::Patient& measured,
                          std::function<void()> then)
{
  then_ = std::move(then);
  const QString code = QString::fromStdString(saved.patient.label);
  const QString side = saved.patient.side == anatomy::Side::left ? tr("left") : tr("right");
  const auto& versions = saved.record.versions;
  title_->setText(
      versions.empty()
          ? tr("%1 %2 exists.").arg(code, side)
          : tr("%1 %2 exists, saved %3.")
                .arg(code, side, QString::fromStdString(versions.back().savedUtc).left(10)));
  const Compared before = comparedOf(saved.patient), after = comparedOf(measured);
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    const int decimals = row < 3 ? 2 : 1;
    const auto text = [decimals](const std::optional<Measured>& one) {
      return one ? QStringLiteral("%1 ± %2").arg(
                       numberText(one->value, decimals),
                       numberText(halfWidth95 * std::hypot(one->sd, one->formula), decimals))
                 : dash();
    };
    cells_[row][0]->setText(text(before[row]));
    cells_[row][1]->setText(text(after[row]));
    const bool areBoth = before[row] && after[row];
    const double by = areBoth ? after[row]->value - before[row]->value : 0.0;
    // the formula is the same on both sides
    const double within = areBoth ? halfWidth95 * std::hypot(before[row]->sd, after[row]->sd) : 0.0;
    QString difference = dash();
    if (areBoth)
      difference = QStringLiteral("%1%2 ± %3")
                       .arg(by > 0.0 ? QStringLiteral("+") : QString(), numberText(by, decimals),
                            numberText(within, decimals));
    cells_[row][2]->setText(difference);
    const bool isBeyond = areBoth && std::fabs(by) > within;
    cells_[row][2]->setStyleSheet(
        isBeyond ? QStringLiteral("color: %1;").arg(shownTheme().warning.name()) : QString());
    cells_[row][2]->setToolTip(isBeyond ? tr("Beyond the 95 % interval of the difference")
                                        : tr("Within the 95 % interval of the difference"));
  }
  show();
}

void VersionQuestion::drop()
{
  then_ = {};
  hide();
}

}  // namespace perilymph::gui
