// SPDX-License-Identifier: BSD-3-Clause
#include "gui/shell/NavigationSection.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/shell/Navigation.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"

namespace perilymph::gui {

namespace {

void setError(QLabel& label, bool isError)
{
  label.setProperty("error", isError);
  label.setProperty("quiet", !isError);
  label.style()->unpolish(&label);
  label.style()->polish(&label);
}

}  // namespace

NavigationSection::NavigationSection(Navigation& navigation, QWidget* parent)
    : QWidget(parent),
      navigation_(navigation),
      off_(new Choice(tr("off"), this)),
      on_(new Choice({}, this)),
      cochlea_(nullptr),
      patient_(nullptr),
      port_(new QLineEdit(this)),
      status_(new WrappedLabel({}, this))
{
  auto* heading = new WrappedLabel(tr("Stream to 3D Slicer (OpenIGTLink)"), this);
  heading->setFont(typeface(13, QFont::DemiBold));
  off_->setObjectName(QStringLiteral("navigation-off"));
  on_->setObjectName(QStringLiteral("navigation-on"));
  for (Choice* choice : {off_, on_}) {
    choice->setFocusPolicy(Qt::TabFocus);
    connect(choice, &QAbstractButton::clicked, this, &NavigationSection::apply);
  }
  // Choices of one widget exclude each other.
  auto* frames = new QWidget(this);
  cochlea_ = new Choice(tr("coordinates of the cochlea"), frames);
  patient_ = new Choice(tr("coordinates of the patient (RAS), with the CT open"), frames);
  cochlea_->setObjectName(QStringLiteral("navigation-cochlea"));
  patient_->setObjectName(QStringLiteral("navigation-patient"));
  auto* frameColumn = new QVBoxLayout(frames);
  frameColumn->setContentsMargins(0, 0, 0, 0);
  frameColumn->setSpacing(spacing);
  for (Choice* choice : {cochlea_, patient_}) {
    choice->setFocusPolicy(Qt::TabFocus);
    frameColumn->addWidget(choice);
    connect(choice, &QAbstractButton::clicked, this, &NavigationSection::apply);
  }
  auto* caption = new WrappedLabel(tr("Port"), this);
  caption->setFont(typeface(13));
  caption->setBuddy(port_);
  port_->setObjectName(QStringLiteral("navigation-port"));
  port_->setAccessibleName(tr("Port"));
  port_->setFont(typeface(13));
  port_->setFixedSize(sized(80), sized(26));
  port_->setMaxLength(5);
  connect(port_, &QLineEdit::editingFinished, this, &NavigationSection::apply);
  status_->setObjectName(QStringLiteral("navigationStatus"));
  status_->setFont(typeface(12));

  auto* choices = new QHBoxLayout;
  choices->setSpacing(3 * spacing);
  choices->addWidget(off_);
  choices->addWidget(on_);
  choices->addStretch();
  auto* row = new QHBoxLayout;
  row->setSpacing(spacing);
  row->addWidget(caption, 1);
  row->addWidget(port_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addWidget(heading);
  column->addLayout(choices);
  column->addWidget(frames);
  column->addLayout(row);
  column->addWidget(status_);
  connect(&navigation_, &Navigation::changed, this, &NavigationSection::show);
  show();
}

void NavigationSection::apply()
{
  bool isNumber = false;
  const int port = port_->text().trimmed().toInt(&isNumber);
  port_->setModified(false);
  if (!isNumber || port < Navigation::minPort || port > Navigation::maxPort) {
    show();
    status_->setText(tr("The port must be a number from %1 to %2.")
                         .arg(Navigation::minPort)
                         .arg(Navigation::maxPort));
    return setError(*status_, true);
  }
  const auto coordinates =
      patient_->isChecked() ? broadcast::Coordinates::patient : broadcast::Coordinates::cochlea;
  const bool isAsIs = on_->isChecked() == navigation_.isOn() && port == navigation_.port() &&
                      coordinates == navigation_.coordinates();
  if (!isAsIs) navigation_.set(on_->isChecked(), port, coordinates);
  show();
}

void NavigationSection::show()
{
  on_->setText(navigation_.isOpenToOthers() ? tr("on, also for other computers")
                                            : tr("on, for programs on this computer"));
  (navigation_.isOn() ? on_ : off_)->setChecked(true);
  const bool isPatient = navigation_.coordinates() == broadcast::Coordinates::patient;
  (isPatient ? patient_ : cochlea_)->setChecked(true);
  // Clients come and go while a port is typed.
  if (!port_->isModified()) port_->setText(QString::number(navigation_.port()));
  status_->setText(navigation_.status());
  setError(*status_, navigation_.isError());
}

}  // namespace perilymph::gui
