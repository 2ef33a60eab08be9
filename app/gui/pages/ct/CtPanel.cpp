// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/ct/CtPanel.h"

#include <QBoxLayout>
#include <QButtonGroup>
#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QStringList>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/pages/ct/CtNextSteps.h"
#include "gui/pages/ct/CtSource.h"
#include "gui/pages/ct/CtText.h"
#include "gui/pages/ct/MarkGuide.h"
#include "gui/setup/MeasureVersions.h"
#include "gui/setup/VersionQuestion.h"
#include "gui/text/ApproachText.h"
#include "gui/text/DataText.h"
#include "gui/text/LandmarkText.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/Selector.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/imaging/MeasuredPatient.h"

namespace perilymph::gui {

namespace {

constexpr int panelWidth_px = 300, wideWidth_px = 560, removeWidth_px = 28, distanceWidth_px = 52,
              structureWidth_px = 122;

QLabel* panelText(const QString& caption, int size_px, QWidget* parent)
{
  auto* label = new WrappedLabel(caption, parent);
  label->setFont(typeface(size_px));
  return label;
}

struct Slab {
  double thickness_mm;
  imaging::Projection projection;
};
constexpr std::array<Slab, 4> slabs{{{0.0, imaging::Projection::mean},
                                     {1.0, imaging::Projection::mean},
                                     {2.0, imaging::Projection::mean},
                                     {2.0, imaging::Projection::maximum}}};

}  // namespace

CtPanel::CtPanel(CtStudy& study, QWidget* parent) : QWidget(parent), study_(study)
{
  setObjectName(QStringLiteral("ctPanel"));
  auto* upper = new QWidget(this);
  columns_ = new QBoxLayout(QBoxLayout::TopToBottom, upper);
  columns_->setContentsMargins(2 * spacing, 2 * spacing, 2 * spacing, spacing);
  columns_->setSpacing(2 * spacing);
  auto* before = new QVBoxLayout;
  auto* found = new QVBoxLayout;
  for (QVBoxLayout* column : {before, found}) {
    column->setSpacing(spacing);
    columns_->addLayout(column, 1);
  }
  addStep(*before, tr("1  SCAN"));
  addSource(*before);
  addMeasurement(*before);
  addView(*before);
  addStructures(*before);
  before->addStretch();
  addStep(*found, tr("2  CHECK"));
  addMeasures(*found);
  addMarks(*found);
  addApproach(*found);
  found->addStretch();
  // what follows the measurement stays in view
  auto* foot = new QVBoxLayout;
  foot->setContentsMargins(2 * spacing, spacing, 2 * spacing, 2 * spacing);
  foot->setSpacing(spacing);
  addStep(*foot, tr("3  USE"));
  addOnward(*foot);
  auto* whole = new QVBoxLayout(this);
  whole->setContentsMargins(0, 0, 0, 0);
  whole->setSpacing(0);
  whole->addWidget(verticalScroll(upper, this), 1);
  whole->addLayout(foot);
  connect(&study_, &CtStudy::changed, this, &CtPanel::refresh);
  setWide(false);
  showIdle({});
}

void CtPanel::setWide(bool isWide)
{
  setFixedWidth(sized(isWide ? wideWidth_px : panelWidth_px));
  columns_->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
  onward_->setWide(isWide);
}

void CtPanel::addStep(QVBoxLayout& column, const QString& title)
{
  steps_.push_back(panelHeading(title, this));
  column.addWidget(steps_.back());
}

void CtPanel::addSource(QVBoxLayout& column) { column.addWidget(source_ = new CtSource(this)); }

void CtPanel::addView(QVBoxLayout& column)
{
  column.addSpacing(spacing);
  column.addWidget(panelHeading(tr("VIEW"), this));
  patientPlanes_ = new Choice(tr("Axial, coronal, sagittal"), this);
  cochleaPlanes_ = new Choice(tr("Cochlear view"), this);
  patientPlanes_->setObjectName(QStringLiteral("patientPlanes"));
  cochleaPlanes_->setObjectName(QStringLiteral("cochleaPlanes"));
  cochleaPlanes_->setToolTip(
      tr("The plane through the basal turn, perpendicular to the modiolus, "
         "and two mid-modiolar planes. Needs a measured cochlea."));
  auto* group = new QButtonGroup(this);
  for (Choice* choice : {patientPlanes_, cochleaPlanes_}) {
    choice->setFont(typeface(13));
    choice->setFocusPolicy(Qt::TabFocus);
    group->addButton(choice);
    column.addWidget(choice);
  }
  patientPlanes_->setChecked(true);
  connect(patientPlanes_, &QAbstractButton::clicked, this,
          [this] { study_.setFrame(PlaneFrame::patient); });
  connect(cochleaPlanes_, &QAbstractButton::clicked, this,
          [this] { study_.setFrame(PlaneFrame::cochlea); });

  window_ = new Selector("grayWindow", tr("Gray values"), this);
  window_->addItems({tr("Bone"), tr("Soft tissue"), tr("All values")});
  window_->setToolTip(
      tr("Bone: level 700, width 4000 HU. Soft tissue: level 40, width 400 HU. Drag "
         "with the right mouse button to change brightness and contrast."));
  slab_ = new Selector("slab", tr("Slab"), this);
  slab_->addItems(
      {tr("Single layer"), tr("Slab 1 mm, mean"), tr("Slab 2 mm, mean"), tr("Slab 2 mm, maximum")});
  for (QComboBox* box : {window_, slab_}) {
    box->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    column.addWidget(box);
  }
  connect(window_, QOverload<int>::of(&QComboBox::activated), this, [this](int which) {
    if (!study_.hasCt()) return;
    study_.setWindow(which == 0   ? imaging::boneWindow
                     : which == 1 ? imaging::softWindow
                                  : imaging::wholeWindow(*study_.volume()));
  });
  connect(slab_, QOverload<int>::of(&QComboBox::activated), this, [this](int which) {
    const Slab& slab = slabs[std::size_t(which)];
    study_.setSlab(slab.thickness_mm, slab.projection);
  });
}

void CtPanel::addMeasurement(QVBoxLayout& column)
{
  search_ = rowButton(tr("Find and measure the cochlea"), "measureCtButton", this);
  measureHere_ = rowButton(tr("Measure at the crosshair"), "measureHereButton", this);
  search_->setProperty("primary", true);
  for (QPushButton* button : {search_, measureHere_}) button->setProperty("small", true);
  measureHere_->setToolTip(tr("Click inside the cochlea first."));
  cancel_ = rowButton(tr("Cancel"), "cancelCtButton", this);
  progress_ = new QProgressBar(this);
  progress_->setTextVisible(false);
  progress_->setFixedHeight(6);
  progress_->setRange(0, 1000);
  status_ = panelText({}, 12, this);
  status_->setObjectName(QStringLiteral("ctStatus"));
  column.addWidget(search_);
  column.addWidget(measureHere_);
  column.addWidget(status_);
  column.addWidget(progress_);
  column.addWidget(cancel_);
  connect(search_, &QPushButton::clicked, this, [this] { Q_EMIT measureRequested(false); });
  connect(measureHere_, &QPushButton::clicked, this, [this] { Q_EMIT measureRequested(true); });
  connect(cancel_, &QPushButton::clicked, this, &CtPanel::cancelRequested);
}

void CtPanel::addMeasures(QVBoxLayout& column)
{
  side_ = panelText({}, 13, this);
  side_->setObjectName(QStringLiteral("ctSide"));
  column.addWidget(side_);
  auto* table = new QGridLayout;
  table->setVerticalSpacing(4);
  fittedHeading_ = panelHeading({}, this);
  fittedHeading_->setObjectName(QStringLiteral("fittedHeading"));
  table->addWidget(fittedHeading_, 0, 1);
  table->addWidget(panelHeading(tr("from landmarks"), this), 0, 2);
  const std::array names{QStringLiteral("A"), QStringLiteral("B"), QStringLiteral("H"), tr("CDL")};
  constexpr std::array keys{"A", "B", "H", "Cdl"};
  for (std::size_t k = 0; k < names.size(); ++k) {
    fitted_[k] = panelText(QStringLiteral("–"), 13, this);
    marked_[k] = panelText(QStringLiteral("–"), 13, this);
    for (QLabel* label : {fitted_[k], marked_[k]}) label->setWordWrap(false);
    fitted_[k]->setObjectName(QStringLiteral("fitted%1").arg(QLatin1String(keys[k])));
    marked_[k]->setObjectName(QStringLiteral("marked%1").arg(QLatin1String(keys[k])));
    table->addWidget(panelText(names[k], 13, this), int(k) + 1, 0);
    table->addWidget(fitted_[k], int(k) + 1, 1);
    table->addWidget(marked_[k], int(k) + 1, 2);
  }
  table->setColumnStretch(1, 3);
  table->setColumnStretch(2, 2);
  column.addLayout(table);
  stale_ = panelText(tr("Landmarks moved: measure again."), 12, this);
  stale_->setObjectName(QStringLiteral("ctStale"));
  stale_->setProperty("error", true);
  column.addWidget(stale_);
  change_ = panelText({}, 12, this);
  change_->setObjectName(QStringLiteral("ctChange"));
  column.addWidget(change_);
  duct_ = panelText({}, 11, this);
  duct_->setProperty("quiet", true);
  column.addWidget(duct_);
  flags_ = panelText({}, 12, this);
  flags_->setObjectName(QStringLiteral("ctFlags"));
  flags_->setProperty("error", true);
  column.addWidget(flags_);
}

void CtPanel::addMarks(QVBoxLayout& column)
{
  column.addSpacing(spacing);
  column.addWidget(panelHeading(tr("LANDMARKS"), this));
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  for (std::size_t k = 0; k < ct::markCount; ++k) {
    const auto mark = static_cast<ct::Mark>(k);
    auto* button = rowButton(markLabel(mark), "", this);
    button->setObjectName(QStringLiteral("mark%1").arg(QLatin1String(ct::nameOf(mark))));
    button->setProperty("small", true);
    button->setAccessibleName(markName(mark));
    button->setToolTip(
        tr("%1. Press, then click into a picture. %2").arg(markName(mark), markGuide(mark)));
    grid->addWidget(button, int(k / 4), int(k % 4));
    marks_[k] = button;
    connect(button, &QPushButton::clicked, this, [this, mark] { Q_EMIT markRequested(mark); });
  }
  column.addLayout(grid);
  column.addWidget(guide_ = new MarkGuide(study_, this));
  auto* verbs = new QGridLayout;
  verbs->setSpacing(4);
  undo_ = rowButton(tr("Undo"), "undoMarkButton", this);
  redo_ = rowButton(tr("Redo"), "redoMarkButton", this);
  saveMarks_ = rowButton(tr("Save…"), "saveMarksButton", this);
  loadMarks_ = rowButton(tr("Load…"), "loadMarksButton", this);
  saveMarks_->setToolTip(
      tr("Markups for 3D Slicer (.mrk.json, LPS): landmarks, axis, and the inserted array with its "
         "contacts"));
  loadMarks_->setToolTip(
      tr("Markups of 3D Slicer with points named RW, LW, B1, B2, base, apex, M, or as this "
         "program saves them"));
  const std::array buttons{undo_, redo_, saveMarks_, loadMarks_};
  for (int i = 0; i < 4; ++i) verbs->addWidget(buttons[std::size_t(i)], i / 2, i % 2);
  column.addLayout(verbs);
  connect(undo_, &QPushButton::clicked, &study_, &CtStudy::undo);
  connect(redo_, &QPushButton::clicked, &study_, &CtStudy::redo);
  connect(saveMarks_, &QPushButton::clicked, this, &CtPanel::saveMarksRequested);
  connect(loadMarks_, &QPushButton::clicked, this, &CtPanel::loadMarksRequested);
}

void CtPanel::addApproach(QVBoxLayout& column)
{
  column.addSpacing(spacing);
  auto* rows = new QGridLayout;
  rows->setVerticalSpacing(4);
  const auto add = [this, rows](QWidget* widget, int row, int place, int columns) {
    rows->addWidget(widget, row, place, 1, columns);
    approach_.push_back(widget);
  };
  add(panelHeading(tr("APPROACH TO THE BASAL TURN"), this), 0, 0, 2);
  inPlane_ = panelText({}, 13, this);
  inPlane_->setObjectName(QStringLiteral("approachInPlane"));
  outOfPlane_ = panelText({}, 13, this);
  outOfPlane_->setObjectName(QStringLiteral("approachOutOfPlane"));
  const std::array names{tr("in its plane"), tr("out of it")};
  const std::array values{inPlane_, outOfPlane_};
  for (int k = 0; k < 2; ++k) {
    QLabel* const name = panelText(names[std::size_t(k)], 13, this);
    name->setWordWrap(false);
    name->setAlignment(Qt::AlignTop);
    add(name, k + 1, 0, 1);
    add(values[std::size_t(k)], k + 1, 1, 1);
  }
  rows->setColumnStretch(1, 1);
  approachLimit_ = panelText(approachLimitText(), 12, this);
  approachLimit_->setObjectName(QStringLiteral("approachLimit"));
  approachLimit_->setProperty("error", true);
  rows->addWidget(approachLimit_, 3, 0, 1, 2);
  resetApproach_ = rowButton(tr("Along the axis of the opening"), "resetApproachButton", this);
  resetApproach_->setToolTip(tr("Home, in the picture of the bone"));
  add(resetApproach_, 4, 0, 2);
  for (QLabel* const value : values)
    value->setToolTip(
        tr("Where the array points at the opening, from the tangent of the scala tympani’s center "
           "line there. Turn the line by its handle in the picture of the bone. Insert and Plan "
           "use it."));
  column.addLayout(rows);
  connect(resetApproach_, &QPushButton::clicked, &study_, &CtStudy::resetApproach);
  connect(&study_, &CtStudy::approachMoved, this, &CtPanel::showApproach);
}

void CtPanel::addStructures(QVBoxLayout& column)
{
  column.addSpacing(spacing);
  column.addWidget(panelHeading(tr("STRUCTURES BESIDE THE APPROACH"), this));
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  for (std::size_t k = 0; k < structures_.size(); ++k) {
    const ct::MarkupKind kind = ct::approachStructures[k];
    StructureRow& row = structures_[k];
    row.mark = rowButton(markupName(kind), "", this);
    row.mark->setObjectName(
        QStringLiteral("structure_%1").arg(QLatin1String(nameIn(ct::markupKinds, kind))));
    row.mark->setProperty("small", true);
    row.mark->setCheckable(true);
    row.mark->setFixedWidth(sized(structureWidth_px));
    row.mark->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    row.mark->setToolTip(tr("Press, then click points into the pictures; press again to end. %1")
                             .arg(structureGuide(kind)));
    row.distance = panelText({}, 13, this);
    row.distance->setMinimumWidth(sized(distanceWidth_px));  // two lines in a narrow column
    row.distance->setObjectName(
        QStringLiteral("distance_%1").arg(QLatin1String(nameIn(ct::markupKinds, kind))));
    row.distance->setToolTip(
        tr("Shortest distance between the line of approach and the marked course, with its 95 % "
           "interval: from placing by hand (standard deviation 0.3 mm) and from the voxels. It "
           "leaves out the width of the structure and of an instrument, navigation and the hand."));
    row.remove = rowButton(QStringLiteral("×"), "", this);
    row.remove->setFixedWidth(sized(removeWidth_px));
    row.remove->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    row.remove->setToolTip(tr("Remove"));
    row.remove->setProperty("small", true);
    row.remove->setAccessibleName(tr("Remove: %1").arg(markupName(kind)));
    grid->addWidget(row.mark, int(k), 0);
    grid->addWidget(row.distance, int(k), 1);
    grid->addWidget(row.remove, int(k), 2);
    connect(row.mark, &QPushButton::toggled, this, [this, k](bool isMarking) {
      for (std::size_t other = 0; isMarking && other < structures_.size(); ++other)
        if (other != k) structures_[other].mark->setChecked(false);
      showApproach();
      Q_EMIT structureRequested(isMarking ? std::optional(ct::approachStructures[k])
                                          : std::nullopt);
    });
    connect(row.remove, &QPushButton::clicked, &study_,
            [this, kind] { study_.removeStructure(kind); });
  }
  grid->setColumnStretch(1, 1);
  column.addLayout(grid);
  structureGuide_ = panelText({}, 12, this);
  structureGuide_->setObjectName(QStringLiteral("structureGuide"));
  column.addWidget(structureGuide_);
}

bool CtPanel::endStructure()
{
  for (const StructureRow& row : structures_) {
    if (!row.mark->isChecked()) continue;
    row.mark->setChecked(false);
    return true;
  }
  return false;
}

void CtPanel::showApproach()
{
  structureGuide_->hide();
  for (std::size_t k = 0; k < structures_.size(); ++k) {
    const ct::MarkupKind kind = ct::approachStructures[k];
    const StructureRow& row = structures_[k];
    const auto distance = study_.distanceFromApproach(kind);
    row.mark->setEnabled(study_.hasCt());
    row.distance->setText(distance ? distanceText(*distance) : QStringLiteral("–"));
    row.remove->setEnabled(!study_.pointsOf(kind).empty());
    if (!row.mark->isChecked()) continue;
    structureGuide_->setText(structureGuide(kind));
    structureGuide_->show();
  }
  const auto angles = study_.approachAngles();
  for (QWidget* const each : approach_) each->setVisible(angles.has_value());
  approachLimit_->setVisible(study_.isApproachAtLimit());
  if (!angles) return;
  inPlane_->setText(inPlaneText(*angles));
  outOfPlane_->setText(outOfPlaneText(*angles));
  resetApproach_->setEnabled(study_.isApproachTurned());
}

void CtPanel::addOnward(QVBoxLayout& column)
{
  column.addWidget(question_ = new VersionQuestion(this));
  column.addWidget(onward_ = new CtNextSteps(this));
  // a question is about these measures and this code
  connect(&study_, &CtStudy::modelChanged, question_, &VersionQuestion::drop);
  connect(onward_, &CtNextSteps::codeChanged, question_, &VersionQuestion::drop);
  connect(onward_, &CtNextSteps::codeChanged, this, &CtPanel::showStep);
  connect(question_, &VersionQuestion::otherCodeWanted, onward_, &CtNextSteps::editCode);
  connect(onward_, &CtNextSteps::insertRequested, this, &CtPanel::insertRequested);
  connect(onward_, &CtNextSteps::planRequested, this, &CtPanel::planRequested);
  connect(onward_, &CtNextSteps::saveSurfaceRequested, this, &CtPanel::saveSurfaceRequested);
  connect(onward_, &CtNextSteps::sendRequested, this, &CtPanel::sendRequested);
}

void CtPanel::setCode(const QString& code) { onward_->setCode(code); }

QString CtPanel::code() const { return onward_->code(); }

void CtPanel::showMark(const std::optional<ct::Mark>& mark) { guide_->showMark(mark); }

void CtPanel::showTask(const QString& task, double fraction)
{
  isBusy_ = true;
  status_->setProperty("error", false);
  status_->setText(task);
  progress_->setValue(int(1000.0 * fraction));
  refresh();
}

void CtPanel::showIdle(const QString& sentence, bool isError)
{
  isBusy_ = false;
  status_->setTextFormat(Qt::PlainText);
  status_->setText(sentence);
  status_->setStyleSheet(isError ? QStringLiteral("color: %1;").arg(shownTheme().warning.name())
                                 : QString());
  refresh();
}

void CtPanel::refresh()
{
  const bool isFree = study_.hasCt() && !isBusy_;
  const bool isMeasured = study_.measures() != nullptr;
  search_->setVisible(!isBusy_);
  measureHere_->setVisible(!isBusy_);
  progress_->setVisible(isBusy_);
  cancel_->setVisible(isBusy_);
  status_->setVisible(!status_->text().isEmpty());
  search_->setEnabled(isFree);
  measureHere_->setEnabled(isFree && (study_.isCrosshairPlaced() || study_.isCorrected()));
  measureHere_->setText(study_.isCorrected() ? tr("Re-measure using landmarks")
                                             : tr("Measure at the crosshair"));
  // one button is what most users press next
  const bool isCorrected = study_.isCorrected() && study_.isStale();
  setPrimary(*search_, !isMeasured && !isCorrected);
  setPrimary(*measureHere_, isCorrected);
  cochleaPlanes_->setEnabled(isMeasured);
  (study_.frame() == PlaneFrame::cochlea ? cochleaPlanes_ : patientPlanes_)->setChecked(true);
  for (QPushButton* button : marks_) button->setEnabled(study_.hasCt());
  undo_->setEnabled(study_.canUndo());
  redo_->setEnabled(study_.canRedo());
  onward_->show(isMeasured, !isBusy_, study_.isStale());
  saveMarks_->setEnabled(!study_.marks().isEmpty());
  loadMarks_->setEnabled(study_.hasCt());
  window_->setEnabled(study_.hasCt());
  slab_->setEnabled(study_.hasCt());
  showStep();
  showMeasures();
  showApproach();
}

void CtPanel::showStep()
{
  const bool isFitted = study_.measures() != nullptr && !study_.isStale();
  const std::size_t next = !study_.hasCt() || isBusy_         ? 0
                           : !isFitted || !onward_->hasCode() ? 1
                                                              : 2;
  for (std::size_t k = 0; k < steps_.size(); ++k)
    steps_[k]->setStyleSheet(
        k == next ? QStringLiteral("color: %1;").arg(shownTheme().accent.name()) : QString());
}

void CtPanel::showMeasures()
{
  const auto& measures = study_.measures();
  const bool isStale = study_.isStale();
  const std::array<const ct::Measure*, 4> fitted =
      measures ? std::array{&measures->a, &measures->b, &measures->h,
                            measures->cdlOc ? &*measures->cdlOc : nullptr}
               : std::array<const ct::Measure*, 4>{};
  const ct::MarkedMeasures between = study_.marked();
  const std::array<std::optional<double>, 4> marked{between.a, between.b, between.h, std::nullopt};
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    fitted_[k]->setText(fitted[k] ? measureText(*fitted[k], k < 3 ? 2 : 1) : QStringLiteral("–"));
    fitted_[k]->setToolTip(fitted[k] ? errorText(*fitted[k]) : QString());
    fitted_[k]->setEnabled(!isStale);
    marked_[k]->setText(lengthText(marked[k]));
  }
  fittedHeading_->setText(isStale ? tr("fitted before (95 % CI)") : tr("used: fitted (95 % CI)"));
  stale_->setVisible(isStale);
  const auto& former = study_.former();
  change_->setVisible(measures && former && !isStale);
  if (measures && former)
    change_->setText(
        remeasuredText(imaging::measuredPatient(*former), imaging::measuredPatient(*measures)));
  side_->setVisible(measures != nullptr);
  duct_->setVisible(measures && measures->cdlOc);
  duct_->setEnabled(!isStale);
  flags_->setVisible(false);
  if (!measures) return;
  side_->setText(measures->side == anatomy::Side::left ? tr("Left ear") : tr("Right ear"));
  duct_->setText(ductLengthText(*measures));
  duct_->setToolTip(ductLengthDetail(*measures));
  QStringList flags;
  for (const ct::Flag flag : measures->flags) flags << dataText(ct::sentenceOf(flag));
  if (!isStale)
    for (const Sentence& each : ct::landmarkContradictions(*measures)) flags << dataText(each);
  if (const auto note = imaging::heightNote(*measures)) flags << dataText(*note);
  flags_->setVisible(!flags.isEmpty());
  flags_->setText(flags.join(QLatin1Char('\n')));
}

}  // namespace perilymph::gui
