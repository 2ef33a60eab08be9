// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/insert/SidePanel.h"

#include <QApplication>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <QVariant>
#include <QWheelEvent>

#include "gui/pages/insert/InputSection.h"
#include "gui/pages/insert/ReferenceRow.h"
#include "gui/setup/ArraySection.h"
#include "gui/setup/PatientSection.h"
#include "gui/setup/ScenarioHeader.h"
#include "gui/setup/SetupHistory.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/Theme.h"

namespace perilymph::gui {

namespace {

constexpr int stripWidth_px = 28;
constexpr int scrollBar_px = 8;

}  // namespace

SidePanel::SidePanel(std::shared_ptr<CochleaStore> cochleae, QWidget* parent)
    : QWidget(parent),
      scroll_(new QScrollArea(this)),
      expand_(new QPushButton(QStringLiteral("▸"), this))
{
  setObjectName(QStringLiteral("sidePanel"));
  auto* content = new QWidget(scroll_);
  // in tab order
  head_ = new ScenarioHeader(content);
  patient_ = new PatientSection(std::move(cochleae), content);
  array_ = new ArraySection(content);
  input_ = new InputSection(content);
  auto* rows = new QVBoxLayout(content);
  rows->setContentsMargins(2 * spacing, spacing, 2 * spacing - scrollBar_px, spacing);
  rows->setSpacing(spacing);
  rows->addWidget(head_);
  rows->addWidget(patient_);
  rows->addWidget(array_);
  rows->addWidget(array_->expert());
  rows->addWidget(input_);
  rows->addWidget(showSection(content));
  rows->addStretch();

  scroll_->setObjectName(QStringLiteral("panelScroll"));
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOn);
  scroll_->verticalScrollBar()->setFixedWidth(scrollBar_px);
  content->setMaximumWidth(shownLengths().sidePanel - scrollBar_px);
  scroll_->setWidget(content);
  scroll_->viewport()->installEventFilter(this);

  expand_->setObjectName(QStringLiteral("expandButton"));
  expand_->setProperty("small", true);
  expand_->setFixedSize(sized(22), sized(22));
  expand_->setFocusPolicy(Qt::NoFocus);
  expand_->setToolTip(tr("Show the panel (B)"));
  expand_->setAccessibleName(tr("Show the panel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(scroll_);
  column->addWidget(expand_, 0, Qt::AlignHCenter | Qt::AlignTop);
  setCollapsed(false);
  connectSections();
}

void SidePanel::connectSections()
{
  connect(head_, &ScenarioHeader::undoRequested, this, &SidePanel::undoRequested);
  connect(head_, &ScenarioHeader::redoRequested, this, &SidePanel::redoRequested);
  connect(head_, &ScenarioHeader::restoreRequested, this, &SidePanel::restoreRequested);
  connect(head_, &ScenarioHeader::collapseRequested, this, [this] { setCollapsed(true); });
  connect(expand_, &QPushButton::clicked, this, [this] { setCollapsed(false); });
  connect(patient_, &PatientSection::changeRequested, this, &SidePanel::changeRequested);
  connect(patient_, &PatientSection::patientChosen, this, &SidePanel::patientChosen);
  connect(patient_, &PatientSection::allPatientsRequested, this, &SidePanel::allPatientsRequested);
  connect(patient_, &PatientSection::newPatientRequested, this, &SidePanel::newPatientRequested);
  connect(array_, &ArraySection::changeRequested, this, &SidePanel::changeRequested);
  connect(input_, &InputSection::changeRequested, this, &SidePanel::changeRequested);
  connect(input_, &InputSection::inputChosen, this, &SidePanel::inputChosen);
  connect(input_, &InputSection::devicesRequested, this, &SidePanel::devicesRequested);
  connect(input_, &InputSection::holdChanged, this, &SidePanel::holdChanged);
  connect(input_, &InputSection::styletRequested, this, &SidePanel::styletRequested);
  // scroll to a field that gets the focus by Tab
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget*, QWidget* now) {
    if (now != nullptr && scroll_->widget()->isAncestorOf(now))
      scroll_->ensureWidgetVisible(now, 0, 3 * spacing);
  });
}

Section* SidePanel::showSection(QWidget* parent)
{
  using visualization::Part;
  auto* section = new Section(tr("Show"), "showFold", parent);
  section->rows().setSpacing(0);
  const std::pair<Part, QString> parts[] = {
      {Part::wallForce, tr("Wall force")},
      {Part::contactArrows, tr("Contact forces")},
      {Part::membrane, tr("Basilar membrane")},
      {Part::styletAndTweezers, tr("Stylet and tweezers")},
      {Part::landmarks, tr("Bone and landmarks")},
  };
  for (const auto& [part, name] : parts) {
    auto* box = new CheckBox(name, section->body());
    box->setChecked(part != Part::landmarks);
    box->setObjectName(QStringLiteral("show%1").arg(static_cast<int>(part)));
    box->setFocusPolicy(Qt::TabFocus);
    connect(box, &QAbstractButton::toggled, this,
            [this, shown = part](bool isOn) { Q_EMIT partShown(shown, isOn); });
    section->rows().addWidget(box);
    parts_.emplace_back(part, box);
  }
  experiment_ = new CheckBox(tr("Published measurements"), section->body());
  experiment_->setChecked(true);
  experiment_->setObjectName(QStringLiteral("showExperiment"));
  experiment_->setFocusPolicy(Qt::TabFocus);
  connect(experiment_, &QAbstractButton::toggled, this, &SidePanel::experimentShown);
  section->rows().addWidget(experiment_);
  reference_ = new ReferenceRow(section->body());
  connect(reference_, &ReferenceRow::removeRequested, this, &SidePanel::removeReferenceRequested);
  section->rows().addWidget(reference_);
  return section;
}

void SidePanel::setTiming(const QString& text) { array_->setTiming(text); }

void SidePanel::setComparable(bool isComparable)
{
  experiment_->setEnabled(isComparable);
  experiment_->setToolTip(
      isComparable ? tr("Published measurements, mean ± SD, in the chart of force over travel.")
                   : tr("Not comparable: array, technique, cochlea, friction or speed differ from "
                        "the published experiment."));
}

void SidePanel::togglePart(visualization::Part part)
{
  for (const auto& [each, box] : parts_)
    if (each == part) box->toggle();
}

void SidePanel::announceParts()
{
  for (const auto& [part, box] : parts_) Q_EMIT partShown(part, box->isChecked());
}

void SidePanel::showSetup(const SetupHistory& history)
{
  head_->show(history);
  patient_->show(history.now());
  array_->show(history.now());
  input_->show(history.now());
  const session::Scenario& scenario = history.now().scenario;
  reference_->showCurrent(session::subjectOf(scenario.text(), scenario.name()));
}

void SidePanel::setReference(const std::optional<ReferenceInsertion>& reference)
{
  reference_->setReference(reference);
}

QString SidePanel::commit()
{
  QString error = patient_->commit();
  if (error.isEmpty()) error = array_->commit();
  if (error.isEmpty()) error = input_->commit();
  return error;
}

void SidePanel::setChangeable(bool isChangeable)
{
  if (isChangeable == isChangeable_) return;
  isChangeable_ = isChangeable;
  // A disabled field must not receive keys.
  QWidget* focused = window()->focusWidget();
  if (!isChangeable && focused != nullptr && isAncestorOf(focused)) window()->setFocus();
  head_->setChangeable(isChangeable);
  patient_->body()->setEnabled(isChangeable);
  array_->setChangeable(isChangeable);
  input_->setChangeable(isChangeable);
}

void SidePanel::setInput(InputSource input, const QString& name) { input_->setInput(input, name); }

void SidePanel::setHeld(bool isHeld)
{
  isHeld_ = isHeld;
  input_->setHeld(isHeld);
}

void SidePanel::setHoldEnabled(bool isEnabled) { input_->setHoldEnabled(isEnabled); }

void SidePanel::setStylet(const QString& text, bool canPull) { input_->setStylet(text, canPull); }

void SidePanel::setCollapsed(bool isCollapsed)
{
  QWidget* focused = window()->focusWidget();
  if (isCollapsed && focused != nullptr && isAncestorOf(focused)) window()->setFocus();
  scroll_->setVisible(!isCollapsed);
  expand_->setVisible(isCollapsed);
  setFixedWidth(isCollapsed ? stripWidth_px : shownLengths().sidePanel);
}

bool SidePanel::isCollapsed() const { return scroll_->isHidden(); }

bool SidePanel::eventFilter(QObject* watched, QEvent* event)
{
  // A wheel that moves the array must not scroll, wherever the mouse is.
  if (event->type() != QEvent::Wheel || !isHeld_) return QWidget::eventFilter(watched, event);
  event->ignore();
  return true;
}

void SidePanel::wheelEvent(QWheelEvent* event) { event->setAccepted(!isHeld_); }

}  // namespace perilymph::gui
