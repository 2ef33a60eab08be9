// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtOnward.h"

#include <QGridLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpressionValidator>
#include <QVariant>
#include <array>

#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int codeHeight_px = 28, maxCodeLength = 24;

}  // namespace

CtOnward::CtOnward(QWidget* parent)
    : QWidget(parent),
      code_(new QLineEdit(this)),
      insert_(panelButton(tr("Insert into this cochlea"), "insertCtButton", this)),
      plan_(panelButton(tr("Plan with this cochlea"), "planCtButton", this)),
      saveSurface_(panelButton(tr("Save surface…"), "saveCtSurfaceButton", this))
{
  code_->setObjectName(QStringLiteral("ctPatientCode"));
  code_->setFont(typeface(13));
  code_->setFixedHeight(sized(codeHeight_px));
  code_->setMaxLength(maxCodeLength);
  code_->setAccessibleName(tr("Patient code"));
  code_->setPlaceholderText(tr("Patient code (no names)"));
  // codes become file names
  code_->setValidator(new QRegularExpressionValidator(
      QRegularExpression(QStringLiteral("[A-Za-z0-9][A-Za-z0-9-]*")), code_));
  insert_->setProperty("primary", true);
  saveSurface_->setToolTip(
      tr("The fitted wall in the CT’s own frame (LPS): STL, PLY, glTF, OBJ, VTP"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(spacing);
  setWide(false);
  connect(code_, &QLineEdit::textChanged, this, &CtOnward::showState);
  connect(code_, &QLineEdit::textChanged, this, &CtOnward::codeChanged);
  connect(insert_, &QPushButton::clicked, this, [this] { Q_EMIT insertAsked(code_->text()); });
  connect(plan_, &QPushButton::clicked, this, [this] { Q_EMIT planAsked(code_->text()); });
  connect(saveSurface_, &QPushButton::clicked, this, &CtOnward::saveSurfaceAsked);
}

void CtOnward::show(bool isMeasured, bool isFree, bool isStale)
{
  isStale_ = isStale;
  isMeasured_ = isMeasured;
  isFree_ = isFree;
  showState();
}

bool CtOnward::hasCode() const { return !code_->text().isEmpty(); }

void CtOnward::editCode()
{
  code_->setFocus();
  code_->selectAll();
}

void CtOnward::setWide(bool isWide)
{
  auto* grid = static_cast<QGridLayout*>(layout());
  const std::array<QWidget*, 4> inOrder{code_, insert_, plan_, saveSurface_};
  constexpr std::array<std::array<int, 2>, 4> inTwoRows{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::size_t k = 0; k < inOrder.size(); ++k) {
    grid->removeWidget(inOrder[k]);
    if (isWide)
      grid->addWidget(inOrder[k], inTwoRows[k][0], inTwoRows[k][1]);
    else
      grid->addWidget(inOrder[k], int(k), 0);
  }
}

void CtOnward::showState()
{
  insert_->setEnabled(isMeasured_ && isFree_ && hasCode());
  plan_->setEnabled(isMeasured_ && isFree_ && hasCode());
  const QString first = !hasCode() ? tr("Type a patient code first.")
                        : isStale_ ? tr("The landmarks moved: the cochlea is measured first.")
                                   : QString();
  insert_->setToolTip(first);
  plan_->setToolTip(first.isEmpty()
                        ? tr("Angular insertion depth, coverage and forces of electrode arrays in "
                             "this cochlea, before one is inserted")
                        : first);
  setPrimary(*insert_, !isStale_);
  saveSurface_->setEnabled(isMeasured_ && isFree_);
}

}  // namespace perilymph::gui
