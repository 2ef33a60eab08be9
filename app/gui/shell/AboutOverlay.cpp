// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/AboutOverlay.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/foundation/StateFolder.h"
#include "perilymph/foundation/Version.h"

namespace perilymph::gui {

AboutOverlay::AboutOverlay(QWidget* parent) : QFrame(parent)
{
  setObjectName(QStringLiteral("about"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * spacing, 2 * spacing, 3 * spacing, 2 * spacing);
  column->setSpacing(spacing);
  const auto add = [this, column](const QString& text, int size_px, QFont::Weight weight) {
    auto* label = new WrappedLabel(text, this);
    label->setFont(typeface(size_px, weight));
    label->setMinimumWidth(sized(420));
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    column->addWidget(label);
  };
  add(QStringLiteral("Perilymph"), 15, QFont::DemiBold);
  add(tr("Version %1").arg(QString::fromStdString(buildId())), 13, QFont::Normal);
  add(tr("Cochlear-implant insertion workstation for research and training. Not a medical device."),
      13, QFont::Normal);
  add(tr("License: BSD 3-clause, in the file LICENSE of the source and of the package."), 13,
      QFont::Normal);
  add(tr("Log file: %1").arg(QString::fromStdString((stateFolder() / "perilymph.log").string())),
      12, QFont::Normal);
  auto* shut = new QPushButton(tr("Close"), this);
  shut->setObjectName(QStringLiteral("aboutCloseButton"));
  shut->setFont(typeface(13));
  shut->setFixedHeight(sized(28));
  shut->setFocusPolicy(Qt::TabFocus);
  connect(shut, &QPushButton::clicked, this, &AboutOverlay::closeRequested);
  column->addWidget(shut, 0, Qt::AlignRight);
  hide();
}

}  // namespace perilymph::gui
