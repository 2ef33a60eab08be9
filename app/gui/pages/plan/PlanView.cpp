// SPDX-License-Identifier: BSD-3-Clause
#include "gui/pages/plan/PlanView.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>

#include "gui/pages/plan/AngleRing.h"
#include "gui/pages/plan/ContactTable.h"
#include "gui/pages/plan/ForceBands.h"
#include "gui/pages/plan/PlanScene.h"
#include "gui/pages/plan/PlanText.h"
#include "gui/report/ContactExport.h"
#include "gui/setup/PatientLibrary.h"
#include "gui/text/ChartLabels.h"
#include "gui/text/DataText.h"
#include "gui/text/Numbers.h"
#include "gui/widgets/CheckBoxes.h"
#include "gui/widgets/DrawingView.h"
#include "gui/widgets/ElidedLabel.h"
#include "gui/widgets/PanelParts.h"
#include "gui/widgets/PlotView.h"
#include "gui/widgets/Theme.h"
#include "gui/widgets/WrappedLabel.h"
#include "perilymph/planning/ContactsCsv.h"

namespace perilymph::gui {

namespace {

constexpr int asideWidth_px = 650, ringHeight_px = 190, unrolledHeight_px = 150;
constexpr int detailsStage = 0, forcesStage = 1;

}  // namespace

/// What the unrolled view draws; it refers to the shape's cochlea.
struct PlanView::Unrolled {
  explicit Unrolled(PlanShapeWork::Shape given)
      : shape(std::move(given)),
        array(*shape->anatomy, shape->parameters.array),
        scala(*shape->anatomy, chartStyle(shownColorScheme()))
  {
    array.follow(shape->end);
  }
  PlanShapeWork::Shape shape;
  charts::ArrayInScala array;
  charts::UnrolledScala scala;
};

PlanView::PlanView(QWidget* parent)
    : QWidget(parent),
      work_(this),
      showsBone_(new CheckBox(tr("Bone and landmarks"), this)),
      grid_(new QGridLayout),
      unrolledView_(new PlotView(
          [this](double width, double height) {
            return unrolled_ ? unrolled_->scala.draw(unrolled_->array, width, height)
                             : figures::Drawing{};
          },
          this)),
      aside_(new QStackedWidget(this)),
      ring_(new AngleRing(this)),
      contacts_(new ContactTable(this)),
      facts_(new WrappedLabel({}, this)),
      forces_(new DrawingView(this)),
      differences_(new WrappedLabel({}, this))
{
  setObjectName(QStringLiteral("planView"));
  for (Pane& pane : panes_) pane = addPane();
  unrolledView_->setObjectName(QStringLiteral("planUnrolled"));
  unrolledView_->setAccessibleName(tr("Unrolled scala tympani"));
  unrolledView_->setFixedHeight(sized(unrolledHeight_px));
  forces_->setObjectName(QStringLiteral("planForces"));
  forces_->setAccessibleName(tr("Insertion force over depth"));
  forces_->setMinimumSize(sized(asideWidth_px) - 2 * spacing, sized(200));
  aside_->addWidget(addDetails());
  aside_->addWidget(addForces());
  aside_->setFixedWidth(sized(asideWidth_px));
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(spacing);
  auto* left = new QVBoxLayout;
  left->setSpacing(spacing);
  left->addLayout(grid_, 1);
  left->addWidget(showsBone_);
  left->addWidget(unrolledView_);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(spacing);
  row->addLayout(left, 1);
  row->addWidget(aside_);
  showsBone_->setObjectName(QStringLiteral("planBone"));
  showsBone_->setChecked(true);
  connect(showsBone_, &QCheckBox::toggled, this, &PlanView::refreshBone);
  connect(&work_, &PlanShapeWork::shapeRun, this, &PlanView::showShape);
  connect(&work_, &PlanShapeWork::failed, this, &PlanView::failed);
}

PlanView::~PlanView() = default;

PlanView::Pane PlanView::addPane()
{
  Pane pane{new QWidget(this), nullptr, nullptr};
  pane.title = new ElidedLabel(pane.frame);
  pane.title->setFont(typeface(13, QFont::DemiBold));
  pane.scene = new PlanScene(pane.frame);
  auto* column = new QVBoxLayout(pane.frame);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(pane.title);
  column->addWidget(pane.scene, 1);
  connect(pane.scene, &PlanScene::cameraMoved, this, [this, scene = pane.scene] {
    for (const Pane& other : panes_)
      if (other.scene != scene) other.scene->lookAs(*scene);
  });
  return pane;
}

QWidget* PlanView::addDetails()
{
  auto* details = new QWidget(this);
  ring_->setFixedHeight(sized(ringHeight_px));
  facts_->setObjectName(QStringLiteral("planFacts"));
  facts_->setFont(typeface(12));
  auto* column = new QVBoxLayout(details);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addWidget(ring_);
  column->addWidget(facts_);
  column->addWidget(contacts_, 1);
  auto* save = panelButton(tr("Save table…"), "savePlanContactsButton", details);
  save->setToolTip(
      tr("Save the contacts for whoever programs the processor, as CSV with a dictionary of its "
         "columns"));
  connect(save, &QPushButton::clicked, this, &PlanView::saveContacts);
  column->addWidget(save, 0, Qt::AlignLeft);
  return details;
}

void PlanView::saveContacts()
{
  if (!plan_ || arrays_.size() != 1) return;
  const auto file = chooseContactFile(
      this, {true, plan_->request.patient, plan_->arrays[arrays_.front()].array, madeUtc_});
  if (!file) return;
  if (const auto written = writeContactTable(*file, planning::contactsCsv(*plan_, arrays_));
      !written)
    Q_EMIT failed(dataText(written.error().message));
}

QWidget* PlanView::addForces()
{
  auto* forces = new QWidget(this);
  differences_->setObjectName(QStringLiteral("planDifferences"));
  differences_->setFont(typeface(12));
  auto* column = new QVBoxLayout(forces);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(spacing);
  column->addWidget(forces_, 1);
  column->addWidget(differences_);
  return forces;
}

void PlanView::arrange(std::size_t count)
{
  // two lie one over the other: the pictures are wider than high
  const std::size_t columns = count > 2 ? 2 : 1;
  // equally wide, whatever their titles say
  for (int column = 0; column < 2; ++column)
    grid_->setColumnStretch(column, column < int(columns) ? 1 : 0);
  for (std::size_t i = 0; i < panes_.size(); ++i) {
    grid_->removeWidget(panes_[i].frame);
    panes_[i].frame->setVisible(i < count);
    panes_[i].scene->clear();
    if (i < count) grid_->addWidget(panes_[i].frame, int(i / columns), int(i % columns));
  }
  const bool isOne = count == 1;
  unrolledView_->setVisible(isOne);
  showsBone_->setVisible(isOne);
  aside_->setCurrentIndex(isOne ? detailsStage : forcesStage);
}

void PlanView::show(const PlanWork::SharedPlan& plan, std::vector<std::size_t> arrays,
                    std::string madeUtc)
{
  plan_ = plan;
  arrays_ = std::move(arrays);
  madeUtc_ = std::move(madeUtc);
  if (arrays_.size() > maxArrays) arrays_.resize(maxArrays);
  unrolled_.reset();
  unrolledView_->refresh();
  arrange(arrays_.size());
  for (std::size_t i = 0; i < arrays_.size(); ++i) {
    const QString name = QString::fromStdString(plan->arrays[arrays_[i]].name);
    panes_[i].title->setText(tr("%1 · computing the picture…").arg(name));
    panes_[i].scene->setAccessibleName(tr("%1 in the cochlea, 3D").arg(name));
  }
  if (arrays_.size() == 1) {
    const planning::ArrayPlan& array = plan->arrays[arrays_.front()];
    ring_->show(array.contacts, plan->request.patient.side);
    contacts_->show(array.contacts, array.draws);
    facts_->setText(factsOf(array, *plan));
  } else {
    forces_->show(figures::draw(forceBands(*plan, arrays_)));
    differences_->setText(differencesOf(*plan, arrays_));
  }
  work_.run(plan, arrays_);
}

void PlanView::showShape(std::size_t place, const PlanShapeWork::Shape& shape)
{
  panes_[place].title->setText(shapeTitle(plan_->arrays[arrays_[place]], shape->insertion));
  panes_[place].scene->show(shape, plan_->request.approach.value_or(anatomy::Approach{}));
  panes_[place].scene->showForces(arrays_.size() == 1);
  refreshBone();
  if (place > 0) panes_[place].scene->lookAs(*panes_[0].scene);
  if (arrays_.size() > 1) return;
  unrolled_ = std::make_unique<Unrolled>(shape);
  unrolledView_->refresh();
}

void PlanView::refreshBone()
{
  if (!plan_ || arrays_.size() != 1) return;
  const anatomy::Patient& patient = plan_->request.patient;
  panes_[0].scene->showBone(showsBone_->isChecked(), boneSource_ ? boneSource_(patient) : nullptr,
                            isMeasuredInCt(patient) ? CochleaOrigin::ct : CochleaOrigin::numbers);
}

std::size_t PlanView::shownScenes() const
{
  std::size_t count = 0;
  for (const Pane& pane : panes_) count += pane.scene->isShown() ? 1 : 0;
  return count;
}

}  // namespace perilymph::gui
