#include "SidePanel.h"

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

#include "Marks.h"
#include "Numbers.h"
#include "Theme.h"

namespace perilymph::gui {

namespace {

constexpr int rowHeight_px = 24;

QString millimetersText(Length length)
{
  return SidePanel::tr("%1 mm").arg(numberText(inMillimeters(length), 2));
}

QLabel* quiet(QLabel* label)
{
  label->setProperty("quiet", true);
  return label;
}

QString frictionText(const mechanics::FrictionLaw& law)
{
  return QStringLiteral("%1 / %2").arg(numberText(law.starting, 4), numberText(law.dynamic, 4));
}

QString techniqueText(const session::Scenario& scenario)
{
  if (!scenario.array.hasStylet) return SidePanel::tr("no stylet");
  return scenario.technique == "standard" ? SidePanel::tr("Standard, stylet in")
                                          : QString::fromStdString(scenario.technique);
}

}  // namespace

SidePanel::SidePanel(QWidget* parent) : QWidget(parent)
{
  setFixedWidth(sidePanelWidth);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
}

void SidePanel::setScenario(const session::Scenario& scenario)
{
  delete content_;
  content_ = new QWidget(this);
  layout()->addWidget(content_);
  auto* column = new QVBoxLayout(content_);
  column->setContentsMargins(2 * spacing, 2 * spacing, 2 * spacing, spacing);
  column->setSpacing(2);
  addPatient(*column, scenario);
  addLine(*column);
  addArray(*column, scenario);
  addLine(*column);
  addHand(*column, scenario);
  addLine(*column);
  addShow(*column);
  column->addStretch();
}

void SidePanel::addTitle(QVBoxLayout& column, const QString& title, const QString& note)
{
  auto* row = new QHBoxLayout;
  auto* label = quiet(new QLabel(title.toUpper(), this));
  label->setFont(typeface(11, QFont::DemiBold));
  row->addWidget(label);
  row->addStretch();
  if (!note.isEmpty()) {
    auto* noteLabel = new QLabel(note, content_);
    noteLabel->setFont(typeface(11));
    noteLabel->setStyleSheet(QStringLiteral("color: %1;").arg(accentColor.name()));
    row->addWidget(noteLabel);
  }
  column.addLayout(row);
  column.addSpacing(4);
}

QLabel* SidePanel::addRow(QVBoxLayout& column, const QString& name, const QString& value,
                          const QString& tip)
{
  auto* row = new QHBoxLayout;
  row->setSpacing(spacing);
  auto* nameLabel = new QLabel(name, content_);
  nameLabel->setFont(typeface(13));
  nameLabel->setFixedHeight(rowHeight_px);
  auto* valueLabel = new QLabel(value, content_);
  valueLabel->setFont(typeface(13));
  valueLabel->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  nameLabel->setToolTip(tip);
  valueLabel->setToolTip(tip);
  row->addWidget(nameLabel);
  row->addWidget(valueLabel, 1);
  column.addLayout(row);
  return valueLabel;
}

void SidePanel::addLine(QVBoxLayout& column)
{
  auto* line = new QFrame(content_);
  line->setObjectName(QStringLiteral("line"));
  line->setFixedHeight(1);
  column.addSpacing(spacing);
  column.addWidget(line);
  column.addSpacing(spacing + 2);
}

void SidePanel::addPatient(QVBoxLayout& column, const session::Scenario& scenario)
{
  const anatomy::Patient& patient = scenario.patient;
  const bool isPublished = scenario.anatomy == "published";
  addTitle(column, tr("Patient"),
           isPublished || patient.basalTurn ? QString::fromStdString(patient.label)
                                            : QString::fromStdString(scenario.anatomy));
  if (patient.basalTurn) {
    addRow(column, tr("Length A"), millimetersText(patient.basalTurn->a),
           tr("From the round window through the modiolus to the far lateral wall."));
    addRow(column, tr("Width B"), millimetersText(patient.basalTurn->b),
           tr("Across A, from lateral wall to lateral wall."));
    if (patient.basalTurn->h)
      addRow(column, tr("Height H"), millimetersText(*patient.basalTurn->h),
             tr("From base to apex along the modiolus."));
  } else if (isPublished) {
    addRow(column, tr("Scala length"), millimetersText(patient.scalaTympaniLength),
           tr("Length of the scala tympani along the path of the organ of Corti."));
    addRow(column, tr("Width at window"), millimetersText(patient.roundWindowWidth),
           tr("Width of the scala tympani's section at the round window."));
    addRow(column, tr("Height at window"), millimetersText(patient.roundWindowHeight),
           tr("Height of the scala tympani's section at the round window."));
  }
  // sections measured by others are shown with their names
  if (!isPublished)
    addRow(column, tr("Sections"), tr("mean of 15, CC BY 4.0"),
           tr("Adapted from Froehlich, Schurzig, Rau, Lenarz (2024), PLOS ONE, "
              "doi 10.1371/journal.pone.0295121, CC BY 4.0."));
  addRow(column, tr("Ear"), patient.side == anatomy::Side::left ? tr("left") : tr("right"));
}

void SidePanel::addArray(QVBoxLayout& column, const session::Scenario& scenario)
{
  addTitle(column, tr("Array"));
  auto* name = new QLabel(QString::fromStdString(scenario.array.name), content_);
  name->setFont(typeface(13, QFont::Medium));
  name->setFixedHeight(rowHeight_px);
  name->setToolTip(QString::fromStdString(scenario.array.note));
  column.addWidget(name);
  stylet_ = addRow(column, tr("Technique"), techniqueText(scenario));
  addRow(column, tr("Speed"),
         tr("%1 mm/s").arg(numberText(inMillimetersPerSecond(scenario.speed), 1)),
         tr("Of the scripted hand."));
  addRow(column, tr("Friction"), frictionText(scenario.friction),
         tr("Coefficients of dry friction between array and wall: starting / dynamic."));
  addRow(column, tr("Model"), tr("Rod · %1 nodes").arg(scenario.nodes),
         tr("The array as an elastic rod, every %1 ms.")
             .arg(numberText(inMilliseconds(scenario.timeStep), 1)));
}

void SidePanel::addHand(QVBoxLayout& column, const session::Scenario& scenario)
{
  addTitle(column, tr("Hand"));
  scripted_ = new Choice(tr("Scripted insertion"), content_);
  scripted_->setObjectName(QStringLiteral("scriptedChoice"));
  scripted_->setToolTip(tr("Constant speed in, constant speed out."));
  pointer_ = new Choice(tr("Mouse and keyboard"), content_);
  pointer_->setObjectName(QStringLiteral("pointerChoice"));
  pointer_->setToolTip(tr("The wheel or the up and down keys move the array while it is held."));
  scripted_->setChecked(true);
  column.addWidget(scripted_);
  device_ = new Choice(tr("Haptic device…"), content_);
  device_->setObjectName(QStringLiteral("deviceChoice"));
  device_->setToolTip(tr("Which devices there are, and which one may be the hand (H)."));
  column.addWidget(pointer_);
  column.addWidget(device_);

  hold_ = new QPushButton(tr("Hold the array (Space)"), content_);
  hold_->setObjectName(QStringLiteral("holdButton"));
  pullStylet_ = new QPushButton(tr("Pull stylet (S)"), content_);
  pullStylet_->setObjectName(QStringLiteral("styletButton"));
  for (QPushButton* button : {hold_, pullStylet_}) {
    button->setFont(typeface(13));
    button->setFixedHeight(28);
    button->setFocusPolicy(Qt::NoFocus);
    button->setEnabled(false);
  }
  hold_->setToolTip(tr("The array follows the wheel only while this is pressed or Space is down."));
  column.addSpacing(4);
  column.addWidget(hold_);
  column.addSpacing(4);
  column.addWidget(pullStylet_);
  pullStylet_->setVisible(scenario.array.hasStylet);
  hold_->setVisible(false);

  connect(scripted_, &QAbstractButton::clicked, this,
          [this] { Q_EMIT handChosen(Hand::scripted); });
  connect(pointer_, &QAbstractButton::clicked, this, [this] { Q_EMIT handChosen(Hand::pointer); });
  connect(device_, &QAbstractButton::clicked, this, &SidePanel::devicesAsked);
  connect(hold_, &QAbstractButton::pressed, this, [this] { Q_EMIT holdChanged(true); });
  connect(hold_, &QAbstractButton::released, this, [this] { Q_EMIT holdChanged(false); });
  connect(pullStylet_, &QAbstractButton::clicked, this, &SidePanel::styletAsked);

  addRow(column, tr("Force shown"),
         QStringLiteral("× %1").arg(numberText(scenario.engine.forceScale, 1)),
         tr("Force at the hand's device over the physical force. Script and mouse feel none."));
}

void SidePanel::addShow(QVBoxLayout& column)
{
  using visualization::Part;
  addTitle(column, tr("Show"));
  const std::pair<Part, QString> parts[] = {
      {Part::wallForce, tr("Wall force")},
      {Part::contactArrows, tr("Contact arrows")},
      {Part::membrane, tr("Basilar membrane")},
      {Part::styletAndTweezers, tr("Stylet and tweezers")},
  };
  for (const auto& [part, name] : parts) {
    auto* box = new CheckBox(name, content_);
    box->setChecked(true);
    box->setObjectName(QStringLiteral("show%1").arg(static_cast<int>(part)));
    connect(box, &QAbstractButton::toggled, this,
            [this, shown = part](bool isOn) { Q_EMIT partShown(shown, isOn); });
    column.addWidget(box);
  }
  auto* experiment = new CheckBox(tr("Published experiment"), content_);
  experiment->setChecked(true);
  experiment->setObjectName(QStringLiteral("showExperiment"));
  connect(experiment, &QAbstractButton::toggled, this, &SidePanel::experimentShown);
  column.addWidget(experiment);
}

void SidePanel::setHand(Hand hand, const QString& name)
{
  scripted_->setChecked(hand == Hand::scripted);
  pointer_->setChecked(hand == Hand::pointer);
  device_->setChecked(hand == Hand::device);
  device_->setText(hand == Hand::device ? name : tr("Haptic device…"));
  hold_->setVisible(hand == Hand::pointer);
}

void SidePanel::setHandChangeable(bool isChangeable)
{
  scripted_->setEnabled(isChangeable);
  pointer_->setEnabled(isChangeable);
  device_->setEnabled(isChangeable);
}

void SidePanel::setHoldEnabled(bool isEnabled) { hold_->setEnabled(isEnabled); }

void SidePanel::setHeld(bool isHeld)
{
  if (hold_->property("held").toBool() == isHeld) return;
  hold_->setProperty("held", isHeld);
  hold_->setText(isHeld ? tr("Array held") : tr("Hold the array (Space)"));
  hold_->style()->unpolish(hold_);
  hold_->style()->polish(hold_);
}

void SidePanel::setStylet(const QString& words, bool canPull)
{
  stylet_->setText(words);
  pullStylet_->setEnabled(canPull);
}

}  // namespace perilymph::gui
