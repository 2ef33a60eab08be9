// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtNextSteps.h"

#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVariant>
#include <array>

#include "gui/text/DataText.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Placeholder.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/anatomy/Patient.h"

namespace perilymph::gui {

namespace {

constexpr int codeHeight_px = 28, longestTyped = 60;

}  // namespace

CtNextSteps::CtNextSteps(QWidget* parent)
    : QWidget(parent),
      code_(new QLineEdit(this)),
      refusal_(new WrappedLabel({}, this)),
      insert_(panelButton(tr("Insert into this cochlea"), "insertCtButton", this)),
      plan_(panelButton(tr("Plan with this cochlea"), "planCtButton", this)),
      saveSurface_(panelButton(tr("Save surface…"), "saveCtSurfaceButton", this)),
      send_(panelButton(tr("Send to the archive…"), "sendCtResultsButton", this))
{
  code_->setObjectName(QStringLiteral("ctPatientCode"));
  code_->setFont(typeface(13));
  code_->setFixedHeight(sized(codeHeight_px));
  code_->setMaxLength(longestTyped);
  code_->setAccessibleName(tr("Patient code"));
  markPlaceholder(*code_, tr("Patient code (no names)"));
  refusal_->setObjectName(QStringLiteral("ctCodeRefusal"));
  refusal_->setFont(typeface(11));
  refusal_->setTextFormat(Qt::PlainText);
  refusal_->setProperty("error", true);
  insert_->setProperty("primary", true);
  saveSurface_->setToolTip(
      tr("The fitted wall in the CT’s own frame (LPS): STL, PLY, glTF, OBJ, VTP"));
  send_->setToolTip(
      tr("Measures, lumen and picture into the study of this CT, as DICOM (SR, SEG, secondary "
         "capture)"));
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(spacing);
  setWide(false);
  connect(code_, &QLineEdit::textChanged, this, &CtNextSteps::showState);
  connect(code_, &QLineEdit::textChanged, this, &CtNextSteps::codeChanged);
  connect(insert_, &QPushButton::clicked, this, [this] { Q_EMIT insertRequested(code_->text()); });
  connect(plan_, &QPushButton::clicked, this, [this] { Q_EMIT planRequested(code_->text()); });
  connect(saveSurface_, &QPushButton::clicked, this, &CtNextSteps::saveSurfaceRequested);
  connect(send_, &QPushButton::clicked, this, &CtNextSteps::sendRequested);
}

void CtNextSteps::show(bool isMeasured, bool isFree, bool isStale)
{
  isStale_ = isStale;
  isMeasured_ = isMeasured;
  isFree_ = isFree;
  showState();
}

bool CtNextSteps::hasCode() const
{
  return static_cast<bool>(anatomy::checkPatientCode(code_->text().toStdString()));
}

void CtNextSteps::setCode(const QString& code) { code_->setText(code); }

QString CtNextSteps::code() const { return code_->text(); }

void CtNextSteps::editCode()
{
  code_->setFocus();
  code_->selectAll();
}

void CtNextSteps::setWide(bool isWide)
{
  auto* grid = static_cast<QGridLayout*>(layout());
  const std::array<QWidget*, 5> inOrder{code_, insert_, plan_, saveSurface_, send_};
  grid->removeWidget(refusal_);
  grid->addWidget(refusal_, int(inOrder.size()), 0, 1, -1);
  constexpr std::array<std::array<int, 2>, 5> inTwoRows{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 1}}};
  for (std::size_t k = 0; k < inOrder.size(); ++k) {
    grid->removeWidget(inOrder[k]);
    if (isWide)
      grid->addWidget(inOrder[k], inTwoRows[k][0], inTwoRows[k][1]);
    else
      grid->addWidget(inOrder[k], int(k), 0);
  }
}

void CtNextSteps::showState()
{
  const std::string code = code_->text().toStdString();
  const auto checked = anatomy::checkPatientCode(code);
  const bool isRefused = !code.empty() && !checked;
  refusal_->setText(isRefused ? dataText(checked.error().message) : QString());
  refusal_->setVisible(isRefused);
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
  send_->setEnabled(isMeasured_ && isFree_);
}

}  // namespace perilymph::gui
