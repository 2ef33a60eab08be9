// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/InputSection.h"

#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/setup/NumberField.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

InputSection::InputSection(QWidget* parent)
    : Section(tr("Input"), "handFold", parent),
      scripted_(new Choice(tr("Scripted insertion"), body())),
      pointer_(new Choice(tr("Mouse and keyboard"), body())),
      device_(new Choice(tr("Haptic device…"), body())),
      hold_(new QPushButton(tr("Hold the array (Space)"), body())),
      pullStylet_(new QPushButton(tr("Withdraw stylet (S)"), body())),
      stylet_(new QLabel(body())),
      force_(new NumberField({tr("Force feedback gain"), "panelForceScale", tr("×"), 1,
                              tr("Ratio of the rendered to the physical force. Without a haptic "
                                 "device there is no force feedback.")},
                             body()))
{
  addChoices();
  addButtons();
}

void InputSection::addChoices()
{
  scripted_->setObjectName(QStringLiteral("scriptedChoice"));
  scripted_->setToolTip(tr("Inserts and withdraws at constant speed."));
  pointer_->setObjectName(QStringLiteral("pointerChoice"));
  pointer_->setToolTip(tr("The mouse wheel or the ↑ and ↓ keys move the array while it is held."));
  device_->setObjectName(QStringLiteral("deviceChoice"));
  device_->setToolTip(
      tr("Uses the device chosen last; shows the list if it is not there (list: H)."));
  scripted_->setChecked(true);
  for (Choice* choice : {scripted_, pointer_, device_}) {
    choice->setFocusPolicy(Qt::TabFocus);
    rows().addWidget(choice);
  }
  connect(scripted_, &QAbstractButton::clicked, this,
          [this] { Q_EMIT inputChosen(InputSource::scripted); });
  connect(pointer_, &QAbstractButton::clicked, this,
          [this] { Q_EMIT inputChosen(InputSource::pointer); });
  connect(device_, &QAbstractButton::clicked, this, &InputSection::devicesRequested);

  // a consumer device's own friction exceeds the forces here: up to 20 times, as in scenarios
  force_->setRange({0.0, 20.0});
  connect(force_, &NumberField::given, this, [this](double value) {
    Q_EMIT changeRequested({SetupField::forceScale,
                            {{"force_scale", QString::number(value, 'f', 4).toStdString()}},
                            tr("force feedback gain %1 ×").arg(numberText(value, 1)),
                            {}});
  });
  rows().addWidget(force_);
}

void InputSection::addButtons()
{
  hold_->setObjectName(QStringLiteral("holdButton"));
  pullStylet_->setObjectName(QStringLiteral("styletButton"));
  for (QPushButton* button : {hold_, pullStylet_}) {
    button->setFont(typeface(13));
    button->setFixedHeight(sized(28));
    button->setFocusPolicy(Qt::NoFocus);
    button->setEnabled(false);
  }
  hold_->setToolTip(tr("The array moves only while this button or Space is held."));
  stylet_->setObjectName(QStringLiteral("styletLabel"));
  stylet_->setFont(typeface(13));
  stylet_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  styletRow_ = namedRow(tr("Stylet"), stylet_, body());
  rows().addWidget(styletRow_);
  rows().addWidget(hold_);
  rows().addWidget(pullStylet_);
  hold_->setVisible(false);
  connect(hold_, &QAbstractButton::pressed, this, [this] { Q_EMIT holdChanged(true); });
  connect(hold_, &QAbstractButton::released, this, [this] { Q_EMIT holdChanged(false); });
  connect(pullStylet_, &QAbstractButton::clicked, this, &InputSection::styletRequested);
}

void InputSection::show(const Setup& setup)
{
  force_->setValue(setup.scenario.engine().forceScale);
  styletRow_->setVisible(setup.scenario.array().hasStylet);
  pullStylet_->setVisible(setup.scenario.array().hasStylet);
}

QString InputSection::commit()
{
  if (force_->commit()) return {};
  return tr("Force feedback gain %1. Enter a valid value or press Esc.").arg(force_->error());
}

void InputSection::setInput(InputSource input, const QString& name)
{
  scripted_->setChecked(input == InputSource::scripted);
  pointer_->setChecked(input == InputSource::pointer);
  device_->setChecked(input == InputSource::device);
  device_->setText(input == InputSource::device ? name : tr("Haptic device…"));
  hold_->setVisible(input == InputSource::pointer);
}

void InputSection::setChangeable(bool isChangeable)
{
  for (QWidget* field : std::initializer_list<QWidget*>{scripted_, pointer_, device_, force_})
    field->setEnabled(isChangeable);
}

void InputSection::setHoldEnabled(bool isEnabled) { hold_->setEnabled(isEnabled); }

void InputSection::setHeld(bool isHeld)
{
  if (hold_->property("held").toBool() == isHeld) return;
  hold_->setProperty("held", isHeld);
  hold_->setText(isHeld ? tr("Array held") : tr("Hold the array (Space)"));
  hold_->style()->unpolish(hold_);
  hold_->style()->polish(hold_);
}

void InputSection::setStylet(const QString& text, bool canPull)
{
  stylet_->setText(text);
  pullStylet_->setEnabled(canPull);
}

}  // namespace perilymph::gui
