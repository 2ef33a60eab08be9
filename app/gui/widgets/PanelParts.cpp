// SPDX-License-Identifier: BSD-3-Clause
#include "gui/widgets/PanelParts.h"

#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QVariant>

#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

constexpr int buttonHeight_px = 28;

}  // namespace

WrappedLabel* panelHeading(const QString& text, QWidget* parent)
{
  auto* label = new WrappedLabel(text, parent);
  label->setFont(typeface(11, QFont::DemiBold));
  label->setProperty("quiet", true);
  return label;
}

QPushButton* panelButton(const QString& text, const char* name, QWidget* parent)
{
  auto* button = new QPushButton(text, parent);
  button->setObjectName(QLatin1String(name));
  button->setFont(typeface(13, QFont::Medium));
  button->setFixedHeight(sized(buttonHeight_px));
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

QPushButton* rowButton(const QString& text, const char* name, QWidget* parent)
{
  QPushButton* button = panelButton(text, name, parent);
  button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return button;
}

void setPrimary(QPushButton& button, bool isPrimary)
{
  if (button.property("primary").toBool() == isPrimary) return;
  button.setProperty("primary", isPrimary);
  button.style()->unpolish(&button);
  button.style()->polish(&button);
}

QProgressBar* endlessBar(int width_px, QWidget* parent)
{
  auto* bar = new QProgressBar(parent);
  bar->setRange(0, 0);
  bar->setTextVisible(false);
  bar->setFixedSize(width_px, 6);
  return bar;
}

QScrollArea* verticalScroll(QWidget* content, QWidget* parent)
{
  auto* scroll = new QScrollArea(parent);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  return scroll;
}

}  // namespace perilymph::gui
